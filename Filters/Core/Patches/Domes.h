// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDomes_h
#define OrthoSlicesDomes_h

#include "Core/Cells/PatchMesh.h"
#include "Core/Graph/TraceCycles.h"

#include <vector>

namespace orthoslices
{
/// How an object ends of which there is one family of slices, where nothing continues a contour.
enum class EndCaps
{
  Dome,     ///< in a dome, or flat beyond the last slice where the sections say so (FlattenEnds)
  Flat,     ///< flat, at its last slice (FlattenLids)
  HalfSlice ///< with walls, then flat, half a slice farther (CopyEndSlices, RaiseEnds)
};

/**
 * Lowers the domes over loops to where the surface ends, as far as that is known (our own
 * addition): where the cell on the other side of the loop has one polygon, a quadratic height
 * function is fitted to it, to the normals at its node points, and to the loop. Its height over the
 * middle of the loop is that of the dome, unless `centralPoints` has a lower one.
 */
void LowerDomes(const CycleGeometry& geometry, const CellGroups& cells,
  const std::vector<double>& nodeNormals, std::vector<double>& centralPoints);

/**
 * Flattens what lies beyond the last slices where the object ends flat, as far as slices of one
 * family tell: where the patch between the last two slices has loops on both, and those on the last
 * one enclose at least 0.98 of what those before enclose. So boxes and cylinders end at
 * their last slice, and balls and cones, whose sections shrink towards their ends, in domes as high
 * as half the spacing or as wide as their loop. `stitched` are the patches between the slices and
 * beyond them. Central points and all points of patches beyond a slice move to the least height
 * over it that a central point has.
 */
void FlattenEnds(const CycleGeometry& geometry, std::vector<PatchMesh>& stitched,
  std::vector<double>& centralPoints);

/**
 * Flattens all patches that end an object of one family of slices on one side of a slice, beyond
 * the last ones and between two: as FlattenEnds does it, whatever the sections are. What ends on
 * both sides of its only slice keeps its domes, as there would be nothing between two flat ends.
 */
void FlattenLids(const CycleGeometry& geometry, std::vector<PatchMesh>& stitched,
  std::vector<double>& centralPoints);

/**
 * Estimates, for each loop, the component along its axis of the surface's outward unit normals, as
 * if its dome was a part of a sphere; 0 for loops without a dome, or with two. A dome as high as
 * its loop is wide is a hemisphere, whose normals at the loop lie in the slice.
 */
std::vector<double> TiltOfDomes(const CycleGeometry& geometry,
  const std::vector<double>& centralPoints, const std::vector<PatchMesh>& meshes);
}

#endif
