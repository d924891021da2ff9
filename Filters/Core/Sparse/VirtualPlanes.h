// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesVirtualPlanes_h
#define OrthoSlicesVirtualPlanes_h

#include "Core/Base/Box.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/// Planes on which nobody has drawn, of each axis, ascending.
using VirtualPlanes = std::array<std::vector<double>, 3>;

/**
 * Where slices are too few for the cells between them to be small against the shape, and how far
 * apart planes have to be there. Extents are those of the box of all contours.
 *
 * - An axis without planes is sparse everywhere. One with planes is sparse in the slabs that are
 *   wider than 1.4 twelfths of its extent: a shape of some detail is seen by a dozen slices.
 * - There, planes are to be as far apart as those of the densest axis, but at most a twelfth and
 *   at least a 64th of the extent of their own axis, so that a fine stack does not multiply the
 *   triangles by itself. `spacing` > 0 takes the place of this rule, in world units.
 */
class SliceDensity
{
public:
  SliceDensity(const SpatialGrid& grid, const Box3& contours, double spacing = 0.0);

  /// Whether there is a sparse slab.
  bool IsSparse() const { return this->Sparse; }
  /// How far apart planes have to be, along an axis.
  double Spacing(int axis) const { return this->Target[axis]; }
  /// How long the edges of a mesh may be that shows the same detail: by the longest axis.
  double EdgeLength() const;
  /// The number of parts of a slab of this width.
  int CountParts(int axis, double width) const;

private:
  Point3 Extent, Target{}, Wide{};
  bool Sparse = false;
};

/**
 * The planes to add between those of the grid, for a surface within the box `surface`: in each
 * sparse slab as many as divide it evenly. They keep a distance from the ends of the surface, where
 * its sections are points.
 */
VirtualPlanes ChooseVirtualPlanes(
  const SpatialGrid& grid, const Box3& surface, const SliceDensity& density);
}

#endif
