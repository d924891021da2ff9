// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the stages of the reconstruction one after another, with everything between them
 */

#ifndef OrthoSlicesStages_h
#define OrthoSlicesStages_h

#include "Core/Graph/EmbedArcs.h"
#include "Core/Reconstruct.h"
#include "Core/Pieces/AssembleContours.h"
#include "Support/CheckSurface.h"
#include "Support/RandomInput.h"
#include "Support/TextContours.h"

namespace orthoslices
{
namespace support
{

/// The tables between the stages, as Reconstruct has them up to the embedded arcs, without loops.
struct Stages
{
  /// Contours as drawn.
  explicit Stages(const std::string& text)
  {
    Options options;
    options.PlaneTolerance = Tolerance;
    options.Orient = Orientation::AsDrawn;
    options.Invalid = InvalidContours::LeaveOut;
    this->Run(ParsePieces(text), options, false);
  }

  /// With `shells`, all arcs are drawn anew.
  explicit Stages(const Input& input, bool shells = false)
  {
    this->Run(input.Sets, input.Settings, shells);
  }

  GridEdge EdgeOf(Index crossing) const
  {
    return GridEdgeCode(this->Grid).Decode(this->Crossings.Edge[crossing]);
  }

  CycleGeometry Geometry() const
  {
    return { this->Grid, this->Graph, this->Crossings, this->Nodes, this->Cycles };
  }

  static constexpr double Tolerance = 1e-9;

  Contours Set;
  SpatialGrid Grid;
  std::vector<IsolatedLoop> Isolated;
  GridCrossings Registered; ///< before reconciliation
  GridCrossings Crossings;
  EdgeRegister Edges;
  Reconciliation Reconciled;
  NodePoints Nodes;
  NodeGraph Graph;
  std::vector<Repair> Redrawn; ///< faces
  CellCycles Cycles;

private:
  void Run(PieceSets pieces, const Options& options, bool shells)
  {
    Reconstruct(std::move(pieces), options, Execution(),
      [this](Stage stage, const StageTables& tables, const Reconstruction& result)
      { this->Take(stage, tables, result); });
    std::vector<Index> forced;
    for (Index arc = 0; shells && arc < this->Crossings.Count(); ++arc)
    {
      forced.push_back(arc);
    }
    this->Redrawn =
      EmbedArcs({ this->Grid, this->Nodes, this->Crossings, this->Graph }, Execution(), forced);
    this->Cycles = TraceCycles(this->Grid, this->Crossings, this->Nodes, this->Graph);
    const SurfaceComponents components = MeasureTopology(this->Geometry(), {});
    this->Graph.Component = components.OfPart;
    this->Graph.Components = components.Topology.Components;
  }

  void Take(Stage stage, const StageTables& tables, const Reconstruction& result)
  {
    switch (stage)
    {
      case Stage::SmoothContours:
        this->Set = tables.Contours;
        this->Grid = result.Grid;
        break;
      case Stage::RegisterCrossings:
        this->Registered = result.Crossings;
        break;
      case Stage::ReconcileSlices:
        this->Crossings = result.Crossings;
        this->Isolated = tables.IsolatedParts;
        this->Edges = tables.Edges;
        this->Reconciled = result.Reconciled;
        this->Reconciled.Repairs = result.Repairs;
        break;
      case Stage::BuildNodeGraph:
        this->Nodes = result.Nodes;
        this->Graph = result.Graph;
        break;
      default:
        break;
    }
  }
};

/// The contours that take part in a reconstruction, oriented and with their planes numbered.
inline Contours UsableContours(const PieceSets& pieces, const Options& options, SpatialGrid& grid)
{
  Contours contours;
  Options untilThen = options;
  if (options.Invalid == InvalidContours::Refuse)
  {
    untilThen.Invalid = InvalidContours::LeaveOut;
  }
  bool isOriented = false;
  Execution execution;
  execution.Continue = [&](double) { return !isOriented; };
  Reconstruct(PieceSets(pieces), untilThen, execution,
    [&](Stage stage, const StageTables& tables, const Reconstruction& result)
    {
      if (stage == Stage::OrientContours)
      {
        contours = tables.Contours;
        grid = result.Grid;
        isOriented = true;
      }
    });
  return contours;
}

/**
 * A cube from 0.5 to 2.5 cut by the planes 1 and 2 of each axis. Every one of the 12 grid lines
 * meets it twice: 24 node points, 48 arcs, and a spatial polygon in every cell but the middle one:
 * 8 of three node points at the corners, 18 of four at edges and faces.
 */
inline std::string Cube(int parts = 1)
{
  const double corners[5][2] = { { 0.5, 0.5 }, { 2.5, 0.5 }, { 2.5, 2.5 }, { 0.5, 2.5 },
    { 0.5, 0.5 } };
  std::string square;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < parts; ++i)
    {
      const double share = double(i) / parts;
      const auto at = [&](int k)
      { return corners[side][k] + share * (corners[side + 1][k] - corners[side][k]); };
      square += " " + std::to_string(at(0)) + "," + std::to_string(at(1));
    }
  }
  std::string text;
  for (const char* plane : { "x=1:", "x=2:", "y=1:", "y=2:", "z=1:", "z=2:" })
  {
    text += plane + square + "\n";
  }
  return text;
}

/// One plane on each axis through the origin, each with a square around it: six node points.
inline std::string Octahedron()
{
  return "x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1; z=0: -1,-1 1,-1 1,1 -1,1";
}

} // namespace support
} // namespace orthoslices

#endif
