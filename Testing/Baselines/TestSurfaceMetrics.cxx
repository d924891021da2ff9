// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   SurfaceMetrics on surfaces whose figures can be worked out by hand
 */

#include "Baselines/ParametricMeshes.h"
#include "Support/NearestTriangle.h"
#include "Support/Vtk/SurfaceMetrics.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace orthoslices::support;
using orthoslices::baselines::MakeCapsule;
using orthoslices::baselines::MakeTorus;

namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

//------------------------------------------------------------------------------
Surface MakeSphere(double radius, double x = 0.0)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetCenter(x, 0.0, 0.0);
  sphere->SetThetaResolution(160);
  sphere->SetPhiResolution(160);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  return sphere->GetOutput();
}

//------------------------------------------------------------------------------
Surface MakeCube(double x, double y, double z)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(x, x + 1.0, y, y + 1.0, z, z + 1.0);
  cube->Update();
  return cube->GetOutput();
}

//------------------------------------------------------------------------------
Surface Together(const Surface& a, const Surface& b)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(a);
  both->AddInputData(b);
  both->Update();
  return both->GetOutput();
}

//------------------------------------------------------------------------------
// A copy without the first triangle, or with it turned round.
Surface SpoilFirst(const Surface& surface, bool turn)
{
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    surface->GetCellPoints(cell, ids);
    if (cell == 0 && turn)
    {
      const vtkIdType second = ids->GetId(1);
      ids->SetId(1, ids->GetId(2));
      ids->SetId(2, second);
    }
    if (cell > 0 || turn)
    {
      triangles->InsertNextCell(ids);
    }
  }
  auto spoilt = Surface::New();
  spoilt->SetPoints(surface->GetPoints());
  spoilt->SetPolys(triangles);
  return spoilt;
}

//------------------------------------------------------------------------------
// A unit square in the plane of height Z, facing up or down.
Surface MakeSquare(double z, bool up)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, z);
  points->InsertNextPoint(1.0, 0.0, z);
  points->InsertNextPoint(1.0, 1.0, z);
  points->InsertNextPoint(0.0, 1.0, z);
  const vtkIdType upward[4] = { 0, 1, 2, 3 };
  const vtkIdType downward[4] = { 3, 2, 1, 0 };
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(4, up ? upward : downward);
  auto square = Surface::New();
  square->SetPoints(points);
  square->SetPolys(polygons);
  return square;
}

} // anonymous namespace

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, ConcentricSpheresAreTheDifferenceOfRadiiApart)
{
  const auto deviation = MeasureDeviation(MakeSphere(1.0), MakeSphere(1.1), 20000);
  ASSERT_TRUE(deviation);
  EXPECT_NEAR(deviation->Mean, 0.1, 2e-4);
  EXPECT_NEAR(deviation->RootMeanSquare, 0.1, 2e-4);
  EXPECT_NEAR(deviation->Hausdorff, 0.1, 5e-4);
  EXPECT_LT(deviation->NormalDegrees, 1.0);
}

//------------------------------------------------------------------------------
// The distance of the point at angle t from the axis of translation is
// |sqrt(1 + 2 d cos t + d^2) - 1|; mean and mean square by quadrature, the largest is d.
TEST(SurfaceMetrics, TranslatedSphereAgreesWithQuadrature)
{
  const double shift = 0.25;
  double mean = 0.0;
  double square = 0.0;
  const int steps = 100000;
  for (int i = 0; i < steps; ++i)
  {
    const double cosine = -1.0 + 2.0 * (i + 0.5) / steps; // uniform on the sphere
    const double distance = std::abs(std::sqrt(1.0 + 2.0 * shift * cosine + shift * shift) - 1.0);
    mean += distance / steps;
    square += distance * distance / steps;
  }
  const auto deviation = MeasureDeviation(MakeSphere(1.0), MakeSphere(1.0, shift), 50000);
  ASSERT_TRUE(deviation);
  EXPECT_NEAR(deviation->Mean, mean, 3e-4);
  EXPECT_NEAR(deviation->RootMeanSquare, std::sqrt(square), 3e-4);
  EXPECT_NEAR(deviation->Hausdorff, shift, 1e-3);
}

//------------------------------------------------------------------------------
TEST(NearestTriangle, AgreesWithAllTrianglesOfASoup)
{
  std::vector<NearestTriangle::Triangle> soup;
  std::mt19937 random(7);
  const auto unit = [&random]() { return random() / 4294967296.0; };
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 a{ unit(), unit(), unit() };
    const Vector3 b{ unit(), unit(), unit() };
    soup.push_back({ a, b, i % 10 == 0 ? b : Vector3{ unit(), unit(), unit() } });
  }
  const NearestTriangle search(soup);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 position{ 3.0 * unit() - 1.0, 3.0 * unit() - 1.0, 3.0 * unit() - 1.0 };
    double least2 = 1e9;
    for (const NearestTriangle::Triangle& triangle : soup)
    {
      least2 = std::min(least2, NearestTriangle::Distance2(position, triangle));
    }
    EXPECT_EQ(search.Find(position).Distance, std::sqrt(least2));
  }
}

//------------------------------------------------------------------------------
// Triangle (0,0,0), (4,0,0), (0,3,0): one point for each feature that can be nearest.
TEST(NearestTriangle, DistancesFromFaceEdgesAndCorners)
{
  const NearestTriangle::Triangle triangle{ { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } } };
  EXPECT_DOUBLE_EQ(NearestTriangle::Distance2({ 1, 1, -2 }, triangle), 4);
  EXPECT_DOUBLE_EQ(NearestTriangle::Distance2({ 2, -1, 1 }, triangle), 2);
  EXPECT_DOUBLE_EQ(NearestTriangle::Distance2({ -2, 1, 0 }, triangle), 4);
  EXPECT_NEAR(NearestTriangle::Distance2({ 4, 3, 0 }, triangle), 2.4 * 2.4, 1e-12);
  EXPECT_DOUBLE_EQ(NearestTriangle::Distance2({ -3, -4, 0 }, triangle), 25);
  EXPECT_DOUBLE_EQ(NearestTriangle::Distance2({ 7, 0, 4 }, triangle), 25);
  EXPECT_DOUBLE_EQ(NearestTriangle::Distance2({ 0, 8, 0 }, triangle), 25);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, HausdorffLooksFromBothSides)
{
  const Surface near = MakeCube(0.0, 0.0, 0.0);
  const Surface both = Together(near, MakeCube(5.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(MeasureDeviation(near, both, 1000)->Hausdorff, 5.0);
  EXPECT_DOUBLE_EQ(MeasureDeviation(both, near, 1000)->Hausdorff, 5.0);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, NormalsOfOppositeFacesDifferBy180Degrees)
{
  EXPECT_NEAR(
    MeasureDeviation(MakeSquare(0, true), MakeSquare(1, false), 100)->NormalDegrees, 180, 1e-9);
  EXPECT_NEAR(
    MeasureDeviation(MakeSquare(0, true), MakeSquare(1, true), 100)->NormalDegrees, 0, 1e-9);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, MeasuringTwiceGivesTheSameNumbers)
{
  const Surface a = MakeSphere(1.0);
  const Surface b = MakeTorus({ 1.0, 2.0, 3.0 }, 0.9, 0.3, 40, 20);
  const auto first = MeasureDeviation(a, b, 5000);
  const auto second = MeasureDeviation(a, b, 5000);
  EXPECT_EQ(first->Mean, second->Mean);
  EXPECT_EQ(first->RootMeanSquare, second->RootMeanSquare);
  EXPECT_EQ(first->Hausdorff, second->Hausdorff);
  EXPECT_EQ(first->NormalDegrees, second->NormalDegrees);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, ScalingLeavesAnglesAlone)
{
  const Deviation scaled = Deviation{ 1.0, 2.0, 3.0, 4.0 }.ScaledBy(0.5);
  EXPECT_EQ(scaled.RootMeanSquare, 0.5);
  EXPECT_EQ(scaled.Mean, 1.0);
  EXPECT_EQ(scaled.Hausdorff, 1.5);
  EXPECT_EQ(scaled.NormalDegrees, 4.0);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, NothingHasNoDeviationAndNoGenus)
{
  const Surface empty = Surface::New();
  EXPECT_FALSE(MeasureDeviation(empty, MakeSphere(1.0)));
  EXPECT_FALSE(MeasureDeviation(MakeSphere(1.0), empty));
  const Topology topology = MeasureTopology(empty);
  EXPECT_FALSE(topology.IsWatertight());
  EXPECT_FALSE(topology.Genus);
  EXPECT_EQ(topology.Components, 0);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, CubeWithSeparateFacesIsClosed)
{
  const Surface cube = MakeCube(3.0, 4.0, 5.0);
  const Topology topology = MeasureTopology(cube);
  EXPECT_TRUE(topology.IsClosedManifold());
  EXPECT_EQ(topology.Points, 8);
  EXPECT_EQ(topology.Triangles, 12);
  EXPECT_EQ(topology.EulerCharacteristic, 2);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_DOUBLE_EQ(MeasureVolume(cube), 1.0);
  EXPECT_DOUBLE_EQ(MeasureArea(cube), 6.0);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, TorusHasGenusOneAndItsVolume)
{
  const Surface torus = MakeTorus({ 1.0, 1.0, 0.5 }, 1.0, 0.4, 200, 100);
  const Topology topology = MeasureTopology(torus);
  EXPECT_TRUE(topology.IsClosedManifold());
  EXPECT_EQ(topology.Components, 1);
  EXPECT_EQ(topology.Genus, 1);
  EXPECT_NEAR(MeasureVolume(torus) / (2.0 * vtkMath::Pi() * vtkMath::Pi() * 0.16), 1.0, 2e-3);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, GenusAddsUpOverComponents)
{
  const Surface a = MakeTorus({ 0.0, 0.0, 1.0 }, 1.0, 0.3, 30, 20);
  const Surface b = MakeTorus({ 0.0, 1.0, 0.0 }, 5.0, 0.3, 30, 20);
  const Topology topology = MeasureTopology(Together(a, b));
  EXPECT_EQ(topology.Components, 2);
  EXPECT_EQ(topology.Genus, 2);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, CapsuleHasItsVolume)
{
  const Surface capsule = MakeCapsule({ 0.0, 0.0, 0.0 }, { 1.0, 2.0, 2.0 }, 0.5, 200);
  EXPECT_TRUE(MeasureTopology(capsule).IsClosedManifold());
  EXPECT_EQ(MeasureTopology(capsule).Genus, 0);
  EXPECT_NEAR(
    MeasureVolume(capsule) / (vtkMath::Pi() * (0.25 * 3.0 + 4.0 / 3.0 * 0.125)), 1.0, 1e-3);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, MissingTriangleOpensThreeEdges)
{
  const Topology topology =
    MeasureTopology(SpoilFirst(MakeTorus({ 0.0, 0.0, 1.0 }, 1.0, 0.4, 30, 20), false));
  EXPECT_EQ(topology.OpenEdges, 3);
  EXPECT_FALSE(topology.IsWatertight());
  EXPECT_EQ(topology.Genus, 1) << "the hole is closed by a disc";
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, TurnedTriangleIsInconsistentAtThreeEdges)
{
  const Topology topology =
    MeasureTopology(SpoilFirst(MakeTorus({ 0.0, 0.0, 1.0 }, 1.0, 0.4, 30, 20), true));
  EXPECT_EQ(topology.InconsistentEdges, 3);
  EXPECT_TRUE(topology.IsWatertight());
  EXPECT_FALSE(topology.IsClosedManifold());
  EXPECT_FALSE(topology.Genus);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, CubesWithACommonEdgeAreNotManifoldThere)
{
  const Topology topology =
    MeasureTopology(Together(MakeCube(0.0, 0.0, 0.0), MakeCube(1.0, 1.0, 0.0)));
  EXPECT_EQ(topology.NonManifoldEdges, 1);
  EXPECT_EQ(topology.OpenEdges, 0);
  EXPECT_FALSE(topology.IsClosedManifold());
  EXPECT_FALSE(topology.Genus);
}

//------------------------------------------------------------------------------
TEST(SurfaceMetrics, CubesWithACommonCornerAreTwoComponents)
{
  const Topology topology =
    MeasureTopology(Together(MakeCube(0.0, 0.0, 0.0), MakeCube(1.0, 1.0, 1.0)));
  EXPECT_EQ(topology.NonManifoldVertices, 1);
  EXPECT_EQ(topology.NonManifoldEdges, 0);
  EXPECT_EQ(topology.Components, 2);
  EXPECT_EQ(topology.Genus, 0);
  EXPECT_FALSE(topology.IsClosedManifold());
}
