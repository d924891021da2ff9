// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
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
}

//----------------------------------------------------------------------------
TEST(NodeNormals, PointOutwardsAlongTheGradient)
{
  for (const Solid& solid : { UnitBall(), TiltedTorus() })
  {
    const Stages stages(Slice(solid, 14));
    const std::vector<double> normals = NormalsOf(stages);
    ASSERT_EQ(normals.size(), 3u * stages.Nodes.Count());
    double worst = 1.0;
    for (Index node = 0; node < stages.Nodes.Count(); ++node)
    {
      const double* n = &normals[3 * node];
      const double* p = &stages.Graph.Points[3 * node];
      const Point3 gradient = solid.Gradient({ p[0], p[1], p[2] });
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      EXPECT_LE(length, 1.0 + 1e-12); // the sine of the angle between the contours
      if (length > 0.1)
      {
        const double cosine =
          (n[0] * gradient[0] + n[1] * gradient[1] + n[2] * gradient[2]) / length;
        worst = std::min(worst, cosine);
      }
    }
    EXPECT_GT(worst, 0.98);
  }
}

//----------------------------------------------------------------------------
TEST(NodeNormals, OfTheCubeAreExact)
{
  const Stages stages{ Cube() };
  const std::vector<double> normals = NormalsOf(stages);
  for (Index node = 0; node < stages.Nodes.Count(); ++node)
  {
    const int axis = stages.EdgeOf(stages.Nodes.First[node]).Direction;
    const double side = stages.Graph.Points[3 * node + axis] < 1.5 ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(normals[3 * node + i], i == axis ? side : 0.0, 1e-12);
    }
  }
}
