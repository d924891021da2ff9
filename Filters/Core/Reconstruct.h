// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReconstruct_h
#define OrthoSlicesReconstruct_h

#include "Core/Base/Execution.h"
#include "Core/Options.h"
#include "Core/Reconstruction.h"
#include "Core/Stage.h"

#include <array>

namespace orthoslices
{
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
 *   MeasureAgreement    disagreement of contours and slices: the report          (our own)
 *   ThinArcs            vertices of arcs left out, if asked for                  (our own)
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
 *   LightenArcs         arcs with few vertices, if asked for                     (our own)
 *   BuildInnerPatches   smooth patches, or the paper's                           (section 5)
 *   LayOutTriangles     all patches as triangles                                 (section 5)
 *   ImproveSurface      triangles of good shape, if asked for                    (our own)
 *
 * One family of slices can be asked to end half a slice farther (EndCaps): then the stack has
 * copies of its first and last contours from AddEndSlices on, before RegisterCrossings, on virtual
 * planes.
 *
 * Where contours of several families were closed along the border of the image, its sides get
 * virtual slices likewise (AddBorderSlices), from a surface that goes on beyond it.
 *
 * Where slices are too few (Options::Virtual, SliceDensity), what they make is a first surface
 * only, with triangles no smaller than the next step needs:
 *
 *   MakeVirtualSlices   the fair surface of its topology, cut on virtual planes  (our own)
 *
 * and all stages from RegisterCrossings on run once more, with real and virtual contours. The
 * second surface is the result if it has as many components and handles as the first one; otherwise
 * the first one is, and its cycles are filled again, as Options::Patching says. For a stack with a
 * few slices across, this is tried first with the surface of the stack alone in the place of the
 * first one, bent through the contours of the slices across. Contours on planes of no family
 * (Options::Guides) guide either surface. Repairs and agreement are those of the real slices in any
 * case.
 *
 * Filters/Core/README.md has the data between the stages, the sampling condition, and the arguments
 * for the guarantees, which hold for every input that is not refused:
 *
 *   G1  Closed: every edge of the surface has exactly two triangles.
 *   G2  2-manifold: the triangles around every vertex form one disc.
 *   G3  Oriented: the two triangles at an edge run through it in opposite directions, and outside
 *       is where the contours have it (on their right, seen from the positive end of the axis).
 *   G4  Contours are kept: where the slices agree, the vertices of contours are vertices of the
 *       surface.
 *   G5  Deterministic: the result does not depend on the number of threads, and slices that agree
 *       are not changed by ReconcileSlices.
 *   G6  Embedded: no two triangles meet but in their common edge or vertex.
 *   G7  Bounded: nothing leaves the box around all contours by more than half the spacing of the
 *       slices (SpacingAtEnds) along any axis.
 *
 * `observer` is called after each stage, in both passes.
 */
Reconstruction Reconstruct(std::array<Pieces, 3>&& pieces, const Options& options,
  const Execution& execution, const StageObserver& observer = {});

class Pass;

/// The same from contours that ReadSlices has read, to the surface. False: stopped.
bool ReconstructContours(Pass& pass);

/// Adds the slices that the options want beyond those of the input, where these are not too few.
/// False: stopped.
bool AddOuterSlices(Pass& pass);
}

#endif
