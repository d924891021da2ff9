// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CellOfStructures.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Base/Vectors.h"
#include "Core/Cells/FindContacts.h"
#include "Core/Labels/CommonPoint.h"
#include "Core/Labels/SheetPatch.h"

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
  Stuck   ///< they may touch
};

class CellSettler
{
public:
  CellSettler(const std::vector<StructureSurface>& structures,
    const std::vector<std::vector<Index>>& meshOf)
    : Structures(structures)
    , MeshOf(meshOf)
    , Groups(0)
  {
  }

  SettledCell Run(const std::vector<StructureCycle>& cycles);

private:
  using Edge = std::pair<Index, Index>; ///< a side of a border, its lesser end first
  using Group = std::vector<Index>;     ///< of patches, ascending

  void AddCycle(const StructureCycle& cycle);
  void AddTriangles(const StructureCycle& cycle, CellPatch& patch);
  void NumberCorners(Index number, std::vector<PatchTriangle>& triangles);
  Index NumberOf(const Point3& point);
  std::vector<Index> BorderOf(const StructureCycle& cycle);
  void CountEdges();
  void FormGroups();
  Group MembersOf(Index patch);
  bool IsPartingPoint(const CellPatch& patch, std::size_t i) const;
  std::vector<Index> PartingPoints(const CellPatch& patch) const;

  std::vector<std::pair<Index, Index>> FindAllContacts() const;
  bool Separate(Index a, Index b);
  bool Demote(Index patch);
  bool BecomeFan(Index patch);
  bool BecomeSheets(const Group& group);
  bool BecomeCommon(const Group& group);
  bool CanBeCommon(const Group& group) const;
  std::vector<JunctionCurve> FindCurves(const Group& group) const;
  Point3 MiddleOf(const Group& group, Index first, Index last) const;
  std::vector<BorderSide> SidesOf(Index patch) const;
  std::vector<BorderSide> SidesOfRest(Index a, Index b) const;
  Point3 MoveInside(const Group& group, Point3 point) const;
  Point3 FanCenter(const Group& group) const;
  void Take(Index number, InnerPatch&& patch);

  static Edge EdgeOf(Index a, Index b) { return std::minmax(a, b); }

  const std::vector<StructureSurface>& Structures;
  const std::vector<std::vector<Index>>& MeshOf;
  std::map<Point3, Index> Numbers;
  std::vector<Point3> Places;
  std::map<std::vector<Index>, Index> ByBorder;
  std::vector<CellPatch> AllPatches;
  std::map<Edge, Index> EdgeCounts; ///< how many patches have a side
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
    const std::vector<Index> border = this->BorderOf({ cycle.Structure, member });
    patch.Border.insert(patch.Border.end(), border.begin(), border.end());
  }
  patch.Offsets.push_back(static_cast<Index>(patch.Border.size()));
  this->AddTriangles(cycle, patch);
  patch.Center = CenterOf(patch);
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

/// Patches whose borders have a side in common are one group.
void CellSettler::FormGroups()
{
  this->Groups = DisjointSets(static_cast<Index>(this->AllPatches.size()));
  this->Forms.assign(this->AllPatches.size(), GroupForm::Own);
  std::map<Edge, Index> first;
  for (std::size_t i = 0; i < this->AllPatches.size(); ++i)
  {
    this->AllPatches[i].VisitSides(
      [&](Index a, Index b)
      {
        const auto found = first.emplace(EdgeOf(a, b), static_cast<Index>(i)).first;
        this->Groups.Unite(found->second, static_cast<Index>(i));
      });
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
      this->Forms[i] = this->BecomeSheets(group) ? GroupForm::Sheets
        : this->BecomeCommon(group)              ? GroupForm::Common
                                                 : GroupForm::Stuck;
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
std::vector<std::pair<Index, Index>> CellSettler::FindAllContacts() const
{
  std::vector<PatchTriangle> triangles;
  std::set<std::array<Index, 3>> known;
  for (const CellPatch& patch : this->AllPatches)
  {
    for (const PatchTriangle& triangle : patch.Triangles)
    {
      std::array<Index, 3> ids = triangle.Ids;
      std::sort(ids.begin(), ids.end());
      if (known.insert(ids).second)
      {
        triangles.push_back(triangle);
      }
    }
  }
  const std::vector<PatchKind> kinds(this->AllPatches.size(), PatchKind::Fan);
  return FindContacts(triangles, kinds);
}

/// Whether the border begins or ends at one of its points to be that of another patch, too.
bool CellSettler::IsPartingPoint(const CellPatch& patch, std::size_t i) const
{
  const std::size_t size = patch.Border.size();
  const Index before = patch.Border[(i + size - 1) % size], after = patch.Border[(i + 1) % size];
  return this->EdgeCounts.at(EdgeOf(before, patch.Border[i])) !=
    this->EdgeCounts.at(EdgeOf(patch.Border[i], after));
}

/// REQUIRES: a patch of one cycle.
std::vector<Index> CellSettler::PartingPoints(const CellPatch& patch) const
{
  std::vector<Index> points;
  for (std::size_t i = 0; i < patch.Border.size(); ++i)
  {
    if (this->IsPartingPoint(patch, i))
    {
      points.push_back(patch.Border[i]);
    }
  }
  return points;
}

/// A patch that parts from others twice ends there on a curve from one of these points to the other.
std::vector<JunctionCurve> CellSettler::FindCurves(const Group& group) const
{
  std::map<Edge, JunctionCurve> curves;
  for (const Index patch : group)
  {
    const std::vector<Index> ends = this->PartingPoints(this->AllPatches[patch]);
    if (ends.size() == 2 && curves.count(EdgeOf(ends[0], ends[1])) == 0)
    {
      const Edge edge = EdgeOf(ends[0], ends[1]);
      curves[edge] = { edge.first, edge.second, this->MiddleOf(group, edge.first, edge.second) };
    }
  }
  std::vector<JunctionCurve> list;
  for (const auto& curve : curves)
  {
    list.push_back(curve.second);
  }
  return list;
}

std::vector<BorderSide> CellSettler::SidesOf(Index patch) const
{
  std::vector<BorderSide> sides;
  this->AllPatches[patch].VisitSides(
    [&](Index a, Index b) { sides.push_back({ this->Places[a], this->Places[b] }); });
  return sides;
}

/// The border of what two patches cover without what both of them do.
std::vector<BorderSide> CellSettler::SidesOfRest(Index a, Index b) const
{
  std::map<Edge, bool> sidesOfB; // whether they run from the lesser end
  this->AllPatches[b].VisitSides(
    [&](Index p, Index q) { sidesOfB[EdgeOf(p, q)] = p < q; });
  std::vector<BorderSide> sides;
  Index alike = 0, opposite = 0;
  this->AllPatches[a].VisitSides(
    [&](Index p, Index q)
    {
      const auto found = sidesOfB.find(EdgeOf(p, q));
      if (found == sidesOfB.end())
      {
        sides.push_back({ this->Places[p], this->Places[q] });
        return;
      }
      ++(found->second == (p < q) ? alike : opposite);
      sidesOfB.erase(found);
    });
  for (const auto& [edge, ascends] : sidesOfB)
  {
    const bool forward = ascends != (alike > opposite);
    const Point3 &p = this->Places[edge.first], &q = this->Places[edge.second];
    sides.push_back(forward ? BorderSide{ p, q } : BorderSide{ q, p });
  }
  return sides;
}

/// Where the curve from one parting point to another passes, by the patches that part at both.
Point3 CellSettler::MiddleOf(const Group& group, Index first, Index last) const
{
  Group members;
  std::vector<std::vector<BorderSide>> surfaces;
  for (const Index patch : group)
  {
    const std::vector<Index> ends = this->PartingPoints(this->AllPatches[patch]);
    if (ends.size() == 2 && EdgeOf(ends[0], ends[1]) == EdgeOf(first, last))
    {
      members.push_back(patch);
      surfaces.push_back(this->SidesOf(patch));
    }
  }
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    for (std::size_t j = i + 1; j < members.size(); ++j)
    {
      surfaces.push_back(this->SidesOfRest(members[i], members[j]));
    }
  }
  return this->MoveInside(
    group, FindCommonPoint(this->Places[first], this->Places[last], surfaces));
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

bool CellSettler::BecomeSheets(const Group& group)
{
  if (!std::all_of(group.begin(), group.end(),
        [this](Index patch) { return this->AllPatches[patch].IsOneCycle; }))
  {
    return false;
  }
  const std::vector<JunctionCurve> curves = this->FindCurves(group);
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
      !BuildSheets(patch.Border, this->Places, own,
        [&](const Point3& point) { return this->MoveInside(group, point); }, made[i]))
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

/// Whether no structure has two of the patches, or one of several cycles.
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

bool CellSettler::BecomeCommon(const Group& group)
{
  if (!this->CanBeCommon(group))
  {
    return false;
  }
  std::set<Index> parting;
  for (const Index patch : group)
  {
    for (const Index point : this->PartingPoints(this->AllPatches[patch]))
    {
      parting.insert(point);
    }
  }
  Point3 center = this->FanCenter(group);
  if (parting.size() >= 2)
  {
    center = { 0.0, 0.0, 0.0 };
    for (const Index i : parting)
    {
      center = center + (1.0 / parting.size()) * this->Places[i];
    }
    center = this->MoveInside(group, center);
  }
  for (const Index patch : group)
  {
    this->Take(patch, FanAround(center, this->AllPatches[patch].Border.size()));
  }
  return true;
}

/// Gives a group whose patches touch each other a safer form. False if there is none.
bool CellSettler::Demote(Index patch)
{
  GroupForm& form = this->Forms[this->Groups.Find(patch)];
  if (form == GroupForm::Stuck)
  {
    return false;
  }
  const bool isSafer = form == GroupForm::Sheets && this->BecomeCommon(this->MembersOf(patch));
  form = isSafer ? GroupForm::Common : GroupForm::Stuck;
  return isSafer;
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
  Group both = this->MembersOf(a);
  const Group others = this->MembersOf(b);
  both.insert(both.end(), others.begin(), others.end());
  std::sort(both.begin(), both.end());
  if (!this->BecomeCommon(both))
  {
    return false;
  }
  this->Groups.Unite(a, b);
  this->Forms[this->Groups.Find(a)] = GroupForm::Common;
  return true;
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

SettledCell CellSettler::Run(const std::vector<StructureCycle>& cycles)
{
  for (const StructureCycle& cycle : cycles)
  {
    this->AddCycle(cycle);
  }
  this->CountEdges();
  this->FormGroups();
  SettledCell result;
  bool changed = true;
  while (changed)
  {
    changed = false;
    const std::vector<std::pair<Index, Index>> contacts = this->FindAllContacts();
    result.IsSettled = contacts.empty();
    for (const auto& [a, b] : contacts)
    {
      changed |= this->Separate(a, b);
    }
  }
  if (getenv("LBDEBUG") && !result.IsSettled)
  {
    fprintf(stderr, "cell unsettled patches %zu owners %zu:", this->AllPatches.size(), cycles.size());
    for (Index i = 0; i < Index(this->AllPatches.size()); ++i) { fprintf(stderr, " [g%d f%d", this->Groups.Find(i), (int)this->Forms[this->Groups.Find(i)]); for (auto& o : this->AllPatches[i].Owners) fprintf(stderr, " s%d", o.Structure); fprintf(stderr, "%s p%zu]", this->AllPatches[i].IsOneCycle ? "" : " M", this->AllPatches[i].IsOneCycle ? this->PartingPoints(this->AllPatches[i]).size() : 0); }
    for (auto& c : this->FindAllContacts()) fprintf(stderr, " %d-%d", c.first, c.second);
    fprintf(stderr, "\n");
  }
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

SettledCell SettleCell(const std::vector<StructureSurface>& structures,
  const std::vector<std::vector<Index>>& meshOf, const std::vector<StructureCycle>& cycles)
{
  return CellSettler(structures, meshOf).Run(cycles);
}
}
