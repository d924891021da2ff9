// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   sums over a long border by a tree are about those over all of its points
 */

#include "Core/Patches/ResidualTree.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;

namespace
{
/// Along a circle of radius 1, with values and gradients that change smoothly.
std::vector<Residual> Ring(int count)
{
  std::vector<Residual> ring;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    ring.push_back({ 1.0 / count, { std::cos(angle), std::sin(angle), 0.1 * std::sin(3.0 * angle) },
      0.01 * std::cos(2.0 * angle), { 0.01 * std::sin(angle), 0.02, 0.01 * std::cos(angle) } });
  }
  return ring;
}

/// The weighted mean of the linear functions at a place, and how many were asked.
struct Mean
{
  double Value = 0.0;
  int Count = 0;
};

template <typename VisitAll>
Mean MeanAt(const Point3& p, VisitAll&& visitAll)
{
  Mean mean;
  double weights = 0.0, values = 0.0;
  visitAll(
    [&](const Residual& r)
    {
      const Point3 d = p - r.Place;
      const double w = r.Weight / (Dot(d, d) * Dot(d, d));
      weights += w;
      values += w * (r.Value + Dot(r.Gradient, d));
      ++mean.Count;
    });
  mean.Value = values / weights;
  return mean;
}
}

//----------------------------------------------------------------------------
TEST(ResidualTree, GivesTheMeanOfAllPointsFromFew)
{
  for (const int count : { 600, 5000, 40000 })
  {
    const std::vector<Residual> ring = Ring(count);
    ResidualTree tree;
    EXPECT_TRUE(tree.IsEmpty());
    tree.Set(ring);
    EXPECT_FALSE(tree.IsEmpty());
    for (const double radius : { 0.0, 0.3, 0.7, 0.95, 0.999 })
    {
      const Point3 p{ radius * std::cos(0.7), radius * std::sin(0.7), 0.02 };
      const Mean all = MeanAt(p,
        [&](const auto& add)
        {
          for (const Residual& r : ring)
          {
            add(r);
          }
        });
      const Mean few = MeanAt(p, [&](const auto& add) { tree.VisitFrom(p, ring, add); });
      EXPECT_NEAR(few.Value, all.Value, 2e-4) << count << " points, radius " << radius;
      EXPECT_LT(few.Count, 500);
    }
  }
}

//----------------------------------------------------------------------------
/// Each residual stands for itself or is part of one sum.
TEST(ResidualTree, LosesNothing)
{
  const std::vector<Residual> ring = Ring(1001);
  ResidualTree tree;
  tree.Set(ring);
  for (const double radius : { 0.0, 0.5, 0.99, 1.0 })
  {
    double weights = 0.0;
    tree.VisitFrom({ radius, 0.0, 0.0 }, ring, [&](const Residual& r) { weights += r.Weight; });
    EXPECT_NEAR(weights, 1.0, 1e-12);
  }
  tree.Clear();
  EXPECT_TRUE(tree.IsEmpty());
}
