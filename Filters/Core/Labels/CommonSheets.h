// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCommonSheets_h
#define OrthoSlicesCommonSheets_h

#include "Core/Improve/ImproveSurface.h"
#include "Core/Labels/CommonCells.h"

#include <tuple>
#include <vector>

namespace orthoslices
{
/**
 * The surfaces of several structures as one, in which a triangle that structures have in common is
 * there once. It consists of sheets: parts whose triangles belong to the same structures, and which
 * all of these continue in the same way. Where structures part, sheets end (SheetBorders). So
 * whatever is done to a sheet is done to all structures that have it.
 */
class CommonSheets
{
public:
  /// With `keepContours`, all points of G stay where they are. Structures have to outlive this.
  CommonSheets(
    const std::vector<StructureSurface>& structures, bool keepContours, const Execution& execution);

  /// Whether that could be made of them: none has the same triangle twice, and no sheet
  /// two borders along the same edge.
  bool AreFound() const { return this->Found; }

  /// As a mesh to be improved, whose first points are to stay where they are, and how many these are.
  /// REQUIRES: AreFound.
  ImprovableMesh MakeMesh() const;
  Index CountKept() const { return this->Numbers.Kept; }

  /// Sets Patches::Improved of all structures from the mesh that MakeMesh made.
  void SetImproved(const ImprovableMesh& mesh) const;

private:
  /// A triangle of a structure.
  struct Member
  {
    Index Structure, Triangle;
    bool IsReversed; ///< it runs the other way
  };
  /// The sites of a triangle, ascending, its structure, and its number there.
  using SitesOfTriangle = std::tuple<std::array<Index, 3>, Index, Index>;
  /// How corners of triangles belong to points of the mesh.
  struct PointNumbers
  {
    std::vector<Index> OfCorner;
    Index Beyond = 0, Kept = 0, FirstInside = 0, Count = 0;
  };

  void FindSites();
  bool FindTriangles();
  void AddTriangle(const std::vector<SitesOfTriangle>& all, std::size_t begin);
  void FindSheets();
  void LinkSheets();
  void FindCrowdedEdges();
  void FindPoints();
  void FindFixed();
  void FollowBorders();
  bool AreBordersSingle() const;
  Index Count() const { return static_cast<Index>(this->Corners.size()); }
  Index SiteAt(const Member& member, int i) const;
  Index CornerAt(Index triangle, Index site) const;
  Index FindNeighbor(Index corner) const;
  Index StartOf(Index corner) const { return this->PointOf[CornerTable::Next(corner)]; }
  Index EndOf(Index corner) const { return this->PointOf[CornerTable::Previous(corner)]; }
  bool IsOnContour(Index corner, const Member& member) const;
  Index LocalPoint(Index corner, const Member& member) const;
  std::vector<std::uint8_t> ListKinds(bool keepContours) const;
  void NumberPoints(bool keepContours);
  std::vector<std::array<Index, 3>> ListWithBeyond() const;
  void MarkCurves(CornerTable& corners) const;
  void PlacePoints(ImprovableMesh& mesh) const;
  void NoteCopies(ImprovableMesh& mesh) const;
  std::vector<Box3> ListRooms() const;
  void SetImproved(Index structure, const ImprovableMesh& mesh, TrianglesLeft&& left) const;

  const std::vector<StructureSurface>& Structures;
  std::vector<SurfaceTriangles> Surfaces;
  std::vector<CornerTable> Tables;
  bool Found = false;
  Index Sites = 0;                           ///< places of points
  std::vector<std::vector<Index>> SiteOf;    ///< of each point of each structure; -1: not used
  std::vector<std::array<Index, 3>> Corners; ///< of each triangle, the sites
  std::vector<Index> MemberOffsets{ 0 };
  std::vector<Member> Members; ///< of each triangle; as it runs in the first one, it is in Corners
  std::vector<std::vector<Index>> TriangleOf; ///< of each triangle of each structure
  std::vector<Index> Sheet;                   ///< of each triangle, which structures it belongs to
  std::vector<Index> FirstOfSheet;            ///< and of each such set, a triangle
  std::vector<Index> Opposite;                ///< of each corner, as in a CornerTable; -1: border
  std::vector<std::uint8_t> IsCrowded; ///< of each corner: its edge has other than two triangles
  std::vector<Index> PointOf;          ///< of each corner, the least one at the same point
  std::vector<std::uint8_t> IsFixed;   ///< of these: the point is on a border, or one of several
  std::vector<Index> Beyond;           ///< of the corners of edges that are borders: of which one
  PointNumbers Numbers;
};
}

#endif
