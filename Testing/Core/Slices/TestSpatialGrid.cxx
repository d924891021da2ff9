// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/SpatialGrid.h"

#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::vector<double> PlanesAlongZ(const std::vector<double>& coordinates, double tolerance,
  std::vector<Index>* planeOf = nullptr, std::vector<double>* moved = nullptr)
{
  Contours contours;
  for (const double z : coordinates)
  {
    contours.U.insert(contours.U.end(), { 0.0, 1.0, 0.0 });
    contours.V.insert(contours.V.end(), { 0.0, 0.0, 1.0 });
    contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
    contours.Axis.push_back(2);
    contours.Coordinate.push_back(z);
    contours.Cell.push_back(0);
  }
  const SpatialGrid grid = BuildSpatialGrid(contours, tolerance);
  EXPECT_TRUE(grid.Planes[0].empty());
  EXPECT_TRUE(grid.Planes[1].empty());
  if (planeOf)
  {
    *planeOf = contours.Plane;
  }
  if (moved)
  {
    *moved = contours.Coordinate;
  }
  return grid.Planes[2];
}
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, SlicesOfAllAxesAreNumberedThrough)
{
  SpatialGrid grid;
  grid.Planes = { { { 1.0, 2.0, 3.0 }, { 1.0 }, { 1.0, 2.0 } } };
  Index number = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (Index plane = 0; plane < grid.Count(axis); ++plane, ++number)
    {
      EXPECT_EQ(grid.SliceNumber(axis, plane), number);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, CoordinateOnAPlaneLiesAboveIt)
{
  SpatialGrid grid;
  grid.Planes[1] = { 1.0, 2.0, 4.0 };
  EXPECT_EQ(grid.Slab(1, 0.5), 0);
  EXPECT_EQ(grid.Slab(1, 1.0), 1);
  EXPECT_EQ(grid.Slab(1, 1.999), 1);
  EXPECT_EQ(grid.Slab(1, 2.0), 2);
  EXPECT_EQ(grid.Slab(1, 4.0), 3);
  EXPECT_EQ(grid.Slab(1, 99.0), 3);
  EXPECT_EQ(grid.Slab(0, 99.0), 0); // no planes: everything is one slab
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, ClampMovesIntoTheClosedSlab)
{
  SpatialGrid grid;
  grid.Planes[2] = { 1.0, 2.0 };
  EXPECT_EQ(grid.Clamp(2, 0, -5.0), -5.0);
  EXPECT_EQ(grid.Clamp(2, 0, 1.5), 1.0);
  EXPECT_EQ(grid.Clamp(2, 1, 0.0), 1.0);
  EXPECT_EQ(grid.Clamp(2, 1, 1.25), 1.25);
  EXPECT_EQ(grid.Clamp(2, 1, 7.0), 2.0);
  EXPECT_EQ(grid.Clamp(2, 2, 7.0), 7.0);
  EXPECT_EQ(grid.Clamp(2, 2, 1.0), 2.0);
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, MeanSpacing)
{
  SpatialGrid grid;
  grid.Planes[0] = { -1.0, 0.0, 5.0 };
  grid.Planes[1] = { 3.0 };
  EXPECT_EQ(grid.MeanSpacing(0), 3.0);
  EXPECT_EQ(grid.MeanSpacing(1), 0.0);
  EXPECT_EQ(grid.MeanSpacing(2), 0.0);
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, PlanesAscendAndAreDistinct)
{
  std::vector<Index> planeOf;
  EXPECT_EQ(PlanesAlongZ({ 3.0, 1.0, 3.0, -2.0, 1.0 }, 0.0, &planeOf),
    (std::vector<double>{ -2.0, 1.0, 3.0 }));
  EXPECT_EQ(planeOf, (std::vector<Index>{ 2, 1, 2, 0, 1 }));
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, NearPlanesBecomeOneAtTheirMedian)
{
  std::vector<Index> planeOf;
  std::vector<double> moved;
  EXPECT_EQ(PlanesAlongZ({ 0.0, 1.02, 1.0, 1.01, 5.0 }, 0.05, &planeOf, &moved),
    (std::vector<double>{ 0.0, 1.01, 5.0 }));
  EXPECT_EQ(planeOf, (std::vector<Index>{ 0, 1, 1, 1, 2 }));
  EXPECT_EQ(moved, (std::vector<double>{ 0.0, 1.01, 1.01, 1.01, 5.0 }));
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, ChainOfNearPlanesIsNotOnePlane)
{
  // Each is near the one before, but only the first two are near the first.
  EXPECT_EQ(PlanesAlongZ({ 0.0, 0.04, 0.08, 0.12 }, 0.05).size(), 2u);
}

//----------------------------------------------------------------------------
TEST(GridEdgeCode, IsUniqueReversibleAndAscendsAlongEveryLine)
{
  SpatialGrid grid;
  grid.Planes = { std::vector<double>{ 0, 1, 2 }, std::vector<double>{ 0 },
    std::vector<double>{ 0, 1, 2, 3 } };
  const GridEdgeCode code(grid);
  std::set<std::uint64_t> codes;
  std::size_t edges = 0;
  for (int t = 0; t < 3; ++t)
  {
    for (Index i = 0; i < grid.Count(FirstAxis(t)); ++i)
    {
      for (Index j = 0; j < grid.Count(SecondAxis(t)); ++j)
      {
        std::uint64_t before = 0;
        for (Index slab = 0; slab <= grid.Count(t); ++slab, ++edges)
        {
          const std::uint64_t number = code.Encode({ t, i, j, slab });
          const GridEdge edge = code.Decode(number);
          EXPECT_TRUE(slab == 0 || number == before + 1);
          EXPECT_EQ(edge.Direction, t);
          EXPECT_EQ(edge.First, i);
          EXPECT_EQ(edge.Second, j);
          EXPECT_EQ(edge.Slab, slab);
          codes.insert(number);
          before = number;
        }
      }
    }
  }
  EXPECT_EQ(codes.size(), edges);
  EXPECT_EQ(*codes.rbegin(), edges - 1);
}

//----------------------------------------------------------------------------
/// Flags are those of the planes, in their order; without virtual planes there are none.
TEST(SpatialGrid, KnowsItsVirtualPlanes)
{
  Contours contours = ParseContours("z=2: 0,0 1,0 0,1; z=0: 0,0 1,0 0,1; z=1: 0,0 1,0 0,1");
  EXPECT_FALSE(BuildSpatialGrid(contours, 1e-6).HasVirtual());
  contours.Virtual = { 0, 0, 0 };
  EXPECT_FALSE(BuildSpatialGrid(contours, 1e-6).HasVirtual());
  contours.Virtual = { 1, 0, 0 };
  const SpatialGrid grid = BuildSpatialGrid(contours, 1e-6);
  EXPECT_TRUE(grid.HasVirtual());
  EXPECT_FALSE(grid.IsVirtual(2, 0));
  EXPECT_FALSE(grid.IsVirtual(2, 1));
  EXPECT_TRUE(grid.IsVirtual(2, 2));
  EXPECT_FALSE(grid.IsVirtual(0, 0)); // an axis without planes
}

//----------------------------------------------------------------------------
/// A virtual contour that comes too near a real plane has no say in where that lies.
TEST(SpatialGrid, APlaneWithARealContourIsReal)
{
  Contours contours = ParseContours("z=0.99: 0,0 1,0 0,1; z=1: 0,0 1,0 0,1; z=1.01: 0,0 1,0 0,1");
  contours.Virtual = { 1, 0, 1 };
  const SpatialGrid grid = BuildSpatialGrid(contours, 0.1);
  EXPECT_FALSE(grid.HasVirtual());
  EXPECT_EQ(grid.Planes[2], (std::vector<double>{ 1.0 }));
}

//----------------------------------------------------------------------------
namespace
{
/// The grid of squares from -1 to 1 on these planes of x, y and z.
SpatialGrid GridOfSquares(const std::array<std::vector<double>, 3>& planes, bool single = false)
{
  Contours contours;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double plane : planes[axis])
    {
      contours.U.insert(contours.U.end(), { -1.0, 1.0, 1.0, -1.0 });
      contours.V.insert(contours.V.end(), { -1.0, -1.0, 1.0, 1.0 });
      contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
      contours.Axis.push_back(static_cast<std::int8_t>(axis));
      contours.Coordinate.push_back(plane);
      contours.Cell.push_back(0);
    }
  }
  return BuildSpatialGrid(contours, 0.0, single);
}
}

TEST(SpatialGrid, BoundsAreHalfASpacingBeyondTheContours)
{
  const SpatialGrid grid = GridOfSquares({ { { -0.5, 0.0, 0.5 }, { 0.0 }, { -2.0, 0.0, 3.0 } } });
  EXPECT_EQ(
    grid.Lowest, (Point3{ -1.25, -1.25, -3.25 })); // y takes the least spacing of the others
  EXPECT_EQ(grid.Highest, (Point3{ 1.25, 1.25, 4.25 }));
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, BoundsWhereNoAxisHasTwoPlanes)
{
  const SpatialGrid one = GridOfSquares({ { {}, {}, { 5.0 } } });
  EXPECT_EQ(one.Lowest, (Point3{ -1.5, -1.5, 4.5 })); // no extent along z: the greatest one counts
  EXPECT_EQ(one.Highest, (Point3{ 1.5, 1.5, 5.5 }));
  EXPECT_EQ(SpatialGrid().Lowest[0], -HUGE_VAL); // and there are none without contours
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, OutermostSlabsEndAtTheBounds)
{
  const SpatialGrid grid = GridOfSquares({ { {}, {}, { -1.0, 1.0 } } });
  ASSERT_EQ(grid.Highest[2], 2.0);
  EXPECT_EQ(grid.MoveInside(2, 2, 7.0), 2.0);
  EXPECT_EQ(grid.MoveInside(2, 0, -7.0), -2.0);
  EXPECT_EQ(grid.MoveInside(2, 0, -1.5), -1.5);
  EXPECT_EQ(grid.MoveIntoBounds(2, 7.0), 2.0);
  double low = -3.0, high = 1.5;
  grid.ClipToBounds(2, low, high);
  EXPECT_EQ(low, -2.0);
  EXPECT_EQ(high, 1.5);
  EXPECT_TRUE(grid.IsWithinBounds({ 0.0, 0.0, 2.0 }));
  EXPECT_FALSE(grid.IsWithinBounds({ 0.0, 0.0, 2.001 }));
}

//----------------------------------------------------------------------------
TEST(SpatialGrid, BoundsInSinglePrecisionAreFloatsWithinTheExactOnes)
{
  const SpatialGrid exact = GridOfSquares({ { { 0.1, 0.2 }, { 0.1, 0.4 }, { 0.3, 1e5 } } });
  const SpatialGrid single = GridOfSquares({ { { 0.1, 0.2 }, { 0.1, 0.4 }, { 0.3, 1e5 } } }, true);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(single.Lowest[axis], static_cast<float>(single.Lowest[axis]));
    EXPECT_EQ(single.Highest[axis], static_cast<float>(single.Highest[axis]));
    EXPECT_NEAR(single.Lowest[axis], exact.Lowest[axis], 2.0 * single.Step[axis]);
    EXPECT_NEAR(single.Highest[axis], exact.Highest[axis], 2.0 * single.Step[axis]);
    const double beyond = 0.5 * single.SpacingAtEnds[axis];
    EXPECT_GE(single.Lowest[axis], std::min(-1.0, single.Planes[axis].front()) - beyond);
    EXPECT_LE(single.Highest[axis], std::max(1.0, single.Planes[axis].back()) + beyond);
  }
}
