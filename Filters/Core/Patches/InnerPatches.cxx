// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/InnerPatches.h"

#include "Core/Cells/FindContacts.h"
#include "Core/Patches/CoonsPatch.h"
#include "Core/Patches/CreasePatch.h"

#include <algorithm>

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
/// Cycles that are filled together: the parts do not depend on the number of threads.
constexpr std::size_t BlockSize = 256;

class PatchFiller
{
public:
  PatchFiller(const CycleGeometry& geometry, const SurfaceNormals& normals,
    const std::vector<double>& centralPoints, const std::vector<PatchMesh>& meshes,
    const PatchOptions& options)
    : Geometry(geometry)
    , Normals(normals)
    , CentralPoints(centralPoints)
    , Meshes(meshes)
    , Method(options.Method)
    , Parts(std::max<Index>(1, static_cast<Index>(std::lround(0.5 / options.EdgeLength))))
    , MeshOf(geometry.Cycles.Count(), -1)
  {
    const double spacing = MinMeanSpacing(geometry.Grid);
    this->Resolution = { options.EdgeLength * spacing, options.ChordTolerance * spacing };
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
      for (const Index cycle : meshes[i].Cycles)
      {
        this->MeshOf[cycle] = static_cast<Index>(i);
      }
    }
  }

  InnerPatches Fill(std::size_t begin, std::size_t end) const;
  /// The patches that touch others of their cell.
  std::vector<Index> FindTouching(
    const Index* first, const Index* last, const InnerPatches& patches) const;

private:
  Point3 CentralPoint(Index cycle) const
  {
    const double* p = this->CentralPoints.data() + 3 * static_cast<std::size_t>(cycle);
    return { p[0], p[1], p[2] };
  }
  struct Workshop;
  bool Build(Index cycle, Workshop& shop) const;
  Index AddTo(CellTriangles& all, Index cycle, const InnerPatches& patches) const;

  const CycleGeometry& Geometry;
  const SurfaceNormals& Normals;
  const std::vector<double>& CentralPoints;
  const std::vector<PatchMesh>& Meshes;
  PatchMethod Method;
  Index Parts; ///< of the sides of Coons patches
  PatchResolution Resolution;
  std::vector<Index> MeshOf; ///< of each cycle, or -1
};

/// What filling a polygon takes, reused from one to the next.
struct PatchFiller::Workshop
{
  SmoothPatchBuilder Smooth;
  PatchBorder Border;
  InnerPatch Patch, Crease;
};

bool PatchFiller::Build(Index cycle, Workshop& shop) const
{
  const SpatialGrid& grid = this->Geometry.Grid;
  if (this->Method == PatchMethod::Coons)
  {
    return BuildCoonsPatch(grid, shop.Border, this->CentralPoint(cycle), this->Parts, shop.Patch);
  }
  const bool smooth = shop.Smooth.Build(shop.Border, shop.Patch);
  if (!HasCorner(shop.Border, this->Normals.Corners))
  {
    return smooth;
  }
  const double deviation = BuildCreasePatch(grid, shop.Border, this->Normals.Corners, shop.Crease);
  if (std::isfinite(deviation) && (!smooth || deviation < shop.Smooth.Deviation()))
  {
    std::swap(shop.Patch, shop.Crease);
    return true;
  }
  return smooth;
}

InnerPatches PatchFiller::Fill(std::size_t begin, std::size_t end) const
{
  InnerPatches result;
  Workshop shop{ { this->Geometry.Grid, this->Resolution }, {}, {}, {} };
  for (std::size_t i = begin; i < end; ++i)
  {
    const Index cycle = static_cast<Index>(i);
    if (this->MeshOf[cycle] >= 0 ||
      (this->Method == PatchMethod::Coons && this->Geometry.IsLoop(cycle)))
    {
      continue;
    }
    shop.Border.Set(this->Geometry, this->Normals, cycle);
    // Which point is the first one depends on the order of the contours; the patch does not.
    const Index first = shop.Border.Turn(), size = shop.Border.Count();
    if (!this->Build(cycle, shop))
    {
      continue;
    }
    for (auto& triangle : shop.Patch.Triangles)
    {
      for (Index& corner : triangle)
      {
        corner = corner >= 0 ? (corner + first) % size : corner;
      }
    }
    result.Add(cycle, shop.Patch);
  }
  return result;
}

/// The patch of a cycle, or the one of several cycles that this is the first of. Its number, or -1 if
/// it is no inner one.
Index PatchFiller::AddTo(CellTriangles& all, Index cycle, const InnerPatches& patches) const
{
  const auto number = std::lower_bound(patches.Cycle.begin(), patches.Cycle.end(), cycle);
  if (number != patches.Cycle.end() && *number == cycle)
  {
    const std::size_t i = static_cast<std::size_t>(number - patches.Cycle.begin());
    const std::int64_t* points = patches.PointOffsets.data() + i;
    const std::int64_t* triangles = patches.TriangleOffsets.data() + i;
    all.AddPatch(PatchKind::Fan, { cycle },
      { patches.Points.data() + 3 * points[0], static_cast<std::size_t>(points[1] - points[0]),
        patches.Corners.data() + 3 * triangles[0],
        static_cast<std::size_t>(triangles[1] - triangles[0]) });
    return static_cast<Index>(i);
  }
  const Index mesh = this->MeshOf[cycle];
  if (mesh >= 0)
  {
    all.AddMesh(this->Meshes[mesh]);
    // It is known by now not to touch itself.
    all.Kinds.back() = PatchKind::Fan;
  }
  else
  {
    all.AddFan(cycle, this->CentralPoint(cycle));
  }
  return -1;
}

std::vector<Index> PatchFiller::FindTouching(
  const Index* first, const Index* last, const InnerPatches& patches) const
{
  CellTriangles all(this->Geometry);
  std::vector<Index> inner; // of each patch of the cell, its number, or -1
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    const Index mesh = this->MeshOf[*cycle];
    if (mesh < 0 || this->Meshes[mesh].Cycles.front() == *cycle)
    {
      inner.push_back(this->AddTo(all, *cycle, patches));
    }
  }
  std::vector<Index> touching;
  for (const auto& contact : FindContacts(all))
  {
    for (const Index patch : { contact.first, contact.second })
    {
      if (inner[patch] >= 0)
      {
        touching.push_back(inner[patch]);
      }
    }
  }
  return touching;
}

/// Takes out patches until none touches another of its cell. The fans that take their place do not.
InnerPatches TakeOutTouching(const CellGroups& cells, const PatchFiller& filler,
  InnerPatches&& patches, const Execution& execution)
{
  InnerPatches result = std::move(patches);
  std::vector<std::pair<Index, Index>> ranges = cells.Several;
  while (!ranges.empty())
  {
    std::vector<std::vector<Index>> touching(ranges.size());
    execution.For(ranges.size(),
      [&](std::size_t begin, std::size_t end)
      {
        const Index* cycles = cells.Cycles.data();
        for (std::size_t i = begin; i < end; ++i)
        {
          touching[i] =
            filler.FindTouching(cycles + ranges[i].first, cycles + ranges[i].second, result);
        }
      });
    std::vector<std::pair<Index, Index>> again;
    std::vector<std::uint8_t> isOut(result.Cycle.size(), 0);
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      for (const Index patch : touching[i])
      {
        isOut[patch] = 1;
      }
      if (!touching[i].empty())
      {
        again.push_back(ranges[i]);
      }
    }
    if (!again.empty())
    {
      InnerPatches others;
      for (Index i = 0; i < result.Count(); ++i)
      {
        if (isOut[i] == 0)
        {
          others.Add(result, i);
        }
      }
      result = std::move(others);
    }
    ranges = std::move(again);
  }
  return result;
}
}

InnerPatches BuildInnerPatches(const CycleGeometry& geometry, const CellGroups& cells,
  const SurfaceNormals& normals, const std::vector<double>& centralPoints,
  const std::vector<PatchMesh>& meshes, const PatchOptions& options, const Execution& execution)
{
  if (options.Method == PatchMethod::Fan)
  {
    return {};
  }
  const PatchFiller filler(geometry, normals, centralPoints, meshes, options);
  const std::size_t count = static_cast<std::size_t>(geometry.Cycles.Count());
  std::vector<InnerPatches> blocks((count + BlockSize - 1) / BlockSize);
  execution.For(blocks.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        blocks[i] = filler.Fill(i * BlockSize, std::min(count, (i + 1) * BlockSize));
      }
    });
  InnerPatches result;
  std::size_t points = 0, corners = 0, patches = 0;
  for (const InnerPatches& block : blocks)
  {
    points += block.Points.size();
    corners += block.Corners.size();
    patches += block.Cycle.size();
  }
  result.Points.reserve(points);
  result.Normals.reserve(points);
  result.Corners.reserve(corners);
  result.Cycle.reserve(patches);
  for (InnerPatches& block : blocks)
  {
    for (Index i = 0; i < block.Count(); ++i)
    {
      result.Add(block, i);
    }
    block = {};
  }
  return TakeOutTouching(cells, filler, std::move(result), execution);
}
}
