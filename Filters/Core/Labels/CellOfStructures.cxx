// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CellOfStructures.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Base/Vectors.h"
#include "Core/Cells/FindContacts.h"
#include "Core/Labels/JunctionFit.h"
#include "Core/Labels/SheetPatch.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <set>

namespace orthoslices
{
namespace
{
/// The most parts of a curve in which structures meet.
constexpr Index MaxParts = 16;

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
  InnerPatch New;           ///< in its place, if it has points
  bool IsOneCycle = true;   ///< else nothing can take its place
  bool IsAmbiguous = false; ///< its owners have other triangles

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

/// How the patches of a group are made: each form makes less of their shape and more sure of it than
/// the one before.
enum class GroupForm : std::uint8_t
{
  Own,    ///< as their structures have them; of one patch only
  Fan,    ///< a fan around a point of its own; of one patch only
  Sheets, ///< divided by the curves in which structures meet
  Common, ///< fans around one point
  Claims, ///< the same, but for structures with several patches, all but one of which have points of their own
  Stuck   ///< they may touch
};

class CellSettler : private CellPoints
{
public:
  explicit CellSettler(const StructureTables& tables)
    : Tables(tables)
    , Structures(tables.Structures)
    , Groups(0)
  {
  }

  SettledCell Run(const std::vector<StructureCycle>& cycles);

private:
  using Edge = CellEdge;
  using Group = std::vector<Index>;     ///< of patches, ascending

  void AddCycle(const StructureCycle& cycle);
  void AddTriangles(const StructureCycle& cycle, CellPatch& patch);
  void NumberCorners(Index number, std::vector<PatchTriangle>& triangles);
  Index NumberOf(const Point3& place) override;
  const Point3& PlaceOf(Index point) const override { return this->Places[point]; }
  std::vector<Index> BorderOf(const StructureCycle& cycle);
  void FileSides();
  void FormGroups();
  Group MembersOf(Index patch);
  bool IsPartingPoint(const CellPatch& patch, std::size_t i) const;
  std::vector<Index> PartingPoints(const CellPatch& patch) const;

  std::vector<std::pair<Index, Index>> FindContactsOf(const Group& group) const;
  bool Separate(Index a, Index b);
  bool Demote(Index patch);
  bool BecomeFan(Index patch);
  bool BecomeSheets(const Group& group);
  bool BecomeCommon(const Group& group);
  bool BecomeClaims(const Group& group);
  bool BecomeClaims(const Group& group, std::size_t kept, double way);
  Group FindClaiming(const Group& group, std::size_t kept) const;
  GroupForm MakeSafe(const Group& group);
  Point3 CommonCenter(const Group& group) const;
  Point3 MiddleOfBorder(const CellPatch& patch) const;
  bool CanBeCommon(const Group& group) const;
  std::vector<JunctionCurve> FindCurves(const Group& group);
  JunctionCurve MakeCurve(const Group& group, const Edge& ends, const Group& patches);
  double EdgeLength(const Group& group) const;
  std::vector<std::pair<Index, Index>> SidesOf(Index patch) const;
  std::vector<std::pair<Index, Index>> SidesOfRest(Index a, Index b) const;
  SheetBorder BorderOfSheets(Index patch) const;
  Box3 RoomOf(const Group& group) const;
  Point3 MoveInside(const Group& group, Point3 point) const;
  Point3 FanCenter(const Group& group) const;
  void Take(Index number, InnerPatch&& patch);
  bool BreakMeshes();
  bool Settle();

  static Edge EdgeOf(Index a, Index b) { return CellEdgeOf(a, b); }

  const StructureTables& Tables;
  const std::vector<StructureSurface>& Structures;
  std::map<Point3, Index> Numbers;
  std::deque<Point3> Places;
  std::map<std::vector<Index>, Index> ByBorder;
  std::vector<CellPatch> AllPatches;
  std::set<const PatchMesh*> Broken; ///< patches of several cycles that give way to those of each
  std::map<Edge, Group> PatchesAt;  ///< those that have a side, ascending
  DisjointSets Groups;              ///< of patches
  std::vector<GroupForm> Forms;     ///< of each group, at its least patch
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

std::vector<Index> CellSettler::BorderOf(const StructureCycle& cycle)
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
void CellSettler::AddCycle(const StructureCycle& cycle)
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

void CellSettler::FileSides()
{
  for (std::size_t i = 0; i < this->AllPatches.size(); ++i)
  {
    this->AllPatches[i].VisitSides([&](Index a, Index b)
      { this->PatchesAt[EdgeOf(a, b)].push_back(static_cast<Index>(i)); });
  }
}

/// Patches whose borders have a side in common are one group.
void CellSettler::FormGroups()
{
  this->Groups = DisjointSets(static_cast<Index>(this->AllPatches.size()));
  this->Forms.assign(this->AllPatches.size(), GroupForm::Own);
  for (const auto& side : this->PatchesAt)
  {
    for (const Index patch : side.second)
    {
      this->Groups.Unite(side.second.front(), patch);
    }
  }
  for (Index i = 0; i < this->Groups.Count(); ++i)
  {
    if (this->Groups.Find(i) != i)
    {
      continue;
    }
    const Group group = this->MembersOf(i);
    if (group.size() > 1)
    {
      this->Forms[i] =
        this->BecomeSheets(group) ? GroupForm::Sheets : this->MakeSafe(group);
    }
    else if (this->AllPatches[i].IsAmbiguous)
    {
      this->Forms[i] = this->BecomeFan(i) ? GroupForm::Fan : GroupForm::Stuck;
    }
  }
}

CellSettler::Group CellSettler::MembersOf(Index patch)
{
  Group group;
  for (Index i = 0; i < this->Groups.Count(); ++i)
  {
    if (this->Groups.Find(i) == this->Groups.Find(patch))
    {
      group.push_back(i);
    }
  }
  return group;
}

/// Patches that touch. Triangles that several patches have count once.
std::vector<std::pair<Index, Index>> CellSettler::FindContactsOf(const Group& group) const
{
  std::vector<PatchTriangle> triangles;
  std::set<std::array<Index, 3>> known;
  for (const Index patch : group)
  {
    for (const PatchTriangle& triangle : this->AllPatches[patch].Triangles)
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
  for (const CellPatch& patch : this->AllPatches)
  {
    // Fans and what structures have made themselves are known not to touch themselves.
    kinds.push_back(patch.New.Points.size() > 1 ? PatchKind::Joined : PatchKind::Fan);
  }
  return FindContacts(triangles, kinds);
}

/// Whether the border is that of other patches before one of its points than after it.
bool CellSettler::IsPartingPoint(const CellPatch& patch, std::size_t i) const
{
  const std::size_t size = patch.Border.size();
  const Index before = patch.Border[(i + size - 1) % size], after = patch.Border[(i + 1) % size];
  return this->PatchesAt.at(EdgeOf(before, patch.Border[i])) !=
    this->PatchesAt.at(EdgeOf(patch.Border[i], after));
}

/// None of a patch of several cycles.
std::vector<Index> CellSettler::PartingPoints(const CellPatch& patch) const
{
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

/// A patch that parts from others twice ends there on a curve from one of these points to the other.
std::vector<JunctionCurve> CellSettler::FindCurves(const Group& group)
{
  std::map<Edge, Group> ending; // patches by where they part from others
  for (const Index patch : group)
  {
    const std::vector<Index> ends = this->PartingPoints(this->AllPatches[patch]);
    if (ends.size() == 2)
    {
      ending[EdgeOf(ends[0], ends[1])].push_back(patch);
    }
  }
  std::vector<JunctionCurve> curves;
  for (const auto& [ends, patches] : ending)
  {
    curves.push_back(this->MakeCurve(group, ends, patches));
  }
  return curves;
}

std::vector<std::pair<Index, Index>> CellSettler::SidesOf(Index patch) const
{
  std::vector<std::pair<Index, Index>> sides;
  this->AllPatches[patch].VisitSides([&](Index a, Index b) { sides.emplace_back(a, b); });
  return sides;
}

/// The border of what two patches cover without what both of them do.
std::vector<std::pair<Index, Index>> CellSettler::SidesOfRest(Index a, Index b) const
{
  std::map<Edge, bool> sidesOfB; // whether they run from the lesser end
  this->AllPatches[b].VisitSides(
    [&](Index p, Index q) { sidesOfB[EdgeOf(p, q)] = p < q; });
  std::vector<std::pair<Index, Index>> sides;
  Index alike = 0, opposite = 0;
  this->AllPatches[a].VisitSides(
    [&](Index p, Index q)
    {
      const auto found = sidesOfB.find(EdgeOf(p, q));
      if (found == sidesOfB.end())
      {
        sides.emplace_back(p, q);
        return;
      }
      ++(found->second == (p < q) ? alike : opposite);
      sidesOfB.erase(found);
    });
  for (const auto& [edge, ascends] : sidesOfB)
  {
    const bool forward = ascends != (alike > opposite);
    sides.push_back(forward ? edge : Edge{ edge.second, edge.first });
  }
  return sides;
}

/// The curve in which some patches of a group end.
JunctionCurve CellSettler::MakeCurve(const Group& group, const Edge& ends, const Group& patches)
{
  const Point3 first = this->Places[ends.first], last = this->Places[ends.second];
  JunctionFit fit(first, last);
  JunctionCurve curve{ ends.first, ends.second, {}, {}, {} };
  const auto tryBorder = [&](const std::vector<std::pair<Index, Index>>& sides)
  {
    std::vector<BorderSide> border;
    for (const auto& [a, b] : sides)
    {
      border.push_back({ this->Places[a], this->Places[b] });
    }
    if (fit.Try(border))
    {
      curve.OnSurface.clear();
      for (const auto& [a, b] : sides)
      {
        curve.OnSurface.insert(EdgeOf(a, b));
      }
    }
  };
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    tryBorder(this->SidesOf(patches[i]));
    for (std::size_t j = i + 1; j < patches.size(); ++j)
    {
      tryBorder(this->SidesOfRest(patches[i], patches[j]));
    }
  }
  const SpatialGrid& grid =
    this->Structures[this->AllPatches[group.front()].Owners.front().Structure].Geometry.Grid;
  PatchBorder inside;
  inside.Room = this->RoomOf(group);
  const double length = Length(last - first);
  const Index parts = static_cast<Index>(
    std::max(2.0, std::min(double(MaxParts), std::ceil(length / this->EdgeLength(group)))));
  for (Index i = 1; i < parts; ++i)
  {
    Point3 place, normal;
    fit.Evaluate(double(i) / parts, place, normal);
    curve.Inside.push_back(this->NumberOf(inside.MoveInside(grid, place)));
    curve.Normals.push_back(normal);
  }
  return curve;
}

/// How long the sides of triangles are.
double CellSettler::EdgeLength(const Group& group) const
{
  const Index structure = this->AllPatches[group.front()].Owners.front().Structure;
  return this->Tables.Options.EdgeLength *
    MinMeanSpacing(this->Structures[structure].Geometry.Grid);
}

/// A place for a point that all patches of a group have in common.
Point3 CellSettler::MoveInside(const Group& group, Point3 point) const
{
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

/// Whether the triangles are a surface with a border of so many points, each side of it passed once, in
/// its direction.
bool IsBordered(const InnerPatch& patch, std::size_t size)
{
  std::set<std::pair<Index, Index>> sides;
  for (const std::array<Index, 3>& triangle : patch.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangle[i], b = triangle[(i + 1) % 3];
      if (a == b || !sides.insert({ a, b }).second)
      {
        return false;
      }
    }
  }
  std::size_t onBorder = 0;
  for (const auto& [a, b] : sides)
  {
    const bool isBorder = a >= 0 && b >= 0 && static_cast<std::size_t>(b) == (a + 1) % size;
    const bool hasTwin = sides.count({ b, a }) > 0;
    if (hasTwin == isBorder)
    {
      return false;
    }
    onBorder += isBorder ? 1 : 0;
  }
  return onBorder == size;
}

/// Gives a patch of one cycle a new form.
void CellSettler::Take(Index number, InnerPatch&& made)
{
  CellPatch& patch = this->AllPatches[number];
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

InnerPatch FanAround(const Point3& center, std::size_t size)
{
  InnerPatch fan;
  fan.Points.push_back(center);
  fan.Normals.push_back({ 0.0, 0.0, 0.0 });
  for (std::size_t i = 0; i < size; ++i)
  {
    fan.Triangles.push_back(
      { static_cast<Index>(i), static_cast<Index>((i + 1) % size), Index(-1) });
  }
  return fan;
}

Point3 CellSettler::MiddleOfBorder(const CellPatch& patch) const
{
  const std::vector<Index>& border = patch.Border;
  Point3 middle{ 0.0, 0.0, 0.0 };
  for (const Index point : border)
  {
    middle = middle + (1.0 / static_cast<double>(border.size())) * this->Places[point];
  }
  return middle;
}

/// A patch whose sides are each seen from one of several points; `around` has the place of each side's
/// point in `centers`, and `base` is that of the patch.
InnerPatch FanAroundSeveral(
  const std::vector<Index>& around, Index base, const std::vector<Point3>& centers)
{
  InnerPatch patch;
  std::map<Index, Index> corner; // of a place in centers
  const auto cornerOf = [&](Index place)
  {
    const auto [at, isNew] = corner.emplace(place, -1 - static_cast<Index>(patch.Points.size()));
    if (isNew)
    {
      patch.Points.push_back(centers[place]);
      patch.Normals.push_back({ 0.0, 0.0, 0.0 });
    }
    return at->second;
  };
  const std::size_t size = around.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Index own = around[i], next = around[(i + 1) % size];
    const Index end = static_cast<Index>((i + 1) % size);
    patch.Triangles.push_back({ static_cast<Index>(i), end, cornerOf(own) });
    if (own != next)
    {
      patch.Triangles.push_back({ end, cornerOf(next), cornerOf(own) });
    }
    if (own != next && own != base && next != base)
    {
      patch.Triangles.push_back({ cornerOf(own), cornerOf(next), cornerOf(base) });
    }
  }
  return patch;
}

/// The middle of the centers of patches.
Point3 CellSettler::FanCenter(const Group& group) const
{
  Point3 center{ 0.0, 0.0, 0.0 };
  for (const Index patch : group)
  {
    center = center + (1.0 / group.size()) * this->AllPatches[patch].Center;
  }
  return this->MoveInside(group, center);
}

/// False if the patch is of several cycles, or a fan already.
bool CellSettler::BecomeFan(Index number)
{
  const CellPatch& patch = this->AllPatches[number];
  if (!patch.IsOneCycle)
  {
    return false;
  }
  this->Take(number, FanAround(this->FanCenter({ number }), patch.Border.size()));
  return true;
}

/// The border of a patch with the normals that its first owner has there.
SheetBorder CellSettler::BorderOfSheets(Index number) const
{
  const CellPatch& patch = this->AllPatches[number];
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

/// Where points inside the patches of a group may be.
Box3 CellSettler::RoomOf(const Group& group) const
{
  Box3 room = Everywhere();
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->AllPatches[patch].Owners)
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

bool CellSettler::BecomeSheets(const Group& group)
{
  if (!std::all_of(group.begin(), group.end(),
        [this](Index patch) { return this->AllPatches[patch].IsOneCycle; }))
  {
    return false;
  }
  const std::vector<JunctionCurve> curves = this->FindCurves(group);
  const SpatialGrid& grid =
    this->Structures[this->AllPatches[group.front()].Owners.front().Structure].Geometry.Grid;
  SheetBuilder builder(
    grid, { this->EdgeLength(group), 0.0 }, this->RoomOf(group), *this);
  std::vector<InnerPatch> made(group.size());
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    const CellPatch& patch = this->AllPatches[group[i]];
    const std::vector<Index> parting = this->PartingPoints(patch);
    const auto isOn = [&](Index point)
    { return std::find(parting.begin(), parting.end(), point) != parting.end(); };
    std::vector<JunctionCurve> own;
    std::copy_if(curves.begin(), curves.end(), std::back_inserter(own),
      [&](const JunctionCurve& curve) { return isOn(curve.First) && isOn(curve.Last); });
    if (2 * own.size() != parting.size() ||
      !builder.Build(this->BorderOfSheets(group[i]), own, made[i]) ||
      !IsBordered(made[i], patch.Border.size()))
    {
      return false;
    }
  }
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    this->Take(group[i], std::move(made[i]));
  }
  return true;
}

/// Whether all patches have one cycle, and no structure has two of them.
bool CellSettler::CanBeCommon(const Group& group) const
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

/// The middle of the points at which borders of a group part; of the patches' centers, if they do not.
Point3 CellSettler::CommonCenter(const Group& group) const
{
  std::set<Index> parting;
  for (const Index patch : group)
  {
    for (const Index point : this->PartingPoints(this->AllPatches[patch]))
    {
      parting.insert(point);
    }
  }
  if (parting.size() < 2)
  {
    return this->FanCenter(group);
  }
  Point3 center{ 0.0, 0.0, 0.0 };
  for (const Index i : parting)
  {
    center = center + (1.0 / static_cast<double>(parting.size())) * this->Places[i];
  }
  return this->MoveInside(group, center);
}

bool CellSettler::BecomeCommon(const Group& group)
{
  if (!this->CanBeCommon(group))
  {
    return false;
  }
  const Point3 center = this->CommonCenter(group);
  for (const Index patch : group)
  {
    this->Take(patch, FanAround(center, this->AllPatches[patch].Border.size()));
  }
  return true;
}

/// The patches of a group that need a point of their own: of each structure all but the one that
/// `kept` counts, from the longest border on; all where a patch of several cycles is in the way.
CellSettler::Group CellSettler::FindClaiming(const Group& group, std::size_t kept) const
{
  const bool hasMesh = std::any_of(group.begin(), group.end(),
    [this](Index patch) { return !this->AllPatches[patch].IsOneCycle; });
  std::map<Index, Group> ofStructure;
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->AllPatches[patch].Owners)
    {
      ofStructure[owner.Structure].push_back(patch);
    }
  }
  std::set<Index> claiming;
  for (auto& structure : ofStructure)
  {
    Group& patches = structure.second;
    std::stable_sort(patches.begin(), patches.end(), [this](Index a, Index b)
      { return this->AllPatches[a].Border.size() > this->AllPatches[b].Border.size(); });
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      const bool isKept = patches.size() == 1 ? !hasMesh : i == kept % patches.size();
      if (!isKept && this->AllPatches[patches[i]].IsOneCycle)
      {
        claiming.insert(patches[i]);
      }
    }
  }
  return { claiming.begin(), claiming.end() };
}

/**
 * Fans around one point, from which some patches take theirs a part of the way to their border. Such a
 * patch claims its sides, so that they have that point in its neighbours, too; where sides around
 * several points follow each other, triangles between these points fill the patch. False if that is
 * no surface.
 */
bool CellSettler::BecomeClaims(const Group& group, std::size_t kept, double way)
{
  std::vector<Point3> centers{ this->CommonCenter(group) };
  std::map<Edge, Index> claimedBy; // place in centers
  std::map<Index, Index> baseOf;
  for (const Index patch : this->FindClaiming(group, kept))
  {
    baseOf[patch] = static_cast<Index>(centers.size());
    this->AllPatches[patch].VisitSides(
      [&](Index a, Index b)
      { claimedBy.emplace(EdgeOf(a, b), static_cast<Index>(centers.size())); });
    centers.push_back(
      this->MoveInside(group, Between(centers[0], this->MiddleOfBorder(this->AllPatches[patch]), way)));
  }
  for (const Index patch : group)
  {
    if (!this->AllPatches[patch].IsOneCycle)
    {
      continue; // stays
    }
    const std::vector<Index>& border = this->AllPatches[patch].Border;
    std::vector<Index> around; // of each side, the place of its point
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const auto found = claimedBy.find(EdgeOf(border[i], border[(i + 1) % border.size()]));
      around.push_back(found == claimedBy.end() ? 0 : found->second);
    }
    const auto base = baseOf.find(patch);
    InnerPatch made =
      FanAroundSeveral(around, base == baseOf.end() ? 0 : base->second, centers);
    if (!IsBordered(made, border.size()))
    {
      return false;
    }
    this->Take(patch, std::move(made));
  }
  return true;
}

/// Tries which patches keep the common point, and how far the others move theirs. A patch of several
/// cycles stays as it is.
bool CellSettler::BecomeClaims(const Group& group)
{
  for (const double way : { 0.4, 0.15, 0.7, 0.85 })
  {
    for (std::size_t kept = 0; kept < 3; ++kept)
    {
      if (this->BecomeClaims(group, kept, way) && this->FindContactsOf(group).empty())
      {
        return true;
      }
    }
  }
  return false;
}

/// Gives a group whose patches touch each other a safer form. False if there is none.
bool CellSettler::Demote(Index patch)
{
  GroupForm& form = this->Forms[this->Groups.Find(patch)];
  form = form == GroupForm::Sheets ? this->MakeSafe(this->MembersOf(patch)) : GroupForm::Stuck;
  return form != GroupForm::Stuck;
}

/// Fans around one point, or around as many as are needed.
GroupForm CellSettler::MakeSafe(const Group& group)
{
  return this->BecomeCommon(group) ? GroupForm::Common
    : this->BecomeClaims(group)    ? GroupForm::Claims
                                   : GroupForm::Stuck;
}

/// Has two patches that touch make room for each other. False if nothing can be done any more.
bool CellSettler::Separate(Index a, Index b)
{
  if (this->Groups.Find(a) == this->Groups.Find(b))
  {
    return this->Demote(a);
  }
  bool changed = false;
  for (const Index patch : { a, b })
  {
    GroupForm& form = this->Forms[this->Groups.Find(patch)];
    if (form == GroupForm::Own && this->BecomeFan(patch))
    {
      form = GroupForm::Fan;
      changed = true;
    }
  }
  if (changed)
  {
    return true;
  }
  this->Groups.Unite(a, b);
  const GroupForm form = this->MakeSafe(this->MembersOf(a));
  this->Forms[this->Groups.Find(a)] = form;
  return form != GroupForm::Stuck;
}

/// The new form of a patch for each of its owners, whose borders may begin elsewhere and run the other
/// way.
void AddNewPatches(const CellPatch& patch, const std::vector<std::vector<Index>>& borders,
  SettledCell& result)
{
  for (std::size_t i = 0; i < patch.Owners.size() && !patch.New.Points.empty(); ++i)
  {
    const std::vector<Index>& border = borders[i];
    std::map<Index, Index> placeOf;
    for (std::size_t k = 0; k < border.size(); ++k)
    {
      placeOf[border[k]] = static_cast<Index>(k);
    }
    const bool isReversed = placeOf[patch.Border[1]] !=
      (placeOf[patch.Border[0]] + 1) % static_cast<Index>(border.size());
    NewPatch own{ patch.Owners[i], patch.New };
    for (std::array<Index, 3>& triangle : own.Patch.Triangles)
    {
      for (Index& corner : triangle)
      {
        corner = corner >= 0 ? placeOf[patch.Border[corner]] : corner;
      }
      if (isReversed)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    result.Patches.push_back(std::move(own));
  }
}

/// Whether a patch of several cycles is in the way of others; then its cycles get patches of their own.
bool CellSettler::BreakMeshes()
{
  bool any = false;
  for (Index i = 0; i < this->Groups.Count(); ++i)
  {
    const CellPatch& patch = this->AllPatches[i];
    if (this->Forms[this->Groups.Find(i)] == GroupForm::Stuck && patch.Offsets.size() > 2)
    {
      any |= this->Broken.insert(patch.Mesh).second;
    }
  }
  return any;
}

/// Makes patches give way to each other. False if some still touch.
bool CellSettler::Settle()
{
  Group all(this->AllPatches.size());
  std::iota(all.begin(), all.end(), 0);
  bool changed = true, settled = false;
  while (changed && !settled)
  {
    changed = false;
    const std::vector<std::pair<Index, Index>> contacts = this->FindContactsOf(all);
    settled = contacts.empty();
    for (const auto& [a, b] : contacts)
    {
      changed |= this->Separate(a, b);
    }
  }
  return settled;
}

SettledCell CellSettler::Run(const std::vector<StructureCycle>& cycles)
{
  SettledCell result;
  do
  {
    this->ByBorder.clear();
    this->AllPatches.clear();
    this->PatchesAt.clear();
    for (const StructureCycle& cycle : cycles)
    {
      this->AddCycle(cycle);
    }
    this->FileSides();
    this->FormGroups();
    result.IsSettled = this->Settle();
  } while (!result.IsSettled && this->BreakMeshes());
  if (getenv("LBDEBUG") && !result.IsSettled)
  {
    fprintf(stderr, "cell unsettled %g %g %g", this->Places[0][0],this->Places[0][1],this->Places[0][2]); fprintf(stderr, " patches %zu owners %zu:", this->AllPatches.size(), cycles.size());
    for (Index i = 0; i < Index(this->AllPatches.size()); ++i) { fprintf(stderr, " [g%d f%d", this->Groups.Find(i), (int)this->Forms[this->Groups.Find(i)]); for (auto& o : this->AllPatches[i].Owners) fprintf(stderr, " s%d", o.Structure); fprintf(stderr, "%s p%zu]", this->AllPatches[i].IsOneCycle ? "" : " M", this->AllPatches[i].IsOneCycle ? this->PartingPoints(this->AllPatches[i]).size() : 0); }
    Group all(this->AllPatches.size());  std::iota(all.begin(), all.end(), 0);
    for (auto& c : this->FindContactsOf(all)) fprintf(stderr, " %d-%d", c.first, c.second);
    fprintf(stderr, "\n"); static int shown = 0; if (shown++ < 3) { for (auto& p : this->AllPatches) { fprintf(stderr, "border"); for (Index b : p.Border) fprintf(stderr, " %d(%.9g %.9g %.9g)", b, this->Places[b][0], this->Places[b][1], this->Places[b][2]); fprintf(stderr, "\n"); } }
  }
  if (getenv("LBDEBUG")) for (Index i = 0; i < Index(this->AllPatches.size()); ++i) if (this->Groups.Find(i) == i && this->Forms[i] != GroupForm::Own) { auto g = this->MembersOf(i); fprintf(stderr, "FORM %d size %zu\n", (int)this->Forms[i], g.size()); }
  for (const CellPatch& patch : this->AllPatches)
  {
    std::vector<std::vector<Index>> borders;
    for (const StructureCycle& owner : patch.Owners)
    {
      borders.push_back(this->BorderOf(owner));
    }
    AddNewPatches(patch, borders, result);
  }
  return result;
}
}

SettledCell SettleCell(const StructureTables& tables, const std::vector<StructureCycle>& cycles)
{
  return CellSettler(tables).Run(cycles);
}
}
