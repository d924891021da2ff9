// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/ChooseJoins.h"

#include "Core/Reconstruct.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckPatch.h"
#include "Support/CheckSurface.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SelfIntersections.h"
#include "Support/SliceSolid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Options AsDrawn()
{
  Options options;
  options.Orient = Orientation::AsDrawn;
  return options;
}

Options Expecting(Index components, Index genus)
{
  Options options = AsDrawn();
  options.Known = { components, genus };
  return options;
}

/// Runs the core; the surface has no flaws and the topology that the core says.
struct CoreRun
{
  explicit CoreRun(const std::string& text, const Options& options = AsDrawn())
    : CoreRun(ParsePieces(text), options)
  {
  }

  CoreRun(const PieceSets& sets, const Options& options)
    : Result(Reconstruct(PieceSets(sets), options, Execution()))
    , Mesh(MeshOf(this->Result))
    , Check(CheckSurface(this->Mesh))
  {
    EXPECT_EQ(DescribeFlaws(this->Mesh), "");
    EXPECT_LE(CountSelfIntersections(this->Mesh), 0);
    EXPECT_EQ(this->Check.Components, this->Result.Topology.Components);
    EXPECT_EQ(this->Check.TotalGenus(), this->Result.Topology.Genus);
    EXPECT_EQ(this->Check.Components, this->Result.Graph.Components);
    for (const PatchMesh& patch : this->Result.Surface.Meshes)
    {
      EXPECT_EQ(DescribePatchFlaws(GeometryOf(this->Result), patch), "");
    }
  }

  double Minimum(int axis) const { return this->Extreme(axis, -1.0); }
  double Greatest(int axis) const { return this->Extreme(axis, 1.0); }

  Reconstruction Result;
  TriangleMesh Mesh;
  SurfaceCheck Check;

private:
  double Extreme(int axis, double sign) const
  {
    double extreme = -HUGE_VAL;
    for (const Point3& p : this->Mesh.Points)
    {
      extreme = std::max(extreme, sign * p[axis]);
    }
    return sign * extreme;
  }
};

std::string Square(const std::string& plane, double u, double v, double size)
{
  const auto at = [&](double du, double dv)
  { return " " + std::to_string(u + du * size) + "," + std::to_string(v + dv * size); };
  return plane + ":" + at(0, 0) + at(1, 0) + at(1, 1) + at(0, 1) + "\n";
}

/// A box with slices at all whole coordinates that cut it.
std::string Box(const Point3& low, const Point3& high)
{
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = FirstAxis(axis), v = SecondAxis(axis);
    const auto at = [&](double x, double y)
    { return " " + std::to_string(x) + "," + std::to_string(y); };
    for (double plane = std::ceil(low[axis]); plane < high[axis]; plane += 1.0)
    {
      text += std::string(1, "xyz"[axis]) + "=" + std::to_string(plane) + ":" + at(low[u], low[v]) +
        at(high[u], low[v]) + at(high[u], high[v]) + at(low[u], high[v]) + "\n";
    }
  }
  return text;
}
}

//----------------------------------------------------------------------------
/// Only z-slices.
TEST(JoinCycles, StackOfOneFamilyIsOneTube)
{
  std::string text;
  for (int plane = 0; plane < 5; ++plane)
  {
    text += Square("z=" + std::to_string(plane), 0.1 * plane, 0.0, 1.0);
  }
  const CoreRun run(text);
  EXPECT_EQ(run.Check.Components, 1);
  EXPECT_EQ(run.Check.TotalGenus(), 0);
  EXPECT_EQ(run.Result.Joins.size(), 4u);
  // Domes at both ends, no higher than half a spacing.
  EXPECT_LT(run.Minimum(2), 0.0);
  EXPECT_GE(run.Minimum(2), -0.5 - 1e-12);
  EXPECT_GT(run.Greatest(2), 4.0);
  EXPECT_LE(run.Greatest(2), 4.5 + 1e-12);
  EXPECT_GT(run.Check.TotalVolume(), 0.9 * 4.0);
  EXPECT_LT(run.Check.TotalVolume(), 1.1 * 5.0);
}

//----------------------------------------------------------------------------
/// The vessel runs along each axis between the planes of the other two, which cut boxes far away.
TEST(JoinCycles, ThinVesselBetweenThePlanes)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    const int u = FirstAxis(axis), v = SecondAxis(axis);
    Point3 low, high;
    low[axis] = 0.5;
    high[axis] = 4.5;
    low[u] = low[v] = -0.5;
    high[u] = high[v] = 2.5;
    low[v] = -8.5;
    high[v] = -4.5;
    std::string text = Box(low, high);
    std::swap(low[u], low[v]);
    std::swap(high[u], high[v]);
    text += Box(low, high);
    for (int plane = 1; plane < 5; ++plane)
    {
      text += Square(std::string(1, "xyz"[axis]) + "=" + std::to_string(plane), 1.3, 1.3, 0.4);
    }
    const CoreRun run(text);
    EXPECT_EQ(run.Result.Isolated.Count(), 4);
    ASSERT_EQ(run.Check.Components, 3);
    EXPECT_EQ(run.Check.TotalGenus(), 0);
    // Of the vessel: three tubes of 0.4 x 0.4 x 1 at least, and its two domes.
    const double volume = *std::min_element(run.Check.Volume.begin(), run.Check.Volume.end());
    EXPECT_GT(volume, 3.0 * 0.16 * 0.9);
    EXPECT_LT(volume, 4.0 * 0.16);
  }
}

//----------------------------------------------------------------------------
TEST(JoinCycles, SingleIsolatedContourBecomesABeadOfSomeVolume)
{
  const CoreRun run(Square("y=0", 0.0, 0.0, 1.0));
  EXPECT_EQ(run.Check.Components, 1);
  EXPECT_EQ(run.Check.TotalGenus(), 0);
  EXPECT_LT(run.Minimum(1), 0.0);
  EXPECT_GT(run.Greatest(1), 0.0);
  EXPECT_GT(run.Check.TotalVolume(), 0.1);
}

//----------------------------------------------------------------------------
TEST(JoinCycles, DiscsIsThePapersRule)
{
  std::string text;
  for (int plane = 0; plane < 5; ++plane)
  {
    text += Square("z=" + std::to_string(plane), 0.0, 0.0, 1.0);
  }
  Options options = AsDrawn();
  options.Several = SeveralCycles::Discs;
  options.Known = { 1, 3 }; // has no effect
  const CoreRun run(text, options);
  EXPECT_TRUE(run.Result.Joins.empty());
  EXPECT_TRUE(run.Result.Undecided.Places.empty());
  EXPECT_EQ(run.Check.Components, 5);
  EXPECT_EQ(run.Check.TotalGenus(), 0);
}

//----------------------------------------------------------------------------
/// Two plates side by side, cut by x- and y-slices only: the lower sheet of one and the upper sheet
/// of the other are closer to each other than to their own.
TEST(JoinCycles, ParallelSheetsStayApart)
{
  std::string text;
  for (const char* axis : { "x", "y" })
  {
    for (int plane = 0; plane < 4; ++plane)
    {
      for (const double height : { 0.0, 0.5 })
      {
        const std::string low = std::to_string(height), high = std::to_string(height + 0.3);
        const std::string name = std::string(axis) + "=" + std::to_string(plane) + ": ";
        // x-slices have the axes y, z and y-slices z, x.
        text += name +
          (axis[0] == 'x' ? "-0.5," + low + " 3.5," + low + " 3.5," + high + " -0.5," + high
                          : low + ",-0.5 " + high + ",-0.5 " + high + ",3.5 " + low + ",3.5") +
          "\n";
      }
    }
  }
  // A z-slice through another box, far away.
  text += Square("z=0.1", 10, 10, 1);
  const CoreRun run(text);
  EXPECT_EQ(run.Check.Components, 3);
  EXPECT_EQ(run.Check.TotalGenus(), 0);
  EXPECT_GE(run.Result.Joins.size(), 9u);
}

//----------------------------------------------------------------------------
/// Thin walls: the two surfaces of a hollow ball are closer to each other than the planes.
TEST(JoinCycles, NestedSurfacesStayApart)
{
  for (const double thickness : { 0.05, 0.1, 0.2 })
  {
    for (const int count : { 6, 9 })
    {
      SCOPED_TRACE(::testing::Message() << thickness << " " << count);
      Solid solid;
      solid.Low = { -1.211, -1.223, -1.237 };
      solid.High = { 1.217, 1.213, 1.229 };
      solid.Function = [thickness](const Point3& p)
      { return std::abs(std::hypot(p[0], p[1], p[2]) - 0.8) - 0.5 * thickness; };
      const CoreRun run(
        SliceSolid(solid, EqualPlanes(solid, { count, count, count }), 16, InPlaneGrid::Free),
        Options());
      EXPECT_EQ(run.Check.Components, 2);
      EXPECT_EQ(run.Check.TotalGenus(), 0);
    }
  }
}

//----------------------------------------------------------------------------
namespace
{
/// Four stacks of four squares at the corners of a rectangle, between z-planes only: nearest to
/// each other along z, then along x.
std::string FourStacks()
{
  std::string text;
  for (int plane = 0; plane < 4; ++plane)
  {
    for (int stack = 0; stack < 4; ++stack)
    {
      text += Square("z=" + std::to_string(plane), stack % 2 * 1.6, stack / 2 * 2.2, 1.0);
    }
  }
  return text;
}
}

TEST(JoinCycles, StacksBesideEachOtherAreParts)
{
  const CoreRun run(FourStacks());
  EXPECT_EQ(run.Check.Components, 4);
  EXPECT_EQ(run.Check.TotalGenus(), 0);
  // All pairs of eight cycles in each of the three slabs, and of four at both ends.
  EXPECT_EQ(run.Result.Joins.size(), 3u * 28u + 2u * 6u);
}

//----------------------------------------------------------------------------
/// Fewer components than the evidence gives need bridges, and more need less of them.
TEST(JoinCycles, GivenComponentsAreMet)
{
  for (Index components = 1; components <= 16; ++components)
  {
    SCOPED_TRACE(components);
    const CoreRun run(FourStacks(), Expecting(components, 0));
    EXPECT_EQ(run.Check.Components, components);
    EXPECT_EQ(run.Check.TotalGenus(), 0);
  }
  // There are no more than 16 contours.
  EXPECT_EQ(CoreRun(FourStacks(), Expecting(17, -1)).Check.Components, 16);
}

//----------------------------------------------------------------------------
TEST(JoinCycles, GivenGenusIsMet)
{
  for (const Index genus : { 0, 1, 2, 3 })
  {
    SCOPED_TRACE(genus);
    const CoreRun run(FourStacks(), Expecting(2, genus));
    EXPECT_EQ(run.Check.Components, 2);
    EXPECT_EQ(run.Check.TotalGenus(), genus);
  }
}

//----------------------------------------------------------------------------
namespace
{
/// Sets without weights: whatever can be reached from each other.
class Sets
{
public:
  explicit Sets(Index count)
    : Of(static_cast<std::size_t>(count))
  {
    std::iota(this->Of.begin(), this->Of.end(), 0);
  }
  bool AreOne(Index a, Index b) const { return this->Of[a] == this->Of[b]; }
  bool Unite(Index a, Index b)
  {
    const Index from = this->Of[b], to = this->Of[a];
    std::replace(this->Of.begin(), this->Of.end(), from, to);
    return from != to;
  }
  Index Count() const
  {
    return static_cast<Index>(std::set<Index>(this->Of.begin(), this->Of.end()).size());
  }

private:
  std::vector<Index> Of;
};

/// Parts of G as PartOf numbers them, connected by arcs but not by joins.
Sets PartsWithoutJoins(const Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  Sets parts(result.Graph.Nodes + static_cast<Index>(result.Graph.Loops.size()));
  for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
  {
    if (!geometry.IsLoop(cycle))
    {
      for (Index i = result.Cycles.Offsets[cycle]; i < result.Cycles.Offsets[cycle + 1]; ++i)
      {
        parts.Unite(
          geometry.PartOf(cycle), StartNode(result.Crossings, result.Nodes, result.Cycles.Arcs[i]));
      }
    }
  }
  return parts;
}

/// What must be true of the choice, whatever the evidence.
void ExpectSoundChoice(const Reconstruction& result, const PriorKnowledge& known)
{
  const CycleGeometry geometry = GeometryOf(result);
  const SurfaceCheck counted = CheckSurface(MeshOf(result));
  EXPECT_EQ(counted.Components, result.Topology.Components);
  EXPECT_EQ(counted.TotalGenus(), result.Topology.Genus);
  const Sets without = PartsWithoutJoins(result);
  Sets reachable = without, parts = without;
  Sets inCell(result.Cycles.Count());
  double weakest = HUGE_VAL;
  for (const CycleJoin& join : result.Joins)
  {
    EXPECT_LT(join.First, join.Second);
    EXPECT_EQ(result.Cycles.Cell[join.First], result.Cycles.Cell[join.Second]);
    EXPECT_FALSE(join.Chosen && join.Impossible);
    if (!join.Impossible)
    {
      reachable.Unite(geometry.PartOf(join.First), geometry.PartOf(join.Second));
    }
    if (join.Chosen)
    {
      // Never in a ring.
      EXPECT_TRUE(inCell.Unite(join.First, join.Second));
      weakest = std::min(weakest, join.Evidence);
      parts.Unite(geometry.PartOf(join.First), geometry.PartOf(join.Second));
    }
  }
  EXPECT_EQ(parts.Count(), result.Topology.Components);
  if (known.Components > 0)
  {
    // As near to the number as the parts and joins allow.
    EXPECT_EQ(result.Topology.Components,
      std::max(reachable.Count(), std::min(without.Count(), known.Components)));
  }
  // Of the joins that would make the same sort of difference, the strongest are chosen.
  Index handles = 0;
  double weakestHandle = HUGE_VAL, weakestConnection = HUGE_VAL;
  std::vector<const CycleJoin*> inOrder;
  for (const CycleJoin& join : result.Joins)
  {
    if (join.Chosen)
    {
      inOrder.push_back(&join);
    }
  }
  std::stable_sort(inOrder.begin(), inOrder.end(),
    [](const CycleJoin* a, const CycleJoin* b) { return a->Evidence > b->Evidence; });
  Sets grown = without;
  for (const CycleJoin* join : inOrder)
  {
    const bool connects = grown.Unite(geometry.PartOf(join->First), geometry.PartOf(join->Second));
    double& minimum = connects ? weakestConnection : weakestHandle;
    minimum = std::min(minimum, join->Evidence);
    handles += connects ? 0 : 1;
  }
  for (const CycleJoin& join : result.Joins)
  {
    if (join.Chosen || join.Impossible)
    {
      continue;
    }
    const bool connects = !parts.AreOne(geometry.PartOf(join.First), geometry.PartOf(join.Second));
    if (connects && known.Components > 0)
    {
      EXPECT_LE(join.Evidence, weakestConnection);
    }
    if (!connects && known.Genus >= 0 && result.Topology.Genus < known.Genus)
    {
      // More handles were wanted, but it would make a ring.
      EXPECT_TRUE(inCell.AreOne(join.First, join.Second));
    }
    if (connects && known.Components == 0)
    {
      EXPECT_LE(join.Evidence, 0.0);
    }
  }
  if (known.Genus < 0)
  {
    EXPECT_GE(weakestHandle, HandleEvidence);
  }
  else
  {
    EXPECT_TRUE(handles == 0 || result.Topology.Genus <= known.Genus);
  }
  if (known.Components == 0)
  {
    EXPECT_GE(weakestConnection, -FragmentAllowance);
  }
}
}

TEST(JoinCycles, ChoicesOnRandomInputs)
{
  int chosen = 0, met = 0, asked = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(120); ++seed)
  {
    Input input = seed % 4 == 0 ? RandomConsistentInput(seed)
      : seed % 4 == 1           ? RandomContradictoryInput(seed)
                                : RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    input.Settings.MinComponent = 0.0;
    for (const PriorKnowledge& known :
      { PriorKnowledge{ 0, -1 }, PriorKnowledge{ 1, -1 }, PriorKnowledge{ 1, 0 },
        PriorKnowledge{ 2, 2 }, PriorKnowledge{ 0, 3 }, PriorKnowledge{ 1000, -1 } })
    {
      SCOPED_TRACE(
        ::testing::Message() << known.Components << " components, genus " << known.Genus);
      input.Settings.Known = known;
      const CoreRun run(input.Sets, input.Settings);
      ExpectSoundChoice(run.Result, known);
      for (const CycleJoin& join : run.Result.Joins)
      {
        chosen += join.Chosen ? 1 : 0;
      }
      asked += known.Genus >= 0 ? 1 : 0;
      met += known.Genus >= 0 && run.Check.TotalGenus() == known.Genus ? 1 : 0;
    }
  }
  EXPECT_GT(chosen, 500);
  EXPECT_GT(met, asked / 4);
  EXPECT_LT(met, asked);
}

//----------------------------------------------------------------------------
/// ChooseJoins by itself: what is impossible is never chosen, and others do instead.
TEST(JoinCycles, ImpossibleJoinsAreReplaced)
{
  const CoreRun run(FourStacks(), Expecting(1, 0));
  std::vector<CycleJoin> joins = run.Result.Joins;
  const CycleGeometry geometry = GeometryOf(run.Result);
  for (int round = 0; round < 5; ++round)
  {
    for (CycleJoin& join : joins)
    {
      join.Impossible |= join.Chosen && join.First % 2 == round % 2;
    }
    const SurfaceTopology topology = ChooseJoins(geometry, { 1, 0 }, joins);
    Index components = 16;
    for (const CycleJoin& join : joins)
    {
      EXPECT_FALSE(join.Chosen && join.Impossible);
      components -= join.Chosen ? 1 : 0;
    }
    EXPECT_EQ(topology.Components, components);
    EXPECT_EQ(topology.Genus, 0);
  }
  for (CycleJoin& join : joins)
  {
    join.Impossible = true;
  }
  EXPECT_EQ(ChooseJoins(geometry, { 1, 5 }, joins).Components, 16);
}

//----------------------------------------------------------------------------
/// Each word of the evidence by itself: two squares on two planes.
TEST(JoinCycles, EvidenceGoesDownWithTheDistance)
{
  double previous = HUGE_VAL;
  for (const double shift : { 2.5, 3.0, 3.5, 4.0 }) // they do not overlap
  {
    const CoreRun run(Square("z=0", 0, 0, 1) + Square("z=1", shift, 0, 1), Expecting(2, 0));
    double evidence = -HUGE_VAL;
    ASSERT_EQ(run.Result.Joins.size(), 1u);
    evidence = run.Result.Joins[0].Evidence;
    EXPECT_LT(evidence, previous);
    previous = evidence;
  }
  EXPECT_LT(previous, 0.0);
  // Whatever the size of the world.
  const auto evidenceAt = [](double scale)
  {
    PieceSets sets = EmptySets();
    for (int plane = 0; plane < 2; ++plane)
    {
      AddPiece(sets[2],
        { { 0, 0 }, { scale, 0 }, { scale, scale }, { 0.3 * plane * scale, scale } },
        plane * scale);
    }
    return Reconstruct(std::move(sets), AsDrawn(), Execution()).Joins.at(0).Evidence;
  };
  EXPECT_NEAR(evidenceAt(1.0), evidenceAt(1000.0), 1e-9);
  EXPECT_NEAR(evidenceAt(1.0), evidenceAt(1e-6), 1e-9);
}
