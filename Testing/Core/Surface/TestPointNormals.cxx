// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/PointNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace orthoslices;

namespace
{
/// A tetrahedron with a right angle in the origin, oriented outwards, and a point apart.
constexpr std::array<double, 15> Points{ 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1, 9, 9, 9 };
constexpr std::array<std::int32_t, 12> Triangles{ 0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3 };

template <typename Coordinate, typename Id>
std::array<float, 15> NormalsOf(const std::vector<float>& smooth)
{
  std::array<Coordinate, 15> points;
  std::copy(Points.begin(), Points.end(), points.begin());
  std::array<Id, 12> triangles;
  std::copy(Triangles.begin(), Triangles.end(), triangles.begin());
  std::array<float, 15> normals;
  normals.fill(7.0f); // whatever was there is overwritten
  ComputePointNormals(points.data(), 5, triangles.data(), 4, smooth, Execution(), normals.data());
  return normals;
}
}

//----------------------------------------------------------------------------
TEST(PointNormals, AreMeansWeightedByArea)
{
  const auto normals = NormalsOf<double, std::int32_t>({});
  // At the origin: areas of the three legs, 1 along -z, 0.5 along -x and 1 along -y.
  EXPECT_NEAR(normals[0], -0.5 / 1.5, 1e-6);
  EXPECT_NEAR(normals[1], -1.0 / 1.5, 1e-6);
  EXPECT_NEAR(normals[2], -1.0 / 1.5, 1e-6);
  // At the point on the x-axis the area vectors sum up to (0.5, 0, 0).
  EXPECT_NEAR(normals[3], 1.0, 1e-6);
  EXPECT_NEAR(normals[4], 0.0, 1e-6);
  EXPECT_NEAR(normals[5], 0.0, 1e-6);
  for (int k = 12; k < 15; ++k)
  {
    EXPECT_EQ(normals[k], 0.0f) << "a point without triangles";
  }
  EXPECT_EQ(normals, (NormalsOf<float, long long>({})));
  EXPECT_EQ(normals, (NormalsOf<double, long long>({})));
  EXPECT_EQ(normals, (NormalsOf<float, std::int32_t>({})));
}

//----------------------------------------------------------------------------
TEST(PointNormals, SmoothOnesAreTakenWithin30Degrees)
{
  const auto plain = NormalsOf<double, std::int32_t>({});
  for (const double degrees : { 29.0, 31.0 })
  {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    std::vector<float> smooth(15, 0.0f);
    smooth[3] = static_cast<float>(std::cos(angle));
    smooth[4] = static_cast<float>(-std::sin(angle)); // away from the next triangles' normals, too
    const auto normals = NormalsOf<double, std::int32_t>(smooth);
    EXPECT_EQ(normals[4], degrees < 30.0 ? smooth[4] : plain[4]);
    EXPECT_EQ(normals[0], plain[0]) << "zero stands for none";
  }
}
