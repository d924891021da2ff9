// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/InnerPatches.h"

#include "Core/Patches/CoonsPatch.h"
#include "Core/Patches/CreasePatch.h"
#include "Core/Patches/DivideCycles.h"
#include "Core/Patches/RemoveTouching.h"
#include "Core/Patches/SharedPatches.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
void InnerPatches::Add(Index cycle, const InnerPatch& patch)
{
  this->Cycle.push_back(cycle);
  for (std::size_t i = 0; i < patch.Points.size(); ++i)
  {
    this->Points.insert(this->Points.end(), patch.Points[i].begin(), patch.Points[i].end());
    this->Normals.insert(this->Normals.end(), patch.Normals[i].begin(), patch.Normals[i].end());
  }
  for (const std::array<Index, 3>& triangle : patch.Triangles)
  {
    this->Corners.insert(this->Corners.end(), triangle.begin(), triangle.end());
  }
  this->PointOffsets.push_back(static_cast<std::int64_t>(this->Points.size() / 3));
  this->TriangleOffsets.push_back(static_cast<std::int64_t>(this->Corners.size() / 3));
}

void InnerPatches::Add(const InnerPatches& others, Index patch)
{
  const auto append = [](const auto& from, std::int64_t first, std::int64_t last, auto& to)
  { to.insert(to.end(), from.begin() + first, from.begin() + last); };
  this->Cycle.push_back(others.Cycle[patch]);
  const std::int64_t* points = others.PointOffsets.data() + patch;
  const std::int64_t* triangles = others.TriangleOffsets.data() + patch;
  append(others.Points, 3 * points[0], 3 * points[1], this->Points);
  append(others.Normals, 3 * points[0], 3 * points[1], this->Normals);
  append(others.Corners, 3 * triangles[0], 3 * triangles[1], this->Corners);
  this->PointOffsets.push_back(this->PointOffsets.back() + points[1] - points[0]);
  this->TriangleOffsets.push_back(this->TriangleOffsets.back() + triangles[1] - triangles[0]);
}

namespace
{
/// Cycles that are filled together, by one thread: how they are put together does not depend on the
/// number of threads. Some hundred polygons make thousands of triangles: blocks are few, and there
/// are many for each thread.
constexpr std::size_t BlockSize = 256;

/// Mean radii of a patch for one of EdgeLength, where these are measured in patches: that of a
/// square as wide as slices are apart is 0.58 of that, so that the default makes sides of about
/// half its width.
constexpr double RadiiOfEdge = 4.0;

/// What filling a polygon takes, and the memory for it, reused from one polygon to the next.
struct Workshop
{
  Workshop(const PatchTables& tables, const PatchOptions& options)
    : Tables(tables)
    , Options(options)
    , Outlines(OutlinesOf(tables))
    , Smooth(tables.Geometry.Grid, ResolutionOf(tables.Geometry.Grid, options))
  {
  }

  static PatchResolution ResolutionOf(const SpatialGrid& grid, const PatchOptions& options)
  {
    const double spacing = MinMeanSpacing(grid);
    if (options.Accuracy > 0.0)
    {
      return { RadiiOfEdge * options.EdgeLength, 0.0, options.Accuracy, options.KeepContours };
    }
    return { options.EdgeLength * spacing, options.ChordTolerance * spacing };
  }

  /// The polygons that the triangles have as their borders.
  static CycleGeometry OutlinesOf(const PatchTables& tables)
  {
    const CycleGeometry& geometry = tables.Geometry;
    return { geometry.Grid, tables.Light ? tables.Light->Graph : geometry.Graph, geometry.Crossings,
      geometry.Nodes, geometry.Cycles };
  }

  /// Where the triangles' vertices are.
  const PatchBorder& Outline() const
  {
    return this->Tables.Light ? this->LightBorder : this->Border;
  }
  const std::vector<std::uint8_t>& Corners() const
  {
    return this->Tables.Light ? this->Tables.Light->Normals.Corners : this->Tables.Normals.Corners;
  }

  const PatchTables& Tables;
  const PatchOptions& Options;
  Index Cycle = 0;    ///< the polygon to be filled
  PatchBorder Border; ///< and its border, which starts where the order of contours does not matter
  PatchBorder LightBorder; ///< with fewer points, if there is a LightGraph
  InnerPatch Patch;        ///< the result
  CycleGeometry Outlines;
  SmoothPatchBuilder Smooth;
  InnerPatch Crease;
};

/**
 * Builds the patch of one polygon: from shop.Cycle and shop.Border to shop.Patch. False if that is
 * impossible. One function for each patch type; REQUIRES of it what InnerPatches.h says.
 */
using FillPolygon = bool (*)(Workshop& shop);

/// The better one of a smooth surface and, if the border has corners, a crease.
bool FillSmoothly(Workshop& shop)
{
  const std::vector<std::uint8_t>& corners = shop.Corners();
  const PatchBorder& outline = shop.Outline();
  const bool smooth = shop.Smooth.Build(shop.Border, outline, shop.Patch);
  if (!HasCorner(outline, corners))
  {
    return smooth;
  }
  const double deviation =
    BuildCreasePatch(shop.Tables.Geometry.Grid, outline, corners, shop.Crease);
  if (std::isfinite(deviation) && (!smooth || deviation < shop.Smooth.Deviation()))
  {
    std::swap(shop.Patch, shop.Crease);
    return true;
  }
  return smooth;
}

/// The paper's quadrilaterals, bilinearly blended. Loops have none, as they have no node points.
bool FillWithCoons(Workshop& shop)
{
  if (shop.Tables.Geometry.IsLoop(shop.Cycle))
  {
    return false;
  }
  const Index parts =
    std::max<Index>(1, static_cast<Index>(std::lround(0.5 / shop.Options.EdgeLength)));
  return BuildCoonsPatch(shop.Tables.Geometry.Grid, shop.Outline(),
    shop.Tables.CentralPoint(shop.Cycle), parts, shop.Patch);
}

/// The function that builds patches of a type; none for fans, which need no points inside.
FillPolygon FillerOf(PatchMethod method)
{
  switch (method)
  {
    case PatchMethod::Smooth:
      return FillSmoothly;
    case PatchMethod::Coons:
      return FillWithCoons;
    case PatchMethod::Fan:
      break;
  }
  return nullptr;
}

/// Numbers the corners of triangles on a border of so many points from another first one on.
void TurnCorners(Index first, Index size, std::vector<std::array<Index, 3>>& triangles)
{
  for (auto& triangle : triangles)
  {
    for (Index& corner : triangle)
    {
      corner = corner >= 0 ? (corner + first) % size : corner;
    }
  }
}

/// Fills those polygons of a block that are chosen and no part of a mesh, as far as possible.
InnerPatches FillBlock(FillPolygon fill, Workshop& shop, const ChosenCycles& chosen,
  const std::vector<Index>& meshOf, std::size_t block)
{
  InnerPatches result;
  const std::size_t end = std::min(meshOf.size(), (block + 1) * BlockSize);
  for (std::size_t i = block * BlockSize; i < end; ++i)
  {
    shop.Cycle = static_cast<Index>(i);
    if (meshOf[i] >= 0 || !chosen.Has(i))
    {
      continue;
    }
    shop.Border.Set(shop.Tables.Geometry, shop.Tables.Normals, shop.Cycle);
    // Which point is the first one depends on the order of the contours; the patch does not.
    Index first = shop.Border.Turn();
    if (shop.Tables.Light)
    {
      shop.LightBorder.Set(shop.Outlines, shop.Tables.Light->Normals, shop.Cycle);
      first = shop.LightBorder.Turn();
    }
    const Index size = shop.Outline().Count();
    const SharedPatches* shared = shop.Options.Shared;
    const bool isShared = shared != nullptr && shared->Find(shop.Outline(), shop.Patch);
    if (!isShared && !fill(shop))
    {
      continue;
    }
    TurnCorners(first, size, shop.Patch.Triangles);
    result.Add(shop.Cycle, shop.Patch);
  }
  return result;
}

/// Where the patches of a block begin among all.
struct BlockStart
{
  std::size_t Patch = 0;
  std::int64_t Point = 0, Triangle = 0;

  BlockStart After(const InnerPatches& block) const
  {
    return { this->Patch + block.Cycle.size(), this->Point + block.PointOffsets.back(),
      this->Triangle + block.TriangleOffsets.back() };
  }
};

/// Copies the patches of a block to their place among all, and releases it.
void MoveBlock(const BlockStart& start, InnerPatches& block, InnerPatches& all)
{
  std::copy(block.Cycle.begin(), block.Cycle.end(), all.Cycle.begin() + start.Patch);
  for (std::size_t i = 0; i < block.Cycle.size(); ++i)
  {
    all.PointOffsets[start.Patch + i + 1] = start.Point + block.PointOffsets[i + 1];
    all.TriangleOffsets[start.Patch + i + 1] = start.Triangle + block.TriangleOffsets[i + 1];
  }
  std::copy(block.Points.begin(), block.Points.end(), all.Points.begin() + 3 * start.Point);
  std::copy(block.Normals.begin(), block.Normals.end(), all.Normals.begin() + 3 * start.Point);
  std::copy(block.Corners.begin(), block.Corners.end(), all.Corners.begin() + 3 * start.Triangle);
  block = {};
}

/// All patches of the blocks, in their order. Empties the blocks.
InnerPatches PutTogether(std::vector<InnerPatches>& blocks, const Execution& execution)
{
  std::vector<BlockStart> starts(1);
  for (const InnerPatches& block : blocks)
  {
    starts.push_back(starts.back().After(block));
  }
  const BlockStart& end = starts.back();
  InnerPatches result;
  result.Cycle.resize(end.Patch);
  result.PointOffsets.resize(end.Patch + 1);
  result.TriangleOffsets.resize(end.Patch + 1);
  result.Points.resize(3 * end.Point);
  result.Normals.resize(3 * end.Point);
  result.Corners.resize(3 * end.Triangle);
  execution.For(blocks.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        MoveBlock(starts[i], blocks[i], result);
      }
    });
  return result;
}

/// A patch as it was put together.
InnerPatch PatchAt(const InnerPatches& patches, Index patch)
{
  InnerPatch result;
  for (auto i = patches.PointOffsets[patch]; i < patches.PointOffsets[patch + 1]; ++i)
  {
    const float* normal = patches.Normals.data() + 3 * i;
    result.Points.push_back(patches.PointAt(i));
    result.Normals.push_back({ normal[0], normal[1], normal[2] });
  }
  for (auto i = patches.TriangleOffsets[patch]; i < patches.TriangleOffsets[patch + 1]; ++i)
  {
    const Index* corners = patches.Corners.data() + 3 * i;
    result.Triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  return result;
}

/// The fan of a cycle with so many points on its border.
InnerPatch FanAround(const Point3& center, Index size)
{
  InnerPatch fan;
  fan.Points.push_back(center);
  fan.Normals.push_back({ 0.0, 0.0, 0.0 });
  for (Index i = 0; i < size; ++i)
  {
    fan.Triangles.push_back({ i, (i + 1) % size, -1 });
  }
  return fan;
}

/// Keeps all patches of one cycle, fans included, for structures with the same borders.
void Share(const PatchTables& tables, const std::vector<Index>& meshOf, const InnerPatches& patches,
  SharedPatches& shared)
{
  PatchBorder border;
  Index next = 0;
  for (Index cycle = 0; cycle < tables.Geometry.Cycles.Count(); ++cycle)
  {
    if (meshOf[cycle] >= 0)
    {
      continue;
    }
    border.Set(
      Workshop::OutlinesOf(tables), tables.Light ? tables.Light->Normals : tables.Normals, cycle);
    const Index first = border.Turn(), size = border.Count();
    const bool isInner = next < patches.Count() && patches.Cycle[next] == cycle;
    InnerPatch patch =
      isInner ? PatchAt(patches, next) : FanAround(tables.CentralPoint(cycle), size);
    next += isInner ? 1 : 0;
    TurnCorners(size - first, size, patch.Triangles);
    shared.Add(border, patch);
  }
}
}

bool NeedsNormals(PatchMethod method) { return method != PatchMethod::Fan; }

bool GivesNormals(PatchMethod method) { return method == PatchMethod::Smooth; }

InnerPatches BuildInnerPatches(
  const PatchTables& tables, const PatchOptions& options, const Execution& execution)
{
  const FillPolygon fill = FillerOf(options.Method);
  if (fill == nullptr)
  {
    return {};
  }
  const std::size_t count = static_cast<std::size_t>(tables.Geometry.Cycles.Count());
  std::vector<Index> meshOf(count, -1);
  for (std::size_t i = 0; i < tables.Meshes.size(); ++i)
  {
    for (const Index cycle : tables.Meshes[i].Cycles)
    {
      meshOf[cycle] = static_cast<Index>(i);
    }
  }
  const ChosenCycles chosen(tables.Cells, count, options.Part);
  std::vector<InnerPatches> blocks((count + BlockSize - 1) / BlockSize);
  execution.For(blocks.size(),
    [&](std::size_t begin, std::size_t end)
    {
      Workshop shop(tables, options);
      for (std::size_t i = begin; i < end; ++i)
      {
        blocks[i] = FillBlock(fill, shop, chosen, meshOf, i);
      }
    });
  InnerPatches patches = PutTogether(blocks, execution);
  const CycleGeometry outlines = Workshop::OutlinesOf(tables);
  RemoveTouching({ outlines, chosen.Cells(), tables.Normals, tables.CentralPoints, tables.Meshes },
    meshOf, execution, patches);
  chosen.LeaveOutOthers(patches);
  if (options.Shared != nullptr)
  {
    Share(tables, meshOf, patches, *options.Shared);
  }
  return patches;
}
}
