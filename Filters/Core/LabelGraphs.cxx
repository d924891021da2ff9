// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LabelRunner.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/ClearLines.h"
#include "Core/Labels/NestedRegions.h"
#include "Core/Labels/SideMeetings.h"
#include "Core/MakeSurface.h"
#include "Core/RealSlices.h"

#include <algorithm>

/// The part of LabelRunner for graphs that are common to labels where their contours are.
namespace orthoslices
{
/// The planes of all labels, and the coarsest precision of any.
SpatialGrid LabelRunner::CommonGrid(const std::vector<Pass*>& passes) const
{
  SpatialGrid grid;
  grid.Planes = this->Planes;
  grid.Quantum = this->Settings.Quantum;
  grid.SinglePrecision = this->Settings.SinglePrecision;
  for (const Pass* pass : passes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      grid.Step[axis] = std::max(grid.Step[axis], pass->Result.Grid.Step[axis]);
    }
  }
  return grid;
}

/// Keeps what is to be said of the slices of a label as they were drawn, unless it is known.
void LabelRunner::KeepReport(Pass& drawn)
{
  for (LabelPass& label : this->Passes)
  {
    if (&label.Stages == &drawn && label.AsDrawn == nullptr)
    {
      label.AsDrawn = std::make_unique<Reconstruction>(ReportOf(drawn.Result));
    }
  }
}

/// Makes contours common again that graphs show otherwise for each label.
void LabelRunner::MendSlices(const SpatialGrid& grid, std::vector<Contours>& labels)
{
  const std::vector<Contours*> all = PointersTo(labels);
  ShareBorders(0.0, this->Borders.Sets, this->Execute, all); // so that lines are crossed alike
  ClearLines(grid, this->Execute, all);
  const SharedBorders shared = ShareBorders(0.0, this->Borders.Sets, this->Execute, all);
  this->AddJunctions(shared.Junctions);
}

/// Draws the graph of each label by itself, and reads its contours. False: stopped.
bool LabelRunner::DrawEach(const std::vector<Pass*>& passes, std::vector<Contours>& drawn)
{
  drawn.clear();
  for (Pass* pass : passes)
  {
    if (!DrawGraph(*pass))
    {
      this->Passes.front().Stages.Result.Stopped = true;
      return false;
    }
    drawn.push_back(ReadAll(pass->Result));
  }
  return true;
}

/**
 * Draws the graphs of all labels. Close to lines in which planes meet, each graph makes room for its
 * own arcs. If arcs of several labels meet by that but in common points, all slices are mended
 * together, and drawn once more; then there is nothing left to make room for. If nothing would be
 * left of a label by that, all stay as they are. False: stopped.
 */
bool LabelRunner::DrawGraphs(const std::vector<Pass*>& passes)
{
  constexpr int mostRounds = 3;
  std::vector<Contours> before, drawn;
  for (const Pass* pass : passes)
  {
    before.push_back(pass->Tables.Contours);
  }
  if (!this->DrawEach(passes, drawn))
  {
    return false;
  }
  const SpatialGrid grid = this->CommonGrid(passes);
  for (int round = 0; round < mostRounds && DoSidesMeet(grid, drawn); ++round)
  {
    this->MendSlices(grid, drawn);
    if (std::any_of(drawn.begin(), drawn.end(),
          [](const Contours& contours) { return contours.Count() == 0; }))
    {
      break;
    }
    for (std::size_t i = 0; i < passes.size(); ++i)
    {
      TakeCells(before[i], drawn[i]);
      this->KeepReport(*passes[i]);
      passes[i]->SetOtherPlanes(this->Planes, EmptyPlanes::All);
      passes[i]->StartAgain(std::move(drawn[i]));
    }
    if (!this->DrawEach(passes, drawn))
    {
      return false;
    }
  }
  return true;
}
}
