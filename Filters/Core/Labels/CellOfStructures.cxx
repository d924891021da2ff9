// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CellOfStructures.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Cells/FindContacts.h"

#include <algorithm>
#include <map>
#include <set>

namespace orthoslices
{
namespace
{
/// Where common points stay away from the faces of their cell, as a share of its width.
constexpr double CommonPointMargin = 0.05;

/// A patch with its border, by the numbers that points of the cell have in all structures.
struct CellPatch
{
  std::vector<StructureCycle> Owners; ///< the same border in several structures, or one structure's
  std::vector<Index> Border;          ///< of all of its cycles, one after another
  std::vector<Index> Offsets;         ///< of each cycle in Border, and the end
  const PatchMesh* Mesh = nullptr;    ///< if it is one
  Point3 Center;                      ///< of the fan that it is, or of one in its place
  std::vector<PatchTriangle> Triangles;
  bool IsOneCycle = true;   ///< else it cannot become a fan
  bool IsAmbiguous = false; ///< its owners have other triangles
  bool IsChanged = false;   ///< it has become a fan around a common point

  template <typename Visit>
  void VisitSides(Visit&& visit) const
  {
    for (std::size_t cycle = 0; cycle + 1 < this->Offsets.size(); ++cycle)
    {
      const Index begin = this->Offsets[cycle], end = this->Offsets[cycle + 1];
      for (Index i = begin; i < end; ++i)
      {
        visit(this->Border[i], this->Border[i + 1 < end ? i + 1 : begin]);
      }
    }
  }
};

class CellSettler
{
public:
  CellSettler(const std::vector<StructureSurface>& structures,
    const std::vector<std::vector<Index>>& meshOf)
    : Structures(structures)
    , MeshOf(meshOf)
  {
  }

  SettledCell Run(const std::vector<StructureCycle>& cycles);

private:
  using Edge = std::pair<Index, Index>; ///< a side of a border, its lesser end first

  void AddCycle(const StructureCycle& cycle);
  void AddTriangles(const StructureCycle& cycle, CellPatch& patch);
  void NumberCorners(Index number, std::vector<PatchTriangle>& triangles);
  Index NumberOf(const Point3& point);
  void CountEdges();
  void JoinPartsInCommon(DisjointSets& groups) const;
  bool JoinContacts(DisjointSets& groups);
  bool FormFans(DisjointSets& groups);
  bool CanBeFans(const std::vector<Index>& group) const;
  void FindPartingPoints(const CellPatch& patch, std::set<Index>& points) const;
  Point3 CommonPoint(const std::vector<Index>& group) const;
  void BecomeFan(const Point3& center, Index number);

  static Edge EdgeOf(Index a, Index b) { return std::minmax(a, b); }

  const std::vector<StructureSurface>& Structures;
  const std::vector<std::vector<Index>>& MeshOf;
  std::map<Point3, Index> Numbers;
  std::vector<Point3> Places;
  std::map<std::vector<Index>, Index> ByBorder;
  std::vector<CellPatch> AllPatches;
  std::map<Edge, Index> EdgeCounts; ///< how many patches have a side
  int Within = 0;
};

Index CellSettler::NumberOf(const Point3& point)
{
  const auto [place, isNew] = this->Numbers.emplace(point, static_cast<Index>(this->Places.size()));
  if (isNew)
  {
    this->Places.push_back(point);
  }
  return place->second;
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

/// The triangles of the patch that a cycle is part of.
void CellSettler::AddTriangles(const StructureCycle& cycle, CellPatch& patch)
{
  const StructureSurface& structure = this->Structures[cycle.Structure];
  const Patches& surface = structure.Surface;
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
void CellSettler::NumberCorners(Index number, std::vector<PatchTriangle>& triangles)
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

/// Adds the patch of a cycle, or another owner of one that was added before.
void CellSettler::AddCycle(const StructureCycle& cycle)
{
  const StructureSurface& structure = this->Structures[cycle.Structure];
  const Index mesh = this->MeshOf[cycle.Structure][cycle.Cycle];
  CellPatch patch;
  patch.Owners.push_back(cycle);
  patch.Mesh = mesh < 0 ? nullptr : &structure.Surface.Meshes[mesh];
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
    for (const Index point : structure.Geometry.GetBorders({ member }))
    {
      patch.Border.push_back(this->NumberOf(structure.Geometry.Graph.PointAt(point)));
    }
  }
  patch.Offsets.push_back(static_cast<Index>(patch.Border.size()));
  this->AddTriangles(cycle, patch);
  const Index number = static_cast<Index>(this->AllPatches.size());
  if (patch.IsOneCycle)
  {
    const auto [place, isNew] = this->ByBorder.emplace(Canonical(patch.Border), number);
    if (!isNew)
    {
      CellPatch& same = this->AllPatches[place->second];
      same.Owners.push_back(cycle);
      same.IsAmbiguous |= CornersOf(same.Triangles) != CornersOf(patch.Triangles);
      return;
    }
  }
  this->NumberCorners(number, patch.Triangles);
  this->AllPatches.push_back(std::move(patch));
}

void CellSettler::CountEdges()
{
  for (const CellPatch& patch : this->AllPatches)
  {
    patch.VisitSides([&](Index a, Index b) { ++this->EdgeCounts[EdgeOf(a, b)]; });
  }
}

/// Joins patches whose borders have a side in common.
void CellSettler::JoinPartsInCommon(DisjointSets& groups) const
{
  std::map<Edge, Index> first;
  for (std::size_t i = 0; i < this->AllPatches.size(); ++i)
  {
    this->AllPatches[i].VisitSides(
      [&](Index a, Index b)
      {
        const auto found = first.emplace(EdgeOf(a, b), static_cast<Index>(i)).first;
        groups.Unite(found->second, static_cast<Index>(i));
      });
  }
}

/// Joins patches that touch, unless they are fans around one point. False if there are none.
bool CellSettler::JoinContacts(DisjointSets& groups)
{
  std::vector<PatchTriangle> triangles;
  for (const CellPatch& patch : this->AllPatches)
  {
    triangles.insert(triangles.end(), patch.Triangles.begin(), patch.Triangles.end());
  }
  const std::vector<PatchKind> kinds(this->AllPatches.size(), PatchKind::Fan);
  bool joined = false;
  for (const auto& [a, b] : FindContacts(triangles, kinds))
  {
    if (getenv("LBDEBUG") && groups.Find(a) == groups.Find(b)) ++this->Within;
    joined |= groups.Unite(a, b);
  }
  return joined;
}

/// Whether no structure has two of the patches, or one of several cycles.
bool CellSettler::CanBeFans(const std::vector<Index>& group) const
{
  std::set<Index> structures;
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->AllPatches[patch].Owners)
    {
      if (!this->AllPatches[patch].IsOneCycle || !structures.insert(owner.Structure).second)
      {
        return false;
      }
    }
  }
  return true;
}

/// The points at which the border of a patch begins or ends to be that of another one, too.
void CellSettler::FindPartingPoints(const CellPatch& patch, std::set<Index>& points) const
{
  const std::size_t size = patch.Border.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Index point = patch.Border[i];
    const Index before = patch.Border[(i + size - 1) % size], after = patch.Border[(i + 1) % size];
    if (this->EdgeCounts.at(EdgeOf(before, point)) != this->EdgeCounts.at(EdgeOf(point, after)))
    {
      points.insert(point);
    }
  }
}

/// The point around which a group of patches become fans.
Point3 CellSettler::CommonPoint(const std::vector<Index>& group) const
{
  std::set<Index> parting;
  Point3 centers{ 0.0, 0.0, 0.0 };
  for (const Index patch : group)
  {
    this->FindPartingPoints(this->AllPatches[patch], parting);
    centers = centers + (1.0 / group.size()) * this->AllPatches[patch].Center;
  }
  Point3 point = centers;
  if (parting.size() >= 2)
  {
    point = { 0.0, 0.0, 0.0 };
    for (const Index i : parting)
    {
      point = point + (1.0 / parting.size()) * this->Places[i];
    }
  }
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->AllPatches[patch].Owners)
    {
      const CycleGeometry& geometry = this->Structures[owner.Structure].Geometry;
      for (int axis = 0; axis < 3; ++axis)
      {
        point[axis] = geometry.Grid.MoveInside(
          axis, geometry.Cycles.Cell[owner.Cycle][axis], point[axis], CommonPointMargin);
      }
    }
  }
  return point;
}

void CellSettler::BecomeFan(const Point3& center, Index number)
{
  CellPatch& patch = this->AllPatches[number];
  patch.Center = center;
  patch.IsChanged = true;
  const StructureCycle& owner = patch.Owners.front();
  CellTriangles triangles(this->Structures[owner.Structure].Geometry);
  triangles.AddFan(owner.Cycle, center);
  patch.Triangles = std::move(triangles.Triangles);
  this->NumberCorners(number, patch.Triangles);
}

/// Groups of several patches, and those that have two forms, become fans. False if some cannot.
bool CellSettler::FormFans(DisjointSets& groups)
{
  std::map<Index, std::vector<Index>> members;
  for (Index i = 0; i < groups.Count(); ++i)
  {
    members[groups.Find(i)].push_back(i);
  }
  bool possible = true;
  for (const auto& [first, group] : members)
  {
    if (group.size() == 1 && !this->AllPatches[first].IsAmbiguous)
    {
      continue;
    }
    if (!this->CanBeFans(group))
    {
      possible = false;
      continue;
    }
    const Point3 center = this->CommonPoint(group);
    for (const Index patch : group)
    {
      this->BecomeFan(center, patch);
    }
  }
  return possible;
}

SettledCell CellSettler::Run(const std::vector<StructureCycle>& cycles)
{
  for (const StructureCycle& cycle : cycles)
  {
    this->AddCycle(cycle);
  }
  this->CountEdges();
  DisjointSets groups(static_cast<Index>(this->AllPatches.size()));
  this->JoinPartsInCommon(groups);
  SettledCell result;
  do
  {
    result.IsSettled = this->FormFans(groups);
    this->Within = 0;
  } while (result.IsSettled && this->JoinContacts(groups));
  if (getenv("LBDEBUG") && (this->Within || !result.IsSettled))
    fprintf(stderr, "cell settled %d within %d patches %zu owners %zu\n", (int)result.IsSettled, (int)this->Within, this->AllPatches.size(), cycles.size());
  for (const CellPatch& patch : this->AllPatches)
  {
    for (const StructureCycle& owner : patch.Owners)
    {
      if (patch.IsChanged)
      {
        result.Fans.push_back({ owner, patch.Center });
      }
    }
  }
  return result;
}
}

SettledCell SettleCell(const std::vector<StructureSurface>& structures,
  const std::vector<std::vector<Index>>& meshOf, const std::vector<StructureCycle>& cycles)
{
  return CellSettler(structures, meshOf).Run(cycles);
}
}
