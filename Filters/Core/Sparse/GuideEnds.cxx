// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/GuideEnds.h"

#include "Core/Base/TriangleDistance.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// The loop on a plane that is nearest to a point; -1 if there is none.
Index FindNearestLoop(const NodeGraph& graph, Index plane, const Point3& point)
{
  double least = std::numeric_limits<double>::infinity();
  Index found = -1;
  for (Index loop = 0; loop < static_cast<Index>(graph.Loops.size()); ++loop)
  {
    const Index arc = graph.Arcs + loop, count = graph.PointCount(arc);
    for (Index i = 0; i < count && graph.Loops[loop].Plane == plane; ++i)
    {
      const Index first = graph.FirstPoint(arc);
      const double distance = SquaredDistanceToSegment(
        point, graph.PointAt(first + i), graph.PointAt(first + (i + 1) % count));
      if (distance < least)
      {
        least = distance;
        found = loop;
      }
    }
  }
  return found;
}
}

std::vector<double> FindEndHeights(const NodeGraph& graph, const GuideCurves& guides)
{
  std::vector<double> heights(static_cast<std::size_t>(graph.Count()), -1.0);
  const Index last = static_cast<Index>(guides.StackPlanes.size());
  for (const GuideSlice& slice : guides.Slices)
  {
    for (const GuidePiece& piece : slice.Pieces)
    {
      if (piece.Slab != 0 && piece.Slab != last)
      {
        continue;
      }
      const Index plane = piece.Slab == 0 ? 0 : last - 1;
      for (const Point3& end : { piece.Points.front(), piece.Points.back() })
      {
        const Index loop = FindNearestLoop(graph, plane, end);
        if (loop >= 0)
        {
          const auto first = heights.begin() + graph.FirstPoint(graph.Arcs + loop);
          const double height = std::max(*first, guides.HeightBeyond(piece));
          std::fill_n(first, graph.PointCount(graph.Arcs + loop), height);
        }
      }
    }
  }
  return heights;
}

void AddPoints(const GuideCurves& guides, Box3& box)
{
  for (const GuideSlice& slice : guides.Slices)
  {
    for (const GuidePiece& piece : slice.Pieces)
    {
      for (const Point3& point : piece.Points)
      {
        box.Add(point);
      }
    }
  }
}
}
