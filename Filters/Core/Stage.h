// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesStage_h
#define OrthoSlicesStage_h

#include "Core/Reconstruction.h"

#include <functional>
#include <vector>

namespace orthoslices
{
/// The stages of Reconstruct in their order.
enum class Stage
{
  AssembleContours,
  OrientContours,
  SmoothContours,
  RegisterCrossings,
  ReconcileSlices,
  PairNodePoints,
  BuildNodeGraph,
  MeasureAgreement,
  ThinArcs,
  EmbedArcs,
  EmbedIsolated,
  TraceCycles,
  StitchSlabs,
  LocateCentralPoints,
  FindJoins,
  SeparatePatches,
  MeasureTopology,
  FindUndecidedPlaces,
  EstimateNormals,
  LightenArcs,
  BuildInnerPatches,
  LayOutTriangles,
  ImproveSurface
};

/// The name of the function that a stage consists of.
const char* NameOf(Stage stage);

/// Tables that one stage passes to the next ones and the result does not keep.
struct StageTables
{
  double Tolerance = 0.0;     ///< of planes, in world units
  Box3 Border = Everywhere(); ///< of the image, where contours were closed along it
  orthoslices::Contours Contours;
  std::vector<IsolatedLoop> IsolatedParts; ///< of contours: runs without node points
  EdgeRegister Edges;
  std::vector<double> NodeNormals; ///< x, y, z of each node; see ComputeNodeNormals
};

/**
 * Is called with the tables as they are after each stage; stages from EmbedArcs to
 * MeasureTopology may come several times. For measuring time, tests and invariants.
 */
using StageObserver =
  std::function<void(Stage stage, const StageTables& tables, const Reconstruction& result)>;
}

#endif
