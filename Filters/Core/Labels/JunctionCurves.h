// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesJunctionCurves_h
#define OrthoSlicesJunctionCurves_h

#include "Core/Labels/StructurePatches.h"

#include <vector>

namespace orthoslices
{
/**
 * The curves in which the patches of a group meet within their cell: a patch that parts from others
 * twice ends there on a curve from one of these points to the other. See JunctionFit for where they
 * run. Their points get numbers in `patches`.
 */
std::vector<JunctionCurve> FindJunctionCurves(const PatchGroup& group, StructurePatches& patches);
}

#endif
