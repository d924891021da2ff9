// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesArcShells_h
#define OrthoSlicesArcShells_h

#include "Core/Graph/EditGraph.h"
#include "Core/Graph/FaceArcs.h"

namespace orthoslices
{
/**
 * Draws all arcs of a face anew as *shells*, whatever they looked like: an arc follows the border
 * of the face at a depth that grows with the number of arcs nested beneath it, so that no two can
 * meet. If the ends of the arcs interlock, they are joined anew first, neighbour to neighbour.
 */
FaceDrawing DrawArcShells(const ArcGeometry& geometry, const FaceArcs& face);
}

#endif
