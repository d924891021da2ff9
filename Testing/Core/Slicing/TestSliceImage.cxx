// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceImage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>

using namespace orthoslices;

namespace
{
/// One row of digits for each row of samples, the uppermost first as one draws it.
SamplePlane Drawing(const std::vector<std::string>& rows)
{
  SamplePlane plane;
  plane.SizeU = static_cast<Index>(rows.front().size());
  plane.SizeV = static_cast<Index>(rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
  {
    for (const char digit : *row)
    {
      plane.Values.push_back(digit - '0');
    }
  }
  return plane;
}

/// Sample i lies at coordinate i.
PlaneContours Draw(const SamplePlane& plane, double threshold)
{
  std::vector<double> us(static_cast<std::size_t>(plane.SizeU) + 2);
  std::vector<double> vs(static_cast<std::size_t>(plane.SizeV) + 2);
  std::iota(us.begin(), us.end(), -1.0);
  std::iota(vs.begin(), vs.end(), -1.0);
  return SliceImage(plane, threshold, us, vs, Precision::Double);
}

std::vector<double> Areas(const PlaneContours& contours)
{
  std::vector<double> areas;
  for (Index c = 0; c < contours.Count(); ++c)
  {
    double twice = 0.0;
    for (Index i = contours.Offsets[c], last = contours.Offsets[c + 1] - 1;
         i < contours.Offsets[c + 1]; last = i++)
    {
      twice += contours.U[last] * contours.V[i] - contours.U[i] * contours.V[last];
    }
    areas.push_back(0.5 * twice);
  }
  std::sort(areas.begin(), areas.end());
  return areas;
}
}

TEST(SliceImage, OneSampleIsADiamond)
{
  const PlaneContours contours = Draw(Drawing({ "000", "010", "000" }), 0.5);
  ASSERT_EQ(contours.Count(), 1);
  EXPECT_EQ(contours.U.size(), 4u);
  EXPECT_EQ(Areas(contours), std::vector<double>{ 0.5 });
}

TEST(SliceImage, BorderIsHalfASpacingOutside)
{
  for (const double threshold : { 0.5, -100.0, 1.0 })
  {
    const PlaneContours contours = Draw(Drawing({ "11", "11" }), threshold);
    ASSERT_EQ(contours.Count(), 1);
    EXPECT_EQ(*std::min_element(contours.U.begin(), contours.U.end()), -0.5);
    EXPECT_EQ(*std::max_element(contours.V.begin(), contours.V.end()), 1.5);
    EXPECT_EQ(Areas(contours), std::vector<double>{ 3.5 }); // 2 x 2 with its corners cut
  }
}

TEST(SliceImage, HolesRunClockwise)
{
  EXPECT_EQ(Areas(Draw(Drawing({ "11111", "11111", "11011", "11111", "11111" }), 0.5)),
    (std::vector<double>{ -0.5, 24.5 }));
}

TEST(SliceImage, DiagonalInsideSamplesStayApart)
{
  EXPECT_EQ(Areas(Draw(Drawing({ "10", "01" }), 0.5)), (std::vector<double>{ 0.5, 0.5 }));
  EXPECT_EQ(Areas(Draw(Drawing({ "01", "10" }), 0.5)), (std::vector<double>{ 0.5, 0.5 }));
}

TEST(SliceImage, DiagonalOutsideSamplesAreOneHole)
{
  const auto areas = Areas(Draw(Drawing({ "1111", "1011", "1101", "1111" }), 0.5));
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_EQ(areas[0], -1.5); // two diamonds and the two triangles between them
}

TEST(SliceImage, ThresholdIsInterpolated)
{
  const PlaneContours contours = Draw(Drawing({ "000", "040", "000" }), 1.0);
  EXPECT_EQ(*std::min_element(contours.U.begin(), contours.U.end()), 0.25);
  EXPECT_EQ(*std::max_element(contours.V.begin(), contours.V.end()), 1.75);
}

TEST(SliceImage, SamplesAtTheThresholdAreInsideAndContoursDoNotTouchThere)
{
  const PlaneContours contours = Draw(Drawing({ "00000", "33233", "00000" }), 2.0);
  EXPECT_EQ(contours.Count(), 1);
  std::map<std::pair<double, double>, int> places;
  for (std::size_t i = 0; i < contours.U.size(); ++i)
  {
    EXPECT_EQ((++places[{ contours.U[i], contours.V[i] }]), 1);
  }
  EXPECT_EQ(places.count({ 2.0, 1.0 }), 0u);
}

TEST(SliceImage, SamplesThatAreNoNumberAreOutside)
{
  SamplePlane plane = Drawing({ "111", "111", "111" });
  plane.Values[4] = std::nan("");
  EXPECT_EQ(Draw(plane, 0.5).Count(), 2);
  plane.Values[4] = -std::numeric_limits<double>::infinity();
  const PlaneContours contours = Draw(plane, 0.5);
  EXPECT_EQ(Areas(contours), (std::vector<double>{ -0.5, 8.5 }));
}

TEST(SliceImage, NothingInsideGivesNothing)
{
  EXPECT_EQ(Draw(Drawing({ "00", "00" }), 0.5).Count(), 0);
}

/// Counts regions instead of following contours: outer boundaries surround 4-connected inside
/// regions, holes surround 8-connected outside regions.
TEST(SliceImage, RandomPlanesHaveAContourForEveryRegion)
{
  std::mt19937 random(4711);
  for (int round = 0; round < 200; ++round)
  {
    SamplePlane plane;
    plane.SizeU = 1 + static_cast<Index>(random() % 12);
    plane.SizeV = 1 + static_cast<Index>(random() % 12);
    const Index width = plane.SizeU + 2;
    std::vector<int> inside(static_cast<std::size_t>(width) * (plane.SizeV + 2), 0);
    for (Index j = 0; j < plane.SizeV; ++j)
    {
      for (Index i = 0; i < plane.SizeU; ++i)
      {
        plane.Values.push_back(static_cast<double>(random() % 2));
        inside[(j + 1) * width + i + 1] = plane.Values.back() > 0.5;
      }
    }

    int regions[2] = { 0, 0 };
    std::vector<bool> seen(inside.size(), false);
    for (std::size_t seed = 0; seed < inside.size(); ++seed)
    {
      if (seen[seed])
      {
        continue;
      }
      ++regions[inside[seed]];
      std::vector<std::size_t> stack{ seed };
      seen[seed] = true;
      while (!stack.empty())
      {
        const std::size_t here = stack.back();
        stack.pop_back();
        for (int dj = -1; dj <= 1; ++dj)
        {
          for (int di = -1; di <= 1; ++di)
          {
            const auto i = static_cast<Index>(here % width) + di;
            const auto j = static_cast<Index>(here / width) + dj;
            if (i < 0 || j < 0 || i >= width || j >= plane.SizeV + 2 ||
              (inside[seed] && di != 0 && dj != 0))
            {
              continue;
            }
            const auto there = static_cast<std::size_t>(j) * width + i;
            if (!seen[there] && inside[there] == inside[seed])
            {
              seen[there] = true;
              stack.push_back(there);
            }
          }
        }
      }
    }

    const auto areas = Areas(Draw(plane, 0.5));
    const auto outer = std::count_if(areas.begin(), areas.end(), [](double a) { return a > 0; });
    EXPECT_EQ(outer, regions[1]) << "round " << round;
    EXPECT_EQ(static_cast<int>(areas.size()) - outer, regions[0] - 1) << "round " << round;
  }
}
