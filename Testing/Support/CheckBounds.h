// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   independent checker of guarantee G7: nothing leaves the contours' box by much
 */

#ifndef OrthoSlicesCheckBounds_h
#define OrthoSlicesCheckBounds_h

#include "Core/Base/Contours.h"
#include "Support/TriangleMesh.h"

#include <string>

namespace orthoslices
{
namespace support
{

/**
 * How far each axis' coordinates may leave the box of the contours: half the mean distance of its
 * planes. Where it has fewer than two of them, half the least of those of the other axes, and a
 * quarter of the extent of the contours at most; where they have no extent, their greatest one
 * counts. At least 128 steps of the precision, where coordinates are far from the origin.
 */
Point3 AllowedExcess(const Contours& contours, bool singlePrecision);

/**
 * By how much the points of a mesh leave the box around all contours beyond AllowedExcess, at
 * worst, along each axis; negative where they do not.
 */
Point3 FindExcess(const TriangleMesh& mesh, const Contours& contours, bool singlePrecision);

/// A line for each axis along which the mesh leaves its bounds (G7). Empty if it does not.
std::string DescribeExcess(
  const TriangleMesh& mesh, const Contours& contours, bool singlePrecision);

} // namespace support
} // namespace orthoslices

#endif
