// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCycleJoin_h
#define OrthoSlicesCycleJoin_h

#include "Core/Cells/PatchMesh.h"

#include <vector>

namespace orthoslices
{
/// Two loops that bound one patch, by their cycles in its cell; First < Second.
struct LoopPair
{
  Index First, Second;
};

/**
 * Two cycles of one cell that may bound one patch, a tube, instead of a disc each. Whatever passes
 * from one cell to the next crosses a slice and leaves a contour on it, so all that the slices
 * leave open is which cycles of a cell belong together.
 *
 * Evidence > 0 speaks for the tube. In units of one step of the spatial grid it is
 * 2.8 - 3 D - 4 T + 2 S - 2 d, less what speaks against it: the *flatness* D is the mean cosine
 * between the surface normals at the node points and the normal of the disc (1 if a sheet of the
 * surface passes through, 0 if the cycle is a cross section of a tube; 0 for loops, which know no
 * normals); T is the mean cosine, without its sign, between the normals and the line that joins
 * the two centres (0 along a tube); S is the smaller cosine between the normals of the two discs
 * and that line, negative if both face the same way; and d is the length of the line. JoinWeights
 * says where the weights come from. Against a tube speak node points at which the slices contradict
 * each other, cycles much wider than their distance (parallel sheets), and loops side by side on
 * one face.
 *
 * With fewer than MinPlanes on an axis, contours turn all the way around between two node points,
 * whose normals then do not speak for them: D and T count as what the *headings* along the whole
 * border say, if that is more. See FindHeadings, CycleShape and SteepnessOfBorders.
 *
 * An isolated contour has to go on somewhere: the nearest patch in one of its two cells, at the
 * distance d, has an evidence of at least ContinuationEvidence - d. With slices on one axis only,
 * this is so in each of its two cells. That alone makes no handle then: a contour that is connected
 * has gone on. Nor does a join with a cycle that StitchSlabs has joined to others. Outer contours
 * and holes are not joined then: that would be a tunnel from a cavity to the outside.
 */
struct CycleJoin
{
  Index First, Second; ///< cycles, First < Second
  double Evidence = 0.0;
  double Flatness = 0.0;     ///< the product of both, if they are positive
  Index Handles = 0;         ///< handles of the stitched patch that comes with it; see StitchSlabs
  bool OnlyConnects = false; ///< not to be chosen where it would make a handle
  bool Chosen = false;
  bool Impossible = false; ///< no patch without crossings was found
};

/// What a criterion for parallel slices and the stitching of slabs say of loops, for FindJoins.
struct KnownPairs
{
  std::vector<LoopPair> Pairs;    ///< ascending; they have CertainEvidence at least
  bool Exclusive = false;         ///< no other two loops across a cell are joined
  std::vector<PatchMesh> Patches; ///< the cycles of one patch are joined; see StitchSlabs
};
}

#endif
