// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/MissingContours.h"

#include "Core/Base/EditContours.h"
#include "Core/Planar/UncrossCurves.h"
#include "Core/Reconstruct.h"
#include "Core/Sparse/InterpolatePolygon.h"
#include "Support/CheckEmbedding.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr int Axis = 2;

/// A regular polygon of 24 corners.
std::vector<std::array<double, 2>> Circle(double u, double v, double radius)
{
  constexpr double pi = 3.14159265358979323846;
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i < 24; ++i)
  {
    const double angle = (i + 0.25) * pi / 12.0;
    points.push_back({ u + radius * std::cos(angle), v + radius * std::sin(angle) });
  }
  return points;
}

void AddCircle(PieceSets& sets, int axis, double plane, double u, double v, double radius)
{
  AddPiece(sets[axis], Circle(u, v, radius), plane);
}

/// A leg on planes 0 to 7, and one beside it without those listed. It leans by 0.2 per slice.
PieceSets TwoLegs(const std::vector<int>& missing)
{
  PieceSets sets = EmptySets();
  for (int plane = 0; plane < 8; ++plane)
  {
    AddCircle(sets, Axis, plane, -5.0, 0.0, 2.0);
    if (std::find(missing.begin(), missing.end(), plane) == missing.end())
    {
      AddCircle(sets, Axis, plane, 5.0 + 0.2 * plane, 0.0, 2.0);
    }
  }
  return sets;
}

MissingContours Find(const PieceSets& sets)
{
  SpatialGrid grid;
  const Contours contours = UsableContours(sets, Options(), grid);
  return FindMissingContours(contours, grid);
}

std::vector<Point2> VerticesOf(const Contours& contours, Index contour)
{
  std::vector<Point2> points;
  for (Index v = contours.Offsets[contour]; v < contours.Offsets[contour + 1]; ++v)
  {
    points.push_back({ contours.U[v], contours.V[v] });
  }
  return points;
}
}

//----------------------------------------------------------------------------
TEST(MissingContours, NoneWhereAllAreThere) { EXPECT_EQ(Find(TwoLegs({})).Found.Count(), 0); }

//----------------------------------------------------------------------------
TEST(MissingContours, OneBetweenItsNeighbours)
{
  const MissingContours missing = Find(TwoLegs({ 3 }));
  ASSERT_EQ(missing.Found.Count(), 1);
  EXPECT_EQ(missing.Found.Axis[0], Axis);
  EXPECT_EQ(missing.Found.Plane[0], 3);
  EXPECT_EQ(missing.Found.Coordinate[0], 3.0);
  EXPECT_EQ(missing.Found.Cell[0], -1);
  EXPECT_GT(TwiceSignedArea(missing.Found, 0), 0.0);
  for (const Point2& p : VerticesOf(missing.Found, 0))
  {
    EXPECT_NEAR(std::hypot(p[0] - 5.6, p[1]), 2.0, 0.03); // the polygon is not quite a circle
  }
  ASSERT_EQ(missing.Repairs.size(), 1u);
  EXPECT_EQ(missing.Repairs[0].Kind, RepairKind::ContourInserted);
  EXPECT_EQ(missing.Repairs[0].Plane, 3);
  EXPECT_NEAR(missing.Repairs[0].Where[0], 5.6, 1e-6);
  EXPECT_NEAR(missing.Repairs[0].Size, 12.5, 0.1);
}

//----------------------------------------------------------------------------
TEST(MissingContours, TwoInARowAndNoMore)
{
  EXPECT_EQ(Find(TwoLegs({ 3, 4 })).Found.Plane, (std::vector<Index>{ 3, 4 }));
  EXPECT_EQ(Find(TwoLegs({ 3, 4, 5 })).Found.Count(), 0);
  EXPECT_EQ(Find(TwoLegs({ 2, 5 })).Found.Plane, (std::vector<Index>{ 2, 5 }));
}

//----------------------------------------------------------------------------
TEST(MissingContours, PartsThatEndStayApart)
{
  EXPECT_EQ(Find(TwoLegs({ 0, 1 })).Found.Count(), 0); // the end of the stack
  PieceSets balls = EmptySets(), domes = EmptySets();
  for (int plane = 0; plane < 9; ++plane)
  {
    for (PieceSets* sets : { &balls, &domes })
    {
      AddCircle(*sets, Axis, plane, -5.0, 0.0, 2.0);
    }
    const double height = plane < 4 ? plane - 1.5 : plane - 6.5; // two balls of radius 2
    if (plane != 4)
    {
      AddCircle(balls, Axis, plane, 5.0, 0.0, std::sqrt(4.0 - height * height));
      // One that ends in a dome, and one that ends flat.
      AddCircle(domes, Axis, plane, 5.0, 0.0, plane > 4 ? 2.0 : std::sqrt(17.0 - plane * plane));
    }
  }
  EXPECT_EQ(Find(balls).Found.Count(), 0);
  EXPECT_EQ(Find(domes).Found.Count(), 0);
}

//----------------------------------------------------------------------------
TEST(MissingContours, NothingIsDrawnAcrossOthers)
{
  for (const bool inTheWay : { false, true })
  {
    PieceSets sets = EmptySets();
    for (const int plane : { 0, 1, 2, 4, 5, 6 })
    {
      AddCircle(sets, Axis, plane, 1.6 * plane, 0.0, 2.0);
    }
    // Where the contour would be at its widest, but beside both of its neighbours.
    AddCircle(sets, Axis, 3.0, 4.8, inTheWay ? 2.0 : 3.0, 0.3);
    EXPECT_EQ(Find(sets).Found.Count(), inTheWay ? 0 : 1);
  }
}

//----------------------------------------------------------------------------
/// Outer contours and holes, whatever their order.
TEST(MissingContours, WallsStayWalls)
{
  PieceSets sets = TwoLegs({ 3 });
  for (const int plane : { 0, 1, 2, 4, 5, 6, 7 })
  {
    AddCircle(sets, Axis, plane, 5.0 + 0.2 * plane, 0.0, 1.0);
  }
  const MissingContours missing = Find(sets);
  ASSERT_EQ(missing.Found.Count(), 2);
  EXPECT_GT(TwiceSignedArea(missing.Found, 0), 0.0);
  EXPECT_LT(TwiceSignedArea(missing.Found, 1), 0.0);
}

//----------------------------------------------------------------------------
/// A slice of another family through the gap decides.
TEST(MissingContours, OtherFamiliesHaveASay)
{
  for (const bool gap : { false, true })
  {
    PieceSets sets = TwoLegs({ 3 });
    const double height = gap ? 2.5 : 7.5;
    AddPiece(sets[0], { { -1.9, -0.5 }, { 1.9, -0.5 }, { 1.9, height }, { -1.9, height } }, 5.5);
    EXPECT_EQ(Find(sets).Found.Count(), gap ? 0 : 1);
  }
  PieceSets elsewhere = TwoLegs({ 3 });
  AddPiece(elsewhere[0], { { -1.9, -0.5 }, { 1.9, -0.5 }, { 1.9, 7.5 }, { -1.9, 7.5 } }, -5.0);
  EXPECT_EQ(Find(elsewhere).Found.Count(), 0) << "nothing is known there";
}

//----------------------------------------------------------------------------
TEST(MissingContours, AreReportedAndCanBeTurnedOff)
{
  Options options;
  const Reconstruction whole = Reconstruct(TwoLegs({ 3 }), options, Execution());
  EXPECT_EQ(whole.Topology.Components, 2);
  EXPECT_EQ(DescribeFlaws(MeshOf(whole)), "");
  ASSERT_EQ(whole.Repairs.size(), 1u);
  EXPECT_EQ(whole.Repairs[0].Kind, RepairKind::ContourInserted);
  options.InsertMissing = false;
  const Reconstruction drawn = Reconstruct(TwoLegs({ 3 }), options, Execution());
  EXPECT_TRUE(drawn.Repairs.empty());
  EXPECT_EQ(drawn.Members.Cell.size() + 1, whole.Members.Cell.size());
}

//----------------------------------------------------------------------------
TEST(InterpolatePolygon, IsThatOfItsEndsAtBothEnds)
{
  const std::vector<Point2> square{ { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 4.0 }, { 0.0, 4.0 } };
  const std::vector<Point2> turned{ { 14.0, 6.0 }, { 10.0, 6.0 }, { 10.0, 2.0 }, { 14.0, 2.0 } };
  const SpatialGrid grid;
  const std::vector<Point2> first = InterpolatePolygon(grid, square, turned, 0.0);
  const std::vector<Point2> half = InterpolatePolygon(grid, square, turned, 0.5);
  ASSERT_EQ(first.size(), 16u);
  ASSERT_EQ(half.size(), 16u);
  EXPECT_EQ(LengthOf(half), 16.0) << "corners come to corners";
  for (std::size_t i = 0; i < 16; ++i)
  {
    EXPECT_EQ(half[i], (Point2{ first[i][0] + 5.0, first[i][1] + 1.0 }));
  }
  EXPECT_EQ(MiddleOf(half), (Point2{ 7.0, 3.0 }));
}
