// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruction.h"

namespace orthoslices
{
CycleGeometry GeometryOf(const Reconstruction& result)
{
  return { result.Grid, result.Graph, result.Crossings, result.Nodes, result.Cycles };
}

Index CountDisagreements(const Reconstruction& result, double tolerance)
{
  Index count = 0;
  for (Index node = 0; node < result.Nodes.Count(); ++node)
  {
    count += result.Nodes.Disagreement(node) > tolerance ? 1 : 0;
  }
  return count;
}
}
