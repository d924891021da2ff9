// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRemeshSurface_h
#define OrthoSlicesRemeshSurface_h

#include "Core/Sparse/SurfaceMesh.h"

namespace orthoslices
{
/**
 * Gives all edges about the same length, by the local operations of M. Botsch and L. Kobbelt, "A
 * Remeshing Approach to Multiresolution Modeling", 2004: edges longer than 4/3 of `length` are
 * split in the middle, those shorter than 4/5 collapse, where that makes no edge longer than 4/3
 * and than those that were there. The shortest collapse first. Lengths are in world units, after
 * the stretch of SurfaceMesh.
 *
 * Topology and the curves stay. Fixed points keep their place, and only those of them are left out
 * that are within a tenth of the length of collapsing edges of the line between their neighbors on
 * the contour; all others keep theirs but for the ends of a collapsed edge, which meet in its
 * middle. New points on curves are fixed; they are on creases where both ends are.
 */
void CollapseShortEdges(double length, SurfaceMesh& mesh);
void SplitLongEdges(double length, SurfaceMesh& mesh);

/// Splits long edges of a mesh with slender triangles, with few new points: first those longer than
/// eight times `length`, then four times and so on, with FlipEdges in between.
void RefineEdges(double length, SurfaceMesh& mesh);

/// Flips edges until their two triangles have no opposite angles that exceed 180 degrees together
/// (as in a Delaunay triangulation), curves excepted; ten passes at most.
void FlipEdges(SurfaceMesh& mesh);
}

#endif
