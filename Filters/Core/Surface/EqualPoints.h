// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEqualPoints_h
#define OrthoSlicesEqualPoints_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"

#include <cstdint>

namespace orthoslices
{
/**
 * How many of `count` points x, y, z would be at the place of another one of them if all were
 * rounded to float, as many file formats store them; of points that share a place one does not
 * count.
 *
 * Of points of which several processes have some each, the number is that of all. There
 * `isDuplicate`, if it is not null, says of each point whether another process has the same point
 * and counts it.
 */
template <typename Coordinate>
std::int64_t CountEqualInFloat(const Coordinate* points, std::int64_t count,
  const Execution& execution = Execution(), const Ranks& ranks = Ranks(),
  const std::uint8_t* isDuplicate = nullptr);

extern template std::int64_t CountEqualInFloat(
  const float*, std::int64_t, const Execution&, const Ranks&, const std::uint8_t*);
extern template std::int64_t CountEqualInFloat(
  const double*, std::int64_t, const Execution&, const Ranks&, const std::uint8_t*);
}

#endif
