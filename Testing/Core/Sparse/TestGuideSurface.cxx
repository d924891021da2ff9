// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/GuideSurface.h"

#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Rectangles on z = 0, 1 and 2, and one across, on x = 0, that goes from z = -0.4 to `top`.
GuideCurves CurvesAcross(const std::string& top)
{
  Contours contours =
    ParseContours("z=0: -1,-1 1,-1 1,1 -1,1; z=1: -1,-1 1,-1 1,1 -1,1; z=2: -1,-1 1,-1 1,1 -1,1; "
                  "x=0: -1,-0.4 1,-0.4 1," +
      top + " -1," + top);
  const SpatialGrid grid = BuildSpatialGrid(contours, 1e-9);
  return CutGuides(contours, grid, 2);
}

/// A square tube from z = 0 to 1 with flat ends, whose corners at both ends are fixed.
SurfaceMesh Tube()
{
  const std::vector<Point3> points{ { -1, -1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 },
    { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } };
  std::vector<std::array<Index, 3>> triangles{ { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 } };
  std::vector<Index> cell{ 0, 0, 2, 2 };
  for (Index i = 0; i < 4; ++i)
  {
    const Index j = (i + 1) % 4;
    triangles.push_back({ i, j, 4 + j });
    triangles.push_back({ i, 4 + j, 4 + i });
    cell.insert(cell.end(), 2, 1);
  }
  SurfaceMesh mesh{ CornerTable(8, triangles), points, std::vector<std::uint8_t>(8, 1),
    std::vector<std::uint8_t>(8, 0), cell,
    { { { -1, -1, -0.5 }, { 1, 1, 0 } }, { { -1, -1, 0 }, { 1, 1, 1 } },
      { { -1, -1, 1 }, { 1, 1, 1.9 } } },
    AxisFrame(), -1, std::vector<Point3>(8, SurfaceMesh::Unstretched) };
  for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
  {
    if (mesh.Cell[corner / 3] != mesh.Cell[mesh.Corners.OppositeOf(corner) / 3])
    {
      mesh.Corners.MarkCurve(corner);
    }
  }
  return mesh;
}
}

//----------------------------------------------------------------------------
TEST(CutGuides, PiecesRunFromPlaneToPlane)
{
  const GuideCurves curves = CurvesAcross("2.3");
  ASSERT_EQ(curves.Slices.size(), 1u);
  EXPECT_EQ(curves.Slices[0].Plane.HeightOf({ 3.0, 5.0, 7.0 }), 3.0);
  const auto& pieces = curves.Slices[0].Pieces;
  ASSERT_EQ(pieces.size(), 6u); // below, above, and two walls in each of two slabs
  std::array<int, 4> inSlab{};
  for (const GuidePiece& piece : pieces)
  {
    ++inSlab[piece.Slab];
    for (const int end : { 0, 1 })
    {
      const Point3& p = end == 0 ? piece.Points.front() : piece.Points.back();
      EXPECT_EQ(p[2], curves.StackPlanes[piece.Planes[end]]);
    }
  }
  EXPECT_EQ(inSlab, (std::array<int, 4>{ 1, 2, 2, 1 }));
}

//----------------------------------------------------------------------------
/// A side in the last slice, but for rounding, is a piece of its own; else there is none.
TEST(CutGuides, ASideInTheLastSliceLiesBeyondIt)
{
  for (const std::string top : { "1.999", "2", "2.001" })
  {
    const auto pieces = CurvesAcross(top).Slices[0].Pieces;
    EXPECT_EQ(std::count_if(pieces.begin(), pieces.end(),
                [](const GuidePiece& piece) { return piece.Slab == 3; }),
      1)
      << top;
  }
  EXPECT_EQ(CurvesAcross("1.9").Slices[0].Pieces.size(), 4u);
}

//----------------------------------------------------------------------------
/// A contour on an inclined plane is cut by the stack and by the slice across before it.
TEST(AddGuides, InclinedContoursAreCut)
{
  GuideCurves curves = CurvesAcross("2.3");
  const double share = std::sqrt(0.5);
  AddGuides({ { { { share, share, 0.0 }, 0.0 },
              { { { 1, -1, -0.4 }, { -1, 1, -0.4 }, { -1, 1, 2.3 }, { 1, -1, 2.3 } } } } },
    curves);
  ASSERT_EQ(curves.Slices.size(), 2u);
  const auto& pieces = curves.Slices[1].Pieces;
  ASSERT_EQ(pieces.size(), 8u); // below and above are two, each, that meet the slice across
  std::array<int, 4> inSlab{};
  for (const GuidePiece& piece : pieces)
  {
    ++inSlab[piece.Slab];
    for (const int end : { 0, 1 })
    {
      const Point3& p = end == 0 ? piece.Points.front() : piece.Points.back();
      const Index plane = piece.Planes[end];
      EXPECT_NEAR(plane < 0 ? p[0] : p[2], plane < 0 ? 0.0 : curves.StackPlanes[plane], 1e-12);
    }
  }
  EXPECT_EQ(inSlab, (std::array<int, 4>{ 2, 2, 2, 2 }));
}

//----------------------------------------------------------------------------
/// Without a stack, contours are cut by the planes of all families, and pieces are within cells.
TEST(AddGuides, FamiliesCutAndNumberCells)
{
  GuideCurves curves;
  curves.Planes = { { { 0.0 }, { 0.0 }, {} } };
  AddGuides({ { { { 0.0, 0.0, 1.0 }, 0.5 },
              { { { -1, -1, 0.5 }, { 1, -1, 0.5 }, { 1, 1, 0.5 }, { -1, 1, 0.5 } } } } },
    curves);
  ASSERT_EQ(curves.Slices.size(), 1u);
  std::array<int, 4> inCell{};
  for (const GuidePiece& piece : curves.Slices[0].Pieces)
  {
    ++inCell.at(piece.Slab);
    EXPECT_EQ(piece.Points.size(), 3u); // around a corner
    EXPECT_EQ(piece.Slab, curves.SlabAt(piece.Points[1]));
  }
  EXPECT_EQ(inCell, (std::array<int, 4>{ 1, 1, 1, 1 }));
}

//----------------------------------------------------------------------------
/// The cut of the end between its two fixed points lies on the guide, corners included, and is
/// fixed.
TEST(GuideSurface, TheCutLiesOnTheGuides)
{
  GuideCurves curves = CurvesAcross("1.5");
  SurfaceMesh mesh = Tube();
  EXPECT_EQ(GuideSurface(curves, 0.5, 0.1, mesh), 4); // both ends and both walls
  EXPECT_EQ(curves.Slices[0].Guiding, 4);
  Index onCut = 0;
  bool low = false, high = false;
  for (Index point = 0; point < mesh.Corners.PointCount(); ++point)
  {
    const Point3& p = mesh.Points[point];
    if (p[0] != 0.0)
    {
      continue;
    }
    ++onCut;
    EXPECT_EQ(mesh.Fixed[point], 1);
    const bool onSide = std::abs(std::abs(p[1]) - 1.0) < 1e-12;
    EXPECT_TRUE(onSide || std::abs(p[2] + 0.4) < 1e-12 || std::abs(p[2] - 1.5) < 1e-12);
    low |= onSide && std::abs(p[2] + 0.4) < 1e-12;
    high |= onSide && std::abs(p[2] - 1.5) < 1e-12;
  }
  EXPECT_GE(onCut, 70); // a length of 7.8 - 1 by 0.1
  EXPECT_TRUE(low && high);
}

//----------------------------------------------------------------------------
TEST(GuideSurface, FarGuidesMoveNothing)
{
  GuideCurves curves = CurvesAcross("1.5");
  for (GuideSlice& slice : curves.Slices)
  {
    for (GuidePiece& piece : slice.Pieces)
    {
      for (Point3& point : piece.Points)
      {
        point[1] += 0.3;
      }
    }
  }
  SurfaceMesh mesh = Tube();
  EXPECT_EQ(GuideSurface(curves, 0.5, 0.1, mesh), 0);
  for (const Point3& point : mesh.Points)
  {
    EXPECT_TRUE(0.0 <= point[2] && point[2] <= 1.0);
  }
}
