// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/MissingLabels.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/FaceSets.h"
#include "Core/Labels/SliceMembers.h"
#include "Core/Labels/SnapVertices.h"
#include "Core/Loops/TraceRegion.h"

#include <algorithm>
#include <set>

namespace orthoslices
{
namespace
{
/// More slices without the structure than this are a gap that no one has overlooked.
constexpr std::ptrdiff_t MaxMissing = 2;

/// What is in a structure towards the gap, as a share of what is in it one slice earlier, at least,
/// if there is one family only; see FindMissingContours.
constexpr double MinShareOfSteady = 0.85;

/// As much of what is in a structure both before and after has nothing else drawn on it.
constexpr double MinShareOfEmpty = 0.5;

using Structures = std::vector<const Contours*>;
using Slice = std::vector<SliceMember>;

/// A structure that a slice lacks; places in the list of the slices of its axis.
struct Lack
{
  Index Structure;
  std::size_t Before, After;
};

/// The slices of one axis, ascending.
class AxisSlices
{
public:
  AxisSlices(const Structures& structures, int axis, bool isAlone)
    : All(structures)
    , IsAlone(isAlone)
  {
    for (Slice& slice : ListSlices(structures))
    {
      if (structures[slice.front().Structure]->Axis[slice.front().Contour] == axis)
      {
        this->Slices.push_back(std::move(slice));
      }
    }
    this->FindLacks();
  }

  std::size_t Count() const { return this->Slices.size(); }
  bool IsAnyLacking(std::size_t slice) const { return !this->Lacks[slice].empty(); }
  /// Adds what structures lack on a slice, for each structure.
  void Fill(std::size_t slice, std::vector<Contours>& found) const;

private:
  struct Overlay;

  void FindLacks();
  void FindLacksOf(Index structure);
  bool IsDrawn(Index structure, std::size_t slice) const;
  double AreaOf(Index structure, std::size_t slice) const;
  bool IsSteady(Index structure, std::size_t slice, std::ptrdiff_t away) const;
  void AddPolygons(std::size_t slice, Index firstNumber, Overlay& overlay) const;
  std::vector<std::uint8_t> FindPlaces(const Lack& lack, const FaceSets& sets) const;

  const Structures& All;
  const bool IsAlone; ///< there are no slices across
  std::vector<Slice> Slices;
  std::vector<std::vector<Lack>> Lacks; ///< of each slice
};

/// Contours of several slices in one plane.
struct AxisSlices::Overlay
{
  std::vector<std::vector<Point2>> Polygons;
  std::vector<Index> Numbers; ///< of the structures, those of each slice from another number on
};

bool AxisSlices::IsDrawn(Index structure, std::size_t slice) const
{
  const Slice& members = this->Slices[slice];
  return std::any_of(members.begin(), members.end(),
    [structure](const SliceMember& member) { return member.Structure == structure; });
}

/// Twice the area.
double AxisSlices::AreaOf(Index structure, std::size_t slice) const
{
  double area = 0.0;
  for (const SliceMember& member : this->Slices[slice])
  {
    area +=
      member.Structure == structure ? TwiceSignedArea(*this->All[structure], member.Contour) : 0.0;
  }
  return area;
}

/// Whether a structure does not shrink from the slice before, seen from a gap, to this one.
bool AxisSlices::IsSteady(Index structure, std::size_t slice, std::ptrdiff_t away) const
{
  const std::ptrdiff_t farther = static_cast<std::ptrdiff_t>(slice) + away;
  if (farther < 0 || farther >= static_cast<std::ptrdiff_t>(this->Count()))
  {
    return false;
  }
  const double area = this->AreaOf(structure, static_cast<std::size_t>(farther));
  return area > 0.0 && this->AreaOf(structure, slice) >= MinShareOfSteady * area;
}

void AxisSlices::FindLacksOf(Index structure)
{
  std::vector<std::size_t> drawn;
  for (std::size_t slice = 0; slice < this->Count(); ++slice)
  {
    if (this->IsDrawn(structure, slice))
    {
      drawn.push_back(slice);
    }
  }
  if (drawn.empty() ||
    static_cast<double>(drawn.size()) <
      (1.0 - MostLacking) * static_cast<double>(drawn.back() - drawn.front() + 1))
  {
    return;
  }
  for (std::size_t i = 0; i + 1 < drawn.size(); ++i)
  {
    const std::size_t before = drawn[i], after = drawn[i + 1];
    const bool isShort = static_cast<std::ptrdiff_t>(after - before) <= MaxMissing + 1;
    if (isShort && after > before + 1 &&
      (!this->IsAlone ||
        (this->IsSteady(structure, before, -1) && this->IsSteady(structure, after, 1))))
    {
      for (std::size_t slice = before + 1; slice < after; ++slice)
      {
        this->Lacks[slice].push_back({ structure, before, after });
      }
    }
  }
}

void AxisSlices::FindLacks()
{
  this->Lacks.resize(this->Count());
  for (std::size_t structure = 0; structure < this->All.size(); ++structure)
  {
    this->FindLacksOf(static_cast<Index>(structure));
  }
}

void AxisSlices::AddPolygons(std::size_t slice, Index firstNumber, Overlay& overlay) const
{
  for (const SliceMember& member : this->Slices[slice])
  {
    overlay.Polygons.push_back(PolygonOf(*this->All[member.Structure], member.Contour));
    overlay.Numbers.push_back(firstNumber + member.Structure);
  }
}

/// 1 for the faces that a structure gets; all 0 if others are drawn in its place. The sets have the
/// structures of the slice, then those of the slice before, then those of the slice after.
std::vector<std::uint8_t> AxisSlices::FindPlaces(const Lack& lack, const FaceSets& sets) const
{
  const Index count = static_cast<Index>(this->All.size());
  std::vector<std::uint8_t> places(sets.Count(), 0);
  double certain = 0.0, empty = 0.0; // areas
  for (Index face = 0; face < sets.Count(); ++face)
  {
    std::array<bool, 3> isAny{}, isOwn{};
    for (const Index number : sets[face])
    {
      isAny[number / count] = true;
      isOwn[number / count] |= number % count == lack.Structure;
    }
    places[face] = !isAny[0] && isAny[1] && isAny[2] && (isOwn[1] || isOwn[2]) ? 1 : 0;
    if (isOwn[1] && isOwn[2] && !sets.IsOuter(face))
    {
      certain += sets.AreaOf(face);
      empty += isAny[0] ? 0.0 : sets.AreaOf(face);
    }
  }
  if (certain <= 0.0 || empty < MinShareOfEmpty * certain)
  {
    std::fill(places.begin(), places.end(), std::uint8_t(0));
  }
  return places;
}

/// Adds the border of faces to the contours of a slice.
void AppendRegion(const PlaneWalks& walks, const PlaneFaces& faces,
  const std::vector<std::uint8_t>& inside, std::pair<int, double> plane, Contours& contours)
{
  for (const TracedLoop& loop : TraceRegion(walks, faces, inside))
  {
    if (loop.Points.size() < 3)
    {
      continue;
    }
    for (const Point2& p : loop.Points)
    {
      contours.U.push_back(p[0]);
      contours.V.push_back(p[1]);
    }
    contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
    contours.Axis.push_back(static_cast<std::int8_t>(plane.first));
    contours.Coordinate.push_back(plane.second);
    contours.Plane.push_back(0); // to be found
    contours.Cell.push_back(-1);
  }
}

void AxisSlices::Fill(std::size_t slice, std::vector<Contours>& found) const
{
  const Index count = static_cast<Index>(this->All.size());
  const SliceMember& first = this->Slices[slice].front();
  const Contours& of = *this->All[first.Structure];
  for (const Lack& lack : this->Lacks[slice])
  {
    Overlay overlay;
    this->AddPolygons(slice, 0, overlay);
    this->AddPolygons(lack.Before, count, overlay);
    this->AddPolygons(lack.After, 2 * count, overlay);
    PlaneWalks walks;
    if (!SplitPolygons(overlay.Polygons, walks))
    {
      continue;
    }
    const PlaneFaces faces(walks);
    const FaceSets sets(walks, faces, LoopWindings(walks, faces), overlay.Numbers);
    AppendRegion(walks, faces, this->FindPlaces(lack, sets),
      { of.Axis[first.Contour], of.Coordinate[first.Contour] }, found[lack.Structure]);
  }
}
}

std::vector<Contours> FindMissingLabels(
  const std::vector<const Contours*>& structures, const Execution& execution)
{
  std::set<int> axes;
  for (const Contours* contours : structures)
  {
    axes.insert(contours->Axis.begin(), contours->Axis.end());
  }
  std::vector<Contours> all(structures.size());
  for (const int axis : axes)
  {
    const AxisSlices slices(structures, axis, axes.size() == 1);
    std::vector<std::vector<Contours>> found(slices.Count());
    execution.For(slices.Count(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          if (slices.IsAnyLacking(i))
          {
            found[i].resize(structures.size());
            slices.Fill(i, found[i]);
          }
        }
      });
    for (const std::vector<Contours>& ofSlice : found)
    {
      for (std::size_t i = 0; i < ofSlice.size(); ++i)
      {
        AppendContours(ofSlice[i], all[i]);
      }
    }
  }
  return all;
}

Contours FindRest(
  const Contours& whole, double thickness, const std::vector<const Contours*>& structures)
{
  Contours rest;
  const int axis = whole.Axis.front();
  const double plane = whole.Coordinate.front();
  std::vector<std::vector<Point2>> polygons;
  SnapTarget drawn(thickness, thickness);
  for (const Contours* contours : structures)
  {
    for (Index i = 0; i < contours->Count(); ++i)
    {
      if (contours->Axis[i] == axis && contours->Coordinate[i] == plane)
      {
        polygons.push_back(PolygonOf(*contours, i));
        drawn.Add(polygons.back());
      }
    }
  }
  std::vector<Index> numbers(polygons.size(), 1); // the whole is 0
  for (Index i = 0; i < whole.Count(); ++i)
  {
    polygons.push_back(PolygonOf(whole, i));
    numbers.push_back(0);
    for (Point2& vertex : polygons.back())
    {
      drawn.Snap(vertex);
    }
  }
  PlaneWalks walks;
  if (SplitPolygons(polygons, walks))
  {
    const PlaneFaces faces(walks);
    FaceSets sets(walks, faces, LoopWindings(walks, faces), numbers);
    sets.RemoveSlivers(thickness, std::vector<std::uint8_t>(sets.Count(), 0));
    std::vector<std::uint8_t> isRest;
    for (Index face = 0; face < sets.Count(); ++face)
    {
      isRest.push_back(sets[face] == std::vector<Index>{ 0 } ? 1 : 0);
    }
    AppendRegion(walks, faces, isRest, { axis, plane }, rest);
  }
  return rest;
}
}
