// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ShareBorders.h"

#include "Core/Base/EditContours.h"
#include "Core/Base/Vectors.h"
#include "Core/Labels/FaceSets.h"
#include "Core/Labels/SliceMembers.h"
#include "Core/Labels/SnapVertices.h"
#include "Core/Loops/TraceRegion.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// What becomes of the contours of one slice.
struct SharedSlice
{
  std::vector<std::pair<Index, Contours>> New; ///< all contours of a structure on the slice
  SharedBorders Found;
};

class SliceSharer
{
public:
  SliceSharer(const std::vector<Contours*>& structures, const std::vector<SliceMember>& members,
    double thickness, const StructureSets& allowed, const SetReplacements& replaced)
    : Structures(structures)
    , Members(members)
    , Thickness(thickness)
    , Allowed(allowed)
    , Replaced(replaced)
  {
  }

  SharedSlice Run();

private:
  void Replace(FaceSets& sets) const;
  std::vector<std::vector<Point2>> ReadPolygons();
  void Report(const FaceSets& sets);
  void CountVanished(const LoopWindings& windings, const FaceSets& sets);
  void AddJunction(const Point2& place);
  void FindJunctions(const PlaneWalks& walks, const PlaneFaces& faces);
  void AddParted(const PlaneWalks& walks, const std::vector<std::vector<TracedLoop>>& regions);
  bool HasChanged(Index structure, const PlaneWalks& walks, const FaceSets& sets) const;
  Contours ListContours(const std::vector<TracedLoop>& loops, Index structure) const;

  const std::vector<Contours*>& Structures;
  const std::vector<SliceMember>& Members;
  const double Thickness;
  const StructureSets& Allowed;
  const SetReplacements& Replaced;
  std::vector<std::uint8_t> IsMoved; ///< of each member: a vertex was moved onto another contour
  SharedSlice Result;
};

/// The contours, those of each structure moved onto those of structures before it that are as close
/// as slivers are wide.
std::vector<std::vector<Point2>> SliceSharer::ReadPolygons()
{
  std::vector<std::vector<Point2>> polygons;
  double length = 0.0;
  std::size_t sides = 0;
  for (const SliceMember& member : this->Members)
  {
    const Contours& contours = *this->Structures[member.Structure];
    std::vector<Point2> polygon;
    for (Index i = contours.Offsets[member.Contour]; i < contours.Offsets[member.Contour + 1]; ++i)
    {
      polygon.push_back({ contours.U[i], contours.V[i] });
      length += polygon.size() > 1 ? Distance(polygon.back(), polygon[polygon.size() - 2]) : 0.0;
      ++sides;
    }
    polygons.push_back(std::move(polygon));
  }
  this->IsMoved.assign(polygons.size(), 0);
  SnapTarget earlier(this->Thickness, length / static_cast<double>(sides));
  for (std::size_t first = 0, last = 0; first < polygons.size(); first = last)
  {
    for (;
         last < polygons.size() && this->Members[last].Structure == this->Members[first].Structure;
         ++last)
    {
      for (Point2& corner : polygons[last])
      {
        this->IsMoved[last] |= earlier.Snap(corner) ? 1 : 0;
      }
    }
    std::for_each(polygons.begin() + first, polygons.begin() + last,
      [&](const std::vector<Point2>& polygon) { earlier.Add(polygon); });
  }
  return polygons;
}

void SliceSharer::Report(const FaceSets& sets)
{
  CommonAreas& areas = this->Result.Found.Areas;
  areas.OfStructure.assign(this->Structures.size(), 0.0);
  for (Index face = 0; face < sets.Count(); ++face)
  {
    const std::vector<Index>& set = sets[face];
    for (std::size_t i = 0; i < set.size() && !sets.IsOuter(face); ++i)
    {
      areas.OfStructure[set[i]] += sets.AreaOf(face);
      for (std::size_t j = i + 1; j < set.size(); ++j)
      {
        areas.OfPair[{ set[i], set[j] }] += sets.AreaOf(face);
      }
    }
  }
}

/// Counts contours that have run around something which is their structure's no more, all of it.
void SliceSharer::CountVanished(const LoopWindings& windings, const FaceSets& sets)
{
  std::vector<std::uint8_t> isLeft(this->Members.size(), 0);
  for (Index face = 0; face < sets.Count(); ++face)
  {
    for (const LoopWindings::Layer& layer : windings.LayersOf(face))
    {
      const Index member = windings.WalkOf(layer.Part);
      const std::vector<Index>& set = sets[face];
      isLeft[member] |= layer.Winding > 0 &&
          std::binary_search(set.begin(), set.end(), this->Members[member].Structure)
        ? 1
        : 0;
    }
  }
  this->Result.Found.Vanished.assign(this->Structures.size(), 0);
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    const SliceMember& member = this->Members[i];
    const bool isOutline =
      TwiceSignedArea(*this->Structures[member.Structure], member.Contour) > 0.0;
    this->Result.Found.Vanished[member.Structure] += isOutline && isLeft[i] == 0 ? 1 : 0;
  }
}

void SliceSharer::AddJunction(const Point2& place)
{
  const Contours& contours = *this->Structures[this->Members.front().Structure];
  const int axis = contours.Axis[this->Members.front().Contour];
  Point3 point;
  point[axis] = contours.Coordinate[this->Members.front().Contour];
  point[FirstAxis(axis)] = place[0];
  point[SecondAxis(axis)] = place[1];
  this->Result.Found.Junctions.insert(point);
}

/// The nodes at which more than two sides meet.
void SliceSharer::FindJunctions(const PlaneWalks& walks, const PlaneFaces& faces)
{
  for (std::size_t node = 0; node < walks.Nodes.size(); ++node)
  {
    if (faces.Leaving(static_cast<Index>(node)).size() > 2)
    {
      this->AddJunction(walks.Nodes[node]);
    }
  }
}

/// Whether loops have other points than the nodes that they pass: corners were cut off there.
bool IsParted(const std::vector<TracedLoop>& loops)
{
  return std::any_of(loops.begin(), loops.end(),
    [](const TracedLoop& loop) { return loop.Points.size() != loop.HalfEdges.size(); });
}

/// There contours part, too.
void SliceSharer::AddParted(
  const PlaneWalks& walks, const std::vector<std::vector<TracedLoop>>& regions)
{
  if (std::none_of(regions.begin(), regions.end(), IsParted))
  {
    return;
  }
  const std::set<Point2> nodes(walks.Nodes.begin(), walks.Nodes.end());
  for (const std::vector<TracedLoop>& loops : regions)
  {
    for (const TracedLoop& loop : loops)
    {
      for (const Point2& point : loop.Points)
      {
        if (nodes.count(point) == 0)
        {
          this->AddJunction(point);
        }
      }
    }
  }
}

/// Whether a walk passes a node more than once.
bool TouchesItself(std::vector<Index> walk)
{
  std::sort(walk.begin(), walk.end());
  return std::adjacent_find(walk.begin(), walk.end()) != walk.end();
}

/// Whether contours of a structure have vertices that they had not, or another interior.
bool SliceSharer::HasChanged(Index structure, const PlaneWalks& walks, const FaceSets& sets) const
{
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    const Contours& contours = *this->Structures[structure];
    if (this->Members[i].Structure == structure &&
      (this->IsMoved[i] != 0 ||
        static_cast<Index>(walks.Walks[i].size()) != contours.Size(this->Members[i].Contour) ||
        TouchesItself(walks.Walks[i])))
    {
      return true;
    }
  }
  const auto contains = [structure](const std::vector<Index>& set)
  { return std::binary_search(set.begin(), set.end(), structure); };
  for (Index face = 0; face < sets.Count(); ++face)
  {
    if (contains(sets[face]) != contains(sets.Before(face)))
    {
      return true;
    }
  }
  return false;
}

/// The contours of a structure, or those around all of them, if it is -1. They are contours of the
/// input if these are of that structure.
Contours SliceSharer::ListContours(const std::vector<TracedLoop>& loops, Index structure) const
{
  Index first = -1; // contour of the structure
  for (auto member = this->Members.rbegin(); member != this->Members.rend(); ++member)
  {
    first = member->Structure == structure ? member->Contour : first;
  }
  const Contours& from = *this->Structures[std::max<Index>(structure, 0)];
  const SliceMember& any = this->Members.front();
  Contours made;
  for (const TracedLoop& loop : loops)
  {
    if (loop.Points.size() < 3)
    {
      continue;
    }
    const SliceMember& drawn = this->Members[loop.Walk];
    const Index source = drawn.Structure == structure ? drawn.Contour : first;
    for (const Point2& p : loop.Points)
    {
      made.U.push_back(p[0]);
      made.V.push_back(p[1]);
    }
    made.Offsets.push_back(static_cast<Index>(made.U.size()));
    made.Axis.push_back(this->Structures[any.Structure]->Axis[any.Contour]);
    made.Coordinate.push_back(this->Structures[any.Structure]->Coordinate[any.Contour]);
    made.Plane.push_back(source < 0 ? 0 : from.Plane[source]);
    made.Cell.push_back(source < 0 ? -1 : from.Cell[source]);
    made.Virtual.push_back(source >= 0 && from.IsVirtual(source) ? 1 : 0);
  }
  return made;
}

void SliceSharer::Replace(FaceSets& sets) const
{
  const Contours& contours = *this->Structures[this->Members.front().Structure];
  const Index contour = this->Members.front().Contour;
  const auto found = this->Replaced.find({ contours.Axis[contour], contours.Coordinate[contour] });
  if (found != this->Replaced.end())
  {
    sets.Replace(found->second);
  }
}

SharedSlice SliceSharer::Run()
{
  PlaneWalks walks;
  if (!SplitPolygons(this->ReadPolygons(), walks))
  {
    return std::move(this->Result);
  }
  const PlaneFaces faces(walks);
  const LoopWindings windings(walks, faces);
  std::vector<Index> structures; // of each walk
  for (const SliceMember& member : this->Members)
  {
    structures.push_back(member.Structure);
  }
  FaceSets sets(walks, faces, windings, structures);
  this->Replace(sets);
  this->Result.Found.Sets = sets.Reassign(this->Thickness, this->Allowed);
  this->Report(sets);
  this->CountVanished(windings, sets);
  this->FindJunctions(walks, faces);
  this->Result.Found.Union = this->ListContours(TraceRegion(walks, faces, sets.InsideOf(-1)), -1);
  std::vector<std::vector<std::uint8_t>> insides;
  for (Index structure = 0; structure < static_cast<Index>(this->Structures.size()); ++structure)
  {
    insides.push_back(sets.InsideOf(structure));
  }
  const std::vector<std::vector<TracedLoop>> loops = TraceRegions(walks, faces, insides);
  this->AddParted(walks, loops);
  for (Index structure = 0; structure < static_cast<Index>(this->Structures.size()); ++structure)
  {
    if (IsParted(loops[structure]) || this->HasChanged(structure, walks, sets))
    {
      this->Result.New.emplace_back(structure, this->ListContours(loops[structure], structure));
    }
  }
  return std::move(this->Result);
}

/// Appends contours that are virtual where they say so.
void AppendWithFlags(const Contours& added, Contours& contours)
{
  std::vector<std::uint8_t> flags = contours.Virtual;
  flags.resize(contours.Axis.size(), 0);
  for (Index i = 0; i < added.Count(); ++i)
  {
    flags.push_back(added.IsVirtual(i) ? 1 : 0);
  }
  AppendContours(added, contours);
  const bool anyVirtual = std::find(flags.begin(), flags.end(), 1) != flags.end();
  contours.Virtual = anyVirtual ? std::move(flags) : std::vector<std::uint8_t>();
}

void AddTo(const SharedBorders& slice, SharedBorders& all)
{
  all.Sets.insert(slice.Sets.begin(), slice.Sets.end());
  AppendContours(slice.Union, all.Union);
  all.Junctions.insert(slice.Junctions.begin(), slice.Junctions.end());
  for (std::size_t i = 0; i < slice.Areas.OfStructure.size(); ++i)
  {
    all.Areas.OfStructure[i] += slice.Areas.OfStructure[i];
  }
  for (std::size_t i = 0; i < slice.Vanished.size(); ++i)
  {
    all.Vanished[i] += slice.Vanished[i];
  }
  for (const auto& [pair, area] : slice.Areas.OfPair)
  {
    all.Areas.OfPair[pair] += area;
  }
}
}

SharedBorders ShareBorders(double thickness, const StructureSets& allowed,
  const Execution& execution, const std::vector<Contours*>& structures,
  const SetReplacements& replaced)
{
  const std::vector<std::vector<SliceMember>> slices =
    ListSlices({ structures.begin(), structures.end() });
  std::vector<SharedSlice> shared(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        shared[i] = SliceSharer(structures, slices[i], thickness, allowed, replaced).Run();
      }
    });
  SharedBorders all;
  all.Areas.OfStructure.assign(structures.size(), 0.0);
  all.Vanished.assign(structures.size(), 0);
  std::vector<std::vector<std::uint8_t>> isReplaced;
  for (const Contours* contours : structures)
  {
    isReplaced.emplace_back(contours->Count(), 0);
  }
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    AddTo(shared[i].Found, all);
    for (const auto& made : shared[i].New)
    {
      for (const SliceMember& member : slices[i])
      {
        if (member.Structure == made.first)
        {
          isReplaced[member.Structure][member.Contour] = 1;
        }
      }
    }
  }
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    RemoveMarked(isReplaced[i], *structures[i]);
  }
  for (SharedSlice& slice : shared)
  {
    for (auto& made : slice.New)
    {
      AppendWithFlags(made.second, *structures[made.first]);
    }
  }
  return all;
}
}
