// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEditGraph_h
#define OrthoSlicesEditGraph_h

#include "Core/Base/Execution.h"
#include "Core/Crossings/Repair.h"
#include "Core/Graph/NodeGraph.h"

#include <vector>

/**
 * @file
 * @brief every way in which G changes once BuildNodeGraph has made it
 *
 * Stages that change G look at it through const views and return what they want changed; it is
 * carried out here, so that no table changes while it is read. Who changes what:
 *
 *   table of G            written by                    for the stage
 *   Points, Offsets       BuildNodeGraph
 *                         LeaveOutVertices              ThinArcs
 *                         DrawArcs, MoveNodes           LightenArcs
 *                         MoveInsideFaces, ReplaceArcs  EmbedArcs
 *                         SetLoops                      EmbedIsolated, StitchSlabs
 *                         RemoveNodes                   RemoveComponents
 *   Loops                 SetLoops                      EmbedIsolated
 *   Redrawn               ReplaceArcs                   EmbedArcs
 *   Nodes                 BuildNodeGraph, RemoveNodes
 *   Component, Components MeasureTopology
 *
 * Of the tables that G stands on, ReplaceArcs changes where arcs lead (GridCrossings::Next and
 * Previous), and RemoveNodes takes crossings and node points out.
 */
namespace orthoslices
{
struct ArcsByFace;

/// G and the tables that it stands on, for stages that change it.
struct GraphTables
{
  const SpatialGrid& Grid;
  const NodePoints& Nodes;
  GridCrossings& Crossings;
  NodeGraph& Graph;
};

/// An arc that leads to another crossing than before.
struct ArcJoin
{
  Index Arc, Stop;
};

/// Arcs of one face that get other vertices, and the repair that this is.
struct FaceDrawing
{
  std::vector<Index> Arcs;
  std::vector<std::size_t> Offsets{ 0 }; ///< arc i gets Points[Offsets[i]] to [Offsets[i + 1] - 1]
  std::vector<Point3> Points;            ///< between the nodes of each arc
  std::vector<ArcJoin> Joins;
  Repair What{};
};

/// A loop of G: a closed curve on one face, its first point not repeated.
struct GraphLoop
{
  orthoslices::Face Face;
  std::vector<Point3> Points;
};

/// Vertices of arcs on the border of their face, or beyond it, move inside by the grid's Margin.
void MoveInsideFaces(
  const SpatialGrid& grid, const ArcsByFace& faces, const Execution& execution, NodeGraph& graph);

/// Gives arcs the vertices that were drawn for them, in the places of the old ones. Drops the
/// loops.
void ReplaceArcs(
  const std::vector<FaceDrawing>& drawings, GridCrossings& crossings, NodeGraph& graph);

/// Keeps the vertices of arcs and loops that are marked, one mark for each point after the nodes.
void LeaveOutVertices(const std::vector<std::uint8_t>& isKept, NodeGraph& graph);

/// Gives all arcs other vertices between their nodes. Loops stay.
void DrawArcs(const std::vector<std::vector<Point3>>& vertices, NodeGraph& graph);

/// Moves node points along their edges, each by so much. REQUIRES: they stay in their order.
void MoveNodes(const std::vector<double>& moves, const SpatialGrid& grid,
  const GridCrossings& crossings, NodePoints& nodes, NodeGraph& graph);

/// Replaces all loops.
void SetLoops(const std::vector<GraphLoop>& loops, NodeGraph& graph);

/**
 * Takes out the nodes that are marked, with their crossings and arcs, and drops the loops.
 * `nodeNormals` has x, y, z of each node. REQUIRES: whole components of G are marked.
 */
void RemoveNodes(const std::vector<std::uint8_t>& isRemoved, GridCrossings& crossings,
  NodePoints& nodes, std::vector<double>& nodeNormals, NodeGraph& graph);
}

#endif
