// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ClearLines.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/SliceMembers.h"
#include "Core/Labels/StripClearer.h"

namespace orthoslices
{
namespace
{
std::vector<std::vector<Point2>> PolygonsOf(
  const std::vector<SliceMember>& members, const std::vector<Contours*>& structures)
{
  std::vector<std::vector<Point2>> polygons;
  for (const SliceMember& member : members)
  {
    polygons.push_back(PolygonOf(*structures[member.Structure], member.Contour));
  }
  return polygons;
}

/// Gives contours other vertices; those that have fewer than three are taken out.
void ReplaceVertices(const std::vector<std::vector<Point2>>& polygons, Contours& contours)
{
  contours.U.clear();
  contours.V.clear();
  contours.Offsets.assign(1, 0);
  std::vector<std::uint8_t> isEmpty;
  for (const std::vector<Point2>& polygon : polygons)
  {
    for (const Point2& place : polygon)
    {
      contours.U.push_back(place[0]);
      contours.V.push_back(place[1]);
    }
    contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
    isEmpty.push_back(polygon.size() < 3 ? 1 : 0);
  }
  RemoveMarked(isEmpty, contours);
}

/// Gives all contours the vertices of polygons, which are listed by slice.
void Replace(const std::vector<std::vector<SliceMember>>& slices,
  std::vector<std::vector<std::vector<Point2>>>& polygons, const std::vector<Contours*>& structures)
{
  std::vector<std::vector<std::vector<Point2>>> ofStructures;
  for (const Contours* contours : structures)
  {
    ofStructures.emplace_back(contours->Count());
  }
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    for (std::size_t k = 0; k < slices[i].size(); ++k)
    {
      const SliceMember& member = slices[i][k];
      ofStructures[member.Structure][member.Contour] = std::move(polygons[i][k]);
    }
  }
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    ReplaceVertices(ofStructures[i], *structures[i]);
  }
}
}

void ClearLines(
  const SpatialGrid& grid, const Execution& execution, const std::vector<Contours*>& structures)
{
  const std::vector<std::vector<SliceMember>> slices =
    ListSlices({ structures.begin(), structures.end() });
  const auto clearerOf = [&](const std::vector<SliceMember>& members, int across)
  {
    const Contours& any = *structures[members.front().Structure];
    const Index contour = members.front().Contour;
    return StripClearer(grid, any.Axis[contour], any.Coordinate[contour], across);
  };
  NodesOfLines nodes;
  for (const std::vector<SliceMember>& members : slices)
  {
    const std::vector<std::vector<Point2>> polygons = PolygonsOf(members, structures);
    clearerOf(members, 0).ListNodes(polygons, nodes);
    clearerOf(members, 1).ListNodes(polygons, nodes);
  }
  for (auto& [line, places] : nodes)
  {
    const int direction = std::get<0>(line);
    places.Settle(grid, direction, StripBands(grid, direction));
  }
  std::vector<std::vector<std::vector<Point2>>> cleared(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        cleared[i] = PolygonsOf(slices[i], structures);
        clearerOf(slices[i], 0).Run(nodes, true, cleared[i]);
        clearerOf(slices[i], 1).Run(nodes, false, cleared[i]);
      }
    });
  Replace(slices, cleared, structures);
}
}
