// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconstruct_h
#define OrthoSlicesReconstruct_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Cells/ChooseJoins.h"
#include "Core/Cells/UndecidedPlaces.h"
#include "Core/Correspondence/FindCorrespondences.h"
#include "Core/Crossings/MeasureAgreement.h"
#include "Core/Crossings/ReconcileSlices.h"
#include "Core/Graph/EmbedArcs.h"
#include "Core/Graph/IsolatedContours.h"
#include "Core/Graph/NodeGraph.h"
#include "Core/Graph/TraceCycles.h"
#include "Core/Patches/CentralPoints.h"
#include "Core/Slices/OrientContours.h"
#include "Core/Slices/SpatialGrid.h"
#include "Core/Surface/LayOutTriangles.h"

#include <vector>

namespace orthoslices
{
/// What happens to contours that cross themselves or another one of their slice.
enum class CrossingContours
{
  Repair,  ///< kept; EmbedArcs takes their arcs apart where they cross
  Refuse,  ///< no surface if there are any
  LeaveOut ///< removed
};

struct Options
{
  double PlaneTolerance = 1e-5; ///< as a fraction of the diagonal of all contours
  Orientation Orient = Orientation::ByNesting;
  bool RefuseInvalid = true; ///< no surface if a contour is open, off its plane or not finite
  CrossingContours Crossing = CrossingContours::Repair;
  bool SinglePrecision = false; ///< the result will be stored as float
  AxisWeights Weights{ 1.0, 1.0, 1.0 };
  CentralPointMethod Central = CentralPointMethod::LeastSquares;
  SeveralCycles Several = SeveralCycles::ByEvidence;
  CorrespondenceCriterion Criterion =
    CorrespondenceCriterion::ByEvidence; ///< with SeveralCycles::ByEvidence
  PriorKnowledge Known;
  PatchOptions Patching;
  double Smoothing = 0.0;        ///< of contours, in mean plane spacings; see SmoothContours
  double ContourTolerance = 0.0; ///< in mean plane spacings; see ThinArcs
  /// Smaller ones are left out, by the diagonal of their bounding box as a fraction of that of all
  /// contours.
  double MinIsolatedContour = 0.0;
  double MinComponent = 0.0;
};

/// What the contours of Contours are, without their vertices.
struct ContourList
{
  std::vector<std::int8_t> Axis;
  std::vector<Index> Plane;
  std::vector<std::int64_t> Cell;
};

struct Reconstruction
{
  std::vector<Problem> Invalid;  ///< open, off their plane or not finite: left out
  std::vector<Problem> Crossing; ///< contours that cross themselves or others
  bool InsideOut = false;        ///< the contours as drawn bound the outside
  bool Refused = false;          ///< because of these, see Options; nothing else is set then
  std::array<Index, 3> ContourCount{ 0, 0, 0 }; ///< usable contours of each axis
  bool Stopped = false;                         ///< Execution::Continue returned false

  double Diagonal = 0.0; ///< of the bounding box of all contours
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
  UndecidedPlaces Undecided;
  Index SmallComponents = 0; ///< left out
  SurfaceNormals Normals;    ///< of G; not for PatchMethod::Fan and Coons
  Patches Surface;

  /// The report: what the slices disagreed on, and what was done about it.
  Reconciliation Reconciled;   ///< its repairs are moved to Repairs
  std::vector<Repair> Repairs; ///< of all stages
  SliceAgreement Agreement;
  ContourList Members; ///< of Agreement.OfContour
};

CycleGeometry GeometryOf(const Reconstruction& result);

/// Number of node points at which the two contours are farther apart than the tolerance.
Index CountDisagreements(const Reconstruction& result, double tolerance);

/**
 * Surface reconstruction from orthogonal slices after R. Svitak and V. Skala, "Robust Surface
 * Reconstruction from Orthogonal Slices" (2004). The stages, in the order in which the data flow:
 *
 *   AssembleContours    pieces of polylines -> closed contours on planes         (section 3)
 *   BuildSpatialGrid    planes of all contours -> spatial grid M                 (section 4)
 *   OrientContours      interior on the left                                     (section 3)
 *   SmoothContours      noise taken out of contours, if asked for                (our own)
 *   RegisterCrossings   contours cut by the lattice, filed on the edges of M     (section 4.2)
 *   ReconcileSlices     contradictions between the slices removed                (our own)
 *   PairNodePoints      crossings on one edge -> node points                     (section 4.2)
 *   BuildNodeGraph      node points and arcs: graph G, components                (section 4.1)
 *   ThinArcs            vertices of arcs left out, if asked for                  (our own)
 *   MeasureAgreement    disagreement of contours and slices: the report          (our own)
 *   EmbedArcs           arcs that cross on a face of M are taken apart            (our own)
 *   EmbedIsolated       contours without node points become loops of G           (our own)
 *   TraceCycles         cycles of G in each cell: spatial polygons               (section 4.3)
 *   StitchSlabs         one family only: contours of slices joined by overlay    (our own)
 *   LocateCentralPoints central point of each polygon                            (section 5)
 *   LowerDomes          domes over loops end where the surface beside them says  (our own)
 *   FindJoins, ChooseJoins  cycles of a cell that bound one patch                (our own)
 *   SeparatePatches     discs, tubes and branchings that do not cross            (our own)
 *   FindUndecidedPlaces what the slices leave open, and where to slice next      (our own)
 *   EstimateNormals     normals of the surface along all contours                (our own)
 *   BuildInnerPatches   smooth patches, or the paper's                           (section 5)
 *   WriteTriangles      all patches as triangles                                 (section 5)
 *
 * Guarantees, for every input that is not refused:
 *   G1  Closed: every edge of the surface has exactly two triangles.
 *   G2  2-manifold: the triangles around every vertex form one disc.
 *   G3  Oriented: the two triangles at an edge run through it in opposite directions, and outside
 *       is where the contours have it (on their right, seen from the positive end of the axis).
 *   G4  Contours are kept: where the slices agree, every vertex of every contour with a node point
 *       is a vertex of the surface, on its plane (where contours cross, in another order and
 *       without those that lie on another part of a contour); one that lies on a
 *       grid line, or within the Margin of the grid of one, may move by that margin, and one on a
 *       grid edge along it by half the disagreement of the two slices there. Where slices
 *       contradict each other by more than the tolerance, vertices move with the node points
 *       beside them, within their planes. Isolated contours are kept, too, unless they touch
 *       others of their face, are so thin that rounding leaves no room beside them, or are left out
 *       by their size; where contours of neighbouring slices cross in projection (one family only),
 *       they get additional vertices. What ReconcileSlices cuts off takes no part in the surface; it
 *       is listed if it has three vertices or more. The contours are those that SmoothContours and
 *       ThinArcs leave, if these are asked for.
 *   G5  Deterministic: the result does not depend on the number of threads, and slices that agree
 *       are not changed by ReconcileSlices.
 *   G6  Embedded: no two triangles meet but in their common edge or vertex.
 *
 * Why G1 to G3 hold: after ReconcileSlices the two slices at an edge of M have the same crossings
 * with the same signs. A node point therefore has one arc in each of the four faces around its
 * edge, and each of the four cells there has two of them, one incoming and one outgoing in the
 * direction of its cycle. So "the next arc in the same cell" is a permutation of all half-arcs;
 * its orbits are closed cycles, every arc is passed once forward (above its slice) and once
 * backward (below), and no cycle passes a node or an arc twice. The fan of a cycle of three or
 * more points is a disc; two discs share arcs only, and around a node four discs close up in a
 * ring. A loop is a cycle in the cell above its slice and in the cell below. A patch of several
 * cycles has each of their arcs once, too.
 *
 * Why G6 holds: PairNodePoints keeps nodes apart and off the ends of their edges, EmbedArcs keeps
 * arcs apart and off the border of their faces, and patches touch the boundary of their cell in
 * their cycle only. So patches of different cells meet in shared arcs only. A cell is convex: the
 * fan of a cycle around a point strictly inside cannot touch itself. Several patches of one cell
 * are kept apart by SeparatePatches, which undoes joins that it cannot make without crossings.
 * A patch with points inside (BuildInnerPatches) is seen from one point, or along one direction, and
 * taken only if its cycle is seen as a simple polygon and all of its triangles from the same side:
 * then they do not overlap as seen from there, so they meet nowhere else. Its points are strictly
 * inside the cell, and no side of a triangle but those of the cycle runs in a face. Where it touches
 * another patch of its cell, the fan takes its place.
 * Where arcs lie so close together that rounding could spoil that, they are drawn anew, farther
 * apart. A slab that is a few dozen steps of the precision wide may leave no room for that:
 * DoubtfulCycles counts the patches concerned.
 *
 * Sampling condition: the surface has the topology of the object's surface S where the contours are
 * its exact cuts and the diagonal D of each cell of M that S meets is at most the reach r of S (its
 * least distance from its medial axis). Compare O. Amini, J.-D. Boissonnat and P. Memari,
 * "Geometric Tomography with Topological Guarantees", Discrete & Computational Geometry 50 (2013),
 * whose condition bounds the height of the cells of arbitrary planes by the reach, too. Why:
 *   - No component of S fits between the planes, as it would have a diameter of 2 r or more. So
 *     every part of S in a cell ends in cycles, which are known: slices that agree leave nothing
 *     to be guessed on the faces of M.
 *   - If all parts are discs, so are ours, with the same cycles as borders. Discs in a ball that do
 *     not meet are isotopic if their borders are the same; then the whole is isotopic to S. This
 *     needs no reach, and holds for SeveralCycles::Discs however coarse the slices are.
 *   - Two normals of S at a distance of D <= r differ by 60 degrees at most, sin(angle / 2) being
 *     at most D / (2 r). So a part of S in a cell is a graph over any of its tangent planes: no
 *     tube, whose normals point all around, but a disc, perhaps with holes. A hole is where S
 *     leaves the convex cell and comes back: around a point whose normal is parallel to an axis.
 *   - Evidence tells the two apart. The border of a disc lies around it as the normals say
 *     (flatness near 1, so nothing speaks for a tube), that of a hole the other way around
 *     (flatness near -1), and an isolated contour continues to the patch that is nearest.
 * The last step is an argument for D much smaller than r only. Tests find no exception among
 * random solids of known reach at D = r, nor at D = 2 r.
 */
Reconstruction Reconstruct(
  std::array<Pieces, 3>&& pieces, const Options& options, const Execution& execution);
}

#endif
