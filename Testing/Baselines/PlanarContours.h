// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours of one family as plain polygons in the plane, slice by slice
 *
 * Slices orthogonal to `axis` have the coordinates u along axis + 1 and v along axis + 2 (modulo
 * 3): seen from the positive end of the axis, (u, v) is right-handed.
 */

#ifndef OrthoSlicesPlanarContours_h
#define OrthoSlicesPlanarContours_h

#include <array>
#include <vector>

class vtkPolyData;

namespace orthoslices
{
namespace baselines
{

using Point2 = std::array<double, 2>;

/// A simple polygon; the last vertex is joined to the first.
using Loop = std::vector<Point2>;

struct Slice
{
  double Coordinate = 0.0;
  std::vector<Loop> Loops;
};

/// Position in space of a point of a slice.
std::array<double, 3> PlaceInSpace(int axis, double coordinate, const Point2& point);

/// Positive if the loop runs counter-clockwise.
double SignedArea(const Loop& loop);

/// Length with the closing segment.
double Perimeter(const Loop& loop);

/// Even-odd rule.
bool IsInside(const Point2& point, const Loop& loop);

/**
 * The slices of one family in ascending order of their planes; loops on one plane keep the order
 * of the cells. Cells of fewer than three different points are left out. Contours belong to one
 * plane if their mean coordinates differ by less than 1e-6 of the diagonal of the bounds.
 *
 * Planes without contours can only be seen if there is a cell array "PlaneIndex": where it skips
 * numbers, as many empty slices are put in at equal distances.
 */
std::vector<Slice> ExtractSlices(vtkPolyData* contours, int axis);

/**
 * Number of other loops of the slice around each loop: even for boundaries of the interior, odd for
 * boundaries of holes.
 */
std::vector<int> NestingDepths(const Slice& slice);

/// Makes boundaries of the interior counter-clockwise and those of holes clockwise.
void OrientByNesting(Slice& slice);

} // namespace baselines
} // namespace orthoslices

#endif
