// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the sampling condition: where slices are dense for the reach, the topology is right
 *
 * Core/Reconstruct.h states it. Random solids whose reach is known exactly, cut by planes at random
 * distances of which none is greater than the condition allows. ORTHOGONAL_SLICES_RUNS is the
 * number of solids of each kind.
 */

#include "Core/Base/Vectors.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Random.h"
#include "Support/RandomInput.h"
#include "Support/SliceSolid.h"
#include "Support/Vtk/PolyDataMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A solid with the least distance of its surface from its medial axis.
struct Sample
{
  Solid Shape;
  double Reach;
};

Point3 Direction(Random& random)
{
  Point3 p;
  do
  {
    p = { random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1) };
  } while (Length(p) > 1.0 || Length(p) < 0.1);
  return Unit(p);
}

Point3 NearOrigin(Random& random)
{
  return { random.Uniform(-0.05, 0.05), random.Uniform(-0.05, 0.05), random.Uniform(-0.05, 0.05) };
}

Sample RandomBall(Random& random)
{
  Sample sample;
  sample.Reach = random.Uniform(0.3, 1.0);
  sample.Shape.Tubes = { Ball(NearOrigin(random), sample.Reach) };
  sample.Shape.Components = 1;
  sample.Shape.Genus = 0;
  return sample;
}

Sample RandomTorus(Random& random)
{
  const double minor = random.Uniform(0.27, 0.35);
  const double major = 0.95 - minor;
  Sample sample;
  sample.Reach = std::min(minor, major - minor);
  sample.Shape.Tubes = { Torus(NearOrigin(random), Direction(random), major, minor) };
  sample.Shape.Components = 1;
  sample.Shape.Genus = 1;
  return sample;
}

Sample RandomCapsule(Random& random)
{
  const Point3 end = 0.9 * Direction(random);
  Sample sample;
  sample.Reach = random.Uniform(0.2, 0.3);
  sample.Shape.Tubes = { Capsule(-1.0 * end, end, sample.Reach) };
  sample.Shape.Components = 1;
  sample.Shape.Genus = 0;
  return sample;
}

/// Half the gap between them is less than their radius.
Sample RandomPairOfBalls(Random& random)
{
  constexpr double radius = 0.45;
  Sample sample;
  sample.Reach = random.Uniform(0.15, 0.25);
  const Point3 center = (radius + sample.Reach) * Direction(random);
  sample.Shape.Tubes = { Ball(center, radius), Ball(-1.0 * center, radius) };
  sample.Shape.Components = 2;
  sample.Shape.Genus = 0;
  return sample;
}

/// Its reach is the least radius of curvature, at the ends of the longest axis.
Sample RandomEllipsoid(Random& random)
{
  const Point3 center = NearOrigin(random);
  const std::array<double, 3> axes{ 1.0, random.Uniform(0.6, 1.0), random.Uniform(0.55, 0.6) };
  const Point3 u = Direction(random);
  const Point3 v = Unit(Cross(u, Direction(random)));
  const Point3 w = Cross(u, v);
  Sample sample;
  sample.Reach = axes[2] * axes[2] / axes[0];
  sample.Shape.Function = [=](const Point3& p)
  {
    const Point3 q = p - center;
    return std::hypot(Dot(q, u) / axes[0], Dot(q, v) / axes[1], Dot(q, w) / axes[2]) - 1.0;
  };
  sample.Shape.Components = 1;
  sample.Shape.Genus = 0;
  return sample;
}

/// All points about as far from a center: an outer surface and that of a cavity.
Sample RandomHollowBall(Random& random)
{
  const Point3 center = NearOrigin(random);
  const auto nearest = [center](const Point3& p)
  { return center + (0.75 / std::max(Length(p - center), 1e-300)) * (p - center); };
  Sample sample;
  sample.Reach = random.Uniform(0.18, 0.25);
  sample.Shape.Tubes = { Tube{ nearest, sample.Reach } };
  sample.Shape.Components = 2;
  sample.Shape.Genus = 0;
  return sample;
}

/// Planes at random distances, from 0.6 of the greatest one.
PlaneSets MaxPlanes(double distance, const Solid& solid, Random& random)
{
  PlaneSets planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    double plane = solid.Low[axis] + random.Uniform(0.0, distance);
    for (; plane < solid.High[axis]; plane += random.Uniform(0.6 * distance, distance))
    {
      planes[axis].push_back(plane);
    }
  }
  return planes;
}

struct Kind
{
  const char* Name;
  Sample (*Make)(Random& random);
};

void PrintTo(const Kind& kind, std::ostream* os) { *os << kind.Name; }

const Kind Kinds[] = { { "Ball", RandomBall }, { "Torus", RandomTorus },
  { "Capsule", RandomCapsule }, { "PairOfBalls", RandomPairOfBalls },
  { "Ellipsoid", RandomEllipsoid }, { "HollowBall", RandomHollowBall } };

class SamplingCondition : public testing::TestWithParam<Kind>
{
protected:
  /// The diagonal of the largest cells is so many times the reach.
  void ExpectRightTopology(double diagonal)
  {
    for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(4); ++seed)
    {
      Random random(seed);
      Sample sample = this->GetParam().Make(random);
      sample.Shape.Low = { -1.3, -1.3, -1.3 };
      sample.Shape.High = { 1.3, 1.3, 1.3 };
      const PlaneSets planes =
        MaxPlanes(diagonal * sample.Reach / std::sqrt(3.0), sample.Shape, random);
      FilterRun run(SliceSolid(sample.Shape, planes, 12, InPlaneGrid::Aligned));
      const SurfaceCheck check = CheckSurface(MeshOf(run.Update()));
      EXPECT_TRUE(run.Errors.empty());
      EXPECT_EQ(check.Components, sample.Shape.Components) << "seed " << seed;
      EXPECT_EQ(check.TotalGenus(), sample.Shape.Genus) << "seed " << seed;
    }
  }
};
}

TEST_P(SamplingCondition, DiagonalOfTheReach) { this->ExpectRightTopology(1.0); }

/// Beyond the condition.
TEST_P(SamplingCondition, DiagonalOfTwiceTheReach) { this->ExpectRightTopology(2.0); }

INSTANTIATE_TEST_SUITE_P(Solids, SamplingCondition, testing::ValuesIn(Kinds),
  [](const testing::TestParamInfo<Kind>& kind) { return std::string(kind.param.Name); });
