// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeasureComponents_h
#define OrthoSlicesMeasureComponents_h

#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"

#include <cstdint>
#include <vector>

namespace orthoslices
{
/// How large a connected component of a surface is, and where, in the units of its points.
struct ComponentMeasure
{
  double Area = 0.0;
  /// Enclosed by the component: positive if its normals point outwards, negative for the surface of
  /// a cavity. Volumes of outer surfaces and cavities therefore add up to that of the body. NaN for
  /// a component that is open.
  double Volume = 0.0;
  /// Of the solid that the component encloses; of the surface if it is open or encloses nothing.
  Point3 Centroid{ 0.0, 0.0, 0.0 };
  std::int64_t Triangles = 0;
};

/**
 * Area, volume and centroid of each of `count` components: exact for the triangles but for
 * rounding, by the divergence theorem, with an origin on each component, so that components far
 * from the origin of the world lose no digits. `triangles` are three ids each of points x, y, z,
 * and `components` has the component of each triangle; one that is not from 0 to `count` - 1 is
 * passed over. A component is closed if its edges cancel: each is passed as often forwards as
 * backwards. Only if `mayBeOpen` this is looked at.
 *
 * Of triangles that several processes have, each the next ones, the measures are those of all: the
 * sums of all processes are added in their order, which changes last digits. REQUIRES then: not
 * `mayBeOpen`.
 */
template <typename Coordinate, typename Id>
std::vector<ComponentMeasure> MeasureComponents(const Coordinate* points, const Id* triangles,
  std::int64_t triangleCount, const int* components, int count, bool mayBeOpen = true,
  const Ranks& ranks = Ranks());

#define ORTHOSLICES_DECLARE(Coordinate, Id)                        \
  extern template std::vector<ComponentMeasure> MeasureComponents( \
    const Coordinate*, const Id*, std::int64_t, const int*, int, bool, const Ranks&);
ORTHOSLICES_DECLARE(float, std::int32_t)
ORTHOSLICES_DECLARE(float, long long)
ORTHOSLICES_DECLARE(double, std::int32_t)
ORTHOSLICES_DECLARE(double, long long)
#undef ORTHOSLICES_DECLARE
}

#endif
