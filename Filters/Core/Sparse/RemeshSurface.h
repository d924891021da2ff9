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
 * split, those shorter than 4/5 collapse. Topology and the course of the curves stay; contours lose
 * vertices. Points keep their place but for the middle of a collapsed edge.
 */
void CollapseShortEdges(double length, SurfaceMesh& mesh);
void SplitLongEdges(double length, SurfaceMesh& mesh);

/// Splits long edges of a mesh with slender triangles, with few new points.
void RefineEdges(double length, SurfaceMesh& mesh);

/// Flips edges until their two triangles have no opposite angles that exceed 180 degrees together
/// (an intrinsic Delaunay triangulation), curves excepted.
void FlipEdges(SurfaceMesh& mesh);
}

#endif
