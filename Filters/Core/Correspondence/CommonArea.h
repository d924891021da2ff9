// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCommonArea_h
#define OrthoSlicesCommonArea_h

#include "Core/Correspondence/ContourStack.h"

#include <vector>

namespace orthoslices
{
/**
 * Whether two regions have an area in common, however small: exact for all coordinates, also where
 * their boundaries coincide or touch. Each region is given by the contours that bound it; those of
 * both regions have to run in the same sense. Time grows with the number of
 * edges, those counted twice that an edge or a line across the slice meets.
 */
bool HaveCommonArea(
  const ContourStack& stack, const std::vector<Index>& one, const std::vector<Index>& other);
}

#endif
