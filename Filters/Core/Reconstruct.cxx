// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruct.h"

#include "Core/Base/EditContours.h"
#include "Core/Cells/DoubtfulJoins.h"
#include "Core/CheckInvariants.h"
#include "Core/Crossings/NodeNormals.h"
#include "Core/Graph/EmbedArcs.h"
#include "Core/Graph/SimplifyArcs.h"
#include "Core/PatchAllCells.h"
#include "Core/Loops/RedrawnContours.h"
#include "Core/Loops/ResolveLoops.h"
#include "Core/Patches/Domes.h"
#include "Core/RealSlices.h"
#include "Core/Slabs/StitchSlabs.h"
#include "Core/Slices/AssembleContours.h"
#include "Core/Slices/SmoothContours.h"
#include "Core/Sparse/MissingContours.h"
#include "Core/Sparse/SelectContours.h"
#include "Core/Sparse/VirtualSlices.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace orthoslices
{
namespace
{
/// Diagonal of the bounding box of all finite coordinates of the input, without virtual pieces.
double FindDiagonal(const std::array<Pieces, 3>& pieces)
{
  Box3 box;
  for (const Pieces& set : pieces)
  {
    const auto extend = [&](int axis, const std::vector<double>& values)
    {
      for (Index piece = 0; piece < set.Count(); ++piece)
      {
        for (Index i = set.Offsets[piece]; i < set.Offsets[piece + 1] && !set.IsVirtual(piece); ++i)
        {
          if (std::isfinite(values[i]))
          {
            box.Add(axis, values[i]);
          }
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

/// Whether the real slices are cuts of one solid: contours meet to within a small part of a spacing.
bool DoSlicesAgree(const SpatialGrid& grid, const GridCrossings& crossings, const NodePoints& nodes)
{
  constexpr double maximum = 0.03;
  double sum = 0.0;
  for (const double difference : nodes.Difference)
  {
    sum += difference * difference;
  }
  const double spacing =
    std::min({ grid.MeanSpacing(0), grid.MeanSpacing(1), grid.MeanSpacing(2) });
  return sum <= maximum * maximum * spacing * spacing * CountRealNodes(grid, crossings, nodes);
}

/// One repair for each patch between real slices that became a shell.
std::vector<Repair> DescribeShells(const Reconstruction& result)
{
  std::vector<Repair> repairs;
  for (const PatchMesh& mesh : result.Surface.Meshes)
  {
    const CycleGeometry geometry = GeometryOf(result);
    const auto isReal = [&](Index cycle) { return geometry.IsReal(cycle); };
    if (!mesh.IsSeparatedDisc() || !std::all_of(mesh.Cycles.begin(), mesh.Cycles.end(), isReal))
    {
      continue;
    }
    const std::vector<Index> border = geometry.GetBorders(mesh.Cycles);
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

SliceDensity DensityOf(const Contours& contours, const SpatialGrid& grid, const Options& options)
{
  return { grid, BoxOf(contours),
    options.Virtual == VirtualSlices::BySpacing ? options.VirtualSpacing : 0.0 };
}

/// What the slices leave open, and what of that the user has to be told.
void ListDoubts(Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  result.PolygonSizes = CountPolygonSizes(result.Cycles, result.Graph);
  result.Undecided = FindUndecidedPlaces(geometry, result.Joins);
  result.Doubtful = FindUndecidedPlaces(geometry, FindDoubtfulJoins(geometry, result.Joins), 1);
}

/// Runs the stages one after another; see Reconstruct.h.
class StageRunner
{
public:
  StageRunner(const Options& options, const Execution& execution, const StageObserver& observer)
    : Settings(options)
    , Execute(execution)
    , Observe(observer)
  {
  }

  Reconstruction Run(std::array<Pieces, 3>&& pieces);

private:
  StageRunner(const StageRunner& first, Contours&& contours);
  bool MakeSurface();
  bool AddVirtualSlices();
  bool BendStack();
  bool Bend(const Reconstruction& base, std::vector<Point3>&& guides);
  void ExpectTopologyOf(const Reconstruction& base);
  bool ReadContours(std::array<Pieces, 3>&& pieces);
  bool OrientSlices();
  bool MakeSlicesAgree();
  bool BuildGraph();
  bool PatchCells();
  bool FillCycles(const PatchOptions& patching);
  bool Sketch();
  bool FillSketch();

  void Finish(Stage stage) const;
  bool GoOn(double progress);
  void SetShare(double from, double to);
  void Report(const std::vector<Repair>& repairs);

  Options Settings;
  const Execution& Execute;
  const StageObserver& Observe;
  StageTables Tables;
  std::vector<Repair> Inserted; ///< contours that slices lack
  SliceDensity Density;         ///< of the contours; not sparse where that is not asked for
  Contours Drawn;               ///< a copy of the contours, where they are too few
  std::vector<double> Centers;  ///< the central points before Sketch
  double From = 0.0, To = 1.0;  ///< progress of the whole at 0 and 1 of the part at work
  Reconstruction Result;
};

/// For other contours of the same input: what the report says is that of the first surface.
StageRunner::StageRunner(const StageRunner& first, Contours&& contours)
  : StageRunner(first.Settings, first.Execute, first.Observe)
{
  this->Tables.Tolerance = first.Tables.Tolerance;
  this->Tables.Contours = std::move(contours);
  this->Inserted = first.Inserted;
  Reconstruction& result = this->Result;
  result.Invalid = first.Result.Invalid;
  result.CrossingProblems = first.Result.CrossingProblems;
  result.Mended = first.Result.Mended;
  result.ContourCount = first.Result.ContourCount;
  result.Diagonal = first.Result.Diagonal;
  result.PolygonSizes = first.Result.PolygonSizes;
  result.Undecided = first.Result.Undecided;
  result.Doubtful = first.Result.Doubtful;
  result.Grid =
    BuildSpatialGrid(this->Tables.Contours, this->Tables.Tolerance, this->Settings.SinglePrecision);
}

void StageRunner::Finish(Stage stage) const
{
#ifdef ORTHOGONAL_SLICES_CHECK_INVARIANTS
  const std::string wrong = CheckInvariants(stage, this->Tables, this->Result);
  if (!wrong.empty())
  {
    std::cerr << wrong << std::endl;
    std::abort();
  }
#endif
  if (this->Observe)
  {
    this->Observe(stage, this->Tables, this->Result);
  }
}

/// Names the share of the work that is done, and asks whether to go on.
bool StageRunner::GoOn(double progress)
{
  this->Result.Stopped = !this->Execute.Continue(this->From + (this->To - this->From) * progress);
  return !this->Result.Stopped;
}

/// Where the part that comes next begins and ends in the progress of the whole.
void StageRunner::SetShare(double from, double to)
{
  this->From = from;
  this->To = to;
}

void StageRunner::Report(const std::vector<Repair>& repairs)
{
  AppendReal(repairs, this->Result.Grid, this->Result.Repairs);
}

/// Closed contours on planes (the paper's section 3).
bool StageRunner::ReadContours(std::array<Pieces, 3>&& pieces)
{
  this->Result.Diagonal = FindDiagonal(pieces);
  this->Tables.Tolerance = this->Settings.PlaneTolerance * this->Result.Diagonal;
  for (Pieces& set : pieces)
  {
    AssembleContours(
      std::move(set), this->Tables.Tolerance, this->Tables.Contours, this->Result.Invalid);
  }
  this->Finish(Stage::AssembleContours);
  return this->GoOn(0.15);
}

/// The spatial grid, and the interior on the left of each contour (sections 3 and 4).
bool StageRunner::OrientSlices()
{
  const Options& options = this->Settings;
  Reconstruction& result = this->Result;
  Contours& contours = this->Tables.Contours;
  const auto buildGrid = [&]
  { result.Grid = BuildSpatialGrid(contours, this->Tables.Tolerance, options.SinglePrecision); };
  buildGrid();
  const Index assembled = contours.Count();
  const bool asDrawn = options.Orient == Orientation::AsDrawn;
  const bool isRepaired = options.Crossing == CrossingContours::Repair;
  RemoveRedrawn(options.RedrawnShare, asDrawn || options.Loops == LoopRule::NonZero, this->Execute,
    contours, result.Mended);
  const Index firstSettled = isRepaired
    ? ResolveLoops(options.Loops, asDrawn, this->Execute, contours, result.Mended)
    : contours.Count();
  OrientContours(options.Orient, !isRepaired, firstSettled, this->Execute, contours,
    result.CrossingProblems);
  if (contours.Count() < assembled || firstSettled < contours.Count())
  {
    // A plane whose contours were all removed says nothing: it must not count as empty.
    buildGrid();
  }
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    result.ContourCount[contours.Axis[contour]] += contours.IsVirtual(contour) ? 0 : 1;
  }
  result.InsideOut = options.Orient == Orientation::AsDrawn && BoundOutside(contours);
  result.Refused = (options.RefuseInvalid && !result.Invalid.empty()) ||
    (options.Crossing == CrossingContours::Refuse && !result.CrossingProblems.empty());
  this->Finish(Stage::OrientContours);
  if (result.Refused || !this->GoOn(0.35))
  {
    return false;
  }
  if (options.InsertMissing && !result.Grid.HasVirtual())
  {
    MissingContours missing = FindMissingContours(contours, result.Grid);
    AppendContours(missing.Found, contours);
    this->Inserted = std::move(missing.Repairs);
  }
  SmoothContours(
    result.Grid, options.Smoothing, options.Patching.CornerAngle, this->Execute, contours);
  if (options.Virtual != VirtualSlices::Off && !result.InsideOut)
  {
    this->Density = DensityOf(contours, result.Grid, options);
  }
  if (this->Density.IsSparse())
  {
    this->Drawn = contours;
    // Two surfaces are made of them: 0.35 to 0.8 of the first one is 0.35 to 0.485 of the whole.
    this->SetShare(0.245, 0.545);
  }
  this->Finish(Stage::SmoothContours);
  return true;
}

/// Where contours cross the lattice, without contradictions between the slices (section 4.2).
bool StageRunner::MakeSlicesAgree()
{
  Reconstruction& result = this->Result;
  StageTables& tables = this->Tables;
  result.Crossings =
    RegisterCrossings(tables.Contours, result.Grid, this->Execute, tables.IsolatedParts);
  tables.Edges = FileOnEdges(result.Crossings);
  this->Finish(Stage::RegisterCrossings);
  if (!this->GoOn(0.5))
  {
    return false;
  }
  result.Reconciled =
    ReconcileSlices({ result.Grid, result.Crossings, tables.Edges, tables.IsolatedParts },
      this->Settings.Weights, result.InsideOut ? 1 : 0);
  result.Repairs.swap(result.Reconciled.Repairs);
  this->Report(this->Inserted);
  this->Finish(Stage::ReconcileSlices);
  result.Nodes =
    PairNodePoints(result.Grid, result.Crossings, tables.Edges, this->Settings.Weights);
  this->Finish(Stage::PairNodePoints);
  tables.Edges = EdgeRegister();
  return true;
}

/// The graph G of node points and arcs (section 4.1), its arcs embedded, and the report.
bool StageRunner::BuildGraph()
{
  Reconstruction& result = this->Result;
  Contours& contours = this->Tables.Contours;
  std::vector<double>& normals = this->Tables.NodeNormals;
  result.Graph = BuildNodeGraph({ contours, result.Grid, result.Crossings, result.Nodes },
    this->Tables.Tolerance, this->Execute);
  normals =
    ComputeNodeNormals(contours, result.Grid, result.Crossings, result.Nodes, this->Execute);
  result.Isolated = CopyIsolated(this->Tables.IsolatedParts, contours, result.Crossings,
    DoSlicesAgree(result.Grid, result.Crossings, result.Nodes));
  this->Finish(Stage::BuildNodeGraph);
  result.Agreement =
    MeasureAgreement(contours, result.Grid, result.Crossings, result.Nodes, normals);
  result.Members = { contours.Axis, contours.Plane, contours.Cell, contours.Virtual };
  this->Finish(Stage::MeasureAgreement);
  ThinArcs(this->Settings.ContourTolerance * MinMeanSpacing(result.Grid), result.Crossings,
    result.Nodes, this->Execute, result.Graph);
  this->Finish(Stage::ThinArcs);
  this->Report(
    EmbedArcs({ result.Grid, result.Nodes, result.Crossings, result.Graph }, this->Execute));
  this->Finish(Stage::EmbedArcs);
  contours = Contours();
  return this->GoOn(0.65);
}

/// Cycles in each cell (section 4.3), and the patches that are not fans.
bool StageRunner::PatchCells()
{
  PatchAllCells(
    this->Settings, this->Execute, [this](Stage stage) { this->Finish(stage); },
    this->Tables.NodeNormals, this->Result);
  if (!this->Result.Grid.HasVirtual()) // else they are known
  {
    ListDoubts(this->Result);
  }
  this->Report(DescribeShells(this->Result));
  this->Finish(Stage::FindUndecidedPlaces);
  return this->GoOn(0.7);
}

/// Normals along the contours, and the inside of the patches (section 5).
bool StageRunner::FillCycles(const PatchOptions& patching)
{
  Reconstruction& result = this->Result;
  const CycleGeometry geometry = GeometryOf(result);
  if (NeedsNormals(patching.Method))
  {
    result.Normals = EstimateNormals(geometry, patching.CornerAngle,
      TiltOfDomes(geometry, result.Surface.CentralPoints, result.Surface.Meshes), this->Execute);
  }
  this->Finish(Stage::EstimateNormals);
  result.Surface.Inner = BuildInnerPatches(
    { geometry, result.Cells, result.Normals, result.Surface.CentralPoints, result.Surface.Meshes },
    patching, this->Execute);
  if (!GivesNormals(patching.Method))
  {
    result.Normals = {}; // those of the triangles say more
  }
  this->Finish(Stage::BuildInnerPatches);
  LayOutTriangles(result.Graph, result.Cycles, result.Surface);
  this->Finish(Stage::LayOutTriangles);
  return this->GoOn(0.8);
}

/// A surface that shows the topology and is going to be bent: with no more triangles than that needs.
bool StageRunner::Sketch()
{
  PatchOptions patching = this->Settings.Patching;
  patching.EdgeLength =
    std::max(patching.EdgeLength, this->Density.EdgeLength() / MinMeanSpacing(this->Result.Grid));
  this->Centers = this->Result.Surface.CentralPoints;
  return this->FillCycles(patching);
}

/// Makes a sketch the surface that is wanted.
bool StageRunner::FillSketch()
{
  this->Result.Surface.CentralPoints.swap(this->Centers);
  this->SetShare(0.0, 1.0);
  return this->FillCycles(this->Settings.Patching);
}

bool StageRunner::MakeSurface()
{
  return this->MakeSlicesAgree() && this->BuildGraph() && this->PatchCells() &&
    (this->Density.IsSparse() ? this->Sketch() : this->FillCycles(this->Settings.Patching));
}

/// Where slices are few, the surface bends from one to the next as little as it can, and is cut on
/// planes between them; from the real and these virtual slices it is made once more. If that has
/// another topology than what was bent, the first surface stays.
bool StageRunner::AddVirtualSlices()
{
  if (!this->Density.IsSparse())
  {
    return true;
  }
  this->SetShare(0.5, 0.66);
  const bool isDone = this->BendStack() || (!this->Result.Stopped && this->Bend(this->Result, {}));
  return !this->Result.Stopped && (isDone || this->FillSketch());
}

/// Bends the surface of a stack through the contours of a few slices across: how the object hangs
/// together, the stack says better than cells that are far longer than wide. False if there is no
/// such stack, or no surface from it.
bool StageRunner::BendStack()
{
  const int axis = this->Density.StackAxis();
  if (axis < 0)
  {
    return false;
  }
  StageRunner stack(*this, SelectAxis(this->Drawn, axis, true));
  stack.Settings.Known = this->Settings.Known;
  stack.Density = this->Density;
  stack.SetShare(0.485, 0.5);
  if (!stack.MakeSurface())
  {
    this->Result.Stopped = true;
    return false;
  }
  return this->Bend(
    stack.Result, SamplePoints(SelectAxis(this->Drawn, axis, false), this->Density.EdgeLength()));
}

/// Makes the surface anew, with virtual slices of `base` that bends through the guides. False if
/// there are none, or if the topology comes out another than that of `base`.
bool StageRunner::Bend(const Reconstruction& base, std::vector<Point3>&& guides)
{
  Execution execution = this->Execute;
  execution.Continue = [this](double progress) { return this->GoOn(progress); };
  const Contours added =
    MakeVirtualSlices({ GeometryOf(base), base.Surface, this->Result.Grid, std::move(guides) },
      this->Density, execution);
  if (this->Result.Stopped || added.Count() == 0)
  {
    return false;
  }
  const std::vector<Index> leftOut = FindLeftOut(this->Result.Isolated, this->Tables.IsolatedParts);
  Contours contours = this->Drawn;
  RemoveContours(leftOut, this->Tables.IsolatedParts, contours);
  AddVirtual(added, contours);
  StageRunner again(*this, std::move(contours));
  again.ExpectTopologyOf(base);
  again.SetShare(0.48, 0.88); // 0.5 to 0.8 of it is 0.68 to 0.8 of the whole
  if (!again.MakeSurface())
  {
    this->Result.Stopped = true;
    return false;
  }
  if (!(again.Result.Topology == base.Topology))
  {
    return false;
  }
  TakeReport(this->Result, leftOut, again.Result);
  this->Result = std::move(again.Result);
  return true;
}

/// Components that were too small are drawn nevertheless, and must not be joined to others instead.
void StageRunner::ExpectTopologyOf(const Reconstruction& base)
{
  const Index small = base.SmallComponents;
  this->Settings.Known = { base.Topology.Components + small, small > 0 ? -1 : base.Topology.Genus };
}

Reconstruction StageRunner::Run(std::array<Pieces, 3>&& pieces)
{
  // Each part says whether to go on.
  static_cast<void>(this->ReadContours(std::move(pieces)) && this->OrientSlices() &&
    this->MakeSurface() && this->AddVirtualSlices());
  return std::move(this->Result);
}
}

Reconstruction Reconstruct(std::array<Pieces, 3>&& pieces, const Options& options,
  const Execution& execution, const StageObserver& observer)
{
  return StageRunner(options, execution, observer).Run(std::move(pieces));
}
}
