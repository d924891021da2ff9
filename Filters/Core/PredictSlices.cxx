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

/// Vertices of contours so close to the line through others, in spacings, stay out of the patches
/// of predictions, which are off by a tenth and more: time would grow with the square of finely
/// drawn contours. But straight parts keep vertices, as they tell patches how contours tilt.
constexpr double Tolerance = 0.003;
constexpr double LongestSide = 0.1;

/// A surface that is compared with slices, of which few triangles would fall short.
void SetAccuracy(Options& settings)
{
  settings.ContourTolerance = std::max(settings.ContourTolerance, Tolerance);
  settings.LongestSide = LongestSide;
  settings.Patching.Accuracy = 0.0;
  settings.Patching.OwnAccuracy = false;
}

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

/// Fields through all slices but one of these.
std::vector<SliceField> SolveWithoutEach(
  const std::vector<SliceName>& slices, const Contours& drawn, const Pass& first, double step)
{
  std::vector<std::vector<ContourSample>> samples;
  for (const SliceName& slice : slices)
  {
    // Half as many samples cost an eighth of the time, and are as good for that.
    samples.push_back(SampleLoops(ListLoops(SelectSlice(drawn, slice, false), first), 2.0 * step));
  }
  return SliceField::ThroughEach(samples, first.Execute);
}

/// Finds distances from a surface for places that follow each other along curves: the triangle that
/// is nearest to one is near to the next, so that the boxes of most others are farther away.
class SurfaceDistance
{
public:
  explicit SurfaceDistance(const SurfaceTriangles& surface)
    : Surface(surface)
  {
    for (const auto& triangle : surface.Triangles)
    {
      this->Boxes.emplace_back();
      for (const Index point : triangle)
      {
        this->Boxes.back().Add(surface.Points[point]);
      }
    }
  }

  double operator()(const Point3& place)
  {
    double least =
      this->Nearest < this->Boxes.size() ? this->SquaredTo(this->Nearest, place) : HUGE_VAL;
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      if (this->Boxes[i].SquaredDistanceTo(place) < least)
      {
        const double squared = this->SquaredTo(i, place);
        this->Nearest = squared < least ? i : this->Nearest;
        least = std::min(least, squared);
      }
    }
    return std::sqrt(least);
  }

private:
  double SquaredTo(std::size_t triangle, const Point3& place) const
  {
    const auto& [a, b, c] = this->Surface.Triangles[triangle];
    const std::vector<Point3>& points = this->Surface.Points;
    return SquaredDistanceToTriangle(place, points[a], points[b], points[c]);
  }

  const SurfaceTriangles& Surface;
  std::vector<Box3> Boxes;
  std::size_t Nearest = 0; ///< to the place before
};
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
  const std::vector<SliceField> fields = SolveWithoutEach(slices, drawn, first, step);
  for (; done < slices.size(); ++done)
  {
    const SliceName& slice = slices[done];
    const SliceField& field = fields[done];
    Pass pass(first, SelectSlice(drawn, slice, false), part);
    SetAccuracy(pass.Settings);
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
    SurfaceDistance distance(surface);
    std::vector<WorldLoop> left = MapToWorld(SelectSlice(drawn, slice, true), metric);
    SortLoops(left);
    for (const ContourSample& sample : SampleLoops(left, 2.0 * step))
    {
      byPatches += distance(sample.Position);
      byField += field.Distance(sample.Position);
    }
  }
  return byField > 0.0 ? byPatches / byField : 0.0;
}
}
