// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFairSurface_h
#define OrthoSlicesFairSurface_h

#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/// The Laplacian of a mesh by which its bending is measured.
enum class EdgeWeights
{
  Uniform,   ///< knows the connections only: for a mesh whose shape says nothing yet
  Cotangents ///< of the surface as it is
};

/**
 * Moves the points that are not fixed to where the surface bends least: the sum over all points of
 * the area times the square of the Laplacian of the position, which is the mean curvature, is
 * minimal (L. Kobbelt et al., "Interactive Multi-Resolution Modeling on Arbitrary Meshes", 1998).
 * On a closed surface this is, by the theorem of Gauss and Bonnet, where the sum of the squares of
 * both principal curvatures is minimal. Contours are interpolated, and the surface passes them
 * smoothly, but for creases; a patch all of whose contours are creases is left as it is. Points that
 * would leave their cell stay on its boundary.
 */
void FairSurface(EdgeWeights weights, SurfaceMesh& mesh);
}

#endif
