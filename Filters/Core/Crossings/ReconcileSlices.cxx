// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/ReconcileSlices.h"

#include "Core/Crossings/LabelVertices.h"
#include "Core/Crossings/SnipEdges.h"

namespace orthoslices
{
Reconciliation ReconcileSlices(const CrossingTables& tables, const AxisWeights& weights,
  int background, const Execution& execution)
{
  Reconciliation result;
  result.Vertices = LabelVertices(tables, weights, background, result.Repairs, execution);
  result.Edges = SnipEdges(tables, background, result.Repairs, execution);
  return result;
}
}
