// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stage.h"

namespace orthoslices
{
const char* NameOf(Stage stage)
{
  switch (stage)
  {
    case Stage::AssembleContours:
      return "AssembleContours";
    case Stage::OrientContours:
      return "OrientContours";
    case Stage::SmoothContours:
      return "SmoothContours";
    case Stage::RegisterCrossings:
      return "RegisterCrossings";
    case Stage::ReconcileSlices:
      return "ReconcileSlices";
    case Stage::PairNodePoints:
      return "PairNodePoints";
    case Stage::BuildNodeGraph:
      return "BuildNodeGraph";
    case Stage::MeasureAgreement:
      return "MeasureAgreement";
    case Stage::ThinArcs:
      return "ThinArcs";
    case Stage::EmbedArcs:
      return "EmbedArcs";
    case Stage::EmbedIsolated:
      return "EmbedIsolated";
    case Stage::TraceCycles:
      return "TraceCycles";
    case Stage::StitchSlabs:
      return "StitchSlabs";
    case Stage::LocateCentralPoints:
      return "LocateCentralPoints";
    case Stage::FindJoins:
      return "FindJoins";
    case Stage::SeparatePatches:
      return "SeparatePatches";
    case Stage::MeasureTopology:
      return "MeasureTopology";
    case Stage::FindUndecidedPlaces:
      return "FindUndecidedPlaces";
    case Stage::EstimateNormals:
      return "EstimateNormals";
    case Stage::LightenArcs:
      return "LightenArcs";
    case Stage::BuildInnerPatches:
      return "BuildInnerPatches";
    case Stage::LayOutTriangles:
      return "LayOutTriangles";
    case Stage::ImproveSurface:
      return "ImproveSurface";
  }
  return "";
}
}
