// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LogisticRegression.h"
#include "PartsInCells.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <set>

using namespace orthoslices;
using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{
/// The surface of a box, of 12 triangles.
TriangleSurface Box(const Point3& low, const Point3& high)
{
  TriangleSurface surface;
  for (int corner = 0; corner < 8; ++corner)
  {
    surface.Points.push_back({ (corner & 1) != 0 ? high[0] : low[0],
      (corner & 2) != 0 ? high[1] : low[1], (corner & 4) != 0 ? high[2] : low[2] });
  }
  surface.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  EXPECT_EQ(CloseSurface(surface).Kind, SurfaceProblemKind::None);
  return surface;
}

/// Parts of the surface in a cell, of all triangles that have one of many points in it.
std::size_t CountParts(
  const TriangleSurface& surface, const SpatialGrid& grid, const std::array<Index, 3>& cell)
{
  PartsInCells parts(surface, grid);
  std::set<Index> found;
  constexpr int steps = 60;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const auto& corners = surface.Triangles[t];
    bool meets = false;
    for (int i = 1; i < steps && !meets; ++i)
    {
      for (int j = 1; i + j < steps && !meets; ++j)
      {
        meets = true;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double x =
            (i * surface.Points[corners[0]][axis] + j * surface.Points[corners[1]][axis] +
              (steps - i - j) * surface.Points[corners[2]][axis]) /
            steps;
          meets = meets && grid.Slab(axis, x) == cell[axis];
        }
      }
    }
    if (meets)
    {
      found.insert(parts.PartOf(static_cast<Index>(t), cell));
    }
  }
  return found.size();
}
}

//----------------------------------------------------------------------------
/// With a constant and one feature that is 0 or 1 the weights are logarithms of observed odds, and
/// their variances sums of reciprocal counts.
TEST(LogisticRegression, OddsOfTwoGroups)
{
  std::vector<Observation<2>> observations;
  const auto add = [&](double feature, bool outcome, int count) {
    observations.insert(observations.end(), count, { { 1.0, feature }, outcome });
  };
  add(0.0, true, 10);
  add(0.0, false, 30);
  add(1.0, true, 24);
  add(1.0, false, 6);
  const LogisticModel<2> model = FitLogistic(observations);
  ASSERT_TRUE(model.Converged);
  EXPECT_NEAR(model.Weights[0], std::log(10.0 / 30.0), 1e-12);
  EXPECT_NEAR(model.Weights[1], std::log(24.0 / 6.0) - std::log(10.0 / 30.0), 1e-12);
  EXPECT_NEAR(model.Errors[0], std::sqrt(1.0 / 10.0 + 1.0 / 30.0), 1e-9);
  EXPECT_NEAR(model.Errors[1], std::sqrt(1.0 / 10.0 + 1.0 / 30.0 + 1.0 / 24.0 + 1.0 / 6.0), 1e-9);
}

//----------------------------------------------------------------------------
TEST(LogisticRegression, FindsTheWeightsThatMadeTheData)
{
  const std::array<double, 3> truth{ -0.5, 2.0, -1.5 };
  Random random(5);
  std::vector<Observation<3>> observations;
  for (int i = 0; i < 20000; ++i)
  {
    const std::array<double, 3> features{ 1.0, random.Uniform(-1.0, 1.0),
      random.Uniform(0.0, 2.0) };
    const double p = 1.0 / (1.0 + std::exp(-LogOdds<3>(truth, features)));
    observations.push_back({ features, random.Chance(p) });
  }
  const LogisticModel<3> model = FitLogistic(observations);
  ASSERT_TRUE(model.Converged);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(model.Weights[i], truth[i], 4.0 * model.Errors[i]);
    EXPECT_LT(model.Errors[i], 0.1);
  }
}

//----------------------------------------------------------------------------
TEST(LogisticRegression, SaysWhatHasNoWeights)
{
  // The feature decides.
  EXPECT_FALSE(
    FitLogistic<2>({ { { 1.0, 0.0 }, false }, { { 1.0, 1.0 }, true }, { { 1.0, 2.0 }, true } })
      .Converged);
  // Two features are the same.
  EXPECT_FALSE(
    FitLogistic<2>({ { { 1.0, 1.0 }, false }, { { 1.0, 1.0 }, true }, { { 1.0, 1.0 }, true } })
      .Converged);
}

//----------------------------------------------------------------------------
/// A beam along x: planes across it leave rings, planes along it sheets.
TEST(PartsInCells, BeamCutByPlanes)
{
  const TriangleSurface beam = Box({ 0.0, 0.0, 0.0 }, { 9.0, 1.0, 1.0 });
  SpatialGrid grid;
  grid.Planes = { { { 3.1, 6.2 }, { 0.3, 0.7 }, {} } };
  // Between the planes of y only the sheets below and above are left; at the ends they are joined.
  EXPECT_EQ(CountParts(beam, grid, { 1, 1, 0 }), 2u);
  EXPECT_EQ(CountParts(beam, grid, { 0, 1, 0 }), 1u);
  EXPECT_EQ(CountParts(beam, grid, { 2, 1, 0 }), 1u);
  EXPECT_EQ(CountParts(beam, grid, { 1, 0, 0 }), 1u);
  grid.Planes[1].clear();
  EXPECT_EQ(CountParts(beam, grid, { 1, 0, 0 }), 1u);
  grid.Planes[2] = { 0.3, 0.7 };
  EXPECT_EQ(CountParts(beam, grid, { 1, 0, 1 }), 2u);
}
