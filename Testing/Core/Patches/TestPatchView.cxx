// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/PatchView.h"

#include "Core/Base/Vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Count = 36;

/// A border from places and normals at equal angles.
template <typename At>
PatchBorder Border(const At& at)
{
  PatchBorder border;
  for (int i = 0; i < Count; ++i)
  {
    Point3 normal;
    border.Points.push_back(i);
    border.Places.push_back(at(2.0 * Pi * i / Count, normal));
    border.Normals.push_back(normal);
  }
  border.Center = WeighByLength(border.Places, border.Weights);
  return border;
}

/// A circle of this radius on the unit sphere, around the z-axis.
PatchBorder OnSphere(double radius)
{
  return Border(
    [radius](double t, Point3& normal)
    {
      normal = { radius * std::cos(t), radius * std::sin(t), std::sqrt(1.0 - radius * radius) };
      return normal;
    });
}

/// An ellipse in a tilted plane through (3, 2, 1).
const std::array<Point3, 3>& Frame()
{
  static const std::array<Point3, 3> frame = CompleteFrame(Unit({ 0.3, 0.5, 0.8 }));
  return frame;
}
PatchBorder OnPlane()
{
  return Border(
    [](double t, Point3& normal)
    {
      normal = Frame()[2];
      return Point3{ 3.0, 2.0, 1.0 } + 2.0 * std::cos(t) * Frame()[0] + std::sin(t) * Frame()[1];
    });
}

/// The fan around a point.
InnerPatch FanAround(const Point3& point)
{
  InnerPatch patch;
  patch.Points = { point };
  patch.Normals = { { 0.0, 0.0, 0.0 } };
  for (Index i = 0; i < Count; ++i)
  {
    patch.Triangles.push_back({ -1, i, (i + 1) % Count });
  }
  return patch;
}

void ExpectNear(const Point3& a, const Point3& b, double tolerance)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(a[axis], b[axis], tolerance);
  }
}
}

//----------------------------------------------------------------------------
TEST(PatchView, SeesAPlaneAlongItsNormal)
{
  const PatchBorder border = OnPlane();
  PatchView view;
  ASSERT_TRUE(view.Set(border));
  ExpectNear(view.ToWorld({ 0.0, 0.0, 0.0 }), { 3.0, 2.0, 1.0 }, 1e-12);
  for (const Point2& p : { Point2{ 0.0, 0.0 }, Point2{ 0.7, -0.4 } })
  {
    ExpectNear(view.LineAt(p), { 0.0, 0.0, 1.0 }, 1e-12);
    ExpectNear(view.DirectionToWorld(view.LineAt(p)), Frame()[2], 1e-12);
  }
  double radius2 = 0.0;
  for (int i = 0; i < Count; ++i)
  {
    radius2 += border.Weights[i] * SquaredDistance(border.Center, border.Places[i]);
    EXPECT_NEAR(view.Places()[i][2], 0.0, 1e-12);
    ExpectNear(view.Normals()[i], { 0.0, 0.0, 1.0 }, 1e-12);
    EXPECT_NEAR(view.Border()[i][0], view.Places()[i][0], 1e-12);
    EXPECT_NEAR(view.Border()[i][1], view.Places()[i][1], 1e-12);
  }
  EXPECT_NEAR(view.Radius(), std::sqrt(radius2), 1e-12);
  EXPECT_GT(SignedArea(view.Border()), 0.0); // counter-clockwise
}

//----------------------------------------------------------------------------
/// The lines go through the sphere's centre, the better the smaller the patch is.
TEST(PatchView, SeesASphereFromItsCentre)
{
  for (const double radius : { 0.1, 0.3, 0.5 })
  {
    const PatchBorder border = OnSphere(radius);
    PatchView view;
    ASSERT_TRUE(view.Set(border));
    EXPECT_NEAR(view.Radius(), radius, 1e-3 * radius + 1e-12);
    for (int i = 0; i < Count; ++i)
    {
      const Point3 line = Unit(view.DirectionToWorld(view.LineAt(view.Border()[i])));
      EXPECT_GT(Dot(line, border.Normals[i]), 1.0 - 0.2 * std::pow(radius, 6));
    }
  }
}

//----------------------------------------------------------------------------
/// Bent more than that, lines would cross near the patch: all places stay in front of their centre.
TEST(PatchView, KeepsTheCentreOfLinesAway)
{
  const PatchBorder saddle = Border(
    [](double t, Point3& normal)
    {
      normal = Unit({ std::cos(t), std::sin(t), 0.2 }); // as of a needle's tip
      return Point3{ std::cos(t), std::sin(t), -0.9 * std::cos(2.0 * t) };
    });
  PatchView view;
  ASSERT_TRUE(view.Set(saddle));
  for (int i = 0; i < Count; ++i)
  {
    const Point3 line = view.LineAt(view.Border()[i]);
    const double bend =
      std::hypot(line[0], line[1]) / std::hypot(view.Border()[i][0], view.Border()[i][1]);
    EXPECT_LE(bend, MaxBend + 1e-9);
    EXPECT_GE(1.0 + bend * view.Places()[i][2], MinDistanceFromCenter - 1e-9);
  }
}

//----------------------------------------------------------------------------
TEST(PatchView, LocalAndWorldAreInverse)
{
  for (const PatchBorder& border : { OnPlane(), OnSphere(0.4) })
  {
    PatchView view;
    ASSERT_TRUE(view.Set(border));
    for (int i = 0; i < Count; ++i)
    {
      const Point3 local = view.ToLocal(border.Places[i]);
      ExpectNear(local, view.Places()[i], 1e-14);
      ExpectNear(view.ToWorld(local), border.Places[i], 1e-14);
      ExpectNear(view.OnLine(view.Project(local), local[2]), local, 1e-14);
    }
  }
}

//----------------------------------------------------------------------------
TEST(PatchView, SeesAFanUnlessItsCentreLiesAside)
{
  const PatchBorder border = OnPlane();
  PatchView view;
  ASSERT_TRUE(view.Set(border));
  const Point3 center{ 3.0, 2.0, 1.0 };
  EXPECT_TRUE(view.SeesAll(FanAround(center)));
  EXPECT_TRUE(view.SeesAll(FanAround(center + 5.0 * Frame()[2])));
  EXPECT_TRUE(view.SeesAll(FanAround(center + 0.9 * Frame()[1])));
  EXPECT_FALSE(view.SeesAll(FanAround(center + 1.1 * Frame()[1])));
  InnerPatch turned = FanAround(center);
  std::swap(turned.Triangles[7][1], turned.Triangles[7][2]);
  EXPECT_FALSE(view.SeesAll(turned));
}

//----------------------------------------------------------------------------
/// Behind the centre of the lines everything is seen upside down.
TEST(PatchView, SeesNothingBehindTheCentreOfLines)
{
  PatchView view;
  ASSERT_TRUE(view.Set(OnSphere(0.5)));
  EXPECT_TRUE(view.SeesAll(FanAround({ 0.0, 0.0, 1.0 })));
  EXPECT_FALSE(view.SeesAll(FanAround({ 0.0, 0.0, -2.0 })));
}

//----------------------------------------------------------------------------
TEST(PatchView, ClampsHeightsToABox)
{
  const PatchBorder border = Border(
    [](double t, Point3& normal)
    {
      normal = { 0.0, 0.0, 1.0 };
      return Point3{ 2.0 * std::cos(t), 2.0 * std::sin(t), 0.0 };
    });
  PatchView view;
  ASSERT_TRUE(view.Set(border));
  Box3 box;
  box.Low = { -1.0, -1.0, -3.0 };
  box.High = { 1.0, 1.0, 1.0 };
  // Heights are in units of the radius, which is 2.
  EXPECT_NEAR(view.Clamp({ 0.0, 0.0 }, box, 9.0), 0.5, 1e-12);
  EXPECT_NEAR(view.Clamp({ 0.0, 0.0 }, box, -9.0), -1.5, 1e-12);
  EXPECT_EQ(view.Clamp({ 0.2, 0.1 }, box, 0.25), 0.25);
}

//----------------------------------------------------------------------------
TEST(PatchView, ThereIsNoneWithoutANormalOrAnExtent)
{
  PatchView view;
  EXPECT_FALSE(view.Set(Border(
    [](double t, Point3& normal)
    {
      normal = { std::cos(t), std::sin(t), 0.0 }; // all around
      return normal;
    })));
  EXPECT_FALSE(view.Set(Border(
    [](double, Point3& normal)
    {
      normal = { 0.0, 0.0, 1.0 };
      return Point3{ 1.0, 2.0, 3.0 };
    })));
}
