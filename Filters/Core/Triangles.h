// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangles_h
#define OrthoSlicesTriangles_h

#include "TraceCycles.h"

namespace orthoslices
{
/**
 * The triangles of all patches: each quadrilateral is a fan around the central point. The patch of
 * cycle i has the triangles Offsets[i] to Offsets[i + 1] - 1, one for each segment of its border.
 */
struct TriangleLayout
{
  std::vector<std::int64_t> Offsets;

  std::int64_t Count() const { return this->Offsets.back(); }
};

TriangleLayout LayOutTriangles(const NodeGraph& graph, const Cycles& cycles);

/**
 * Writes three point ids for each triangle, counter-clockwise seen from outside. Ids are those of
 * the points of G; the central point of cycle i has the id graph.Count() + i.
 */
template <typename Id>
void WriteTriangles(const TriangleLayout& layout, const NodeGraph& graph,
  const Crossings& crossings, const NodePoints& nodes, const Cycles& cycles,
  const Execution& execution, Id* connectivity);

extern template void WriteTriangles(const TriangleLayout&, const NodeGraph&, const Crossings&,
  const NodePoints&, const Cycles&, const Execution&, std::int32_t*);
extern template void WriteTriangles(const TriangleLayout&, const NodeGraph&, const Crossings&,
  const NodePoints&, const Cycles&, const Execution&, long long*);
}

#endif
