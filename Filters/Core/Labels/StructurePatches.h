// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesStructurePatches_h
#define OrthoSlicesStructurePatches_h

#include "Core/Cells/FindContacts.h"
#include "Core/Labels/CellOfStructures.h"
#include "Core/Labels/SheetPatch.h"

#include <deque>
#include <map>
#include <set>
#include <vector>

namespace orthoslices
{
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
  bool IsOneCycle = true;   ///< of distinct points; else nothing can take its place
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

/// Patches of a cell by their numbers, ascending.
using PatchGroup = std::vector<Index>;

/// The patches of all structures in one cell. Points have the same number in all of them if they
/// are at the same place, to the last bit.
class StructurePatches final : public CellPoints
{
public:
  explicit StructurePatches(const StructureTables& tables)
    : Tables(tables)
    , Structures(tables.Structures)
  {
  }

  /// Starts anew with the patches of these cycles. Borders that are the same become one patch of
  /// several owners.
  void Set(const std::vector<StructureCycle>& cycles);
  /// The patch of several cycles gives way to one for each of them, once the patches are set again.
  /// False if it has already.
  bool Break(const CellPatch& patch) { return this->Broken.insert(patch.Mesh).second; }

  /// Whether one of the cycles of a patch is all of the border of another patch.
  bool HasBorderOfAnother(Index patch) const;

  Index Count() const { return static_cast<Index>(this->Patches.size()); }
  const CellPatch& operator[](Index patch) const { return this->Patches[patch]; }
  Index NumberOf(const Point3& place) override;
  const Point3& PlaceOf(Index point) const override { return this->Places[point]; }
  /// The points around a cycle, in its direction.
  std::vector<Index> BorderOf(const StructureCycle& cycle);
  /// The patches of which a side of a border is part, by that side.
  const std::map<CellEdge, PatchGroup>& Sides() const { return this->PatchesAt; }
  /// The points of a border before which it is that of other patches than after them. None of a
  /// patch of several cycles.
  std::vector<Index> PartingPoints(Index patch) const;

  /// Patches of a group that touch. Triangles that several patches have count once.
  std::vector<std::pair<Index, Index>> FindContactsOf(const PatchGroup& group) const;
  /// Gives a patch of one cycle a new form.
  void Take(Index number, InnerPatch&& made);

  /// The grid of the first structure of a group.
  const SpatialGrid& GridOf(const PatchGroup& group) const
  {
    return this->Structures[this->Patches[group.front()].Owners.front().Structure].Geometry.Grid;
  }
  /// How long the sides of triangles are.
  double EdgeLength(const PatchGroup& group) const
  {
    return this->Tables.Options.EdgeLength * MinMeanSpacing(this->GridOf(group));
  }
  /// The border of a patch with the normals that its first owner has there.
  SheetBorder BorderOfSheets(Index patch) const;
  /// A place for a point that all patches of a group have in common.
  Point3 MoveInside(const PatchGroup& group, const Point3& point) const;
  /// A place for a point of one patch, which may be close to a face of the cell.
  Point3 KeepInside(const PatchGroup& group, const Point3& point) const;
  /// Where points inside the patches of a group may be.
  Box3 RoomOf(const PatchGroup& group) const;
  Point3 MiddleOfBorder(const CellPatch& patch) const;

private:
  Point3 MoveInside(const PatchGroup& group, Point3 point, double share) const;
  void AddCycle(const StructureCycle& cycle);
  void AddTriangles(const StructureCycle& cycle, CellPatch& patch);
  void NumberCorners(Index number, std::vector<PatchTriangle>& triangles);
  bool IsPartingPoint(const CellPatch& patch, std::size_t i) const;

  const StructureTables& Tables;
  const std::vector<StructureSurface>& Structures;
  std::map<Point3, Index> Numbers;
  std::deque<Point3> Places;
  std::vector<CellPatch> Patches;
  std::map<std::vector<Index>, Index> ByBorder;
  std::map<CellEdge, PatchGroup> PatchesAt;
  std::set<const PatchMesh*> Broken;
};
}

#endif
