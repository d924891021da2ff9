// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/SparseSurface.h"

#include "Core/MakeSurface.h"
#include "Core/RealSlices.h"
#include "Core/Sparse/SelectContours.h"
#include "Core/Sparse/VirtualSlices.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Runs the passes; see MakeSparseSurface.
class SparseRunner
{
public:
  SparseRunner(const SliceDensity& density, Pass& first)
    : Density(density)
    , First(first)
    , Drawn(first.Tables.Contours)
  {
  }

  bool Run();

private:
  bool Sketch(Pass& pass) const;
  bool FillFirst();
  bool BendStack();
  bool Bend(const Reconstruction& base, GuideCurves&& guides);
  Contours WithVirtual(const Contours& added, const std::vector<Index>& leftOut) const;
  bool Stop();

  const SliceDensity& Density;
  Pass& First;
  Contours Drawn;              ///< as they are before the first pass
  std::vector<double> Centers; ///< the central points of the first surface before its sketch
};

bool SparseRunner::Stop()
{
  this->First.Result.Stopped = true;
  return false;
}

/// A surface that shows the topology and is going to be bent: with no more triangles than that needs.
bool SparseRunner::Sketch(Pass& pass) const
{
  PatchOptions patching = pass.Settings.Patching;
  patching.EdgeLength =
    std::max(patching.EdgeLength, this->Density.EdgeLength() / MinMeanSpacing(pass.Result.Grid));
  patching.Shared = nullptr;
  return FillCycles(patching, pass);
}

/// Makes the sketch of the first surface the surface that is wanted.
bool SparseRunner::FillFirst()
{
  this->First.Result.Surface.CentralPoints.swap(this->Centers);
  this->First.SetShare(0.0, 1.0);
  return FillCycles(this->First.Settings.Patching, this->First);
}

/// False if there is no stack with slices across, or no surface from it.
bool SparseRunner::BendStack()
{
  const int axis = this->Density.StackAxis();
  if (axis < 0)
  {
    return false;
  }
  Pass stack(this->First, SelectAxis(this->Drawn, axis, true));
  stack.SetShare(0.485, 0.5);
  if (!ConnectContours(stack) || !this->Sketch(stack))
  {
    return this->Stop();
  }
  return this->Bend(stack.Result, CutGuides(this->Drawn, this->First.Result.Grid, axis));
}

/// What a second surface has to come out as. Components that were too small are drawn nevertheless,
/// and must not be joined to others instead.
PriorKnowledge TopologyOf(const Reconstruction& base)
{
  const Index small = base.SmallComponents;
  return { base.Topology.Components + small, small > 0 ? -1 : base.Topology.Genus };
}

/// The contours as drawn, those that took no part left out, and virtual ones.
Contours SparseRunner::WithVirtual(const Contours& added, const std::vector<Index>& leftOut) const
{
  Contours contours = this->Drawn;
  RemoveContours(leftOut, this->First.Tables.IsolatedParts, contours);
  AddVirtual(added, contours);
  return contours;
}

/// Makes the surface anew, with virtual slices of `base` that bends through the guides: with all of
/// them, or those that agree with the real slices. False if there are none, or if the topology comes
/// out another than that of `base`.
bool SparseRunner::Bend(const Reconstruction& base, GuideCurves&& guides)
{
  Reconstruction& first = this->First.Result;
  Execution execution = this->First.Execute;
  execution.Continue = [this](double progress) { return this->First.GoOn(progress); };
  // Without planes on which arcs were drawn anew, and then without those on which any were mended. But
  // that a stack hangs together otherwise than all slices together do shall not be made to work.
  const int attempts = guides.Slices.empty() ? 3 : 1;
  Contours added = MakeVirtualSlices(
    { GeometryOf(base), base.Surface, first.Grid, std::move(guides) }, this->Density, execution);
  const std::vector<Index> leftOut = FindLeftOut(first.Isolated, this->First.Tables.IsolatedParts);
  for (int attempt = 0; attempt < attempts && !first.Stopped && added.Count() > 0; ++attempt)
  {
    Pass again(this->First, this->WithVirtual(added, leftOut));
    again.Settings.Known = TopologyOf(base);
    // 0.5 to 0.8 of it is 0.68 to 0.8 of the whole. Further attempts are not foreseen there.
    again.SetShare(attempt == 0 ? 0.48 : 0.8, attempt == 0 ? 0.88 : 0.8);
    if (!ConnectContours(again) || !FillCycles(again.Settings.Patching, again))
    {
      return this->Stop();
    }
    if (again.Result.Topology == base.Topology)
    {
      TakeReport(first, leftOut, again.Result);
      first = std::move(again.Result);
      return true;
    }
    if (!RemoveMended(again.OfVirtual, again.Result.Grid, added))
    {
      return false;
    }
  }
  return false;
}

bool SparseRunner::Run()
{
  // Two surfaces are made: 0.35 to 0.8 of the first one is 0.35 to 0.485 of the whole.
  this->First.SetShare(0.245, 0.545);
  if (!ConnectContours(this->First))
  {
    return false;
  }
  this->Centers = this->First.Result.Surface.CentralPoints;
  if (!this->Sketch(this->First))
  {
    return false;
  }
  this->First.SetShare(0.5, 0.66);
  const Reconstruction& result = this->First.Result;
  const bool isDone = this->BendStack() || (!result.Stopped && this->Bend(result, {}));
  return !result.Stopped && (isDone || this->FillFirst());
}
}

bool MakeSparseSurface(const SliceDensity& density, Pass& pass)
{
  return SparseRunner(density, pass).Run();
}
}
