// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOptions_h
#define OrthoSlicesOptions_h

#include "Core/Base/AxisFrame.h"
#include "Core/Base/Ranks.h"
#include "Core/Cells/ChooseJoins.h"
#include "Core/Correspondence/FindCorrespondences.h"
#include "Core/Crossings/ReconcileSlices.h"
#include "Core/Loops/LoopRule.h"
#include "Core/Patches/CentralPoints.h"
#include "Core/Patches/Domes.h"
#include "Core/Patches/InnerPatches.h"
#include "Core/Pieces/ImageBorder.h"
#include "Core/Slices/OrientContours.h"
#include "Core/Sparse/GuideCurves.h"

#include <cmath>
#include <set>

namespace orthoslices
{
/// What happens to contours that cross themselves or another one of their slice.
enum class CrossingContours
{
  Repair,  ///< LoopRule says what they bound
  Refuse,  ///< no surface if there are any
  LeaveOut ///< removed
};

/// What happens to contours that are open, off their plane, without area or not finite.
enum class InvalidContours
{
  Refuse,   ///< no surface if there are any
  LeaveOut, ///< removed
  Mend      ///< see AssembleContours; removed if that cannot be; no surface if nothing is left
};

/// Where slices are too few, virtual ones are cut from the surface that bends least between them;
/// see Sparse/VirtualSlices.h.
enum class VirtualSlices
{
  Automatic, ///< where they are needed, as SliceDensity says
  Off,
  BySpacing ///< wherever slices are farther apart than 1.4 times VirtualSpacing
};

struct Options
{
  double PlaneTolerance = 1e-5; ///< as a fraction of the diagonal of all contours
  Orientation Orient = Orientation::ByNesting;
  InvalidContours Invalid = InvalidContours::Mend;
  BorderContours AtBorder = BorderContours::CloseAlong; ///< with InvalidContours::Mend
  Box3
    GivenBorder; ///< of the image, along the axes; of an axis along which it is empty, it is found
  CrossingContours Crossing = CrossingContours::Repair;
  LoopRule Loops = LoopRule::Union; ///< with Repair
  double RedrawnShare = 0.05;       ///< of the thickness of contours; see RemoveRedrawn
  bool SinglePrecision = false;     ///< the result will be stored as float
  double Quantum = 0.0;      ///< see SpatialGrid; 0: coordinates are not rounded on its account
  AxisFrame Metric;          ///< see SpatialGrid
  bool FollowField = true;     ///< through a few slices; see MakeSparseSurface
  bool InsertMissing = true; ///< contours that slices lack; see FindMissingContours
  AxisWeights Weights{ 1.0, 1.0, 1.0 };
  CentralPointMethod Central = CentralPointMethod::LeastSquares;
  SeveralCycles Several = SeveralCycles::ByEvidence;
  CorrespondenceCriterion Criterion =
    CorrespondenceCriterion::ByEvidence; ///< with SeveralCycles::ByEvidence
  PriorKnowledge Known;
  PatchOptions Patching;
  /// Vertices at which contours of several structures part, so that they stay; see ArcSource.
  const std::set<Point3>* Junctions = nullptr;
  EndCaps Ends = EndCaps::Dome;  ///< of one family of slices; others show their ends themselves
  double Smoothing = 0.0;        ///< of contours, in mean plane spacings; see SmoothContours
  double ContourTolerance = 0.0; ///< in mean plane spacings; see ThinArcs
  double LongestSide = HUGE_VAL; ///< with ContourTolerance, in mean plane spacings
  VirtualSlices Virtual = VirtualSlices::Off;
  double VirtualSpacing = 0.0; ///< with BySpacing, in world units; 0: as with Automatic
  /// Contours on planes of no family, which guide the surface where virtual slices are made; or
  /// null.
  const std::vector<GuideContours>* Guides = nullptr;
  /// Smaller ones are left out, by the diagonal of their bounding box as a fraction of that of all
  /// contours.
  double MinIsolatedContour = 0.0;
  double MinComponent = 0.0;
  /// Processes that make the surface together, or null: this one alone. All of them have the same
  /// contours. Each fills a part of the cycles, if the surface can be divided (Reconstruction::Part).
  const Ranks* Processes = nullptr;
};
}

#endif
