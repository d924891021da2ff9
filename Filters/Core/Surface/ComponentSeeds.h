// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesComponentSeeds_h
#define OrthoSlicesComponentSeeds_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"
#include "Core/Surface/MeasureComponents.h"

#include <cstdint>
#include <vector>

namespace orthoslices
{
/**
 * A point in the region that each component encloses, right beside it: of the surface of a cavity,
 * in the cavity. Mesh generators want one of each region, and of each hole. It lies on a line along
 * an axis through the middle of the component's triangle that is widest as seen along it, halfway
 * to where that line meets the surface next: so no other component lies between it and its own.
 * Arguments as for MeasureComponents, whose result gives the sign of the volumes. NaN if there is
 * nothing on that line, as in a component that is open.
 *
 * Of triangles that several processes have, each the next ones, the seeds are those of all.
 */
template <typename Coordinate, typename Id>
std::vector<Point3> FindSeeds(const Coordinate* points, const Id* triangles,
  std::int64_t triangleCount, const int* components, const std::vector<ComponentMeasure>& measures,
  const Ranks& ranks = Ranks(), const Execution& execution = Execution());

#define ORTHOSLICES_DECLARE(Coordinate, Id)                                                 \
  extern template std::vector<Point3> FindSeeds(const Coordinate*, const Id*, std::int64_t, \
    const int*, const std::vector<ComponentMeasure>&, const Ranks&, const Execution&);
ORTHOSLICES_DECLARE(float, std::int32_t)
ORTHOSLICES_DECLARE(float, long long)
ORTHOSLICES_DECLARE(double, std::int32_t)
ORTHOSLICES_DECLARE(double, long long)
#undef ORTHOSLICES_DECLARE
}

#endif
