// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/ChooseJoins.h"

#include "Core/Base/Box.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The components of the surface and its Euler characteristic, while joins are chosen.
class Chooser
{
public:
  Chooser(const CycleGeometry& geometry, std::vector<CycleJoin>& joins);
  SurfaceTopology Run(const PriorKnowledge& known);

private:
  bool IsRing(const CycleJoin& join)
  {
    return this->InCell.Find(join.First) == this->InCell.Find(join.Second);
  }
  bool Connects(const CycleJoin& join)
  {
    return this->Parts.Find(this->Geometry.PartOf(join.First)) !=
      this->Parts.Find(this->Geometry.PartOf(join.Second));
  }
  void Choose(CycleJoin& join);
  double EvidenceToConnect(const CycleJoin& join);
  void Connect(const PriorKnowledge& known);
  void AddHandles(const PriorKnowledge& known);

  const CycleGeometry& Geometry;
  std::vector<CycleJoin*> InOrder;
  DisjointSets Parts;      ///< of G
  std::vector<Box3> Boxes; ///< of each part, at the number that stands for it
  double Size = 0.0;       ///< diagonal of the box of all
  DisjointSets InCell;     ///< cycles that bound one patch
  Index Components = 0;
  Index Euler = 0;
};

Chooser::Chooser(const CycleGeometry& geometry, std::vector<CycleJoin>& joins)
  : Geometry(geometry)
  , Parts(ConnectArcs(geometry.Crossings, geometry.Nodes, geometry.Graph))
  , InCell(geometry.Cycles.Count())
{
  const Index nodes = geometry.Graph.Nodes;
  const Index loops = static_cast<Index>(geometry.Graph.Loops.size());
  Box3 all;
  this->Boxes.resize(nodes + loops);
  for (Index part = 0; part < nodes + loops; ++part)
  {
    const Index root = this->Parts.Find(part);
    this->Components += root == part ? 1 : 0;
    const Index arc = geometry.Graph.Arcs + part - nodes;
    const Index first = part < nodes ? part : geometry.Graph.FirstPoint(arc);
    const Index count = part < nodes ? 1 : geometry.Graph.PointCount(arc);
    for (Index point = first; point < first + count; ++point)
    {
      this->Boxes[root].Add(geometry.Graph.PointAt(point));
    }
    all.Add(this->Boxes[root]);
  }
  this->Size = this->Components > 0 ? all.Diagonal() : 0.0;
  // Two arcs leave each node; a loop with its one vertex and one edge counts nothing.
  this->Euler = geometry.Cycles.Count() - nodes;
  for (CycleJoin& join : joins)
  {
    join.Chosen = false;
    if (!join.Impossible)
    {
      this->InOrder.push_back(&join);
    }
  }
  std::stable_sort(this->InOrder.begin(), this->InOrder.end(),
    [](const CycleJoin* a, const CycleJoin* b) { return a->Evidence > b->Evidence; });
}

void Chooser::Choose(CycleJoin& join)
{
  join.Chosen = true;
  this->InCell.Unite(join.First, join.Second);
  const Index a = this->Parts.Find(this->Geometry.PartOf(join.First));
  const Index b = this->Parts.Find(this->Geometry.PartOf(join.Second));
  this->Boxes[std::min(a, b)].Add(this->Boxes[std::max(a, b)]);
  this->Components -=
    this->Parts.Unite(this->Geometry.PartOf(join.First), this->Geometry.PartOf(join.Second)) ? 1
                                                                                             : 0;
  this->Euler -= 2 * (1 + join.Handles);
}

double Chooser::EvidenceToConnect(const CycleJoin& join)
{
  double smaller = this->Size;
  for (const Index cycle : { join.First, join.Second })
  {
    const Index part = this->Parts.Find(this->Geometry.PartOf(cycle));
    smaller = std::min(smaller, this->Boxes[part].Diagonal());
  }
  const double share = this->Size > 0.0 ? smaller / this->Size : 1.0;
  return -FragmentAllowance * (1.0 - join.Flatness) * std::max(0.0, 1.0 - share / LargestFragment);
}

/// Joins what is not connected yet.
void Chooser::Connect(const PriorKnowledge& known)
{
  for (CycleJoin* join : this->InOrder)
  {
    const bool wanted = known.Components > 0 ? this->Components > known.Components
                                             : join->Evidence > this->EvidenceToConnect(*join);
    if (wanted && !join->Chosen && !this->IsRing(*join) && this->Connects(*join))
    {
      this->Choose(*join);
    }
  }
}

void Chooser::AddHandles(const PriorKnowledge& known)
{
  for (CycleJoin* join : this->InOrder)
  {
    const Index genus = this->Components - this->Euler / 2;
    const bool wanted = known.Genus >= 0 ? genus < known.Genus
                                         : join->Evidence > HandleEvidence && !join->OnlyConnects;
    if (wanted && !join->Chosen && !this->IsRing(*join) && !this->Connects(*join))
    {
      this->Choose(*join);
    }
  }
}

SurfaceTopology Chooser::Run(const PriorKnowledge& known)
{
  this->Connect(known);
  this->AddHandles(known);
  return { this->Components, this->Components - this->Euler / 2 };
}
}

SurfaceTopology ChooseJoins(
  const CycleGeometry& geometry, const PriorKnowledge& known, std::vector<CycleJoin>& joins)
{
  return Chooser(geometry, joins).Run(known);
}
}
