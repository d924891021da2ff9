// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/CycleGeometry.h"

#include <algorithm>

namespace orthoslices
{
void CycleGeometry::GetBoundary(
  Index cycle, std::vector<Index>& points, std::vector<Index>& nodePlaces) const
{
  const NodeGraph& graph = this->Graph;
  const CellCycles& cycles = this->Cycles;
  points.clear();
  nodePlaces.clear();
  for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
  {
    const HalfArc& half = cycles.Arcs[i];
    if (!graph.IsLoop(half.Arc))
    {
      nodePlaces.push_back(static_cast<Index>(points.size()));
      points.push_back(StartNode(this->Crossings, this->Nodes, half));
    }
    const Index first = graph.FirstPoint(half.Arc);
    const Index count = graph.PointCount(half.Arc);
    const std::size_t place = points.size();
    points.resize(place + count);
    for (Index p = 0; p < count; ++p)
    {
      points[place + p] = half.Above ? first + p : first + count - 1 - p;
    }
  }
}

bool CycleGeometry::IsOnReal(Index arc) const
{
  if (!this->Grid.HasVirtual())
  {
    return true;
  }
  if (this->Graph.IsLoop(arc))
  {
    const Face& face = this->Graph.Loops[arc - this->Graph.Arcs];
    return !this->Grid.IsVirtual(face.Axis, face.Plane);
  }
  const GridEdge edge = GridEdgeCode(this->Grid).Decode(this->Crossings.Edge[arc]);
  return !IsVirtualSlice(this->Grid, edge, this->Crossings.Family[arc]);
}

bool CycleGeometry::IsReal(Index cycle) const
{
  const auto first = this->Cycles.Arcs.begin() + this->Cycles.Offsets[cycle];
  const auto last = this->Cycles.Arcs.begin() + this->Cycles.Offsets[cycle + 1];
  return std::all_of(first, last, [&](const HalfArc& half) { return this->IsOnReal(half.Arc); });
}

std::vector<Index> CycleGeometry::GetBorders(const std::vector<Index>& cycles) const
{
  std::vector<Index> borders, border, places;
  for (const Index cycle : cycles)
  {
    this->GetBoundary(cycle, border, places);
    borders.insert(borders.end(), border.begin(), border.end());
  }
  return borders;
}
}
