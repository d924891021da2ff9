// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the tests' own tools: checkers have to find what is wrong, fixtures to be what they say
 */

#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/Perturbations.h"
#include "Support/SelfIntersections.h"
#include "Support/SharpestFold.h"
#include "Support/SliceSolid.h"
#include "Support/Vtk/CountTopology.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
TriangleMesh Tetrahedron()
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  mesh.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  return mesh;
}

/// Two tetrahedra; point i of the second is replaced by shared[i] if that is not -1.
TriangleMesh TwoTetrahedra(const std::array<std::int64_t, 4>& shared)
{
  TriangleMesh mesh = Tetrahedron();
  for (const auto& t : Tetrahedron().Triangles)
  {
    std::array<std::int64_t, 3> ids;
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = shared[t[i]] >= 0 ? shared[t[i]] : t[i] + 4;
    }
    mesh.Triangles.push_back(ids);
  }
  for (const Point3& p : Tetrahedron().Points)
  {
    mesh.Points.push_back({ p[0] + 5, p[1], p[2] });
  }
  return mesh;
}
}

//----------------------------------------------------------------------------
TEST(CheckSurface, AcceptsATetrahedron)
{
  const SurfaceCheck check = CheckSurface(Tetrahedron());
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, 1);
  EXPECT_EQ(check.Euler, 2);
  EXPECT_EQ(check.Genus, (std::vector<std::int64_t>{ 0 }));
  EXPECT_DOUBLE_EQ(check.Volume[0], 1.0 / 6.0);
}

//----------------------------------------------------------------------------
TEST(CheckSurface, FindsEveryKindOfFlaw)
{
  TriangleMesh open = Tetrahedron();
  open.Triangles.pop_back();
  EXPECT_EQ(CheckSurface(open).OpenEdges, 3);

  TriangleMesh flipped = Tetrahedron();
  std::swap(flipped.Triangles[0][1], flipped.Triangles[0][2]);
  EXPECT_EQ(CheckSurface(flipped).InconsistentEdges, 3);

  TriangleMesh doubled = Tetrahedron();
  doubled.Triangles.push_back(doubled.Triangles[0]);
  EXPECT_EQ(CheckSurface(doubled).CrowdedEdges, 3);

  TriangleMesh degenerate = Tetrahedron();
  degenerate.Triangles.push_back({ 0, 0, 1 });
  EXPECT_EQ(CheckSurface(degenerate).DegenerateTriangles, 1);
  degenerate.Triangles.back() = { 0, 1, 4 };
  EXPECT_EQ(CheckSurface(degenerate).DegenerateTriangles, 1);

  EXPECT_EQ(CheckSurface(TwoTetrahedra({ 1, -1, -1, -1 })).NonManifoldVertices, 1);
  EXPECT_EQ(CheckSurface(TwoTetrahedra({ 1, 2, -1, -1 })).CrowdedEdges, 1);
  EXPECT_EQ(CheckSurface(TwoTetrahedra({ 1, -1, -1, -1 })).UnusedPoints, 1);

  TriangleMesh inside = Tetrahedron();
  for (auto& t : inside.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  EXPECT_TRUE(CheckSurface(inside).IsClosedManifold());
  EXPECT_LT(CheckSurface(inside).TotalVolume(), 0.0);
}

//----------------------------------------------------------------------------
TEST(CheckSurface, CountsComponents)
{
  const SurfaceCheck check = CheckSurface(TwoTetrahedra({ -1, -1, -1, -1 }));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, 2);
  EXPECT_EQ(check.Euler, 4);
  EXPECT_EQ(check.Component.front(), 0);
  EXPECT_EQ(check.Component.back(), 1);
}

//----------------------------------------------------------------------------
TEST(CheckSurface, WindingNumberIsOneInsideOnly)
{
  EXPECT_NEAR(WindingNumber(Tetrahedron(), { 0.1, 0.1, 0.1 }), 1.0, 1e-12);
  EXPECT_NEAR(WindingNumber(Tetrahedron(), { 1.0, 1.0, 1.0 }), 0.0, 1e-12);
  EXPECT_NEAR(WindingNumber(Tetrahedron(), { -0.1, 0.1, 0.1 }), 0.0, 1e-12);
}

//----------------------------------------------------------------------------
TEST(CountCrossings, CountsPairsThatCross)
{
  TriangleMesh mesh = TwoTetrahedra({ -1, -1, -1, -1 });
  EXPECT_EQ(CountCrossings(mesh), 0);
  for (std::size_t i = 4; i < 8; ++i)
  {
    mesh.Points[i][0] -= 4.75;
    mesh.Points[i][1] += 0.1;
    mesh.Points[i][2] += 0.125;
  }
  EXPECT_GT(CountCrossings(mesh), 0);
  const std::int64_t cgal = CountSelfIntersections(mesh);
  EXPECT_TRUE(cgal < 0 || cgal == CountCrossings(mesh));
  mesh.Triangles.resize(4);
  EXPECT_EQ(CountCrossings(mesh), 0);
}

//----------------------------------------------------------------------------
TEST(CountCrossings, FindsAFanThatFoldsIntoItself)
{
  // Two triangles with a common corner; a side of one passes through the other.
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0.5, 0.5, -1 }, { 0.5, 0.5, 1 } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 3, 4 } };
  EXPECT_EQ(CountCrossings(mesh), 1);
  mesh.Points[3] = { 0.5, 0.5, 0.5 };
  EXPECT_EQ(CountCrossings(mesh), 0);
}

//----------------------------------------------------------------------------
TEST(TextContours, TextAndPiecesAreTheSame)
{
  const std::string text = "x=0.5: 0,0 1,0 1,1\ny=-2 open: 3,4 5,6.25\nz=1: 0,0,1.5 1,0 1,1\n";
  const PieceSets sets = ParsePieces(text);
  EXPECT_EQ(ToText(sets),
    "x=0.5: 0,0 1,0 1,1\ny=-2 open: 3,4 5,6.25\n"
    "z=1.5: 0,0 1,0,1 1,1,1\n");
  EXPECT_EQ(sets[0].U, (std::vector<double>{ 0, 1, 1 }));
  EXPECT_EQ(sets[1].Closed, (std::vector<std::uint8_t>{ 0 }));
  EXPECT_EQ(sets[1].V, (std::vector<double>{ 4, 6.25 }));
  EXPECT_EQ(sets[2].W, (std::vector<double>{ 1.5, 1, 1 }));
}

//----------------------------------------------------------------------------
TEST(SliceSolid, VerticesLieOnTheSurfaceAndOnTheirPlanes)
{
  for (const Solid& solid : AllAnalyticSolids())
  {
    for (const InPlaneGrid grid : { InPlaneGrid::Aligned, InPlaneGrid::Free })
    {
      SCOPED_TRACE(solid.Name);
      const PieceSets sets = SliceSolid(solid, EqualPlanes(solid, { 5, 6, 7 }), 2, grid);
      std::size_t vertices = 0;
      for (const Pieces& pieces : sets)
      {
        for (std::size_t i = 0; i < pieces.U.size(); ++i, ++vertices)
        {
          Point3 p;
          p[pieces.Axis] = pieces.W[i];
          p[FirstAxis(pieces.Axis)] = pieces.U[i];
          p[SecondAxis(pieces.Axis)] = pieces.V[i];
          EXPECT_LT(std::abs(solid.Value(p)), 1e-12);
        }
      }
      EXPECT_GT(vertices, 50u);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SliceSolid, CircleHasItsAreaAndRunsCounterClockwise)
{
  Solid ball;
  ball.Low = { -1.3, -1.3, -1.3 };
  ball.High = { 1.3, 1.3, 1.3 };
  ball.Tubes = { Ball({ 0, 0, 0 }, 1.0) };
  PlaneSets planes;
  planes = { std::vector<double>{ 0.1 }, std::vector<double>{ 0.2 }, std::vector<double>{ 0.6 } };
  const PieceSets sets = SliceSolid(ball, planes, 100, InPlaneGrid::Free);
  ASSERT_EQ(sets[2].Count(), 1);
  double area = 0.0;
  const std::size_t n = sets[2].U.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t j = (i + 1) % n;
    area += 0.5 * (sets[2].U[i] * sets[2].V[j] - sets[2].U[j] * sets[2].V[i]);
  }
  EXPECT_NEAR(area, 3.14159265 * 0.64, 1e-3);
}

//----------------------------------------------------------------------------
TEST(AnalyticSolids, HaveTheTopologyTheySay)
{
  for (const Solid& solid : AllAnalyticSolids())
  {
    SCOPED_TRACE(solid.Name);
    const auto topology = CountTopology(solid, 0.03);
    ASSERT_TRUE(topology.has_value());
    EXPECT_EQ(topology->Components, solid.Components);
    EXPECT_EQ(topology->Genus, solid.Genus);
  }
}

//----------------------------------------------------------------------------
TEST(AnalyticSolids, GradientIsTheDerivativeOfTheValue)
{
  for (const Solid& solid : AllAnalyticSolids())
  {
    SCOPED_TRACE(solid.Name);
    const Point3 p{ 0.31, -0.23, 0.17 };
    const Point3 gradient = solid.Gradient(p);
    for (int axis = 0; axis < 3; ++axis)
    {
      Point3 low = p, high = p;
      low[axis] -= 1e-6;
      high[axis] += 1e-6;
      EXPECT_NEAR((solid.Value(high) - solid.Value(low)) / 2e-6, gradient[axis], 1e-5);
    }
  }
}

//----------------------------------------------------------------------------
TEST(Perturbations, ThreeQuarterTurnsOfTheAxesAreNone)
{
  const std::string text = "x=1: 0,0 1,0 1,2\ny=3: 0,0 1,0 1,4\nz=5: 0,0 1,0 1,6\n";
  PieceSets sets = ParsePieces(text);
  PermuteAxes(sets);
  EXPECT_EQ(ToText(sets), "x=5: 0,0 1,0 1,6\ny=1: 0,0 1,0 1,2\nz=3: 0,0 1,0 1,4\n");
  PermuteAxes(sets);
  PermuteAxes(sets);
  EXPECT_EQ(ToText(sets), text);
  ExchangeXAndY(sets);
  EXPECT_EQ(ToText(sets), "x=3: 0,0 0,1 4,1\ny=1: 0,0 0,1 2,1\nz=5: 0,0 0,1 6,1\n");
}

//----------------------------------------------------------------------------
TEST(Perturbations, RoundedToFloatAllCoordinatesAreFloats)
{
  PieceSets sets =
    ParsePieces("x=0.1: 0.2,0.3 1,0.7 1,2.1\ny=0.3: 0.1,0 1,0.7 1,4; z=5: 0,0 1,0 1,6");
  RoundToFloat(sets);
  EXPECT_EQ(sets[0].W, std::vector<double>(3, 0.1f));
  EXPECT_EQ(sets[0].U, (std::vector<double>{ 0.2f, 1.0, 1.0 }));
  EXPECT_EQ(sets[0].V, (std::vector<double>{ 0.3f, 0.7f, 2.1f }));
  EXPECT_EQ(sets[1].W, std::vector<double>(3, 0.3f));
  EXPECT_EQ(sets[1].U, (std::vector<double>{ 0.1f, 1.0, 1.0 }));
  EXPECT_EQ(sets[2].V, (std::vector<double>{ 0.0, 0.0, 6.0 }));
}

//----------------------------------------------------------------------------
TEST(SharpestFold, IsTheLeastAngleAtASide)
{
  TriangleMesh mesh = Tetrahedron();
  EXPECT_NEAR(SharpestFold(mesh), 54.7356, 1e-3); // of the slanted triangle and the others
  mesh.Points[3] = { 0.25, 0.25, 1e-9 };
  EXPECT_LT(SharpestFold(mesh), 1e-6);
  mesh.Points[3] = { 0, 0, std::tan(3.14159265358979323846 / 36.0) / std::sqrt(2.0) };
  EXPECT_NEAR(SharpestFold(mesh), 5.0, 1e-9); // half a side's diagonal away
}
