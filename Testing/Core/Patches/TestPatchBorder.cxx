// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/PatchBorder.h"

#include "Core/Base/Vectors.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Normals that say which point they are of: not of unit length.
SurfaceNormals NumberedNormals(const Stages& stages)
{
  SurfaceNormals normals;
  for (Index i = 0; i < stages.Graph.Count(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      normals.Normals.push_back(static_cast<float>(3 * i + axis));
    }
  }
  return normals;
}

Index CycleIn(const Stages& stages, const std::array<Index, 3>& cell)
{
  const auto at = std::find(stages.Cycles.Cell.begin(), stages.Cycles.Cell.end(), cell);
  return static_cast<Index>(at - stages.Cycles.Cell.begin());
}

PatchBorder BorderIn(const Stages& stages, const std::array<Index, 3>& cell)
{
  PatchBorder border;
  border.Set(stages.Geometry(), NumberedNormals(stages), CycleIn(stages, cell));
  return border;
}

void ExpectNear(const Point3& a, const Point3& b, double tolerance)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(a[axis], b[axis], tolerance);
  }
}
}

//----------------------------------------------------------------------------
/// The square of the cube's lower x-face in the middle cell there.
TEST(PatchBorder, OfASquare)
{
  const Stages stages{ Cube() };
  const PatchBorder border = BorderIn(stages, { 0, 1, 1 });
  ASSERT_EQ(border.Count(), 4);
  EXPECT_EQ(border.NodePlaces, (std::vector<Index>{ 0, 1, 2, 3 }));
  ExpectNear(border.Center, { 0.5, 1.5, 1.5 }, 1e-15);
  for (Index i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(border.Weights[i], 0.25, 1e-15);
    EXPECT_EQ(border.Places[i], stages.Graph.PointAt(border.Points[i]));
    const double first = 3.0 * border.Points[i];
    EXPECT_EQ(border.Normals[i], (Point3{ first, first + 1.0, first + 2.0 }));
  }
}

//----------------------------------------------------------------------------
/// At a corner of the cube: six sides of length 1/2.
TEST(PatchBorder, CenterAndWeightsAreThoseOfTheLength)
{
  const Stages stages{ Cube(3) };
  const PatchBorder border = BorderIn(stages, { 0, 0, 0 });
  EXPECT_NEAR(std::accumulate(border.Weights.begin(), border.Weights.end(), 0.0), 1.0, 1e-14);
  ExpectNear(border.Center, { 0.75, 0.75, 0.75 }, 1e-6);
}

//----------------------------------------------------------------------------
TEST(PatchBorder, TurnedStartsAtItsLeastPlace)
{
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    const Stages stages(RandomConsistentInput(seed));
    for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
    {
      PatchBorder border;
      border.Set(stages.Geometry(), NumberedNormals(stages), cycle);
      const PatchBorder before = border;
      const Index first = border.Turn(), n = border.Count();
      ASSERT_EQ(border.Places[0], *std::min_element(before.Places.begin(), before.Places.end()));
      for (Index i = 0; i < n; ++i)
      {
        ASSERT_EQ(border.Points[i], before.Points[(i + first) % n]);
        ASSERT_EQ(border.Places[i], before.Places[(i + first) % n]);
        ASSERT_EQ(border.Normals[i], before.Normals[(i + first) % n]);
        ASSERT_NEAR(border.Weights[i], before.Weights[(i + first) % n], 1e-12);
      }
      ASSERT_TRUE(std::is_sorted(border.NodePlaces.begin(), border.NodePlaces.end()));
      std::vector<Index> nodes, nodesBefore;
      for (std::size_t i = 0; i < border.NodePlaces.size(); ++i)
      {
        nodes.push_back(border.Points[border.NodePlaces[i]]);
        nodesBefore.push_back(before.Points[before.NodePlaces[i]]);
      }
      EXPECT_TRUE(std::is_permutation(nodes.begin(), nodes.end(), nodesBefore.begin()));
      ExpectNear(border.Center, before.Center, 1e-12);
    }
  }
}

//----------------------------------------------------------------------------
/// In the cell at a corner of the cube, the borders' points lie on the planes 1 of the three axes.
TEST(PatchBorder, FindsPointsOnOneFace)
{
  const Stages stages{ Cube(3) };
  const PatchBorder border = BorderIn(stages, { 0, 0, 0 });
  Index pairs = 0;
  for (Index i = 0; i < border.Count(); ++i)
  {
    for (Index j = 0; j < border.Count(); ++j)
    {
      bool expected = false;
      for (int axis = 0; axis < 3; ++axis)
      {
        expected |= border.Places[i][axis] == 1.0 && border.Places[j][axis] == 1.0;
      }
      EXPECT_EQ(border.AreOnOneFace(i, j), expected);
      pairs += expected ? 0 : 1;
    }
  }
  EXPECT_GT(pairs, 0);
}

//----------------------------------------------------------------------------
TEST(PatchBorder, MovesPointsStrictlyInsideTheCell)
{
  const Stages stages{ Cube() };
  const PatchBorder middle = BorderIn(stages, { 0, 1, 1 });
  const Point3 inside{ 0.4, 1.3, 1.7 };
  EXPECT_EQ(middle.MoveInside(stages.Grid, inside), inside);
  // Slab 0 of x ends at the bounds of the surface: half a spacing beyond the cube, at 0.
  const Point3 far = middle.MoveInside(stages.Grid, { -50.0, 0.0, 9.0 });
  EXPECT_EQ(far[0], 0.0);
  EXPECT_GT(far[1], 1.0);
  EXPECT_LT(far[2], 2.0);
  ExpectNear(far, { 0.0, 1.0, 2.0 }, 2.0 * InnerMargin);
  EXPECT_LT(middle.MoveInside(stages.Grid, { 1.0, 1.5, 1.5 })[0], 1.0);
}
