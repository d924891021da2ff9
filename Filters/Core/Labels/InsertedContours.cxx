// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/InsertedContours.h"

#include "Core/Labels/FaceSets.h"
#include "Core/Labels/SliceMembers.h"

#include <algorithm>
#include <iterator>

namespace orthoslices
{
namespace
{
using Structures = std::vector<const Contours*>;
using Members = std::vector<SliceMember>;

bool IsInserted(const Structures& structures, const SliceMember& member)
{
  return structures[member.Structure]->Cell[member.Contour] < 0;
}

/// Which structures places of a slice have; those of inserted contours are structures of their own,
/// after all others.
StructureSets FindSets(double thickness, const Structures& structures, const Members& members)
{
  std::vector<std::vector<Point2>> polygons;
  std::vector<Index> ofWalk;
  for (const SliceMember& member : members)
  {
    polygons.push_back(PolygonOf(*structures[member.Structure], member.Contour));
    ofWalk.push_back(member.Structure +
      (IsInserted(structures, member) ? static_cast<Index>(structures.size()) : 0));
  }
  PlaneWalks walks;
  if (!SplitPolygons(polygons, walks))
  {
    return {};
  }
  const PlaneFaces faces(walks);
  return FaceSets(walks, faces, LoopWindings(walks, faces), ofWalk).Reassign(thickness, {});
}

/// The structures that are at a place if the inserted contours are right.
std::vector<Index> Together(const std::vector<Index>& set, Index count)
{
  std::set<Index> together;
  for (const Index structure : set)
  {
    together.insert(structure % count);
  }
  return { together.begin(), together.end() };
}
}

std::vector<std::vector<std::uint8_t>> FindContradictedInsertions(
  double thickness, const Structures& structures, const Execution& execution)
{
  const Index count = static_cast<Index>(structures.size());
  std::vector<std::vector<std::uint8_t>> marked;
  bool any = false;
  for (const Contours* contours : structures)
  {
    marked.emplace_back(contours->Count(), 0);
    any |= std::any_of(
      contours->Cell.begin(), contours->Cell.end(), [](std::int64_t cell) { return cell < 0; });
  }
  if (!any)
  {
    return marked;
  }
  const std::vector<Members> slices = ListSlices(structures);
  std::vector<StructureSets> sets(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        sets[i] = FindSets(thickness, structures, slices[i]);
      }
    });
  StructureSets drawn;
  for (const StructureSets& ofSlice : sets)
  {
    std::copy_if(ofSlice.begin(), ofSlice.end(), std::inserter(drawn, drawn.end()),
      [count](const std::vector<Index>& set) { return set.empty() || set.back() < count; });
  }
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    std::set<Index> contradicted;
    for (const std::vector<Index>& set : sets[i])
    {
      const std::vector<Index> together = Together(set, count);
      if (together.size() > 1 && drawn.count(together) == 0)
      {
        contradicted.insert(together.begin(), together.end());
      }
    }
    for (const SliceMember& member : slices[i])
    {
      marked[member.Structure][member.Contour] =
        IsInserted(structures, member) && contradicted.count(member.Structure) > 0 ? 1 : 0;
    }
  }
  return marked;
}
}
