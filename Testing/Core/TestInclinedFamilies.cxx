// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a ball and an ellipsoid cut by families at 60 to 75 degrees, against orthogonal ones
 *
 * Lengths, angles and normals are those of the world, not of the map that makes boxes of oblique
 * cells.
 */

#include "Core/ReconstructSorted.h"

#include "Support/CheckEmbedding.h"
#include "Support/ReconstructionMesh.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
const double Pi = std::acos(-1.0);
constexpr int Points = 120;
/// How far the chords of a circle of radius 1 with so many points are from it.
const double Chord = 1.0 - std::cos(Pi / Points);

/// Half axes of an ellipsoid, which is turned against the axes of the world.
struct Ellipsoid
{
  Point3 HalfAxes;
  Matrix3 Turn = RotationAround({ 1.0, 2.0, 3.0 }, 0.8);

  /// The map of the unit ball to this.
  Point3 Map(const Point3& p) const
  {
    return Apply(
      this->Turn, { p[0] * this->HalfAxes[0], p[1] * this->HalfAxes[1], p[2] * this->HalfAxes[2] });
  }
  /// How far a point near the surface is from it, about: exactly so on a unit ball.
  double DistanceTo(const Point3& p) const
  {
    Point3 q = Apply(Transpose(this->Turn), p);
    double least = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis)
    {
      q[axis] /= this->HalfAxes[axis];
      least = std::min(least, this->HalfAxes[axis]);
    }
    return least * std::abs(Length(q) - 1.0);
  }
};

/// Unit normals at an angle to each other, in degrees, the last one along z.
std::array<Point3, 3> NormalsAt(double degrees)
{
  const double c = std::cos(degrees * Pi / 180.0), s = std::sqrt(1.0 - c * c);
  const double across = (c - c * c) / s;
  return { { { s, 0.0, c }, { across, std::sqrt(s * s - across * across), c },
    { 0.0, 0.0, 1.0 } } };
}

/// The cut with a plane at a share of the way from the first to the last point along its normal.
void AddCut(const Ellipsoid& solid, const Point3& normal, double share, int port, Polylines& lines)
{
  const Point3 turned = Apply(Transpose(solid.Turn), normal);
  Point3 inBall;
  for (int axis = 0; axis < 3; ++axis)
  {
    inBall[axis] = turned[axis] * solid.HalfAxes[axis];
  }
  const Point3 n = Unit(inBall);
  const Point3 u = Unit(Cross(n, std::abs(n[0]) < 0.7 ? Point3{ 1, 0, 0 } : Point3{ 0, 1, 0 }));
  const Point3 v = Cross(n, u);
  const double height = 2.0 * share - 1.0, radius = std::sqrt(1.0 - height * height);
  for (int i = 0; i < Points; ++i)
  {
    const double angle = 2.0 * Pi * (i + 0.3) / Points;
    const Point3 p =
      solid.Map(height * n + radius * std::cos(angle) * u + radius * std::sin(angle) * v);
    lines.X.push_back(p[0]);
    lines.Y.push_back(p[1]);
    lines.Z.push_back(p[2]);
  }
  lines.Offsets.push_back(static_cast<Index>(lines.X.size()));
  lines.Closed.push_back(1);
  lines.From.Port.push_back(static_cast<std::int8_t>(port));
  lines.From.Block.push_back(0);
  lines.From.Cell.push_back(static_cast<std::int64_t>(lines.From.Cell.size()));
}

/// `counts` planes of each family.
Polylines Cut(
  const Ellipsoid& solid, const std::array<Point3, 3>& normals, const std::array<int, 3>& counts)
{
  Polylines lines;
  for (int family = 0; family < 3; ++family)
  {
    for (int i = 0; i < counts[family]; ++i)
    {
      AddCut(
        solid, normals[family], (i + 0.5 + 0.01 * (family + 1)) / counts[family], family, lines);
    }
  }
  return lines;
}

double ErrorOf(const Ellipsoid& solid, const TriangleMesh& mesh)
{
  double sum = 0.0, area = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    const Point3 &a = mesh.Points[t[0]], &b = mesh.Points[t[1]], &c = mesh.Points[t[2]];
    const double size = Length(Cross(b - a, c - a));
    const double distance = solid.DistanceTo((1.0 / 3.0) * (a + b + c));
    sum += size * distance * distance;
    area += size;
  }
  return std::sqrt(sum / area);
}

/// What three quarters of the surface are nearer than: a few patches that fail do not count.
double UsualErrorOf(const Ellipsoid& solid, const TriangleMesh& mesh)
{
  std::vector<std::pair<double, double>> parts; // distance and area
  double area = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    const Point3 &a = mesh.Points[t[0]], &b = mesh.Points[t[1]], &c = mesh.Points[t[2]];
    parts.emplace_back(solid.DistanceTo((1.0 / 3.0) * (a + b + c)), Length(Cross(b - a, c - a)));
    area += parts.back().second;
  }
  std::sort(parts.begin(), parts.end());
  double below = 0.0;
  const auto at = std::find_if(parts.begin(), parts.end(),
    [&](const auto& part)
    {
      below += part.second;
      return below > 0.75 * area;
    });
  return at->first;
}

TriangleMesh RunCore(const Polylines& lines)
{
  Options options;
  options.Virtual = VirtualSlices::Automatic;
  return MeshOf(ReconstructSorted(SortByPlanes(lines, FrameOptions()), options, Execution()));
}

const Ellipsoid Ball{ { 1.0, 1.0, 1.0 } };
const Ellipsoid Long{ { 1.0, 0.7, 0.45 } };
}

//----------------------------------------------------------------------------
/// Oblique cells are longer, by 1.15 at 60 degrees in each family and more along the diagonal.
TEST(InclinedFamilies, DenseSlicesAreAsGoodAsOrthogonalOnes)
{
  for (const Ellipsoid& solid : { Ball, Long })
  {
    const double orthogonal = ErrorOf(solid, RunCore(Cut(solid, NormalsAt(90.0), { 9, 9, 9 })));
    for (const double degrees : { 75.0, 67.0, 60.0 })
    {
      SCOPED_TRACE(degrees);
      const TriangleMesh mesh = RunCore(Cut(solid, NormalsAt(degrees), { 9, 9, 9 }));
      EXPECT_EQ(DescribeFlaws(mesh), "");
      EXPECT_LT(ErrorOf(solid, mesh), (degrees > 70.0 ? 1.5 : 3.0) * orthogonal);
    }
  }
}

//----------------------------------------------------------------------------
/// A stack with two slices along its axis, at an angle to each other, as of a heart.
TEST(InclinedFamilies, FewSlicesAreAsGoodAsOrthogonalOnes)
{
  for (const double degrees : { 50.0, 60.0, 75.0 })
  {
    SCOPED_TRACE(degrees);
    const double c = std::cos(degrees * Pi / 180.0), s = std::sqrt(1.0 - c * c);
    const std::array<Point3, 3> normals{ { { 1.0, 0.0, 0.0 }, { c, s, 0.0 }, { 0.0, 0.0, 1.0 } } };
    for (const Ellipsoid& solid : { Ball, Long })
    {
      const Polylines lines = Cut(solid, normals, { 1, 1, 12 });
      const TriangleMesh mesh = RunCore(lines);
      EXPECT_EQ(DescribeFlaws(mesh), "");
      const double orthogonal =
        UsualErrorOf(solid, RunCore(Cut(solid, NormalsAt(90.0), { 1, 1, 12 })));
      EXPECT_LT(UsualErrorOf(solid, mesh), 1.5 * orthogonal + Chord);
    }
  }
}

//----------------------------------------------------------------------------
TEST(InclinedFamilies, TheSurfaceTurnsWithThem)
{
  const Matrix3 turn = RotationAround({ 2.0, -1.0, 0.5 }, 0.1);
  const Polylines lines = Cut(Long, NormalsAt(68.0), { 7, 8, 9 });
  Polylines turned = lines;
  for (std::size_t i = 0; i < lines.X.size(); ++i)
  {
    const Point3 p = Apply(turn, lines.PointAt(static_cast<Index>(i)));
    turned.X[i] = p[0];
    turned.Y[i] = p[1];
    turned.Z[i] = p[2];
  }
  const TriangleMesh one = RunCore(lines), other = RunCore(turned);
  ASSERT_EQ(one.Triangles, other.Triangles);
  for (std::size_t i = 0; i < one.Points.size(); ++i)
  {
    EXPECT_LT(Length(Apply(turn, one.Points[i]) - other.Points[i]), 1e-6);
  }
}
