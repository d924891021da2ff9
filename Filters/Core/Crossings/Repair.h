// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRepair_h
#define OrthoSlicesRepair_h

#include "Core/Slices/SpatialGrid.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace orthoslices
{
/// What was done to make a closed surface of contradictory contours. The numbers are part of the
/// output.
enum class RepairKind
{
  VertexRelabelled = 3, ///< a slice was overruled on whether a vertex of M is inside
  CrossingsSnipped = 4, ///< two crossings that the other slice does not have were taken out
  ArcsRedrawn = 5,      ///< arcs that touched on a face of M were drawn anew
  ArcsReconnected = 6,  ///< the same, and their ends were joined in another way
  PatchesSeparated = 7, ///< patches that crossed within a cell became shells
  ArcsUncrossed = 8,    ///< arcs that crossed on a face of M pass their vertices in another order
  ContourInserted = 9   ///< a contour that a slice lacks was interpolated; see MissingContours
};

/**
 * A repair and its place. Size, in world units: distance from the vertex to the overruled slice's
 * nearest crossing (plane spacing if there is none); distance of the two crossings; length of the
 * new arcs (twice); length of the border of the patch; by how much the arcs became shorter; length
 * of the contour.
 */
struct Repair
{
  RepairKind Kind;
  int Axis;    ///< of the slice that was changed; -1 for patches
  Index Plane; ///< of that slice; -1 for patches
  Point3
    Where; ///< the vertex, the middle of the crossings, of the new arcs or contour, or of the border
  double Size;
};

/// Takes out the repairs that are not larger than the tolerance.
inline void RemoveSmallRepairs(double tolerance, std::vector<Repair>& repairs)
{
  const auto isSmall = [&](const Repair& repair) { return repair.Size <= tolerance; };
  repairs.erase(std::remove_if(repairs.begin(), repairs.end(), isSmall), repairs.end());
}

/// Whether a repair concerns a virtual slice, and not the input.
inline bool IsOfVirtual(const SpatialGrid& grid, const Repair& repair)
{
  return repair.Axis >= 0 && grid.IsVirtual(repair.Axis, repair.Plane);
}

/// Appends the repairs that concern the input: not those of virtual slices.
inline void AppendReal(
  const std::vector<Repair>& repairs, const SpatialGrid& grid, std::vector<Repair>& all)
{
  std::copy_if(repairs.begin(), repairs.end(), std::back_inserter(all),
    [&](const Repair& repair) { return !IsOfVirtual(grid, repair); });
}

/// Appends the others.
inline void AppendVirtual(
  const std::vector<Repair>& repairs, const SpatialGrid& grid, std::vector<Repair>& all)
{
  std::copy_if(repairs.begin(), repairs.end(), std::back_inserter(all),
    [&](const Repair& repair) { return IsOfVirtual(grid, repair); });
}

/// Trust in the slices of each axis: not negative, not all zero.
using AxisWeights = std::array<double, 3>;
}

#endif
