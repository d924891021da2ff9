// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/AlignToBorders.h"

#include "Core/Base/Vectors.h"
#include "Core/Frames/SortByPlanes.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The part of a circle of radius 10 on a slice across z where x is less than a border, turned.
void AddPart(double z, double border, const Matrix3& turn, Polylines& lines)
{
  const double half = std::acos(border / 10.0);
  constexpr int parts = 40;
  for (int i = 0; i <= parts; ++i)
  {
    const double angle = half + (2.0 * 3.14159265358979 - 2.0 * half) * i / parts;
    const Point3 p = Apply(turn, { 10.0 * std::cos(angle), 10.0 * std::sin(angle), z });
    lines.X.push_back(p[0]);
    lines.Y.push_back(p[1]);
    lines.Z.push_back(p[2]);
  }
  lines.Offsets.push_back(static_cast<Index>(lines.X.size()));
  lines.Closed.push_back(0);
  lines.From.Port.push_back(2);
  lines.From.Block.push_back(0);
  lines.From.Cell.push_back(lines.Count() - 1);
}

/// How much a direction of the world is along the axis of the frame that is nearest to it.
double Along(const AxisFrame& frame, const Point3& direction)
{
  double most = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    most = std::max(most, std::abs(Dot(frame.Normal(axis), direction)));
  }
  return most;
}
}

/// Contours of an oblique stack end at the border of the image: that is across an axis.
TEST(AlignToBorders, TheBorderIsAcrossAnAxis)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    const Matrix3 turn = RandomRotation(seed);
    Polylines lines;
    for (double z = 0.0; z < 6.0; z += 1.0)
    {
      AddPart(z, 4.0, turn, lines);
    }
    const SortedSlices sorted = SortByPlanes(lines, {});
    EXPECT_NEAR(Along(sorted.Frame, Apply(turn, { 1.0, 0.0, 0.0 })), 1.0, 1e-9) << seed;
    EXPECT_NEAR(Along(sorted.Frame, Apply(turn, { 0.0, 0.0, 1.0 })), 1.0, 1e-9) << seed;
    EXPECT_TRUE(sorted.Frame.IsRotation());
  }
}

/// So do those of a stack across z whose image lies at an angle; not by a thousandth.
TEST(AlignToBorders, TheWorldTurnsToo)
{
  for (const double angle : { 0.4, -0.7, 0.0005 })
  {
    const Matrix3 turn = RotationAround({ 0.0, 0.0, 1.0 }, angle);
    for (const std::int8_t port : { 2, 0 })
    {
      Polylines lines;
      for (double z = 0.0; z < 6.0; z += 1.0)
      {
        AddPart(z, 4.0, turn, lines);
      }
      lines.From.Port.assign(lines.Count(), port);
      const SortedSlices sorted = SortByPlanes(lines, {});
      EXPECT_EQ(sorted.Frame.IsWorld(), angle < 0.001 && angle > 0.0);
      EXPECT_EQ(sorted.Frame.Normal(2), (Point3{ 0.0, 0.0, 1.0 }));
      EXPECT_EQ(sorted.Slices[2].Count(), 6);
      if (!sorted.Frame.IsWorld())
      {
        EXPECT_NEAR(Along(sorted.Frame, Apply(turn, { 1.0, 0.0, 0.0 })), 1.0, 1e-9);
      }
    }
  }
}

/// One contour that is open, or gaps in all directions, say nothing of borders.
TEST(AlignToBorders, GapsTurnNothing)
{
  const Matrix3 turn = RandomRotation(3);
  Polylines one, gaps;
  AddPart(0.0, 4.0, turn, one);
  for (int i = 0; i < 6; ++i)
  {
    const Matrix3 around = RotationAround({ 0.0, 0.0, 1.0 }, 0.7 * i);
    Matrix3 both{};
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        for (int k = 0; k < 3; ++k)
        {
          both[row][column] += turn[row][k] * around[k][column];
        }
      }
    }
    AddPart(i, 9.9, both, gaps);
  }
  FamilyAxes axes;
  axes.HasFamily = { false, false, true };
  axes.Frame = AxisFrame(Transpose(turn));
  for (const Polylines* lines : { &one, &gaps })
  {
    FamilyAxes turned = axes;
    AlignToBorders(*lines, turned);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(turned.Frame.Normal(axis), axes.Frame.Normal(axis));
    }
  }
}
