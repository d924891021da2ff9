// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a surface as the checkers take it: points and triangles of point ids
 */

#ifndef OrthoSlicesTriangleMesh_h
#define OrthoSlicesTriangleMesh_h

#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
namespace support
{

struct TriangleMesh
{
  std::vector<Point3> Points;
  /// Ids of the corners, counter-clockwise seen from outside.
  std::vector<std::array<std::int64_t, 3>> Triangles;
};

} // namespace support
} // namespace orthoslices

#endif
