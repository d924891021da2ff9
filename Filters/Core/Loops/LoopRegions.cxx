// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/LoopRegions.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;
}

LoopRegions::LoopRegions(const LoopWindings& windings)
  : Windings(windings)
  , Graph(windings.GetGraph())
{
  this->FindContainers();
  this->FindRepeated();
  this->RemoveRepeated();
}

bool LoopRegions::Contains(Index outer, Index inner) const
{
  const std::vector<Index>& containers = this->Containers[inner];
  return std::binary_search(containers.begin(), containers.end(), outer);
}

/// A part is contained in those that surround all of its area but for a little; but not two parts
/// in each other.
void LoopRegions::FindContainers()
{
  std::map<std::pair<Index, Index>, double> common;
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    for (const LoopWindings::Layer& inner : this->Windings.LayersOf(face))
    {
      for (const LoopWindings::Layer& outer : this->Windings.LayersOf(face))
      {
        if (inner.Part != outer.Part && this->Windings.IsAtHome(inner.Part, face))
        {
          common[{ inner.Part, outer.Part }] += this->Windings.AreaOfFace(face);
        }
      }
    }
  }
  const auto isWithin = [&](Index inner, Index outer)
  {
    const auto entry = common.find({ inner, outer });
    return entry != common.end() &&
      entry->second >= (1.0 - LittleShare) * this->Windings.AreaOf(inner);
  };
  this->Containers.resize(this->Windings.CountParts());
  for (const auto& entry : common)
  {
    const Index inner = entry.first.first;
    const Index outer = entry.first.second;
    if (isWithin(inner, outer) && !isWithin(outer, inner))
    {
      this->Containers[inner].push_back(outer);
    }
  }
}

void LoopRegions::FindRepeated()
{
  const Index parts = this->Windings.CountParts();
  this->IsRepeated.assign(parts, 0);
  std::vector<double> length(parts, 0.0);
  std::map<std::pair<Index, Index>, double> common; // of two parts, the interior on the same side
  for (Index edge = 0; edge < this->Graph.CountHalfEdges() / 2; ++edge)
  {
    const LoopWindings::Layers& left = this->Windings.LayersOf(this->Graph.Face(2 * edge));
    const auto isLeft = [&](Index part)
    {
      return std::any_of(left.begin(), left.end(),
        [&](const LoopWindings::Layer& layer) { return layer.Part == part; });
    };
    const double more = this->Windings.LengthOf(edge);
    for (Index i = this->Graph.FirstPassage(edge); i < this->Graph.EndOfPassages(edge); ++i)
    {
      const Index part = this->Windings.PartOf(i);
      if (part == None)
      {
        continue;
      }
      length[part] += more;
      for (Index j = this->Graph.FirstPassage(edge); j < i; ++j)
      {
        const Index other = this->Windings.PartOf(j);
        if (other != None && isLeft(part) == isLeft(other))
        {
          common[{ part, other }] += more;
          common[{ other, part }] += more;
        }
      }
    }
  }
  for (const auto& entry : common)
  {
    const Index part = entry.first.first;
    if (this->Contains(entry.first.second, part) && 3.0 * entry.second > 2.0 * length[part])
    {
      this->IsRepeated[part] = 1;
    }
  }
}

/// Leaves the parts out of consideration that repeat others.
void LoopRegions::RemoveRepeated()
{
  for (Index part = 0; part < this->Windings.CountParts(); ++part)
  {
    std::vector<Index>& containers = this->Containers[part];
    containers.erase(std::remove_if(containers.begin(), containers.end(),
                       [this](Index other) { return this->IsRepeated[other] != 0; }),
      containers.end());
  }
}

/// How many parts, each within the next one, are around each part at most.
std::vector<Index> LoopRegions::FindLevels() const
{
  std::vector<Index> order(this->Windings.CountParts());
  std::iota(order.begin(), order.end(), 0);
  // Containers are larger.
  std::stable_sort(order.begin(), order.end(),
    [this](Index a, Index b) { return this->Windings.AreaOf(a) > this->Windings.AreaOf(b); });
  std::vector<Index> levels(order.size(), 0);
  for (const Index part : order)
  {
    for (const Index container : this->Containers[part])
    {
      levels[part] = std::max(levels[part], levels[container] + 1);
    }
  }
  return levels;
}

/// Where the number of turns counts, a part that makes several ones around everything makes one.
std::vector<Index> LoopRegions::SumWindings(LoopRule rule) const
{
  std::vector<Index> sums;
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    const LoopWindings::Layers& layers = this->Windings.LayersOf(face);
    sums.push_back(std::accumulate(layers.begin(), layers.end(), Index(0),
      [&](Index sum, const LoopWindings::Layer& layer)
      {
        const Index turns = rule == LoopRule::EvenOdd ? this->Windings.TurnsOf(layer.Part) : 1;
        return sum + layer.Winding / turns;
      }));
  }
  return sums;
}

std::vector<std::uint8_t> LoopRegions::FindInside(LoopRule rule) const
{
  const std::vector<Index> sums = this->SumWindings(rule);
  const std::vector<Index> levels = this->FindLevels();
  std::vector<std::uint8_t> inside(sums.size(), 0);
  for (std::size_t face = 0; face < inside.size(); ++face)
  {
    const LoopWindings::Layers& layers = this->Windings.LayersOf(face);
    const auto isHoleOf = [&](Index outline, Index hole)
    { return levels[hole] % 2 != 0 && this->Contains(outline, hole); };
    const auto isInOutline = [&](const LoopWindings::Layer& outline)
    {
      return levels[outline.Part] % 2 == 0 && !this->IsRepeated[outline.Part] &&
        std::none_of(layers.begin(), layers.end(),
          [&](const LoopWindings::Layer& hole) { return isHoleOf(outline.Part, hole.Part); });
    };
    inside[face] = rule == LoopRule::Union ? std::any_of(layers.begin(), layers.end(), isInOutline)
      : rule == LoopRule::EvenOdd          ? sums[face] % 2 != 0
                                           : sums[face] != 0;
  }
  return inside;
}

std::vector<std::uint8_t> LoopRegions::FindInsideAsDrawn(LoopRule rule, bool insideOut) const
{
  std::vector<std::uint8_t> inside;
  for (const Index sum : this->SumWindings(rule))
  {
    const bool isIn = rule == LoopRule::EvenOdd ? (sum % 2 != 0) != insideOut
      : insideOut                               ? sum >= 0
                                                : sum > 0;
    inside.push_back(isIn ? 1 : 0);
  }
  return inside;
}

}
