// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSecondPass_h
#define OrthoSlicesSecondPass_h

#include "Core/Pass.h"

#include <vector>

/**
 * What surfaces of two passes have in common: a sketch of the first one, and a pass over the slices
 * and virtual ones that is to come out with its topology.
 */
namespace orthoslices
{
/// Progress where slices are few, when these are done: reading, the cells of the first surface,
/// leaving slices out, the sketch of the first surface, the surface of a stack alone, what is bent
/// and cut. The rest is the surface of real and virtual slices.
constexpr double ProgressOfSlices = 0.04;
constexpr double ProgressOfCells = 0.15;
constexpr double ProgressOfPredictions = 0.3;
constexpr double ProgressOfSketch = 0.45;
constexpr double ProgressOfStack = 0.5;
constexpr double ProgressOfBending = 0.62;

/// A surface that shows the topology and is going to be bent: with no more triangles than that
/// needs. `edgeLength` is in world units. False: stopped.
bool Sketch(double edgeLength, Pass& pass);

/// What a second surface has to come out as. Components that were too small are drawn nevertheless,
/// and must not be joined to others instead.
PriorKnowledge TopologyOf(const Reconstruction& base);

/// A pass over the contours as they were drawn, without what the first surface leaves out, and over
/// virtual ones. `leftOut` gets the contours that take no part.
Pass SecondPass(const Pass& first, const Contours& drawn, const Contours& added,
  const PriorKnowledge& known, std::vector<Index>& leftOut);
}

#endif
