// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/OverlaySlab.h"

#include "Core/Planar/ConstrainedTriangulation.h"
#include "Core/Slabs/OverlayGraph.h"
#include "Core/Slabs/OverlaySurface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace orthoslices
{
namespace
{
/// Displacements of the upper loops that are tried one after another, as shares of the extent of
/// all loops. Contours of voxel data, or of a prism, have vertices and segments in common with
/// those of the next slice; they have none after a displacement in a direction that is none of the
/// grid's. So the digits are of irrational numbers (the golden ratio, e, pi, the square roots of 3,
/// 2 and 5). The sizes are far above rounding, some 1e-16, and far below the detail of contours.
constexpr std::array<Point2, 3> Displacements{ { { 0.6180339887e-7, 0.2718281828e-7 },
  { -0.3141592654e-7, 0.7320508076e-7 }, { -0.4142135624e-6, -0.2360679775e-6 } } };

/// The surface for one displacement of the upper loops.
SlabOverlay OverlayDisplaced(
  const std::vector<SlabLoop>& loops, const Point2& shift, const Point2& displacement)
{
  OverlayGraph graph(loops, shift, displacement);
  std::array<PlaneRegion, 2> regions{ PlaneRegion(0), PlaneRegion(0) };
  if (!graph.Build() || !graph.FindRegions(regions))
  {
    return {};
  }
  ConstrainedTriangulation triangulation(graph.GetPlaces(), graph.GetLevels(), regions);
  if (!triangulation.Run(graph.GetOrder()))
  {
    return {};
  }
  return MakeOverlaySurface(graph, regions, triangulation.GetRegions(), displacement);
}

/// The larger side of the box around all loops; negative if there is something wrong with a loop.
double ExtentOf(const std::vector<SlabLoop>& loops, const Point2& shift)
{
  Point2 low{ HUGE_VAL, HUGE_VAL };
  Point2 high{ -HUGE_VAL, -HUGE_VAL };
  for (const SlabLoop& loop : loops)
  {
    if (loop.Points.size() < 3)
    {
      return -1.0;
    }
    for (const Point2& point : loop.Points)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        const double x = loop.Upper ? point[axis] - shift[axis] : point[axis];
        if (!std::isfinite(x))
        {
          return -1.0;
        }
        low[axis] = std::min(low[axis], x);
        high[axis] = std::max(high[axis], x);
      }
    }
  }
  return std::max(high[0] - low[0], high[1] - low[1]);
}
}

SlabOverlay OverlaySlab(const std::vector<SlabLoop>& loops, const Point2& shift)
{
  SlabOverlay result;
  if (loops.empty())
  {
    result.Valid = true;
    return result;
  }
  const double extent = ExtentOf(loops, shift);
  for (const Point2& displacement : Displacements)
  {
    if (extent > 0.0 && !result.Valid)
    {
      result =
        OverlayDisplaced(loops, shift, { extent * displacement[0], extent * displacement[1] });
    }
  }
  return result;
}

namespace
{
/// An insertion into a loop as it is on the same loop passed the other way round.
SlabOverlay::Insertion Reverse(
  const SlabOverlay::Insertion& insertion, const std::vector<SlabLoop>& loops)
{
  const Index count = static_cast<Index>(loops[insertion.Loop].Points.size());
  const double share = std::min(1.0 - insertion.Share, std::nextafter(1.0, 0.0));
  return { insertion.Loop, (2 * count - 2 - insertion.After) % count, share };
}

/// Makes an overlay of reversed loops one of the loops themselves, with its other side outside.
void ReverseOverlay(const std::vector<SlabLoop>& loops, SlabOverlay& overlay)
{
  std::vector<Index> cornerOf;
  for (const SlabLoop& loop : loops)
  {
    const Index first = static_cast<Index>(cornerOf.size());
    for (Index i = static_cast<Index>(loop.Points.size()) - 1; i >= 0; --i)
    {
      cornerOf.push_back(first + i);
    }
  }
  const std::vector<SlabOverlay::Insertion> before = overlay.Insertions;
  const Index vertices = static_cast<Index>(cornerOf.size());
  const Index count = static_cast<Index>(before.size());
  std::vector<Index> order(before.size()); // those on one segment are in descending order before
  std::iota(order.rbegin(), order.rend(), 0);
  const auto segmentOf = [&](Index i)
  {
    const SlabOverlay::Insertion insertion = Reverse(before[i], loops);
    return std::make_tuple(insertion.Loop, insertion.After);
  };
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return segmentOf(a) < segmentOf(b); });
  cornerOf.resize(vertices + count);
  for (Index i = 0; i < count; ++i)
  {
    overlay.Insertions[i] = Reverse(before[order[i]], loops);
    cornerOf[vertices + order[i]] = vertices + i;
  }
  const auto move = [&](Index corner)
  { return corner < vertices + count ? cornerOf[corner] : corner; };
  for (auto& [a, b, c] : overlay.Triangles)
  {
    std::tie(a, b, c) = std::make_tuple(move(a), move(c), move(b));
  }
}
}

SlabOverlay OverlayHoles(const std::vector<SlabLoop>& loops, const Point2& shift)
{
  std::vector<SlabLoop> reversed = loops;
  for (SlabLoop& loop : reversed)
  {
    std::reverse(loop.Points.begin(), loop.Points.end());
  }
  SlabOverlay overlay = OverlaySlab(reversed, shift);
  ReverseOverlay(loops, overlay);
  return overlay;
}
}
