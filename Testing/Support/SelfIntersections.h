// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether triangles meet in common edges and vertices only, decided by CGAL
 */

#ifndef OrthoSlicesSelfIntersections_h
#define OrthoSlicesSelfIntersections_h

#include "Support/TriangleMesh.h"

namespace orthoslices
{
namespace support
{

/**
 * Pairs of triangles that meet in more than a common side or corner; -1 if the tests were built
 * without CGAL. The mesh has to be manifold: CGAL leaves out a triangle where it is not.
 */
std::int64_t CountSelfIntersections(const TriangleMesh& mesh);

} // namespace support
} // namespace orthoslices

#endif
