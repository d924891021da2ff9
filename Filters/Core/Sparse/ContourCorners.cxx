// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/ContourCorners.h"

#include "Core/Base/Vectors.h"
#include "Core/Graph/ContourRings.h"
#include "Core/Patches/SliceMetric.h"
#include "Core/Slices/ContourCurve.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The length over which the directions at a corner are measured, as a share of the spacing: as far
/// as a corner is looked for.
constexpr double Reach = 0.12;

Point2 UnitOf(const Point2& way) { return (1.0 / std::max(Length(way), 1e-300)) * way; }

class CornerFinder
{
public:
  CornerFinder(const CycleGeometry& geometry, double cornerAngle)
    : Geometry(geometry)
    , CornerAngle(cornerAngle)
  {
  }

  std::vector<ContourCorner> Run();

private:
  void AddContour(int axis, const std::vector<Index>& points);

  const CycleGeometry& Geometry;
  double CornerAngle;
  std::vector<ContourCorner> Found;
};

void CornerFinder::AddContour(int axis, const std::vector<Index>& points)
{
  const double spacing = MeanSpacingInSlices(this->Geometry.Grid, axis);
  const SliceMetric metric(this->Geometry.Grid.Metric, axis);
  std::vector<Point2> places;
  for (const Index point : points)
  {
    places.push_back(metric.ToTrue(this->Geometry.Graph.PointAt(point)));
  }
  MeasuredCurve measured;
  measured.Set(std::move(places), spacing, this->CornerAngle);
  const ContourCurve& curve = measured.Curve;
  for (Index i = 0; i < curve.Count() && curve.HasCorners(); ++i)
  {
    if (curve.IsCorner(i))
    {
      const Point2 back = UnitOf(curve.Reach(i, Reach * spacing, false));
      const Point2 on = UnitOf(curve.Reach(i, Reach * spacing, true));
      Point3 tip{ 0.0, 0.0, 0.0 };
      tip[FirstAxis(axis)] = -back[0] - on[0];
      tip[SecondAxis(axis)] = -back[1] - on[1];
      const double turn =
        std::atan2(on[0] * back[1] - on[1] * back[0], -on[0] * back[0] - on[1] * back[1]);
      this->Found.push_back({ points[i], axis, Unit(tip), turn });
    }
  }
}

std::vector<ContourCorner> CornerFinder::Run()
{
  const NodeGraph& graph = this->Geometry.Graph;
  const ContourRings rings(
    this->Geometry.Grid, this->Geometry.Crossings, this->Geometry.Nodes, graph);
  const std::array<std::vector<Index>, 3> starts = rings.FindStarts();
  ArcRing ring;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Index start : starts[axis])
    {
      rings.List(start, ring);
      this->AddContour(axis, ring.Points);
    }
  }
  for (std::size_t loop = 0; loop < graph.Loops.size(); ++loop)
  {
    const Index arc = graph.Arcs + static_cast<Index>(loop);
    std::vector<Index> points(static_cast<std::size_t>(graph.PointCount(arc)));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i] = graph.FirstPoint(arc) + static_cast<Index>(i);
    }
    this->AddContour(graph.Loops[loop].Axis, points);
  }
  return std::move(this->Found);
}
}

std::vector<ContourCorner> FindContourCorners(const CycleGeometry& geometry, double cornerAngle)
{
  return CornerFinder(geometry, cornerAngle).Run();
}
}
