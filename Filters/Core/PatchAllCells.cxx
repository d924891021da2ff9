// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PatchAllCells.h"

#include "Core/Cells/SeparatePatches.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/EmbedArcs.h"
#include "Core/Graph/EmbedIsolated.h"
#include "Core/Graph/RemoveSmallComponents.h"
#include "Core/Patches/Domes.h"
#include "Core/Slabs/PairLoops.h"
#include "Core/Slabs/StitchSlabs.h"

#include <algorithm>
#include <map>

namespace orthoslices
{
namespace
{
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

class CellPatcher
{
public:
  CellPatcher(const Options& options, const Execution& execution,
    const std::function<void(Stage)>& finish, std::vector<double>& nodeNormals,
    Reconstruction& result)
    : Settings(options)
    , Execute(execution)
    , Finish(finish)
    , NodeNormals(nodeNormals)
    , Result(result)
  {
  }

  void Run();

private:
  void EmbedIsolatedContours();
  void PatchCells();
  KnownPairs PairLoopsOfSlabs();
  void SeparatePatches(const KnownPairs& known);
  void NumberComponents();
  void RemoveSmall();
  void DrawArcsApart();

  const Options& Settings;
  const Execution& Execute;
  const std::function<void(Stage)>& Finish;
  std::vector<double>& NodeNormals;
  Reconstruction& Result;
  std::vector<Index> Unresolved; ///< cycles of cells in which patches may still touch
};

void CellPatcher::EmbedIsolatedContours()
{
  EmbedIsolated(this->Result.Grid, this->Result.Nodes, this->Execute,
    this->Settings.MinIsolatedContour * this->Result.Diagonal, this->Result.Crossings,
    this->Result.Isolated, this->Result.Graph);
  this->Finish(Stage::EmbedIsolated);
}

/// What is known of loops: what the criterion joins, and the patches of slabs between slices.
KnownPairs CellPatcher::PairLoopsOfSlabs()
{
  KnownPairs known;
  if (this->Settings.Several != SeveralCycles::ByEvidence || this->Result.Graph.Loops.empty())
  {
    return known;
  }
  const CorrespondenceCriterion criterion = this->Settings.Criterion;
  known.Pairs = PairLoops(GeometryOf(this->Result), criterion, this->Settings.Known);
  known.Exclusive = criterion != CorrespondenceCriterion::ByEvidence;
  StitchedSlabs stitched =
    StitchSlabs(GeometryOf(this->Result), criterion, known.Pairs, this->Execute);
  if (!stitched.Loops.empty())
  {
    SetLoops(stitched.Loops, this->Result.Graph);
  }
  known.Patches = std::move(stitched.Patches);
  this->Finish(Stage::StitchSlabs);
  return known;
}

/// The patches for the joins that can be made, the best ones first.
void CellPatcher::SeparatePatches(const KnownPairs& known)
{
  constexpr int maxRounds = 16;
  const CycleGeometry geometry = GeometryOf(this->Result);
  const PriorKnowledge& expected = this->Settings.Known;
  const bool atAnyPrice = expected.Components > 0 || expected.Genus >= 0;
  PatchSeparator separator(
    geometry, this->Result.Cells, this->Result.Surface.CentralPoints, known.Patches, atAnyPrice);
  bool done = false;
  for (int round = 1; round <= maxRounds && !done; ++round)
  {
    // Others may do instead of joins that have turned out to be impossible.
    if (!this->Result.Joins.empty())
    {
      ChooseJoins(geometry, expected, this->Result.Joins);
    }
    done = separator.Run(this->Execute, this->Result.Joins);
  }
  SeparatedPatches separated = separator.Take();
  this->Result.SharedCells = separated.SharedCells;
  this->Result.Surface.Meshes = std::move(separated.Meshes);
  this->Unresolved = std::move(separated.Unresolved);
  this->Finish(Stage::SeparatePatches);
}

void CellPatcher::NumberComponents()
{
  SurfaceComponents components =
    MeasureTopology(GeometryOf(this->Result), this->Result.Surface.Meshes);
  this->Result.Topology = components.Topology;
  this->Result.Graph.Component = std::move(components.OfPart);
  this->Result.Graph.Components = components.Topology.Components;
  this->Finish(Stage::MeasureTopology);
}

/// Cycles, central points, and the patches that are not fans.
void CellPatcher::PatchCells()
{
  Reconstruction& result = this->Result;
  result.Cycles = TraceCycles(result.Grid, result.Crossings, result.Nodes, result.Graph);
  result.Cells = GroupByCell(result.Grid, result.Cycles, this->Execute);
  this->Finish(Stage::TraceCycles);
  const KnownPairs known = this->PairLoopsOfSlabs();
  const CycleGeometry geometry = GeometryOf(result);
  std::vector<double>& centralPoints = result.Surface.CentralPoints;
  centralPoints =
    LocateCentralPoints(this->Settings.Central, geometry, this->NodeNormals, this->Execute);
  LowerDomes(geometry, result.Cells, this->NodeNormals, centralPoints);
  this->Finish(Stage::LocateCentralPoints);
  result.Joins.clear();
  if (this->Settings.Several == SeveralCycles::ByEvidence)
  {
    result.Joins =
      FindJoins({ geometry, result.Cells, this->NodeNormals, centralPoints }, known, this->Execute);
    this->Finish(Stage::FindJoins);
  }
  this->SeparatePatches(known);
  this->NumberComponents();
}

/// Without small components, others may no longer be connected.
void CellPatcher::RemoveSmall()
{
  const double size = this->Settings.MinComponent * this->Result.Diagonal;
  Index removed = size > 0.0 ? 1 : 0;
  while (removed > 0)
  {
    removed = RemoveSmallComponents(size, this->Result.Crossings, this->Result.Nodes,
      this->NodeNormals, this->Result.Isolated, this->Result.Graph);
    this->Result.SmallComponents += removed;
    if (removed > 0)
    {
      this->EmbedIsolatedContours();
      this->PatchCells();
    }
  }
}

/// Draws arcs of unresolved cells anew that lie too close together for the precision.
void CellPatcher::DrawArcsApart()
{
  const std::vector<Repair> repairs =
    EmbedArcs(this->Result.Grid, this->Result.Nodes, this->Execute, this->Result.Crossings,
      this->Result.Graph, ArcsOf(this->Result.Graph, this->Result.Cycles, this->Unresolved));
  this->Result.Repairs.insert(this->Result.Repairs.end(), repairs.begin(), repairs.end());
  this->Finish(Stage::EmbedArcs);
}

void CellPatcher::Run()
{
  constexpr int maxRounds = 3;
  this->EmbedIsolatedContours();
  this->PatchCells();
  this->RemoveSmall();
  for (int round = 1; round < maxRounds && !this->Unresolved.empty(); ++round)
  {
    this->DrawArcsApart();
    this->EmbedIsolatedContours();
    this->PatchCells();
  }
  // Some isolated contours are so thin that there is no room beside them.
  while (!this->Unresolved.empty() && LeaveOutThinnest(this->Unresolved, this->Result))
  {
    this->EmbedIsolatedContours();
    this->PatchCells();
  }
  this->Result.DoubtfulCycles = static_cast<Index>(this->Unresolved.size());
}
}

void PatchAllCells(const Options& options, const Execution& execution,
  const std::function<void(Stage)>& finish, std::vector<double>& nodeNormals,
  Reconstruction& result)
{
  CellPatcher(options, execution, finish, nodeNormals, result).Run();
}
}
