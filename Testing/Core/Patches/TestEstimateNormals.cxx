// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/EstimateNormals.h"

#include "Core/Base/Vectors.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double CornerAngle = 1.05;

SurfaceNormals NormalsOf(const Stages& stages, double cornerAngle = CornerAngle)
{
  return EstimateNormals(stages.Geometry(), cornerAngle, {}, Execution());
}

Point3 NormalAt(const SurfaceNormals& normals, Index point)
{
  const float* n = normals.Normals.data() + 3 * static_cast<std::size_t>(point);
  return { n[0], n[1], n[2] };
}

Solid Ellipsoid()
{
  Solid solid;
  solid.Low = { -1.63, -1.21, -0.99 };
  solid.High = { 1.57, 1.22, 0.94 };
  solid.Function = [](const Point3& p) { return std::hypot(p[0] / 1.4, p[1], p[2] / 0.8) - 1.0; };
  return solid;
}

Stages Slices(
  const Solid& solid, int count, int subdivisions = 8, InPlaneGrid grid = InPlaneGrid::Free)
{
  Input input;
  input.Sets = SliceSolid(solid, EqualPlanes(solid, { count, count, count }), subdivisions, grid);
  return Stages(input);
}

struct Errors
{
  double Mean, Greatest; ///< angles
};

Errors ErrorsOf(const Stages& stages, const Solid& solid)
{
  const SurfaceNormals normals = NormalsOf(stages);
  Errors errors{ 0.0, 0.0 };
  for (Index i = 0; i < stages.Graph.Count(); ++i)
  {
    const Point3 expected = Unit(solid.Gradient(stages.Graph.PointAt(i)));
    const double angle = 2.0 * std::asin(0.5 * Length(NormalAt(normals, i) - expected));
    errors.Mean += angle / stages.Graph.Count();
    errors.Greatest = std::max(errors.Greatest, angle);
  }
  return errors;
}

/// Coordinates on the sides of the cube: one on its faces, two on its edges.
int CountSides(const Point3& p)
{
  return static_cast<int>(std::count_if(
    p.begin(), p.end(), [](double x) { return std::abs(std::abs(x - 1.5) - 1.0) < 1e-9; }));
}
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, HaveUnitLength)
{
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    const SurfaceNormals normals = NormalsOf(stages);
    ASSERT_EQ(normals.Normals.size(), 3u * stages.Graph.Count());
    EXPECT_TRUE(normals.Corners.empty() ||
      normals.Corners.size() == static_cast<std::size_t>(stages.Graph.Count()));
    for (Index i = 0; i < stages.Graph.Count(); ++i)
    {
      ASSERT_NEAR(Length(NormalAt(normals, i)), 1.0, 1e-6) << seed;
    }
  }
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, PointAlongTheGradient)
{
  for (const Solid& solid : { TiltedTorus(), Ellipsoid() })
  {
    const Errors exact = ErrorsOf(Slices(solid, 20, 8, InPlaneGrid::Aligned), solid);
    EXPECT_LT(exact.Mean, 0.003);
    EXPECT_LT(exact.Greatest, 0.15);
    // Contours that meet but for the height of their chords.
    EXPECT_LT(ErrorsOf(Slices(solid, 20), solid).Mean, 0.01);
  }
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, ConvergeWithTheThirdPowerOfTheSpacing)
{
  for (const Solid& solid : { TiltedTorus(), Ellipsoid() })
  {
    const auto error = [&](int count)
    { return ErrorsOf(Slices(solid, count, 8, InPlaneGrid::Aligned), solid).Mean; };
    EXPECT_GT(error(12), 6.0 * error(24));
  }
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, OfNodePointsAreOrthogonalToBothContours)
{
  const Solid solid = Ellipsoid();
  const Stages stages = Slices(solid, 14, 16);
  const SurfaceNormals normals = NormalsOf(stages);
  for (Index node = 0; node < stages.Nodes.Count(); ++node)
  {
    const Point3 gradient = Unit(solid.Gradient(stages.Graph.PointAt(node)));
    const int direction = stages.EdgeOf(stages.Nodes.First[node]).Direction;
    if (std::abs(gradient[direction]) > 0.3) // else the contours run along each other
    {
      EXPECT_LT(Length(NormalAt(normals, node) - gradient), 6e-3);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, OfACubeAreThoseOfItsFaces)
{
  const Stages stages{ Cube(20) };
  const SurfaceNormals normals = NormalsOf(stages);
  ASSERT_EQ(normals.Corners.size(), static_cast<std::size_t>(stages.Graph.Count()));
  for (Index i = 0; i < stages.Graph.Count(); ++i)
  {
    const Point3 p = stages.Graph.PointAt(i), n = NormalAt(normals, i);
    const int sides = CountSides(p);
    ASSERT_GE(sides, 1);
    EXPECT_EQ(normals.Corners[i], sides > 1 ? 1 : 0);
    for (int axis = 0; axis < 3 && sides == 1; ++axis)
    {
      const double distance = p[axis] - 1.5;
      EXPECT_NEAR(n[axis], std::abs(distance) > 0.999 ? distance : 0.0, 1e-5);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, WithoutCornersThereIsNoListOfThem)
{
  EXPECT_TRUE(NormalsOf(Stages{ Cube(20) }, 1.7).Corners.empty());
  EXPECT_TRUE(NormalsOf(Slices(Ellipsoid(), 8)).Corners.empty());
  const Stages cube{ Cube() };
  const SurfaceNormals normals = NormalsOf(cube);
  EXPECT_EQ(std::count(normals.Corners.begin(), normals.Corners.end(), 1), 24);
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, OfLoopsLieInTheirPlane)
{
  std::string text = "z=1:";
  for (int i = 0; i < 40; ++i)
  {
    const double t = 2.0 * 3.14159265358979 * i / 40;
    text +=
      " " + std::to_string(3.0 + 0.5 * std::cos(t)) + "," + std::to_string(2.0 + 0.5 * std::sin(t));
  }
  const Reconstruction result = Reconstruct(ParsePieces(text), Options(), Execution());
  ASSERT_EQ(result.Graph.Loops.size(), 1u);
  const SurfaceNormals normals = EstimateNormals(GeometryOf(result), CornerAngle, {}, Execution());
  ASSERT_EQ(result.Graph.Count(), 40);
  for (Index i = 0; i < 40; ++i)
  {
    const Point3 p = result.Graph.PointAt(i), n = NormalAt(normals, i);
    EXPECT_NEAR(n[0], 2.0 * (p[0] - 3.0), 1e-4);
    EXPECT_NEAR(n[1], 2.0 * (p[1] - 2.0), 1e-4);
    EXPECT_EQ(n[2], 0.0);
  }
}

//----------------------------------------------------------------------------
/// With one family and two planes of another, contours have few node points, or one at each end.
TEST(SurfaceNormals, OfFewNodePoints)
{
  const Stages stages{ Octahedron() };
  const SurfaceNormals normals = NormalsOf(stages, 1.7);
  for (Index i = 0; i < stages.Graph.Count(); ++i)
  {
    const Point3 p = stages.Graph.PointAt(i);
    EXPECT_GT(Dot(p, NormalAt(normals, i)), 0.6 * Length(p)); // outwards
  }
}

//----------------------------------------------------------------------------
TEST(SurfaceNormals, SameForAnyNumberOfThreads)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    const SurfaceNormals one = NormalsOf(stages);
    const SurfaceNormals many = EstimateNormals(stages.Geometry(), CornerAngle, {}, ManyThreads());
    EXPECT_EQ(one.Normals, many.Normals);
    EXPECT_EQ(one.Corners, many.Corners);
  }
}
