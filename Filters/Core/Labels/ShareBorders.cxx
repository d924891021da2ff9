// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ShareBorders.h"

#include "Core/Base/EditContours.h"
#include "Core/Base/Vectors.h"
#include "Core/Labels/SnapVertices.h"
#include "Core/Loops/LoopWindings.h"
#include "Core/Loops/TraceRegion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace orthoslices
{
namespace
{
/// A contour of one of several structures.
struct Member
{
  Index Structure;
  Index Contour;
};

/// What becomes of the contours of one slice.
struct SharedSlice
{
  std::vector<std::pair<Index, Contours>> New; ///< all contours of a structure on the slice
  SharedBorders Found;
};

class SliceSharer
{
public:
  SliceSharer(const std::vector<Contours*>& structures, const std::vector<Member>& members,
    double thickness, const StructureSets& allowed)
    : Structures(structures)
    , Members(members)
    , Thickness(thickness)
    , Allowed(allowed)
  {
  }

  SharedSlice Run();

private:
  std::vector<std::vector<Point2>> ReadPolygons();
  void FindSets(const PlaneFaces& faces, const LoopWindings& windings);
  void MeasureFaces(const PlaneWalks& walks, const PlaneFaces& faces, const LoopWindings& windings);
  bool IsSliver(Index face) const;
  void Reassign(const PlaneFaces& faces);
  Index BestNeighbour(Index face, const std::vector<std::uint8_t>& isOpen) const;
  void Report();
  void CountVanished(const LoopWindings& windings);
  void FindJunctions(const PlaneWalks& walks, const PlaneFaces& faces);
  bool HasChanged(Index structure, const PlaneWalks& walks) const;
  std::vector<std::uint8_t> InsideOf(Index structure) const;
  Contours Trace(const PlaneWalks& walks, const PlaneFaces& faces, Index structure) const;

  const std::vector<Contours*>& Structures;
  const std::vector<Member>& Members;
  const double Thickness;
  const StructureSets& Allowed;
  std::vector<std::vector<Index>> Sets, SetsBefore; ///< of each face: the structures that it is in
  std::vector<double> Areas, Lengths;               ///< of each face
  std::vector<std::set<Index>> Beside;              ///< of each face: structures with a side on it
  std::vector<std::map<Index, double>> Common;      ///< lengths of borders with other faces
  std::vector<std::uint8_t> IsOuter;
  std::vector<std::uint8_t> IsMoved; ///< of each member: a vertex was moved onto another contour
  SharedSlice Result;
};

/// The contours, those of each structure moved onto those of structures before it that are as close as
/// slivers are wide.
std::vector<std::vector<Point2>> SliceSharer::ReadPolygons()
{
  std::vector<std::vector<Point2>> polygons;
  double length = 0.0;
  std::size_t sides = 0;
  for (const Member& member : this->Members)
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

void SliceSharer::FindSets(const PlaneFaces& faces, const LoopWindings& windings)
{
  this->Sets.resize(faces.CountFaces());
  for (Index face = 0; face < faces.CountFaces(); ++face)
  {
    std::map<Index, Index> turns; // around the face, of each structure
    for (const LoopWindings::Layer& layer : windings.LayersOf(face))
    {
      turns[this->Members[windings.WalkOf(layer.Part)].Structure] += layer.Winding;
    }
    for (const auto& [structure, count] : turns)
    {
      if (count > 0)
      {
        this->Sets[face].push_back(structure);
      }
    }
  }
  this->SetsBefore = this->Sets;
}

void SliceSharer::MeasureFaces(
  const PlaneWalks& walks, const PlaneFaces& faces, const LoopWindings& windings)
{
  const std::size_t count = static_cast<std::size_t>(faces.CountFaces());
  this->Areas.assign(count, 0.0);
  this->Lengths.assign(count, 0.0);
  this->Beside.resize(count);
  this->Common.resize(count);
  this->IsOuter.assign(count, 0);
  for (Index component = 0; component < faces.CountComponents(); ++component)
  {
    this->IsOuter[faces.OuterFace(component)] = 1;
  }
  for (Index face = 0; face < faces.CountFaces(); ++face)
  {
    this->Areas[face] = std::abs(windings.AreaOfFace(face));
  }
  for (Index half = 0; half < faces.CountHalfEdges(); ++half)
  {
    const Index face = faces.Face(half), other = faces.Face(PlaneFaces::Twin(half));
    const double length = Distance(walks.Nodes[faces.Head(half)], walks.Nodes[faces.Tail(half)]);
    this->Lengths[face] += length;
    this->Common[face][other] += length;
    for (Index i = faces.FirstPassage(half / 2); i < faces.EndOfPassages(half / 2); ++i)
    {
      this->Beside[face].insert(this->Members[faces.PassageAt(i).Walk].Structure);
    }
  }
}

bool SliceSharer::IsSliver(Index face) const
{
  return this->IsOuter[face] == 0 && this->Beside[face].size() > 1 &&
    2.0 * this->Areas[face] <= this->Thickness * this->Lengths[face];
}

/// How many structures, from the first one on, are in both of two sets or in none of them, before one
/// that is in one of them only. REQUIRES: the sets are not the same.
Index AgreeUpTo(const std::vector<Index>& a, const std::vector<Index>& b)
{
  std::vector<Index> different;
  std::set_symmetric_difference(
    a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(different));
  return different.empty() ? std::numeric_limits<Index>::max() : different.front();
}

/// The face beside that is not open itself with the set that agrees for most structures, and of these the
/// one with the longest common border; -1 if there is none.
Index SliceSharer::BestNeighbour(Index face, const std::vector<std::uint8_t>& isOpen) const
{
  Index best = -1;
  std::pair<Index, double> most{ -1, 0.0 };
  for (const auto& [other, length] : this->Common[face])
  {
    if (other == face || isOpen[other] != 0)
    {
      continue;
    }
    const std::pair<Index, double> value{ AgreeUpTo(this->Sets[face], this->Sets[other]), length };
    if (value > most)
    {
      best = other;
      most = value;
    }
  }
  return best;
}

/// Gives slivers, and what no structures may have in common, to neighbours, until none is left that
/// has one.
void SliceSharer::Reassign(const PlaneFaces& faces)
{
  std::vector<std::uint8_t> isOpen(this->Sets.size(), 0);
  for (Index face = 0; face < faces.CountFaces(); ++face)
  {
    const bool isAllowed = this->Allowed.empty() || this->Allowed.count(this->Sets[face]) > 0;
    isOpen[face] = this->IsOuter[face] == 0 && (this->IsSliver(face) || !isAllowed) ? 1 : 0;
    if (isOpen[face] == 0)
    {
      this->Result.Found.Sets.insert(this->Sets[face]);
    }
  }
  bool changed = true;
  while (changed)
  {
    changed = false;
    std::vector<std::pair<Index, Index>> taken;
    for (Index face = 0; face < faces.CountFaces(); ++face)
    {
      const Index neighbour = isOpen[face] != 0 ? this->BestNeighbour(face, isOpen) : -1;
      if (neighbour >= 0)
      {
        taken.emplace_back(face, neighbour);
      }
    }
    for (const auto& [face, neighbour] : taken)
    {
      this->Sets[face] = this->Sets[neighbour];
      isOpen[face] = 0;
      changed = true;
    }
  }
}

void SliceSharer::Report()
{
  CommonAreas& areas = this->Result.Found.Areas;
  areas.OfStructure.assign(this->Structures.size(), 0.0);
  for (std::size_t face = 0; face < this->Sets.size(); ++face)
  {
    const std::vector<Index>& set = this->Sets[face];
    for (std::size_t i = 0; i < set.size() && this->IsOuter[face] == 0; ++i)
    {
      areas.OfStructure[set[i]] += this->Areas[face];
      for (std::size_t j = i + 1; j < set.size(); ++j)
      {
        areas.OfPair[{ set[i], set[j] }] += this->Areas[face];
      }
    }
  }
}

/// Counts contours that have run around something which is their structure's no more, all of it.
void SliceSharer::CountVanished(const LoopWindings& windings)
{
  std::vector<std::uint8_t> isLeft(this->Members.size(), 0);
  for (std::size_t face = 0; face < this->Sets.size(); ++face)
  {
    for (const LoopWindings::Layer& layer : windings.LayersOf(static_cast<Index>(face)))
    {
      const Index member = windings.WalkOf(layer.Part);
      const std::vector<Index>& set = this->Sets[face];
      isLeft[member] |= layer.Winding > 0 &&
          std::binary_search(set.begin(), set.end(), this->Members[member].Structure)
        ? 1
        : 0;
    }
  }
  this->Result.Found.Vanished.assign(this->Structures.size(), 0);
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    const Member& member = this->Members[i];
    const bool isOutline =
      TwiceSignedArea(*this->Structures[member.Structure], member.Contour) > 0.0;
    this->Result.Found.Vanished[member.Structure] += isOutline && isLeft[i] == 0 ? 1 : 0;
  }
}

/// The nodes at which more than two sides meet.
void SliceSharer::FindJunctions(const PlaneWalks& walks, const PlaneFaces& faces)
{
  const Contours& contours = *this->Structures[this->Members.front().Structure];
  const int axis = contours.Axis[this->Members.front().Contour];
  for (std::size_t node = 0; node < walks.Nodes.size(); ++node)
  {
    if (faces.Leaving(static_cast<Index>(node)).size() > 2)
    {
      Point3 place;
      place[axis] = contours.Coordinate[this->Members.front().Contour];
      place[FirstAxis(axis)] = walks.Nodes[node][0];
      place[SecondAxis(axis)] = walks.Nodes[node][1];
      this->Result.Found.Junctions.insert(place);
    }
  }
}

/// Whether contours of a structure have vertices that they had not, or another interior.
bool SliceSharer::HasChanged(Index structure, const PlaneWalks& walks) const
{
  for (std::size_t i = 0; i < this->Members.size(); ++i)
  {
    const Contours& contours = *this->Structures[structure];
    if (this->Members[i].Structure == structure &&
      (this->IsMoved[i] != 0 ||
        static_cast<Index>(walks.Walks[i].size()) != contours.Size(this->Members[i].Contour)))
    {
      return true;
    }
  }
  const auto contains = [structure](const std::vector<Index>& set)
  { return std::binary_search(set.begin(), set.end(), structure); };
  for (std::size_t face = 0; face < this->Sets.size(); ++face)
  {
    if (contains(this->Sets[face]) != contains(this->SetsBefore[face]))
    {
      return true;
    }
  }
  return false;
}

/// 1 for the faces that are inside a structure; inside any, if it is -1.
std::vector<std::uint8_t> SliceSharer::InsideOf(Index structure) const
{
  std::vector<std::uint8_t> inside;
  for (const std::vector<Index>& set : this->Sets)
  {
    const bool isIn =
      structure < 0 ? !set.empty() : std::binary_search(set.begin(), set.end(), structure);
    inside.push_back(isIn ? 1 : 0);
  }
  return inside;
}

/// The contours of a structure, or those around all of them, if it is -1. They are contours of the input
/// if these are of that structure.
Contours SliceSharer::Trace(const PlaneWalks& walks, const PlaneFaces& faces, Index structure) const
{
  Index first = -1; // contour of the structure
  for (auto member = this->Members.rbegin(); member != this->Members.rend(); ++member)
  {
    first = member->Structure == structure ? member->Contour : first;
  }
  const Contours& from = *this->Structures[std::max<Index>(structure, 0)];
  const Member& any = this->Members.front();
  Contours made;
  for (const TracedLoop& loop : TraceRegion(walks, faces, this->InsideOf(structure)))
  {
    if (loop.Points.size() < 3)
    {
      continue;
    }
    const Member& drawn = this->Members[loop.Walk];
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

SharedSlice SliceSharer::Run()
{
  PlaneWalks walks;
  if (!SplitPolygons(this->ReadPolygons(), walks))
  {
    return std::move(this->Result);
  }
  const PlaneFaces faces(walks);
  const LoopWindings windings(walks, faces);
  this->FindSets(faces, windings);
  this->MeasureFaces(walks, faces, windings);
  this->Reassign(faces);
  this->Report();
  this->CountVanished(windings);
  this->FindJunctions(walks, faces);
  this->Result.Found.Union = this->Trace(walks, faces, -1);
  for (Index structure = 0; structure < static_cast<Index>(this->Structures.size()); ++structure)
  {
    if (this->HasChanged(structure, walks))
    {
      this->Result.New.emplace_back(structure, this->Trace(walks, faces, structure));
    }
  }
  return std::move(this->Result);
}

/// The contours of all structures by slice.
std::vector<std::vector<Member>> ListSlices(const std::vector<Contours*>& structures)
{
  std::map<std::pair<int, double>, std::vector<Member>> slices;
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    const Contours& contours = *structures[i];
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      slices[{ contours.Axis[contour], contours.Coordinate[contour] }].push_back(
        { static_cast<Index>(i), contour });
    }
  }
  std::vector<std::vector<Member>> list;
  for (auto& slice : slices)
  {
    list.push_back(std::move(slice.second));
  }
  return list;
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
  const Execution& execution, const std::vector<Contours*>& structures)
{
  const std::vector<std::vector<Member>> slices = ListSlices(structures);
  std::vector<SharedSlice> shared(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        shared[i] = SliceSharer(structures, slices[i], thickness, allowed).Run();
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
      for (const Member& member : slices[i])
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
