// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/GraftPatch.h"
#include "Core/Cells/JoinPatch.h"

#include "Core/Reconstruct.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckPatch.h"
#include "Support/SelfIntersections.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Squares on z-slices: the first number of each is its lower corner in u, the others are v and z.
Reconstruction Squares(const std::vector<Point3>& corners)
{
  PieceSets sets = EmptySets();
  for (const Point3& c : corners)
  {
    AddPiece(sets[2],
      { { c[0], c[1] }, { c[0] + 1, c[1] }, { c[0] + 1, c[1] + 1 }, { c[0], c[1] + 1 } }, c[2]);
  }
  Options options;
  options.Orient = Orientation::AsDrawn;
  options.Several = SeveralCycles::Discs;
  return Reconstruct(std::move(sets), options, Execution());
}

/// The cycle above the plane 0, or below the plane 1, whose border begins nearest to u.
Index CycleAt(const Reconstruction& result, double u, double z)
{
  const CycleGeometry geometry = GeometryOf(result);
  Index best = -1;
  double minimum = 1e9;
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    const Point3 p = result.Graph.PointAt(geometry.GetBorders({ cycle }).front());
    if (result.Cycles.Cell[cycle][2] == 1 && p[2] == z && std::abs(p[0] - u) < minimum)
    {
      minimum = std::abs(p[0] - u);
      best = cycle;
    }
  }
  return best;
}

PatchMesh Tube(const Reconstruction& result, Index a, Index b)
{
  const auto pair = std::minmax(a, b);
  return BuildJoinedPatch(GeometryOf(result), { pair.first, pair.second }, { { a, b } }, 0.5);
}

PatchMesh Bare(Index cycle) { return { PatchKind::Joined, { cycle }, {}, {} }; }
}

//----------------------------------------------------------------------------
/// One triangle of the tube gives way to a ring of as many points as the square has.
TEST(GraftPatch, CycleOnATube)
{
  const Reconstruction result = Squares({ { 0, 0, 0 }, { 0, 0, 1 }, { 3, 0, 0 } });
  const Index a = CycleAt(result, 0, 0), b = CycleAt(result, 0, 1), c = CycleAt(result, 3, 0);
  const PatchMesh tube = Tube(result, a, b);
  for (std::size_t attempt = 0; attempt < 2; ++attempt)
  {
    const PatchMesh patch =
      GraftPatches(GeometryOf(result), { tube, Bare(c) }, { { a, c } }, attempt);
    EXPECT_EQ(patch.Cycles.size(), 3u);
    EXPECT_EQ(DescribePatchFlaws(GeometryOf(result), patch), "");
    EXPECT_EQ(EulerCharacteristic(patch), -1);
    EXPECT_GT(patch.Points.size(), tube.Points.size());
    EXPECT_LE(CountSelfIntersections(MeshOf(GeometryOf(result), patch)), 0);
  }
}

//----------------------------------------------------------------------------
TEST(GraftPatch, TubeOnATube)
{
  const Reconstruction result =
    Squares({ { 0, 0, 0 }, { 0, 0, 1 }, { 3, 0, 0 }, { 3, 0, 1 }, { 6, 0, 0 } });
  const Index a = CycleAt(result, 0, 0), b = CycleAt(result, 0, 1), c = CycleAt(result, 3, 0),
              d = CycleAt(result, 3, 1), e = CycleAt(result, 6, 0);
  const PatchMesh patch = GraftPatches(GeometryOf(result),
    { Tube(result, a, b), Tube(result, c, d), Bare(e) }, { { a, c }, { d, e } }, 0);
  EXPECT_EQ(patch.Cycles.size(), 5u);
  EXPECT_EQ(DescribePatchFlaws(GeometryOf(result), patch), "");
  EXPECT_EQ(EulerCharacteristic(patch), -3);
  EXPECT_LE(CountSelfIntersections(MeshOf(GeometryOf(result), patch)), 0);
}

//----------------------------------------------------------------------------
TEST(GraftPatch, EmptyWhenThereAreNoMoreTriangles)
{
  const Reconstruction result = Squares({ { 0, 0, 0 }, { 0, 0, 1 }, { 3, 0, 0 } });
  const Index a = CycleAt(result, 0, 0), b = CycleAt(result, 0, 1), c = CycleAt(result, 3, 0);
  const PatchMesh patch =
    GraftPatches(GeometryOf(result), { Tube(result, a, b), Bare(c) }, { { a, c } }, 1000);
  EXPECT_TRUE(patch.Cycles.empty());
  EXPECT_TRUE(patch.Triangles.empty());
}
