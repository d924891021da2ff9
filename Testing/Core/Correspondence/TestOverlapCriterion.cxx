// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/OverlapCriterion.h"

#include "Support/ContourStacks.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
ContourPairs Overlaps(const std::string& text)
{
  return FindPairs(CorrespondenceCriterion::Overlap, ParseStack(text));
}
}

//----------------------------------------------------------------------------
TEST(OverlapCriterion, CrossingContoursCorrespond)
{
  EXPECT_EQ(Overlaps("z=0: 0,0 2,0 2,2 0,2; z=1: 1,1 3,1 3,3 1,3"), (ContourPairs{ { 0, 1 } }));
  EXPECT_EQ(Overlaps("z=0: 0,0 2,0 2,2 0,2; z=1: 3,1 4,1 4,3 3,3"), ContourPairs());
}

//----------------------------------------------------------------------------
TEST(OverlapCriterion, ContainmentNeedsNoCrossing)
{
  EXPECT_EQ(Overlaps("z=0: 0,0 9,0 9,9 0,9; z=1: 4,4 5,4 5,5 4,5"), (ContourPairs{ { 0, 1 } }));
  EXPECT_EQ(Overlaps("z=0: 4,4 5,4 5,5 4,5; z=1: 0,0 9,0 9,9 0,9"), (ContourPairs{ { 0, 1 } }));
}

//----------------------------------------------------------------------------
TEST(OverlapCriterion, EqualContoursCorrespond)
{
  EXPECT_EQ(Overlaps("z=0: 0,0 2,0 2,2 0,2; z=1: 0,0 2,0 2,2 0,2"), (ContourPairs{ { 0, 1 } }));
  // With corners of the one in the sides of the other.
  EXPECT_EQ(Overlaps("z=0: 0,0 2,0 2,2 0,2; z=1: 1,0 2,1 1,2 0,1"), (ContourPairs{ { 0, 1 } }));
}

//----------------------------------------------------------------------------
TEST(OverlapCriterion, TouchingContoursDoNot)
{
  const std::string square = "z=0: 0,0 2,0 2,2 0,2;";
  EXPECT_EQ(Overlaps(square + "z=1: 2,0 4,0 4,2 2,2"), ContourPairs());   // a side
  EXPECT_EQ(Overlaps(square + "z=1: -2,0 0,0 0,2 -2,2"), ContourPairs()); //
  EXPECT_EQ(Overlaps(square + "z=1: 0,2 2,2 2,4 0,4"), ContourPairs());   //
  EXPECT_EQ(Overlaps(square + "z=1: 0,-2 2,-2 2,0 0,0"), ContourPairs()); //
  EXPECT_EQ(Overlaps(square + "z=1: 2,2 4,2 4,4 2,4"), ContourPairs());   // a corner
  EXPECT_EQ(Overlaps(square + "z=1: -1,-1 0,0 -1,0"), ContourPairs());    //
  EXPECT_EQ(Overlaps(square + "z=1: 2,1 4,0 4,2"), ContourPairs());       // corner and side
}

//----------------------------------------------------------------------------
TEST(OverlapCriterion, TheSmallestOverlapCounts)
{
  EXPECT_EQ(Overlaps("z=0: 0,0 2,0 2,2 0,2; z=1: 1.9999999999999998,0 4,0 4,2"),
    (ContourPairs{ { 0, 1 } }));
}

//----------------------------------------------------------------------------
// A ring below, above it what lies in its hole (not the ring's interior) and a ring like it.
TEST(OverlapCriterion, HolesAreNotInterior)
{
  const std::string ring = "z=0: 0,0 9,0 9,9 0,9; z=0: 2,2 2,7 7,7 7,2;";
  EXPECT_EQ(Overlaps(ring + "z=1: 4,4 5,4 5,5 4,5"), ContourPairs());
  EXPECT_EQ(Overlaps(ring + "z=1: 1,1 3,1 3,3 1,3"), (ContourPairs{ { 0, 2 } }));
  EXPECT_EQ(Overlaps(ring + "z=1: 0,0 8,0 8,8 0,8; z=1: 3,3 3,6 6,6 6,3"),
    (ContourPairs{ { 0, 2 }, { 1, 3 } }));
  EXPECT_EQ(Overlaps(ring + "z=1: 2,2 7,2 7,7 2,7"), ContourPairs()); // a plug, touching all around
  EXPECT_EQ(Overlaps(ring + "z=1: 4,2 5,2 5,7 4,7"), ContourPairs()); // a bar, touching at its ends
  // An island fills the hole of the one where the other has its own hole: the voids are apart.
  EXPECT_EQ(Overlaps(ring +
              "z=0: 3,3 6,3 6,6 3,6;"
              "z=1: 0,0 9,0 9,9 0,9; z=1: 4,4 4,5 5,5 5,4"),
    (ContourPairs{ { 0, 3 }, { 2, 3 } }));
}

//----------------------------------------------------------------------------
TEST(OverlapCriterion, BranchesCorrespondToTheTrunk)
{
  EXPECT_EQ(Overlaps("z=0: 0,0 9,0 9,2 0,2; z=1: 0,0 3,0 3,2 0,2; z=1: 6,0 9,0 9,2 6,2"),
    (ContourPairs{ { 0, 1 }, { 0, 2 } }));
}

//----------------------------------------------------------------------------
// Regions of unit squares: common squares tell which interiors overlap.
TEST(OverlapCriterion, AgreesWithCountingOnRandomRectangles)
{
  Random random(7);
  for (int round = 0; round < 300; ++round)
  {
    ContourStack stack = EmptyStack(2);
    struct Rectangle
    {
      int U, V, Width, Height;
    };
    std::vector<Rectangle> rectangles;
    // Side by side in four columns of each slice, so that contours of one slice do not cross.
    for (Index slice = 0; slice < 2; ++slice)
    {
      for (int column = 0; column < 4; ++column)
      {
        const Rectangle r{ 4 * column + static_cast<int>(random.Below(2)) + slice,
          static_cast<int>(random.Below(6)), 1 + static_cast<int>(random.Below(3)),
          1 + static_cast<int>(random.Below(4)) };
        const double u = r.U, v = r.V, w = r.Width, h = r.Height;
        AddContour(stack, slice, { { u, v }, { u + w, v }, { u + w, v + h }, { u, v + h } });
        rectangles.push_back(r);
      }
    }
    ContourPairs expected;
    for (Index i = 0; i < 4; ++i)
    {
      for (Index j = 4; j < 8; ++j)
      {
        const Rectangle &a = rectangles[i], &b = rectangles[j];
        if (std::max(a.U, b.U) < std::min(a.U + a.Width, b.U + b.Width) &&
          std::max(a.V, b.V) < std::min(a.V + a.Height, b.V + b.Height))
        {
          expected.push_back({ i, j });
        }
      }
    }
    EXPECT_EQ(FindPairs(CorrespondenceCriterion::Overlap, stack), expected) << "round " << round;
  }
}

namespace
{
/// Sides of a rectangle: low and high u, low and high v.
using Sides = std::array<double, 4>;

bool Contains(const Sides& r, double u, double v)
{
  return u > r[0] && u < r[1] && v > r[2] && v < r[3];
}

/// A rectangle with a hole with an island, each within the one before.
std::array<Sides, 3> RandomNest(Random& random, double shift)
{
  std::array<Sides, 3> nest;
  Sides around{ shift, shift + 16.0, 0.0, 16.0 };
  for (Sides& r : nest)
  {
    for (int i = 0; i < 4; ++i)
    {
      const double inwards = 1.0 + random.Below(2);
      r[i] = around[i] + (i % 2 == 0 ? inwards : -inwards);
    }
    around = r;
  }
  return nest;
}

/// Whether the interiors of contour i of one nest and j of another have a common half unit square.
bool HaveCommonArea(
  const std::array<Sides, 3>& a, std::size_t i, const std::array<Sides, 3>& b, std::size_t j)
{
  const auto interior = [](const std::array<Sides, 3>& nest, std::size_t k, double u, double v)
  { return Contains(nest[k], u, v) && !(k < 2 && Contains(nest[k + 1], u, v)); };
  for (double u = 0.25; u < 17.0; u += 0.5)
  {
    for (double v = 0.25; v < 17.0; v += 0.5)
    {
      if (interior(a, i, u, v) && interior(b, j, u, v))
      {
        return true;
      }
    }
  }
  return false;
}
}

//----------------------------------------------------------------------------
// Sides of the one often lie on sides of the other, and islands fit into holes.
TEST(OverlapCriterion, AgreesWithCountingOnRandomNests)
{
  Random random(8);
  for (int round = 0; round < 400; ++round)
  {
    ContourStack stack = EmptyStack(2);
    const std::array<std::array<Sides, 3>, 2> nests{ RandomNest(random, 0.0),
      RandomNest(random, round % 2 == 0 ? 0.0 : 0.5) };
    for (Index slice = 0; slice < 2; ++slice)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Sides& r = nests[slice][k];
        std::vector<Point2> vertices{ { r[0], r[2] }, { r[1], r[2] }, { r[1], r[3] },
          { r[0], r[3] } };
        if (k == 1)
        {
          std::reverse(vertices.begin(), vertices.end());
        }
        AddContour(stack, slice, vertices);
      }
    }
    ContourPairs expected;
    for (Index i = 0; i < 3; ++i)
    {
      for (Index j = 0; j < 3; ++j)
      {
        if ((i == 1) == (j == 1) && HaveCommonArea(nests[0], i, nests[1], j))
        {
          expected.push_back({ i, 3 + j });
        }
      }
    }
    EXPECT_EQ(FindPairs(CorrespondenceCriterion::Overlap, stack), expected) << "round " << round;
  }
}
