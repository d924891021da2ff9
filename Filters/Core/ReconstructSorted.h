// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconstructSorted_h
#define OrthoSlicesReconstructSorted_h

#include "Core/Frames/SortByPlanes.h"
#include "Core/Reconstruct.h"

namespace orthoslices
{
/**
 * Reconstruct for slices of any frame. All points, normals and shifts of the result are those of
 * the world; planes, their bounds and the cells of M are numbered and measured along the axes of
 * the frame (Reconstruction::Frame). Problems and contours have the port and the cell that they
 * come from.
 *
 * In a frame that is no rotation, the stages see boxes where the cells are oblique, but lengths and
 * angles that the surface depends on are those of the world (Options::Metric). Distances along an
 * axis, such as the disagreement of slices, are measured at right angles to the planes of that axis
 * in any frame; other lengths of the report are those along the axes.
 *
 * Contours on planes of no family guide the surface where it bends from slice to slice
 * (Options::Guides).
 */
Reconstruction ReconstructSorted(SortedSlices&& sorted, const Options& options,
  const Execution& execution, const StageObserver& observer = {});

/// A power of 2 to whose multiples coordinates are rounded before they are mapped: 256 steps of
/// double at the largest of them, far above the rounding of the map; of results in float, 16 steps
/// of float. 0 in the frame of the world, where nothing is mapped.
double ChooseQuantum(const SortedSlices& sorted, bool singlePrecision);

/// Whether single precision has room between all slices: at least 4096 steps at the coordinates of
/// their axis, so that the 16 steps that the surface keeps from each plane are next to nothing. Far
/// from the origin it has not, and the grid would take planes for one. What is closer than
/// `tolerance`, as a share of the extent along the axis, is one plane in any case.
bool HasRoomInSinglePrecision(const SortedSlices& sorted, double tolerance);

/// What lengths and angles are along the axes of a frame: see SpatialGrid::Metric.
AxisFrame MetricOf(const AxisFrame& frame);

/// Maps the result of Reconstruct to the world, and names the sources of its contours.
void ReturnToWorld(SortedSlices&& sorted, Reconstruction& result);
}

#endif
