// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/ComponentSeeds.h"

#include "Core/Base/Vectors.h"
#include "Support/ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace orthoslices;

namespace
{
/// Boxes, outwards or inwards, one component each.
struct Boxes
{
  std::vector<double> Points;
  std::vector<std::int32_t> Triangles;
  std::vector<int> Components;
  int Count = 0;

  void Add(double half, bool isCavity, const Point3& middle = { 0.0, 0.0, 0.0 })
  {
    const std::int32_t first = static_cast<std::int32_t>(this->Points.size() / 3);
    for (int i = 0; i < 8; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Points.push_back(middle[axis] + ((i >> axis & 1) != 0 ? half : -half));
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int32_t u = 1 << FirstAxis(axis), v = 1 << SecondAxis(axis);
      for (const std::int32_t base : { 0, 1 << axis })
      {
        const bool isUp = (base != 0) != isCavity;
        this->AddTriangle(first + base, first + base + u, first + base + u + v, isUp);
        this->AddTriangle(first + base, first + base + u + v, first + base + v, isUp);
      }
    }
    ++this->Count;
  }
  /// Of several processes, each has some of the triangles.
  std::vector<Point3> Seeds(const Ranks& ranks = Ranks()) const
  {
    const Portion own = PortionOf(ranks, this->Components.size(), [](std::size_t) { return 1.0; });
    const auto count = static_cast<std::int64_t>(own.Last - own.First);
    const std::int32_t* triangles = this->Triangles.data() + 3 * own.First;
    const int* components = this->Components.data() + own.First;
    return FindSeeds(this->Points.data(), triangles, count, components,
      MeasureComponents(
        this->Points.data(), triangles, count, components, this->Count, false, ranks),
      ranks);
  }

private:
  void AddTriangle(std::int32_t a, std::int32_t b, std::int32_t c, bool isUp)
  {
    this->Triangles.insert(this->Triangles.end(), { a, isUp ? b : c, isUp ? c : b });
    this->Components.push_back(this->Count);
  }
};

/// How far a point is from the origin along the axes.
double Depth(const Point3& p)
{
  return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
}
}

//----------------------------------------------------------------------------
TEST(ComponentSeeds, OneInEachRegionBesideItsComponent)
{
  Boxes boxes; // a body, its cavity, and a body in that
  boxes.Add(1.0, false);
  boxes.Add(0.5, true);
  boxes.Add(0.25, false);
  const std::vector<Point3> seeds = boxes.Seeds();
  ASSERT_EQ(seeds.size(), 3u);
  EXPECT_GT(Depth(seeds[0]), 0.5);
  EXPECT_LT(Depth(seeds[0]), 1.0);
  EXPECT_GT(Depth(seeds[1]), 0.25);
  EXPECT_LT(Depth(seeds[1]), 0.5);
  EXPECT_LT(Depth(seeds[2]), 0.25);
}

//----------------------------------------------------------------------------
// Lines of all components cross each other's triangles: each ends at the next one, wherever it lies.
TEST(ComponentSeeds, BesideTheirComponentsAmongHundreds)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> offset(-0.05, 0.05);
  std::vector<Point3> middles;
  Boxes boxes;
  for (int i = 0; i < 7 * 8 * 9; ++i)
  {
    middles.push_back(
      { i % 7 + offset(random), i / 7 % 8 + offset(random), 1e3 + i / 56 + offset(random) });
    boxes.Add(0.4, false, middles.back());
    boxes.Add(0.3, true, middles.back());
  }
  const std::vector<Point3> seeds = boxes.Seeds();
  ASSERT_EQ(seeds.size(), 2 * middles.size());
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    EXPECT_NEAR(Depth(seeds[2 * i] - middles[i]), 0.35, 1e-9) << i;
    EXPECT_NEAR(Depth(seeds[2 * i + 1] - middles[i]), 0.1, 1e-9) << i; // halfway through the cavity
  }
}

//----------------------------------------------------------------------------
// Triangles of a box are equally wide: all processes take the first of all.
TEST(ComponentSeeds, ThoseOfAllWhereProcessesHaveAPartEach)
{
  Boxes boxes;
  boxes.Add(1.0, false);
  boxes.Add(0.5, true);
  boxes.Add(0.25, false);
  const std::vector<Point3> whole = boxes.Seeds();
  for (const int count : { 2, 3, 7, 50 })
  {
    std::vector<std::vector<Point3>> seeds(count);
    support::ThreadRanks(count).ForAll(
      [&](const Ranks& ranks) { seeds[ranks.Rank] = boxes.Seeds(ranks); });
    for (const std::vector<Point3>& ofRank : seeds)
    {
      EXPECT_EQ(ofRank, whole) << count << " processes";
    }
  }
}

//----------------------------------------------------------------------------
TEST(ComponentSeeds, NoneWhereNothingIsEnclosed)
{
  const std::vector<double> points{ 0, 0, 0, 1, 0, 0, 0, 1, 0 };
  const std::vector<std::int32_t> triangle{ 0, 1, 2 };
  const std::vector<int> components{ 0 };
  const std::vector<Point3> seeds = FindSeeds(points.data(), triangle.data(), 1, components.data(),
    MeasureComponents(points.data(), triangle.data(), 1, components.data(), 2));
  ASSERT_EQ(seeds.size(), 2u);
  EXPECT_TRUE(std::isnan(seeds[0][0]));
  EXPECT_TRUE(std::isnan(seeds[1][0]));
}
