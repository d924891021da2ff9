// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/UncrossCurves.h"

#include "Support/CheckEmbedding.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
PlanarCurves MakeCurves(const std::vector<std::vector<Point2>>& curves)
{
  PlanarCurves set;
  for (const std::vector<Point2>& curve : curves)
  {
    set.Curves.emplace_back(curve.size());
    std::iota(
      set.Curves.back().begin(), set.Curves.back().end(), static_cast<Index>(set.Vertices.size()));
    set.Vertices.insert(set.Vertices.end(), curve.begin(), curve.end());
  }
  return set;
}

Point3 Lift(const PlanarCurves& set, Index vertex)
{
  return { set.Vertices[vertex][0], set.Vertices[vertex][1], 0.0 };
}

/// Whether the segment from b to c runs back along that from a to b, or one of them is a point.
bool FoldsBack(const Point2& a, const Point2& b, const Point2& c)
{
  return ExactTurn({ a[0], a[1], 0.0 }, { b[0], b[1], 0.0 }, { c[0], c[1], 0.0 }, 2) == 0 &&
    ((a[0] - b[0]) * (c[0] - b[0]) > 0.0 || (a[1] - b[1]) * (c[1] - b[1]) > 0.0 || a == b ||
      b == c);
}

/// Compares all segments with each other, by the tests' own predicates.
bool DoMeet(const PlanarCurves& set)
{
  for (std::size_t a = 0; a < set.Curves.size(); ++a)
  {
    const std::vector<Index>& p = set.Curves[a];
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
    {
      if (i > 0 && FoldsBack(set.Vertices[p[i - 1]], set.Vertices[p[i]], set.Vertices[p[i + 1]]))
      {
        return true;
      }
      for (std::size_t b = a; b < set.Curves.size(); ++b)
      {
        const std::vector<Index>& q = set.Curves[b];
        for (std::size_t j = a == b ? i + 2 : 0; j + 1 < q.size(); ++j)
        {
          if (SegmentsMeet(
                Lift(set, p[i]), Lift(set, p[i + 1]), Lift(set, q[j]), Lift(set, q[j + 1]), 2))
          {
            return true;
          }
        }
      }
    }
  }
  return false;
}

std::size_t CountVertices(const PlanarCurves& set)
{
  std::vector<Index> all;
  for (const std::vector<Index>& curve : set.Curves)
  {
    all.insert(all.end(), curve.begin(), curve.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
  return all.size();
}

/// Curves of 20 000 vertices side by side along y, from 0 to 1, each in a strip of this width.
std::vector<std::vector<Point2>> DenseCurvesAlongY(double width)
{
  constexpr int count = 20000;
  Random random(3);
  std::vector<std::vector<Point2>> curves(2);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    for (int k = 0; k < count; ++k)
    {
      curves[i].push_back({ i + width * random.Uniform(0.0, 1.0), k / (count - 1.0) });
    }
  }
  return curves;
}

void ExchangeAxes(std::vector<std::vector<Point2>>& curves)
{
  for (std::vector<Point2>& curve : curves)
  {
    for (Point2& p : curve)
    {
      std::swap(p[0], p[1]);
    }
  }
}

void ExpectLeftAlone(const std::vector<std::vector<Point2>>& curves)
{
  PlanarCurves set = MakeCurves(curves);
  const auto before = set.Curves;
  EXPECT_TRUE(AreSimple(set));
  const Uncrossing outcome = UncrossCurves(set);
  EXPECT_TRUE(outcome.Simple);
  EXPECT_EQ(outcome.Changes, 0);
  EXPECT_EQ(outcome.Shortening, 0.0);
  EXPECT_EQ(set.Curves, before);
}

double Length(const PlanarCurves& set)
{
  double length = 0.0;
  for (const std::vector<Index>& curve : set.Curves)
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      const Point2& p = set.Vertices[curve[i - 1]];
      const Point2& q = set.Vertices[curve[i]];
      length += std::hypot(q[0] - p[0], q[1] - p[1]);
    }
  }
  return length;
}
}

//----------------------------------------------------------------------------
TEST(AreSimple, IfNothingTouches)
{
  const auto areSimple = [](const std::vector<std::vector<Point2>>& curves)
  {
    PlanarCurves set = MakeCurves(curves);
    return AreSimple(set);
  };
  EXPECT_TRUE(areSimple({ { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 } } }));
  EXPECT_TRUE(areSimple({ { { 0, 0 }, { 1, 0 } }, { { 0, 1 }, { 1, 1 } } }));
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 1, 0 }, { 0, 0 } } }));            // back
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 2, 0 }, { 1, 0 } } }));            // partly
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 0, 0 }, { 1, 0 } } }));            // twice
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 } } }));  // closed
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 1, -1 } } })); // crosses
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 2, 0 } }, { { 1, 0 }, { 1, 1 } } }));
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 2, 0 } }, { { 0, 0 }, { 2, 1 } } }));
}

//----------------------------------------------------------------------------
TEST(AreSimple, ClosedCurves)
{
  const auto areSimple = [](const std::vector<std::vector<Point2>>& curves, std::size_t closed)
  {
    PlanarCurves set = MakeCurves(curves);
    set.FirstClosed = closed;
    return AreSimple(set);
  };
  const std::vector<Point2> square{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 } };
  EXPECT_TRUE(areSimple({ square }, 0));
  EXPECT_FALSE(areSimple({ square }, 1));
  EXPECT_TRUE(areSimple({ { { 2, 0 }, { 2, 1 } }, square }, 1));
  EXPECT_FALSE(areSimple({ { { 0.5, -1 }, { 0.5, 1 } }, square }, 1));
  // It runs back along its first segment.
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 0 }, { 0, 0 } } }, 0));
  EXPECT_FALSE(areSimple({ { { 0, 0 }, { 2, 0 }, { 0, 2 }, { 2, 2 }, { 0, 0 } } }, 0));
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, TakesAClosedCurveApart)
{
  PlanarCurves set = MakeCurves({ { { 0, 0 }, { 2, 0 }, { 0, 2 }, { 2, 2 }, { 0, 0 } } });
  set.FirstClosed = 0;
  EXPECT_TRUE(UncrossCurves(set).Simple);
  EXPECT_EQ(set.Curves[0].size(), 5u);
  EXPECT_EQ(set.Vertices[set.Curves[0].front()], set.Vertices[set.Curves[0].back()]);
}

//----------------------------------------------------------------------------
/// Squares whose corners overlap stay side by side, whichever corner they begin with; none comes to
/// lie within the other.
TEST(UncrossCurves, ClosedCurvesExchangeTheirShorterParts)
{
  std::vector<Point2> a{ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } };
  std::vector<Point2> b{ { 3, 3 }, { 7, 3 }, { 7, 7 }, { 3, 7 } };
  for (int start = 0; start < 16; ++start)
  {
    PlanarCurves set;
    AddClosedCurve(a, set);
    AddClosedCurve(b, set);
    EXPECT_TRUE(UncrossCurves(set).Simple);
    for (const int curve : { 0, 1 })
    {
      std::vector<Point2> polygon;
      for (const Index vertex : set.Curves[curve])
      {
        polygon.push_back(set.Vertices[vertex]);
      }
      EXPECT_EQ(polygon.front(), polygon.back());
      EXPECT_LE(std::abs(SignedArea(polygon)), 16.0) << start;
      EXPECT_GE(std::abs(SignedArea(polygon)), 12.0) << start;
    }
    std::rotate(a.begin(), a.begin() + 1, a.end());
    std::rotate(b.begin(), b.begin() + (start % 4 == 3 ? 1 : 0), b.end());
  }
}

//----------------------------------------------------------------------------
TEST(AreSimple, AsByComparingAllPairs)
{
  Random random(7);
  int simple = 0;
  for (int run = 0; run < 5000; ++run)
  {
    std::vector<std::vector<Point2>> curves(1 + random.Below(3));
    for (auto& curve : curves)
    {
      for (std::size_t i = 2 + random.Below(3); i > 0; --i)
      {
        // On a coarse lattice half of the time.
        const double step = run % 2 == 0 ? 0.25 : 1e-9;
        curve.push_back({ step * std::round(random.Uniform(0.0, 1.0) / step),
          step * std::round(random.Uniform(0.0, 1.0) / step) });
      }
    }
    PlanarCurves set = MakeCurves(curves);
    const bool isSimple = AreSimple(set);
    EXPECT_EQ(isSimple, !DoMeet(set));
    simple += isSimple ? 1 : 0;
  }
  EXPECT_GT(simple, 200);
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, LeavesCurvesThatDoNotTouch)
{
  ExpectLeftAlone({ { { 0, 0 }, { 1, 1 }, { 2, 0 } }, { { 0, 1 }, { 1, 2 }, { 2, 1 } } });
}

//----------------------------------------------------------------------------
/// All segments of a curve overlap along one axis. A contour so dense is no contradiction.
TEST(UncrossCurves, LeavesDenseCurvesThatDoNotTouch)
{
  for (const double width : { 0.0, 1e-9, 1e-4 })
  {
    auto curves = DenseCurvesAlongY(width);
    ExpectLeftAlone(curves);
    ExchangeAxes(curves);
    ExpectLeftAlone(curves);
  }
}

//----------------------------------------------------------------------------
/// Half of the segments overlap along x, the other half along y. That takes long, and is done.
TEST(UncrossCurves, LeavesADenseCurveAroundACorner)
{
  auto curves = DenseCurvesAlongY(0.0);
  curves.pop_back();
  for (int k = 1; k <= 20000; ++k)
  {
    curves[0].push_back({ k / 20000.0, 1.0 });
  }
  ExpectLeftAlone(curves);
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, TakesDenseCurvesApartThatCross)
{
  auto curves = DenseCurvesAlongY(1e-4);
  for (int turn = 0; turn < 2; ++turn)
  {
    PlanarCurves set = MakeCurves(curves);
    std::swap(set.Curves[0][5000], set.Curves[0][5001]);
    std::swap(set.Curves[1][7000], set.Curves[1][7100]);
    EXPECT_FALSE(AreSimple(set));
    EXPECT_TRUE(UncrossCurves(set).Simple);
    EXPECT_TRUE(AreSimple(set));
    EXPECT_EQ(CountVertices(set), set.Vertices.size());
    ExchangeAxes(curves);
  }
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, PassesALoopTheOtherWay)
{
  PlanarCurves set =
    MakeCurves({ { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, -1 }, { 0, -1 } } });
  const Uncrossing outcome = UncrossCurves(set);
  EXPECT_TRUE(outcome.Simple);
  EXPECT_EQ(outcome.Changes, 1);
  EXPECT_EQ(set.Curves[0], std::vector<Index>({ 0, 3, 2, 1, 4, 5 }));
  EXPECT_NEAR(outcome.Shortening, 4.0 - 2.0 * std::sqrt(2.0), 1e-15);
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, KeepsTheTipOfAHairpinWhoseSidesCrossTwice)
{
  PlanarCurves set = MakeCurves({ { { 0, 1 }, { 2, -1 }, { 4, -1 }, { 6, 1 }, { 8, 0 }, { 6, -1 },
    { 4, 1 }, { 2, 1 }, { 0, -1 } } });
  EXPECT_TRUE(UncrossCurves(set).Simple);
  EXPECT_EQ(set.Curves[0], std::vector<Index>({ 0, 7, 6, 3, 4, 5, 2, 1, 8 }));
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, ExchangesTheRestsOfTwoCurves)
{
  PlanarCurves set = MakeCurves({ { { 0, 0 }, { 2, 2 } }, { { 0, 2 }, { 2, 0 } } });
  EXPECT_TRUE(UncrossCurves(set).Simple);
  EXPECT_EQ(set.Curves[0], std::vector<Index>({ 0, 3 }));
  EXPECT_EQ(set.Curves[1], std::vector<Index>({ 2, 1 }));
}

//----------------------------------------------------------------------------
/// The two sides of a thin part, drawn so that they overlap: whichever way they run, each keeps its
/// ends.
TEST(UncrossCurves, ExchangesThePartsBetweenTwoCrossings)
{
  PlanarCurves set = MakeCurves(
    { { { 0, 0 }, { 2, 2 }, { 3, 2 }, { 5, 0 } }, { { 0, 1 }, { 2, 0 }, { 3, 0 }, { 5, 1 } } });
  EXPECT_TRUE(UncrossCurves(set).Simple);
  EXPECT_EQ(set.Curves[0], std::vector<Index>({ 0, 5, 6, 3 }));
  EXPECT_EQ(set.Curves[1], std::vector<Index>({ 4, 1, 2, 7 }));

  set = MakeCurves(
    { { { 0, 0 }, { 2, 2 }, { 3, 2 }, { 5, 0 } }, { { 5, 1 }, { 3, 0 }, { 2, 0 }, { 0, 1 } } });
  EXPECT_TRUE(UncrossCurves(set).Simple);
  EXPECT_EQ(set.Curves[0], std::vector<Index>({ 0, 6, 5, 3 }));
  EXPECT_EQ(set.Curves[1], std::vector<Index>({ 4, 2, 1, 7 }));

  // Both crossings on one segment.
  set = MakeCurves({ { { 0, 0 }, { 6, 0 } }, { { 0, 1 }, { 2, -1 }, { 4, -1 }, { 6, 1 } } });
  EXPECT_TRUE(UncrossCurves(set).Simple);
  EXPECT_EQ(set.Curves[0], std::vector<Index>({ 0, 3, 4, 1 }));
  EXPECT_EQ(set.Curves[1], std::vector<Index>({ 2, 5 }));
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, LeavesOutVerticesThatTouch)
{
  // The vertex of one curve on the other; a fold; a copy.
  for (const auto& curves : std::vector<std::vector<std::vector<Point2>>>{
         { { { 0, 0 }, { 4, 0 } }, { { 0, 1 }, { 2, 0 }, { 4, 1 } } },
         { { { 0, 0 }, { 3, 0 }, { 2, 0 }, { 2, 1 } } },
         { { { 0, 0 }, { 1, 1 }, { 1, 1 }, { 2, 0 } } } })
  {
    PlanarCurves set = MakeCurves(curves);
    const std::size_t before = CountVertices(set);
    EXPECT_TRUE(UncrossCurves(set).Simple);
    EXPECT_EQ(CountVertices(set), before - 1);
    EXPECT_FALSE(DoMeet(set));
  }
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, GivesUpWhereEndsTouch)
{
  PlanarCurves set = MakeCurves({ { { 0, 0 }, { 2, 0 } }, { { 1, 0 }, { 2, 1 } } });
  EXPECT_FALSE(UncrossCurves(set).Simple);
}

//----------------------------------------------------------------------------
TEST(UncrossCurves, GivesUpInTime)
{
  // Much worse than any noise: 8000 vertices all over the place.
  Random random(1);
  std::vector<Point2> scribble(8000);
  for (Point2& p : scribble)
  {
    p = { random.Uniform(0.0, 1.0), random.Uniform(0.0, 1.0) };
  }
  PlanarCurves set = MakeCurves({ scribble });
  EXPECT_FALSE(UncrossCurves(set).Simple);
}

//----------------------------------------------------------------------------
/// On a coarse lattice vertices coincide and segments overlap as often as they cross.
TEST(UncrossCurves, TakesApartWhatever)
{
  for (const double step : { 0.0, 0.125 })
  {
    for (int run = 0; run < 200; ++run)
    {
      Random random(run);
      std::vector<std::vector<Point2>> curves(1 + run % 4);
      for (std::size_t i = 0; i < curves.size(); ++i)
      {
        // Starts and ends on the left and right border, apart from each other.
        curves[i].push_back({ -1.0, static_cast<double>(i) });
        for (int k = 0; k < 5 + run % 50; ++k)
        {
          Point2 p{ random.Uniform(0.0, 3.0), random.Uniform(0.0, 3.0) };
          for (double& x : p)
          {
            x = step > 0.0 ? step * std::round(x / step) : x;
          }
          curves[i].push_back(p);
        }
        curves[i].push_back({ 4.0, static_cast<double>(random.Uniform(0.0, 1.0) + i) });
      }
      PlanarCurves set = MakeCurves(curves);
      const std::size_t vertices = CountVertices(set);
      const double length = Length(set);
      const Uncrossing outcome = UncrossCurves(set);
      ASSERT_TRUE(outcome.Simple) << "run " << run;
      EXPECT_FALSE(DoMeet(set)) << "run " << run;
      EXPECT_NEAR(outcome.Shortening, length - Length(set), 1e-9);
      EXPECT_TRUE(outcome.Changes == 0 || outcome.Shortening > 0.0);
      EXPECT_TRUE(step > 0.0 || CountVertices(set) == vertices);
    }
  }
}
