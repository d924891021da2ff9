// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the guarantees G1 to G7 of Core/Reconstruct.h, one by one
 *
 * Each is checked over all shapes in Data, all analytic solids and random solids, as they are and
 * made contradictory. ORTHOGONAL_SLICES_RUNS and ORTHOGONAL_SLICES_SEED set the number of random
 * inputs of each kind and the first of them.
 */

#include "Support/CheckBounds.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/NearestTriangle.h"
#include "Support/Perturbations.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SelfIntersections.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"
#include "Support/Threads.h"
#include "Support/Vtk/CountTopology.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"
#include "Support/Vtk/SurfaceMetrics.h"

#include "vtkNew.h"
#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr std::uint64_t UsualRuns = 150;

/// Runs the core and hands over what a guarantee is about.
struct Result
{
  explicit Result(const Input& input)
    : Core(Reconstruct(PieceSets(input.Sets), input.Settings, Execution()))
    , Mesh(MeshOf(Core))
  {
  }

  Reconstruction Core;
  TriangleMesh Mesh;
};

template <typename Visit>
void VisitData(Visit&& visit)
{
  for (const DataSet& data : AllDataSets())
  {
    for (const int count : { 16, 32 })
    {
      Input input;
      input.Name = data.Name + " n" + std::to_string(count);
      input.Sets = ReadPieceSets(data, count);
      SCOPED_TRACE(input.Name);
      visit(input);
    }
  }
}

template <typename Visit>
void VisitSolids(Visit&& visit)
{
  for (const Solid& solid : AllAnalyticSolids())
  {
    for (const InPlaneGrid grid : { InPlaneGrid::Aligned, InPlaneGrid::Free })
    {
      Input input;
      input.Exact = grid == InPlaneGrid::Aligned;
      input.Name = solid.Name + (input.Exact ? ", aligned" : ", free");
      input.Sets = SliceSolid(solid, EqualPlanes(solid, { 12, 11, 10 }), 3, grid);
      SCOPED_TRACE(input.Name);
      visit(input);
    }
  }
}

template <typename Visit>
void VisitRandom(Input (*make)(std::uint64_t), Visit&& visit)
{
  const std::uint64_t first = FirstSeed();
  const std::uint64_t runs = RandomRuns(UsualRuns);
  std::cout << "Random inputs " << first << " to " << first + runs - 1 << "\n";
  for (std::uint64_t seed = first; seed < first + runs; ++seed)
  {
    const Input input = make(seed);
    SCOPED_TRACE(input.Name);
    visit(input);
  }
}

template <typename Visit>
void VisitConsistent(Visit&& visit)
{
  VisitSolids(visit);
  VisitRandom(RandomConsistentInput, visit);
}

/// Everything, contradictory or not.
template <typename Visit>
void VisitAll(Visit&& visit)
{
  VisitData(visit);
  VisitConsistent(visit);
  VisitRandom(RandomContradictoryInput, visit);
  VisitRandom(RandomSparseInput, visit);
}
}

//----------------------------------------------------------------------------
TEST(Guarantees, G1EveryEdgeHasTwoTriangles)
{
  std::int64_t triangles = 0;
  VisitAll(
    [&](const Input& input)
    {
      const Result result(input);
      const SurfaceCheck check = CheckSurface(result.Mesh);
      EXPECT_EQ(check.DegenerateTriangles, 0) << check;
      EXPECT_EQ(check.OpenEdges, 0) << check;
      EXPECT_EQ(check.CrowdedEdges, 0) << check;
      EXPECT_TRUE(
        !input.Exact || !result.Mesh.Triangles.empty() || result.Core.Isolated.Count() > 0);
      triangles += static_cast<std::int64_t>(result.Mesh.Triangles.size());
    });
  EXPECT_GT(triangles, 0);
}

//----------------------------------------------------------------------------
TEST(Guarantees, G2TrianglesAroundEveryVertexFormOneDisc)
{
  VisitAll(
    [](const Input& input)
    {
      const SurfaceCheck check = CheckSurface(Result(input).Mesh);
      EXPECT_EQ(check.NonManifoldVertices, 0) << check;
      EXPECT_EQ(check.UnusedPoints, 0) << check;
    });
}

//----------------------------------------------------------------------------
TEST(Guarantees, G3OrientedAndOutsideWhereTheContoursHaveIt)
{
  std::int64_t compared = 0, skipped = 0;
  VisitAll(
    [&](const Input& input)
    {
      const Result result(input);
      EXPECT_EQ(CheckSurface(result.Mesh).InconsistentEdges, 0);
      SpatialGrid grid;
      const Contours contours = UsableContours(input.Sets, input.Settings, grid);
      const SideCheck sides =
        CheckGridVertices(result.Mesh, contours, grid, input.Settings.Orient, 40, 1);
      EXPECT_TRUE(sides.Wrong.empty())
        << sides.Wrong.size() << " of " << sides.Compared << " grid vertices, the first at ("
        << sides.Wrong[0][0] << ", " << sides.Wrong[0][1] << ", " << sides.Wrong[0][2] << ")";
      compared += sides.Compared;
      skipped += sides.Skipped;
    });
  EXPECT_GT(compared, 10 * skipped);
}

//----------------------------------------------------------------------------
namespace
{
/// The points of the surface and of the contours that are listed as isolated.
TriangleMesh AllPoints(const Result& result)
{
  TriangleMesh mesh = result.Mesh;
  const std::vector<double>& isolated = result.Core.Isolated.Points;
  for (std::size_t i = 0; i < isolated.size(); i += 3)
  {
    mesh.Points.push_back({ isolated[i], isolated[i + 1], isolated[i + 2] });
  }
  return mesh;
}

std::size_t CountSnipped(const Reconstruction& result)
{
  std::size_t count = 0;
  for (Index c = 0; c < result.Crossings.Count(); ++c)
  {
    count += result.Crossings.IsRemoved(c) ? 1 : 0;
  }
  return count;
}

/// The greatest distance of the two contours at a node point.
double GreatestDisagreement(const Reconstruction& result)
{
  double greatest = 0.0;
  for (Index node = 0; node < result.Nodes.Count(); ++node)
  {
    greatest = std::max(greatest, result.Nodes.Disagreement(node));
  }
  return greatest;
}

/// Vertices on the border of a face move inside by a tiny share of the slab's width.
double GreatestMargin(const SpatialGrid& grid)
{
  double greatest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (Index slab = 0; slab <= grid.Count(axis); ++slab)
    {
      greatest = std::max(greatest, grid.Margin(axis, slab));
    }
  }
  return greatest;
}

/// Whether a face had to be drawn anew because its arcs crossed.
bool HasRedrawnFaces(const Reconstruction& result)
{
  return std::any_of(result.Repairs.begin(), result.Repairs.end(),
    [](const Repair& repair) {
      return repair.Kind == RepairKind::ArcsRedrawn || repair.Kind == RepairKind::ArcsReconnected;
    });
}
}

namespace
{
/// The number of vertices of contours, all of which have to be there; 0 if that cannot be said.
std::int64_t ExpectVertices(const Input& input)
{
  const Result result(input);
  if (HasRedrawnFaces(result.Core))
  {
    return 0; // contours that cross lose vertices in these faces
  }
  SpatialGrid grid;
  const Contours contours = UsableContours(input.Sets, input.Settings, grid);
  // Vertices move with their node points: not at all where slices agree.
  const double maximum =
    0.5 * GreatestDisagreement(result.Core) + 1.001 * GreatestMargin(result.Core.Grid);
  const std::size_t missing = FindMissingVertices(contours, AllPoints(result), maximum).size();
  // Loops of one or two vertices go when the reconciliation snips a pair of crossings.
  EXPECT_LE(missing, 2 * CountSnipped(result.Core));
  EXPECT_TRUE(!input.Exact || missing == 0) << missing;
  return static_cast<std::int64_t>(contours.U.size());
}

/// With as few triangles as the surface's own error allows.
Input Light(Input input, bool keepContours)
{
  input.Settings.Patching.OwnAccuracy = true;
  input.Settings.Patching.KeepContours = keepContours;
  return input;
}

/// The surface passes within the accuracy, in spacings of the planes across each slice, of every
/// vertex of every contour, but for what contradictions move. Returns their number.
std::int64_t ExpectWithinAccuracy(const Input& input)
{
  const Result result(input);
  if (HasRedrawnFaces(result.Core) || CountSnipped(result.Core) > 0)
  {
    return 0; // what was cut off is not there
  }
  std::vector<NearestTriangle::Triangle> triangles;
  for (const auto& [a, b, c] : result.Mesh.Triangles)
  {
    triangles.push_back({ result.Mesh.Points[a], result.Mesh.Points[b], result.Mesh.Points[c] });
  }
  if (triangles.empty() || result.Core.Isolated.Count() > 0)
  {
    return 0; // which may be left out
  }
  const NearestTriangle surface(std::move(triangles));
  SpatialGrid grid;
  const Contours contours = UsableContours(input.Sets, input.Settings, grid);
  const double moved =
    0.5 * GreatestDisagreement(result.Core) + 1.001 * GreatestMargin(result.Core.Grid);
  double farthest = 0.0;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    const double spacing = MeanSpacingInSlices(grid, contours.Axis[contour]);
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      const double distance = surface.Find(contours.World(contour, i)).Distance;
      farthest = std::max(farthest, (distance - moved) / spacing);
    }
  }
  EXPECT_GT(result.Core.Accuracy, 0.0);
  EXPECT_LE(farthest, result.Core.Accuracy);
  return static_cast<std::int64_t>(contours.U.size());
}
}

TEST(Guarantees, G4ContourVerticesAreKept)
{
  std::int64_t vertices = 0;
  VisitAll([&](const Input& input) { vertices += ExpectVertices(input); });
  EXPECT_GT(vertices, 100000);
}

//----------------------------------------------------------------------------
TEST(Guarantees, G4ContourVerticesAreKeptWithFewTrianglesIfAskedFor)
{
  std::int64_t vertices = 0;
  const auto check = [&](const Input& input) { vertices += ExpectVertices(Light(input, true)); };
  VisitData(check);
  VisitConsistent(check);
  EXPECT_GT(vertices, 100000);
}

//----------------------------------------------------------------------------
TEST(Guarantees, G4WithFewTrianglesTheSurfacePassesWithinTheAccuracyOfEveryContour)
{
  std::int64_t vertices = 0;
  const auto check = [&](const Input& input)
  { vertices += ExpectWithinAccuracy(Light(input, false)); };
  VisitData(check);
  VisitConsistent(check);
  EXPECT_GT(vertices, 100000);
}

//----------------------------------------------------------------------------
namespace
{
void ExpectClosedEmbeddedAndBounded(const Input& input)
{
  const TriangleMesh mesh = Result(input).Mesh;
  const SurfaceCheck surface = CheckSurface(mesh);
  EXPECT_TRUE(surface.IsClosedManifold()) << surface;
  EXPECT_TRUE(FindMeetings(mesh).empty());
  SpatialGrid grid;
  const Contours contours = UsableContours(input.Sets, input.Settings, grid);
  EXPECT_EQ(DescribeExcess(mesh, contours, false), "");
}

void CheckFewTriangles(bool keepContours)
{
  const auto check = [&](const Input& input)
  { ExpectClosedEmbeddedAndBounded(Light(input, keepContours)); };
  VisitData(check);
  VisitRandom(RandomContradictoryInput, check);
  if (!keepContours) // takes several times as long
  {
    VisitRandom(RandomConsistentInput, check);
    VisitRandom(RandomSparseInput, check);
  }
}
}

TEST(Guarantees, G1ToG3G6AndG7HoldWithFewTriangles) { CheckFewTriangles(false); }

TEST(Guarantees, G1ToG3G6AndG7HoldWithFewTrianglesThatKeepContours) { CheckFewTriangles(true); }

//----------------------------------------------------------------------------
/// Cuts of one surface agree to a millionth of a slab: every vertex is there to the last bit.
TEST(Guarantees, G4VerticesOfConsistentContoursAreKeptBitForBit)
{
  for (const DataSet& data : AllDataSets())
  {
    if (!data.Consistent)
    {
      continue;
    }
    for (const int count : { 16, 32 })
    {
      SCOPED_TRACE(data.Name + " n" + std::to_string(count));
      Input input;
      input.Sets = ReadPieceSets(data, count);
      const Result result(input);
      SpatialGrid grid;
      const Contours contours = UsableContours(input.Sets, input.Settings, grid);
      EXPECT_LE(FindMissingVertices(contours, AllPoints(result), 0.0).size(),
        2 * CountSnipped(result.Core));
    }
  }
}

//----------------------------------------------------------------------------
namespace
{
void ExpectSame(const Reconstruction& a, const Reconstruction& b)
{
  EXPECT_EQ(a.Graph.Points, b.Graph.Points);
  EXPECT_EQ(MeshOf(a).Points, MeshOf(b).Points);
  EXPECT_EQ(a.Graph.Component, b.Graph.Component);
  EXPECT_EQ(a.Isolated.Points, b.Isolated.Points);
  EXPECT_EQ(a.Cycles.Cell, b.Cycles.Cell);
  EXPECT_EQ(a.Invalid.size(), b.Invalid.size());
  EXPECT_EQ(a.CrossingProblems.size(), b.CrossingProblems.size());
  EXPECT_EQ(MeshOf(a).Triangles, MeshOf(b).Triangles);
}
}

TEST(Guarantees, G5SameForAnyNumberOfThreads)
{
  const auto check = [](const Input& input)
  {
    ExpectSame(
      Result(input).Core, Reconstruct(PieceSets(input.Sets), input.Settings, ManyThreads()));
  };
  VisitData(check);
  VisitRandom(RandomContradictoryInput, check);
  VisitRandom(RandomSparseInput, check);
  const auto checkLight = [&](const Input& input) { check(Light(input, false)); };
  VisitData(checkLight);
  VisitRandom(RandomContradictoryInput, checkLight);
}

//----------------------------------------------------------------------------
TEST(Guarantees, G5SlicesThatAgreeAreNotChanged)
{
  std::int64_t nodes = 0;
  VisitConsistent(
    [&](const Input& input)
    {
      if (!input.Exact)
      {
        return;
      }
      const Result result(input);
      EXPECT_EQ(result.Core.Reconciled.Vertices, 0);
      EXPECT_EQ(result.Core.Reconciled.Edges, 0);
      EXPECT_EQ(GreatestDisagreement(result.Core), 0.0);
      nodes += result.Core.Nodes.Count();
    });
  EXPECT_GT(nodes, 1000);
}

//----------------------------------------------------------------------------
TEST(Guarantees, G6NoTwoTrianglesMeet)
{
  VisitAll(
    [](const Input& input)
    {
      const TriangleMesh mesh = Result(input).Mesh;
      EXPECT_TRUE(FindMeetings(mesh).empty()) << "of " << mesh.Triangles.size() << " triangles";
    });
}

//----------------------------------------------------------------------------
/// The same by a checker that is not of this project.
TEST(Guarantees, G6NoTwoTrianglesMeetSaysCgal)
{
  if (CountSelfIntersections(TriangleMesh()) < 0)
  {
    GTEST_SKIP() << "CGAL was not found";
  }
  VisitAll(
    [](const Input& input)
    {
      const TriangleMesh mesh = Result(input).Mesh;
      EXPECT_EQ(CountSelfIntersections(mesh), 0) << "of " << mesh.Triangles.size();
    });
}

//----------------------------------------------------------------------------
namespace
{
/// The sets of an input whose bits are set, x first, and the others empty.
Input TakeFamilies(const Input& input, unsigned families)
{
  Input taken = input;
  for (int axis = 0; axis < 3; ++axis)
  {
    if ((families >> axis & 1u) == 0)
    {
      taken.Sets[axis] = EmptySets()[axis];
    }
  }
  taken.Name += ", families " + std::to_string(families);
  return taken;
}

/// With every patch type, and with the central points of both kinds.
void ExpectWithinBounds(Input input)
{
  SpatialGrid grid;
  const Contours contours = UsableContours(input.Sets, input.Settings, grid);
  for (const auto method : { PatchMethod::Smooth, PatchMethod::Coons, PatchMethod::Fan })
  {
    for (const auto central : { CentralPointMethod::LeastSquares, CentralPointMethod::Centroid })
    {
      input.Settings.Patching.Method = method;
      input.Settings.Central = central;
      EXPECT_EQ(DescribeExcess(Result(input).Mesh, contours, false), "")
        << static_cast<int>(method) << " " << static_cast<int>(central);
    }
  }
}
}

TEST(Guarantees, G7NothingLeavesTheBoxOfTheContoursByMoreThanHalfASpacing)
{
  VisitConsistent(ExpectWithinBounds);
  VisitRandom(RandomContradictoryInput, ExpectWithinBounds);
  VisitRandom(RandomSparseInput, ExpectWithinBounds);
}

//----------------------------------------------------------------------------
/// Where families are missing, cells reach to the ends of the object.
TEST(Guarantees, G7HoldsForEverySubsetOfTheFamilies)
{
  for (const DataSet& data : AllDataSets())
  {
    Input input;
    input.Name = data.Name;
    input.Sets = ReadPieceSets(data, 16);
    for (unsigned families = 1; families < 8; ++families)
    {
      const Input taken = TakeFamilies(input, families);
      SCOPED_TRACE(taken.Name);
      SpatialGrid grid;
      const Contours contours = UsableContours(taken.Sets, taken.Settings, grid);
      EXPECT_EQ(DescribeExcess(Result(taken).Mesh, contours, false), "");
    }
  }
}

//----------------------------------------------------------------------------
/// Rounded to float, points may come together: the core keeps them apart if it knows.
TEST(Guarantees, G1ToG7HoldInSinglePrecision)
{
  const auto check = [](Input input)
  {
    input.Settings.SinglePrecision = true;
    RoundToFloat(input.Sets);
    TriangleMesh mesh = Result(input).Mesh;
    for (Point3& p : mesh.Points)
    {
      for (double& x : p)
      {
        x = static_cast<double>(static_cast<float>(x));
      }
    }
    const SurfaceCheck surface = CheckSurface(mesh);
    EXPECT_TRUE(surface.IsClosedManifold()) << surface;
    EXPECT_TRUE(FindMeetings(mesh).empty());
    EXPECT_LE(CountSelfIntersections(mesh), 0);
    SpatialGrid grid;
    EXPECT_EQ(DescribeExcess(mesh, UsableContours(input.Sets, input.Settings, grid), true), "");
  };
  VisitData(check);
  VisitRandom(RandomConsistentInput, check);
  VisitRandom(RandomContradictoryInput, check);
  VisitRandom(RandomSparseInput, check);
  const auto checkLight = [&](const Input& input) { check(Light(input, false)); };
  VisitData(checkLight);
  VisitRandom(RandomConsistentInput, checkLight);
  VisitRandom(RandomContradictoryInput, checkLight);
}

//----------------------------------------------------------------------------
// What follows from the guarantees where the sampling is good enough.

TEST(Topology, ShapesOfTheDataFolder)
{
  for (const DataSet& data : AllDataSets())
  {
    // Laces and branches are thinner than the distance of the slices: handles are guessed there.
    const bool isThin = data.Name == "boot" || data.Name == "neuron";
    for (const int count : { 16, 32 })
    {
      SCOPED_TRACE(data.Name + " n" + std::to_string(count));
      Input input;
      input.Sets = ReadPieceSets(data, count);
      const SurfaceCheck check = CheckSurface(Result(input).Mesh);
      EXPECT_EQ(check.Components, data.Components);
      if (isThin)
      {
        EXPECT_NEAR(check.TotalGenus(), data.Genus, 4);
        input.Settings.Known = { data.Components, data.Genus };
        const SurfaceCheck known = CheckSurface(Result(input).Mesh);
        EXPECT_EQ(known.Components, data.Components);
        EXPECT_EQ(known.TotalGenus(), data.Genus);
        continue;
      }
      EXPECT_EQ(check.TotalGenus(), data.Genus);
      const double truth = CheckSurface(MeshOf(ReadTruth(data))).TotalVolume();
      EXPECT_NEAR(check.TotalVolume(), truth, 0.02 * truth);
    }
  }
}

//----------------------------------------------------------------------------
/// Slices across the stack of a heart join it otherwise in small places, and leave the surface of all
/// slices together notches: this one is several times as far off.
TEST(Accuracy, StackWithSlicesAcrossHasNoNotches)
{
  const std::vector<DataSet> all = AllDataSets();
  const DataSet& data =
    *std::find_if(all.begin(), all.end(), [](const DataSet& any) { return any.Name == "heart"; });
  const auto truth = ReadTruth(data);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(truth);
  slicer->SetNumberOfSlices(1, 1, 20);
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  for (int axis = 0; axis < 3; ++axis)
  {
    filter->SetInputConnection(axis, slicer->GetOutputPort(axis));
  }
  filter->Update();
  const SurfaceCheck check = CheckSurface(MeshOf(filter->GetOutput()));
  EXPECT_EQ(check.Components, data.Components);
  EXPECT_EQ(check.TotalGenus(), data.Genus);
  const auto deviation = MeasureDeviation(filter->GetOutput(), truth, 20000);
  ASSERT_TRUE(deviation);
  const double* bounds = truth->GetBounds();
  EXPECT_LT(deviation->RootMeanSquare, 0.06 * (bounds[5] - bounds[4]) / 20.0);
}

//----------------------------------------------------------------------------
/// As near to the label volume's own surface as its voxels allow.
TEST(Accuracy, LabelVolumesToHalfAVoxel)
{
  const double voxel = 0.9375; // millimetres, the shorter side; Data/*/meta.json
  const std::map<std::string, double> scale{ { "lbl_lumbar3", 0.010255403836489527 },
    { "lbl_stomach", 0.0063848474084438 } };
  for (const DataSet& data : AllDataSets())
  {
    if (!data.Consistent)
    {
      SCOPED_TRACE(data.Name);
      FilterRun run(ReadPieceSets(data, 32));
      const auto deviation = MeasureDeviation(run.Update(), ReadTruth(data), 20000);
      ASSERT_TRUE(deviation);
      EXPECT_LT(deviation->RootMeanSquare, 0.5 * voxel * scale.at(data.Name));
    }
  }
}

//----------------------------------------------------------------------------
TEST(Topology, AnalyticSolids)
{
  for (const Solid& solid : AllAnalyticSolids())
  {
    for (const InPlaneGrid grid : { InPlaneGrid::Aligned, InPlaneGrid::Free })
    {
      SCOPED_TRACE(solid.Name);
      Input input;
      input.Sets = SliceSolid(solid, EqualPlanes(solid, { 20, 19, 21 }), 2, grid);
      const SurfaceCheck check = CheckSurface(Result(input).Mesh);
      EXPECT_EQ(check.Components, solid.Components) << check;
      EXPECT_EQ(check.TotalGenus(), solid.Genus) << check;
    }
  }
}

//----------------------------------------------------------------------------
TEST(Topology, CavityIsOrientedIntoItself)
{
  const Solid solid = HollowBall();
  Input input;
  input.Sets = SliceSolid(solid, EqualPlanes(solid, { 16, 16, 16 }), 3, InPlaneGrid::Free);
  std::vector<double> volume = CheckSurface(Result(input).Mesh).Volume;
  std::sort(volume.begin(), volume.end());
  ASSERT_EQ(volume.size(), 2u);
  const double ball = 4.0 / 3.0 * 3.14159265358979;
  EXPECT_NEAR(volume[0], -ball * std::pow(0.6 - 0.21, 3), 0.02);
  EXPECT_NEAR(volume[1], ball * std::pow(0.6 + 0.21, 3), 0.06);
}

//----------------------------------------------------------------------------
/// Solids without parts and gaps narrower than a slab: nothing is left to chance.
TEST(Topology, RandomSolidsWithClearance)
{
  const int count = 20;
  const std::uint64_t runs = RandomRuns(UsualRuns);
  std::uint64_t judged = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + runs; ++seed)
  {
    const Solid solid = RandomSolid(seed);
    const double spacing = (solid.High[2] - solid.Low[2]) / count;
    const auto topology = CountTopology(solid, 0.5 * spacing);
    if (!topology)
    {
      continue;
    }
    ++judged;
    SCOPED_TRACE(solid.Name);
    Input input;
    input.Sets =
      SliceSolid(solid, EqualPlanes(solid, { count, count, count }), 3, InPlaneGrid::Free);
    const SurfaceCheck check = CheckSurface(Result(input).Mesh);
    EXPECT_EQ(check.Components, topology->Components) << check;
    EXPECT_EQ(check.TotalGenus(), topology->Genus) << check;
  }
  EXPECT_GT(judged, runs / 5);
}
