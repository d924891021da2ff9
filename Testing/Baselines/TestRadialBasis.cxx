// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   radial basis functions on values known by hand, and the surfaces they make of contours
 */

#include "Baselines/CaseFolder.h"
#include "Baselines/ContourSamples.h"
#include "Baselines/ParametricMeshes.h"
#include "Baselines/RadialBasis.h"
#include "Baselines/RadialBasisFunction.h"
#include "Support/Random.h"
#include "Support/Vtk/SurfaceMetrics.h"

#include "vtkAppendPolyData.h"
#include "vtkNew.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

constexpr RadialKernel Kernels[] = { RadialKernel::Biharmonic, RadialKernel::Triharmonic };

//------------------------------------------------------------------------------
// Positions in a box far from the origin.
std::vector<RadialConstraint> MakeConstraintsAtRandom(
  int count, double (*valueAt)(const std::array<double, 3>&))
{
  orthoslices::support::Random numbers(5);
  std::vector<RadialConstraint> constraints;
  for (int i = 0; i < count; ++i)
  {
    const std::array<double, 3> position{ 100.0 + numbers.Uniform(0.0, 30.0),
      numbers.Uniform(-10.0, 10.0), numbers.Uniform(0.0, 5.0) };
    constraints.push_back({ position, valueAt(position) });
  }
  return constraints;
}

//------------------------------------------------------------------------------
double Bumpy(const std::array<double, 3>& p)
{
  return std::sin(0.3 * p[0]) + std::cos(0.2 * p[1]) * p[2];
}

//------------------------------------------------------------------------------
double Linear(const std::array<double, 3>& p) { return 3.0 - 2.0 * p[0] + 0.5 * p[1] + p[2]; }

//------------------------------------------------------------------------------
Surface MakeBall(double radius, bool isCavity = false)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  if (!isCavity)
  {
    return sphere->GetOutput();
  }
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputConnection(sphere->GetOutputPort());
  reverse->Update();
  return reverse->GetOutput();
}

//------------------------------------------------------------------------------
void ExpectShape(const Surface& surface, std::int64_t components, std::int64_t genus)
{
  const Topology shape = MeasureTopology(surface);
  EXPECT_TRUE(shape.IsClosedManifold());
  EXPECT_EQ(shape.Components, components);
  EXPECT_EQ(shape.Genus, genus);
}

//------------------------------------------------------------------------------
SliceFamilies MakeSlice(int axis, std::vector<Loop> loops)
{
  SliceFamilies families;
  families[axis].push_back({ 2.0, std::move(loops) });
  OrientByNesting(families[axis].front());
  return families;
}

} // anonymous namespace

//------------------------------------------------------------------------------
TEST(RadialBasisFunction, TakesTheGivenValues)
{
  const std::vector<RadialConstraint> constraints = MakeConstraintsAtRandom(200, Bumpy);
  for (const RadialKernel kernel : Kernels)
  {
    const RadialBasisFunction function(constraints, kernel);
    for (const RadialConstraint& c : constraints)
    {
      EXPECT_NEAR(function.Evaluate(c.Position), c.Value, 1e-8);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RadialBasisFunction, LinearFunctionsAreReproducedEverywhere)
{
  for (const RadialKernel kernel : Kernels)
  {
    const RadialBasisFunction function(MakeConstraintsAtRandom(50, Linear), kernel);
    for (const std::array<double, 3>& far :
      { std::array<double, 3>{ 0, 0, 0 }, { 500, 3, -80 }, { 110, 1, 2 } })
    {
      EXPECT_NEAR(function.Evaluate(far), Linear(far), 1e-6);
    }
  }
}

//------------------------------------------------------------------------------
TEST(RadialBasisFunction, OpenSystemsAreRefused)
{
  std::vector<RadialConstraint> constraints = MakeConstraintsAtRandom(3, Linear);
  EXPECT_THROW(RadialBasisFunction(constraints, RadialKernel::Biharmonic), std::runtime_error);
  constraints = MakeConstraintsAtRandom(30, Linear);
  for (RadialConstraint& c : constraints)
  {
    c.Position[1] = 7.0;
  }
  EXPECT_THROW(RadialBasisFunction(constraints, RadialKernel::Triharmonic), std::runtime_error);
}

//------------------------------------------------------------------------------
TEST(RadialBasisFunction, GreedyFitStopsAtTheAccuracyOrTheNumber)
{
  const std::vector<RadialConstraint> constraints = MakeConstraintsAtRandom(1000, Bumpy);
  const auto worst = [&](std::size_t largest, double accuracy)
  {
    const RadialBasisFunction function =
      FitGreedily(constraints, RadialKernel::Triharmonic, largest, accuracy);
    double difference = 0.0;
    for (const RadialConstraint& c : constraints)
    {
      difference = std::max(difference, std::abs(function.Evaluate(c.Position) - c.Value));
    }
    return difference;
  };
  EXPECT_LT(worst(1000, 0.0), 1e-7);
  EXPECT_LT(worst(1000, 0.05), 0.05);
  EXPECT_GT(worst(1000, 0.05), 1e-7); // with fewer centres
  EXPECT_GT(worst(60, 0.05), 0.05);
}

//------------------------------------------------------------------------------
TEST(ContourSamples, LieEvenlyOnTheContourWithNormalsToTheInterior)
{
  const Loop outer{ { -4, -4 }, { 4, -4 }, { 4, 4 }, { -4, 4 } };
  const Loop hole{ { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    const SliceFamilies families = MakeSlice(axis, { outer, hole });
    EXPECT_DOUBLE_EQ(TotalLength(families), 40.0);
    const std::vector<ContourSample> samples = SampleContours(families, 0.5);
    ASSERT_EQ(samples.size(), 80u);
    for (const ContourSample& sample : samples)
    {
      const double u = sample.Position[(axis + 1) % 3];
      const double v = sample.Position[(axis + 2) % 3];
      const double radius = std::max(std::abs(u), std::abs(v));
      EXPECT_EQ(sample.Position[axis], 2.0);
      EXPECT_EQ(sample.Inwards[axis], 0.0);
      EXPECT_TRUE(std::abs(radius - 4.0) < 1e-12 || std::abs(radius - 1.0) < 1e-12) << radius;
      const double towardsAxis =
        -u * sample.Inwards[(axis + 1) % 3] - v * sample.Inwards[(axis + 2) % 3];
      EXPECT_EQ(towardsAxis > 0.0, radius > 2.0);
    }
  }
}

//------------------------------------------------------------------------------
// A plate thinner than the offset: the points inside stay on their own side of the middle.
TEST(ContourSamples, PointsOffTheSurfaceStayNearestToTheirOwn)
{
  const double thickness = 0.2;
  const Loop plate{ { 0, 0 }, { 10, 0 }, { 10, thickness }, { 0, thickness } };
  const std::vector<ContourSample> samples = SampleContours(MakeSlice(2, { plate }), 0.2);
  int inside = 0;
  for (const RadialConstraint& c : MakeConstraints(samples, 0.3))
  {
    if (c.Value > 0.0 && c.Position[0] > 1.0 && c.Position[0] < 9.0)
    {
      ++inside;
      EXPECT_LT(c.Value, thickness);
      EXPECT_LT(c.Position[1], thickness);
      EXPECT_GT(c.Position[1], 0.0);
    }
  }
  EXPECT_GE(inside, 40);
}

//------------------------------------------------------------------------------
TEST(RadialBasisMethod, BallFromThreeGreatCircles)
{
  const Surface ball = MakeBall(1.0);
  const Surface surface = RadialBasis(400, 40).Reconstruct(CutSurface(ball, { 1, 1, 1 }));
  ExpectShape(surface, 1, 0);
  EXPECT_LT(MeasureDeviation(surface, ball, 10000)->RootMeanSquare, 0.01);
}

//------------------------------------------------------------------------------
// The ends are free; where the slices are, the surface follows the contours.
TEST(RadialBasisMethod, BallFromAStackOnAnyAxis)
{
  const Surface ball = MakeBall(1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<int, 3> numbers{ 0, 0, 0 };
    numbers[axis] = 8;
    const Surface surface = RadialBasis(600, 40).Reconstruct(CutSurface(ball, numbers));
    ExpectShape(surface, 1, 0);
    EXPECT_LT(MeasureDeviation(surface, ball, 10000)->RootMeanSquare, 0.05);
  }
}

//------------------------------------------------------------------------------
TEST(RadialBasisMethod, CavityStaysClosedWithOneSliceAlongTheStack)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(MakeBall(1.0));
  both->AddInputData(MakeBall(0.5, true));
  both->Update();
  SliceSets slices = CutSurface(both->GetOutput(), { 1, 0, 7 });
  slices.Families[1] = nullptr;
  const Surface surface = RadialBasis(600, 40).Reconstruct(slices);
  ExpectShape(surface, 2, 0);
  EXPECT_LT(MeasureDeviation(surface, both->GetOutput(), 10000)->RootMeanSquare, 0.05);
}

//------------------------------------------------------------------------------
TEST(RadialBasisMethod, NoContoursMakeNoSurface)
{
  EXPECT_EQ(RadialBasis().Reconstruct(SliceSets())->GetNumberOfCells(), 0);
}
