// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CommonNodes.h"

#include "Core/Base/Vectors.h"
#include "Core/Patches/BalancedCurve.h"

#include <algorithm>
#include <tuple>

namespace orthoslices
{
namespace
{
GridEdge EdgeOf(const CycleGeometry& geometry, Index node)
{
  return GridEdgeCode(geometry.Grid).Decode(geometry.Crossings.Edge[geometry.Nodes.First[node]]);
}

bool IsCorner(const SurfaceNormals& normals, Index point)
{
  return !normals.Corners.empty() && normals.Corners[point] != 0;
}
}

CommonNodes::CommonNodes(const std::vector<ArcSurface>& structures, const BorderPieces& borders)
  : Structures(structures)
{
  std::vector<std::tuple<int, Point3, std::size_t, Index>> all;
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    const CycleGeometry& geometry = structures[i].Geometry;
    for (Index node = 0; node < geometry.Nodes.Count(); ++node)
    {
      all.emplace_back(EdgeOf(geometry, node).Direction, geometry.Graph.PointAt(node), i, node);
    }
  }
  std::sort(all.begin(), all.end());
  for (std::size_t first = 0, last = 0; first < all.size(); first = last)
  {
    const auto& [direction, place, structure, number] = all[first];
    CommonNode node;
    node.Ends = borders.EndsAt(structures[structure].Geometry, structure, number);
    node.MayMove = !borders.IsInsideArc(place);
    for (; last < all.size() && std::get<0>(all[last]) == direction &&
         std::get<1>(all[last]) == place;
         ++last)
    {
      const std::size_t i = std::get<2>(all[last]);
      const Index member = std::get<3>(all[last]);
      node.MayMove = node.MayMove && !IsCorner(structures[i].Normals, member) &&
        borders.EndsAt(structures[i].Geometry, i, member) == node.Ends;
      node.Members.push_back({ i, member });
    }
    this->OnLines[LineAt(direction, place)].push_back(place[direction]);
    this->Nodes.push_back(std::move(node));
  }
}

double CommonNodes::RoomBeside(
  const SpatialGrid& grid, const GridEdge& edge, const Point3& place) const
{
  const int axis = edge.Direction;
  const double here = place[axis];
  double low = edge.Slab > 0 ? grid.Planes[axis][edge.Slab - 1] : grid.Lowest[axis];
  double high = edge.Slab < grid.Count(axis) ? grid.Planes[axis][edge.Slab] : grid.Highest[axis];
  const std::vector<double>& others = this->OnLines.at(LineAt(axis, place));
  const auto before = std::lower_bound(others.begin(), others.end(), here);
  const auto after = std::upper_bound(others.begin(), others.end(), here);
  low = before != others.begin() ? std::max(low, *(before - 1)) : low;
  high = after != others.end() ? std::min(high, *after) : high;
  return std::max(0.0, std::min(here - low, high - here));
}

double CommonNodes::MoveOf(const CommonNode& node, const std::function<Point3(PieceEnd)>& bulges,
  const std::function<double(int)>& tolerance) const
{
  const auto& [structure, number] = node.Members.front();
  const CycleGeometry& geometry = this->Structures[structure].Geometry;
  const GridEdge edge = EdgeOf(geometry, number);
  const float* n =
    this->Structures[structure].Normals.Normals.data() + 3 * static_cast<std::size_t>(number);
  const Point3 normal{ n[0], n[1], n[2] };
  double sum = 0.0;
  for (const PieceEnd& end : node.Ends)
  {
    sum += Dot(normal, bulges(end));
  }
  return NodeMove{ sum, normal[edge.Direction],
    this->RoomBeside(geometry.Grid, edge, geometry.Graph.PointAt(number)),
    std::min(tolerance(FirstAxis(edge.Direction)), tolerance(SecondAxis(edge.Direction))) }
    .Find();
}
}
