// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesVirtualSlices_h
#define OrthoSlicesVirtualSlices_h

#include "Core/Base/Execution.h"
#include "Core/Slicing/PlaneContours.h"
#include "Core/Sparse/GuideCurves.h"
#include "Core/Sparse/VirtualPlanes.h"
#include "Core/Surface/LayOutTriangles.h"

namespace orthoslices
{
/// What virtual slices are made from: a surface through the contours of all slices or of some, the
/// planes of all of them, and the contours of those that took no part in the surface, which are
/// told whether they guide it.
struct FairSource
{
  const CycleGeometry& Geometry;
  const Patches& Surface;
  const SpatialGrid& Grid;
  GuideCurves& Guides;
  double CornerAngle; ///< of contours, radians; see DrawCreases
  /// The planes to cut on, in place of those of ChooseVirtualPlanes; null if they are to be chosen.
  const VirtualPlanes* Planes = nullptr;
  /// Whether the surface is bent; else it is cut as it is.
  bool IsBent = true;
};

/**
 * What slices on the planes between the real ones would show, if the object had the topology of the
 * surface that was reconstructed, its contours, and between them the shape that bends least:
 *
 * - MakeSurfaceMesh: the surface, with its contours as curves on it, and the ends that guides show;
 * - RemeshSurface: with triangles of about the same size;
 * - DrawCreases: with edges of the object from corner to corner of the contours;
 * - FairSurface: bent as little as the contours and cells allow;
 * - GuideSurface: through the guides; then RemeshSurface and FairSurface, twice more;
 * - SubdivideSurface: four curved triangles for each, within the bounds of the grid;
 * - SliceSurface: cut on the planes of ChooseVirtualPlanes, and near rims between slices.
 *
 * Returns these contours alone: closed, with the interior on their left, of Cell -1 and with
 * Virtual set, without vertices that lie within 0.003 of the distance of planes of the line through
 * the others; Plane is for the caller to find. They may cross each other where the smooth surface
 * crosses itself. None if no plane is to be added. `execution` is asked between the steps whether
 * to go on; if not, there are none. REQUIRES: density.IsSparse().
 *
 * Deterministic. The mesh has as many edges as EdgeLength asks for, besides what contours need to
 * keep their course; two sparse systems of equations of its size are solved, five with guides,
 * three times at most each.
 */
Contours MakeVirtualSlices(
  const FairSource& source, const SliceDensity& density, const Execution& execution);

/// Appends the contours of a virtual slice: of Cell -1, with Virtual set, their Plane to be found.
void AppendSlice(const PlaneContours& drawn, int axis, double coordinate, Contours& contours);
}

#endif
