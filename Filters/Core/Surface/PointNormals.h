// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPointNormals_h
#define OrthoSlicesPointNormals_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// The points of a part of a surface of which other processes have the others.
struct SharedPoints
{
  const Ranks& Processes;
  std::vector<std::int64_t> Ids;      ///< of all points of the part in the whole surface, ascending
  std::vector<std::uint8_t> IsShared; ///< whether other parts have the point, too
  bool AnySmooth;                     ///< whether there are smooth normals, here or elsewhere
};

/**
 * Unit normals of points from the triangles around them, weighted by area, or those of a smooth
 * surface. Triangles are three ids each of points x, y, z; `smooth` has x, y, z for each point,
 * zero where there is none, or is empty. A smooth normal is taken if it is within 30 degrees of the
 * area vector of the triangles around the point, or of that of the next triangles around these,
 * which decide where the first are slivers. `normals`, x, y, z of each point, is written; zero at
 * points without area around them. Points are divided into `parts` ranges, each of which one thread
 * sums up: as many as there are threads, say. The result does not depend on it.
 *
 * Of a part of a surface (`shared` is not null), normals are those of the whole surface: the parts
 * hand each other what they have at common points. Parts have to be in the order of their triangles.
 */
template <typename Coordinate, typename Id>
void ComputePointNormals(const Coordinate* xyz, std::size_t points, const Id* triangles,
  std::int64_t count, const std::vector<float>& smooth, const Execution& execution, float* normals,
  std::size_t parts = 1, const SharedPoints* shared = nullptr);

#define ORTHOSLICES_DECLARE(Coordinate, Id)                                           \
  extern template void ComputePointNormals(const Coordinate*, std::size_t, const Id*, \
    std::int64_t, const std::vector<float>&, const Execution&, float*, std::size_t,   \
    const SharedPoints*);
ORTHOSLICES_DECLARE(float, std::int32_t)
ORTHOSLICES_DECLARE(float, long long)
ORTHOSLICES_DECLARE(double, std::int32_t)
ORTHOSLICES_DECLARE(double, long long)
#undef ORTHOSLICES_DECLARE
}

#endif
