// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/DoubtfulJoins.h"

#include "Core/Base/Box.h"
#include "Core/Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace orthoslices
{
namespace
{
/// The side of a cube as large as the mean cell; infinite without two planes on any axis.
double MeanCellSize(const SpatialGrid& grid)
{
  double product = 1.0;
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (grid.Count(axis) > 1)
    {
      product *= grid.MeanSpacing(axis);
      ++axes;
    }
  }
  return axes > 0 ? std::pow(product, 1.0 / axes) : std::numeric_limits<double>::infinity();
}

class Doubts
{
public:
  Doubts(const CycleGeometry& geometry, const std::vector<CycleJoin>& joins);

  bool IsDoubtful(const CycleJoin& join)
  {
    return this->IsNearEven(join) && !this->IsMoot(join) && this->Matters(join);
  }

private:
  bool IsNearEven(const CycleJoin& join) const
  {
    return join.Impossible || std::abs(join.Evidence) < NearEvenEvidence;
  }
  bool IsMoot(const CycleJoin& join);
  bool Matters(const CycleJoin& join) const;
  Index ComponentOf(Index cycle) const
  {
    return this->Geometry.Graph.Component[this->Geometry.PartOf(cycle)];
  }
  bool AreApart(const CycleJoin& join) const
  {
    return this->ComponentOf(join.First) != this->ComponentOf(join.Second);
  }
  double WidthOf(Index cycle) const;

  const CycleGeometry& Geometry;
  DisjointSets Patches; ///< the cycles of one patch
  double MinWidth;
};

Doubts::Doubts(const CycleGeometry& geometry, const std::vector<CycleJoin>& joins)
  : Geometry(geometry)
  , Patches(geometry.Cycles.Count())
  , MinWidth(WidthThatMatters * MeanCellSize(geometry.Grid))
{
  for (const CycleJoin& join : joins)
  {
    if (join.Chosen)
    {
      this->Patches.Unite(join.First, join.Second);
    }
  }
}

/// Whether nothing depends on the join any more, as other joins were chosen.
bool Doubts::IsMoot(const CycleJoin& join)
{
  if (join.Chosen)
  {
    return false;
  }
  return this->Patches.Find(join.First) == this->Patches.Find(join.Second) ||
    (join.OnlyConnects && !join.Impossible && !this->AreApart(join));
}

double Doubts::WidthOf(Index cycle) const
{
  Box3 box;
  for (const Index point : this->Geometry.GetBorders({ cycle }))
  {
    box.Add(this->Geometry.Graph.PointAt(point));
  }
  return box.Diagonal();
}

bool Doubts::Matters(const CycleJoin& join) const
{
  return this->AreApart(join) ||
    std::min(this->WidthOf(join.First), this->WidthOf(join.Second)) >= this->MinWidth;
}
}

std::vector<CycleJoin> FindDoubtfulJoins(
  const CycleGeometry& geometry, const std::vector<CycleJoin>& joins)
{
  Doubts doubts(geometry, joins);
  std::vector<CycleJoin> doubtful;
  std::copy_if(joins.begin(), joins.end(), std::back_inserter(doubtful),
    [&](const CycleJoin& join) { return doubts.IsDoubtful(join); });
  return doubtful;
}
}
