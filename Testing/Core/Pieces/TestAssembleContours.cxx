// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/AssembleContours.h"

#include "Support/Perturbations.h"
#include "Support/Random.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Loop = std::vector<std::array<double, 2>>;

struct Assembled
{
  Contours Set;
  std::vector<Problem> Problems;
};

Assembled Assemble(const PieceSets& sets, double tolerance = 0.0)
{
  Assembled result;
  AssembleSettings settings;
  settings.Tolerance = tolerance;
  result.Problems = AssembleContours(PieceSets(sets), settings, result.Set).Unusable;
  return result;
}

Assembled Assemble(const std::string& text, double tolerance = 0.0)
{
  return Assemble(ParsePieces(text), tolerance);
}

Loop LoopOf(const Contours& contours, Index contour)
{
  Loop loop;
  for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
  {
    loop.push_back({ contours.U[i], contours.V[i] });
  }
  return loop;
}

/// The same for every start and direction: begins at the least vertex, goes to the lesser
/// neighbour.
Loop Canonical(Loop loop)
{
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  if (loop.back() < loop[1])
  {
    std::reverse(loop.begin() + 1, loop.end());
  }
  return loop;
}

std::multiset<std::pair<double, Loop>> CanonicalLoops(const Contours& contours)
{
  std::multiset<std::pair<double, Loop>> loops;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    loops.emplace(contours.Coordinate[i], Canonical(LoopOf(contours, i)));
  }
  return loops;
}

/// Star-shaped loops around several places on several planes; no vertex is shared.
PieceSets RandomLoops(std::uint64_t seed)
{
  Random random(seed);
  PieceSets sets = EmptySets();
  for (Pieces& pieces : sets)
  {
    const std::size_t count = 1 + random.Below(6);
    for (std::size_t i = 0; i < count; ++i)
    {
      Loop loop;
      const std::size_t size = 3 + random.Below(10);
      for (std::size_t k = 0; k < size; ++k)
      {
        const double angle = 6.28318 * static_cast<double>(k) / static_cast<double>(size);
        const double radius = random.Uniform(0.5, 1.0);
        loop.push_back({ 3.0 * i + radius * std::cos(angle), radius * std::sin(angle) });
      }
      AddPiece(pieces, loop, static_cast<double>(i / 2));
    }
  }
  return sets;
}

void ExpectProblem(
  const Assembled& result, ProblemKind kind, int port, std::int64_t cell, const Point3& where)
{
  ASSERT_EQ(result.Problems.size(), 1u);
  EXPECT_EQ(result.Problems[0].Kind, kind);
  EXPECT_EQ(result.Problems[0].Port, port);
  EXPECT_EQ(result.Problems[0].Cell, cell);
  EXPECT_EQ(result.Problems[0].Where, where);
}
}

//----------------------------------------------------------------------------
TEST(AssembleContours, ClosedPieceStaysAsItIs)
{
  const Assembled result = Assemble("y=0.5: 0,0 2,0 1,1");
  EXPECT_TRUE(result.Problems.empty());
  ASSERT_EQ(result.Set.Count(), 1);
  EXPECT_EQ(LoopOf(result.Set, 0), (Loop{ { 0, 0 }, { 2, 0 }, { 1, 1 } }));
  EXPECT_EQ(result.Set.Axis[0], 1);
  EXPECT_EQ(result.Set.Coordinate[0], 0.5);
  EXPECT_EQ(result.Set.World(0, 1), (Point3{ 0, 0.5, 2 })); // u is z and v is x on a y-slice
}

//----------------------------------------------------------------------------
TEST(AssembleContours, LooseSegmentsOfAnyOrderAndDirection)
{
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(seed);
    PieceSets sets = RandomLoops(seed);
    const auto expected = CanonicalLoops(Assemble(sets).Set);
    SplitIntoSegments(sets, seed);
    const Assembled result = Assemble(sets);
    EXPECT_TRUE(result.Problems.empty());
    EXPECT_EQ(CanonicalLoops(result.Set), expected);
  }
}

//----------------------------------------------------------------------------
TEST(AssembleContours, LoopsOfDifferentPlanesAreNotMixed)
{
  PieceSets sets = ParsePieces("z=0: 0,0 1,0 1,1; z=1: 0,0 1,0 1,1");
  const auto expected = CanonicalLoops(Assemble(sets).Set);
  ASSERT_EQ(expected.size(), 2u);
  SplitIntoSegments(sets, 1);
  EXPECT_EQ(CanonicalLoops(Assemble(sets).Set), expected);
}

//----------------------------------------------------------------------------
TEST(AssembleContours, OpenPiecesOfAnyDirectionAreJoined)
{
  for (const char* text : { "z=0 open: 0,0 1,0 1,1; z=0 open: 1,1 0,1 0,0",
         "z=0 open: 0,0 1,0 1,1; z=0 open: 0,0 0,1 1,1",
         "z=0 open: 1,0 0,0; z=0 open: 0,0 0,1; z=0 open: 1,0 1,1 0,1" })
  {
    SCOPED_TRACE(text);
    const Assembled result = Assemble(text);
    EXPECT_TRUE(result.Problems.empty());
    ASSERT_EQ(result.Set.Count(), 1);
    EXPECT_EQ(Canonical(LoopOf(result.Set, 0)), (Loop{ { 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 0 } }));
  }
}

//----------------------------------------------------------------------------
TEST(AssembleContours, NearEndsAreJoinedWithinTheTolerance)
{
  const std::string text = "z=0 open: 0,0 1,0 1,1; z=0 open: 1,1.001 0,1 0,0.001";
  const Assembled joined = Assemble(text, 0.002);
  EXPECT_TRUE(joined.Problems.empty());
  ASSERT_EQ(joined.Set.Count(), 1);
  EXPECT_EQ(joined.Set.Size(0), 6);
  // Each piece alone is closed by a segment not longer than twice its longest.
  EXPECT_EQ(Assemble(text, 0.0005).Set.Count(), 2);
}

//----------------------------------------------------------------------------
TEST(AssembleContours, NearestOfSeveralEndsIsTaken)
{
  const Assembled result = Assemble("z=0 open: 0,0 9,0 9,9; z=0 open: 9,9.1 0,9 0,0.1\n"
                                    "z=0 open: 0,-0.3 -9,0 -9,-9; z=0 open: -9,-9.1 0,-9 0,-0.4",
    0.5);
  EXPECT_TRUE(result.Problems.empty());
  ASSERT_EQ(result.Set.Count(), 2);
  EXPECT_EQ(result.Set.Size(0), 6);
  EXPECT_EQ(result.Set.Size(1), 6);
}

//----------------------------------------------------------------------------
TEST(AssembleContours, GapOfTwoSegmentsIsClosedAndNoLargerOne)
{
  EXPECT_EQ(Assemble("z=0 open: 0,0 1,0 1,1 0,1").Set.Count(), 1);
  EXPECT_EQ(Assemble("z=0 open: 0,0 1,0 2,0").Set.Count(), 1); // exactly twice
  ExpectProblem(Assemble("z=0 open: 0,0 1,0 2,0 3,0"), ProblemKind::Open, 2, 0, Point3{ 3, 0, 0 });
}

//----------------------------------------------------------------------------
TEST(AssembleContours, OpenChainIsReportedWithPortCellAndLooseEnd)
{
  const Assembled result = Assemble("x=3: 0,0 1,0 0,1; x=3 open: 5,5 6,5; x=3 open: 6,5 6,6");
  EXPECT_EQ(result.Set.Count(), 1);
  ASSERT_EQ(result.Problems.size(), 1u);
  EXPECT_EQ(result.Problems[0].Kind, ProblemKind::Open);
  EXPECT_EQ(result.Problems[0].Port, 0);
  const bool atFirst = result.Problems[0].Where == Point3{ 3, 5, 5 };
  const bool atLast = result.Problems[0].Where == Point3{ 3, 6, 6 };
  EXPECT_TRUE(atFirst || atLast);
  EXPECT_EQ(result.Problems[0].Cell, atFirst ? 1 : 2);
}

//----------------------------------------------------------------------------
TEST(AssembleContours, DanglingSegmentDoesNotSpoilTheLoop)
{
  PieceSets sets = ParsePieces("z=0: 0,0 1,0 1,1 0,1");
  SplitIntoSegments(sets, 7);
  AddPiece(sets[2], { { 4.0, 4.0 }, { 5.0, 5.0 } }, 0.0);
  sets[2].Closed.back() = 0;
  const Assembled result = Assemble(sets);
  EXPECT_EQ(result.Set.Count(), 1);
  ASSERT_EQ(result.Problems.size(), 1u);
  EXPECT_EQ(result.Problems[0].Cell, 4);
}

//----------------------------------------------------------------------------
namespace
{
/// Two paths a-p-b and c-p-d through one point cross if c and d lie on different sides.
bool PathsCross(double a, double b, double c, double d)
{
  const auto between = [](double from, double to, double x)
  { return std::fmod(x - from + 720.0, 360.0) < std::fmod(to - from + 720.0, 360.0); };
  return between(a, b, c) != between(a, b, d);
}

double Degrees(const std::array<double, 2>& from, const std::array<double, 2>& to)
{
  return std::atan2(to[1] - from[1], to[0] - from[0]) * 180.0 / 3.14159265358979;
}
}

TEST(AssembleContours, ContoursThatTouchInAPointArePairedWithoutCrossing)
{
  // Three triangles with a common corner, as a cutter leaves them.
  PieceSets sets = ParsePieces("z=0: 0,0 2,0 2,1; z=0: 0,0 -1,2 -2,1; z=0: 0,0 -1,-2 1,-2");
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    PieceSets segments = sets;
    SplitIntoSegments(segments, seed);
    const Assembled result = Assemble(segments);
    EXPECT_TRUE(result.Problems.empty());
    std::vector<std::array<double, 2>> visits; // directions to the neighbours at each visit
    std::size_t vertices = 0;
    for (const auto& entry : CanonicalLoops(result.Set))
    {
      const Loop& loop = entry.second;
      vertices += loop.size();
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        if (loop[i] == std::array<double, 2>{ 0, 0 })
        {
          visits.push_back({ Degrees(loop[i], loop[(i + loop.size() - 1) % loop.size()]),
            Degrees(loop[i], loop[(i + 1) % loop.size()]) });
        }
      }
    }
    EXPECT_EQ(vertices, 9u);
    ASSERT_EQ(visits.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        EXPECT_FALSE(PathsCross(visits[i][0], visits[i][1], visits[j][0], visits[j][1]));
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(AssembleContours, AnOpenPieceOfOnePointJoinsNothing)
{
  const Assembled result = Assemble("y=2 open: 0,0; y=2 open: 0,0 8,0 8,8 0,8 0,0");
  ASSERT_EQ(result.Set.Count(), 1);
  EXPECT_EQ(result.Set.Size(0), 4);
  ASSERT_EQ(result.Problems.size(), 1u);
  EXPECT_EQ(result.Problems[0].Kind, ProblemKind::Open);
}

//----------------------------------------------------------------------------
TEST(AssembleContours, SegmentsGivenTwiceCountOnce)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    PieceSets sets = RandomLoops(seed);
    const auto expected = CanonicalLoops(Assemble(sets).Set);
    SplitIntoSegments(sets, seed);
    PieceSets again = sets;
    DuplicatePieces(again);
    ShufflePieces(again, seed);
    const Assembled result = Assemble(again);
    EXPECT_TRUE(result.Problems.empty());
    EXPECT_EQ(CanonicalLoops(result.Set), expected);
  }
}

//----------------------------------------------------------------------------
TEST(AssembleContours, NotFiniteIsReportedAndTheRestKept)
{
  ExpectProblem(Assemble("z=2: 0,0 1,0 1,inf; z=2: 0,0 1,0 1,1"), ProblemKind::NotFinite, 2, 0,
    Point3{ 1, HUGE_VAL, 2 });
  const Assembled result = Assemble("z=2: 0,0 1,0 1,1; z=2: 0,0 nan,0 1,1");
  EXPECT_EQ(result.Set.Count(), 1);
  ASSERT_EQ(result.Problems.size(), 1u);
  EXPECT_EQ(result.Problems[0].Cell, 1);
  EXPECT_TRUE(std::isnan(result.Problems[0].Where[0]));
}

//----------------------------------------------------------------------------
TEST(AssembleContours, LeavingThePlaneByMoreThanTheToleranceIsReported)
{
  const std::string text = "z=0: 0,0 1,0,0.01 1,1";
  ExpectProblem(Assemble(text, 0.005), ProblemKind::OffPlane, 2, 0, Point3{ 1, 0, 0.01 });
  const Assembled within = Assemble(text, 0.02);
  EXPECT_TRUE(within.Problems.empty());
  ASSERT_EQ(within.Set.Count(), 1);
  EXPECT_EQ(within.Set.World(0, 1), (Point3{ 1, 0, 0 })); // moved onto the plane
}

//----------------------------------------------------------------------------
TEST(AssembleContours, RepeatedVerticesAndContoursWithoutAreaGo)
{
  const Assembled result =
    Assemble("z=0: 0,0 0,0 1,0 1,0 1,0 1,1 0,0; z=0: 5,5 5,5 6,6; z=0: 7,7 7,7 7,7");
  EXPECT_TRUE(result.Problems.empty());
  ASSERT_EQ(result.Set.Count(), 1);
  EXPECT_EQ(LoopOf(result.Set, 0), (Loop{ { 0, 0 }, { 1, 0 }, { 1, 1 } }));
}

//----------------------------------------------------------------------------
TEST(AssembleContours, MinusZeroMeetsZero)
{
  const Assembled result = Assemble("z=0 open: 0,0 1,0 1,1; z=0 open: 1,1 0,1 -0,-0");
  ASSERT_EQ(result.Set.Count(), 1);
  EXPECT_EQ(result.Set.Size(0), 4);
}

//----------------------------------------------------------------------------
namespace
{
/// With Mend; Problems are those that were mended or left out.
Assembled Mend(const std::string& text, double tolerance = 0.0)
{
  Assembled result;
  AssembleSettings settings;
  settings.Tolerance = tolerance;
  settings.Mend = true;
  const PieceProblems problems = AssembleContours(ParsePieces(text), settings, result.Set);
  EXPECT_TRUE(problems.Unusable.empty());
  result.Problems = problems.Mended;
  return result;
}
}

TEST(AssembleContours, MendingChangesNothingThatNeedsNothing)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(seed);
    PieceSets sets = RandomLoops(seed);
    if (seed % 2 == 1)
    {
      SplitIntoSegments(sets, seed);
    }
    const Assembled plain = Assemble(sets);
    const Assembled mended = Mend(ToText(sets));
    EXPECT_TRUE(mended.Problems.empty());
    EXPECT_EQ(mended.Set.U, plain.Set.U);
    EXPECT_EQ(mended.Set.V, plain.Set.V);
    EXPECT_EQ(mended.Set.Offsets, plain.Set.Offsets);
    EXPECT_EQ(mended.Set.Cell, plain.Set.Cell);
    EXPECT_EQ(mended.Set.Coordinate, plain.Set.Coordinate);
  }
}

//----------------------------------------------------------------------------
TEST(AssembleContours, JunkIsLeftOutAndListed)
{
  const struct
  {
    const char* Text;
    ProblemKind Kind;
    double Size;
  } cases[] = { { "z=0 open: 5,5 6,5", ProblemKind::TooShort, 1.0 },
    { "z=0: 5,5 5,5 6,5", ProblemKind::TooShort, 1.0 },
    { "z=0: 5,5 6,6 8,8", ProblemKind::Flat, std::sqrt(18.0) },
    { "z=0: 5,5 6,5 6,7 6,5", ProblemKind::Flat, 5.0 },
    { "z=0: 5,5 6,5 6,7 6,5 5,5 4,2", ProblemKind::Flat, 6.0 + std::sqrt(10.0) },
    { "z=0: 5,5 nan,5 6,6", ProblemKind::NotFinite, 0.0 },
    { "z=0: 5,5 6,5,0.5 6,6", ProblemKind::OffPlane, 0.5 },
    { "z=0 open: 5,5 6,5 7,5 8,5", ProblemKind::Open, 3.0 } };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.Text);
    const Assembled result =
      Mend("z=0: 0,0 1,0 1,1; " + std::string(one.Text) + "; z=1: 0,0 1,0 1,1");
    EXPECT_EQ(result.Set.Count(), 2);
    ASSERT_EQ(result.Problems.size(), 1u);
    EXPECT_EQ(result.Problems[0].Kind, one.Kind);
    EXPECT_EQ(result.Problems[0].Cell, 1);
    EXPECT_TRUE(result.Problems[0].IsLeftOut);
    EXPECT_NEAR(result.Problems[0].Size, one.Size, 1e-12);
  }
}

//----------------------------------------------------------------------------
TEST(AssembleContours, LoopsWithZeroSignedAreaAreNotFlat)
{
  // A figure eight, and two squares that touch in a corner.
  const Assembled result = Mend("z=0: 0,0 2,2 2,0 0,2; z=1: 0,0 1,0 1,1 2,1 2,2 1,2 1,1 0,1");
  EXPECT_EQ(result.Set.Count(), 2);
  EXPECT_TRUE(result.Problems.empty());
}

//----------------------------------------------------------------------------
TEST(AssembleContours, FigureEightsThatDoNotRepeatTheirFirstPointAreNoOverruns)
{
  const Assembled result = Mend("z=0 open: 0,0 2,2 2,0 0,2; z=1 open: 0,0 2,2 2,0 0,2");
  ASSERT_EQ(result.Set.Count(), 2);
  EXPECT_EQ(result.Set.Size(0), 4);
  EXPECT_TRUE(result.Problems.empty());
  // A square that runs on by a tenth of its sides is one.
  const Assembled square = Mend("z=0 open: 0,0 2,0 2,2 0,2 0,-0.2; z=1 open: 0,0 2,0 2,2 0,2");
  EXPECT_EQ(square.Set.Count(), 2);
  EXPECT_EQ(square.Set.Size(1), 4);
  ASSERT_EQ(square.Problems.size(), 1u);
  EXPECT_EQ(square.Problems[0].Kind, ProblemKind::OverrunTrimmed);
}

//----------------------------------------------------------------------------
TEST(AssembleContours, VerticesBesideTheirPlaneAreMovedAndReported)
{
  const Assembled result =
    Mend("z=0: 0,0 1,0,0.01 1,1,-0.02 0,1; z=1: 0,0 1,0 1,1; z=2: 0,0 1,0 1,1", 1e-4);
  ASSERT_EQ(result.Set.Count(), 3);
  EXPECT_EQ(result.Set.Size(0), 4);
  EXPECT_EQ(result.Set.Coordinate[0], 0.0);
  ASSERT_EQ(result.Problems.size(), 1u);
  EXPECT_EQ(result.Problems[0].Kind, ProblemKind::MovedOntoPlane);
  EXPECT_EQ(result.Problems[0].Size, 0.02);
  EXPECT_EQ(result.Problems[0].Where, (Point3{ 1.0, 1.0, -0.02 }));
  EXPECT_FALSE(result.Problems[0].IsLeftOut);
}

//----------------------------------------------------------------------------
TEST(AssembleContours, OpenCurvesBecomeContoursAfterAllOthers)
{
  const Assembled result =
    Mend("x=0 open: 0,0 4,0 4,4 0,4 0,3 0,2.5; x=0: 8,8 9,8 9,9; z=0: 0,0 1,0 1,1\n"
         "x=0 open: 20,0 24,0 24,4 20,4 20,0 21,0");
  ASSERT_EQ(result.Set.Count(), 4);
  EXPECT_EQ(result.Set.Cell, (std::vector<std::int64_t>{ 0, 1, 0, 2 }));
  EXPECT_EQ(result.Set.Axis, (std::vector<std::int8_t>{ 0, 0, 2, 0 }));
  EXPECT_EQ(Canonical(LoopOf(result.Set, 3)), (Loop{ { 20, 0 }, { 20, 4 }, { 24, 4 }, { 24, 0 } }));
  ASSERT_EQ(result.Problems.size(), 1u) << "the first lacks less than twice its longest segment";
  EXPECT_EQ(result.Problems[0].Kind, ProblemKind::OverrunTrimmed);
  EXPECT_EQ(result.Problems[0].Size, 1.0);
  EXPECT_EQ(result.Problems[0].Cell, 2);
}
