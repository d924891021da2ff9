// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far the surface lies off solids that are known, and how far its normals are turned: what the
 * constants of smooth patches and of normals were judged by (see their comments). To try another
 * value, change the constant and run the program again.
 *
 *   PatchErrors [planes ...]
 *
 * For each number of planes on each axis (default: 10, 16 and 24) and each kind of contours one row:
 *   exact   cuts of five smooth solids (AllSmoothSolids)
 *   noisy   the same, vertices moved within their planes by up to 3 % of the plane spacing
 *   coarse  the same with every fourth vertex of the contours
 * Columns: root mean square and 99th percentile of the distance from the surface to the solid, in
 * hundredths of the plane spacing, at the vertices inside patches and the centres of triangles; root
 * mean square angle of the normals at the points of the contours, in degrees;
 * share of polygons that are left as fans, in percent. Rows are means over the solids.
 */

#include "Core/Base/Vectors.h"
#include "Core/Reconstruct.h"
#include "Support/Perturbations.h"
#include "Support/SliceSolid.h"
#include "Support/SmoothSolids.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A solid and the nearest point of its surface to a point near by, with the normal there.
struct Shape
{
  Solid Body;
  std::function<Point3(const Point3&, Point3&)> Project;
};

std::vector<Shape> SmoothShapes()
{
  std::vector<Shape> shapes;
  for (const SmoothSolid& solid : AllSmoothSolids())
  {
    shapes.push_back(
      { solid, [solid](const Point3& p, Point3& normal) { return solid.Project(p, normal); } });
  }
  return shapes;
}

struct Errors
{
  double Distance = 0.0, Percentile = 0.0, Angle = 0.0, Fans = 0.0;
};

/// The places at which the distance is measured.
std::vector<Point3> PlacesOf(const Reconstruction& result)
{
  std::vector<double> points(result.Graph.Points.begin(), result.Graph.Points.end());
  const std::size_t given = points.size();
  const std::vector<double>& centers = result.Surface.CentralPoints;
  points.insert(points.end(), centers.begin(), centers.end());
  const std::vector<double> others = ListOtherPoints(result.Surface);
  points.insert(points.end(), others.begin(), others.end());
  std::vector<std::int32_t> corners(3 * result.Surface.TriangleCount());
  WriteTriangles(result.Surface, GeometryOf(result), Execution(), corners.data());
  const auto at = [&](std::size_t i) -> Point3 {
    return { points[3 * i], points[3 * i + 1], points[3 * i + 2] };
  };
  std::vector<Point3> places;
  for (std::size_t i = given / 3; i < points.size() / 3; ++i)
  {
    places.push_back(at(i));
  }
  for (std::size_t t = 0; t < corners.size(); t += 3)
  {
    places.push_back((1.0 / 3.0) * (at(corners[t]) + at(corners[t + 1]) + at(corners[t + 2])));
  }
  return places;
}

Errors Measure(const Shape& shape, PieceSets sets)
{
  const Reconstruction result = Reconstruct(std::move(sets), Options(), Execution());
  const double spacing = MinMeanSpacing(result.Grid);
  Errors errors;
  std::vector<double> distances;
  for (const Point3& place : PlacesOf(result))
  {
    Point3 normal;
    distances.push_back(100.0 / spacing * Length(shape.Project(place, normal) - place));
    errors.Distance += distances.back() * distances.back();
  }
  errors.Distance = std::sqrt(errors.Distance / static_cast<double>(distances.size()));
  const auto percentile = distances.begin() + static_cast<std::ptrdiff_t>(0.99 * distances.size());
  std::nth_element(distances.begin(), percentile, distances.end());
  errors.Percentile = *percentile;
  for (Index i = 0; i < result.Graph.Count(); ++i)
  {
    Point3 normal;
    shape.Project(result.Graph.PointAt(i), normal);
    const float* n = result.Normals.Normals.data() + 3 * static_cast<std::size_t>(i);
    const double half = 0.5 * Length(Point3{ n[0], n[1], n[2] } - normal);
    const double angle = 2.0 * 57.29577951308232 * std::asin(std::min(1.0, half));
    errors.Angle += angle * angle / result.Graph.Count();
  }
  errors.Angle = std::sqrt(errors.Angle);
  const Index filled = result.Surface.Inner.Count();
  errors.Fans = 100.0 * (result.Cycles.Count() - filled) / result.Cycles.Count();
  return errors;
}

enum class Kind
{
  Exact,
  Noisy,
  Coarse
};

PieceSets Cut(const Shape& shape, int planes, Kind kind)
{
  const Solid& solid = shape.Body;
  const double spacing = (solid.High[0] - solid.Low[0]) / planes;
  PieceSets sets =
    SliceSolid(solid, EqualPlanes(solid, { planes, planes, planes }), 6, InPlaneGrid::Free);
  if (kind == Kind::Noisy)
  {
    MoveVertices(sets, 0.03 * spacing, 1);
  }
  for (Pieces& pieces : sets)
  {
    if (kind == Kind::Coarse)
    {
      ThinOut(pieces, 4);
    }
  }
  return sets;
}

void PrintRow(const char* name, int planes, Kind kind, const std::vector<Shape>& shapes)
{
  Errors mean;
  for (const Shape& shape : shapes)
  {
    const Errors errors = Measure(shape, Cut(shape, planes, kind));
    const double share = 1.0 / static_cast<double>(shapes.size());
    mean.Distance += share * errors.Distance;
    mean.Percentile += share * errors.Percentile;
    mean.Angle += share * errors.Angle;
    mean.Fans += share * errors.Fans;
  }
  std::printf("%6d  %-6s  %8.4f  %8.4f  %7.3f  %6.2f\n", planes, name, mean.Distance,
    mean.Percentile, mean.Angle, mean.Fans);
}
}

int main(int argc, char** argv)
{
  std::vector<int> counts;
  for (int i = 1; i < argc; ++i)
  {
    counts.push_back(std::atoi(argv[i]));
  }
  if (counts.empty())
  {
    counts = { 10, 16, 24 };
  }
  std::printf("planes  cuts         rms        99%%    angle    fans\n");
  for (const int planes : counts)
  {
    PrintRow("exact", planes, Kind::Exact, SmoothShapes());
    PrintRow("noisy", planes, Kind::Noisy, SmoothShapes());
    PrintRow("coarse", planes, Kind::Coarse, SmoothShapes());
  }
  return 0;
}
