// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PredictSlices.h"

#include "Core/Base/EditContours.h"
#include "Core/Base/TriangleDistance.h"
#include "Core/Sparse/SliceField.h"
#include "Core/Sparse/SurfaceMesh.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Of a family of more than two slices these are left out: at a third and two thirds of it.
constexpr Index FewSlices = 3;

struct SliceName
{
  int Axis;
  Index Plane;
};

std::vector<SliceName> ChooseSlices(const SpatialGrid& grid)
{
  std::vector<SliceName> slices;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Index count = grid.Count(axis);
    for (Index plane = 0; plane < count; ++plane)
    {
      if (count < FewSlices || plane == count / 3 || plane == 2 * count / 3)
      {
        slices.push_back({ axis, plane });
      }
    }
  }
  return slices;
}

/// The contours of a slice, or those of all others.
Contours SelectSlice(const Contours& contours, const SliceName& slice, bool ofSlice)
{
  std::vector<std::uint8_t> marked;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const bool isOf = contours.Axis[i] == slice.Axis && contours.Plane[i] == slice.Plane;
    marked.push_back(isOf != ofSlice ? 1 : 0);
  }
  Contours chosen = contours;
  RemoveMarked(marked, chosen);
  return chosen;
}

double DistanceFrom(const SurfaceTriangles& surface, const Point3& place)
{
  double least = HUGE_VAL;
  for (const auto& t : surface.Triangles)
  {
    least = std::min(least,
      SquaredDistanceToTriangle(
        place, surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]]));
  }
  return std::sqrt(least);
}
}

std::vector<WorldLoop> ListLoops(const Contours& drawn, const Pass& pass)
{
  std::vector<WorldLoop> loops = MapToWorld(drawn, pass.Settings.Metric);
  if (pass.Settings.Guides != nullptr)
  {
    AppendGuides(*pass.Settings.Guides, pass.Settings.Metric, loops);
  }
  SortLoops(loops);
  return loops;
}

double ComparePredictions(const Contours& drawn, Pass& first, double step, const Sketcher& sketch)
{
  double byPatches = 0.0, byField = 0.0;
  const std::vector<SliceName> slices = ChooseSlices(first.Result.Grid);
  std::size_t done = 0;
  Execution part = first.Outer;
  part.Continue = [&](double progress)
  { return first.GoOn((static_cast<double>(done) + progress) / slices.size()); };
  for (; done < slices.size(); ++done)
  {
    const SliceName& slice = slices[done];
    const Contours others = SelectSlice(drawn, slice, false);
    // Half as many samples cost an eighth of the time, and are as good for that.
    const SliceField field(SampleLoops(ListLoops(others, first), 2.0 * step), first.Execute);
    Pass pass(first, Contours(others), part);
    if (!field.IsSolved())
    {
      continue;
    }
    if (!sketch(pass))
    {
      return 0.0;
    }
    const AxisFrame& metric = first.Result.Grid.Metric;
    SurfaceTriangles surface =
      ListTriangles(GeometryOf(pass.Result), pass.Result.Surface, first.Execute);
    for (Point3& point : surface.Points)
    {
      point = metric.ToWorld(point);
    }
    std::vector<WorldLoop> left = MapToWorld(SelectSlice(drawn, slice, true), metric);
    SortLoops(left);
    for (const ContourSample& sample : SampleLoops(left, 2.0 * step))
    {
      byPatches += DistanceFrom(surface, sample.Position);
      byField += field.Distance(sample.Position);
    }
  }
  return byField > 0.0 ? byPatches / byField : 0.0;
}
}
