// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/StructurePatches.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Where common points stay away from the faces of their cell, as a share of its width.
constexpr double CommonPointMargin = 0.05;

/// The corners of triangles, whatever their order and direction.
std::set<std::set<Point3>> CornersOf(const std::vector<PatchTriangle>& triangles)
{
  std::set<std::set<Point3>> corners;
  for (const PatchTriangle& triangle : triangles)
  {
    corners.insert({ triangle.Corners[0], triangle.Corners[1], triangle.Corners[2] });
  }
  return corners;
}

/// A border from its least number towards the lesser one of the neighbours.
std::vector<Index> Canonical(std::vector<Index> border)
{
  std::rotate(border.begin(), std::min_element(border.begin(), border.end()), border.end());
  if (border.back() < border[1])
  {
    std::reverse(border.begin() + 1, border.end());
  }
  return border;
}

/// Where a fan in the place of a patch has its center: the middle of what is inside the patch.
Point3 CenterOf(const CellPatch& patch)
{
  std::set<Point3> inner;
  for (const PatchTriangle& triangle : patch.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (triangle.Ids[i] < 0)
      {
        inner.insert(triangle.Corners[i]);
      }
    }
  }
  Point3 center{ 0.0, 0.0, 0.0 };
  for (const Point3& point : inner)
  {
    center = center + (1.0 / static_cast<double>(inner.size())) * point;
  }
  return inner.empty() ? patch.Center : center;
}
}

void StructurePatches::Set(const std::vector<StructureCycle>& cycles)
{
  this->ByBorder.clear();
  this->Patches.clear();
  this->PatchesAt.clear();
  for (const StructureCycle& cycle : cycles)
  {
    this->AddCycle(cycle);
  }
  for (Index i = 0; i < this->Count(); ++i)
  {
    this->Patches[i].VisitSides(
      [&](Index a, Index b) { this->PatchesAt[CellEdgeOf(a, b)].push_back(i); });
  }
}

Index StructurePatches::NumberOf(const Point3& point)
{
  const auto [place, isNew] = this->Numbers.emplace(point, static_cast<Index>(this->Places.size()));
  if (isNew)
  {
    this->Places.push_back(point);
  }
  return place->second;
}

/// The triangles of the patch that a cycle is part of.
void StructurePatches::AddTriangles(const StructureCycle& cycle, CellPatch& patch)
{
  const StructureSurface& structure = this->Structures[cycle.Structure];
  const orthoslices::Patches& surface = structure.Surface;
  CellTriangles triangles(structure.Geometry);
  const std::vector<Index>& inner = surface.Inner.Cycle;
  const auto found = std::lower_bound(inner.begin(), inner.end(), cycle.Cycle);
  if (found != inner.end() && *found == cycle.Cycle)
  {
    const std::size_t i = static_cast<std::size_t>(found - inner.begin());
    const std::int64_t* points = surface.Inner.PointOffsets.data() + i;
    const std::int64_t* corners = surface.Inner.TriangleOffsets.data() + i;
    triangles.AddPatch(PatchKind::Fan, { cycle.Cycle },
      { surface.Inner.Points.data() + 3 * points[0],
        static_cast<std::size_t>(points[1] - points[0]),
        surface.Inner.Corners.data() + 3 * corners[0],
        static_cast<std::size_t>(corners[1] - corners[0]) });
  }
  else if (patch.Mesh != nullptr)
  {
    triangles.AddMesh(*patch.Mesh);
  }
  else
  {
    triangles.AddFan(cycle.Cycle, patch.Center);
  }
  patch.Triangles = std::move(triangles.Triangles);
}

/// Gives corners the numbers of the cell; points inside patches have theirs below zero.
void StructurePatches::NumberCorners(Index number, std::vector<PatchTriangle>& triangles)
{
  for (PatchTriangle& triangle : triangles)
  {
    triangle.Patch = number;
    for (int i = 0; i < 3; ++i)
    {
      triangle.Ids[i] = this->NumberOf(triangle.Corners[i]);
    }
  }
}

Point3 StructurePatches::MiddleOfBorder(const CellPatch& patch) const
{
  const std::vector<Index>& border = patch.Border;
  Point3 middle{ 0.0, 0.0, 0.0 };
  for (const Index point : border)
  {
    middle = middle + (1.0 / static_cast<double>(border.size())) * this->Places[point];
  }
  return middle;
}

std::vector<Index> StructurePatches::BorderOf(const StructureCycle& cycle)
{
  const CycleGeometry& geometry = this->Structures[cycle.Structure].Geometry;
  std::vector<Index> border;
  for (const Index point : geometry.GetBorders({ cycle.Cycle }))
  {
    border.push_back(this->NumberOf(geometry.Graph.PointAt(point)));
  }
  return border;
}

/// Adds the patch of a cycle, or another owner of one that was added before.
void StructurePatches::AddCycle(const StructureCycle& cycle)
{
  const StructureSurface& structure = this->Structures[cycle.Structure];
  const Index mesh = this->Tables.MeshOf[cycle.Structure][cycle.Cycle];
  CellPatch patch;
  patch.Owners.push_back(cycle);
  patch.Mesh = mesh < 0 ? nullptr : &structure.Surface.Meshes[mesh];
  if (this->Broken.count(patch.Mesh) > 0)
  {
    patch.Mesh = nullptr;
    patch.IsAmbiguous = true;
  }
  if (patch.Mesh != nullptr && patch.Mesh->Cycles.front() != cycle.Cycle)
  {
    return; // added with its first cycle
  }
  patch.IsOneCycle = patch.Mesh == nullptr || patch.Mesh->Cycles.size() == 1;
  const double* center = structure.Surface.CentralPoints.data() + 3 * std::size_t(cycle.Cycle);
  patch.Center = { center[0], center[1], center[2] };
  const std::vector<Index> cycles =
    patch.Mesh == nullptr ? std::vector<Index>{ cycle.Cycle } : patch.Mesh->Cycles;
  for (const Index member : cycles)
  {
    patch.Offsets.push_back(static_cast<Index>(patch.Border.size()));
    const std::vector<Index> border = this->BorderOf({ cycle.Structure, member });
    patch.Border.insert(patch.Border.end(), border.begin(), border.end());
  }
  patch.Offsets.push_back(static_cast<Index>(patch.Border.size()));
  // Where a border has two points at one place, numbers do not tell what is between them.
  const std::set<Index> distinct(patch.Border.begin(), patch.Border.end());
  patch.IsOneCycle = patch.IsOneCycle && distinct.size() == patch.Border.size();
  this->AddTriangles(cycle, patch);
  patch.Center = patch.IsAmbiguous ? this->MiddleOfBorder(patch) : CenterOf(patch);
  const Index number = static_cast<Index>(this->Patches.size());
  if (patch.IsOneCycle)
  {
    const auto [place, isNew] = this->ByBorder.emplace(Canonical(patch.Border), number);
    if (!isNew)
    {
      CellPatch& same = this->Patches[place->second];
      same.Owners.push_back(cycle);
      same.IsAmbiguous |= CornersOf(same.Triangles) != CornersOf(patch.Triangles);
      return;
    }
  }
  this->NumberCorners(number, patch.Triangles);
  this->Patches.push_back(std::move(patch));
}

/// Patches that touch. Triangles that several patches have count once.
std::vector<std::pair<Index, Index>> StructurePatches::FindContactsOf(const PatchGroup& group) const
{
  std::vector<PatchTriangle> triangles;
  std::set<std::array<Index, 3>> known;
  for (const Index patch : group)
  {
    for (const PatchTriangle& triangle : this->Patches[patch].Triangles)
    {
      std::array<Index, 3> ids = triangle.Ids;
      std::sort(ids.begin(), ids.end());
      if (known.insert(ids).second)
      {
        triangles.push_back(triangle);
      }
    }
  }
  std::vector<PatchKind> kinds;
  for (const CellPatch& patch : this->Patches)
  {
    // Fans and what structures have made themselves are known not to touch themselves.
    kinds.push_back(patch.New.Points.size() > 1 ? PatchKind::Joined : PatchKind::Fan);
  }
  return FindContacts(triangles, kinds);
}

/// Whether the border is that of other patches before one of its points than after it.
bool StructurePatches::IsPartingPoint(const CellPatch& patch, std::size_t i) const
{
  const std::size_t size = patch.Border.size();
  const Index before = patch.Border[(i + size - 1) % size], after = patch.Border[(i + 1) % size];
  return this->PatchesAt.at(CellEdgeOf(before, patch.Border[i])) !=
    this->PatchesAt.at(CellEdgeOf(patch.Border[i], after));
}

/// None of a patch of several cycles.
std::vector<Index> StructurePatches::PartingPoints(Index number) const
{
  const CellPatch& patch = this->Patches[number];
  std::vector<Index> points;
  for (std::size_t i = 0; patch.IsOneCycle && i < patch.Border.size(); ++i)
  {
    if (this->IsPartingPoint(patch, i))
    {
      points.push_back(patch.Border[i]);
    }
  }
  return points;
}

bool StructurePatches::HasBorderOfAnother(Index number) const
{
  const CellPatch& patch = this->Patches[number];
  for (std::size_t i = 0; i + 1 < patch.Offsets.size(); ++i)
  {
    const auto found = this->ByBorder.find(Canonical(
      { patch.Border.begin() + patch.Offsets[i], patch.Border.begin() + patch.Offsets[i + 1] }));
    if (found != this->ByBorder.end() && found->second != number)
    {
      return true;
    }
  }
  return false;
}

Point3 StructurePatches::MoveInside(const PatchGroup& group, const Point3& point) const
{
  return this->MoveInside(group, point, CommonPointMargin);
}

Point3 StructurePatches::KeepInside(const PatchGroup& group, const Point3& point) const
{
  return this->MoveInside(group, point, InnerMargin);
}

/// Moves a point at least a share of the width of the cell away from its faces.
Point3 StructurePatches::MoveInside(const PatchGroup& group, Point3 point, double share) const
{
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->Patches[patch].Owners)
    {
      const CycleGeometry& geometry = this->Structures[owner.Structure].Geometry;
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = geometry.Grid.MoveInside(
          axis, geometry.Cycles.Cell[owner.Cycle][axis], point[axis], share);
      }
    }
  }
  return point;
}

/// Where points inside the patches of a group may be.
Box3 StructurePatches::RoomOf(const PatchGroup& group) const
{
  Box3 room = Everywhere();
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->Patches[patch].Owners)
    {
      const CycleGeometry& geometry = this->Structures[owner.Structure].Geometry;
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto place = [&](double x) {
          return geometry.Grid.MoveInside(
            axis, geometry.Cycles.Cell[owner.Cycle][axis], x, InnerMargin);
        };
        room.Low[axis] = std::max(room.Low[axis], place(-HUGE_VAL));
        room.High[axis] = std::min(room.High[axis], place(HUGE_VAL));
      }
    }
  }
  return room;
}

/// The border of a patch with the normals that its first owner has there.
SheetBorder StructurePatches::BorderOfSheets(Index number) const
{
  const CellPatch& patch = this->Patches[number];
  const StructureCycle& owner = patch.Owners.front();
  const StructureSurface& structure = this->Structures[owner.Structure];
  SheetBorder border;
  border.Points = patch.Border;
  if (!structure.Normals.Normals.empty())
  {
    for (const Index point : structure.Geometry.GetBorders({ owner.Cycle }))
    {
      const float* normal = structure.Normals.Normals.data() + 3 * static_cast<std::size_t>(point);
      border.Normals.push_back({ normal[0], normal[1], normal[2] });
    }
  }
  return border;
}

/// Gives a patch of one cycle a new form.
void StructurePatches::Take(Index number, InnerPatch&& made)
{
  CellPatch& patch = this->Patches[number];
  patch.New = std::move(made);
  patch.Triangles.clear();
  for (const std::array<Index, 3>& triangle : patch.New.Triangles)
  {
    std::array<Point3, 3> corners;
    std::array<Index, 3> ids;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = triangle[i] >= 0 ? this->Places[patch.Border[triangle[i]]]
                                    : patch.New.Points[-1 - triangle[i]];
      ids[i] = this->NumberOf(corners[i]);
    }
    patch.Triangles.push_back({ number, corners, ids });
  }
}
}
