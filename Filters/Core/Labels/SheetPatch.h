// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSheetPatch_h
#define OrthoSlicesSheetPatch_h

#include "Core/Patches/SmoothPatch.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace orthoslices
{
/// Points of a cell by their numbers.
struct CellPoints
{
  /// The number of a point; a new one if it has none.
  virtual Index NumberOf(const Point3& place) = 0;
  virtual const Point3& PlaceOf(Index point) const = 0;

protected:
  ~CellPoints() = default;
};

/// A side of a border, the lesser number of its ends first.
using CellEdge = std::pair<Index, Index>;
inline CellEdge CellEdgeOf(Index a, Index b) { return std::minmax(a, b); }

/// A curve in which surfaces of structures meet within a cell, from a point on its boundary to
/// another.
struct JunctionCurve
{
  Index First, Last;
  std::vector<Index> Inside;    ///< its other points, in order, at least one
  std::vector<Point3> Normals;  ///< there, of the smooth surface that it is on; zero if not known
  std::set<CellEdge> OnSurface; ///< the sides of the border of that surface
};

/// Curves that meet in one point within a cell.
struct JunctionStar
{
  Index Middle;                             ///< the point
  Point3 Normal;                            ///< there, of the smooth surface that it is on
  std::map<Index, JunctionCurve> CurveFrom; ///< the point, by their other ends
  std::set<CellEdge> OnSurface;             ///< the sides of the border of that surface
};

/// A border with the normals of the surface, empty if they are not known.
struct SheetBorder
{
  std::vector<Index> Points;
  std::vector<Point3> Normals;
};

/**
 * Builds patches of borders on which curves begin and end that divide them into *sheets*. Each
 * curve cuts off the part of the border between its ends; what is left is a sheet, too. Sheets are
 * smooth patches between their part of the border and the curves, or fans around the middle of a
 * curve where that cannot be. Each is built once, so that it has the same triangles in all patches
 * that it is part of, whichever way their borders run.
 */
class SheetBuilder
{
public:
  /// `room` is where points may be.
  SheetBuilder(const SpatialGrid& grid, const PatchResolution& resolution, const Box3& room,
    CellPoints& points)
    : Grid(grid)
    , Smooth(grid, resolution)
    , Room(room)
    , Points(points)
  {
  }

  /// The patch of a border with all curves that end on it. False if ends of others lie between the
  /// ends of one.
  bool Build(
    const SheetBorder& border, const std::vector<JunctionCurve>& curves, InnerPatch& patch);
  /// The patch of a border that curves from some of its points divide into sheets around the point
  /// where they meet. False if there are less than two.
  bool Build(const SheetBorder& border, const JunctionStar& star, InnerPatch& patch);

private:
  struct Sheet
  {
    std::vector<Index> Border; ///< from its least number
    std::vector<std::array<Index, 3>> Triangles;
    std::vector<Index> Inside;
    std::vector<Point3> Normals; ///< of the points inside
  };
  struct Outline;

  void AddPath(const SheetBorder& border, Index from, Index to, Outline& outline) const;
  void AddCurve(
    const JunctionCurve& curve, Index from, const CellEdge& beside, Outline& outline) const;
  const Sheet& FindSheet(const Outline& outline, bool& isReversed);
  Sheet MakeSheet(const Outline& outline);
  bool MakeSmooth(const Outline& outline, Sheet& sheet);
  void MakeFan(const Outline& outline, Sheet& sheet);
  void AppendAll(
    const SheetBorder& border, const std::vector<Outline>& outlines, InnerPatch& patch);
  void Append(
    const Sheet& sheet, bool isReversed, std::map<Index, Index>& corner, InnerPatch& patch) const;

  const SpatialGrid& Grid;
  SmoothPatchBuilder Smooth;
  Box3 Room;
  CellPoints& Points;
  std::vector<Sheet> Sheets;
};
}

#endif
