// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/CentralPoints.h"

#include "Core/Crossings/NodeNormals.h"
#include "Support/EvenSlices.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::vector<double> NormalsOf(const Stages& stages)
{
  return ComputeNodeNormals(stages.Set, stages.Grid, stages.Crossings, stages.Nodes, Execution());
}

std::vector<Point3> CentersOf(const Stages& stages, CentralPointMethod method)
{
  const std::vector<double> xyz =
    LocateCentralPoints(method, stages.Geometry(), NormalsOf(stages), Execution());
  std::vector<Point3> centers;
  for (std::size_t i = 0; i < xyz.size(); i += 3)
  {
    centers.push_back({ xyz[i], xyz[i + 1], xyz[i + 2] });
  }
  return centers;
}

Point3 CenterIn(const Stages& stages, CentralPointMethod method, const std::array<Index, 3>& cell)
{
  const auto at = std::find(stages.Cycles.Cell.begin(), stages.Cycles.Cell.end(), cell);
  return CentersOf(stages, method)[at - stages.Cycles.Cell.begin()];
}

void ExpectNear(const Point3& a, const Point3& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(a[axis], b[axis], 1e-9);
  }
}

/// Root of the mean squared distance of the central points to the solid.
double ErrorOf(const Stages& stages, const Solid& solid, CentralPointMethod method)
{
  double sum = 0.0;
  const std::vector<Point3> centers = CentersOf(stages, method);
  for (const Point3& center : centers)
  {
    sum += solid.Value(center) * solid.Value(center);
  }
  return std::sqrt(sum / static_cast<double>(centers.size()));
}
}

//----------------------------------------------------------------------------
TEST(CentralPoint, OfAPlanarPolygonIsItsCentroid)
{
  const Stages stages{ Cube() };
  for (const auto method : { CentralPointMethod::Centroid, CentralPointMethod::LeastSquares })
  {
    ExpectNear(CenterIn(stages, method, { 0, 1, 1 }), { 0.5, 1.5, 1.5 });
    ExpectNear(CenterIn(stages, method, { 1, 1, 2 }), { 1.5, 1.5, 2.5 });
  }
}

//----------------------------------------------------------------------------
TEST(CentralPoint, CentroidIsThatOfTheArcsByLength)
{
  const Stages stages{ Cube() };
  // At a corner: six segments of length 1/2. Each point stands for two half ones.
  ExpectNear(CenterIn(stages, CentralPointMethod::Centroid, { 0, 0, 0 }), { 0.75, 0.75, 0.75 });
  // Along the edge x = y = 0.5: two sides of length 1 at z = 1 and 2 over the corner (0.5, 0.5),
  // and two sides parallel to z from (0.5, 1) and (1, 0.5).
  ExpectNear(CenterIn(stages, CentralPointMethod::Centroid, { 0, 0, 1 }), { 0.6875, 0.6875, 1.5 });
}

//----------------------------------------------------------------------------
TEST(CentralPoint, LeastSquaresIsMuchNearerToACurvedSurface)
{
  for (const Solid& solid : { UnitBall(), TiltedTorus() })
  {
    const Stages stages(Slice(solid, 16));
    const double centroid = ErrorOf(stages, solid, CentralPointMethod::Centroid);
    const double squares = ErrorOf(stages, solid, CentralPointMethod::LeastSquares);
    EXPECT_LT(squares, 0.25 * centroid);
    EXPECT_GT(centroid, 1e-3);
  }
}

//----------------------------------------------------------------------------
/// With twice the planes the error falls at least eightfold, that of the centroid fourfold.
TEST(CentralPoint, LeastSquaresConvergesFaster)
{
  const Solid solid = UnitBall();
  const Stages coarse(Slice(solid, 10, 24)), fine(Slice(solid, 20, 24));
  EXPECT_GT(ErrorOf(coarse, solid, CentralPointMethod::LeastSquares),
    6.0 * ErrorOf(fine, solid, CentralPointMethod::LeastSquares));
  EXPECT_GT(ErrorOf(coarse, solid, CentralPointMethod::Centroid),
    3.0 * ErrorOf(fine, solid, CentralPointMethod::Centroid));
}

//----------------------------------------------------------------------------
TEST(CentralPoint, LiesInItsClosedCell)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Stages stages(RandomContradictoryInput(seed));
    SCOPED_TRACE(seed);
    for (const auto method : { CentralPointMethod::Centroid, CentralPointMethod::LeastSquares })
    {
      const std::vector<Point3> centers = CentersOf(stages, method);
      for (std::size_t i = 0; i < centers.size(); ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const double x = centers[i][axis];
          EXPECT_EQ(stages.Grid.Clamp(axis, stages.Cycles.Cell[i][axis], x), x);
        }
      }
    }
  }
}
