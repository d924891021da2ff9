// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPiecePlanes_h
#define OrthoSlicesPiecePlanes_h

#include "Core/Base/Contours.h"

#include <vector>

namespace orthoslices
{
/// How far a piece was moved onto its plane.
struct PlaneShift
{
  Index Vertex = -1;     ///< the one that was farthest off; -1 if none was
  double Distance = 0.0; ///< in world units
  double From = 0.0;     ///< its coordinate before
};

/**
 * Moves vertices that lie a little off their plane onto it: files are rounded, frames are turned,
 * and points are drawn by hand. Returns the shift of each piece; nothing if all pieces are planar
 * to within `tolerance`, or if none is but for more than little noise, and then nothing is moved.
 *
 *  - A piece lies on the plane of the median of its vertices; how far the others are off is its
 *    noise. Pieces whose planes are nearer to each other than a few times that are of one slice;
 *    pieces without noise are not, however near they are.
 *  - Little is a tenth of the least distance between slices, which makes it certain which slice is
 *    meant; with a single slice it is `alone`. Noise beyond that says nothing about other pieces,
 *    and a piece with a vertex that is farther off stays as it is.
 */
std::vector<PlaneShift> MoveOntoPlanes(double tolerance, double alone, Pieces& pieces);
}

#endif
