// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   topology of an implicit solid, where it is beyond doubt
 */

#ifndef OrthoSlicesCountTopology_h
#define OrthoSlicesCountTopology_h

#include "Support/AnalyticSolids.h"

#include <optional>

namespace orthoslices
{
namespace support
{

/**
 * Counted on a fine iso-surface. Nothing if the solid has another topology once it is larger or
 * smaller by `clearance` all around: then it has thin parts or narrow gaps, and nobody can tell
 * what is right for coarse slices.
 */
std::optional<CountedTopology> CountTopology(const Solid& solid, double clearance);

} // namespace support
} // namespace orthoslices

#endif
