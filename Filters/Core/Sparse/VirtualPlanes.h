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

/// What shows the shape between slices: a surface that bends from one to the next, or a field
/// through all of them (SliceField).
enum class SparseRule : std::uint8_t
{
  Bending,
  Field
};

/**
 * Where slices are too few for the cells between them to be small against the shape, and how far
 * apart planes have to be there (our own rules). Extents are those of the box of all contours.
 *
 * - Where a family is missing, its axis is sparse everywhere.
 * - An axis with at most a third of the planes of the densest one, such as that of a long-axis
 *   slice through a stack, is sparse in slabs that are wider than 1.4 twelfths of its extent: a
 *   shape of some detail is seen by a dozen slices; and wider than 1.4 times the spacing of the
 *   densest axis, as a flat object has few slices across. Between axes with about as many planes
 *   cells are about as long as wide, and patches from the contours around them are as good as any.
 * - But where all families have fewer than eight slices, these are not enough for a surface to bend
 *   from one to the next, and nothing is sparse; except in stacks of at least five slices with a
 *   few across of one family, one or two, or at most a third as many: these show how the object
 *   goes on and ends. With slices across of two families, a stack takes eight.
 *
 * A field takes several families of fewer than a dozen slices each, or a stack of 8 to 16 with a
 * few across; then all axes are sparse in slabs that are wider than 1.4 times what planes are to be
 * apart.
 *
 * In sparse slabs, planes are to be as far apart as those of the densest axis, but at most a
 * twelfth and at least a 64th of the extent of their own axis, so that a fine stack does not
 * multiply the triangles by itself. `spacing` > 0, in world units, takes the place of these rules
 * for bending, and of this distance: then an axis without planes is sparse, and so is each slab
 * that is wider than 1.4 times `spacing`.
 *
 * REQUIRES: the grid has planes.
 */
class SliceDensity
{
public:
  SliceDensity() = default; ///< of slices that are not sparse anywhere
  SliceDensity(const SpatialGrid& grid, const Box3& contours, double spacing = 0.0,
    SparseRule rule = SparseRule::Bending);

  /// Planes half as many, for a surface that need not be as exact.
  void Coarsen();

  /// The axis of a stack of five slices and more that has a few across; -1 if this is none.
  int StackAxis() const { return this->Stack; }
  /// Whether there is a sparse slab.
  bool IsSparse() const { return this->Sparse; }
  /// Whether slices are so few that no surface can bend from one to the next.
  bool IsOfField() const { return this->OfField; }
  /// How far apart planes have to be along an axis, in world units; 0 if the rules find nothing
  /// sparse.
  double Spacing(int axis) const { return this->Target[axis]; }
  /// How long the edges of a mesh may be that shows the same detail, in world units: half of the
  /// spacing along the axis of the greatest extent, 0.35 of it for two families.
  double EdgeLength() const;
  /// How often the mesh is to be made anew and bent with cotangents: once, twice for two families,
  /// whose contours are close enough together for the surface to settle.
  int Rounds() const { return this->IsFine ? 2 : 1; }
  /// The number of parts into which planes are to divide a slab of this width; 1 if it is not
  /// sparse.
  int CountParts(int axis, double width) const;

private:
  Point3 Target{};
  Point3 Wide{}; ///< slabs up to that width stay as they are
  int Longest = 0;
  int Stack = -1;
  bool IsFine = false; ///< two families, neither of them a few slices across the other
  bool Sparse = false;
  bool OfField = false;
};

/**
 * The planes to add between those of the grid, for a surface within the box `surface`: in each
 * sparse slab as many as divide it evenly, rounded as the grid says. The first and the last are
 * half as far from the ends of the surface, where its sections are points, as they are from each
 * other.
 */
VirtualPlanes ChooseVirtualPlanes(
  const SpatialGrid& grid, const Box3& surface, const SliceDensity& density);
}

#endif
