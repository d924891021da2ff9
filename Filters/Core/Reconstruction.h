// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconstruction_h
#define OrthoSlicesReconstruction_h

#include "Core/Base/AxisFrame.h"
#include "Core/Base/Box.h"
#include "Core/Base/Contours.h"
#include "Core/Base/Polylines.h"
#include "Core/Base/Ranks.h"
#include "Core/Cells/UndecidedPlaces.h"
#include "Core/Crossings/MeasureAgreement.h"
#include "Core/Crossings/ReconcileSlices.h"
#include "Core/Graph/CycleGeometry.h"
#include "Core/Graph/IsolatedContours.h"
#include "Core/Patches/EstimateNormals.h"
#include "Core/Surface/LayOutTriangles.h"
#include "Core/Surface/MeasureTopology.h"

#include <optional>
#include <vector>

namespace orthoslices
{
/// What the contours of Contours are, without their vertices.
struct ContourList
{
  std::vector<std::int8_t> Axis;
  std::vector<Index> Plane;
  std::vector<std::int64_t> Cell;
  std::vector<std::uint8_t> Virtual; ///< as in Contours
  /// The input port and the block of a composite input that contours come from; empty until
  /// ReconstructSorted names them.
  std::vector<std::int8_t> Port;
  std::vector<Index> Block;

  bool IsVirtual(std::size_t contour) const
  {
    return !this->Virtual.empty() && this->Virtual[contour] != 0;
  }
};

struct Reconstruction
{
  std::vector<Problem> Invalid;          ///< open, off their plane or not finite: left out
  std::vector<Problem> CrossingProblems; ///< contours that cross themselves or others
  std::vector<Problem> Mended;           ///< what was mended in the input, or left out for that
  /// With BorderContours::LeaveOpen, the surface is to be cut off where it leaves this box: see
  /// CutAtBorder. Beyond it contours are not those of the input.
  Box3 OpenBorder = Everywhere();
  bool InsideOut = false; ///< the contours as drawn bound the outside
  bool Refused = false;   ///< because of these, see Options; nothing else is set then
  std::array<Index, 3> ContourCount{ 0, 0,
    0 };                ///< usable contours of each axis, without virtual ones
  bool Stopped = false; ///< Execution::Continue returned false

  double Diagonal = 0.0; ///< of the bounding box of all contours
  AxisFrame Frame;       ///< of the axes of Grid; see ReconstructSorted
  SpatialGrid Grid;
  GridCrossings Crossings;
  NodePoints Nodes;
  NodeGraph Graph;
  IsolatedContours Isolated;
  CellCycles Cycles;
  CellGroups Cells;
  Index SharedCells = 0;        ///< cells with several cycles
  Index DoubtfulCycles = 0;     ///< of cells so narrow that their patches may touch
  std::vector<CycleJoin> Joins; ///< what the slices leave open, and what was chosen
  SurfaceTopology Topology;
  std::vector<Index> PolygonSizes; ///< see CountPolygonSizes; of the real slices alone
  UndecidedPlaces Undecided;       ///< those of the real slices alone
  /// Whether the surface was bent through contours of each of Options::Guides; empty if it is not
  /// bent. Of ReconstructSorted: of each polyline on a plane of no family.
  std::vector<std::uint8_t> Guiding;
  UndecidedPlaces Doubtful;  ///< of these, the ones to tell the user of; see FindDoubtfulJoins
  Index SmallComponents = 0; ///< left out
  SurfaceNormals Normals;    ///< of G; not for PatchMethod::Fan and Coons
  Patches Surface;
  /// How far contours may be from the surface, in mean spacings of the planes across their slices;
  /// 0 if they keep their vertices. See PatchOptions::Accuracy.
  double Accuracy = 0.0;
  /// G with all vertices of contours, if Graph has lost some of them for few triangles; else empty.
  NodeGraph Drawn;
  /// The cycles whose triangles are in Surface, where several processes have a part each; else it has
  /// those of all. Everything else is that of the whole, but for the points of improved triangles.
  std::optional<Portion> Part;

  /// The report: what the slices disagreed on, and what was done about it.
  Reconciliation Reconciled;   ///< its repairs are moved to Repairs
  std::vector<Repair> Repairs; ///< of all stages, without those of virtual slices
  SliceAgreement Agreement;
  ContourList Members;                  ///< of Agreement.OfContour
  std::vector<std::int64_t> ArcSources; ///< see FindArcSources
  /// The polylines whose numbers ArcSources and Isolated.Source are; empty until ReconstructSorted
  /// names them.
  PolylineSources Sources;
  /// NodePoints::Difference before there were virtual slices, whose planes divide edges; else
  /// empty.
  std::vector<double> RealDifferences;
};

CycleGeometry GeometryOf(const Reconstruction& result);

/// G with all vertices of contours.
inline const NodeGraph& DrawnGraph(const Reconstruction& result)
{
  return result.Drawn.Points.empty() ? result.Graph : result.Drawn;
}

/// Contours of real slices without node points, or parts of them, that take no part in the surface.
Index CountLeftOut(const Reconstruction& result);

/// Number of node points at which two real slices meet.
Index CountRealNodes(
  const SpatialGrid& grid, const GridCrossings& crossings, const NodePoints& nodes);

/// Number of node points at which two contours of real slices are farther apart than the tolerance.
Index CountDisagreements(const Reconstruction& result, double tolerance);
}

#endif
