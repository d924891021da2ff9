// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LabelRunner.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/InsertedContours.h"
#include "Core/Labels/MissingLabels.h"
#include "Core/Labels/SliceMembers.h"
#include "Core/Sparse/InterpolatePolygon.h"

#include <algorithm>

/// The part of LabelRunner for contours that slices lack.
namespace orthoslices
{
/// Takes out contours that were inserted for a label where other labels are drawn.
void LabelRunner::RemoveInserted()
{
  const std::vector<Contours*> labels = this->ListContours();
  const auto marked =
    FindContradictedInsertions(this->Thickness(), { labels.begin(), labels.end() }, this->Execute);
  const std::vector<Index> numbers = this->ListRead();
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    Contours& contours = *labels[i];
    std::vector<Repair>& repairs = this->Passes[numbers[i]].Stages.Inserted;
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      const auto isOfSlice = [&](const Repair& repair)
      {
        return repair.Axis == contours.Axis[contour] &&
          repair.Where[repair.Axis] == contours.Coordinate[contour];
      };
      if (marked[i][contour] != 0)
      {
        repairs.erase(std::remove_if(repairs.begin(), repairs.end(), isOfSlice), repairs.end());
      }
    }
    RemoveMarked(marked[i], contours);
  }
}

/// Adds the contours of labels that slices lack where nothing else is drawn. Such slices give way to
/// those across.
void LabelRunner::AddMissing()
{
  if (!this->Settings.InsertMissing || this->IsAnyInsideOut())
  {
    return;
  }
  const std::vector<Contours*> labels = this->ListContours();
  const std::vector<Contours> found =
    FindMissingLabels({ labels.begin(), labels.end() }, this->Execute);
  const std::vector<Index> numbers = this->ListRead();
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    for (Index contour = 0; contour < found[i].Count(); ++contour)
    {
      const int axis = found[i].Axis[contour];
      const std::vector<Point2> polygon = PolygonOf(found[i], contour);
      const Point2 middle = MiddleOf(polygon);
      Point3 where;
      where[FirstAxis(axis)] = middle[0];
      where[SecondAxis(axis)] = middle[1];
      where[axis] = found[i].Coordinate[contour];
      this->Passes[numbers[i]].Stages.Inserted.push_back(
        { RepairKind::ContourInserted, axis, 0, where, LengthOf(polygon) });
      this->Filled[axis].insert(where[axis]);
    }
    AppendContours(found[i], *labels[i]);
  }
}
}
