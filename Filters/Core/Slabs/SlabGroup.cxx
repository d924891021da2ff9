// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/SlabGroup.h"

#include "Core/Base/Box.h"
#include "Core/Base/DisjointSets.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <map>

namespace orthoslices
{
Index CycleOfLoop(const CycleGeometry& geometry, Index loop, bool above)
{
  // The cycles of loops are the last ones: two each, below and above.
  return geometry.Cycles.Count() - 2 * static_cast<Index>(geometry.Graph.Loops.size()) + 2 * loop +
    (above ? 1 : 0);
}

std::vector<Point2> OutlineOf(const NodeGraph& graph, Index loop)
{
  const int axis = graph.Loops[loop].Axis;
  const Index arc = graph.Arcs + loop;
  std::vector<Point2> polygon;
  for (Index i = 0; i < graph.PointCount(arc); ++i)
  {
    const Point3 p = graph.PointAt(graph.FirstPoint(arc) + i);
    polygon.push_back({ p[FirstAxis(axis)], p[SecondAxis(axis)] });
  }
  return polygon;
}

std::vector<SlabGroup> FormSlabGroups(const CycleGeometry& geometry,
  CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs)
{
  const NodeGraph& graph = geometry.Graph;
  std::vector<SlabGroup> groups;
  const bool together = criterion == CorrespondenceCriterion::ByEvidence ||
    criterion == CorrespondenceCriterion::Overlap;
  DisjointSets sets(geometry.Cycles.Count());
  for (const LoopPair& pair : pairs)
  {
    sets.Unite(pair.First, pair.Second);
  }
  std::map<std::pair<Index, Index>, std::size_t> groupOf;
  for (Index loop = 0; loop < static_cast<Index>(graph.Loops.size()); ++loop)
  {
    const std::vector<Point2> polygon = OutlineOf(graph, loop);
    for (const bool above : { false, true })
    {
      const Index slab = graph.Loops[loop].Plane + (above ? 1 : 0);
      const Index set = together ? 0 : sets.Find(CycleOfLoop(geometry, loop, above));
      const auto at = groupOf.emplace(std::make_pair(slab, set), groups.size());
      if (at.second)
      {
        groups.push_back({ slab, {}, {}, { 0.0, 0.0 }, {} });
      }
      SlabGroup& group = groups[at.first->second];
      group.Loops.push_back(loop);
      group.Outlines.push_back({ polygon, !above });
    }
  }
  return groups;
}

Point2 MiddleOfCurves(const std::vector<SlabLoop>& loops, bool upper)
{
  CurveCenter center(Point3{ 0.0, 0.0, 0.0 });
  for (const SlabLoop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.Points.size() && loop.Upper == upper; ++i)
    {
      const Point2& p = loop.Points[i];
      const Point2& q = loop.Points[(i + 1) % loop.Points.size()];
      center.Add({ p[0], p[1], 0.0 }, { q[0], q[1], 0.0 });
    }
  }
  const Point3 result = center.Get();
  return { result[0], result[1] };
}

Point2 MiddleOfBox(const std::vector<SlabLoop>& loops, bool upper)
{
  Box3 box;
  for (const SlabLoop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.Points.size() && loop.Upper == upper; ++i)
    {
      box.Add(Point3{ loop.Points[i][0], loop.Points[i][1], 0.0 });
    }
  }
  return { 0.5 * (box.Low[0] + box.High[0]), 0.5 * (box.Low[1] + box.High[1]) };
}

Index CountPieces(const SlabOverlay& overlay)
{
  return overlay.Piece.empty() ? 0
                               : *std::max_element(overlay.Piece.begin(), overlay.Piece.end()) + 1;
}

void OverlayGroup(bool mayShear, SlabGroup& group)
{
  group.Overlay = OverlaySlab(group.Outlines, group.Shift);
  if (!mayShear || (group.Overlay.Valid && CountPieces(group.Overlay) == 1))
  {
    return;
  }
  const Point2 lower = MiddleOfCurves(group.Outlines, false);
  const Point2 upper = MiddleOfCurves(group.Outlines, true);
  const Point2 shift{ upper[0] - lower[0], upper[1] - lower[1] };
  SlabOverlay sheared = OverlaySlab(group.Outlines, shift);
  if (sheared.Valid && CountPieces(sheared) == 1)
  {
    group.Shift = shift;
    group.Overlay = std::move(sheared);
  }
  else
  {
    group.Overlay.Valid = false;
  }
}
}
