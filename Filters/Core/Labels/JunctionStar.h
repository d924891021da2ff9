// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesJunctionStar_h
#define OrthoSlicesJunctionStar_h

#include "Core/Labels/StructurePatches.h"

namespace orthoslices
{
/**
 * The point at which the curves meet, in a cell, in which surfaces of structures meet, and these
 * curves, from each point at which borders of a group of patches part. They are on the smoothest of
 * the surfaces that go through at least three of these points: on that around some of the
 * structures together, to whose border a quadratic fits best. It is the middle of the points on
 * that border, moved onto it. False if no quadratic fits.
 */
bool FindJunctionStar(const PatchGroup& group, StructurePatches& patches, JunctionStar& star);
}

#endif
