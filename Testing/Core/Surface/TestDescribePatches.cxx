// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/DescribePatches.h"

#include "Core/Reconstruct.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Three squares around the origin; the z-slice reaches `more` farther along +y than the x-slice,
/// at one of the six node points.
Reconstruction ThreeSquares(double more)
{
  const std::string high = std::to_string(1.0 + more);
  return Reconstruct(ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                                 "z=0: -1,-1 1,-1 1," +
                       high + " -1," + high),
    Options(), Execution());
}

/// Two slices of one square each: discs at both ends and a tube between them.
Reconstruction Box()
{
  return Reconstruct(
    ParsePieces("z=0: 0,0 2,0 2,2 0,2; z=1: 0,0 2,0 2,2 0,2"), Options(), Execution());
}
}

//----------------------------------------------------------------------------
TEST(DescribePatches, NodesThatDisagreeMarkTheirPolygons)
{
  const Reconstruction result = ThreeSquares(0.5);
  const CycleGeometry geometry = GeometryOf(result);
  ASSERT_EQ(geometry.Cycles.Count(), 8);
  for (const double tolerance : { 0.49, 0.51 })
  {
    const auto repairs = FindPatchRepairs(geometry, result.Surface.Meshes, tolerance);
    for (Index cycle = 0; cycle < 8; ++cycle)
    {
      // The node point lies between the cells beyond y = 0.
      const bool beyond = geometry.Cycles.Cell[cycle][1] == 1;
      EXPECT_EQ(repairs[cycle], tolerance < 0.5 && beyond ? NodesDisagree : 0);
    }
  }
}

//----------------------------------------------------------------------------
TEST(DescribePatches, ArcsThatWereChangedMarkTheirPolygons)
{
  Reconstruction result = ThreeSquares(0.0);
  result.Graph.Redrawn.assign(result.Graph.Arcs, 0);
  result.Graph.Redrawn[0] = 1;
  const CycleGeometry geometry = GeometryOf(result);
  const auto repairs = FindPatchRepairs(geometry, result.Surface.Meshes, 0.1);
  EXPECT_EQ(std::count(repairs.begin(), repairs.end(), ArcsChanged), 2) << "an arc has two cells";
  EXPECT_EQ(std::count(repairs.begin(), repairs.end(), 0), 6);
}

//----------------------------------------------------------------------------
TEST(DescribePatches, PatchesOfSeveralCyclesCountAtTheFirst)
{
  const Reconstruction cube = ThreeSquares(0.0);
  EXPECT_EQ(CountNodePoints(GeometryOf(cube), cube.Surface.Meshes), std::vector<Index>(8, 3));
  const Reconstruction box = Box();
  EXPECT_EQ(CountNodePoints(GeometryOf(box), box.Surface.Meshes), std::vector<Index>(4, 0));

  // As if the first and the last polygon were the ends of a tube, the arcs of which were changed.
  Reconstruction joined = ThreeSquares(0.0);
  PatchMesh tube;
  tube.Cycles = { 0, 7 };
  joined.Graph.Redrawn.assign(joined.Graph.Arcs, 1);
  const CycleGeometry geometry = GeometryOf(joined);
  EXPECT_EQ(CountNodePoints(geometry, { tube })[0], 6);
  EXPECT_EQ(FindPatchRepairs(geometry, { tube }, 0.1)[0] & ArcsChanged, ArcsChanged);
}

//----------------------------------------------------------------------------
TEST(DescribePatches, SmoothNormalsStandAtThePointsOfTheSurface)
{
  const Reconstruction result = ThreeSquares(0.0);
  const Index graphPoints = result.Graph.Count();
  const std::int64_t points = std::int64_t(graphPoints) + result.Cycles.Count() +
    static_cast<std::int64_t>(ListOtherPoints(result.Surface).size() / 3);
  const auto normals = ListSmoothNormals(result.Normals, result.Surface, graphPoints, points);
  ASSERT_EQ(normals.size(), 3u * points);
  for (Index i = 0; i < graphPoints; ++i)
  {
    const bool corner = !result.Normals.Corners.empty() && result.Normals.Corners[i] != 0;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(normals[3 * i + k], corner ? 0.0f : result.Normals.Normals[3 * i + k]);
    }
  }
  const InnerPatches& inner = result.Surface.Inner;
  ASSERT_GT(inner.Count(), 0);
  for (Index i = 0; i < inner.Count(); ++i)
  {
    const std::int64_t id = std::int64_t(graphPoints) + inner.Cycle[i];
    EXPECT_EQ(normals[3 * id], inner.Normals[3 * inner.PointOffsets[i]]);
  }
  // Of contours without any corner nothing is said of corners.
  SurfaceNormals smooth = result.Normals;
  smooth.Corners.clear();
  const auto all = ListSmoothNormals(smooth, result.Surface, graphPoints, points);
  ASSERT_EQ(all.size(), 3u * points);
  EXPECT_TRUE(std::equal(smooth.Normals.begin(), smooth.Normals.end(), all.begin()));
  EXPECT_TRUE(ListSmoothNormals(SurfaceNormals(), result.Surface, graphPoints, points).empty());
}
