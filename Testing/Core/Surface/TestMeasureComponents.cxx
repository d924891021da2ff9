// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/MeasureComponents.h"

#include "Core/Base/Vectors.h"
#include "Support/ClosedMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// The components of a mesh, given the component of each triangle, moved and stretched.
template <typename Coordinate = double, typename Id = std::int32_t>
std::vector<ComponentMeasure> Measure(const PlainMesh& mesh, const std::vector<int>& components,
  int count, double scale = 1.0, const Point3& shift = { 0.0, 0.0, 0.0 })
{
  std::vector<Coordinate> points;
  std::vector<Id> ids;
  for (const Point3& point : mesh.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      points.push_back(static_cast<Coordinate>(scale * point[axis] + shift[axis]));
    }
  }
  for (const auto& triangle : mesh.Triangles)
  {
    ids.insert(ids.end(), triangle.begin(), triangle.end());
  }
  return MeasureComponents(points.data(), ids.data(),
    static_cast<std::int64_t>(mesh.Triangles.size()), components.data(), count);
}

/// The one component of a mesh.
ComponentMeasure MeasureAll(
  const PlainMesh& mesh, double scale = 1.0, const Point3& shift = { 0.0, 0.0, 0.0 })
{
  return Measure(mesh, std::vector<int>(mesh.Triangles.size(), 0), 1, scale, shift).front();
}

PlainMesh Reversed(PlainMesh mesh)
{
  for (auto& triangle : mesh.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

void ExpectPoint(const Point3& point, const Point3& expected, double tolerance)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(point[axis], expected[axis], tolerance) << "axis " << axis;
  }
}
}

TEST(MeasureComponents, Tetrahedron)
{
  PlainMesh corner;
  corner.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 }, { 0, 0, 4 } };
  corner.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  const ComponentMeasure measure = MeasureAll(corner);
  EXPECT_NEAR(measure.Volume, 4.0, 1e-14);
  EXPECT_NEAR(measure.Area, 3.0 + 4.0 + 6.0 + 0.5 * std::sqrt(36.0 + 64.0 + 144.0), 1e-14);
  ExpectPoint(measure.Centroid, { 0.5, 0.75, 1.0 }, 1e-14);
  EXPECT_EQ(measure.Triangles, 4);
}

/// The same digits wherever the component is: an origin of the world would cost seven of them.
TEST(MeasureComponents, FarFromTheOrigin)
{
  const PlainMesh mesh = OctahedronMesh();
  const double expected = MeasureAll(mesh).Volume;
  const Point3 shift{ 1e6, -2e6, 4e6 };
  const ComponentMeasure measure = MeasureAll(mesh, 1.0, shift);
  EXPECT_NEAR(measure.Volume, expected, 1e-12 * expected);
  ExpectPoint(measure.Centroid, shift, 1e-9);
}

TEST(MeasureComponents, ScalesWithTheUnit)
{
  const ComponentMeasure one = MeasureAll(TorusMesh(40, 20));
  const ComponentMeasure thousand = MeasureAll(TorusMesh(40, 20), 1000.0);
  EXPECT_NEAR(thousand.Volume, 1e9 * one.Volume, 1e-3 * one.Volume);
  EXPECT_NEAR(thousand.Area, 1e6 * one.Area, 1e-6 * one.Area);
}

/// A frustum of a regular polygon has volume and centroid in closed form.
TEST(MeasureComponents, Frustum)
{
  const Index segments = 24;
  const double low = 3.0, high = 1.0, height = 5.0;
  const PlainMesh mesh = RingMesh(segments, { low, high }, { 0.0, height }, 0.0, height);
  const double polygon = 0.5 * segments * std::sin(2.0 * Pi / segments);
  const ComponentMeasure measure = MeasureAll(mesh);
  const double volume = polygon * height / 3.0 * (low * low + low * high + high * high);
  EXPECT_NEAR(measure.Volume, volume, 1e-12 * volume);
  const double up = height / 4.0 * (low * low + 2.0 * low * high + 3.0 * high * high) /
    (low * low + low * high + high * high);
  ExpectPoint(measure.Centroid, { 0.0, 0.0, up }, 1e-12);
}

TEST(MeasureComponents, CavitiesAreNegativeAndAddUp)
{
  PlainMesh mesh = OctahedronMesh();
  const std::size_t outer = mesh.Triangles.size();
  PlainMesh cavity = Reversed(OctahedronMesh());
  for (Point3& point : cavity.Points)
  {
    point = 0.5 * point + Point3{ 0.1, 0.0, 0.0 };
  }
  mesh.Append(cavity);
  std::vector<int> components(mesh.Triangles.size(), 1);
  std::fill_n(components.begin(), outer, 0);
  const auto measures = Measure<float, long long>(mesh, components, 2);
  ASSERT_EQ(measures.size(), 2u);
  EXPECT_GT(measures[0].Volume, 0.0);
  EXPECT_NEAR(measures[1].Volume, -measures[0].Volume / 8.0, 1e-6);
  ExpectPoint(measures[1].Centroid, { 0.1, 0.0, 0.0 }, 1e-6);
}

TEST(MeasureComponents, OpenComponentsHaveNoVolume)
{
  PlainMesh mesh = OctahedronMesh();
  const double area = MeasureAll(mesh).Area;
  mesh.Triangles.pop_back();
  const ComponentMeasure open = MeasureAll(mesh);
  EXPECT_TRUE(std::isnan(open.Volume));
  EXPECT_NEAR(open.Area, area * 7.0 / 8.0, 1e-14 * area);
  EXPECT_TRUE(std::isfinite(open.Centroid[0]));
}

TEST(MeasureComponents, WithoutVolumeTheCentroidIsThatOfTheSurface)
{
  PlainMesh sheet;
  sheet.Points = { { 0, 0, 2 }, { 3, 0, 2 }, { 0, 3, 2 } };
  sheet.Triangles = { { 0, 1, 2 }, { 0, 2, 1 } };
  const ComponentMeasure measure = MeasureAll(sheet);
  EXPECT_EQ(measure.Volume, 0.0);
  ExpectPoint(measure.Centroid, { 1.0, 1.0, 2.0 }, 1e-14);
}

TEST(MeasureComponents, WithoutTriangles)
{
  EXPECT_TRUE(Measure(PlainMesh(), {}, 0).empty());
  const auto measures = Measure(OctahedronMesh(), std::vector<int>(8, -1), 1);
  ASSERT_EQ(measures.size(), 1u);
  EXPECT_EQ(measures[0].Area, 0.0);
  EXPECT_EQ(measures[0].Volume, 0.0);
}
