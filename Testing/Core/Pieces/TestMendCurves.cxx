// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/MendCurves.h"

#include "Core/Pieces/CloseGaps.h"
#include "Core/Pieces/FindBorders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;

namespace
{
OpenCurve CurveOf(const std::vector<Point2>& points, std::int64_t cell = 0, double plane = 0.0)
{
  OpenCurve curve;
  curve.Axis = 2;
  curve.Plane = plane;
  curve.Cell = cell;
  curve.Points = points;
  return curve;
}

/// Part of a circle, in steps of two degrees.
OpenCurve Arc(double from, double to, std::int64_t cell = 0, Point2 center = { 0.0, 0.0 })
{
  OpenCurve curve = CurveOf({}, cell);
  const int steps = std::max(1, static_cast<int>(std::lround(std::abs(to - from) / 2.0)));
  for (int i = 0; i <= steps; ++i)
  {
    const double angle = (from + (to - from) * i / steps) * 3.14159265358979323846 / 180.0;
    curve.Points.push_back({ center[0] + std::cos(angle), center[1] + std::sin(angle) });
  }
  return curve;
}

double AreaOf(const OpenCurve& loop)
{
  double area = 0.0;
  for (std::size_t i = 0; i < loop.Points.size(); ++i)
  {
    area += 0.5 * Cross(loop.Points[i], loop.Points[(i + 1) % loop.Points.size()]);
  }
  return std::abs(area);
}

double TotalArea(const std::vector<OpenCurve>& loops)
{
  double area = 0.0;
  for (const OpenCurve& loop : loops)
  {
    area += AreaOf(loop);
  }
  return area;
}

std::vector<OpenCurve> Close(std::vector<OpenCurve>& curves)
{
  std::vector<OpenCurve> closed;
  CloseGaps([](const OpenCurve&, int, const OpenCurve&, int) { return true; }, curves, closed);
  return closed;
}

/// Mends curves of z-slices.
MendedCurves Mend(std::vector<OpenCurve> curves,
  BorderContours atBorder = BorderContours::CloseAlong, const Box3& given = Box3())
{
  std::array<ImageBorder, 3> borders;
  for (const OpenCurve& curve : curves)
  {
    for (const Point2& point : curve.Points)
    {
      borders[2].Add(point);
    }
  }
  return MendCurves(std::move(curves), 1e-9, atBorder, given, borders);
}
}

//----------------------------------------------------------------------------
TEST(CloseGaps, ShortGapsOfOneCurve)
{
  std::vector<OpenCurve> curves{ Arc(30.0, 350.0) };
  const std::vector<OpenCurve> closed = Close(curves);
  EXPECT_TRUE(curves.empty());
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_NEAR(closed[0].Gap, 2.0 * std::sin(0.349), 1e-3);
  EXPECT_EQ(closed[0].Points.size(), 161u);
  curves = { Arc(0.0, 290.0) }; // a gap of more than a fifth of the length
  EXPECT_TRUE(Close(curves).empty());
  EXPECT_EQ(curves.size(), 1u);
}

//----------------------------------------------------------------------------
TEST(CloseGaps, SeveralPiecesInAnyOrderAndDirection)
{
  std::vector<OpenCurve> curves{ Arc(0.0, 80.0, 1), Arc(350.0, 290.0, 2), Arc(100.0, 180.0, 3),
    Arc(280.0, 190.0, 4) };
  const std::vector<OpenCurve> closed = Close(curves);
  EXPECT_TRUE(curves.empty());
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_EQ(closed[0].Cell, 4) << "of the longest piece";
  EXPECT_NEAR(AreaOf(closed[0]), 3.14159, 0.02);
  EXPECT_NEAR(closed[0].Gap, 2.0 * std::sin(0.1745), 1e-3) << "the longest, of 20 degrees";
}

//----------------------------------------------------------------------------
TEST(CloseGaps, LoopsCloseThemselvesBesideOthers)
{
  // The gaps face each other, and the ends of the other circle are nearer than the own ones.
  std::vector<OpenCurve> curves{ Arc(15.0, 345.0), Arc(-165.0, 165.0, 1, { 2.3, 0.0 }) };
  EXPECT_LT(Distance(curves[0].End(0), curves[1].End(1)), curves[0].EndDistance());
  const std::vector<OpenCurve> closed = Close(curves);
  ASSERT_EQ(closed.size(), 2u);
  EXPECT_NEAR(AreaOf(closed[0]), 3.14, 0.03);
  EXPECT_NEAR(AreaOf(closed[1]), 3.14, 0.03);
}

//----------------------------------------------------------------------------
TEST(CloseGaps, PiecesThatOverlapAreTrimmed)
{
  std::vector<OpenCurve> curves{ Arc(0.0, 190.0), Arc(180.0, 370.0) };
  const std::vector<OpenCurve> closed = Close(curves);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_NEAR(AreaOf(closed[0]), 3.14, 0.01);
  EXPECT_NEAR(closed[0].Length(), 6.28, 0.04) << "no part of it twice";
  EXPECT_GT(closed[0].Trimmed, 0.3);
}

//----------------------------------------------------------------------------
TEST(MendCurves, ShortAndOpenOnesAreLeftOut)
{
  const MendedCurves result =
    Mend({ Arc(0.0, 200.0, 5), CurveOf({ { 5.0, 5.0 }, { 6.0, 5.0 } }, 7) });
  EXPECT_TRUE(result.Loops.empty());
  ASSERT_EQ(result.Problems.size(), 2u);
  EXPECT_EQ(result.Problems[0].Kind, ProblemKind::Open);
  EXPECT_EQ(result.Problems[0].Cell, 5);
  EXPECT_TRUE(result.Problems[0].IsLeftOut);
  EXPECT_EQ(result.Problems[1].Kind, ProblemKind::TooShort);
  EXPECT_EQ(result.Problems[1].Size, 1.0);
  EXPECT_EQ(result.Problems[1].Where, (Point3{ 5.0, 5.0, 0.0 }));
}

//----------------------------------------------------------------------------
TEST(MendCurves, CurvesOfDifferentSlicesAreNotJoined)
{
  OpenCurve other = Arc(180.0, 360.0);
  other.Plane = 1.0;
  const MendedCurves result = Mend({ Arc(2.0, 170.0), other });
  EXPECT_TRUE(result.Loops.empty());
}

//----------------------------------------------------------------------------
namespace
{
const std::vector<Point2> HalfDisc{ { 4.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 3.0 }, { 2.0, 5.0 },
  { 4.0, 6.0 } };
}

TEST(ImageBorder, CurvesAreClosedAlongIt)
{
  const MendedCurves result = Mend({ CurveOf(HalfDisc, 3), CurveOf(HalfDisc, 4, 1.0) });
  ASSERT_EQ(result.Loops.size(), 2u);
  EXPECT_EQ(AreaOf(result.Loops[0]), 12.0);
  ASSERT_EQ(result.Problems.size(), 2u);
  EXPECT_EQ(result.Problems[0].Kind, ProblemKind::ClosedAlongBorder);
  EXPECT_EQ(result.Problems[0].Size, 6.0);
  EXPECT_EQ(result.Problems[0].Cell, 3);
  EXPECT_FALSE(result.Problems[0].IsLeftOut);
}

//----------------------------------------------------------------------------
TEST(ImageBorder, HolesAtItStayHoles)
{
  const OpenCurve hole = CurveOf({ { 4.0, 2.0 }, { 3.0, 3.0 }, { 4.0, 4.0 } });
  for (const bool reversed : { false, true })
  {
    OpenCurve outline = CurveOf(HalfDisc);
    if (reversed)
    {
      std::reverse(outline.Points.begin(), outline.Points.end());
    }
    const MendedCurves result = Mend({ outline, hole });
    ASSERT_EQ(result.Loops.size(), 1u);
    EXPECT_EQ(AreaOf(result.Loops[0]), 11.0);
  }
}

//----------------------------------------------------------------------------
TEST(ImageBorder, TheCornerOfTheImageIsInside)
{
  // A quarter of a disc around the corner (5, 5), on three slices.
  std::vector<OpenCurve> curves;
  for (int i = 0; i < 3; ++i)
  {
    curves.push_back(CurveOf({ { 5.0, 1.0 + i }, { 2.0 + i, 2.0 + i }, { 1.0 + i, 5.0 } }, i, i));
  }
  const MendedCurves result = Mend(curves);
  ASSERT_EQ(result.Loops.size(), 3u);
  EXPECT_EQ(AreaOf(result.Loops[0]), 12.0);
  const auto& points = result.Loops[0].Points;
  EXPECT_NE(std::find(points.begin(), points.end(), Point2{ 5.0, 5.0 }), points.end());
}

//----------------------------------------------------------------------------
TEST(ImageBorder, WhatPassesFromOneSideToTheOtherIsBetweenItsOutlines)
{
  std::vector<OpenCurve> curves;
  for (int i = 0; i < 2; ++i)
  {
    curves.push_back(CurveOf({ { 0.0, 2.0 }, { 5.0, 1.0 }, { 10.0, 2.0 } }, 0, i));
    curves.push_back(CurveOf({ { 10.0, 6.0 }, { 5.0, 7.0 }, { 0.0, 6.0 } }, 1, i));
  }
  const MendedCurves result = Mend(curves);
  ASSERT_EQ(result.Loops.size(), 2u);
  EXPECT_EQ(AreaOf(result.Loops[0]), 50.0);
}

//----------------------------------------------------------------------------
TEST(ImageBorder, PiecesWithGapsAreJoinedBeforeTheyAreClosed)
{
  // The half disc in two parts that lack a tenth of a segment.
  const MendedCurves result = Mend({ CurveOf({ { 4.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 2.9 } }),
    CurveOf({ { 1.0, 3.1 }, { 2.0, 5.0 }, { 4.0, 6.0 } }) });
  ASSERT_EQ(result.Loops.size(), 1u);
  EXPECT_NEAR(AreaOf(result.Loops[0]), 12.0, 0.2);
}

//----------------------------------------------------------------------------
TEST(ImageBorder, ALoopThatBeginsWhereItReachesFarthestIsNoBorder)
{
  // All begin at (1, 0), which is farthest along u; what they lack is not at a border.
  std::vector<OpenCurve> curves;
  for (int i = 0; i < 4; ++i)
  {
    curves.push_back(Arc(0.0, 330.0, i));
    curves.back().Plane = i;
  }
  const MendedCurves result = Mend(curves);
  ASSERT_EQ(result.Loops.size(), 4u);
  for (const Problem& problem : result.Problems)
  {
    EXPECT_EQ(problem.Kind, ProblemKind::GapClosed);
  }
}

//----------------------------------------------------------------------------
TEST(ImageBorder, OtherAxesSeeTheSameSide)
{
  // One end on each of two z-slices, and on two y-slices, at x = 4.
  std::vector<OpenCurve> curves{ CurveOf(HalfDisc) };
  OpenCurve other = CurveOf({});
  other.Axis = 1; // u is z, v is x
  for (const Point2& point : HalfDisc)
  {
    other.Points.push_back({ point[1], point[0] });
  }
  curves.push_back(other);
  std::array<ImageBorder, 3> borders;
  for (const OpenCurve& curve : curves)
  {
    for (const Point2& point : curve.Points)
    {
      borders[curve.Axis].Add(point);
    }
  }
  const MendedCurves result =
    MendCurves(std::move(curves), 1e-9, BorderContours::CloseAlong, Box3(), borders);
  EXPECT_EQ(TotalArea(result.Loops), 24.0);
  EXPECT_TRUE(borders[2].IsFound[0][1]);
  EXPECT_TRUE(borders[1].IsFound[1][1]);
  EXPECT_FALSE(borders[1].IsFound[0][1] || borders[2].IsFound[1][1] || borders[2].IsFound[0][0]);
}

//----------------------------------------------------------------------------
/// Where other contours reach farther, a border is found only if it is given; of the axes that are
/// not given it is found as before.
TEST(ImageBorder, GivenSidesNeedNotBeFound)
{
  OpenCurve farther = Arc(5.0, 355.0, 7, { 8.0, 3.0 });
  EXPECT_EQ(Mend({ CurveOf(HalfDisc, 3), farther }).Loops.size(), 1u);
  Box3 given;
  given.Low[0] = 0.0;
  given.High[0] = 4.0;
  const MendedCurves result =
    Mend({ CurveOf(HalfDisc, 3), farther }, BorderContours::CloseAlong, given);
  ASSERT_EQ(result.Loops.size(), 2u);
  EXPECT_NEAR(TotalArea(result.Loops), 12.0 + 3.14159, 0.02);
  given.High[0] = 1.0;
  EXPECT_EQ(Mend({ CurveOf(HalfDisc, 3) }, BorderContours::CloseAlong, given).Loops.size(), 0u);
  given = Box3();
  given.Low[1] = -2.0;
  given.High[1] = 8.0;
  EXPECT_EQ(Mend({ CurveOf(HalfDisc, 3) }, BorderContours::CloseAlong, given).Loops.size(), 1u);
  given.Low[0] = -HUGE_VAL;
  given.High[0] = 4.0;
  EXPECT_EQ(
    AreaOf(Mend({ CurveOf(HalfDisc, 3) }, BorderContours::CloseAlong, given).Loops.at(0)), 12.0);
}

//----------------------------------------------------------------------------
TEST(ImageBorder, ToBeLeftOpenCurvesGoOnAcrossIt)
{
  const MendedCurves result =
    Mend({ CurveOf(HalfDisc, 3), CurveOf(HalfDisc, 4, 0.5) }, BorderContours::LeaveOpen);
  ASSERT_EQ(result.Loops.size(), 2u);
  EXPECT_DOUBLE_EQ(AreaOf(result.Loops[0]), 12.0 + 0.5 * 6.0) << "for the distance of the slices";
  ASSERT_EQ(result.Problems.size(), 2u);
  EXPECT_EQ(result.Problems[0].Kind, ProblemKind::LeftOpen);
  EXPECT_FALSE(result.Problems[0].IsLeftOut);
}

//----------------------------------------------------------------------------
TEST(ImageBorder, WallsThatReachFarthestAreNoSides)
{
  // A bar that is cut off at its end: the walls are farthest along v on every slice.
  const std::vector<Point2> bar{ { 4.0, 0.0 }, { 2.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 1.0 },
    { 2.0, 1.0 }, { 4.0, 1.0 } };
  std::vector<OpenCurve> curves;
  std::array<ImageBorder, 3> borders;
  for (int i = 0; i < 3; ++i)
  {
    curves.push_back(CurveOf(bar, i, 0.1 * i));
  }
  for (const Point2& point : bar)
  {
    borders[2].Add(point);
  }
  FindBorders(curves, borders);
  EXPECT_TRUE(borders[2].IsFound[0][1]);
  EXPECT_FALSE(borders[2].IsFound[0][0] || borders[2].IsFound[1][0] || borders[2].IsFound[1][1]);
}

//----------------------------------------------------------------------------
TEST(ImageBorder, RefusedIfAskedFor)
{
  const MendedCurves result = Mend({ CurveOf(HalfDisc, 3) }, BorderContours::Refuse);
  EXPECT_TRUE(result.Loops.empty());
  ASSERT_EQ(result.Refused.size(), 1u);
  EXPECT_EQ(result.Refused[0].Kind, ProblemKind::Open);
  EXPECT_EQ(result.Refused[0].Cell, 3);
}
