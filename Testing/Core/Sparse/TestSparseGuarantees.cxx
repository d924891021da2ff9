// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the guarantees where virtual slices are added: one family, two, a stack with few across
 *
 * What is true of a surface from real slices has to be true of one with virtual slices between
 * them, and the report must be that of the real ones. ORTHOGONAL_SLICES_RUNS and
 * ORTHOGONAL_SLICES_SEED set the number of random inputs of each kind and the first of them.
 */

#include "Core/Reconstruct.h"
#include "Support/CheckBounds.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/Perturbations.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SparseSolids.h"
#include "Support/Stages.h"
#include "Support/TextContours.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Input MakeInput(const Solid& solid, const std::array<int, 3>& count, InPlaneGrid grid)
{
  Input input;
  input.Name = solid.Name;
  for (const int planes : count)
  {
    input.Name += " " + std::to_string(planes);
  }
  // A little off the middle: no plane of symmetry.
  input.Sets = SliceByFewPlanes(solid, FewPlanes(solid, count, { 0.013, -0.011, 0.0 }), grid);
  input.Exact = grid == InPlaneGrid::Aligned;
  return input;
}

/// Solids with walls, cavities and branchings by few planes of one, two and three axes.
std::vector<Input> SparseInputs(InPlaneGrid grid)
{
  std::vector<Input> inputs;
  const std::array<int, 3> counts[] = { { 0, 0, 12 }, { 10, 0, 11 }, { 1, 1, 14 }, { 0, 7, 0 },
    { 0, 9, 8 }, { 0, 13, 1 } };
  std::size_t number = 0;
  for (const Solid& solid :
    { PlainBall(), Pipe(0.5), BallWithCavity(0.5), OpenShell(0.2), Beaker(0.5), TorusAround(0, 0.3),
      TorusAround(2, 0.15), BranchingTube(), TwoBalls(2, 0.3) })
  {
    for (int i = 0; i < 2; ++i)
    {
      inputs.push_back(MakeInput(solid, counts[number++ % 6], grid));
    }
  }
  return inputs;
}

Reconstruction RunWith(
  const Input& input, VirtualSlices mode, const Execution& execution = Execution())
{
  Options options = input.Settings;
  options.Virtual = mode;
  return Reconstruct(PieceSets(input.Sets), options, execution);
}

Reconstruction RunSparse(const Input& input, const Execution& execution = Execution())
{
  return RunWith(input, VirtualSlices::Automatic, execution);
}

bool AreSame(const TriangleMesh& a, const TriangleMesh& b)
{
  return a.Points == b.Points && a.Triangles == b.Triangles;
}

template <typename Visit>
void VisitRandom(std::uint64_t usual, Visit&& visit)
{
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(usual); ++seed)
  {
    const Input input = RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    visit(input);
  }
}

/// All inputs, exact and not, and random ones.
template <typename Visit>
void VisitAll(std::uint64_t usual, Visit&& visit)
{
  for (const InPlaneGrid grid : { InPlaneGrid::Aligned, InPlaneGrid::Free })
  {
    for (const Input& input : SparseInputs(grid))
    {
      SCOPED_TRACE(input.Name + (input.Exact ? ", aligned" : ", free"));
      visit(input);
    }
  }
  VisitRandom(usual, visit);
}

int CountFamilies(const PieceSets& sets)
{
  return static_cast<int>(std::count_if(
    sets.begin(), sets.end(), [](const Pieces& pieces) { return pieces.Count() > 0; }));
}
}

//----------------------------------------------------------------------------
/// G1, G2, G3, G6 and G7.
TEST(SparseGuarantees, SurfacesAreClosedEmbeddedOrientedAndBounded)
{
  int withVirtual = 0;
  VisitAll(60,
    [&](const Input& input)
    {
      const Reconstruction result = RunSparse(input);
      const TriangleMesh mesh = MeshOf(result);
      EXPECT_EQ(DescribeFlaws(mesh), "");
      SpatialGrid grid;
      const Contours contours = UsableContours(input.Sets, input.Settings, grid);
      EXPECT_EQ(DescribeExcess(mesh, contours, false), "");
      // At the vertices of the real grid.
      const SideCheck sides = CheckGridVertices(mesh, contours, grid, input.Settings.Orient, 40, 1);
      EXPECT_TRUE(sides.Wrong.empty()) << sides.Wrong.size() << " of " << sides.Compared;
      withVirtual += result.Grid.HasVirtual() ? 1 : 0;
    });
  EXPECT_GT(withVirtual, 36);
}

//----------------------------------------------------------------------------
/// What is asked to be left out is left out of the surface with virtual slices, too.
TEST(SparseGuarantees, SmallComponentsAreLeftOut)
{
  // Side by side: between two above each other a stack does not know of slices without contours.
  Solid solid = TwoBalls(0, 0.3);
  solid.Tubes.back().Radius *= 0.5;
  for (const auto& count : { std::array<int, 3>{ 0, 0, 20 }, { 20, 0, 16 } })
  {
    Input input = MakeInput(solid, count, InPlaneGrid::Free);
    EXPECT_EQ(RunSparse(input).Topology.Components, 2);
    input.Settings.MinComponent = 0.4;
    const Reconstruction one = RunSparse(input);
    EXPECT_TRUE(one.Grid.HasVirtual());
    EXPECT_EQ(one.Topology.Components, 1);
    EXPECT_EQ(one.SmallComponents, 1);
    for (const Point3& p : MeshOf(one).Points)
    {
      EXPECT_LT(p[0], 0.2); // the smaller one is beyond
    }
    EXPECT_EQ(DescribeFlaws(MeshOf(one)), "");
  }
}

//----------------------------------------------------------------------------
/// G4: every vertex of a stack, and every vertex of families that agree, to the last bit.
TEST(SparseGuarantees, ContoursOfRealSlicesAreKept)
{
  VisitAll(60,
    [](const Input& input)
    {
      const Reconstruction result = RunSparse(input);
      if (!result.Grid.HasVirtual() || result.SmallComponents > 0 ||
        input.Settings.MinIsolatedContour > 0.0 || !(input.Exact || CountFamilies(input.Sets) == 1))
      {
        return;
      }
      SpatialGrid grid;
      const Contours contours = UsableContours(input.Sets, input.Settings, grid);
      TriangleMesh mesh = MeshOf(result);
      EXPECT_EQ(FindMissingVertices(contours, mesh, 0.0).size(), 0u) << "of " << contours.U.size();
    });
}

//----------------------------------------------------------------------------
/// Where a surface bends, virtual slices change the shape between real ones, but never what is
/// connected to what.
TEST(SparseGuarantees, TopologyIsThatOfTheRealSlices)
{
  VisitAll(60,
    [](Input input)
    {
      input.Settings.FollowField = false;
      const SurfaceCheck real = CheckSurface(MeshOf(RunWith(input, VirtualSlices::Off)));
      const Reconstruction result = RunSparse(input);
      const SurfaceCheck all = CheckSurface(MeshOf(result));
      EXPECT_EQ(all.Components, real.Components);
      EXPECT_EQ(all.TotalGenus(), real.TotalGenus());
      EXPECT_EQ(result.Topology.Components, all.Components);
      EXPECT_EQ(result.Topology.Genus, all.TotalGenus());
      std::vector<std::int64_t> a = real.Genus, b = all.Genus;
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      EXPECT_EQ(a, b);
    });
}

//----------------------------------------------------------------------------
namespace
{
/// A field through a few slices parts nothing, and leaves numbers that are expected as they are.
void ExpectNothingParted(const Input& input, const SurfaceTopology& found)
{
  const SurfaceTopology real = RunWith(input, VirtualSlices::Off).Topology;
  EXPECT_LE(found.Components, real.Components);
  EXPECT_TRUE(input.Settings.Known.Components == 0 || found.Components == real.Components);
  EXPECT_TRUE(input.Settings.Known.Genus < 0 || found.Genus == real.Genus);
}
}

TEST(SparseGuarantees, FieldsPartNothing)
{
  VisitRandom(
    90, [](const Input& input) { ExpectNothingParted(input, RunSparse(input).Topology); });
}

//----------------------------------------------------------------------------
namespace
{
/// Node points and disagreement of each real contour.
std::vector<std::tuple<Index, double, double>> AgreementOf(const Reconstruction& result)
{
  std::vector<std::tuple<Index, double, double>> rows;
  for (std::size_t i = 0; i < result.Members.Cell.size(); ++i)
  {
    if (!result.Members.IsVirtual(i))
    {
      const Agreement& agreement = result.Agreement.OfContour[i];
      rows.emplace_back(agreement.NodePoints, agreement.SumOfSquares, agreement.Greatest);
    }
  }
  return rows;
}

std::array<std::size_t, 2> Overruled(const Reconstruction& result)
{
  std::array<std::size_t, 2> count{ 0, 0 };
  for (const Repair& repair : result.Repairs)
  {
    count[0] += repair.Kind == RepairKind::VertexRelabelled ? 1 : 0;
    count[1] += repair.Kind == RepairKind::CrossingsSnipped ? 1 : 0;
  }
  return count;
}
}

TEST(SparseGuarantees, ReportIsThatOfTheRealSlices)
{
  VisitAll(60,
    [](const Input& input)
    {
      const Reconstruction real = RunWith(input, VirtualSlices::Off);
      const Reconstruction all = RunSparse(input);
      EXPECT_EQ(all.ContourCount, real.ContourCount);
      EXPECT_EQ(all.Diagonal, real.Diagonal);
      EXPECT_EQ(all.PolygonSizes, real.PolygonSizes);
      EXPECT_EQ(all.Undecided.Places.size(), real.Undecided.Places.size());
      EXPECT_EQ(all.Undecided.Planes.size(), real.Undecided.Planes.size());
      EXPECT_EQ(all.Doubtful.Places.size(), real.Doubtful.Places.size());
      EXPECT_EQ(AgreementOf(all), AgreementOf(real));
      EXPECT_EQ(Overruled(all), Overruled(real));
      EXPECT_EQ(all.Reconciled.Vertices, real.Reconciled.Vertices);
      EXPECT_EQ(all.Reconciled.Edges, real.Reconciled.Edges);
      EXPECT_EQ(all.SmallComponents, real.SmallComponents);
      for (const Repair& repair : all.Repairs)
      {
        EXPECT_TRUE(repair.Axis < 0 || !all.Grid.IsVirtual(repair.Axis, repair.Plane));
      }
    });
}

//----------------------------------------------------------------------------
/// The mode says nothing where slices are dense.
TEST(SparseGuarantees, DenseSlicesGiveTheSameBytes)
{
  for (std::uint64_t seed = 0; seed < 12; ++seed)
  {
    const int n = 24 + static_cast<int>(seed);
    const Input input = MakeInput(RandomSolid(seed), { n, n, n + 1 }, InPlaneGrid::Free);
    const Reconstruction off = RunWith(input, VirtualSlices::Off);
    const Reconstruction automatic = RunSparse(input);
    EXPECT_FALSE(automatic.Grid.HasVirtual());
    EXPECT_TRUE(AreSame(MeshOf(off), MeshOf(automatic))) << input.Name;
  }
}

//----------------------------------------------------------------------------
namespace
{
/// `threads` ranges of about equal length, each in a thread of its own.
Execution Threads(std::size_t threads)
{
  Execution execution;
  execution.For = [threads](std::size_t count, const Execution::Range& run)
  {
    std::vector<std::thread> all;
    for (std::size_t i = 0; i < threads; ++i)
    {
      all.emplace_back(
        [&run, i, count, threads]
        {
          const std::size_t begin = count * i / threads, end = count * (i + 1) / threads;
          begin < end ? run(begin, end) : static_cast<void>(0);
        });
    }
    for (std::thread& thread : all)
    {
      thread.join();
    }
  };
  return execution;
}
}

/// G5.
TEST(SparseGuarantees, SameForAnyNumberOfThreads)
{
  const auto check = [](const Input& input)
  {
    const TriangleMesh one = MeshOf(RunSparse(input, Threads(1)));
    EXPECT_TRUE(AreSame(MeshOf(RunSparse(input, Threads(2))), one));
    EXPECT_TRUE(AreSame(MeshOf(RunSparse(input, Threads(8))), one));
    EXPECT_TRUE(AreSame(MeshOf(RunSparse(input, ManyThreads())), one));
  };
  for (const Input& input : SparseInputs(InPlaneGrid::Free))
  {
    SCOPED_TRACE(input.Name);
    check(input);
  }
  VisitRandom(20, check);
}

//----------------------------------------------------------------------------
/// Rounded to float: closed, embedded and bounded, with the topology of the real slices.
TEST(SparseGuarantees, HoldInSinglePrecision)
{
  VisitAll(60,
    [](Input input)
    {
      input.Settings.SinglePrecision = true;
      RoundToFloat(input.Sets);
      const Reconstruction result = RunSparse(input);
      TriangleMesh mesh = MeshOf(result);
      for (Point3& p : mesh.Points)
      {
        for (double& x : p)
        {
          x = static_cast<double>(static_cast<float>(x));
        }
      }
      EXPECT_EQ(DescribeFlaws(mesh), "");
      SpatialGrid grid;
      const Contours contours = UsableContours(input.Sets, input.Settings, grid);
      EXPECT_EQ(DescribeExcess(mesh, contours, true), "");
      ExpectNothingParted(input, result.Topology);
    });
}

//----------------------------------------------------------------------------
namespace
{
/// Whether the topology is the same, the result has virtual slices, and the volume: what no change
/// of the description may change. The fair surface is a mesh with edges half as long as slices are
/// apart; which of its edges collapse first follows the numbers of its points, and with it what
/// flat triangles cut off. Of the thinnest of these solids, between seven slices, that is 1.3 per
/// cent.
void ExpectAlike(const Reconstruction& a, const Reconstruction& b, double factor = 1.0)
{
  EXPECT_TRUE(a.Topology == b.Topology);
  EXPECT_EQ(a.Grid.HasVirtual(), b.Grid.HasVirtual());
  const double volume = CheckSurface(MeshOf(a)).TotalVolume();
  EXPECT_NEAR(CheckSurface(MeshOf(b)).TotalVolume() / factor, volume, 2e-2 * std::abs(volume));
}
}

/// What lies in one slice alone would enclose nothing if it was bent: it keeps its domes, also
/// beside other components.
TEST(SparseGuarantees, ComponentsOnOneSliceKeepTheirVolume)
{
  /// Of the component with the least volume.
  const auto volumeOf = [](const std::string& text, VirtualSlices which)
  {
    Options options;
    options.Virtual = which;
    const Reconstruction result = Reconstruct(ParsePieces(text), options, Execution());
    EXPECT_EQ(result.Grid.HasVirtual(), which == VirtualSlices::Automatic);
    const std::vector<double> volumes = CheckSurface(MeshOf(result)).Volume;
    return *std::min_element(volumes.begin(), volumes.end());
  };
  const std::string one = "z=3: 2,0 1,2 -1,2 -2,0 -1,-2 1,-2";
  const std::string others = "; z=0: 12,0 10,2 8,0 10,-2; z=2: 13,0 10,3 7,0 10,-3"
                             "; z=4: 13,0 10,3 7,0 10,-3; z=6: 12,0 10,2 8,0 10,-2";
  const double alone = volumeOf(one, VirtualSlices::Off);
  EXPECT_NEAR(volumeOf(one, VirtualSlices::Automatic), alone, 0.05 * alone);
  const double beside = volumeOf(one + others, VirtualSlices::Off);
  EXPECT_NEAR(volumeOf(one + others, VirtualSlices::Automatic), beside, 0.25 * beside);
}

//----------------------------------------------------------------------------
namespace
{
/// A prism over this polygon from z = 0 on, as a stack of so many slices and rectangles across it.
struct Prism
{
  /// Planes begin at `first`, and end as far before the height.
  PieceSets Slice(int count, double first, const std::vector<double>& across) const
  {
    PieceSets sets = EmptySets();
    for (int i = 0; i < count; ++i)
    {
      AddPiece(sets[2], { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } },
        first + i * (this->Height - 2.0 * first) / (count - 1));
    }
    for (const double x : across)
    {
      AddPiece(sets[0], { { -1, 0 }, { 1, 0 }, { 1, this->Height }, { -1, this->Height } }, x);
    }
    return sets;
  }

  double Height = 4.0;
};
}

/// Flat ends are where slices across show them: beyond the last slice of a stack, or in it.
TEST(SparseGuarantees, FlatEndsAreWhereSlicesAcrossShowThem)
{
  const Prism prism;
  for (const int count : { 5, 8, 12 })
  {
    for (const double first : { 1e-6, 0.2, 2.0 / count })
    {
      Input input;
      input.Sets = prism.Slice(count, first, { 0.13 });
      for (int axis = 0; axis < 3; ++axis)
      {
        SCOPED_TRACE(std::to_string(count) + " " + std::to_string(first));
        const Reconstruction result = RunSparse(input);
        EXPECT_TRUE(result.Grid.HasVirtual());
        const TriangleMesh mesh = MeshOf(result);
        EXPECT_EQ(DescribeFlaws(mesh), "");
        // Upright edges are rounded between slices.
        EXPECT_NEAR(CheckSurface(mesh).TotalVolume(), 16.0, 0.02 * 16.0);
        PermuteAxes(input.Sets);
      }
    }
  }
}

/// Walls and cavities by five or six slices that meet them and one across, or nine and two across,
/// are as large as by many.
TEST(SparseGuarantees, FewSlicesWithOneAcrossShowWallsAndCavities)
{
  for (const Solid& solid : { PlainBall(), Pipe(0.5), BallWithCavity(0.5) })
  {
    const double volume =
      CheckSurface(MeshOf(Reconstruct(SliceByFewPlanes(solid, EqualPlanes(solid, { 24, 24, 24 })),
                     Options(), Execution())))
        .TotalVolume();
    for (const auto& count : { std::array<int, 3>{ 1, 0, 8 }, { 1, 1, 12 }, { 0, 1, 9 } })
    {
      const Input input = MakeInput(solid, count, InPlaneGrid::Free);
      SCOPED_TRACE(input.Name);
      const Reconstruction result = RunSparse(input);
      EXPECT_TRUE(result.Grid.HasVirtual());
      EXPECT_NEAR(CheckSurface(MeshOf(result)).TotalVolume(), volume, 0.03 * volume);
      double worst = 0.0;
      for (const Point3& point : MeshOf(result).Points)
      {
        worst = std::max(worst, std::abs(solid.Value(point)));
      }
      EXPECT_LT(worst, 0.1);
    }
  }
}

//----------------------------------------------------------------------------
/// Which axis is called x is of no importance.
TEST(SparseGuarantees, AxesMayBePermuted)
{
  for (const Input& input : SparseInputs(InPlaneGrid::Free))
  {
    SCOPED_TRACE(input.Name);
    const Reconstruction before = RunSparse(input);
    Input turned = input;
    for (int i = 0; i < 2; ++i)
    {
      PermuteAxes(turned.Sets);
      ExpectAlike(before, RunSparse(turned));
    }
  }
}

//----------------------------------------------------------------------------
/// Pieces in another order that begin elsewhere.
TEST(SparseGuarantees, PiecesMayComeInAnyOrder)
{
  for (const Input& input : SparseInputs(InPlaneGrid::Free))
  {
    SCOPED_TRACE(input.Name);
    Input shuffled = input;
    ShufflePieces(shuffled.Sets, 7);
    ExpectAlike(RunSparse(input), RunSparse(shuffled));
  }
}

//----------------------------------------------------------------------------
/// Times a power of two: every number is that power times what it was.
TEST(SparseGuarantees, ScalingByPowersOfTwoIsExact)
{
  for (const Input& input : SparseInputs(InPlaneGrid::Free))
  {
    SCOPED_TRACE(input.Name);
    const TriangleMesh before = MeshOf(RunSparse(input));
    for (const double factor : { 0x1p-20, 0x1p10 })
    {
      Input scaled = input;
      Scale(scaled.Sets, factor);
      TriangleMesh after = MeshOf(RunSparse(scaled));
      for (Point3& p : after.Points)
      {
        p = (1.0 / factor) * p;
      }
      EXPECT_TRUE(AreSame(before, after)) << factor;
    }
  }
}
