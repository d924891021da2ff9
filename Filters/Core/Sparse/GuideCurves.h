// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesGuideCurves_h
#define OrthoSlicesGuideCurves_h

#include "Core/Base/Contours.h"
#include "Core/Base/Vectors.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/// A plane of any inclination: of the points whose product with the unit vector Normal is Offset.
struct GuidePlane
{
  Point3 Normal{};
  double Offset = 0.0;

  double HeightOf(const Point3& point) const { return Dot(this->Normal, point) - this->Offset; }
};

/// A part of a contour across a stack, from one plane that cuts it to the next.
struct GuidePiece
{
  std::vector<Point3> Points; ///< in the direction of the contour; the ends lie on those planes
  Index Slab = 0;             ///< number of planes of the stack below it
  std::array<Index, 2> Planes{ -1, -1 }; ///< of the stack, where it begins and ends; -1: another's
};

/// The contours of one slice across a stack.
struct GuideSlice
{
  GuidePlane Plane;
  std::vector<GuidePiece> Pieces;
};

/// What guides the surface of a stack: contours of slices across, with their interior on the left as
/// seen from where the normal of their plane points.
struct GuideCurves
{
  int StackAxis = -1;
  std::vector<double> StackPlanes; ///< ascending
  std::vector<GuideSlice> Slices;

  /// The mean distance of the planes of the stack; 1 if there are fewer than two.
  double Spacing() const;
};

/// A part that ends the object within that share of the spacing of a stack ends it flat: in the slice.
constexpr double FlatShare = 0.02;

/**
 * Cuts the contours of all other axes where they cross the planes of the stack, or those of slices
 * before them. Contours that cross none guide nothing and are left out. Outwards of the first and the
 * last plane of the stack, contours count as beyond it from FlatShare of the spacing before it: so
 * the side of a rectangle that lies in it, but for rounding, is a piece of its own.
 */
GuideCurves CutGuides(const Contours& contours, const SpatialGrid& grid, int stackAxis);
}

#endif
