// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/EmptyPlanes.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
/// A square of side 2 around (u, v) on the slice across an axis at w.
void AddSquare(int axis, double u, double v, double w, Contours& contours)
{
  for (const Point2& p : { Point2{ u - 1, v - 1 }, Point2{ u + 1, v - 1 }, Point2{ u + 1, v + 1 },
         Point2{ u - 1, v + 1 } })
  {
    contours.U.push_back(p[0]);
    contours.V.push_back(p[1]);
  }
  contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
  contours.Axis.push_back(static_cast<std::int8_t>(axis));
  contours.Coordinate.push_back(w);
  contours.Cell.push_back(contours.Count());
}

/// Two cubes of side 2 at z = 0 and z = 10, with slices across x and z.
Contours TwoCubes()
{
  Contours contours;
  for (const double z : { 0.0, 10.0 })
  {
    AddSquare(2, 0.0, 0.0, z - 0.5, contours);
    AddSquare(2, 0.0, 0.0, z + 0.5, contours);
    AddSquare(0, 0.0, z, 0.0, contours);
  }
  return contours;
}

const std::array<std::vector<double>, 3> Planes{ std::vector<double>{ -5.0, -4.0, 0.0, 4.0 },
  std::vector<double>{}, std::vector<double>{ 0.25, 3.0, 7.0, 12.0, 13.0 } };
}

/// Between the cubes and next to them, but not where a contour passes.
TEST(EmptyPlanes, ThoseThroughWhichNothingPasses)
{
  Contours contours = TwoCubes();
  SpatialGrid grid = BuildSpatialGrid(contours, 1e-6);
  AddEmptyPlanes(Planes, EmptyPlanes::NotPassed, contours, grid);
  EXPECT_EQ(grid.Planes[0], (std::vector<double>{ -4.0, 0.0, 4.0 }));
  EXPECT_EQ(grid.Planes[2], (std::vector<double>{ -0.5, 0.5, 3.0, 7.0, 9.5, 10.5, 12.0 }));
  EXPECT_FALSE(grid.HasVirtual());
  for (Index i = 0; i < contours.Count(); ++i)
  {
    EXPECT_EQ(grid.Planes[contours.Axis[i]][contours.Plane[i]], contours.Coordinate[i]);
  }
}

/// Where slices agree, also those on which contours end.
TEST(EmptyPlanes, AllWhereSlicesAgree)
{
  Contours contours = TwoCubes();
  SpatialGrid grid = BuildSpatialGrid(contours, 1e-6);
  AddEmptyPlanes(Planes, EmptyPlanes::All, contours, grid);
  EXPECT_EQ(grid.Planes[2], (std::vector<double>{ -0.5, 0.25, 0.5, 3.0, 7.0, 9.5, 10.5, 12.0 }));
  EXPECT_FALSE(grid.HasVirtual());
}

/// Of one family, nobody knows what passes between its planes.
TEST(EmptyPlanes, NoneBetweenSlicesOfOneFamily)
{
  Contours contours;
  AddSquare(2, 0.0, 0.0, 0.0, contours);
  AddSquare(2, 0.0, 0.0, 10.0, contours);
  SpatialGrid grid = BuildSpatialGrid(contours, 1e-6);
  AddEmptyPlanes(Planes, EmptyPlanes::NotPassed, contours, grid);
  EXPECT_EQ(grid.Planes[2], (std::vector<double>{ 0.0, 10.0, 12.0 }));
}

/// Virtual slices are empty wherever they are.
TEST(EmptyPlanes, AllAreVirtualAmongVirtualOnes)
{
  Contours contours = TwoCubes();
  contours.Virtual.assign(contours.Count(), 0);
  contours.Virtual.back() = 1;
  contours.Coordinate.back() = 0.5;
  SpatialGrid grid = BuildSpatialGrid(contours, 1e-6);
  AddEmptyPlanes(Planes, EmptyPlanes::NotPassed, contours, grid);
  EXPECT_EQ(grid.Planes[2], (std::vector<double>{ -0.5, 0.25, 0.5, 3.0, 7.0, 9.5, 10.5, 12.0 }));
  EXPECT_TRUE(grid.IsVirtual(2, 1));
  EXPECT_FALSE(grid.IsVirtual(2, 2));
}
