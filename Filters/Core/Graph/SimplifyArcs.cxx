// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/SimplifyArcs.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"
#include "Core/Graph/EditGraph.h"

#include <algorithm>

namespace orthoslices
{
void MarkKept(const std::vector<Point3>& points, double tolerance, std::vector<std::uint8_t>& kept)
{
  std::vector<std::pair<std::size_t, std::size_t>> open{ { 0, points.size() - 1 } };
  kept.assign(points.size(), 0);
  while (!open.empty())
  {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance * tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i)
    {
      const double distance = SquaredDistanceToSegment(points[i], points[first], points[last]);
      if (distance > farthest)
      {
        farthest = distance;
        split = i;
      }
    }
    if (split != first)
    {
      kept[split] = 1;
      open.push_back({ first, split });
      open.push_back({ split, last });
    }
  }
}

namespace
{
/// Marks vertices in addition, as few as leave no side longer than that.
void KeepSidesShort(
  const std::vector<Point3>& points, double longest, std::vector<std::uint8_t>& kept)
{
  std::size_t last = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    if (!kept[i] && Length(points[i + 1] - points[last]) > longest)
    {
      kept[i] = 1;
    }
    last = kept[i] ? i : last;
  }
}
}

void ThinArcs(const Thinning& thinning, const GridCrossings& crossings, const NodePoints& nodes,
  const Execution& execution, NodeGraph& graph)
{
  if (!(thinning.Tolerance > 0.0))
  {
    return;
  }
  std::vector<std::uint8_t> isKept(graph.Offsets.back(), 1);
  execution.For(crossings.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Point3> points;
      std::vector<std::uint8_t> kept;
      for (std::size_t c = begin; c < end; ++c)
      {
        const Index arc = static_cast<Index>(c);
        const Index count = graph.PointCount(arc);
        if (count == 0)
        {
          continue;
        }
        points.assign(1, graph.PointAt(nodes.NodeOf[arc]));
        for (Index i = 0; i < count; ++i)
        {
          points.push_back(graph.PointAt(graph.FirstPoint(arc) + i));
        }
        points.push_back(graph.PointAt(nodes.NodeOf[crossings.Next[arc]]));
        MarkKept(points, thinning.Tolerance, kept);
        KeepSidesShort(points, thinning.LongestSide, kept);
        std::copy(kept.begin() + 1, kept.end() - 1, isKept.begin() + graph.Offsets[arc]);
      }
    });
  LeaveOutVertices(isKept, graph);
}
}
