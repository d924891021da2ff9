// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how nearly triangles with a common side lie on each other
 */

#ifndef OrthoSlicesSharpestFold_h
#define OrthoSlicesSharpestFold_h

#include "Support/TriangleMesh.h"

namespace orthoslices
{
namespace support
{

/// The least angle between two triangles at a common side, inside or outside, in degrees: 180 if all
/// are in one plane, 0 if two lie on each other. REQUIRES: each side has two triangles.
double SharpestFold(const TriangleMesh& mesh);

} // namespace support
} // namespace orthoslices

#endif
