// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PatchAllCells.h"

#include "Core/Cells/SeparatePatches.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/EmbedArcs.h"
#include "Core/Graph/EmbedIsolated.h"
#include "Core/Graph/RemoveComponents.h"
#include "Core/Patches/Domes.h"
#include "Core/Slabs/PairLoops.h"
#include "Core/Slabs/StitchSlabs.h"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

namespace orthoslices
{
namespace
{
/// Arcs of the given cycles, but for loops; of virtual slices alone, if so asked.
std::vector<Index> ArcsOf(
  const CycleGeometry& geometry, const std::vector<Index>& chosen, bool virtualOnly)
{
  const CellCycles& cycles = geometry.Cycles;
  std::vector<Index> arcs;
  for (const Index cycle : chosen)
  {
    for (Index i = cycles.Offsets[cycle]; i < cycles.Offsets[cycle + 1]; ++i)
    {
      const Index arc = cycles.Arcs[i].Arc;
      if (!geometry.Graph.IsLoop(arc) && !(virtualOnly && geometry.IsOnReal(arc)))
      {
        arcs.push_back(arc);
      }
    }
  }
  return arcs;
}

/// Takes the thinnest isolated contour of each of these cells out of the surface, one of a virtual
/// slice if there is any. False if there is none.
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
  std::map<std::array<Index, 3>, std::tuple<bool, double, Index>> thinnest;
  for (const Index cycle : cycles)
  {
    if (geometry.IsLoop(cycle))
    {
      const Index contour = contourOf[geometry.LoopOf(cycle)];
      const auto candidate =
        std::make_tuple(geometry.IsReal(cycle), ThicknessOf(result.Isolated, contour), contour);
      const auto at = thinnest.emplace(result.Cycles.Cell[cycle], candidate).first;
      at->second = std::min(at->second, candidate);
    }
  }
  for (const auto& cell : thinnest)
  {
    result.Isolated.LeftOut[std::get<Index>(cell.second)] = 1;
  }
  return !thinnest.empty();
}

bool AreSame(const CellCycles& a, const CellCycles& b)
{
  return a.Offsets == b.Offsets && a.Cell == b.Cell &&
    std::equal(a.Arcs.begin(), a.Arcs.end(), b.Arcs.begin(), b.Arcs.end(),
      [](const HalfArc& p, const HalfArc& q) { return p.Arc == q.Arc && p.Above == q.Above; });
}

/// Whether two lists of joins are of the same cycles.
bool AreOfSameCycles(const std::vector<CycleJoin>& a, const std::vector<CycleJoin>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const CycleJoin& p, const CycleJoin& q)
    { return p.First == q.First && p.Second == q.Second; });
}

/// Cycles with a join for which the evidence is not what it was. REQUIRES: AreOfSameCycles.
std::vector<Index> FindReassessed(
  const std::vector<CycleJoin>& joins, const std::vector<CycleJoin>& before)
{
  std::vector<Index> cycles;
  for (std::size_t i = 0; i < joins.size(); ++i)
  {
    if (joins[i].Evidence != before[i].Evidence)
    {
      cycles.push_back(joins[i].First);
    }
  }
  return cycles;
}

/// Cycles whose border or central point is not what it was. REQUIRES: the cycles are the same.
std::vector<Index> FindChanged(const CycleGeometry& geometry, const NodeGraph& graphBefore,
  const std::vector<double>& centralPoints, const std::vector<double>& centralPointsBefore)
{
  const NodeGraph& graph = geometry.Graph;
  const auto hasMoved = [&](Index arc)
  {
    bool moved = graph.PointCount(arc) != graphBefore.PointCount(arc);
    for (Index i = 0; !moved && i < graph.PointCount(arc); ++i)
    {
      moved = graph.PointAt(graph.FirstPoint(arc) + i) !=
        graphBefore.PointAt(graphBefore.FirstPoint(arc) + i);
    }
    return moved;
  };
  const CellCycles& cycles = geometry.Cycles;
  std::vector<Index> changed;
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    const auto center = centralPoints.begin() + 3 * static_cast<std::ptrdiff_t>(cycle);
    const auto before = centralPointsBefore.begin() + 3 * static_cast<std::ptrdiff_t>(cycle);
    const auto first = cycles.Arcs.begin() + cycles.Offsets[cycle];
    const auto last = cycles.Arcs.begin() + cycles.Offsets[cycle + 1];
    if (!std::equal(center, center + 3, before) ||
      std::any_of(first, last, [&](const HalfArc& half) { return hasMoved(half.Arc); }))
    {
      changed.push_back(cycle);
    }
  }
  return changed;
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
    , Geometry(GeometryOf(result))
  {
  }

  void Run();

private:
  GraphTables Tables() const
  {
    return { this->Result.Grid, this->Result.Nodes, this->Result.Crossings, this->Result.Graph };
  }
  void EmbedIsolatedContours();
  void PatchCells();
  void Trace(CellCycles&& cycles);
  void PairLoopsOfSlabs();
  void LocateCenters();
  void FindCellJoins();
  void SeparatePatches();
  void TakePatches();
  bool LeaveOut(const std::vector<std::uint8_t>& marked);
  void LeaveOutComponents();
  bool SharesArcs() const;
  void DrawArcsApart(bool virtualOnly);

  const Options& Settings;
  const Execution& Execute;
  const std::function<void(Stage)>& Finish;
  std::vector<double>& NodeNormals;
  Reconstruction& Result;
  const CycleGeometry Geometry; ///< of the result
  KnownPairs Known;
  std::unique_ptr<PatchSeparator> Separator; ///< has the patches that were built last
  NodeGraph GraphBefore;                     ///< as it was when they were built
  std::vector<Index> Unresolved;             ///< cycles of cells in which patches may still touch
};

void CellPatcher::EmbedIsolatedContours()
{
  EmbedIsolated(this->Tables(), this->Settings.MinIsolatedContour * this->Result.Diagonal,
    this->Execute, this->Result.Isolated);
  this->Finish(Stage::EmbedIsolated);
}

/// New cycles, for which all cells have to be patched.
void CellPatcher::Trace(CellCycles&& cycles)
{
  this->Separator.reset();
  this->Result.Cycles = std::move(cycles);
  this->Result.Cells = GroupByCell(this->Result.Grid, this->Result.Cycles, this->Execute);
}

/// What is known of loops: what the criterion joins, and the patches of slabs between slices.
void CellPatcher::PairLoopsOfSlabs()
{
  this->Known = KnownPairs();
  if (this->Settings.Several != SeveralCycles::ByEvidence || this->Result.Graph.Loops.empty())
  {
    return;
  }
  const CorrespondenceCriterion criterion = this->Settings.Criterion;
  this->Known.Pairs = PairLoops(this->Geometry, criterion, this->Settings.Known);
  this->Known.Exclusive = criterion != CorrespondenceCriterion::ByEvidence;
  StitchedSlabs stitched = StitchSlabs(this->Geometry, criterion, this->Known.Pairs, this->Execute);
  if (!stitched.Loops.empty())
  {
    SetLoops(stitched.Loops, this->Result.Graph);
  }
  this->Known.Patches = std::move(stitched.Patches);
  this->Finish(Stage::StitchSlabs);
}

void CellPatcher::LocateCenters()
{
  std::vector<double>& centralPoints = this->Result.Surface.CentralPoints;
  centralPoints = LocateCentralPoints(this->Settings.Central, this->Geometry, this->NodeNormals,
    this->Execute, this->Settings.Processes ? *this->Settings.Processes : Ranks());
  LowerDomes(this->Geometry, this->Result.Cells, this->NodeNormals, centralPoints);
  FlattenEnds(this->Geometry, this->Known.Patches, centralPoints);
  this->Finish(Stage::LocateCentralPoints);
}

void CellPatcher::FindCellJoins()
{
  this->Result.Joins.clear();
  if (this->Settings.Several == SeveralCycles::ByEvidence)
  {
    this->Result.Joins = FindJoins(
      { this->Geometry, this->Result.Cells, this->NodeNormals, this->Result.Surface.CentralPoints },
      this->Known, this->Execute);
    this->Finish(Stage::FindJoins);
  }
}

/// Builds the patches for the joins that can be made, the best ones first.
void CellPatcher::SeparatePatches()
{
  constexpr int maxRounds = 16;
  bool done = false;
  for (int round = 1; round <= maxRounds && !done; ++round)
  {
    // Others may do instead of joins that have turned out to be impossible.
    if (!this->Result.Joins.empty())
    {
      ChooseJoins(this->Geometry, this->Settings.Known, this->Result.Joins);
    }
    done = this->Separator->Run(this->Execute, this->Result.Joins);
  }
  this->Unresolved = this->Separator->Unresolved();
}

/// Cycles, central points, and the patches that are not fans, of all cells that have changed.
void CellPatcher::PatchCells()
{
  Reconstruction& result = this->Result;
  CellCycles cycles =
    TraceCycles(result.Grid, result.Crossings, result.Nodes, result.Graph, this->Execute);
  // Slabs are stitched all together, and give loops other points.
  const bool isNew =
    !this->Separator || !this->Known.Patches.empty() || !AreSame(cycles, result.Cycles);
  if (isNew)
  {
    this->Trace(std::move(cycles));
  }
  this->Finish(Stage::TraceCycles);
  this->PairLoopsOfSlabs();
  const std::vector<double> centersBefore = result.Surface.CentralPoints;
  this->LocateCenters();
  const std::vector<CycleJoin> joinsBefore = result.Joins;
  this->FindCellJoins();
  if (this->Settings.Ends == EndCaps::Flat) // does not change what is joined
  {
    FlattenLids(this->Geometry, this->Known.Patches, result.Surface.CentralPoints);
  }
  if (isNew || !AreOfSameCycles(joinsBefore, result.Joins))
  {
    const PriorKnowledge& expected = this->Settings.Known;
    this->Separator =
      std::make_unique<PatchSeparator>(this->Geometry, result.Cells, result.Surface.CentralPoints,
        this->Known.Patches, expected.Components > 0 || expected.Genus >= 0);
  }
  else
  {
    std::vector<Index> changed = FindReassessed(result.Joins, joinsBefore);
    const std::vector<Index> moved =
      FindChanged(this->Geometry, this->GraphBefore, result.Surface.CentralPoints, centersBefore);
    changed.insert(changed.end(), moved.begin(), moved.end());
    this->Separator->Forget(changed, result.Joins);
  }
  this->SeparatePatches();
}

/// The patches that were built last, and the components of the surface, unless they are taken.
void CellPatcher::TakePatches()
{
  if (!this->Separator)
  {
    return;
  }
  SeparatedPatches separated = this->Separator->Take();
  this->Separator.reset();
  this->Result.SharedCells = separated.SharedCells;
  this->Result.Surface.Meshes = std::move(separated.Meshes);
  this->Finish(Stage::SeparatePatches);
  SurfaceComponents components = MeasureTopology(this->Geometry, this->Result.Surface.Meshes);
  this->Result.Topology = components.Topology;
  this->Result.Graph.Component = std::move(components.OfPart);
  this->Result.Graph.Components = components.Topology.Components;
  this->Finish(Stage::MeasureTopology);
}

/// Takes marked components out, and patches the cells anew if there are any.
bool CellPatcher::LeaveOut(const std::vector<std::uint8_t>& marked)
{
  Reconstruction& result = this->Result;
  if (std::count(marked.begin(), marked.end(), 1) == 0)
  {
    return false;
  }
  RemoveComponents(
    marked, { result.Crossings, result.Nodes, this->NodeNormals, result.Isolated, result.Graph });
  this->EmbedIsolatedContours();
  this->PatchCells();
  return true;
}

/// Takes out components that nobody has drawn, and small ones. Without them, others may no longer
/// be connected.
void CellPatcher::LeaveOutComponents()
{
  Reconstruction& result = this->Result;
  bool removed = result.Grid.HasVirtual();
  while (removed)
  {
    this->TakePatches();
    removed = this->LeaveOut(
      FindVirtualComponents(result.Grid, result.Crossings, result.Nodes, result.Graph));
  }
  const double size = this->Settings.MinComponent * result.Diagonal;
  removed = size > 0.0;
  while (removed)
  {
    this->TakePatches();
    const auto isSmall = FindSmallComponents(size, result.Nodes, result.Graph);
    result.SmallComponents += static_cast<Index>(std::count(isSmall.begin(), isSmall.end(), 1));
    removed = this->LeaveOut(isSmall);
  }
}

/// Whether contours are common to other structures. Arcs stay then as they are for all of them, since
/// drawn anew for one alone they would leave the others' side; patches that touch make room for each
/// other once those of all structures are known (SettleCommonCells).
bool CellPatcher::SharesArcs() const
{
  return this->Settings.Junctions != nullptr && !this->Settings.Junctions->empty();
}

/// Draws arcs of unresolved cells anew that lie too close together for the precision.
void CellPatcher::DrawArcsApart(bool virtualOnly)
{
  this->GraphBefore = this->Result.Graph;
  const std::vector<Repair> repairs =
    EmbedArcs(this->Tables(), this->Execute, ArcsOf(this->Geometry, this->Unresolved, virtualOnly));
  AppendReal(repairs, this->Result.Grid, this->Result.Repairs);
  this->Finish(Stage::EmbedArcs);
}

void CellPatcher::Run()
{
  // Arcs of virtual slices are tried alone at first.
  const bool hasVirtual = this->Result.Grid.HasVirtual();
  const int maxRounds = this->SharesArcs() ? 1 : hasVirtual ? 4 : 3;
  this->EmbedIsolatedContours();
  this->PatchCells();
  this->LeaveOutComponents();
  for (int round = 1; round < maxRounds && !this->Unresolved.empty(); ++round)
  {
    this->DrawArcsApart(hasVirtual && round == 1);
    this->EmbedIsolatedContours();
    this->PatchCells();
  }
  // Some isolated contours are so thin that there is no room beside them.
  while (!this->Unresolved.empty() && LeaveOutThinnest(this->Unresolved, this->Result))
  {
    this->EmbedIsolatedContours();
    this->PatchCells();
  }
  this->TakePatches();
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
