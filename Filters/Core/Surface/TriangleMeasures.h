// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTriangleMeasures_h
#define OrthoSlicesTriangleMeasures_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/// How well the triangles of a surface are shaped.
struct TriangleQuality
{
  double SmallestAngle = 0.0;       ///< of all triangles, in degrees
  double ShareAbove20Degrees = 0.0; ///< of the triangles, those with no smaller angle
  double LargestAspectRatio =
    0.0; ///< longest side by height over it: 1.15 at best, infinite for no area
};

/// Measures the shapes of triangles, which are three ids each of points x, y, z.
template <typename Coordinate, typename Id>
TriangleQuality MeasureQuality(
  const Coordinate* points, const Id* triangles, std::int64_t count, const Execution& execution);

/// How well the triangles of all processes are shaped, each of which has measured `count` of its own.
TriangleQuality JoinQualities(const TriangleQuality& own, std::int64_t count, const Ranks& ranks);

/// Curvatures at points; positive mean curvature where the surface is convex.
struct Curvatures
{
  std::vector<float> Mean, Gaussian;
};

/**
 * Measures curvatures from how the normals change along the sides of triangles (S. Rusinkiewicz,
 * "Estimating Curvatures and Their Derivatives on Triangle Meshes", 2004): in each triangle the
 * best fitting second fundamental form, and at a point the mean over its triangles, weighted by
 * their areas. `normals` are unit vectors, x, y, z of each point.
 */
template <typename Coordinate, typename Id>
Curvatures MeasureCurvatures(const Coordinate* points, std::size_t pointCount, const float* normals,
  const Id* triangles, std::int64_t count);

#define ORTHOSLICES_DECLARE(Coordinate, Id)                        \
  extern template TriangleQuality MeasureQuality(                  \
    const Coordinate*, const Id*, std::int64_t, const Execution&); \
  extern template Curvatures MeasureCurvatures(                    \
    const Coordinate*, std::size_t, const float*, const Id*, std::int64_t);
ORTHOSLICES_DECLARE(float, std::int32_t)
ORTHOSLICES_DECLARE(float, long long)
ORTHOSLICES_DECLARE(double, std::int32_t)
ORTHOSLICES_DECLARE(double, long long)
#undef ORTHOSLICES_DECLARE
}

#endif
