// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesInsertedContours_h
#define OrthoSlicesInsertedContours_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"

#include <vector>

namespace orthoslices
{
/**
 * Contours that were inserted where slices of a structure lack them (MissingContours), but where
 * other structures are drawn: something else was there. Marks them, for each structure. Contours of
 * structures that are drawn within each other elsewhere may be within each other. All of a slice
 * are marked if one is contradicted. `thickness` is that of slivers, as in ShareBorders.
 */
std::vector<std::vector<std::uint8_t>> FindContradictedInsertions(
  double thickness, const std::vector<const Contours*>& structures, const Execution& execution);
}

#endif
