// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/FieldSlices.h"

#include "Core/Base/EditContours.h"
#include "Support/SparseSolids.h"
#include "Support/Stages.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The contours of a solid as the first stages leave them, with the interior on the left.
struct Sliced
{
  Sliced(const Solid& solid, const std::array<int, 3>& count, double scale = 1.0)
  {
    PieceSets sets = SliceByFewPlanes(solid, EqualPlanes(solid, count));
    for (Pieces& set : sets)
    {
      for (std::vector<double>* values : { &set.U, &set.V, &set.W })
      {
        std::for_each(values->begin(), values->end(), [&](double& value) { value *= scale; });
      }
    }
    this->Set = UsableContours(sets, Options(), this->Grid);
    this->Loops = MapToWorld(this->Set, AxisFrame());
    this->Step = SampleStep(this->Loops, 0.05 * scale);
  }

  Contours Set;
  SpatialGrid Grid;
  std::vector<WorldLoop> Loops;
  double Step;

  SliceField Solve(const Execution& execution = Execution()) const
  {
    return SliceField(SampleLoops(this->Loops, this->Step), execution);
  }
};

/// Directions, evenly over all of them.
std::vector<Point3> Directions()
{
  std::vector<Point3> directions;
  constexpr int count = 200;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count, angle = 2.399963 * i;
    const double r = std::sqrt(1.0 - z * z);
    directions.push_back({ r * std::cos(angle), r * std::sin(angle), z });
  }
  return directions;
}

Contours Cut(const Sliced& sliced, const Execution& execution = Execution())
{
  const SliceDensity density(sliced.Grid, BoxOf(sliced.Set), 0.0, SparseRule::Field);
  return CutField(sliced.Solve(execution), sliced.Grid, density, execution);
}
}

//----------------------------------------------------------------------------
/// Three circles on each axis tell all of a ball, slopes of slices near its poles included.
TEST(SliceField, IsTheDistanceFromABall)
{
  const Point3 centre{ 0.02, -0.01, 0.01 }; // of radius 1
  const Sliced sliced(PlainBall(), { 3, 3, 3 });
  const SliceField field = sliced.Solve();
  ASSERT_TRUE(field.IsSolved());
  for (const Point3& direction : Directions())
  {
    EXPECT_NEAR(field.Value(centre + direction), 0.0, 0.015);
    EXPECT_LT(field.Distance(centre + direction), 0.015);
    // Nearby, about the distance: slopes are right at the contours, and even between them.
    EXPECT_NEAR(field.Value(centre + 0.9 * direction), 0.1, 0.02);
    EXPECT_NEAR(field.Value(centre + 1.1 * direction), -0.1, 0.02);
  }
}

//----------------------------------------------------------------------------
TEST(SliceField, IsZeroOnTheContoursOfAnySolid)
{
  for (const Solid& solid : AllSparseSolids())
  {
    SCOPED_TRACE(solid.Name);
    const Sliced sliced(solid, { 2, 2, 3 });
    const SliceField field = sliced.Solve();
    ASSERT_TRUE(field.IsSolved());
    for (const ContourSample& sample : SampleLoops(sliced.Loops, sliced.Step))
    {
      EXPECT_NEAR(field.Value(sample.Position), 0.0, 1e-6);
      EXPECT_GT(field.Value(sample.Position + 1e-3 * sample.Inwards), 0.0);
    }
  }
}

//----------------------------------------------------------------------------
TEST(SliceField, ScalesWithTheContours)
{
  const Sliced small(PlainBall(), { 2, 2, 2 }), large(PlainBall(), { 2, 2, 2 }, 1024.0);
  const SliceField fine = small.Solve();
  const SliceField coarse = large.Solve();
  for (const Point3& direction : Directions())
  {
    const Point3 place = 0.7 * direction;
    EXPECT_NEAR(coarse.Value(1024.0 * place), 1024.0 * fine.Value(place), 1e-6);
  }
}

//----------------------------------------------------------------------------
TEST(SliceField, OnePlaneDoesNotDetermineIt)
{
  const Sliced sliced(PlainBall(), { 0, 0, 1 });
  ASSERT_EQ(sliced.Set.Count(), 1);
  EXPECT_FALSE(sliced.Solve().IsSolved());
}

//----------------------------------------------------------------------------
/// Fields through some of the contours are the same whether or not others are solved with them.
TEST(SliceField, ThroughEachChoiceAsFromItAlone)
{
  const Sliced sliced(PlainBall(), { 3, 2, 2 });
  std::vector<std::vector<ContourSample>> choices;
  for (std::size_t leftOut = 0; leftOut < sliced.Loops.size(); ++leftOut)
  {
    std::vector<WorldLoop> loops = sliced.Loops;
    loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(leftOut));
    choices.push_back(SampleLoops(loops, 2.0 * sliced.Step));
  }
  choices.push_back(SampleLoops({ sliced.Loops.front() }, sliced.Step)); // in one plane
  const std::vector<SliceField> fields = SliceField::ThroughEach(choices, Execution());
  ASSERT_EQ(fields.size(), choices.size());
  EXPECT_FALSE(fields.back().IsSolved());
  for (std::size_t i = 0; i + 1 < choices.size(); ++i)
  {
    const SliceField alone(std::move(choices[i]), Execution());
    ASSERT_TRUE(alone.IsSolved() && fields[i].IsSolved());
    for (const Point3& direction : Directions())
    {
      EXPECT_NEAR(fields[i].Value(0.9 * direction), alone.Value(0.9 * direction), 1e-8);
    }
  }
}

//----------------------------------------------------------------------------
/// Enough for the smallest system to be of use, and not too many for the greatest.
TEST(SliceField, SamplesAreBetweenHundredsAndThousands)
{
  const Sliced sliced(PlainBall(), { 5, 5, 5 });
  const std::size_t fewest = SampleLoops(sliced.Loops, SampleStep(sliced.Loops, 100.0)).size();
  const std::size_t most = SampleLoops(sliced.Loops, SampleStep(sliced.Loops, 1e-6)).size();
  EXPECT_GE(fewest, 500u);
  EXPECT_GT(most, fewest);
  EXPECT_LE(most, 1700u);
}

//----------------------------------------------------------------------------
TEST(FieldSlices, ContoursOfABallAreCirclesWithTheInteriorOnTheLeft)
{
  const Solid ball = PlainBall();
  const Contours contours = Cut(Sliced(ball, { 3, 3, 3 }));
  std::array<int, 3> count{};
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    ++count[contours.Axis[contour]];
    EXPECT_TRUE(contours.IsVirtual(contour));
    EXPECT_GT(TwiceSignedArea(contours, contour), 0.0);
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      EXPECT_NEAR(ball.Value(contours.World(contour, i)), 0.0, 0.015);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_GE(count[axis], 6);
  }
}

//----------------------------------------------------------------------------
/// On the line where two virtual planes meet, the contours of both have the same vertices.
TEST(FieldSlices, ContoursMeetToTheLastBit)
{
  const Contours contours = Cut(Sliced(TorusAround(1, 0.3), { 3, 3, 3 }));
  std::array<std::set<double>, 3> planes;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    planes[contours.Axis[contour]].insert(contours.Coordinate[contour]);
  }
  for (int along = 0; along < 3; ++along)
  {
    std::array<std::set<Point3>, 2> met;
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      const int axis = contours.Axis[contour];
      const int other = 3 - axis - along;
      for (Index i = contours.Offsets[contour]; axis != along && i < contours.Offsets[contour + 1];
           ++i)
      {
        const Point3 place = contours.World(contour, i);
        if (planes[other].count(place[other]) > 0)
        {
          met[axis == FirstAxis(along) ? 0 : 1].insert(place);
        }
      }
    }
    EXPECT_GT(met[0].size(), 20u);
    EXPECT_EQ(met[0], met[1]);
  }
}

//----------------------------------------------------------------------------
TEST(FieldSlices, NothingLeavesTheBoundsOfTheGrid)
{
  for (const Solid& solid : AllSparseSolids())
  {
    SCOPED_TRACE(solid.Name);
    const Sliced sliced(solid, { 2, 3, 2 });
    const Contours contours = Cut(sliced);
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
      {
        const Point3 place = contours.World(contour, i);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_GT(place[axis], sliced.Grid.Lowest[axis]);
          EXPECT_LT(place[axis], sliced.Grid.Highest[axis]);
        }
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(FieldSlices, AreTheSameForAnyThreads)
{
  const Sliced sliced(TwoBalls(2, 0.2), { 2, 2, 3 });
  const Contours one = Cut(sliced), many = Cut(sliced, ManyThreads());
  EXPECT_EQ(one.U, many.U);
  EXPECT_EQ(one.V, many.V);
  EXPECT_EQ(one.Offsets, many.Offsets);
}
