// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/MakeSurface.h"

#include "Core/Cells/DoubtfulJoins.h"
#include "Core/Crossings/ArcSources.h"
#include "Core/Crossings/NodeNormals.h"
#include "Core/Graph/EmbedArcs.h"
#include "Core/Graph/SimplifyArcs.h"
#include "Core/Improve/ImproveSurface.h"
#include "Core/Labels/ImproveStructures.h"
#include "Core/Labels/LightenStructures.h"
#include "Core/PatchAllCells.h"
#include "Core/Patches/DivideCycles.h"
#include "Core/Patches/Domes.h"
#include "Core/Patches/FitError.h"
#include "Core/Slabs/StitchSlabs.h"
#include "Core/Surface/KeepPart.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace orthoslices
{
namespace
{
/// The parts of PatchOptions::Accuracy that arcs with few vertices and better triangles may use up.
/// What is left is for what they add to each other, and for the worst triangles, which may take
/// 1.7 times as much: so contours are within the accuracy (G4).
constexpr double ShareOfArcs = 0.2;
constexpr double ShareOfTriangles = 0.2;

/// The accuracy by the error of the surface, both in spacings, where the surface itself is to say:
/// it is a bound, of which the RMS is about a twentieth. Twelve shapes and three of voxels at 16 and 32
/// planes per axis get a twentieth more RMS distance in the mean, most of them from a seventh of
/// the triangles or less. Rough shapes get less than in proportion, as their errors are in few
/// places.
constexpr double AccuracyByError = 8.5;
constexpr double AccuracyByRoot = 0.66;
/// Fewer rough patches are in proportion more accurate: they have few triangles in any case, of
/// which all are as far from them as may be, not the worst alone.
constexpr double ManyPatches = 300.0;
constexpr double LeastShare = 0.25;
constexpr double LeastAccuracy = 0.004; ///< exact data need no end of triangles

/// The part of what slices disagree on, RMS, that the surface may be off them in any case. What is
/// asked for in addition would reproduce noise.
constexpr double ShareOfDisagreement = 2.0;

/// Triangles with a smaller angle are improved, in degrees: somewhat above the 20 that are wanted.
constexpr double GoodAngle = 22.0;

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

/// What the slices leave open, and what of that the user has to be told.
void ListDoubts(Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  result.PolygonSizes = CountPolygonSizes(result.Cycles, result.Graph);
  result.Undecided = FindUndecidedPlaces(geometry, result.Joins);
  result.Doubtful = FindUndecidedPlaces(geometry, FindDoubtfulJoins(geometry, result.Joins), 1);
}

/// The graph G of node points and arcs (section 4.1), its arcs embedded, and the report.
bool BuildGraph(Pass& pass)
{
  Reconstruction& result = pass.Result;
  Contours& contours = pass.Tables.Contours;
  std::vector<double>& normals = pass.Tables.NodeNormals;
  result.Graph = BuildNodeGraph(
    { contours, result.Grid, result.Crossings, result.Nodes, pass.Settings.Junctions },
    pass.Tables.Tolerance, pass.Execute);
  normals = ComputeNodeNormals(contours, result.Grid, result.Crossings, result.Nodes, pass.Execute);
  result.Isolated =
    CopyIsolated(pass.Tables.IsolatedParts, contours, result.Crossings, DoSlicesAgree(result));
  pass.Finish(Stage::BuildNodeGraph);
  result.Agreement =
    MeasureAgreement(contours, result.Grid, result.Crossings, result.Nodes, normals);
  result.ArcSources = FindArcSources(contours, result.Crossings);
  result.Members = { contours.Axis, contours.Plane, contours.Cell, contours.Virtual, {}, {} };
  pass.Finish(Stage::MeasureAgreement);
  const double spacing = MinMeanSpacing(result.Grid);
  ThinArcs({ pass.Settings.ContourTolerance * spacing, pass.Settings.LongestSide * spacing },
    result.Crossings, result.Nodes, pass.Execute, result.Graph);
  pass.Finish(Stage::ThinArcs);
  pass.Report(
    EmbedArcs({ result.Grid, result.Nodes, result.Crossings, result.Graph }, pass.Execute));
  pass.Finish(Stage::EmbedArcs);
  contours = Contours();
  return pass.GoOn();
}

/// Of the differences of slices at all node points.
double SumOfSquaredDifferences(const NodePoints& nodes)
{
  double sum = 0.0;
  for (const double difference : nodes.Difference)
  {
    sum += difference * difference;
  }
  return sum;
}

}

bool ConnectGraph(Pass& pass)
{
  PatchAllCells(
    pass.Settings, pass.Execute, [&](Stage stage) { pass.Finish(stage); }, pass.Tables.NodeNormals,
    pass.Result);
  if (pass.ShowsDoubts()) // else they are known
  {
    ListDoubts(pass.Result);
  }
  pass.Report(DescribeShells(pass.Result));
  pass.Finish(Stage::FindUndecidedPlaces);
  return pass.GoOn();
}

bool DoSlicesAgree(const Reconstruction& result)
{
  constexpr double maximum = 0.03;
  const double sum = SumOfSquaredDifferences(result.Nodes);
  const SpatialGrid& grid = result.Grid;
  const double spacing =
    std::min({ grid.MeanSpacing(0), grid.MeanSpacing(1), grid.MeanSpacing(2) });
  return sum <=
    maximum * maximum * spacing * spacing * CountRealNodes(grid, result.Crossings, result.Nodes);
}

bool MakeSlicesAgree(Pass& pass)
{
  Reconstruction& result = pass.Result;
  StageTables& tables = pass.Tables;
  result.Crossings =
    RegisterCrossings(tables.Contours, result.Grid, pass.Execute, tables.IsolatedParts);
  tables.Edges = FileOnEdges(result.Crossings);
  pass.Finish(Stage::RegisterCrossings);
  if (!pass.GoOn())
  {
    return false;
  }
  result.Reconciled =
    ReconcileSlices({ result.Grid, result.Crossings, tables.Edges, tables.IsolatedParts },
      pass.Settings.Weights, result.InsideOut ? 1 : 0, pass.Execute);
  result.Repairs.swap(result.Reconciled.Repairs);
  pass.Report(pass.Inserted);
  pass.Finish(Stage::ReconcileSlices);
  result.Nodes = PairNodePoints(
    result.Grid, result.Crossings, tables.Edges, pass.Settings.Weights, pass.Execute);
  pass.Finish(Stage::PairNodePoints);
  tables.Edges = EdgeRegister();
  return true;
}

bool DrawGraph(Pass& pass) { return MakeSlicesAgree(pass) && BuildGraph(pass); }

bool ConnectContours(Pass& pass) { return DrawGraph(pass) && ConnectGraph(pass); }

namespace
{
/// How far slices are from each other, RMS, in world units.
double DisagreementOf(const Reconstruction& result)
{
  const Index count = CountRealNodes(result.Grid, result.Crossings, result.Nodes);
  return std::sqrt(SumOfSquaredDifferences(result.Nodes) / std::max<Index>(1, count));
}

/// The processes that make the surface together; one alone if it is not divided.
Ranks ProcessesOf(const Pass& pass)
{
  return pass.Result.Part ? *pass.Settings.Processes : Ranks();
}

/// As accurate as asked for, in spacings, but not much more than the slices are; 0 for all
/// triangles.
double AccuracyOf(const PatchOptions& patching, const Pass& pass)
{
  const Reconstruction& result = pass.Result;
  if (!GivesNormals(patching.Method) || !patching.IsLight())
  {
    return 0.0;
  }
  const double spacing = MinMeanSpacing(result.Grid);
  double accuracy = patching.Accuracy;
  if (!(accuracy > 0.0))
  {
    const CycleGeometry geometry = GeometryOf(result);
    const PatchTables tables{ geometry, result.Cells, result.Normals, result.Surface.CentralPoints,
      result.Surface.Meshes };
    const double error = FitError(tables, pass.Execute, ProcessesOf(pass)) / spacing;
    const double few = std::max(LeastShare, std::min(1.0, result.Cycles.Count() / ManyPatches));
    accuracy = std::max(
      LeastAccuracy, std::min(AccuracyByError * error, few * AccuracyByRoot * std::sqrt(error)));
  }
  return std::max(accuracy, ShareOfDisagreement * DisagreementOf(result) / spacing);
}

/// Normals along the contours, if patches are made from them.
void FindNormals(const PatchOptions& patching, Pass& pass)
{
  Reconstruction& result = pass.Result;
  const CycleGeometry geometry = GeometryOf(result);
  if (NeedsNormals(patching.Method))
  {
    result.Normals = EstimateNormals(geometry, patching.CornerAngle,
      TiltOfDomes(geometry, result.Surface.CentralPoints, result.Surface.Meshes), pass.Execute,
      ProcessesOf(pass));
  }
  pass.Finish(Stage::EstimateNormals);
}

/// The points that triangles have on contours, if they are to be few.
LightGraph DrawOutlines(double accuracy, Pass& pass)
{
  Reconstruction& result = pass.Result;
  const CycleGeometry geometry = GeometryOf(result);
  LightGraph light;
  if (accuracy > 0.0 && !pass.Settings.Patching.KeepContours)
  {
    light = LightenArcs({ geometry, result.Cells, result.Surface.Meshes, result.Normals },
      ShareOfArcs * accuracy, pass.Execute);
  }
  pass.Finish(Stage::LightenArcs);
  return light;
}

/// Whether triangles are improved, which takes all of them.
bool AreToBeImproved(double accuracy, const SpatialGrid& grid)
{
  return accuracy > 0.0 && grid.Metric.IsWorld();
}

/// Fills all cycles, or those of the part, and lays the patches out as triangles.
void LayOutPatches(const PatchOptions& patching, LightGraph&& light, Pass& pass)
{
  Reconstruction& result = pass.Result;
  result.Surface.Inner = BuildInnerPatches(
    { GeometryOf(result), result.Cells, result.Normals, result.Surface.CentralPoints,
      result.Surface.Meshes, light.Any() ? &light : nullptr },
    patching, pass.Execute);
  const bool ofAll = patching.Part == nullptr || AreToBeImproved(patching.Accuracy, result.Grid);
  if (patching.Part != nullptr && ofAll)
  {
    result.Surface.Inner = JoinParts(ProcessesOf(pass), result.Surface.Inner);
  }
  if (light.Any())
  {
    result.Drawn = std::move(result.Graph);
    result.Graph = std::move(light.Graph);
    result.Nodes.Position.swap(light.Positions);
    std::swap(result.Normals, light.Normals);
  }
  if (!GivesNormals(patching.Method))
  {
    result.Normals = {}; // those of the triangles say more
  }
  pass.Finish(Stage::BuildInnerPatches);
  LayOutTriangles(result.Graph, result.Cycles, result.Surface, ofAll ? nullptr : patching.Part);
  pass.Finish(Stage::LayOutTriangles);
}

/// What may be done to triangles, without points that are kept.
ImprovementLimits LimitsOf(double accuracy, const SpatialGrid& grid)
{
  ImprovementLimits limits;
  limits.Tolerance = ShareOfTriangles * accuracy * MinMeanSpacing(grid);
  limits.SmallAngle = GoodAngle;
  return limits;
}

/// Triangles of good shape, if they are to be few.
void ImproveIfLight(double accuracy, Pass& pass)
{
  Reconstruction& result = pass.Result;
  if (AreToBeImproved(accuracy, result.Grid))
  {
    ImprovementLimits limits = LimitsOf(accuracy, result.Grid);
    limits.Kept = pass.Settings.Patching.KeepContours ? result.Graph.Count() : 0;
    ImproveSurface(
      GeometryOf(result), result.Normals, limits, pass.Execute, result.Surface, ProcessesOf(pass));
    if (result.Part)
    {
      result.Part = KeepPart(*pass.Settings.Processes, result.Surface);
    }
  }
  pass.Finish(Stage::ImproveSurface);
}
}

void DivideSurface(Pass& pass)
{
  const Ranks* processes = pass.Settings.Processes;
  if (processes != nullptr && processes->AreSeveral() && pass.Settings.Patching.Shared == nullptr)
  {
    pass.Result.Part =
      DivideCycles(GeometryOf(pass.Result), pass.Result.Surface.Meshes, *processes);
  }
}

bool FillCycles(const PatchOptions& options, Pass& pass)
{
  PatchOptions patching = options;
  patching.Part = pass.Result.Part ? &*pass.Result.Part : nullptr;
  FindNormals(patching, pass);
  patching.Accuracy = AccuracyOf(options, pass);
  pass.Result.Accuracy = options.KeepContours ? 0.0 : patching.Accuracy;
  LayOutPatches(patching, DrawOutlines(patching.Accuracy, pass), pass);
  ImproveIfLight(patching.Accuracy, pass);
  return pass.GoOn();
}

bool FillTogether(
  const PatchOptions& options, const std::vector<Pass*>& structures, double& accuracy)
{
  PatchOptions patching = options;
  patching.Accuracy = HUGE_VAL;
  std::deque<CycleGeometry> geometries;
  std::vector<ArcSurface> surfaces;
  for (Pass* pass : structures)
  {
    FindNormals(options, *pass);
    Reconstruction& result = pass->Result;
    patching.Accuracy = std::min(patching.Accuracy, AccuracyOf(options, *pass));
    geometries.push_back(GeometryOf(result));
    surfaces.push_back({ geometries.back(), result.Cells, result.Surface.Meshes, result.Normals });
  }
  std::vector<LightGraph> light(structures.size());
  if (patching.Accuracy > 0.0 && !structures.empty() && !patching.KeepContours)
  {
    light =
      LightenStructures(surfaces, ShareOfArcs * patching.Accuracy, structures.front()->Execute);
  }
  accuracy = structures.empty() ? 0.0 : patching.Accuracy;
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    structures[i]->Result.Accuracy = options.KeepContours ? 0.0 : patching.Accuracy;
    structures[i]->Finish(Stage::LightenArcs);
    LayOutPatches(patching, std::move(light[i]), *structures[i]);
    structures[i]->Finish(Stage::ImproveSurface);
    if (!structures[i]->GoOn())
    {
      return false;
    }
  }
  return true;
}

void ImproveTogether(double accuracy, const PatchOptions& patching,
  const std::vector<StructureSurface>& structures, const Execution& execution)
{
  if (!structures.empty() && AreToBeImproved(accuracy, structures.front().Geometry.Grid))
  {
    ImproveStructures(structures, LimitsOf(accuracy, structures.front().Geometry.Grid),
      patching.KeepContours, execution);
  }
}
}
