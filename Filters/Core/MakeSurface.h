// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMakeSurface_h
#define OrthoSlicesMakeSurface_h

#include "Core/Pass.h"

namespace orthoslices
{
/// The first part of ConnectContours: slices that agree, and the graph G. False: stopped.
bool DrawGraph(Pass& pass);

/// From contours to the cycles of all cells and how they are joined (the paper's section 4):
/// crossings, agreement of the slices, graph, patches without their inside, and the report. False:
/// stopped.
bool ConnectContours(Pass& pass);

/// Has FillCycles fill a part of the cycles alone, if several processes make the surface together
/// (Options::Processes) and it can be divided. REQUIRES: ConnectContours.
void DivideSurface(Pass& pass);

/// The inside of the patches, and all triangles (section 5). False: stopped.
bool FillCycles(const PatchOptions& patching, Pass& pass);

/// Whether the real slices are cuts of one solid: contours meet to within a small part of a
/// spacing.
/// REQUIRES: node points were found.
bool DoSlicesAgree(const Reconstruction& result);
}

#endif
