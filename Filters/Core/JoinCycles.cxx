// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JoinCycles.h"

#include "Vectors.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// Least evidence for a join. A fragment, much smaller than the whole, needs less to be connected:
/// it is more likely to be a piece of a thin part than a solid of its own. The lowering ends at
/// fragments of this share of the size of all contours.
constexpr double LeastEvidence = 0.0;
constexpr double ForFragments = 1.5;
constexpr double LargestFragment = 0.5;

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
  void Enlarge(Index from, Index to);
  void Choose(CycleJoin& join);
  double EvidenceToConnect(const CycleJoin& join);
  void Connect(const PriorKnowledge& known);
  void AddHandles(const PriorKnowledge& known);

  const CycleGeometry& Geometry;
  std::vector<CycleJoin*> InOrder;
  DisjointSets Parts;            ///< of G
  std::vector<Point3> Low, High; ///< box of each part, at the number that stands for it
  double Size = 0.0;             ///< diagonal of the box of all
  DisjointSets InCell;           ///< cycles that bound one patch
  Index Components = 0;
  Index Euler = 0;
};

Chooser::Chooser(const CycleGeometry& geometry, std::vector<CycleJoin>& joins)
  : Geometry(geometry)
  , Parts(ConnectArcs(geometry.Lattice, geometry.Nodes, geometry.Graph))
  , InCell(geometry.Polygons.Count())
{
  const Index nodes = geometry.Graph.Nodes;
  const Index loops = static_cast<Index>(geometry.Graph.Loops.size());
  Point3 low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (Index part = 0; part < nodes + loops; ++part)
  {
    const Index point =
      part < nodes ? part : geometry.Graph.FirstPoint(geometry.Graph.Arcs + part - nodes);
    this->Low.push_back(geometry.Graph.PointAt(point));
    this->High.push_back(this->Low.back());
    const Index root = this->Parts.Find(part);
    this->Components += root == part ? 1 : 0;
    this->Enlarge(part, root);
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], this->Low[part][axis]);
      high[axis] = std::max(high[axis], this->High[part][axis]);
    }
  }
  this->Size = this->Components > 0 ? Length(high - low) : 0.0;
  // Two arcs leave each node; a loop with its one vertex and one edge counts nothing.
  this->Euler = geometry.Polygons.Count() - nodes;
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
  this->Enlarge(std::max(a, b), std::min(a, b));
  this->Components -=
    this->Parts.Unite(this->Geometry.PartOf(join.First), this->Geometry.PartOf(join.Second)) ? 1
                                                                                             : 0;
  this->Euler -= 2 * (1 + join.Handles);
}

/// Makes the box of a part contain that of another one.
void Chooser::Enlarge(Index from, Index to)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[to][axis] = std::min(this->Low[to][axis], this->Low[from][axis]);
    this->High[to][axis] = std::max(this->High[to][axis], this->High[from][axis]);
  }
}

double Chooser::EvidenceToConnect(const CycleJoin& join)
{
  double smaller = this->Size;
  for (const Index cycle : { join.First, join.Second })
  {
    const Index part = this->Parts.Find(this->Geometry.PartOf(cycle));
    smaller = std::min(smaller, Length(this->High[part] - this->Low[part]));
  }
  const double share = this->Size > 0.0 ? smaller / this->Size : 1.0;
  return LeastEvidence - ForFragments * std::max(0.0, 1.0 - share / LargestFragment);
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
                                         : join->Evidence > LeastEvidence && !join->OnlyConnects;
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
