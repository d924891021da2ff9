// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSlabPull_h
#define OrthoSlicesSlabPull_h

#include "Core/Sparse/SurfaceMesh.h"

#include <vector>

namespace orthoslices
{
/**
 * What the slices say of a surface far from their contours: that it lies between them. A ledge, a
 * saddle or a top that spreads far from all contours can be anywhere in its slab, and its mean
 * place is the middle; the surface of least bending, which knows nothing of slabs, hugs the slice
 * that its contours lie on or runs through it. As a spring: the sum over all points of Strength
 * times the square of the distance from the plane of constant coordinate Aim, along the axis of the
 * slices, joins the bending.
 */
struct SlabPull
{
  std::vector<double> Strength; ///< of each point, for the squared distance; 0 if it is fixed
  std::vector<double> Aim;      ///< of each point, a coordinate along the axis

  bool IsEmpty() const { return this->Strength.empty(); }
};

/**
 * The pull for a mesh with a StretchAxis. The strength is the point's area as seen along the axis,
 * so that steep parts, whose places the contours say, feel nothing, times a function of the
 * roughness by the fourth power of the width of the slab: the reach of a spring against bending is
 * the fourth root of bending by strength, and it must be a matter of spacings.
 *
 * `roughness` is the mean over the surface of the square of the bending (twice the mean curvature,
 * times the width of the slab) of the surface without a pull: 0.1 where slices show all of a smooth
 * shape, 0.8 for scans of rough ones. The smoother a shape is, the farther is least bending to be
 * trusted, and the less it is pulled.
 *
 * REQUIRES: the points are about where they are going to be, so that it shows where the surface is
 * flat and which way it faces. Cells beyond the last slices are half a slab wide.
 */
SlabPull PullIntoSlabs(const SurfaceMesh& mesh, double roughness);
}

#endif
