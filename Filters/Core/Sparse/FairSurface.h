// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFairSurface_h
#define OrthoSlicesFairSurface_h

#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/// The Laplacian of a mesh by which its bending is measured, after the stretch of SurfaceMesh.
enum class EdgeWeights
{
  Uniform,    ///< knows the connections only, as if all edges had the same length and all points
              ///< the same area: for a mesh whose shape says nothing yet
  Cotangents, ///< of the surface as it is; angles below 3 degrees count as such of 3 degrees
  RoundCotangents ///< the same, and round shapes do not shrink (KeepRound)
};

/**
 * Moves the points that are not fixed to where the surface bends least: the sum over all points of
 * the area times the square of the Laplacian of the position, which is twice the mean curvature, is
 * minimal (L. Kobbelt et al., "Interactive Multi-Resolution Modeling on Arbitrary Meshes", 1998).
 * On a closed surface this is, by the theorem of Gauss and Bonnet, where the sum of the squares of
 * both principal curvatures is minimal. Areas and Laplacian are those of the mesh as it is given,
 * so that positions are the solution of linear equations.
 *
 * Contours are interpolated: fixed points stay, and the bending at them counts, so that the surface
 * passes them smoothly; that at points of creases does not; a patch all of whose contours are
 * creases is left as it is, and so is a component with contours in one slice alone. With cotangents
 * and a StretchAxis, what spreads far from its contours is pulled to the middle of its slab
 * (SlabPull). Points that would leave their cell are moved onto its boundary, and the others placed
 * anew if that was more than a hundredth of the cell, three times at most; with uniform weights and
 * a StretchAxis not at all. So all free points are within their cells. Triangles may cross.
 * Where the equations have no finite solution, points stay as they are.
 */
void FairSurface(EdgeWeights weights, SurfaceMesh& mesh);
}

#endif
