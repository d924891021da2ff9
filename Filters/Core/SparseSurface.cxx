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
/// A surface that shows the topology and is going to be bent: with no more triangles than that needs.
bool Sketch(const SliceDensity& density, Pass& pass)
{
  PatchOptions patching = pass.Settings.Patching;
  patching.EdgeLength =
    std::max(patching.EdgeLength, density.EdgeLength() / MinMeanSpacing(pass.Result.Grid));
  patching.Shared = nullptr;
  return FillCycles(patching, pass);
}

/// What a second surface has to come out as. Components that were too small are drawn nevertheless,
/// and must not be joined to others instead.
PriorKnowledge TopologyOf(const Reconstruction& base)
{
  const Index small = base.SmallComponents;
  return { base.Topology.Components + small, small > 0 ? -1 : base.Topology.Genus };
}

/// A pass over the contours as they were drawn, without what the first surface leaves out, and over
/// virtual ones.
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
  again.SetShare(0.48, 0.88); // 0.5 to 0.8 of it is 0.68 to 0.8 of the whole
  return again;
}

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
  bool FillFirst();
  bool BendStack();
  bool Bend(const Reconstruction& base, GuideCurves&& guides);
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
  if (!ConnectContours(stack) || !Sketch(this->Density, stack))
  {
    return this->Stop();
  }
  return this->Bend(stack.Result, CutGuides(this->Drawn, this->First.Result.Grid, axis));
}

/// Makes the surface anew, with virtual slices of `base` that bends through the guides. False if
/// there are none, or if the topology comes out another than that of `base`.
bool SparseRunner::Bend(const Reconstruction& base, GuideCurves&& guides)
{
  Reconstruction& first = this->First.Result;
  Execution execution = this->First.Execute;
  execution.Continue = [this](double progress) { return this->First.GoOn(progress); };
  const Contours added = MakeVirtualSlices(
    { GeometryOf(base), base.Surface, first.Grid, std::move(guides) }, this->Density, execution);
  if (first.Stopped || added.Count() == 0)
  {
    return false;
  }
  std::vector<Index> leftOut;
  Pass again = SecondPass(this->First, this->Drawn, added, TopologyOf(base), leftOut);
  if (!ConnectContours(again) || !FillCycles(again.Settings.Patching, again))
  {
    return this->Stop();
  }
  if (!(again.Result.Topology == base.Topology))
  {
    return false;
  }
  TakeReport(first, leftOut, again.Result);
  first = std::move(again.Result);
  return true;
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
  if (!Sketch(this->Density, this->First))
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

bool SparseStructure::Draw()
{
  this->First.SetShare(0.245, 0.545);
  if (!ConnectContours(this->First))
  {
    return false;
  }
  this->Centers = this->First.Result.Surface.CentralPoints;
  if (!Sketch(this->Density, this->First))
  {
    return false;
  }
  Reconstruction& first = this->First.Result;
  Execution execution = this->First.Execute;
  execution.Continue = [this](double progress) { return this->First.GoOn(progress); };
  const int axis = this->Density.StackAxis();
  const Contours ofStack = axis < 0 ? Contours() : SelectAxis(this->Drawn, axis, true);
  if (ofStack.Count() == 0)
  {
    this->Known = TopologyOf(first);
    this->Virtual =
      MakeVirtualSlices({ GeometryOf(first), first.Surface, first.Grid, {}, &this->Planes },
        this->Density, execution);
    return !first.Stopped;
  }
  Pass stack(this->First, Contours(ofStack));
  stack.SetShare(0.485, 0.5);
  if (!ConnectContours(stack) || !Sketch(this->Density, stack))
  {
    first.Stopped = true;
    return false;
  }
  this->Known = TopologyOf(stack.Result);
  this->Virtual = MakeVirtualSlices({ GeometryOf(stack.Result), stack.Result.Surface, first.Grid,
                                      CutGuides(this->Drawn, first.Grid, axis), &this->Planes },
    this->Density, execution);
  return !first.Stopped;
}

bool SparseStructure::Redraw()
{
  if (this->Virtual.Count() == 0)
  {
    return true;
  }
  std::vector<Index> leftOut;
  Pass again = SecondPass(this->First, this->Drawn, this->Virtual, this->Known, leftOut);
  if (!DrawGraph(again))
  {
    this->First.Result.Stopped = true;
    return false;
  }
  this->Virtual = ReadVirtual(again.Result, this->First.Result.Grid);
  return true;
}

bool SparseStructure::Finish()
{
  if (this->Virtual.Count() == 0)
  {
    this->First.Result.Surface.CentralPoints.swap(this->Centers);
    this->First.SetShare(0.0, 1.0);
    return FillCycles(this->First.Settings.Patching, this->First);
  }
  std::vector<Index> leftOut;
  Pass again = SecondPass(this->First, this->Drawn, this->Virtual, this->Known, leftOut);
  if (!ConnectContours(again) || !FillCycles(again.Settings.Patching, again))
  {
    this->First.Result.Stopped = true;
    return false;
  }
  TakeReport(this->First.Result, leftOut, again.Result);
  this->First.Result = std::move(again.Result);
  return true;
}
}
