// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/SparseStructure.h"

#include "Core/MakeSurface.h"
#include "Core/PredictSlices.h"
#include "Core/RealSlices.h"
#include "Core/SecondPass.h"
#include "Core/Sparse/FieldSlices.h"
#include "Core/Sparse/SelectContours.h"
#include "Core/Sparse/VirtualSlices.h"

namespace orthoslices
{
/// The first surface, as it is cut and bent. False: stopped.
bool SparseStructure::SketchFirst()
{
  this->First.SetShare(ProgressOfPredictions, ProgressOfSketch);
  return Sketch(this->Density.EdgeLength(), this->First);
}

bool SparseStructure::Draw()
{
  this->First.SetShare(ProgressOfSlices, ProgressOfPredictions);
  if (!ConnectContours(this->First))
  {
    return false;
  }
  if (this->Density.IsOfField())
  {
    return this->DrawFew();
  }
  if (!this->SketchFirst())
  {
    return false;
  }
  Reconstruction& first = this->First.Result;
  this->First.SetShare(ProgressOfStack, ProgressOfBending);
  Execution execution = this->First.Execute;
  execution.Continue = [this](double progress) { return this->First.GoOn(progress); };
  const double cornerAngle = this->First.Settings.Patching.CornerAngle;
  const int axis = this->Density.StackAxis();
  const Contours ofStack = axis < 0 ? Contours() : SelectAxis(this->Drawn, axis, true);
  if (ofStack.Count() == 0)
  {
    this->Known = TopologyOf(first);
    GuideCurves none;
    this->Virtual = MakeVirtualSlices(
      { GeometryOf(first), first.Surface, first.Grid, none, cornerAngle, &this->Planes },
      this->Density, execution);
    return !first.Stopped;
  }
  Pass stack(this->First, Contours(ofStack));
  stack.SetShare(ProgressOfSketch, ProgressOfStack);
  if (!ConnectContours(stack) || !Sketch(this->Density.EdgeLength(), stack))
  {
    first.Stopped = true;
    return false;
  }
  this->Known = TopologyOf(stack.Result);
  GuideCurves guides = CutGuides(this->Drawn, first.Grid, axis);
  this->Virtual = MakeVirtualSlices({ GeometryOf(stack.Result), stack.Result.Surface, first.Grid,
                                      guides, cornerAngle, &this->Planes },
    this->Density, execution);
  return !first.Stopped;
}

/// Virtual slices from a field, or from the first surface as it is: few slices leave it not enough
/// to bend between.
bool SparseStructure::DrawFew()
{
  Reconstruction& first = this->First.Result;
  this->Known = TopologyOf(first);
  this->First.SetShare(ProgressOfSketch, ProgressOfBending);
  if (this->FollowsField)
  {
    const std::vector<WorldLoop> loops = ListLoops(this->Drawn, this->First);
    const double step = SampleStep(loops, this->Density.EdgeLength());
    const SliceField field(SampleLoops(loops, step), this->First.Execute);
    if (field.IsSolved())
    {
      this->Virtual = CutField(field, first.Grid, this->Density, this->Planes, this->First.Execute);
      return this->First.GoOn(0.5);
    }
  }
  if (!this->SketchFirst())
  {
    return false;
  }
  GuideCurves none;
  this->Virtual =
    MakeVirtualSlices({ GeometryOf(first), first.Surface, first.Grid, none,
                        this->First.Settings.Patching.CornerAngle, &this->Planes, false },
      this->Density, this->First.Execute);
  return this->First.GoOn(0.5);
}

Contours SparseStructure::ListSlices() const
{
  std::vector<Index> leftOut;
  return SecondPass(this->First, this->Drawn, this->Virtual, this->Known, leftOut).Tables.Contours;
}

void SparseStructure::TakeVirtual(Contours&& slices)
{
  this->Virtual = std::move(slices);
  RemoveOnPlanes(this->First.Result.Grid, this->Virtual);
  this->Virtual.Cell.assign(this->Virtual.Axis.size(), -1);
  this->Virtual.Virtual.assign(this->Virtual.Axis.size(), 1);
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

Pass& SparseStructure::StartAgain()
{
  this->Again = std::make_unique<Pass>(
    SecondPass(this->First, this->Drawn, this->Virtual, this->Known, this->LeftOut));
  return *this->Again;
}

bool SparseStructure::Connect()
{
  if (!ConnectGraph(*this->Again))
  {
    this->First.Result.Stopped = true;
    return false;
  }
  return true;
}

void SparseStructure::Finish()
{
  TakeReport(this->First.Result, this->LeftOut, this->Again->Result);
  this->First.Result = std::move(this->Again->Result);
  this->Again.reset();
}
}
