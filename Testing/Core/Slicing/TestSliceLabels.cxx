// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceLabels.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

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

/// Whatever the others are, a label's contours are those of an image that has no others.
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
    const PlaneContours expected =
      SliceImage(alone, 0.5, Coordinates(9), Coordinates(7), Precision::Double);
    for (Index i = 0; i < expected.Count(); ++i, ++found)
    {
      ASSERT_LT(found, contours.Contours.Count());
      EXPECT_EQ(contours.Labels[found], label);
      const Index size = expected.Offsets[i + 1] - expected.Offsets[i];
      ASSERT_EQ(contours.Contours.Offsets[found + 1] - contours.Contours.Offsets[found], size);
      for (Index k = 0; k < size; ++k)
      {
        EXPECT_EQ(contours.Contours.U[contours.Contours.Offsets[found] + k],
          expected.U[expected.Offsets[i] + k]);
        EXPECT_EQ(contours.Contours.V[contours.Contours.Offsets[found] + k],
          expected.V[expected.Offsets[i] + k]);
      }
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

TEST(SliceLabels, BackgroundAndWhatIsNotFiniteHaveNoContours)
{
  const double infinity = std::numeric_limits<double>::infinity();
  SamplePlane plane{ 3, 2, { 0, -2, std::nan(""), infinity, 5, 5 } };
  EXPECT_EQ(Slice(plane).Labels, (std::vector<double>{ -2.0, 5.0 }));
  EXPECT_EQ(Slice(plane, 5.0).Labels, (std::vector<double>{ -2.0, 0.0 }));
  EXPECT_EQ(Slice(SamplePlane{ 2, 1, { 0, 0 } }).Contours.Count(), 0);
}
