// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LabelRunner.h"

#include "Core/Labels/CommonLines.h"
#include "Core/Labels/SidesOnPlanes.h"

#include <algorithm>

/// The part of LabelRunner for labels that end just on slices.
namespace orthoslices
{
/// Sets of labels that places have on some slice, of which two overlap although neither is within
/// the other one.
StructureSets LabelRunner::FindOverlapping() const
{
  StructureSets found;
  for (const std::vector<Index>& set : this->Borders.Sets)
  {
    const auto& areas = this->Borders.Areas;
    const auto isOverlap = [&](const auto& pair)
    {
      const double least =
        std::min(areas.OfStructure[pair.first.first], areas.OfStructure[pair.first.second]);
      return pair.second < MostOverlap * least &&
        std::binary_search(set.begin(), set.end(), pair.first.first) &&
        std::binary_search(set.begin(), set.end(), pair.first.second);
    };
    if (std::any_of(areas.OfPair.begin(), areas.OfPair.end(), isOverlap))
    {
      found.insert(set);
    }
  }
  return found;
}

/// What becomes of places on which labels overlap that slices across do not show to overlap.
SetReplacements LabelRunner::FindContradicted()
{
  const StructureSets overlapping = this->FindOverlapping();
  if (overlapping.empty())
  {
    return {};
  }
  std::vector<StructureCrossings> crossings;
  for (const LabelPass& label : this->Passes)
  {
    if (label.IsRead)
    {
      Contours contours = label.Stages.Tables.Contours;
      SpatialGrid grid = label.Stages.Result.Grid;
      AddEmptyPlanes(this->Planes, EmptyPlanes::All, contours, grid);
      std::vector<IsolatedLoop> isolated;
      GridCrossings found = RegisterCrossings(contours, grid, this->Execute, isolated);
      crossings.push_back({ std::move(grid), std::move(found), {} });
    }
  }
  return FindContradictedSets(crossings, overlapping, this->Borders.Sets);
}

/**
 * Where labels end just on a slice, that and the slices across may say the same in two ways: it
 * shows the label that ends, or the one that begins, or both; and sides of contours that lie on the
 * plane count as above it. So labels that one slice alone has in common are parted, and sides on
 * the plane go to the side of it that agrees.
 */
void LabelRunner::SettleEnds()
{
  if (this->IsAnyInsideOut())
  {
    return;
  }
  const std::vector<Contours*> labels = this->ListContours();
  const SetReplacements replaced = this->FindContradicted();
  SharedBorders shared;
  bool hasChanged = !replaced.empty();
  if (hasChanged)
  {
    shared = ShareBorders(0.0, {}, this->Execute, labels, replaced);
  }
  std::vector<Pass*> passes;
  for (LabelPass& pass : this->Passes)
  {
    if (pass.IsRead)
    {
      passes.push_back(&pass.Stages);
    }
  }
  if (SettleSidesOnPlanes(this->CommonGrid(passes), 0.5 * this->Thickness(), this->Execute, labels))
  {
    hasChanged = true;
    shared = ShareBorders(0.0, {}, this->Execute, labels);
  }
  if (hasChanged)
  {
    this->TakeBorders(std::move(shared));
  }
}

/// Takes borders that have become others since labels were read; overlaps are those that were drawn.
void LabelRunner::TakeBorders(SharedBorders&& shared)
{
  this->Borders.Sets = std::move(shared.Sets);
  this->Borders.Union = std::move(shared.Union);
  this->Junctions = RoundAll(shared.Junctions, this->Settings.Quantum);
  this->BuildGrids();
}
}
