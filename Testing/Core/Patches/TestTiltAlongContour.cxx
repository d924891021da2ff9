// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/TiltAlongContour.h"

#include "Core/Base/Vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double CornerAngle = 1.05;

/// The ellipsoid with the given half-axes, at the height of a slice across z.
struct Ellipsoid
{
  Point3 HalfAxes;
  double Height;

  Point3 Normal(const Point2& p) const
  {
    const Point3& h = this->HalfAxes;
    return Unit({ p[0] / h[0] / h[0], p[1] / h[1] / h[1], this->Height / h[2] / h[2] });
  }

  /// The contour with normals at every `every`-th point. Points are at equal angles.
  ContourRing Ring(int count, int every, double spacing) const
  {
    const Point3& h = this->HalfAxes;
    const double scale = std::sqrt(1.0 - this->Height * this->Height / h[2] / h[2]);
    ContourRing ring;
    ring.Axis = 2;
    ring.Spacing = spacing;
    std::vector<Point2> points;
    for (int i = 0; i < count; ++i)
    {
      const double t = 2.0 * Pi * i / count;
      points.push_back({ scale * h[0] * std::cos(t), scale * h[1] * std::sin(t) });
      const Point3 normal = this->Normal(points.back());
      const double length = std::hypot(normal[0], normal[1]);
      ring.Tangents.push_back(
        { static_cast<float>(-normal[1] / length), static_cast<float>(normal[0] / length) });
      const double known = i % every == 0 ? 1.0 : 0.0;
      ring.KnownNormals.push_back({ static_cast<float>(known * normal[0]),
        static_cast<float>(known * normal[1]), static_cast<float>(known * normal[2]) });
    }
    ring.Measured.Set(std::move(points), spacing, CornerAngle);
    return ring;
  }

  /// The greatest error of the tilt, in radians.
  double ErrorOf(const ContourRing& ring) const
  {
    TiltAlongContour tilt(ring);
    double greatest = 0.0;
    for (Index i = 0; i < ring.Measured.Curve.Count(); ++i)
    {
      const double expected = std::asin(this->Normal(ring.Measured.Curve[i])[2]);
      greatest = std::max(greatest, std::abs(tilt.At(i) - expected));
    }
    return greatest;
  }
};

/// A square with its corners at points 0, count, ...; of each side one normal is known, at a point
/// of it.
ContourRing Square(int count, const std::array<double, 4>& tilts, const std::array<int, 4>& known)
{
  ContourRing ring;
  ring.Axis = 2;
  ring.Spacing = 1.0;
  const double corners[5][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 }, { -1, -1 } };
  std::vector<Point2> points;
  for (int side = 0; side < 4; ++side)
  {
    const double u = 0.5 * (corners[side + 1][0] - corners[side][0]);
    const double v = 0.5 * (corners[side + 1][1] - corners[side][1]);
    for (int i = 0; i < count; ++i)
    {
      points.push_back(
        { corners[side][0] + 2.0 * u * i / count, corners[side][1] + 2.0 * v * i / count });
      ring.Tangents.push_back({ static_cast<float>(u), static_cast<float>(v) });
      const double c = i == known[side] ? std::cos(tilts[side]) : 0.0;
      const double s = i == known[side] ? std::sin(tilts[side]) : 0.0;
      ring.KnownNormals.push_back(
        { static_cast<float>(c * v), static_cast<float>(-c * u), static_cast<float>(s) });
    }
  }
  ring.Measured.Set(std::move(points), ring.Spacing, CornerAngle);
  return ring;
}

/// Multiplies the normals by this.
void Shorten(double factor, ContourRing& ring)
{
  for (std::array<float, 3>& normal : ring.KnownNormals)
  {
    for (float& x : normal)
    {
      x *= static_cast<float>(factor);
    }
  }
}
}

//----------------------------------------------------------------------------
/// All normals of a sphere along a slice have the same tilt, above its middle and below.
TEST(TiltAlongContour, OfASphereIsThatOfItsLatitude)
{
  for (const double height : { -0.8, -0.3, 0.0, 0.4, 0.9 })
  {
    const Ellipsoid sphere{ { 1.0, 1.0, 1.0 }, height };
    EXPECT_LT(sphere.ErrorOf(sphere.Ring(96, 8, 0.2)), 1e-5) << height;
  }
}

//----------------------------------------------------------------------------
TEST(TiltAlongContour, ConvergesWithTheThirdPowerOfTheDistanceOfNodePoints)
{
  const Ellipsoid ellipsoid{ { 1.4, 1.0, 1.2 }, 0.4 };
  const double coarse = ellipsoid.ErrorOf(ellipsoid.Ring(480, 24, 0.3));
  const double fine = ellipsoid.ErrorOf(ellipsoid.Ring(480, 12, 0.15));
  EXPECT_LT(coarse, 0.01);
  EXPECT_GT(coarse, 7.0 * fine);
  EXPECT_GT(fine, 1e-6);
}

//----------------------------------------------------------------------------
/// Near the top of a flat, long ellipsoid the contour turns sharply at its ends, and the tilt
/// changes as fast there; the height over the slice does not.
TEST(TiltAlongContour, OfANearlyParallelSurfaceFollowsItsHeight)
{
  const Ellipsoid ellipsoid{ { 2.0, 0.7, 0.5 }, 0.42 };
  ContourRing ring = ellipsoid.Ring(240, 20, 0.4);
  ASSERT_TRUE(ring.Measured.Curve.IsExact());
  const double fitted = ellipsoid.ErrorOf(ring);
  ring.Measured.Curve.SetExact(false); // then tilts are interpolated
  const double interpolated = ellipsoid.ErrorOf(ring);
  EXPECT_LT(fitted, 0.02);
  EXPECT_GT(interpolated, 3.0 * fitted);
}

//----------------------------------------------------------------------------
/// Wherever the normals are known: near the corners, or far from them.
TEST(TiltAlongContour, IsNotInterpolatedAcrossCorners)
{
  const std::array<double, 4> tilts{ 0.3, -0.2, 0.0, 0.7 };
  const int count = 20;
  for (const std::array<int, 4>& known :
    { std::array{ 10, 10, 10, 10 }, std::array{ 2, 3, 16, 10 }, std::array{ 17, 1, 10, 19 } })
  {
    const ContourRing ring = Square(count, tilts, known);
    TiltAlongContour tilt(ring);
    for (Index i = 0; i < ring.Measured.Curve.Count(); ++i)
    {
      ASSERT_EQ(ring.Measured.Curve.IsCorner(i), i % count == 0);
      const double found = tilt.At(i);
      if (i % count != 0)
      {
        EXPECT_NEAR(found, tilts[i / count], 1e-6) << i;
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(TiltAlongContour, IsZeroWhereNothingIsKnown)
{
  const Ellipsoid sphere{ { 1.0, 1.0, 1.0 }, 0.5 };
  ContourRing ring = sphere.Ring(60, 5, 0.3);
  Shorten(0.0, ring);
  TiltAlongContour tilt(ring);
  EXPECT_FALSE(tilt.IsKnown());
  for (Index i = 0; i < 60; ++i)
  {
    EXPECT_EQ(tilt.At(i), 0.0);
  }
}

//----------------------------------------------------------------------------
TEST(TiltAlongContour, ContoursThatRunAlongEachOtherGiveNoNormal)
{
  const Ellipsoid sphere{ { 1.0, 1.0, 1.0 }, 0.5 };
  for (const double factor : { 0.99, 1.01 })
  {
    ContourRing ring = sphere.Ring(60, 5, 0.3);
    Shorten(factor * MinSine, ring);
    EXPECT_EQ(TiltAlongContour(ring).IsKnown(), factor > 1.0);
  }
}

//----------------------------------------------------------------------------
/// Of two node points close together, the one where the contours cross at a greater angle counts;
/// also where the ring begins.
TEST(TiltAlongContour, TakesTheBetterOfNodePointsCloseTogether)
{
  const Ellipsoid sphere{ { 1.0, 1.0, 1.0 }, 0.5 };
  const Index count = 480;
  const double spacing = 0.3, step = 2.0 * Pi * std::sqrt(0.75) / count;
  const Index near = static_cast<Index>(MergedNodes * spacing / step) - 1;
  for (const Index node : { 80, 0 })
  {
    for (const Index shift : { near, -near })
    {
      ContourRing ring = sphere.Ring(count, 40, spacing);
      const auto place = [&](Index times) { return (node + times * shift + count) % count; };
      const std::array<float, 2>& tangent = ring.Tangents[place(1)];
      ring.KnownNormals[place(1)] = { 0.5f * tangent[1], -0.5f * tangent[0], 0.0f };
      EXPECT_LT(sphere.ErrorOf(ring), 1e-4) << node << ", " << shift;
      // Far enough away it counts.
      ring.KnownNormals[place(2)] = ring.KnownNormals[place(1)];
      EXPECT_GT(sphere.ErrorOf(ring), 0.1) << node << ", " << shift;
    }
  }
}

//----------------------------------------------------------------------------
TEST(TiltAlongContour, OfOneNodePointIsTheSameEverywhere)
{
  const Ellipsoid sphere{ { 1.0, 1.0, 1.0 }, -0.6 };
  EXPECT_LT(sphere.ErrorOf(sphere.Ring(60, 60, 0.3)), 1e-6);
}
