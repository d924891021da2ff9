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

/// The contours on one plane of no family: closed loops of at least three points, with their
/// interior on the left as seen from where the normal of the plane points.
struct GuideContours
{
  GuidePlane Plane;
  std::vector<std::vector<Point3>> Loops;
};

/// A part of a contour that guides, from one plane that cuts it to the next.
struct GuidePiece
{
  std::vector<Point3> Points; ///< in the direction of the contour; the ends lie on those planes
  Index Slab = 0;             ///< where it is: see GuideCurves::SlabAt
  std::array<Index, 2> Planes{ -1, -1 }; ///< of the stack, where it begins and ends; -1: another's
};

/// The contours of one slice that guides.
struct GuideSlice
{
  GuidePlane Plane;
  std::vector<GuidePiece> Pieces;
  Index Guiding = 0; ///< pieces that the surface passes through; see GuideSurface
};

/// What guides a surface between its own contours: contours of other slices, with their interior on
/// the left as seen from where the normal of their plane points. Either the surface is that of a
/// stack, or that of all families.
struct GuideCurves
{
  int StackAxis = -1;                        ///< -1: the surface is that of several families
  std::vector<double> StackPlanes;           ///< of a stack, ascending
  std::array<std::vector<double>, 3> Planes; ///< of several families, ascending; of a stack, none
  std::vector<GuideSlice> Slices;
  /// Whether parts of a stack that end between two slices end in the middle between them, with
  /// walls at right angles to the last slice they are on: EndCaps::HalfSlice.
  bool HalfSliceEnds = false;

  /// The mean distance of the planes of the stack; 1 if there are fewer than two.
  double Spacing() const;

  /// The number of the slab, or of the cell of several families, in which a point is.
  Index SlabAt(const Point3& point) const;
};

/// A part that ends the object within that share of the spacing of a stack ends it flat: in the
/// slice.
constexpr double FlatShare = 0.02;

/**
 * Cuts the contours of all other axes where they cross the planes of the stack, or those of slices
 * before them. Contours that cross none guide nothing and are left out. Outwards of the first and
 * the last plane of the stack, contours count as beyond it from FlatShare of the spacing before it:
 * so the side of a rectangle that lies in it, but for rounding, is a piece of its own.
 */
GuideCurves CutGuides(const Contours& contours, const SpatialGrid& grid, int stackAxis);

/**
 * Cuts contours on planes of any inclination likewise, and appends them: where they cross the
 * planes of the surface that they are to guide, or those of slices before them. Without a stack,
 * contours have no ends beyond its planes, and all planes cut alike.
 */
void AddGuides(const std::vector<GuideContours>& others, GuideCurves& curves);
}

#endif
