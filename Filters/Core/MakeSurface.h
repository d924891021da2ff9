// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMakeSurface_h
#define OrthoSlicesMakeSurface_h

#include "Core/Labels/CommonCells.h"
#include "Core/Pass.h"

#include <vector>

namespace orthoslices
{
/// Where contours cross the lattice, without contradictions between the slices (section 4.2). False:
/// stopped.
bool MakeSlicesAgree(Pass& pass);

/// The first part of ConnectContours: slices that agree, and the graph G. False: stopped.
bool DrawGraph(Pass& pass);

/// The second part: cycles in each cell (section 4.3), and the patches that are not fans. False:
/// stopped.
bool ConnectGraph(Pass& pass);

/// From contours to the cycles of all cells and how they are joined (the paper's section 4):
/// crossings, agreement of the slices, graph, patches without their inside, and the report. False:
/// stopped.
bool ConnectContours(Pass& pass);

/// Has FillCycles fill a part of the cycles alone, if several processes make the surface together
/// (Options::Processes) and it can be divided. If triangles are to be few, processes improve all of
/// them together, and each keeps its part of them afterwards. REQUIRES: ConnectContours.
void DivideSurface(Pass& pass);

/// The inside of the patches, and all triangles (section 5). False: stopped.
bool FillCycles(const PatchOptions& patching, Pass& pass);

/// FillCycles for several structures that have the same planes around their cells. If triangles are
/// to be few, arcs are drawn for all of them at once (LightenStructures), with the least accuracy of
/// all, which is set. False: stopped.
bool FillTogether(
  const PatchOptions& patching, const std::vector<Pass*>& structures, double& accuracy);

/// Triangles of good shape for several structures, if they are to be few: if the accuracy that
/// FillTogether set is not 0.
void ImproveTogether(double accuracy, const PatchOptions& patching,
  const std::vector<StructureSurface>& structures, const Execution& execution);

/// Whether the real slices are cuts of one solid: contours meet to within a small part of a
/// spacing.
/// REQUIRES: node points were found.
bool DoSlicesAgree(const Reconstruction& result);
}

#endif
