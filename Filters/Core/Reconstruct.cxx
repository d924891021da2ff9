// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruct.h"

#include "Core/Base/Box.h"
#include "Core/Cells/SeparatePatches.h"
#include "Core/Graph/RemoveSmallComponents.h"
#include "Core/Graph/SimplifyArcs.h"
#include "Core/Patches/Domes.h"
#include "Core/Slabs/StitchSlabs.h"
#include "Core/Slices/AssembleContours.h"
#include "Core/Slices/SmoothContours.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace orthoslices
{
CycleGeometry GeometryOf(const Reconstruction& result)
{
  return { result.Grid, result.Graph, result.Crossings, result.Nodes, result.Cycles };
}

namespace
{
/// Diagonal of the bounding box of all finite coordinates.
double FindDiagonal(const std::array<Pieces, 3>& pieces)
{
  Box3 box;
  for (const Pieces& set : pieces)
  {
    const auto extend = [&](int axis, const std::vector<double>& values)
    {
      for (const double x : values)
      {
        if (std::isfinite(x))
        {
          box.Add(axis, x);
        }
      }
    };
    extend(FirstAxis(set.Axis), set.U);
    extend(SecondAxis(set.Axis), set.V);
    extend(set.Axis, set.W);
  }
  const double diagonal = box.Diagonal();
  return std::isfinite(diagonal) ? diagonal : 0.0;
}

/// Whether the slices are cuts of one solid: contours meet to within a small part of a spacing.
bool DoSlicesAgree(const SpatialGrid& grid, const NodePoints& nodes)
{
  constexpr double maximum = 0.03;
  double sum = 0.0;
  for (const double difference : nodes.Difference)
  {
    sum += difference * difference;
  }
  const double spacing =
    std::min({ grid.MeanSpacing(0), grid.MeanSpacing(1), grid.MeanSpacing(2) });
  return sum <= maximum * maximum * spacing * spacing * nodes.Count();
}

/// Names the share of the work that is done, and asks whether to go on.
bool GoOn(const Execution& execution, Reconstruction& result, double progress)
{
  result.Stopped = !execution.Continue(progress);
  return !result.Stopped;
}

void Append(const std::vector<Repair>& more, std::vector<Repair>& repairs)
{
  repairs.insert(repairs.end(), more.begin(), more.end());
}

/// One repair for each patch that became a shell.
std::vector<Repair> DescribeShells(const Reconstruction& result)
{
  std::vector<Repair> repairs;
  for (const PatchMesh& mesh : result.Surface.Meshes)
  {
    if (!mesh.IsSeparatedDisc())
    {
      continue;
    }
    const std::vector<Index> border = GeometryOf(result).GetBorders(mesh.Cycles);
    Point3 sum{ 0.0, 0.0, 0.0 };
    double length = 0.0;
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const Point3 p = result.Graph.PointAt(border[i]);
      const Point3 q = result.Graph.PointAt(border[(i + 1) % border.size()]);
      length += Length(q - p);
      sum = sum + (1.0 / border.size()) * p;
    }
    repairs.push_back({ RepairKind::PatchesSeparated, -1, -1, sum, length });
  }
  return repairs;
}

void CountContours(const Contours& contours, Reconstruction& result)
{
  for (const std::int8_t axis : contours.Axis)
  {
    ++result.ContourCount[axis];
  }
}

/// Arcs of the given cycles, but for loops.
std::vector<Index> ArcsOf(
  const NodeGraph& graph, const CellCycles& cycles, const std::vector<Index>& chosen)
{
  std::vector<Index> arcs;
  for (const Index cycle : chosen)
  {
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      if (!graph.IsLoop(cycles.Arcs[i].Arc))
      {
        arcs.push_back(cycles.Arcs[i].Arc);
      }
    }
  }
  return arcs;
}

/// The patches of all cycles, with the joins that can be made.
SeparatedPatches ChoosePatches(const Options& options, const std::vector<double>& normals,
  const Execution& execution, Reconstruction& result)
{
  constexpr int maxRounds = 16;
  const CycleGeometry geometry = GeometryOf(result);
  result.Cells = GroupByCell(result.Grid, result.Cycles, execution);
  KnownPairs known;
  if (options.Several == SeveralCycles::ByEvidence && !result.Graph.Loops.empty())
  {
    known.Pairs = PairLoops(geometry, options.Criterion, options.Known);
    known.Exclusive = options.Criterion != CorrespondenceCriterion::ByEvidence;
    known.Patches = StitchSlabs(
      result.Grid, result.Cycles, options.Criterion, known.Pairs, execution, result.Graph);
  }
  result.Surface.CentralPoints = LocateCentralPoints(options.Central, geometry, normals, execution);
  LowerDomes(geometry, result.Cells, normals, result.Surface.CentralPoints);
  result.Joins.clear();
  if (options.Several == SeveralCycles::ByEvidence)
  {
    result.Joins =
      FindJoins(geometry, result.Cells, normals, result.Surface.CentralPoints, known, execution);
  }
  const bool atAnyPrice = options.Known.Components > 0 || options.Known.Genus >= 0;
  PatchSeparator separator(
    geometry, result.Cells, result.Surface.CentralPoints, known.Patches, atAnyPrice);
  bool done = false;
  for (int round = 1; round <= maxRounds && !done; ++round)
  {
    // Others may do instead of joins that have turned out to be impossible.
    if (!result.Joins.empty())
    {
      ChooseJoins(geometry, options.Known, result.Joins);
    }
    done = separator.Run(execution, result.Joins);
  }
  return separator.Take();
}

/// Numbers the components of the surface, and counts its handles.
void MeasureTopology(Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  DisjointSets parts = ConnectArcs(result.Crossings, result.Nodes, result.Graph);
  // Two arcs leave each node, and the inside of a disc counts one.
  Index euler = result.Cycles.Count() - result.Graph.Nodes;
  for (const PatchMesh& mesh : result.Surface.Meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      parts.Unite(geometry.PartOf(mesh.Cycles.front()), geometry.PartOf(cycle));
    }
    euler += EulerCharacteristic(mesh) - static_cast<Index>(mesh.Cycles.size());
  }
  FindComponents(parts, result.Graph);
  result.Topology = { result.Graph.Components, result.Graph.Components - euler / 2 };
}

/// Cycles, central points and patches. Returns the cycles of cells that rounding leaves unresolved.
std::vector<Index> PatchCells(const Options& options, const std::vector<double>& normals,
  const Execution& execution, Reconstruction& result)
{
  result.Cycles = TraceCycles(result.Grid, result.Crossings, result.Nodes, result.Graph);
  SeparatedPatches separated = ChoosePatches(options, normals, execution, result);
  result.SharedCells = separated.SharedCells;
  result.Surface.Meshes = std::move(separated.Meshes);
  MeasureTopology(result);
  return separated.Unresolved;
}

/// Takes the thinnest isolated contour of each of these cells out of the surface. False if there is
/// none.
bool LeaveOutThinnest(const std::vector<Index>& cycles, Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  std::vector<Index> contourOf(result.Graph.Loops.size(), IsolatedContours::None);
  for (Index contour = 0; contour < result.Isolated.Count(); ++contour)
  {
    if (result.Isolated.Loop[contour] != IsolatedContours::None)
    {
      contourOf[result.Isolated.Loop[contour]] = contour;
    }
  }
  std::map<std::array<Index, 3>, std::pair<double, Index>> thinnest;
  for (const Index cycle : cycles)
  {
    if (geometry.IsLoop(cycle))
    {
      const Index contour = contourOf[geometry.LoopOf(cycle)];
      const auto candidate = std::make_pair(ThicknessOf(result.Isolated, contour), contour);
      const auto at = thinnest.emplace(result.Cycles.Cell[cycle], candidate).first;
      at->second = std::min(at->second, candidate);
    }
  }
  for (const auto& cell : thinnest)
  {
    result.Isolated.LeftOut[cell.second.second] = 1;
  }
  return !thinnest.empty();
}

/// Loops and all patches, without small components.
void MakePatches(const Options& options, std::vector<double>& normals, const Execution& execution,
  Reconstruction& result)
{
  constexpr int maxRounds = 3;
  const auto embedIsolated = [&]
  {
    EmbedIsolated(result.Grid, result.Nodes, execution,
      options.MinIsolatedContour * result.Diagonal, result.Crossings, result.Isolated,
      result.Graph);
  };
  embedIsolated();
  std::vector<Index> unresolved = PatchCells(options, normals, execution, result);
  // Without small components, others may no longer be connected.
  Index removed = options.MinComponent > 0.0 ? 1 : 0;
  while (removed > 0)
  {
    removed = RemoveSmallComponents(options.MinComponent * result.Diagonal, result.Crossings,
      result.Nodes, normals, result.Isolated, result.Graph);
    result.SmallComponents += removed;
    if (removed > 0)
    {
      unresolved = PatchCells(options, normals, execution, result);
    }
  }
  // Arcs that lie too close together for the precision are drawn anew.
  for (int round = 1; round < maxRounds && !unresolved.empty(); ++round)
  {
    Append(EmbedArcs(result.Grid, result.Nodes, execution, result.Crossings, result.Graph,
             ArcsOf(result.Graph, result.Cycles, unresolved)),
      result.Repairs);
    embedIsolated();
    unresolved = PatchCells(options, normals, execution, result);
  }
  // Isolated contours are not; some are so thin that there is no room beside them.
  while (!unresolved.empty() && LeaveOutThinnest(unresolved, result))
  {
    embedIsolated();
    unresolved = PatchCells(options, normals, execution, result);
  }
  result.DoubtfulCycles = static_cast<Index>(unresolved.size());
}

void FillPolygons(const Options& options, const Execution& execution, Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  if (options.Patching.Method != PatchMethod::Fan)
  {
    result.Normals = EstimateNormals(geometry, options.Patching.CornerAngle,
      TiltOfDomes(geometry, result.Surface.CentralPoints, result.Surface.Meshes), execution);
  }
  result.Surface.Inner = BuildInnerPatches(geometry, result.Cells, result.Normals,
    result.Surface.CentralPoints, result.Surface.Meshes, options.Patching, execution);
  if (options.Patching.Method != PatchMethod::Smooth)
  {
    result.Normals = {}; // those of the triangles say more
  }
}
}

Index CountDisagreements(const Reconstruction& result, double tolerance)
{
  Index count = 0;
  for (Index node = 0; node < result.Nodes.Count(); ++node)
  {
    count += result.Nodes.Disagreement(node) > tolerance ? 1 : 0;
  }
  return count;
}

Reconstruction Reconstruct(
  std::array<Pieces, 3>&& pieces, const Options& options, const Execution& execution)
{
  Reconstruction result;
  result.Diagonal = FindDiagonal(pieces);
  const double tolerance = options.PlaneTolerance * result.Diagonal;
  Contours contours;
  for (Pieces& set : pieces)
  {
    AssembleContours(std::move(set), tolerance, contours, result.Invalid);
  }
  if (!GoOn(execution, result, 0.15))
  {
    return result;
  }
  result.Grid = BuildSpatialGrid(contours, tolerance, options.SinglePrecision);
  const Index assembled = contours.Count();
  OrientContours(options.Orient, options.Crossing == CrossingContours::Repair, execution, contours,
    result.Crossing);
  if (contours.Count() < assembled)
  {
    // A plane whose contours were all removed says nothing: it must not count as empty.
    result.Grid = BuildSpatialGrid(contours, tolerance, options.SinglePrecision);
  }
  CountContours(contours, result);
  result.InsideOut = options.Orient == Orientation::AsDrawn && BoundOutside(contours);
  result.Refused = (options.RefuseInvalid && !result.Invalid.empty()) ||
    (options.Crossing == CrossingContours::Refuse && !result.Crossing.empty());
  if (result.Refused || !GoOn(execution, result, 0.35))
  {
    return result;
  }
  SmoothContours(result.Grid, options.Smoothing, options.Patching.CornerAngle, execution, contours);
  std::vector<IsolatedLoop> isolated;
  result.Crossings = RegisterCrossings(contours, result.Grid, execution, isolated);
  EdgeRegister edges = FileOnEdges(result.Crossings);
  if (!GoOn(execution, result, 0.5))
  {
    return result;
  }
  result.Reconciled = ReconcileSlices(
    result.Grid, result.Crossings, edges, isolated, options.Weights, result.InsideOut ? 1 : 0);
  result.Repairs.swap(result.Reconciled.Repairs);
  result.Nodes = PairNodePoints(result.Grid, result.Crossings, edges, options.Weights);
  edges = EdgeRegister();
  result.Graph =
    BuildNodeGraph(contours, result.Grid, result.Crossings, result.Nodes, tolerance, execution);
  std::vector<double> normals =
    ComputeNodeNormals(contours, result.Grid, result.Crossings, result.Nodes, execution);
  result.Isolated =
    CopyIsolated(isolated, contours, result.Crossings, DoSlicesAgree(result.Grid, result.Nodes));
  result.Agreement =
    MeasureAgreement(contours, result.Grid, result.Crossings, result.Nodes, normals);
  result.Members = { contours.Axis, contours.Plane, contours.Cell };
  ThinArcs(options.ContourTolerance * MinMeanSpacing(result.Grid), result.Crossings, result.Nodes,
    execution, result.Graph);
  Append(EmbedArcs(result.Grid, result.Nodes, execution, result.Crossings, result.Graph),
    result.Repairs);
  contours = Contours();
  if (!GoOn(execution, result, 0.65))
  {
    return result;
  }
  MakePatches(options, normals, execution, result);
  result.Undecided = FindUndecidedPlaces(GeometryOf(result), result.Joins);
  Append(DescribeShells(result), result.Repairs);
  if (!GoOn(execution, result, 0.7))
  {
    return result;
  }
  FillPolygons(options, execution, result);
  LayOutTriangles(result.Graph, result.Cycles, result.Surface);
  GoOn(execution, result, 0.8);
  return result;
}
}
