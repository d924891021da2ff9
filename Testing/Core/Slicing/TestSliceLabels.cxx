// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceLabels.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Coordinates of `count` samples with one more on both ends.
std::vector<double> Coordinates(Index count)
{
  std::vector<double> coordinates;
  for (Index i = -1; i <= count; ++i)
  {
    coordinates.push_back(0.5 * i * i + 10.0 * i); // uneven
  }
  return coordinates;
}

LabelContours Slice(const SamplePlane& plane, double background = 0.0)
{
  return SliceLabels(
    plane, background, Coordinates(plane.SizeU), Coordinates(plane.SizeV), Precision::Double);
}

SamplePlane RandomLabels(Index sizeU, Index sizeV, int labels, std::uint64_t seed)
{
  Random random(seed);
  SamplePlane plane{ sizeU, sizeV, {} };
  for (Index i = 0; i < sizeU * sizeV; ++i)
  {
    plane.Values.push_back(static_cast<double>(random.Below(labels)));
  }
  return plane;
}

/// The vertices of the contours of a label.
std::set<std::pair<double, double>> VerticesOf(const LabelContours& contours, double label)
{
  std::set<std::pair<double, double>> vertices;
  for (Index contour = 0; contour < contours.Contours.Count(); ++contour)
  {
    for (Index i = contours.Contours.Offsets[contour];
         i < contours.Contours.Offsets[contour + 1] && contours.Labels[contour] == label; ++i)
    {
      vertices.insert({ contours.Contours.U[i], contours.Contours.V[i] });
    }
  }
  return vertices;
}
}

namespace
{
/// The vertices of a contour that lie on lines between samples: not those in which labels meet.
std::vector<std::pair<double, double>> VerticesOnLines(const PlaneContours& contours, Index contour)
{
  const std::vector<double> samples = Coordinates(9);
  const auto isSample = [&](double x)
  { return std::find(samples.begin(), samples.end(), x) != samples.end(); };
  std::vector<std::pair<double, double>> vertices;
  for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
  {
    if (isSample(contours.U[i]) || isSample(contours.V[i]))
    {
      vertices.emplace_back(contours.U[i], contours.V[i]);
    }
  }
  return vertices;
}
}

/// The squares in which a label is on one diagonal and a lesser one, above the background 0, on the
/// other one, by their lower left samples.
std::vector<std::size_t> SquaresToJoin(const SamplePlane& plane, double label)
{
  std::vector<std::size_t> squares;
  for (std::size_t i = 0; i + plane.SizeU + 1 < plane.Values.size(); ++i)
  {
    const double* lower = plane.Values.data() + i;
    const double* upper = lower + plane.SizeU;
    const bool isSquare = (i + 1) % plane.SizeU != 0;
    const double other = std::min(lower[0], lower[1]);
    if (isSquare && lower[0] == upper[1] && lower[1] == upper[0] && other > 0.0 && other < label &&
      std::max(lower[0], lower[1]) == label)
    {
      squares.push_back(i);
    }
  }
  return squares;
}

/// Whatever the others are, a label's contours are those of an image that has no others, but for
/// vertices in which labels meet, and for squares in which it is joined between those of a lesser
/// one.
TEST(SliceLabels, EachLabelAsIfThereWereNoOther)
{
  const SamplePlane plane = RandomLabels(9, 7, 4, 5);
  const LabelContours contours = Slice(plane);
  Index found = 0;
  for (const double label : { 1.0, 2.0, 3.0 })
  {
    SamplePlane alone = plane;
    for (double& value : alone.Values)
    {
      value = value == label ? 1.0 : 0.0;
    }
    alone.Joined = SquaresToJoin(plane, label);
    const PlaneContours expected =
      SliceImage(alone, 0.5, Coordinates(9), Coordinates(7), Precision::Double);
    for (Index i = 0; i < expected.Count(); ++i, ++found)
    {
      ASSERT_LT(found, contours.Contours.Count());
      EXPECT_EQ(contours.Labels[found], label);
      EXPECT_EQ(VerticesOnLines(contours.Contours, found), VerticesOnLines(expected, i));
    }
  }
  EXPECT_EQ(found, contours.Contours.Count());
}

TEST(SliceLabels, NeighboursShareTheirBorder)
{
  // Two labels side by side, two columns of three samples each.
  const SamplePlane plane{ 4, 3, { 3, 3, 8, 8, 3, 3, 8, 8, 3, 3, 8, 8 } };
  const LabelContours contours = Slice(plane);
  EXPECT_EQ(contours.Labels, (std::vector<double>{ 3.0, 8.0 }));
  const auto first = VerticesOf(contours, 3.0), second = VerticesOf(contours, 8.0);
  const std::vector<double> us = Coordinates(4), vs = Coordinates(3);
  for (Index row = 0; row < 3; ++row)
  {
    const std::pair<double, double> between{ 0.5 * (us[2] + us[3]), vs[row + 1] };
    EXPECT_EQ(first.count(between), 1u);
    EXPECT_EQ(second.count(between), 1u);
  }
}

/// Three labels, or two and the background, have a vertex in common where they meet; not where two
/// samples on a diagonal are one label.
TEST(SliceLabels, LabelsMeetInOneVertex)
{
  const std::vector<double> us = Coordinates(2);
  const std::pair<double, double> middle{ 0.5 * (us[1] + us[2]), 0.5 * (us[1] + us[2]) };
  const LabelContours three = Slice(SamplePlane{ 2, 2, { 1, 1, 2, 3 } });
  for (const double label : { 1.0, 2.0, 3.0 })
  {
    EXPECT_EQ(VerticesOf(three, label).count(middle), 1u);
  }
  const LabelContours two = Slice(SamplePlane{ 2, 2, { 1, 2, 0, 0 } });
  EXPECT_EQ(VerticesOf(two, 1.0).count(middle), 1u);
  EXPECT_EQ(VerticesOf(two, 2.0).count(middle), 1u);
  EXPECT_EQ(VerticesOf(Slice(SamplePlane{ 2, 2, { 1, 2, 1, 2 } }), 1.0).count(middle), 0u);
  EXPECT_EQ(VerticesOf(Slice(SamplePlane{ 2, 2, { 1, 2, 3, 1 } }), 2.0).count(middle), 0u);
}

namespace
{
/// Twice the area within all contours.
double TwiceAreaOf(const PlaneContours& contours)
{
  double area = 0.0;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    const Index begin = contours.Offsets[contour], end = contours.Offsets[contour + 1];
    for (Index i = begin; i < end; ++i)
    {
      const Index next = i + 1 < end ? i + 1 : begin;
      area += contours.U[i] * contours.V[next] - contours.U[next] * contours.V[i];
    }
  }
  return area;
}
}

/// Labels that meet across the diagonals of squares leave nothing between them.
TEST(SliceLabels, NothingIsLeftBetweenDiagonals)
{
  SamplePlane plane = RandomLabels(40, 30, 5, 7);
  for (std::size_t i = 0; i < plane.Values.size(); ++i)
  {
    const bool isOnBorder = i < 40 || i >= 29 * 40 || i % 40 == 0 || i % 40 == 39;
    plane.Values[i] = isOnBorder ? 1.0 : plane.Values[i] + 1.0; // no background
  }
  const double all = TwiceAreaOf(Slice(plane).Contours);
  SamplePlane one = plane;
  std::fill(one.Values.begin(), one.Values.end(), 1.0);
  EXPECT_NEAR(all, TwiceAreaOf(Slice(one).Contours), 1e-9 * all);
}

/// Of two labels on both diagonals of a square, the greater one is joined.
TEST(SliceLabels, OneOfTwoLabelsIsJoinedOnDiagonals)
{
  const LabelContours two = Slice(SamplePlane{ 2, 2, { 1, 2, 2, 1 } });
  EXPECT_EQ(std::count(two.Labels.begin(), two.Labels.end(), 1.0), 2);
  EXPECT_EQ(std::count(two.Labels.begin(), two.Labels.end(), 2.0), 1);
  const LabelContours withBackground = Slice(SamplePlane{ 2, 2, { 0, 2, 2, 0 } });
  EXPECT_EQ(std::count(withBackground.Labels.begin(), withBackground.Labels.end(), 2.0), 2);
}

TEST(SliceLabels, BackgroundAndWhatIsNotFiniteHaveNoContours)
{
  const double infinity = std::numeric_limits<double>::infinity();
  SamplePlane plane{ 3, 2, { 0, -2, std::nan(""), infinity, 5, 5 } };
  EXPECT_EQ(Slice(plane).Labels, (std::vector<double>{ -2.0, 5.0 }));
  EXPECT_EQ(Slice(plane, 5.0).Labels, (std::vector<double>{ -2.0, 0.0 }));
  EXPECT_EQ(Slice(SamplePlane{ 2, 1, { 0, 0 } }).Contours.Count(), 0);
}
