// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruct.h"

#include "Support/CheckEmbedding.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SelfIntersections.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Reconstruction RunCore(const std::string& text, const Options& options = Options())
{
  return Reconstruct(ParsePieces(text), options, Execution());
}
}

//----------------------------------------------------------------------------
TEST(Reconstruct, OctahedronIsOneClosedSphere)
{
  const Reconstruction result = RunCore(Octahedron());
  const SurfaceCheck check = CheckSurface(MeshOf(result));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, 1);
  EXPECT_EQ(check.TotalGenus(), 0);
  EXPECT_GT(check.TotalVolume(), 0.0);
  EXPECT_EQ(result.ContourCount, (std::array<Index, 3>{ 1, 1, 1 }));
}

//----------------------------------------------------------------------------
TEST(Reconstruct, CubeHasItsVolumeButForTheCorners)
{
  const SurfaceCheck check = CheckSurface(MeshOf(RunCore(Cube())));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.TotalGenus(), 0);
  // Corners and edges of the cube lie between the slices, where nobody can know them.
  EXPECT_LT(check.TotalVolume(), 8.0);
  EXPECT_GT(check.TotalVolume(), 6.5);
}

//----------------------------------------------------------------------------
TEST(Reconstruct, DirectionsDoNotMatterUnlessTrusted)
{
  const std::string reversed =
    "x=0: -1,-1 -1,1 1,1 1,-1; y=0: -1,-1 -1,1 1,1 1,-1; z=0: -1,-1 -1,1 1,1 1,-1";
  EXPECT_GT(CheckSurface(MeshOf(RunCore(reversed))).TotalVolume(), 0.0);
  Options fans;
  fans.Patching.Method = PatchMethod::Fan; // whose triangles are the same from both sides
  Options options = fans;
  options.Orient = Orientation::AsDrawn;
  // As drawn, they bound the outside: the same surface inside out.
  const Reconstruction result = RunCore(reversed, options);
  EXPECT_TRUE(result.InsideOut);
  EXPECT_EQ(result.Reconciled.Vertices, 0);
  EXPECT_EQ(result.Nodes.Count(), 6);
  EXPECT_TRUE(CheckSurface(MeshOf(result)).IsClosedManifold());
  EXPECT_EQ(CheckSurface(MeshOf(result)).TotalVolume(),
    -CheckSurface(MeshOf(RunCore(reversed, fans))).TotalVolume());
}

//----------------------------------------------------------------------------
TEST(Reconstruct, RefusesWithTheListOfProblems)
{
  const std::string text = Octahedron() + "; z=0: 5,5 6,6 6,5 5,6; x=0: 5,5 nan,6 6,6";
  Options strict;
  strict.Invalid = InvalidContours::Refuse;
  strict.Crossing = CrossingContours::Refuse;
  const Reconstruction refused = RunCore(text, strict);
  EXPECT_TRUE(refused.Refused);
  EXPECT_EQ(refused.Cycles.Count(), 0);
  EXPECT_EQ(refused.Surface.TriangleCount(), 0);
  ASSERT_EQ(refused.Invalid.size(), 1u);
  EXPECT_EQ(refused.Invalid[0].Kind, ProblemKind::NotFinite);
  EXPECT_EQ(refused.Invalid[0].Port, 0);
  EXPECT_TRUE(refused.Mended.empty());
  ASSERT_EQ(refused.CrossingProblems.size(), 1u);
  EXPECT_EQ(refused.CrossingProblems[0].Kind, ProblemKind::CrossesItself);
  EXPECT_EQ(refused.CrossingProblems[0].Port, 2);
  for (const auto crossing : { CrossingContours::Repair, CrossingContours::LeaveOut })
  {
    Options options;
    options.Invalid = InvalidContours::LeaveOut;
    options.Crossing = crossing;
    const Reconstruction kept = RunCore(text, options);
    EXPECT_FALSE(kept.Refused);
    EXPECT_EQ(kept.Invalid.size(), 1u);
    // Both lobes are parts of the surface, or there is neither of them.
    const bool isRepaired = crossing == CrossingContours::Repair;
    EXPECT_EQ(kept.CrossingProblems.size(), isRepaired ? 0u : 1u);
    EXPECT_EQ(kept.Mended.size(), isRepaired ? 1u : 0u);
    EXPECT_EQ(kept.Cycles.Count(), isRepaired ? 12 : 8);
    options.Crossing = CrossingContours::Refuse;
    EXPECT_TRUE(RunCore(text, options).Refused);
  }
}

//----------------------------------------------------------------------------
/// A plane whose only contour is unusable says nothing about inside and outside.
TEST(Reconstruct, PlaneOfLeftOutContoursIsNotEmpty)
{
  Options options;
  options.Crossing = CrossingContours::LeaveOut;
  const Reconstruction result = RunCore(Octahedron() + "; z=0.5: -1,-1 1,1 1,-1 -1,1", options);
  EXPECT_EQ(result.CrossingProblems.size(), 1u);
  EXPECT_EQ(result.Grid.Planes[2], (std::vector<double>{ 0.0 }));
  EXPECT_EQ(result.Reconciled.Vertices, 0);
  EXPECT_EQ(result.Cycles.Count(), 8);
}

//----------------------------------------------------------------------------
TEST(Reconstruct, IsolatedContoursAreListedAsTheyAre)
{
  const Reconstruction result = RunCore(Octahedron() + "; z=0: 0.25,0.25 0.75,0.25 0.75,0.75");
  ASSERT_EQ(result.Isolated.Count(), 1);
  EXPECT_EQ(result.Isolated.Axis[0], 2);
  EXPECT_EQ(result.Isolated.Plane[0], 0);
  std::vector<double> points = result.Isolated.Points;
  std::sort(points.begin(), points.end());
  EXPECT_EQ(points, (std::vector<double>{ 0, 0, 0, 0.25, 0.25, 0.25, 0.75, 0.75, 0.75 }));
}

//----------------------------------------------------------------------------
TEST(Reconstruct, ProgressRisesAndStopsWhenAsked)
{
  std::vector<double> all;
  Execution execution;
  execution.Continue = [&](double progress)
  {
    all.push_back(progress);
    return true;
  };
  EXPECT_FALSE(Reconstruct(ParsePieces(Cube()), Options(), execution).Stopped);
  EXPECT_GE(all.size(), 4u);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  EXPECT_GE(all.front(), 0.0);
  EXPECT_LE(all.back(), 1.0);
  for (std::size_t stop = 1; stop <= all.size(); ++stop)
  {
    std::size_t calls = 0;
    execution.Continue = [&](double) { return ++calls < stop; };
    EXPECT_TRUE(Reconstruct(ParsePieces(Cube()), Options(), execution).Stopped);
    EXPECT_EQ(calls, stop);
  }
}

//----------------------------------------------------------------------------
TEST(Reconstruct, ToleranceIsRelativeToTheBounds)
{
  // Diagonal of the bounds: 2 sqrt 3. Planes 1e-4 apart are one with a tolerance of 1e-3.
  const std::string text = Octahedron() + "; z=0.0001: -1,-1 1,-1 1,1 -1,1";
  Options options;
  EXPECT_EQ(RunCore(text, options).Grid.Planes[2].size(), 2u);
  options.PlaneTolerance = 1e-3;
  EXPECT_EQ(RunCore(text, options).Grid.Planes[2].size(), 1u);
}

//----------------------------------------------------------------------------
TEST(Reconstruct, OfNothingIsNothing)
{
  const Reconstruction result = RunCore("");
  EXPECT_EQ(result.Cycles.Count(), 0);
  EXPECT_TRUE(result.Invalid.empty());
}

//----------------------------------------------------------------------------
namespace
{
/// Contours as drawn whose surface once crossed itself.
void ExpectEmbedded(const std::string& text)
{
  Options fans;
  fans.Patching.Method = PatchMethod::Fan; // whose triangles are the same from both sides
  Options options = fans;
  options.Orient = Orientation::AsDrawn;
  const TriangleMesh mesh = MeshOf(RunCore(text, options));
  EXPECT_FALSE(mesh.Triangles.empty());
  EXPECT_EQ(DescribeFlaws(mesh), "");
  EXPECT_LE(CountSelfIntersections(mesh), 0);
}
}

TEST(Reconstruct, ClockwiseContoursOfThreeNeighbourSlicesBug1)
{
  ExpectEmbedded(
    "x=0.003: 0.11316666666666664,0.17256939595201184 -0.05,-0.6 -0.1,-0.6\n"
    "y=0.11316666666666664: -0.4,0.2 0.17256939595201184,0.003 -0.35,-0.421 -0.6,-0.4\n"
    "z=-0.4: 0.02,0.3 0,-0.2 -0.3,-0.3; z=0.4: -0.4,0.8 -0.4,0.7 -0.3,0.7");
}

TEST(Reconstruct, ClockwiseContoursWithSeveralPatchesInACellBug2)
{
  ExpectEmbedded("x=0: 0.4,0.85 0.1,0.05 -0.1,0.2; y=0.35: 0.85,0.2 0.5,-0.4 -0.4,-0.3\n"
                 "y=0.6: 0.7,0.2 0.5,-0.3 0.5,-0.2; z=0.72: -0.2,0.6 0.3,0.1 -0.2,-0.1");
}

//----------------------------------------------------------------------------
TEST(Reconstruction, CountsNodePointsAtWhichSlicesDisagree)
{
  // The y-slice of the octahedron is smaller: its four node points lie 0.25 from the others'
  // contours.
  const Reconstruction result = Reconstruct(
    ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -0.75,-0.75 0.75,-0.75 0.75,0.75 -0.75,0.75;"
                "z=0: -1,-1 1,-1 1,1 -1,1"),
    Options(), Execution());
  ASSERT_EQ(result.Nodes.Count(), 6);
  EXPECT_EQ(CountDisagreements(result, 0.2), 4);
  EXPECT_EQ(CountDisagreements(result, 0.3), 0);
}
