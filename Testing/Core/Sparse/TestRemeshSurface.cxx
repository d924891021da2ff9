// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RemeshSurface.h"

#include "Core/Base/TriangleDistance.h"
#include "Support/CheckSurface.h"
#include "Support/ClosedMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr Index Segments = 60;
const std::vector<double> Heights{ -0.8, -0.3, 0.2, 0.8 };

/// A ball of radius 1 between contours of many vertices.
SurfaceMesh BallOfRings()
{
  std::vector<double> radii;
  for (const double z : Heights)
  {
    radii.push_back(std::sqrt(1.0 - z * z));
  }
  return RingSurface(RingMesh(Segments, radii, Heights, -1, 1), Segments, Heights, 1.2);
}

SurfaceCheck Check(const SurfaceMesh& mesh)
{
  return CheckSurface(CopyUsed(mesh.Corners, mesh.Points));
}

void ExpectComplete(const SurfaceMesh& mesh)
{
  const std::size_t points = mesh.Points.size();
  EXPECT_EQ(points, static_cast<std::size_t>(mesh.Corners.PointCount()));
  EXPECT_EQ(mesh.Fixed.size(), points);
  EXPECT_EQ(mesh.Crease.size(), points);
  EXPECT_EQ(mesh.Stretch.size(), points);
  EXPECT_EQ(mesh.Cell.size(), static_cast<std::size_t>(mesh.Corners.CornerCount() / 3));
}

template <typename Visit>
void ForEdges(const SurfaceMesh& mesh, Visit&& visit)
{
  for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
  {
    if (mesh.Corners.IsAlive(corner) && corner < mesh.Corners.OppositeOf(corner))
    {
      const Index a = mesh.Corners.StartOf(corner), b = mesh.Corners.EndOf(corner);
      visit(corner, a, b, Length(mesh.Edge(a, b)));
    }
  }
}

/// The greatest distance of the points of `before` on contours from the contours of `after`.
double ContourDeviation(const SurfaceMesh& before, const SurfaceMesh& after)
{
  double greatest = 0.0;
  for (std::size_t i = 0; i < before.Points.size(); ++i)
  {
    if (!before.Fixed[i])
    {
      continue;
    }
    double least = HUGE_VAL;
    ForEdges(after,
      [&](Index corner, Index a, Index b, double)
      {
        if (after.Corners.IsCurve(corner))
        {
          least = std::min(
            least, SquaredDistanceToSegment(before.Points[i], after.Points[a], after.Points[b]));
        }
      });
    greatest = std::max(greatest, std::sqrt(least));
  }
  return greatest;
}

/// Points on contours stay in their slices, and curves join fixed points of one slice.
void ExpectContoursInSlices(const SurfaceMesh& mesh)
{
  std::vector<Index> curves(Heights.size(), 0);
  ForEdges(mesh,
    [&](Index corner, Index a, Index b, double)
    {
      if (mesh.Corners.IsCurve(corner))
      {
        EXPECT_TRUE(mesh.Fixed[a] && mesh.Fixed[b]);
        EXPECT_EQ(mesh.Points[a][2], mesh.Points[b][2]);
        const auto slice = std::find(Heights.begin(), Heights.end(), mesh.Points[a][2]);
        ASSERT_NE(slice, Heights.end());
        ++curves[slice - Heights.begin()];
      }
    });
  for (const Index count : curves)
  {
    EXPECT_GE(count, 3);
  }
}

/// Every triangle lies in its cell: none has been mixed up.
void ExpectTrianglesInCells(const SurfaceMesh& mesh)
{
  for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
  {
    if (mesh.Corners.IsAlive(corner))
    {
      const Box3& cell = mesh.Cells[mesh.Cell[corner / 3]];
      const double z = mesh.Points[mesh.Corners.VertexOf(corner)][2];
      EXPECT_GE(z, cell.Low[2]);
      EXPECT_LE(z, cell.High[2]);
    }
  }
}
}

//----------------------------------------------------------------------------
TEST(RemeshSurface, EdgesAreAboutAsLongAsAskedFor)
{
  constexpr double length = 0.25;
  const SurfaceMesh before = BallOfRings();
  SurfaceMesh mesh = before;
  CollapseShortEdges(length, mesh);
  FlipEdges(mesh);
  RefineEdges(length, mesh);
  SplitLongEdges(length, mesh);
  CollapseShortEdges(length, mesh);
  ExpectComplete(mesh);
  std::size_t edges = 0, shorter = 0;
  ForEdges(mesh,
    [&](Index, Index, Index, double edge)
    {
      EXPECT_LE(edge, 4.0 / 3.0 * length);
      ++edges;
      shorter += edge < 0.5 * length ? 1 : 0;
    });
  EXPECT_GT(edges, 300u);
  EXPECT_LT(shorter, edges / 10); // where contours and surface have no room for longer ones
  const SurfaceCheck check = Check(mesh);
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Euler, 2);
  ExpectContoursInSlices(mesh);
  ExpectTrianglesInCells(mesh);
}

//----------------------------------------------------------------------------
/// A contour loses vertices, but not its course: twice a tenth of the shortest edges, in two steps.
TEST(RemeshSurface, ContoursKeepTheirCourse)
{
  for (const double length : { 0.1, 0.25, 0.5, 2.0 })
  {
    SCOPED_TRACE(length);
    const SurfaceMesh before = BallOfRings();
    SurfaceMesh mesh = before;
    CollapseShortEdges(length, mesh);
    EXPECT_LE(ContourDeviation(before, mesh), 2.0 * 0.1 * 0.8 * length);
    ExpectContoursInSlices(mesh);
    ExpectTrianglesInCells(mesh);
    const SurfaceCheck check = Check(mesh);
    EXPECT_TRUE(check.IsClosedManifold()) << check;
    EXPECT_EQ(check.Euler, 2);
    ExpectComplete(mesh);
  }
}

//----------------------------------------------------------------------------
/// However long an edge is, none of its parts stays too long.
TEST(RemeshSurface, EveryLongEdgeIsSplit)
{
  for (const double length : { 1.0, 0.3, 0.1, 0.03 })
  {
    SurfaceMesh mesh = FreeSurface(OctahedronMesh(), 2.0);
    SplitLongEdges(length, mesh);
    ForEdges(mesh, [&](Index, Index, Index, double edge) { EXPECT_LE(edge, 4.0 / 3.0 * length); });
    ExpectComplete(mesh);
    const SurfaceCheck check = Check(mesh);
    EXPECT_TRUE(check.IsClosedManifold()) << check;
    EXPECT_NEAR(check.TotalVolume(), 4.0 / 3.0, 1e-12); // no point has left the octahedron
  }
}

//----------------------------------------------------------------------------
/// What is stretched is divided as if it were wider.
TEST(RemeshSurface, StretchedSurfacesHaveMoreTriangles)
{
  SurfaceMesh plain = BallOfRings();
  SurfaceMesh stretched = plain;
  stretched.StretchAxis = 2;
  std::fill(stretched.Stretch.begin(), stretched.Stretch.end(), Point3{ 3.0, 3.0, 1.0 });
  for (SurfaceMesh* mesh : { &plain, &stretched })
  {
    CollapseShortEdges(0.25, *mesh);
    RefineEdges(0.25, *mesh);
  }
  EXPECT_GT(stretched.Corners.ListTriangles().size(), 2 * plain.Corners.ListTriangles().size());
  ForEdges(
    stretched, [](Index, Index, Index, double edge) { EXPECT_LE(edge, 4.0 / 3.0 * 0.25 * 1.01); });
}

//----------------------------------------------------------------------------
/// Beside a point that is stretched 16 times, what is not stretched stays nearly so: the mean of
/// the thicknesses is 8.5 times the thinner one.
TEST(RemeshSurface, LittleIsStretchedBesideThinThings)
{
  SurfaceMesh mesh = BallOfRings();
  const Index corner = 0;
  mesh.Stretch[mesh.Corners.StartOf(corner)] = { 16.0, 16.0, 1.0 };
  SplitEdge(corner, 0.5, mesh);
  EXPECT_NEAR(mesh.Stretch.back()[0], 16.0 / 8.5, 1e-12);
  EXPECT_EQ(mesh.Stretch.back()[2], 1.0);
}

//----------------------------------------------------------------------------
/// Of a convex quadrilateral the shorter diagonal, and curves stay.
TEST(RemeshSurface, FlipsMakeADelaunayTriangulation)
{
  const SurfaceMesh before = BallOfRings();
  SurfaceMesh mesh = before;
  FlipEdges(mesh);
  const auto angle = [&](Index apex, Index a, Index b)
  {
    const Point3 u = mesh.Points[a] - mesh.Points[apex], v = mesh.Points[b] - mesh.Points[apex];
    return std::atan2(Length(Cross(u, v)), Dot(u, v));
  };
  ForEdges(mesh,
    [&](Index corner, Index a, Index b, double)
    {
      const Index c = mesh.Corners.VertexOf(corner);
      const Index d = mesh.Corners.VertexOf(mesh.Corners.OppositeOf(corner));
      EXPECT_TRUE(
        !mesh.Corners.CanFlip(corner) || angle(c, a, b) + angle(d, a, b) <= std::acos(-1.0) + 1e-6);
    });
  EXPECT_EQ(ContourDeviation(before, mesh), 0.0);
  EXPECT_TRUE(Check(mesh).IsClosedManifold());
}
