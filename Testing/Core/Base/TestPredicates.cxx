// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Predicates.h"

#include "Support/CheckEmbedding.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A coordinate from a few places, moved by some of the last bits: almost everything coincides.
double NearlyInteger(Random& random)
{
  double x = static_cast<double>(random.Below(4)) + 0.1;
  for (std::size_t i = random.Below(3); i > 0; --i)
  {
    x = std::nextafter(x, random.Chance(0.5) ? 100.0 : -100.0);
  }
  return x;
}

Point2 RandomPoint2(Random& random) { return { NearlyInteger(random), NearlyInteger(random) }; }

Point3 RandomPoint3(Random& random)
{
  return { NearlyInteger(random), NearlyInteger(random), NearlyInteger(random) };
}

Point3 Lift(const Point2& p) { return { p[0], p[1], 0.0 }; }
}

//----------------------------------------------------------------------------
TEST(Predicates, SideOfIsExact)
{
  EXPECT_EQ(SideOf({ 0, 0 }, { 1, 0 }, { 0, 1 }), 1);
  EXPECT_EQ(SideOf({ 0, 0 }, { 1, 0 }, { 0, -1 }), -1);
  EXPECT_EQ(SideOf({ 0, 0 }, { 1, 0 }, { 7, 0 }), 0);
  Random random(1);
  int onLine = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Point2 p = RandomPoint2(random), q = RandomPoint2(random), r = RandomPoint2(random);
    const int side = SideOf(p, q, r);
    EXPECT_EQ(side, ExactTurn(Lift(p), Lift(q), Lift(r), 2));
    EXPECT_EQ(side, ExactSideOf(p, q, r));
    EXPECT_EQ(side, -SideOf(q, p, r));
    EXPECT_EQ(side, SideOf(q, r, p));
    onLine += side == 0 ? 1 : 0;
  }
  EXPECT_GT(onLine, 300);
}

//----------------------------------------------------------------------------
TEST(Predicates, SideOfSmallAndLargeNumbers)
{
  for (const double scale : { 1e-60, 1e-9, 1.0, 1e9, 1e60 })
  {
    const double e = std::nextafter(scale, HUGE_VAL);
    EXPECT_EQ(SideOf({ 0, 0 }, { scale, scale }, { scale, e }), 1);
    EXPECT_EQ(SideOf({ 0, 0 }, { scale, scale }, { e, scale }), -1);
    EXPECT_EQ(SideOf({ 0, 0 }, { scale, scale }, { e, e }), 0);
  }
}

//----------------------------------------------------------------------------
TEST(Predicates, CertainSideIsRightOrNotCertain)
{
  const Point3 a{ 0, 0, 0 }, b{ 1, 0, 0 }, c{ 0, 1, 0 };
  EXPECT_EQ(CertainSide(a, b, c, { 0, 0, 1 }), 1);
  EXPECT_EQ(CertainSide(a, b, c, { 0, 0, -1 }), -1);
  EXPECT_EQ(CertainSide(a, b, c, { 5, 5, 0 }), 0);
  Random random(3);
  int certain = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Point3 p = RandomPoint3(random), q = RandomPoint3(random), r = RandomPoint3(random),
                 s = RandomPoint3(random);
    const int side = CertainSide(p, q, r, s);
    if (side != 0)
    {
      EXPECT_EQ(side, -ExactOrientation(p, q, r, s));
      ++certain;
    }
  }
  EXPECT_GT(certain, 5000);
}

//----------------------------------------------------------------------------
namespace
{
using Corners = std::array<Point3, 3>;

bool DoMeet(const TriangleMesh& mesh)
{
  for (const Meeting& meeting : FindMeetings(mesh, 100))
  {
    if (meeting.First != meeting.Second)
    {
      return true;
    }
  }
  return false;
}

Corners CornersOf(const TriangleMesh& mesh, int t)
{
  const auto& ids = mesh.Triangles[t];
  return { mesh.Points[ids[0]], mesh.Points[ids[1]], mesh.Points[ids[2]] };
}
}

TEST(Predicates, TrianglesThatAreCertainlyApartDoNotMeet)
{
  Random random(4);
  int apart = 0;
  for (int i = 0; i < 20000; ++i)
  {
    TriangleMesh mesh;
    for (int p = 0; p < 6; ++p)
    {
      mesh.Points.push_back(RandomPoint3(random));
    }
    mesh.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
    if (CertainlyApart(CornersOf(mesh, 0), CornersOf(mesh, 1)))
    {
      EXPECT_FALSE(DoMeet(mesh));
      ++apart;
    }
  }
  EXPECT_GT(apart, 5000);
}

//----------------------------------------------------------------------------
TEST(Predicates, TrianglesWithSpaceBetweenAreCertainlyApart)
{
  Random random(5);
  for (int i = 0; i < 2000; ++i)
  {
    // On both sides of the plane x + y + z = 0.
    Corners s, t;
    for (int corner = 0; corner < 3; ++corner)
    {
      s[corner] = RandomPoint3(random);
      t[corner] = RandomPoint3(random);
      t[corner][random.Below(3)] -= 20.0;
    }
    EXPECT_TRUE(CertainlyApart(s, t));
    EXPECT_TRUE(CertainlyApart(t, s));
  }
}

//----------------------------------------------------------------------------
TEST(Predicates, TrianglesWithCommonCornersThatAreCertainlyApartBeyondDoNotMeet)
{
  Random random(6);
  std::array<int, 2> apart{ 0, 0 };
  for (int i = 0; i < 40000; ++i)
  {
    TriangleMesh mesh;
    for (int p = 0; p < 6; ++p)
    {
      mesh.Points.push_back(RandomPoint3(random));
    }
    const int common = 1 + static_cast<int>(random.Below(2));
    mesh.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
    std::vector<int> ofFirst, ofSecond;
    for (int c = 0; c < common; ++c)
    {
      ofFirst.push_back((i + c) % 3);
      ofSecond.push_back((i / 3 + 2 * c) % 3);
      mesh.Triangles[1][ofSecond.back()] = mesh.Triangles[0][ofFirst.back()];
    }
    if (!HasNoArea(CornersOf(mesh, 0)) && !HasNoArea(CornersOf(mesh, 1)) &&
      CertainlyApartBeyond(ofFirst, CornersOf(mesh, 0), ofSecond, CornersOf(mesh, 1)))
    {
      EXPECT_FALSE(DoMeet(mesh));
      ++apart[common - 1];
    }
  }
  for (const int count : apart)
  {
    EXPECT_GT(count, 1000);
  }
}

//----------------------------------------------------------------------------
TEST(Predicates, NoArea)
{
  EXPECT_TRUE(HasNoArea({ { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } } }));
  EXPECT_TRUE(HasNoArea({ { { 0, 0, 0 }, { 0, 0, 0 }, { 2, 4, 6 } } }));
  EXPECT_FALSE(HasNoArea({ { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, std::nextafter(6.0, 7.0) } } }));
}
