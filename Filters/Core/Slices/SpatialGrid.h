// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSpatialGrid_h
#define OrthoSlicesSpatialGrid_h

#include "Core/Base/AxisFrame.h"
#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orthoslices
{
/**
 * The spatial grid M of the paper (section 4): the planes of all slices, ascending and distinct on
 * each axis, and the cells, faces, edges and vertices between them.
 *
 * *Slab* k of an axis lies between planes k - 1 and k; slab 0 and slab n (n planes) reach
 * from the outermost planes to the bounds of the surface (Lowest, Highest).
 * A coordinate equal to a plane's lies on its upper side. This symbolic rule, used everywhere, is
 * why no singular cases exist (contours through grid edges, vertices on planes, collinear
 * segments).
 *
 * A plane is *real* if the input has contours on it, and *virtual* if it was added, with contours
 * of a surface that fills the gaps between the real ones. Where a real and a virtual slice
 * contradict each other, the real one is right.
 *
 * An *edge* of M runs along axis t on the intersection of plane i of FirstAxis(t) with plane j of
 * SecondAxis(t), within slab k of t. All edges with the same t, i, j form a *grid line*.
 */
struct SpatialGrid
{
  std::array<std::vector<double>, 3> Planes;
  /// For each plane, 1 if it is virtual; empty if all planes of all axes are real.
  std::array<std::vector<std::uint8_t>, 3> Virtual;
  /// All coordinates of the result, planes included, are values of float.
  bool SinglePrecision = false;
  /// If it is not 0, all coordinates of the result, planes included, are multiples of this power of
  /// 2: for results that will be mapped, so that distinct points stay distinct.
  double Quantum = 0.0;
  /// What lengths and angles are: those of the world as this frame maps it. That of the world
  /// itself if the families are at right angles to each other, whose frame changes neither.
  AxisFrame Metric;
  /// Whether contours cross the planes at the same places, to the last bit, if they run the other
  /// way, as those of a structure on the other side of a common border do.
  bool BothWays = false;
  /// Distance of neighbouring numbers of the precision at the largest coordinate of each axis.
  Point3 Step{ 0.0, 0.0, 0.0 };
  /// Length of the box around all contours along each axis; where it is zero, the greatest of the
  /// three.
  Point3 Extent{ 0.0, 0.0, 0.0 };
  /**
   * How far apart slices are at the ends of the object: the mean spacing of the axis' real planes.
   * An axis with fewer than two of them takes the least of those of the other axes, which tells how
   * fine the object is sampled, but no more than half the extent of the contours along it (where
   * that is zero, of their greatest extent), which is what one plane in the middle leaves on each
   * side. Never less than planes are apart at least, 256 steps of the precision, so that there is
   * room for what lies beyond the outermost ones.
   */
  Point3 SpacingAtEnds{ HUGE_VAL, HUGE_VAL, HUGE_VAL };
  /// The bounds of the surface, values of the precision: the box around all contours of real
  /// planes, widened by half of SpacingAtEnds on each side, and by more where virtual contours
  /// (which should end two hundredths of SpacingAtEnds before that) would else not be within. All
  /// points that are placed in a cell lie within them. Without contours there are none.
  Point3 Lowest{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  Point3 Highest{ HUGE_VAL, HUGE_VAL, HUGE_VAL };

  Index Count(int axis) const { return static_cast<Index>(this->Planes[axis].size()); }

  bool IsVirtual(int axis, Index plane) const
  {
    return !this->Virtual[axis].empty() && this->Virtual[axis][plane] != 0;
  }

  /// Whether any plane is virtual.
  bool HasVirtual() const
  {
    return !this->Virtual[0].empty() || !this->Virtual[1].empty() || !this->Virtual[2].empty();
  }

  /// Number of a slice among those of all axes, x before y before z. That of z-slice Count(2),
  /// which there is not, is how many there are.
  Index SliceNumber(int axis, Index plane) const
  {
    return plane + (axis > 0 ? this->Count(0) : 0) + (axis > 1 ? this->Count(1) : 0);
  }

  /// Slab of a coordinate: the number of planes that are not above it.
  Index Slab(int axis, double coordinate) const
  {
    const auto& planes = this->Planes[axis];
    return static_cast<Index>(
      std::upper_bound(planes.begin(), planes.end(), coordinate) - planes.begin());
  }

  /// The number of the plane at a coordinate, to the last bit; -1 if there is none.
  Index FindPlane(int axis, double coordinate) const
  {
    const Index plane = this->Slab(axis, coordinate) - 1;
    return plane >= 0 && this->Planes[axis][plane] == coordinate ? plane : -1;
  }

  /// Moves a coordinate into the closed slab.
  double Clamp(int axis, Index slab, double coordinate) const
  {
    const auto& planes = this->Planes[axis];
    if (slab > 0)
    {
      coordinate = std::max(coordinate, planes[slab - 1]);
    }
    if (slab < this->Count(axis))
    {
      coordinate = std::min(coordinate, planes[slab]);
    }
    return coordinate;
  }

  /// A coordinate as it will be in the result.
  double Round(double x) const
  {
    if (this->Quantum > 0.0)
    {
      return this->Quantum * std::nearbyint(x / this->Quantum);
    }
    if (!this->SinglePrecision)
    {
      return x;
    }
    // Volatile, because GCC 12 at -O3 vectorizes the conversion to float and back away.
    volatile float rounded = static_cast<float>(x);
    return rounded;
  }

  /// Distance that points inside a cell or on one of its edges keep from the ends of the slab.
  double Margin(int axis, Index slab) const;

  /// Whether a coordinate lies strictly inside the slab.
  bool IsInside(int axis, Index slab, double coordinate) const
  {
    const auto& planes = this->Planes[axis];
    return (slab == 0 || planes[slab - 1] < coordinate) &&
      (slab == this->Count(axis) || coordinate < planes[slab]);
  }

  /// Moves a coordinate into the slab: `share` of its width (at least the Margin) away from its
  /// planes, and not beyond the bounds of the surface.
  double MoveInside(int axis, Index slab, double coordinate, double share = 0.0) const;

  /// Moves a coordinate into the bounds of the surface, as it will be in the result.
  double MoveIntoBounds(int axis, double coordinate) const
  {
    return std::max(this->Lowest[axis], std::min(this->Highest[axis], this->Round(coordinate)));
  }

  /// The ends of a slab; an outermost one ends a mean spacing beyond the range [minimum, maximum],
  /// or once more its length, whatever the bounds of the surface are.
  void GetExtent(
    int axis, Index slab, double minimum, double maximum, double& low, double& high) const;

  /// The part of a range that is within the bounds of the surface.
  void ClipToBounds(int axis, double& low, double& high) const
  {
    low = std::max(low, this->Lowest[axis]);
    high = std::min(high, this->Highest[axis]);
  }

  bool IsWithinBounds(const Point3& point) const
  {
    bool within = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      within = within && this->Lowest[axis] <= point[axis] && point[axis] <= this->Highest[axis];
    }
    return within;
  }

  /// Mean distance of consecutive planes; the extent of all contours where there is only one
  /// plane.
  double MeanSpacing(int axis) const
  {
    const auto& planes = this->Planes[axis];
    return planes.size() < 2 ? this->Extent[axis]
                             : (planes.back() - planes.front()) / (planes.size() - 1.0);
  }

  /// Width of a slab; the mean spacing for an outermost one.
  double Width(int axis, Index slab) const
  {
    const auto& planes = this->Planes[axis];
    return slab > 0 && slab < this->Count(axis) ? planes[slab] - planes[slab - 1]
                                                : this->MeanSpacing(axis);
  }
};

/// The number of axes that have planes.
int CountFamilies(const SpatialGrid& grid);

/// The number of planes of the axis that has most.
Index MostPlanes(const SpatialGrid& grid);

/// The axis of the only family of slices; -1 if there are none or several.
int FindOnlyFamily(const SpatialGrid& grid);

/// The least mean spacing of the planes of an axis, of those that have two or more of them.
double MinMeanSpacing(const SpatialGrid& grid);

/// The least mean spacing of the planes of the two axes that lie in the slices across `axis`; if
/// neither of these has two planes, that of all axes.
double MeanSpacingInSlices(const SpatialGrid& grid, int axis);

/// A face of M: the rectangle between its four grid lines, on a slice.
struct Face
{
  int Axis;
  Index Plane;
  std::array<Index, 2> Slab; ///< along FirstAxis and SecondAxis
};

/// An edge of M in numbers: direction, the planes of the other two axes, slab.
struct GridEdge
{
  int Direction;
  Index First;  ///< plane of FirstAxis(Direction)
  Index Second; ///< plane of SecondAxis(Direction)
  Index Slab;   ///< slab of Direction
};

/// Whether the slice of a family at an edge of M is virtual: family 0 is the slice of
/// FirstAxis(Direction), family 1 that of SecondAxis(Direction).
inline bool IsVirtualSlice(const SpatialGrid& grid, const GridEdge& edge, int family)
{
  return family == 0 ? grid.IsVirtual(FirstAxis(edge.Direction), edge.First)
                     : grid.IsVirtual(SecondAxis(edge.Direction), edge.Second);
}

/// Whether both slices at an edge of M are real, so that it counts what they disagree on.
inline bool AreReal(const SpatialGrid& grid, const GridEdge& edge)
{
  return !IsVirtualSlice(grid, edge, 0) && !IsVirtualSlice(grid, edge, 1);
}

/// Packs the edges of a grid into one number, ascending along each grid line.
class GridEdgeCode
{
public:
  explicit GridEdgeCode(const SpatialGrid& grid);

  std::uint64_t Encode(const GridEdge& edge) const
  {
    const int t = edge.Direction;
    return this->Base[t] +
      (static_cast<std::uint64_t>(edge.First) * this->Count[SecondAxis(t)] + edge.Second) *
      (this->Count[t] + 1) +
      edge.Slab;
  }
  GridEdge Decode(std::uint64_t code) const;

private:
  std::array<std::uint64_t, 3> Count; ///< planes on each axis
  std::array<std::uint64_t, 3> Base;  ///< code of the first edge in each direction
};

/**
 * Finds the planes of all contours and sets Contours::Plane. Planes closer than `tolerance`, or
 * than a few dozen steps of the precision, to the first of a group become one at the median
 * coordinate of the group's contours; the contours move onto it. A plane is virtual if all of its
 * contours are; otherwise these have no say in its coordinate. Sets the bounds of the surface. With
 * a quantum, vertices of contours become multiples of it, too.
 */
SpatialGrid BuildSpatialGrid(
  Contours& contours, double tolerance, bool singlePrecision = false, double quantum = 0.0);

/// Narrows the bounds of the surface to the border of the image, but for as much room beyond it as
/// keeps contours of virtual planes on it. REQUIRES: no contour lies beyond the border.
void LimitBounds(const Box3& border, SpatialGrid& grid);
}

#endif
