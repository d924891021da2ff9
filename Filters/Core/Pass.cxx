// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pass.h"

#include "Core/CheckInvariants.h"
#include "Core/RealSlices.h"
#include "Core/Slices/EmptyPlanes.h"
#include "Core/Slices/EndSlices.h"
#include "Core/Sparse/SelectContours.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

namespace orthoslices
{
Pass::Pass(const Pass& first, Contours&& contours)
  : Pass(first, std::move(contours), first.Outer)
{
  this->Progress->ShareWhole(*first.Progress);
}

Pass::Pass(const Pass& first, Contours&& contours, const Execution& execution)
  : Pass(first.Settings, execution, first.Observe)
{
  this->Tables.Tolerance = first.Tables.Tolerance;
  this->Tables.Border = first.Tables.Border;
  this->Tables.Contours = std::move(contours);
  this->Inserted = first.Inserted;
  this->Bounds = first.Bounds;
  this->OtherPlanes = first.OtherPlanes;
  this->WhichPlanes = first.WhichPlanes;
  Reconstruction& result = this->Result;
  result.Invalid = first.Result.Invalid;
  result.CrossingProblems = first.Result.CrossingProblems;
  result.Mended = first.Result.Mended;
  result.OpenBorder = first.Result.OpenBorder;
  result.ContourCount = first.Result.ContourCount;
  result.Diagonal = first.Result.Diagonal;
  result.PolygonSizes = first.Result.PolygonSizes;
  result.Undecided = first.Result.Undecided;
  result.Doubtful = first.Result.Doubtful;
  this->BuildGrid();
}

void Pass::Finish(Stage stage) const
{
#ifdef ORTHOGONAL_SLICES_CHECK_INVARIANTS
  const std::string wrong = CheckInvariants(stage, this->Tables, this->Result);
  if (!wrong.empty())
  {
    std::cerr << wrong << std::endl;
    std::abort();
  }
#endif
  if (this->Observe)
  {
    this->Observe(stage, this->Tables, this->Result);
  }
  this->Progress->Finish(stage, StageShares(this->Settings, this->Result.Grid));
}

bool Pass::GoOn()
{
  this->Result.Stopped = !this->Progress->GoOn();
  return !this->Result.Stopped;
}

bool Pass::GoOn(double share)
{
  this->Result.Stopped = !this->Progress->GoOn(share);
  return !this->Result.Stopped;
}

void Pass::Report(const std::vector<Repair>& repairs)
{
  AppendReal(repairs, this->Result.Grid, this->Result.Repairs);
  AppendVirtual(repairs, this->Result.Grid, this->OfVirtual);
}

void Pass::BuildGrid()
{
  this->Result.Grid = BuildSpatialGrid(this->Tables.Contours, this->Tables.Tolerance,
    this->Settings.SinglePrecision, this->Settings.Quantum);
  this->Result.Grid.Metric = this->Settings.Metric;
  this->Result.Grid.BothWays = this->Settings.Patching.Shared != nullptr;
  LimitBounds(this->Tables.Border, this->Result.Grid);
  LimitBoundsTo(this->Bounds, this->Result.Grid);
  if (this->OtherPlanes != nullptr)
  {
    AddEmptyPlanes(*this->OtherPlanes, this->WhichPlanes, this->Tables.Contours, this->Result.Grid);
  }
  this->NumberInserted();
}

void Pass::StartAgain(Contours&& contours)
{
  this->Tables.Contours = std::move(contours);
  this->Tables.IsolatedParts.clear();
  this->Inserted.clear();
  this->OfVirtual.clear();
  this->BuildGrid();
}

/// Gives inserted contours the numbers that their planes have in the grid. Those on planes that are
/// no more are not there either.
void Pass::NumberInserted()
{
  for (Repair& repair : this->Inserted)
  {
    repair.Plane = this->Result.Grid.FindPlane(repair.Axis, repair.Where[repair.Axis]);
  }
  this->Inserted.erase(std::remove_if(this->Inserted.begin(), this->Inserted.end(),
                         [](const Repair& repair) { return repair.Plane < 0; }),
    this->Inserted.end());
}

void Pass::AddEndSlices()
{
  const EndSlices ends =
    CopyEndSlices(this->Tables.Contours, this->Result.Grid, this->Tables.Tolerance);
  if (ends.Copies.Count() > 0)
  {
    this->AddVirtualSlices(ends.Copies, ends.Bounds);
  }
}

void Pass::AddVirtualSlices(const Contours& added, const Box3& bounds)
{
  this->Bounds = bounds;
  AddVirtual(added, this->Tables.Contours);
  this->OwnsVirtual = true;
  this->BuildGrid();
}
}
