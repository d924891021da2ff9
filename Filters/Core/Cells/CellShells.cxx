// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellShells.h"

#include "Core/Base/Vectors.h"
#include "Core/Cells/CellRegion.h"
#include "Core/Planar/TriangulatePolygon.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// Depths of the deepest shells as parts of the way to the middle of the cell. Discs stay in the
/// outer half, which leaves the rest for the region between several cycles: mostly a waist, which
/// is smaller the deeper it lies. Chosen by hand.
constexpr double DeepestDisc = 0.4;
constexpr double DeepestWaist = 0.85;
/// Depths that are tried for the region between several cycles, as parts of the room that it has:
/// the one with the smallest area is taken.
constexpr std::array<double, 4> TriedDepths{ 0.25, 0.5, 0.75, 1.0 };

/// A group of cycles and its region.
struct ShellGroup
{
  CellRegion Region;
  bool Possible = true;
  int Height = 1; ///< 1 plus the length of the longest chain of groups nested within
  bool IsContained = false;
};

/// The shells of one cell.
class CellShells
{
public:
  CellShells(const CycleGeometry& geometry, const Index* first, const Index* last,
    const std::vector<std::vector<Index>>& groups)
    : Geometry(geometry)
    , Regions(geometry)
    , First(first)
    , OfCycle(Regions.Find(first, last))
    , Wanted(groups)
  {
    this->Last = last;
  }

  std::vector<PatchMesh> Run();

private:
  Index PlaceOf(Index cycle) const
  {
    return static_cast<Index>(std::lower_bound(this->First, this->Last, cycle) - this->First);
  }
  void ChooseRoot();
  void MoveRoot(Index cycle);
  Index CountPossible() const;
  bool FindOutermost(const std::vector<Index>& cycles, std::size_t& outermost) const;
  void FormGroups();
  void FindHeights();

  std::vector<PatchMesh> BuildAll() const;
  bool IsWithinBounds(const std::vector<PatchMesh>& shells) const;
  PatchMesh BuildShell(const ShellGroup& group, double depth) const;
  PatchMesh BuildSmallest(const ShellGroup& group, double minimum, double maximum) const;
  void AddWalls(const CellRegion& region, PatchMesh& shell) const;
  void AddFace(const CellRegion& region, int face, PatchMesh& shell) const;
  Point3 Inward(const Point3& point, double depth) const;

  const CycleGeometry& Geometry;
  CellRegions Regions;
  const Index* First;
  const Index* Last;
  std::vector<CellRegion> OfCycle;
  const std::vector<std::vector<Index>>& Wanted;
  std::vector<ShellGroup> Groups;
};

/// Finds the cycle of a group whose region has the regions of all others within, side by side.
/// False if there is none: then no region lies between the cycles.
bool CellShells::FindOutermost(const std::vector<Index>& cycles, std::size_t& outermost) const
{
  for (outermost = 0; outermost < cycles.size(); ++outermost)
  {
    const CellRegion& outer = this->OfCycle[this->PlaceOf(cycles[outermost])];
    bool possible = true;
    for (std::size_t i = 0; i < cycles.size() && possible; ++i)
    {
      const CellRegion& region = this->OfCycle[this->PlaceOf(cycles[i])];
      // The region between them lies on the same side of all of them.
      possible = i == outermost ||
        (this->Regions.Contains(outer, region) && region.IsLeft() != outer.IsLeft());
      for (std::size_t j = 0; j < cycles.size() && possible; ++j)
      {
        possible = i == outermost || j == outermost || i == j ||
          !this->Regions.Contains(region, this->OfCycle[this->PlaceOf(cycles[j])]);
      }
    }
    if (possible)
    {
      return true;
    }
  }
  return false;
}

Index CellShells::CountPossible() const
{
  Index count = 0;
  std::size_t outermost;
  for (const std::vector<Index>& cycles : this->Wanted)
  {
    count += cycles.size() > 1 && this->FindOutermost(cycles, outermost) ? 1 : 0;
  }
  return count;
}

/// Moves the fixed place, from which all regions lie away, to just inside the region of a cycle.
void CellShells::MoveRoot(Index cycle)
{
  const CellRegion root = this->OfCycle[this->PlaceOf(cycle)];
  for (CellRegion& region : this->OfCycle)
  {
    if (region.Cycles == root.Cycles || this->Regions.Contains(region, root))
    {
      CellRegions::Flip(region);
    }
  }
}

void CellShells::ChooseRoot()
{
  Index maximum = this->CountPossible();
  std::vector<CellRegion> best = this->OfCycle;
  const std::vector<CellRegion> before = this->OfCycle;
  Index wanted = 0;
  for (const std::vector<Index>& cycles : this->Wanted)
  {
    wanted += cycles.size() > 1 ? 1 : 0;
  }
  for (const std::vector<Index>& cycles : this->Wanted)
  {
    for (std::size_t i = 0; i < cycles.size() && cycles.size() > 1 && maximum < wanted; ++i)
    {
      this->OfCycle = before;
      this->MoveRoot(cycles[i]);
      const Index count = this->CountPossible();
      if (count > maximum)
      {
        maximum = count;
        best = this->OfCycle;
      }
    }
  }
  this->OfCycle = std::move(best);
}

void CellShells::FormGroups()
{
  for (const std::vector<Index>& cycles : this->Wanted)
  {
    ShellGroup group;
    std::size_t outermost = 0;
    group.Possible = cycles.size() == 1 || this->FindOutermost(cycles, outermost);
    std::vector<const CellRegion*> members;
    for (const Index cycle : cycles)
    {
      members.push_back(&this->OfCycle[this->PlaceOf(cycle)]);
    }
    group.Region = CellRegions::Subtract(members, outermost);
    this->Groups.push_back(std::move(group));
  }
  // A group on both sides of another one cannot be had.
  for (ShellGroup& inner : this->Groups)
  {
    for (const ShellGroup& outer : this->Groups)
    {
      Index within = 0;
      for (std::size_t i = 0;
           &inner != &outer && inner.Region.Cycles.size() > 1 && i < inner.Region.Cycles.size();
           ++i)
      {
        within +=
          this->Regions.Contains(outer.Region, this->OfCycle[this->PlaceOf(inner.Region.Cycles[i])])
          ? 1
          : 0;
      }
      inner.Possible &= within == 0 || within == static_cast<Index>(inner.Region.Cycles.size());
    }
  }
}

void CellShells::FindHeights()
{
  // Passes until nothing changes: as many as regions are nested, which are few.
  bool changed = true;
  for (std::size_t pass = 0; changed && pass < this->Groups.size(); ++pass)
  {
    changed = false;
    for (ShellGroup& outer : this->Groups)
    {
      for (ShellGroup& inner : this->Groups)
      {
        if (&inner != &outer && outer.Possible && inner.Possible &&
          (pass == 0 || outer.Height <= inner.Height) &&
          this->Regions.Contains(
            outer.Region, this->OfCycle[this->PlaceOf(inner.Region.Cycles.front())]))
        {
          inner.IsContained = true;
          changed |= outer.Height <= inner.Height;
          outer.Height = std::max(outer.Height, inner.Height + 1);
        }
      }
    }
  }
}

Point3 CellShells::Inward(const Point3& point, double depth) const
{
  Point3 inner;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = this->Regions.LowCorner()[axis];
    const double middle = low + 0.5 * (this->Regions.HighCorner()[axis] - low);
    inner[axis] = this->Geometry.Grid.Round(point[axis] + depth * (middle - point[axis]));
  }
  return inner;
}

/// The strips between the cycles and their copies further inside.
void CellShells::AddWalls(const CellRegion& region, PatchMesh& shell) const
{
  for (std::size_t c = 0; c < region.Cycles.size(); ++c)
  {
    const Index begin = region.BorderOffsets[c];
    const Index end = region.BorderOffsets[c + 1];
    for (Index i = begin; i < end; ++i)
    {
      const Index j = i + 1 < end ? i + 1 : begin;
      shell.Triangles.push_back({ i, j, -1 - j });
      shell.Triangles.push_back({ i, -1 - j, -1 - i });
    }
  }
}

/// Fills rings that have no triangles. A ring that is no wider than the precision may be turned
/// over by rounding and then encloses nothing; but the walls beside it are there, and the patch has
/// to be closed.
void AddRingsLeftOut(const std::vector<Point2>& points,
  const std::vector<std::vector<Index>>& rings, std::vector<std::array<Index, 3>>& triangles)
{
  std::vector<std::uint8_t> isUsed(points.size(), 0);
  for (const auto& triangle : triangles)
  {
    for (const Index point : triangle)
    {
      isUsed[point] = 1;
    }
  }
  std::vector<Point2> polygon;
  for (const std::vector<Index>& ring : rings)
  {
    if (isUsed[ring.front()])
    {
      continue;
    }
    polygon.clear();
    for (const Index point : ring)
    {
      polygon.push_back(points[point]);
    }
    for (const auto& [a, b, c] : TriangulatePolygon(polygon))
    {
      triangles.push_back({ ring[a], ring[b], ring[c] });
    }
  }
}

/// Triangulates the copy of the region on one face.
void CellShells::AddFace(const CellRegion& region, int face, PatchMesh& shell) const
{
  const std::array<int, 2> axes = AxesOfFace(face);
  const Index size = static_cast<Index>(region.Border.size());
  // Shell points: the copies of the border, then the eight corners. The copies are triangulated,
  // not the border, because rounding has moved them already.
  std::vector<Index> shellPoints;
  std::vector<Point2> points;
  std::vector<std::vector<Index>> rings = this->Regions.RingsOn(region, face);
  for (std::vector<Index>& ring : rings)
  {
    for (Index& vertex : ring)
    {
      shellPoints.push_back(vertex >= 0 ? vertex : size + (-1 - vertex));
      const Point3& p = shell.Points[shellPoints.back()];
      points.push_back({ p[axes[0]], p[axes[1]] });
      vertex = static_cast<Index>(points.size()) - 1;
    }
  }
  std::vector<std::array<Index, 3>> triangles = TriangulateRings(points, rings);
  AddRingsLeftOut(points, rings, triangles);
  for (const auto& triangle : triangles)
  {
    const Index a = -1 - shellPoints[triangle[0]];
    const Index b = -1 - shellPoints[triangle[1]];
    const Index c = -1 - shellPoints[triangle[2]];
    shell.Triangles.push_back(
      region.IsLeft() ? std::array<Index, 3>{ a, b, c } : std::array<Index, 3>{ a, c, b });
  }
}

/// Drops the corners that are not used.
void Compact(PatchMesh& shell)
{
  std::vector<Index> place(shell.Points.size(), -1);
  std::vector<Point3> used;
  for (auto& triangle : shell.Triangles)
  {
    for (Index& corner : triangle)
    {
      if (corner < 0)
      {
        Index& p = place[-1 - corner];
        if (p < 0)
        {
          p = static_cast<Index>(used.size());
          used.push_back(shell.Points[-1 - corner]);
        }
        corner = -1 - p;
      }
    }
  }
  shell.Points.swap(used);
}

PatchMesh CellShells::BuildShell(const ShellGroup& group, double depth) const
{
  PatchMesh shell;
  shell.Kind = PatchKind::Shell;
  shell.Cycles = group.Region.Cycles;
  for (const Index point : group.Region.Border)
  {
    shell.Points.push_back(this->Inward(this->Geometry.Graph.PointAt(point), depth));
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    shell.Points.push_back(this->Inward(this->Regions.Corner(corner), depth));
  }
  this->AddWalls(group.Region, shell);
  for (int face = 0; face < 6; ++face)
  {
    this->AddFace(group.Region, face, shell);
  }
  return shell;
}

double AreaOf(const CycleGeometry& geometry, const CellRegion& region, const PatchMesh& shell)
{
  const auto at = [&](Index corner) {
    return corner >= 0 ? geometry.Graph.PointAt(region.Border[corner]) : shell.Points[-1 - corner];
  };
  double area = 0.0;
  for (const auto& triangle : shell.Triangles)
  {
    const Point3 p = at(triangle[0]);
    area += 0.5 * Length(Cross(at(triangle[1]) - p, at(triangle[2]) - p));
  }
  return area;
}

PatchMesh CellShells::BuildSmallest(const ShellGroup& group, double minimum, double maximum) const
{
  PatchMesh best;
  double minArea = std::numeric_limits<double>::infinity();
  for (const double part : TriedDepths)
  {
    PatchMesh shell = this->BuildShell(group, minimum + part * (maximum - minimum));
    const double area = AreaOf(this->Geometry, group.Region, shell);
    if (area < minArea)
    {
      minArea = area;
      best = std::move(shell);
    }
  }
  return best;
}

std::vector<PatchMesh> CellShells::BuildAll() const
{
  int highest = 1;
  for (const ShellGroup& group : this->Groups)
  {
    highest = std::max(highest, group.Height);
  }
  std::vector<PatchMesh> shells;
  for (const ShellGroup& group : this->Groups)
  {
    const double maximum = DeepestDisc * group.Height / highest;
    if (!group.Possible)
    {
      shells.emplace_back();
      shells.back().Kind = PatchKind::Shell;
      shells.back().Cycles = group.Region.Cycles;
      continue;
    }
    if (group.Region.Cycles.size() == 1)
    {
      shells.push_back(this->BuildShell(group, maximum));
    }
    else
    {
      const double minimum = DeepestDisc * (group.Height - 1) / highest;
      shells.push_back(
        this->BuildSmallest(group, minimum, group.IsContained ? maximum : DeepestWaist));
    }
    Compact(shells.back());
  }
  return shells;
}

bool CellShells::IsWithinBounds(const std::vector<PatchMesh>& shells) const
{
  return std::all_of(shells.begin(), shells.end(),
    [this](const PatchMesh& shell)
    {
      return std::all_of(shell.Points.begin(), shell.Points.end(),
        [this](const Point3& point) { return this->Geometry.Grid.IsWithinBounds(point); });
    });
}

std::vector<PatchMesh> CellShells::Run()
{
  this->ChooseRoot();
  this->FormGroups();
  this->FindHeights();
  std::vector<PatchMesh> shells = this->BuildAll();
  if (!this->IsWithinBounds(shells))
  {
    this->Regions.ClipToBounds();
    shells = this->BuildAll();
  }
  return shells;
}
}

std::vector<PatchMesh> BuildShells(const CycleGeometry& geometry, const Index* first,
  const Index* last, const std::vector<std::vector<Index>>& groups)
{
  return CellShells(geometry, first, last, groups).Run();
}
}
