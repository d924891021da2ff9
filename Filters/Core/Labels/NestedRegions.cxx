// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/NestedRegions.h"

#include "Core/Base/EditContours.h"
#include "Core/Labels/FaceSets.h"
#include "Core/Labels/SliceMembers.h"
#include "Core/Loops/TraceRegion.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <tuple>

namespace orthoslices
{
namespace
{
/// A plane across an axis.
struct SlicePlane
{
  int Axis;
  double Coordinate;
  bool IsVirtual;
};

/// The plane graph of all contours of a slice.
class SliceGraph
{
public:
  SliceGraph(
    const std::vector<const Contours*>& structures, const std::vector<SliceMember>& members);

  bool IsSplit() const { return this->Sets != nullptr; }
  FaceSets& GetSets() { return *this->Sets; }
  /// Marks the faces that are on both sides of one of the lines in which planes meet, or may be.
  std::vector<std::uint8_t> FindAcrossLines(const std::array<std::vector<double>, 3>& planes) const;
  /// The border of faces for which a condition holds.
  void Trace(const std::function<bool(Index face)>& isInside, Contours& contours) const;

  SlicePlane Plane;

private:
  PlaneWalks Walks;
  std::unique_ptr<PlaneFaces> Faces;
  std::unique_ptr<FaceSets> Sets;
};

SliceGraph::SliceGraph(
  const std::vector<const Contours*>& structures, const std::vector<SliceMember>& members)
{
  const Contours& first = *structures[members.front().Structure];
  const Index contour = members.front().Contour;
  const bool isVirtual = std::all_of(members.begin(), members.end(),
    [&](const SliceMember& member)
    { return structures[member.Structure]->IsVirtual(member.Contour); });
  this->Plane = { first.Axis[contour], first.Coordinate[contour], isVirtual };
  std::vector<std::vector<Point2>> polygons;
  std::vector<Index> ofWalk;
  for (const SliceMember& member : members)
  {
    polygons.push_back(PolygonOf(*structures[member.Structure], member.Contour));
    ofWalk.push_back(member.Structure);
  }
  if (SplitPolygons(polygons, this->Walks))
  {
    this->Faces = std::make_unique<PlaneFaces>(this->Walks);
    const LoopWindings windings(this->Walks, *this->Faces);
    this->Sets = std::make_unique<FaceSets>(this->Walks, *this->Faces, windings, ofWalk);
  }
}

std::vector<std::uint8_t> SliceGraph::FindAcrossLines(
  const std::array<std::vector<double>, 3>& planes) const
{
  // Of each face, one of its nodes on each line.
  std::map<std::tuple<Index, int, double>, Index> nodes;
  std::vector<std::uint8_t> found(this->Sets->Count(), 0);
  const int axes[2] = { FirstAxis(this->Plane.Axis), SecondAxis(this->Plane.Axis) };
  for (Index half = 0; half < this->Faces->CountHalfEdges(); ++half)
  {
    const Index node = this->Faces->Tail(half), face = this->Faces->Face(half);
    for (int i = 0; i < 2; ++i)
    {
      const double place = this->Walks.Nodes[node][i];
      if (std::binary_search(planes[axes[i]].begin(), planes[axes[i]].end(), place))
      {
        const Index other = nodes.emplace(std::make_tuple(face, i, place), node).first->second;
        found[face] |= other != node ? 1 : 0;
      }
    }
  }
  return found;
}

void SliceGraph::Trace(const std::function<bool(Index face)>& isInside, Contours& contours) const
{
  std::vector<std::uint8_t> inside;
  for (Index face = 0; face < this->Sets->Count(); ++face)
  {
    inside.push_back(isInside(face) ? 1 : 0);
  }
  for (const TracedLoop& loop : TraceRegion(this->Walks, *this->Faces, inside))
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
    contours.Axis.push_back(static_cast<std::int8_t>(this->Plane.Axis));
    contours.Coordinate.push_back(this->Plane.Coordinate);
    contours.Plane.push_back(0); // to be found
    contours.Cell.push_back(-1);
    contours.Virtual.push_back(this->Plane.IsVirtual ? 1 : 0);
  }
}

/// Appends contours with their flags.
void Append(const Contours& added, Contours& contours)
{
  std::vector<std::uint8_t> flags = std::move(contours.Virtual);
  flags.insert(flags.end(), added.Virtual.begin(), added.Virtual.end());
  contours.Virtual.clear();
  AppendContours(added, contours);
  contours.Virtual = std::move(flags);
}

/// Makes contours of each slice, and appends those of all slices in their order. False if a slice
/// cannot be split.
bool MakeOfSlices(const std::vector<const Contours*>& from, const Execution& execution,
  const std::function<void(SliceGraph& slice, std::vector<Contours>& made)>& make,
  std::vector<Contours>& all)
{
  const std::vector<std::vector<SliceMember>> slices = ListSlices(from);
  std::vector<std::vector<Contours>> made(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        SliceGraph slice(from, slices[i]);
        if (slice.IsSplit())
        {
          made[i].resize(all.size());
          make(slice, made[i]);
        }
      }
    });
  for (const std::vector<Contours>& ofSlice : made)
  {
    if (ofSlice.size() != all.size())
    {
      return false;
    }
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      Append(ofSlice[i], all[i]);
    }
  }
  return true;
}

/// Which contour of each slice has a vertex at a place.
class VertexFinder
{
public:
  explicit VertexFinder(const Contours& contours)
    : From(contours)
  {
    for (Index i = 0; i < contours.Count(); ++i)
    {
      for (Index k = contours.Offsets[i]; k < contours.Offsets[i + 1]; ++k)
      {
        this->Places.push_back({ contours.World(i, k), contours.Axis[i], i });
      }
    }
    std::sort(this->Places.begin(), this->Places.end());
  }

  /// The cell of the contour that has most of the vertices of a contour; -1 if none has any.
  std::int64_t CellOf(const Contours& contours, Index contour) const
  {
    std::map<Index, Index> count;
    for (Index k = contours.Offsets[contour]; k < contours.Offsets[contour + 1]; ++k)
    {
      const Place place{ contours.World(contour, k), contours.Axis[contour], 0 };
      const auto found = std::lower_bound(this->Places.begin(), this->Places.end(), place);
      if (found != this->Places.end() && found->Where == place.Where && found->Axis == place.Axis)
      {
        ++count[found->Contour];
      }
    }
    const auto most = std::max_element(
      count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == count.end() ? -1 : this->From.Cell[most->first];
  }

private:
  struct Place
  {
    Point3 Where;
    int Axis;
    Index Contour;
    bool operator<(const Place& other) const
    {
      return this->Where != other.Where ? this->Where < other.Where
        : this->Axis != other.Axis      ? this->Axis < other.Axis
                                        : this->Contour < other.Contour;
    }
  };

  const Contours& From;
  std::vector<Place> Places;
};
}

std::vector<Contours> NestRegions(const OrderedSets& sets, const Execution& execution,
  const std::vector<const Contours*>& structures)
{
  std::map<std::vector<Index>, std::size_t> numbers;
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    numbers[sets[i]] = i;
  }
  const StructureSets allowed(sets.begin(), sets.end());
  const auto makeRegions = [&](SliceGraph& slice, std::vector<Contours>& made)
  {
    FaceSets& faces = slice.GetSets();
    faces.Reassign(0.0, allowed);
    std::vector<std::size_t> numberOf;
    for (Index face = 0; face < faces.Count(); ++face)
    {
      const auto found = numbers.find(faces[face]);
      numberOf.push_back(found == numbers.end() ? 0 : found->second);
    }
    const std::size_t last = *std::max_element(numberOf.begin(), numberOf.end());
    for (std::size_t i = 0; i < last; ++i)
    {
      slice.Trace([&](Index face) { return numberOf[face] > i; }, made[i]);
    }
  };
  std::vector<Contours> regions(sets.empty() ? 0 : sets.size() - 1);
  return MakeOfSlices(structures, execution, makeRegions, regions) ? regions
                                                                   : std::vector<Contours>();
}

void TakeCells(const Contours& before, Contours& contours)
{
  const VertexFinder finder(before);
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    contours.Cell[contour] = finder.CellOf(contours, contour);
  }
}

bool PartRegions(const RegionParting& parting, const Execution& execution,
  const std::vector<Contours>& regions, const std::vector<Contours*>& structures)
{
  const auto partRegions = [&](SliceGraph& slice, std::vector<Contours>& made)
  {
    FaceSets& faces = slice.GetSets();
    faces.RemoveSlivers(parting.Thickness, slice.FindAcrossLines(parting.Planes));
    std::set<Index> present;
    const auto setOf = [&](Index face) -> const std::vector<Index>&
    { return parting.Sets[faces[face].empty() ? 0 : faces[face].back() + 1]; };
    for (Index face = 0; face < faces.Count(); ++face)
    {
      present.insert(setOf(face).begin(), setOf(face).end());
    }
    for (const Index structure : present)
    {
      const auto isInside = [&](Index face)
      { return std::binary_search(setOf(face).begin(), setOf(face).end(), structure); };
      slice.Trace(isInside, made[structure]);
    }
  };
  std::vector<const Contours*> from;
  for (const Contours& region : regions)
  {
    from.push_back(&region);
  }
  std::vector<Contours> parted(structures.size());
  if (!MakeOfSlices(from, execution, partRegions, parted))
  {
    return false;
  }
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    TakeCells(*structures[i], parted[i]);
    *structures[i] = std::move(parted[i]);
  }
  return true;
}
}
