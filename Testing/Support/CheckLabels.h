// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether surfaces of several structures cross, overlap, or leave gaps between them
 */

#ifndef OrthoSlicesCheckLabels_h
#define OrthoSlicesCheckLabels_h

#include "Support/TriangleMesh.h"

#include <vector>

namespace orthoslices
{
namespace support
{

/**
 * Pairs of triangles of different labels of which one has a side that passes through the inside of
 * the other, or crosses a side of the other, each inside, in a plane across an axis: there sides lie
 * that slices are made of, and neither triangle need pierce the other one. Decided exactly. Corners
 * are common if they are at the same place. `labels` has one for each triangle.
 */
std::int64_t CountLabelCrossings(const TriangleMesh& mesh, const std::vector<int>& labels);

/// Volumes that structures have, and what is wrong between them.
struct LabelVolumes
{
  std::vector<double> OfLabel;
  double Overlap = 0.0; ///< in two of them; in three counts twice
  double Gap = 0.0;     ///< in none, between two on one line along x
};

/**
 * Measured along `lines` by `lines` lines along x through the box of the mesh. For structures that
 * together are convex, a gap is what none of them fills. Labels are 0 and up.
 */
LabelVolumes MeasureLabels(
  const TriangleMesh& mesh, const std::vector<int>& labels, int lines = 200);

} // namespace support
} // namespace orthoslices

#endif
