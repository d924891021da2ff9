// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/SecondPass.h"

#include "Core/MakeSurface.h"
#include "Core/RealSlices.h"
#include "Core/Sparse/SelectContours.h"

#include <algorithm>

namespace orthoslices
{
bool Sketch(double edgeLength, Pass& pass)
{
  PatchOptions patching = pass.Settings.Patching;
  patching.EdgeLength =
    std::max(patching.EdgeLength, edgeLength / MinMeanSpacing(pass.Result.Grid));
  patching.Shared = nullptr;
  // Contours keep their vertices: the surface is going to be bent through them.
  patching.Accuracy = 0.0;
  patching.OwnAccuracy = false;
  return FillCycles(patching, pass);
}

PriorKnowledge TopologyOf(const Reconstruction& base)
{
  const Index small = base.SmallComponents;
  return { base.Topology.Components + small, small > 0 ? -1 : base.Topology.Genus };
}

Pass SecondPass(const Pass& first, const Contours& drawn, const Contours& added,
  const PriorKnowledge& known, std::vector<Index>& leftOut)
{
  const std::vector<IsolatedLoop>& parts = first.Tables.IsolatedParts;
  leftOut = FindLeftOut(first.Result.Isolated, parts);
  Contours contours = drawn;
  RemoveContours(leftOut, parts, contours);
  AddVirtual(added, contours);
  Pass again(first, std::move(contours));
  again.Settings.Known = known;
  again.SetShare(ProgressOfBending, 1.0);
  return again;
}
}
