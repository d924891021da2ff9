// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/FaceSets.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace orthoslices
{
namespace
{
/// How many structures, from the first one on, are in both of two sets or in none of them, before
/// one that is in one of them only. REQUIRES: the sets are not the same.
Index AgreeUpTo(const std::vector<Index>& a, const std::vector<Index>& b)
{
  std::vector<Index> different;
  std::set_symmetric_difference(
    a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(different));
  return different.empty() ? std::numeric_limits<Index>::max() : different.front();
}
}

FaceSets::FaceSets(const PlaneWalks& walks, const PlaneFaces& faces, const LoopWindings& windings,
  const std::vector<Index>& structures)
  : Sets(faces.CountFaces())
{
  this->FindSets(windings, structures);
  this->MeasureFaces(walks, faces, windings, structures);
}

void FaceSets::FindSets(const LoopWindings& windings, const std::vector<Index>& structures)
{
  for (Index face = 0; face < this->Count(); ++face)
  {
    std::map<Index, Index> turns; // around the face, of each structure
    for (const LoopWindings::Layer& layer : windings.LayersOf(face))
    {
      turns[structures[windings.WalkOf(layer.Part)]] += layer.Winding;
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

void FaceSets::MeasureFaces(const PlaneWalks& walks, const PlaneFaces& faces,
  const LoopWindings& windings, const std::vector<Index>& structures)
{
  const std::size_t count = static_cast<std::size_t>(faces.CountFaces());
  this->Areas.assign(count, 0.0);
  this->Lengths.assign(count, 0.0);
  this->Beside.resize(count);
  this->Common.resize(count);
  this->OuterFaces.assign(count, 0);
  for (Index component = 0; component < faces.CountComponents(); ++component)
  {
    this->OuterFaces[faces.OuterFace(component)] = 1;
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
      this->Beside[face].insert(structures[faces.PassageAt(i).Walk]);
    }
  }
}

bool FaceSets::IsSliver(Index face, double thickness) const
{
  return !this->IsOuter(face) && this->Beside[face].size() > 1 &&
    2.0 * this->Areas[face] <= thickness * this->Lengths[face];
}

/// The face beside that is not open itself with the set that agrees for most structures, and of
/// these the one with the longest common border; -1 if there is none.
Index FaceSets::BestNeighbour(Index face, const std::vector<std::uint8_t>& isOpen) const
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

/// Gives open faces to neighbours, until none is left that has one.
void FaceSets::FillOpen(std::vector<std::uint8_t>& isOpen)
{
  bool changed = true;
  while (changed)
  {
    changed = false;
    std::vector<std::pair<Index, Index>> taken;
    for (Index face = 0; face < this->Count(); ++face)
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

StructureSets FaceSets::Reassign(double thickness, const StructureSets& allowed)
{
  StructureSets kept;
  std::vector<std::uint8_t> isOpen(this->Sets.size(), 0);
  for (Index face = 0; face < this->Count(); ++face)
  {
    const bool isAllowed = allowed.empty() || allowed.count(this->Sets[face]) > 0;
    isOpen[face] = !this->IsOuter(face) && (this->IsSliver(face, thickness) || !isAllowed) ? 1 : 0;
    if (isOpen[face] == 0)
    {
      kept.insert(this->Sets[face]);
    }
  }
  this->FillOpen(isOpen);
  return kept;
}

void FaceSets::Replace(const std::map<std::vector<Index>, std::vector<Index>>& replaced)
{
  for (std::vector<Index>& set : this->Sets)
  {
    const auto found = replaced.find(set);
    if (found != replaced.end())
    {
      set = found->second;
    }
  }
}

void FaceSets::RemoveSlivers(double thickness, const std::vector<std::uint8_t>& isKept)
{
  std::vector<std::uint8_t> isOpen;
  for (Index face = 0; face < this->Count(); ++face)
  {
    isOpen.push_back(isKept[face] == 0 && this->IsSliver(face, thickness) ? 1 : 0);
  }
  this->FillOpen(isOpen);
}

std::vector<std::uint8_t> FaceSets::InsideOf(Index structure) const
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
}
