// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRealSlices_h
#define OrthoSlicesRealSlices_h

#include "Core/Reconstruction.h"

#include <vector>

/**
 * What a surface from real and virtual slices keeps of the one from real slices alone: whatever the
 * report says of the input, and which contours take no part.
 */
namespace orthoslices
{
/// The isolated contours that are whole ones and take no part in the surface. `parts` is what
/// `isolated` was copied from.
std::vector<Index> FindLeftOut(
  const IsolatedContours& isolated, const std::vector<IsolatedLoop>& parts);

/// Takes contours that are left out away from the contours as they were drawn, but never all of a
/// plane: virtual slices would give them node points. `leftOut` are places in `parts`.
void RemoveContours(
  const std::vector<Index>& leftOut, const std::vector<IsolatedLoop>& parts, Contours& contours);

/// What TakeReport takes of a first surface, taken out of it.
Reconstruction ReportOf(Reconstruction& first);

/// Gives `result`, whose grid has virtual planes besides those of the first one, the report of the
/// first one, and lists the contours that were left out there. What that says of planes that the
/// grid of `result` has not is left out: planes on which nothing is left once labels agree.
void TakeReport(
  const Reconstruction& first, const std::vector<Index>& leftOut, Reconstruction& result);

/// Takes out the contours on planes that a grid has.
void RemoveOnPlanes(const SpatialGrid& known, Contours& contours);

/// The contours of virtual slices as they are in the graph G, but for planes that `known` has.
Contours ReadVirtual(const Reconstruction& result, const SpatialGrid& known);

/// The contours of all slices as they are in the graph G, without those that are left out there;
/// of the cell -1, Plane to be found.
Contours ReadAll(const Reconstruction& result);
}

#endif
