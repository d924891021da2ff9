// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEmbedIsolated_h
#define OrthoSlicesEmbedIsolated_h

#include "Core/Base/Execution.h"
#include "Core/Graph/EditGraph.h"
#include "Core/Graph/IsolatedContours.h"

namespace orthoslices
{
/**
 * Makes loops of G of the whole isolated contours (our own addition; the paper leaves them open).
 * Vertices on the border of their face move inside by the grid's Margin. Contours that cross
 * themselves or each other are taken apart (see UncrossCurves). One that still touches an arc or a
 * larger loop of its face takes no part in the surface, nor does one whose bounding box has a
 * diagonal of less than `minimum` (world units). Loops that G had before are replaced. REQUIRES:
 * EmbedArcs has run.
 */
void EmbedIsolated(const GraphTables& tables, double minimum, const Execution& execution,
  IsolatedContours& isolated);
}

#endif
