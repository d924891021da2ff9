// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/ContourRings.h"

namespace orthoslices
{
int ContourRings::AxisOf(Index crossing) const
{
  const int direction = this->Code.Decode(this->Crossings.Edge[crossing]).Direction;
  return this->Crossings.Family[crossing] == 0 ? FirstAxis(direction) : SecondAxis(direction);
}

std::array<std::vector<Index>, 3> ContourRings::FindStarts() const
{
  const GridCrossings& crossings = this->Crossings;
  std::array<std::vector<Index>, 3> starts;
  std::vector<std::uint8_t> seen(crossings.Count(), 0);
  for (Index start = 0; start < crossings.Count(); ++start)
  {
    if (seen[start] != 0 || crossings.IsRemoved(start))
    {
      continue;
    }
    Index minimum = start;
    for (Index c = start; seen[c] == 0; c = crossings.Next[c])
    {
      seen[c] = 1;
      const bool isLess = crossings.Edge[c] != crossings.Edge[minimum]
        ? crossings.Edge[c] < crossings.Edge[minimum]
        : crossings.Position[c] < crossings.Position[minimum];
      minimum = isLess ? c : minimum;
    }
    starts[this->AxisOf(start)].push_back(minimum);
  }
  return starts;
}

void ContourRings::List(Index start, ArcRing& ring) const
{
  ring.Points.clear();
  ring.Crossing.clear();
  Index c = start;
  do
  {
    ring.Points.push_back(this->Nodes.NodeOf[c]);
    ring.Crossing.push_back(c);
    for (Index i = 0; i < this->Graph.PointCount(c); ++i)
    {
      ring.Points.push_back(this->Graph.FirstPoint(c) + i);
      ring.Crossing.push_back(GridCrossings::None);
    }
    c = this->Crossings.Next[c];
  } while (c != start);
}
}
