// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangles_h
#define OrthoSlicesTriangles_h

#include "SeparatePatches.h"

namespace orthoslices
{
/**
 * The patches of all cycles. Each quadrilateral of a polygon is a fan around the central point;
 * the patches in Shells (ascending by cycle) are no fans. Patch i has the triangles Offsets[i] to
 * Offsets[i + 1] - 1.
 *
 * Point ids: first the points of G; then one point for each cycle, which is the central point, or
 * the first point of the shell; then the other points of the shells, from ShellOffsets[s] on for
 * shell s.
 */
struct Patches
{
  std::vector<double> CentralPoints;
  std::vector<ShellPatch> Shells;
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<Index> ShellOffsets;

  std::int64_t TriangleCount() const { return this->Offsets.back(); }
};

/// Sets the offsets, and the first points of the shells among the central points.
void LayOutTriangles(const NodeGraph& graph, const Cycles& cycles, Patches& patches);

/// Writes three point ids for each triangle, counter-clockwise seen from outside.
template <typename Id>
void WriteTriangles(const Patches& patches, const NodeGraph& graph, const Crossings& crossings,
  const NodePoints& nodes, const Cycles& cycles, const Execution& execution, Id* connectivity);

extern template void WriteTriangles(const Patches&, const NodeGraph&, const Crossings&,
  const NodePoints&, const Cycles&, const Execution&, std::int32_t*);
extern template void WriteTriangles(const Patches&, const NodeGraph&, const Crossings&,
  const NodePoints&, const Cycles&, const Execution&, long long*);
}

#endif
