// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSmoothPatch_h
#define OrthoSlicesSmoothPatch_h

#include "Core/Patches/PatchView.h"
#include "Core/Patches/SmoothSurface.h"
#include "Core/Planar/DiscTriangulation.h"

namespace orthoslices
{
/// How fine patches are.
struct PatchResolution
{
  double EdgeLength = 0.0; ///< of the sides of triangles, in world units
  /// Greatest distance of a side's middle from the surface, in world units; 0 for any. Then sides
  /// are as short as that asks, EdgeLength at most.
  double ChordTolerance = 0.0;
  /// See PatchOptions. If it is not 0, it takes the place of ChordTolerance, and EdgeLength is a
  /// share of each patch's mean radius.
  double Accuracy = 0.0;
  /// Whether triangles become as small as short sides of the border ask for, also if they are to be
  /// few: where the border keeps such sides.
  bool KeepsBorder = false;
};

/**
 * Builds smooth patches (our own addition): the border seen in the plane (PatchView) is
 * triangulated with points inside (DiscTriangulation), and each of these is moved along its line
 * to where a smooth surface is (SmoothSurface), but not out of the cell. Borders of a thousand
 * points and more get fewer points inside than the resolution asks for.
 */
class SmoothPatchBuilder
{
public:
  SmoothPatchBuilder(const SpatialGrid& grid, const PatchResolution& resolution)
    : Grid(grid)
    , Resolution(resolution)
  {
  }

  /// Fits the surface alone, for Deviation; false if that is impossible.
  bool Fit(const PatchBorder& border);
  /// False if the border cannot be seen as a whole or leaves no room for the precision, or if the
  /// surface runs away from the contours.
  bool Build(const PatchBorder& border, InnerPatch& patch)
  {
    return this->Build(border, border, patch);
  }
  /// The same, with triangles whose corners on the border are those of another one, `outline`,
  /// which may have fewer points.
  bool Build(const PatchBorder& border, const PatchBorder& outline, InnerPatch& patch);
  /// How far the border of the last patch lies off a surface without creases, in world units.
  double Deviation() const { return this->View.Radius() * this->Surface.Deviation(); }

private:
  double SizeOfTriangles() const;
  double HeightAtBorder(const Point2& p) const;
  bool FindHeight(const Point2& p, double& z, Point3& gradient) const;
  bool SearchHeight(const Point2& p, double guess, double& z, Point3& gradient) const;
  bool RunsAway(const Point3& place) const;
  bool Triangulate(const PatchBorder& border, const PatchBorder& outline);
  void Balance(const PatchBorder& outline, InnerPatch& patch) const;
  bool PlacePoint(const PatchBorder& border, const Point2& p, InnerPatch& patch) const;

  const SpatialGrid& Grid;
  PatchResolution Resolution;
  PatchView View;
  SmoothSurface Surface;
  DiscTriangulation Disc;
};
}

#endif
