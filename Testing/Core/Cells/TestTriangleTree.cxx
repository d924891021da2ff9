// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/TriangleTree.h"

#include "Core/Base/Predicates.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The strip between two circles that are `count` segments long and one apart.
std::vector<PatchTriangle> Strip(Index count, double inner, double outer)
{
  std::vector<PatchTriangle> triangles;
  const auto at = [&](Index i, bool high)
  {
    const double angle = 6.283185307179586 * i / count;
    const double r = high ? outer : inner;
    return Point3{ r * std::cos(angle), r * std::sin(angle), high ? 1.0 : 0.0 };
  };
  for (Index i = 0; i < count; ++i)
  {
    const Index next = (i + 1) % count;
    triangles.push_back(
      { 0, { at(i, false), at(next, false), at(i, true) }, { i, next, count + i } });
    triangles.push_back(
      { 0, { at(next, false), at(next, true), at(i, true) }, { next, count + next, count + i } });
  }
  return triangles;
}

std::size_t CountFound(const std::vector<PatchTriangle>& triangles)
{
  const TriangleTree tree(triangles);
  std::size_t count = 0;
  std::vector<Index> found;
  for (Index i = 0; i < static_cast<Index>(triangles.size()); ++i)
  {
    tree.FindAfter(
      i, [](Index, Index) { return true; }, found);
    count += found.size();
  }
  return count;
}
}

//----------------------------------------------------------------------------
TEST(TriangleTree, LeavesOutOnlyWhatIsApart)
{
  Random random(3);
  std::vector<PatchTriangle> triangles;
  for (Index i = 0; i < 400; ++i)
  {
    const double size = random.Below(2) == 0 ? 0.3 : 2.0;
    std::array<Point3, 3> corners;
    const Point3 place{ random.Uniform(-3, 3), random.Uniform(-3, 3), random.Uniform(-3, 3) };
    for (Point3& corner : corners)
    {
      corner = place;
      for (double& x : corner)
      {
        x += random.Uniform(-size, size);
      }
    }
    triangles.push_back({ i % 3, corners, { 3 * i, 3 * i + 1, 3 * i + 2 } });
  }
  const TriangleTree tree(triangles);
  const auto isWanted = [](Index a, Index b) { return a != b; };
  std::size_t found = 0, apart = 0;
  for (Index i = 0; i < 400; ++i)
  {
    std::vector<Index> after;
    tree.FindAfter(i, isWanted, after);
    EXPECT_TRUE(std::is_sorted(after.begin(), after.end()));
    for (Index j = i + 1; j < 400; ++j)
    {
      const bool isFound = std::binary_search(after.begin(), after.end(), j);
      found += isFound ? 1 : 0;
      apart += isFound ? 0 : 1;
      if (!isFound && isWanted(triangles[i].Patch, triangles[j].Patch))
      {
        EXPECT_TRUE(CertainlyApart(triangles[i].Corners, triangles[j].Corners)) << i << " " << j;
      }
    }
  }
  EXPECT_GT(found, 100u);
  EXPECT_GT(apart, 10 * found);
}

//----------------------------------------------------------------------------
TEST(TriangleTree, FindsAFewNeighboursInAStripOfLongTriangles)
{
  // Boxes along the axes overlap for a sixth of all pairs.
  for (const Index count : { 500, 2000 })
  {
    const std::vector<PatchTriangle> triangles = Strip(count, 1.0, 3.0);
    EXPECT_LT(CountFound(triangles), 10 * triangles.size());
  }
}
