// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CheckInvariants.h"

#include "Core/Cells/CheckPatchMeshes.h"
#include "Core/Crossings/CheckCrossings.h"
#include "Core/Graph/CheckGraph.h"

#include <array>
#include <vector>

namespace orthoslices
{
namespace
{
/// Contours have three vertices or more, consecutive ones differ, and their planes are numbered.
std::string CheckContours(const Contours& contours, const SpatialGrid& grid)
{
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    const Index first = contours.Offsets[contour], size = contours.Size(contour);
    bool good = size >= 3;
    for (Index i = 0; good && i < size; ++i)
    {
      const Index a = first + i, b = first + (i + 1) % size;
      good = contours.U[a] != contours.U[b] || contours.V[a] != contours.V[b];
    }
    const auto& planes = grid.Planes[contours.Axis[contour]];
    const Index plane = contours.Plane[contour];
    good = good && plane >= 0 && plane < static_cast<Index>(planes.size());
    if (!good)
    {
      return "contour " + std::to_string(contour) + " is no closed curve on a plane of the grid";
    }
  }
  return {};
}

/// Patches with points inside: see CheckPatchCoversBorders.
std::string CheckInnerPatches(const CycleGeometry& geometry, const InnerPatches& patches)
{
  for (Index patch = 0; patch < patches.Count(); ++patch)
  {
    std::vector<std::array<Index, 3>> triangles;
    for (auto t = patches.TriangleOffsets[patch]; t < patches.TriangleOffsets[patch + 1]; ++t)
    {
      const Index* corners = patches.Corners.data() + 3 * t;
      triangles.push_back({ corners[0], corners[1], corners[2] });
    }
    const std::string wrong =
      CheckPatchCoversBorders(geometry, { patches.Cycle[patch] }, triangles);
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return {};
}

std::string FindViolation(Stage stage, const StageTables& tables, const Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  switch (stage)
  {
    case Stage::OrientContours:
      return CheckContours(tables.Contours, result.Grid);
    case Stage::RegisterCrossings:
      return CheckCrossingOrder(result.Crossings);
    case Stage::ReconcileSlices:
    {
      const std::string wrong = CheckCrossingOrder(result.Crossings);
      return wrong.empty() ? CheckSlicesAgree(result.Crossings, tables.Edges) : wrong;
    }
    case Stage::PairNodePoints:
      return CheckNodePoints(result.Crossings, result.Nodes);
    case Stage::BuildNodeGraph:
    case Stage::ThinArcs:
      return CheckFourArcs(result.Crossings, result.Nodes, result.Graph);
    case Stage::EmbedArcs:
    case Stage::EmbedIsolated:
    {
      const std::string wrong = CheckFourArcs(result.Crossings, result.Nodes, result.Graph);
      return wrong.empty()
        ? CheckEmbedding(result.Grid, result.Crossings, result.Nodes, result.Graph)
        : wrong;
    }
    case Stage::TraceCycles:
      return CheckCycles(geometry);
    case Stage::StitchSlabs:
      return CheckEmbedding(result.Grid, result.Crossings, result.Nodes, result.Graph);
    case Stage::SeparatePatches:
      return CheckPatchMeshes(geometry, result.Surface.Meshes);
    case Stage::BuildInnerPatches:
    {
      const std::string wrong =
        CheckEmbedding(result.Grid, result.Crossings, result.Nodes, result.Graph);
      return wrong.empty() ? CheckInnerPatches(geometry, result.Surface.Inner) : wrong;
    }
    default:
      return {};
  }
}
}

std::string CheckInvariants(Stage stage, const StageTables& tables, const Reconstruction& result)
{
  const std::string wrong = FindViolation(stage, tables, result);
  return wrong.empty() ? wrong : std::string("After ") + NameOf(stage) + ": " + wrong + ".";
}
}
