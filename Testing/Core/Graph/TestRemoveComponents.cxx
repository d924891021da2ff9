// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/RemoveComponents.h"

#include "Core/Reconstruct.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Corners = std::array<Point3, 3>;

Reconstruction RunCore(const PieceSets& sets, double minComponent, Options options = Options())
{
  options.MinComponent = minComponent;
  return Reconstruct(PieceSets(sets), options, Execution());
}

/// A component of the surface.
struct Part
{
  std::vector<Corners> Triangles;
};

/// The components by triangles that share points, in the order of their first triangles.
std::vector<Part> PartsOf(const Reconstruction& result)
{
  const TriangleMesh mesh = MeshOf(result);
  const SurfaceCheck check = CheckSurface(mesh);
  std::vector<Part> parts(static_cast<std::size_t>(check.Components));
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto& ids = mesh.Triangles[t];
    parts[check.Component[t]].Triangles.push_back(
      { mesh.Points[ids[0]], mesh.Points[ids[1]], mesh.Points[ids[2]] });
  }
  return parts;
}

/// Bounding box of the contours of each component; central points do not count.
std::vector<double> DiagonalsOf(const Reconstruction& result)
{
  std::vector<Point3> low(result.Graph.Components, { HUGE_VAL, HUGE_VAL, HUGE_VAL });
  std::vector<Point3> high(result.Graph.Components, { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL });
  const CycleGeometry geometry = GeometryOf(result);
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    const Index component = result.Graph.Component[geometry.PartOf(cycle)];
    for (const Index point : geometry.GetBorders({ cycle }))
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double x = result.Graph.PointAt(point)[axis];
        low[component][axis] = std::min(low[component][axis], x);
        high[component][axis] = std::max(high[component][axis], x);
      }
    }
  }
  std::vector<double> diagonals;
  for (std::size_t i = 0; i < low.size(); ++i)
  {
    diagonals.push_back(
      std::hypot(high[i][0] - low[i][0], high[i][1] - low[i][1], high[i][2] - low[i][2]));
  }
  return diagonals;
}

Solid BallAndBead()
{
  Solid solid;
  solid.Low = { -1.2, -1.2, -1.2 };
  solid.High = { 1.21, 1.22, 1.23 };
  solid.Tubes = { Ball({ -0.3, -0.31, -0.32 }, 0.7), Ball({ 0.87, 0.86, 0.85 }, 0.2) };
  return solid;
}

std::vector<Corners> SortedTriangles(const Reconstruction& result)
{
  std::vector<Corners> triangles;
  for (const Part& part : PartsOf(result))
  {
    triangles.insert(triangles.end(), part.Triangles.begin(), part.Triangles.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Whether no cell has cycles of small and of large components.
bool AreApart(const Reconstruction& result, const std::vector<double>& diagonals, double minimum)
{
  std::set<std::array<Index, 3>> cells[2];
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    const Index component = result.Graph.Component[GeometryOf(result).PartOf(cycle)];
    cells[diagonals[component] < minimum ? 1 : 0].insert(result.Cycles.Cell[cycle]);
  }
  return std::none_of(cells[1].begin(), cells[1].end(),
    [&](const std::array<Index, 3>& cell) { return cells[0].count(cell) > 0; });
}
}

//----------------------------------------------------------------------------
/// The rest is what it is without the small one, byte by byte.
TEST(SmallComponents, TheSmallOneGoesAndTheRestStays)
{
  const Solid solid = BallAndBead();
  const PieceSets sets =
    SliceSolid(solid, EqualPlanes(solid, { 12, 13, 14 }), 3, InPlaneGrid::Free);
  const Reconstruction all = RunCore(sets, 0.0);
  EXPECT_EQ(all.SmallComponents, 0);
  const std::vector<Part> parts = PartsOf(all);
  ASSERT_EQ(parts.size(), 2u);
  // 0.4 * sqrt(3) of about 2.4 * sqrt(3) in all.
  const Reconstruction rest = RunCore(sets, 0.3);
  EXPECT_EQ(rest.SmallComponents, 1);
  EXPECT_EQ(rest.Graph.Components, 1);
  EXPECT_EQ(rest.Topology.Components, 1);
  EXPECT_EQ(DescribeFlaws(MeshOf(rest)), "");
  const std::vector<Part> left = PartsOf(rest);
  ASSERT_EQ(left.size(), 1u);
  const auto& larger = parts[0].Triangles.size() > parts[1].Triangles.size() ? parts[0] : parts[1];
  EXPECT_EQ(left[0].Triangles, larger.Triangles);
  EXPECT_EQ(rest.Graph.Nodes, rest.Nodes.Count());
}

//----------------------------------------------------------------------------
TEST(SmallComponents, AllOrNoneOfThem)
{
  const Solid solid = BallAndBead();
  const PieceSets sets =
    SliceSolid(solid, EqualPlanes(solid, { 12, 13, 14 }), 3, InPlaneGrid::Free);
  const TriangleMesh all = MeshOf(RunCore(sets, 0.0));
  const Reconstruction same = RunCore(sets, 0.05);
  EXPECT_EQ(same.SmallComponents, 0);
  EXPECT_EQ(MeshOf(same).Points, all.Points);
  EXPECT_EQ(MeshOf(same).Triangles, all.Triangles);
  const Reconstruction none = RunCore(sets, 1.0);
  EXPECT_EQ(none.SmallComponents, 2);
  EXPECT_TRUE(MeshOf(none).Triangles.empty());
  EXPECT_TRUE(MeshOf(none).Points.empty());
  EXPECT_EQ(none.Topology.Components, 0);
}

//----------------------------------------------------------------------------
/// The bead is cut by z-slices only.
TEST(SmallComponents, OfIsolatedContours)
{
  const std::string box = "z=0: 0,0 4,0 4,4 0,4\nz=1: 0,0 4,0 4,4 0,4\nz=2: 0,0 4,0 4,4 0,4\n";
  const std::string bead = "z=1: 7,7 7.5,7 7.5,7.5 7,7.5\n";
  const Reconstruction both = RunCore(ParsePieces(box + bead), 0.0);
  const Reconstruction one = RunCore(ParsePieces(box + bead), 0.2);
  EXPECT_EQ(PartsOf(both).size(), 2u);
  EXPECT_EQ(one.SmallComponents, 1);
  ASSERT_EQ(PartsOf(one).size(), 1u);
  ASSERT_EQ(one.Isolated.Count(), 4);
  EXPECT_EQ(CountLeftOut(one.Isolated), 1);
  EXPECT_EQ(one.Isolated.Points, both.Isolated.Points);
}

//----------------------------------------------------------------------------
/// Whatever is left is sound, nothing in it is smaller, and nothing else was touched.
TEST(SmallComponents, RandomInputs)
{
  Index removed = 0;
  int unchanged = 0, more = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(300); ++seed)
  {
    Input input = seed % 2 == 0 ? RandomContradictoryInput(seed) : RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.Known = PriorKnowledge();
    const double share = 0.04 * static_cast<double>(1 + seed % 9);
    const Reconstruction all = RunCore(input.Sets, 0.0, input.Settings);
    const Reconstruction rest = RunCore(input.Sets, share, input.Settings);
    EXPECT_EQ(DescribeFlaws(MeshOf(rest)), "");
    removed += rest.SmallComponents;
    const std::vector<double> before = DiagonalsOf(all);
    const auto small = std::count_if(before.begin(), before.end(),
      [&](double diagonal) { return diagonal < share * all.Diagonal; });
    // Without them the rest counts as smaller, so that fragments are connected less easily.
    EXPECT_GE(rest.SmallComponents, small);
    EXPECT_EQ(rest.SmallComponents == 0, small == 0);
    more += rest.SmallComponents > small ? 1 : 0;
    EXPECT_EQ(CheckSurface(MeshOf(rest)).Components, rest.Topology.Components);
    for (const double diagonal : DiagonalsOf(rest))
    {
      EXPECT_GE(diagonal, share * all.Diagonal);
    }
    for (std::size_t i = 0; i < rest.Nodes.NodeOf.size(); ++i)
    {
      const bool has = rest.Nodes.NodeOf[i] != GridCrossings::None;
      EXPECT_EQ(has, !rest.Crossings.IsRemoved(static_cast<Index>(i)));
    }
    // What shares no cell with what is left out stays as it is.
    if (small > 0 && rest.SmallComponents == small && AreApart(all, before, share * all.Diagonal))
    {
      ++unchanged;
      const std::vector<Corners> a = SortedTriangles(all), b = SortedTriangles(rest);
      EXPECT_TRUE(std::includes(a.begin(), a.end(), b.begin(), b.end()));
    }
  }
  EXPECT_GT(removed, 10);
  EXPECT_GT(unchanged, 0);
  EXPECT_LT(more, 5);
}
