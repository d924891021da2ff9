// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/LabelRunner.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/InsertedContours.h"
#include "Core/Labels/MissingLabels.h"
#include "Core/Labels/SliceMembers.h"
#include "Core/MakeSurface.h"
#include "Core/SecondPass.h"
#include "Core/Slicing/SliceSurface.h"
#include "Core/Sparse/InterpolatePolygon.h"
#include "Core/Sparse/SurfaceMesh.h"
#include "Core/Sparse/VirtualSlices.h"

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

/// Marks contours on slices that lack one label alone: slices across show more of what is missing
/// there than those before and after do, see FillLacking.
std::vector<std::uint8_t> LabelRunner::FindAlone(
  const LackingLabels& lacking, const Contours& contours)
{
  std::vector<std::uint8_t> marked;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const auto found = lacking.find({ contours.Axis[i], contours.Coordinate[i] });
    marked.push_back(found != lacking.end() && found->second.size() == 1 ? 1 : 0);
  }
  return marked;
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
  std::vector<Contours> found = FindMissingLabels({ labels.begin(), labels.end() }, this->Execute);
  const LackingLabels lacking = this->ListLacking();
  const std::vector<Index> numbers = this->ListRead();
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    RemoveMarked(FindAlone(lacking, found[i]), found[i]);
    this->AddInserted(numbers[i], found[i]);
  }
}

/// Adds contours that were inserted for a label, on slices that give way to those across.
void LabelRunner::AddInserted(Index label, const Contours& found)
{
  Pass& pass = this->Passes[label].Stages;
  for (Index contour = 0; contour < found.Count(); ++contour)
  {
    const int axis = found.Axis[contour];
    const std::vector<Point2> polygon = PolygonOf(found, contour);
    const Point2 middle = MiddleOf(polygon);
    Point3 where;
    where[FirstAxis(axis)] = middle[0];
    where[SecondAxis(axis)] = middle[1];
    where[axis] = found.Coordinate[contour];
    pass.Inserted.push_back({ RepairKind::ContourInserted, axis, 0, where, LengthOf(polygon) });
    this->Filled[axis].insert(where[axis]);
  }
  AppendContours(found, pass.Tables.Contours);
}

/// The slices that labels lack although they pass through them, and these labels.
LabelRunner::LackingLabels LabelRunner::ListLacking() const
{
  LackingLabels slices;
  for (const Index label : this->ListRead())
  {
    VirtualPlanes lacking;
    if (!this->FindLacking(this->Passes[label], lacking))
    {
      return {}; // not all labels are drawn on all families
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double plane : lacking[axis])
      {
        slices[{ axis, plane }].push_back(label);
      }
    }
  }
  return slices;
}

/// Cuts a surface around all labels on planes, those of each plane by themselves; what is drawn
/// there has no part in it. False: stopped.
bool LabelRunner::CutUnion(const VirtualPlanes& planes, std::vector<Contours>& cuts)
{
  Contours others = this->Borders.Union;
  std::vector<std::uint8_t> isThere;
  for (Index i = 0; i < others.Count(); ++i)
  {
    const std::vector<double>& of = planes[others.Axis[i]];
    isThere.push_back(std::binary_search(of.begin(), of.end(), others.Coordinate[i]) ? 1 : 0);
  }
  RemoveMarked(isThere, others);
  if (others.Count() == 0)
  {
    return true;
  }
  RemoveThinHoles(this->Thickness(), others);
  LabelPass all(this->Settings, this->Execute);
  all.SetProgress(ProgressOfReading, ProgressOfReading, 0, 1);
  Pass& pass = all.Stages;
  pass.Tables.Tolerance = this->Passes.front().Stages.Tables.Tolerance;
  pass.Tables.Contours = std::move(others);
  pass.BuildGrid();
  if (!ConnectContours(pass) || !Sketch(0.0, pass))
  {
    this->Passes.front().Stages.Result.Stopped = true;
    return false;
  }
  GuideCurves none;
  const SurfaceMesh mesh =
    MakeSurfaceMesh(GeometryOf(pass.Result), pass.Result.Surface, none, pass.Execute);
  TriangleSurface surface{ mesh.Points, mesh.Corners.ListTriangles(), {} };
  if (CloseSurface(surface).Kind == SurfaceProblemKind::None)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::vector<PlaneContours> sections = SliceSurface(surface, axis, planes[axis],
        this->Settings.SinglePrecision ? Precision::Single : Precision::Double, pass.Execute);
      for (std::size_t i = 0; i < sections.size(); ++i)
      {
        cuts.emplace_back();
        AppendSlice(sections[i], axis, planes[axis][i], cuts.back());
      }
    }
  }
  return true;
}

/**
 * A label that a slice lacks still, such as one that ends beyond it, is in what all labels cover
 * together there, but for what is drawn: a surface around all through the other slices shows that.
 * Of slices that lack several labels nobody knows which is where. False: stopped.
 */
bool LabelRunner::FillLacking()
{
  constexpr double thickness = 10.0; // what the surface is off slices, in slivers
  if (!this->Settings.InsertMissing || this->IsAnyInsideOut())
  {
    return true;
  }
  VirtualPlanes planes;
  LackingLabels slices = this->ListLacking();
  for (const auto& [slice, lacking] : slices)
  {
    planes[slice.first].push_back(slice.second);
  }
  std::vector<Contours> cuts;
  if (slices.empty() || !this->CutUnion(planes, cuts))
  {
    return slices.empty();
  }
  const std::vector<Contours*> labels = this->ListContours();
  bool hasChanged = false;
  for (const Contours& whole : cuts)
  {
    const std::vector<Index> lacking = whole.Count() == 0
      ? std::vector<Index>()
      : slices[{ whole.Axis.front(), whole.Coordinate.front() }];
    if (lacking.size() == 1)
    {
      this->AddInserted(lacking.front(),
        FindRest(whole, thickness * this->Thickness(), { labels.begin(), labels.end() }));
      hasChanged = true;
    }
  }
  if (hasChanged)
  {
    this->TakeBorders(ShareBorders(0.0, {}, this->Execute, labels));
  }
  return true;
}
}
