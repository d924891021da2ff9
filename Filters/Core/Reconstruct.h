// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconstruct_h
#define OrthoSlicesReconstruct_h

#include "CentralPoint.h"
#include "NodeGraph.h"
#include "OrientContours.h"
#include "ReconcileSlices.h"
#include "SpatialGrid.h"
#include "TraceCycles.h"
#include "Triangles.h"
#include "Types.h"

namespace orthoslices
{
/**
 * Surface reconstruction from orthogonal slices after R. Svitak and V. Skala, "Robust Surface
 * Reconstruction from Orthogonal Slices" (2004). The stages, in the order in which the data flow:
 *
 *   AssembleContours    pieces of polylines -> closed contours on planes         (section 3)
 *   BuildSpatialGrid    planes of all contours -> spatial grid M                 (section 4)
 *   OrientContours      interior on the left                                     (section 3)
 *   RegisterCrossings   contours cut by the lattice, filed on the edges of M     (section 4.2)
 *   ReconcileSlices     contradictions between the slices removed                (our own)
 *   PairNodePoints      crossings on one edge -> node points                     (section 4.2)
 *   BuildNodeGraph      node points and arcs: graph G, components                (section 4.1)
 *   TraceCycles         cycles of G in each cell: spatial polygons               (section 4.3)
 *   LocateCentralPoints central point of each polygon                            (section 5)
 *   Quadrilaterals      one for each node point of a polygon                     (section 5)
 *   Triangles           fans in the quadrilaterals                               (section 5)
 *
 * Guarantees, for every input that is not refused:
 *   G1  Closed: every edge of the surface has exactly two triangles.
 *   G2  2-manifold: the triangles around every vertex form one disc.
 *   G3  Oriented: the two triangles at an edge run through it in opposite directions, and outside
 *       is where the contours have it (on their right, seen from the positive end of the axis).
 *   G4  Contours are kept: every vertex of every contour that has a node point is a vertex of the
 *       surface, on its plane; one that lies on a grid edge may move along it by half the
 *       disagreement of the two slices there. Excepted are parts without a node point: isolated
 *       contours, which are listed, and what ReconcileSlices cuts off where slices contradict each
 *       other, which is listed if it has three vertices or more.
 *   G5  Deterministic: the result does not depend on the number of threads, and slices that agree
 *       are not changed by ReconcileSlices.
 *
 * Why G1 to G3 hold: after ReconcileSlices the two slices at an edge of M have the same crossings
 * with the same signs. A node point therefore has one arc in each of the four faces around its
 * edge, and each of the four cells there has two of them, one incoming and one outgoing in the
 * direction of its cycle. So "the next arc in the same cell" is a permutation of all half-arcs; its
 * orbits are closed cycles, every arc is passed once forward (above its slice) and once backward
 * (below), and no cycle passes a node or an arc twice. The fan of a cycle of three or more points
 * is a disc; two discs share arcs only, and around a node four discs close up in a ring.
 * NodeGraph.h tells why no two arcs are the same edge.
 */
struct Options
{
  double PlaneTolerance = 1e-5; ///< as a fraction of the diagonal of all contours
  Orientation Orient = Orientation::ByNesting;
  bool RefuseProblems = true; ///< no surface if there is any Problem
  CentralPointMethod Central = CentralPointMethod::LeastSquares;
};

/// Closed polylines on slices, as they are: contours that take no part in the surface.
struct IsolatedContours
{
  std::vector<double> Points;
  std::vector<Index> Offsets{ 0 };
  std::vector<std::int8_t> Axis;
  std::vector<Index> Plane;

  Index Count() const { return static_cast<Index>(this->Axis.size()); }
};

struct Reconstruction
{
  /// Unusable contours; with Options::RefuseProblems nothing else is set if there are any.
  std::vector<Problem> Problems;
  std::array<Index, 3> ContourCount{ 0, 0, 0 }; ///< usable contours of each axis
  bool Stopped = false;                         ///< Execution::Continue returned false

  SpatialGrid Grid;
  Crossings Lattice;
  NodePoints Nodes;
  NodeGraph Graph;
  IsolatedContours Isolated;
  Cycles Polygons;
  std::vector<double> CentralPoints;
  TriangleLayout Triangles;
  Reconciliation Reconciled;
};

/// Runs all stages up to the layout of the triangles; WriteTriangles gives the triangles
/// themselves.
Reconstruction Reconstruct(
  std::array<Pieces, 3>&& pieces, const Options& options, const Execution& execution);
}

#endif
