// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesKeepPart_h
#define OrthoSlicesKeepPart_h

#include "Core/Base/Ranks.h"
#include "Core/Surface/LayOutTriangles.h"

namespace orthoslices
{
/**
 * Leaves one of several processes a part of the improved triangles, which all of them have: those
 * of some patches, one behind the other, so that the parts in the order of the processes are the
 * surface, and about as many triangles for each. Returns the cycles of the part.
 * REQUIRES: triangles are improved, and no part yet.
 */
Portion KeepPart(const Ranks& ranks, Patches& patches);
}

#endif
