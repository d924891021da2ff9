// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCrossingGuard_h
#define OrthoSlicesCrossingGuard_h

#include "Core/Improve/BoxTree.h"
#include "Core/Improve/SheetBorders.h"
#include "Core/Surface/CornerTable.h"

#include <vector>

namespace orthoslices
{
/// Triangles of a surface that others would replace.
struct SurfaceChange
{
  std::vector<Index> Removed;              ///< triangles
  std::vector<std::array<Index, 3>> Added; ///< corners of others, counter-clockwise
  Index Point = -1;                        ///< a point that would have another place; -1: none.
                                           ///< May be the next one that the surface will get
  Point3 Place{};                          ///< that place
};

/// The box of a triangle; empty if it is gone.
Box3 BoxOf(const CornerTable& corners, const std::vector<Point3>& points, Index triangle);

/// The boxes of all triangles.
std::vector<Box3> BoxesOf(const CornerTable& corners, const std::vector<Point3>& points);

/**
 * Tells whether a surface whose triangles meet in their common corners and sides only would remain
 * so if some were replaced by others with the same border. What lies around one point and is a fan
 * in a projection along an axis needs no tests of pairs, and neither does what a line in that
 * projection separates; the rest is tested triangle against triangle. All tests are exact, or say
 * no when they are not certain. Where sheets meet, their points at one place count as one, and a
 * side between two of these places stays the only one. Time does not grow with the surface, where
 * few triangles are near each other.
 */
class CrossingGuard
{
public:
  /// The surface is the caller's, who changes it, and the boxes around its triangles. Several guards
  /// may look at it at the same time.
  CrossingGuard(const CornerTable& corners, const std::vector<Point3>& points, const BoxTree& boxes,
    const SheetBorders& borders = SheetBorders::None());

  bool Allows(const SurfaceChange& change);

private:
  /// A corner of the triangles that are added.
  struct Corner
  {
    Index Point;
    Point3 Place;
    Point2 Projected;
  };
  using Places = std::array<Point3, 3>;
  /// A triangle that is added.
  struct AddedTriangle
  {
    std::array<Index, 3> Points; ///< of those at one place the first one, as everywhere here
    Places Corners;
    Box3 Box;
  };

  void SetChange(const SurfaceChange& change);
  void ChooseAxis();
  bool IsRemoved(Index triangle) const;
  bool IsCornerOfAdded(Index point) const;
  const Point3& PlaceOf(Index point) const
  {
    return point == this->Change->Point ? this->Change->Place : this->Points[point];
  }
  Places PlacesOf(const std::array<Index, 3>& triangle) const;
  std::array<Index, 3> CornersOf(Index triangle) const;
  Point2 Project(const Point3& place) const;
  void ListAround(Index point);
  bool IsFan(Index point) const;
  bool DoublesSide(Index a, Index b) const;
  bool DoublesAnySide() const;
  bool AreApartAround(Index point);
  bool LineSeparates(const std::array<Index, 3>& triangle) const;
  bool PlaneSeparates(const std::array<Index, 3>& triangle) const;
  bool IsApart(Index triangle);
  void ListClose(Index triangle, const std::array<Index, 3>& corners, bool isBeside);

  const CornerTable& Corners;
  const std::vector<Point3>& Points;
  const BoxTree& Boxes;
  const SheetBorders& Borders;
  const SurfaceChange* Change = nullptr;
  std::vector<AddedTriangle> Added;
  std::vector<Corner> AddedCorners;
  int Axis = 0;                             ///< of the projection
  int Direction = 1;                        ///< 1 if triangles run counter-clockwise there, else -1
  std::vector<std::array<Index, 3>> Around; ///< triangles at a point, which is their first corner
  std::size_t AddedAround = 0;              ///< how many of them are added; they come first
  std::vector<Index> Near;
  std::vector<std::size_t> Close; ///< of what is added, what a triangle may meet
};
}

#endif
