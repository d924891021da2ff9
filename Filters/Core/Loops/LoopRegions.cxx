// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/LoopRegions.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;
/// What does not count of an area: noise makes contours cross by about that.
constexpr double LittleArea = 0.02;
/// What noise leaves in all lobes of a contour together, by its area without them, is less than that.
constexpr double MostInLobes = 0.25;
}

LoopRegions::LoopRegions(const PlaneWalks& walks, const PlaneFaces& faces)
  : Walks(walks)
  , Graph(faces)
{
  this->FindParts();
  this->SpreadWindings();
  this->AddSurrounding();
  this->MeasureFaces();
  this->FindContainers();
  this->FindRepeated();
  this->RemoveRepeated();
}

void LoopRegions::FindParts()
{
  const Index passages = this->Graph.CountPassages();
  this->PartOfPassage.assign(passages, None);
  this->Net.assign(passages, 0);
  this->EdgeOfPassage.assign(passages, None);
  std::vector<std::vector<Index>> ofWalk(this->Walks.Walks.size());
  for (Index edge = 0; edge < this->Graph.CountHalfEdges() / 2; ++edge)
  {
    for (Index i = this->Graph.FirstPassage(edge); i < this->Graph.EndOfPassages(edge); ++i)
    {
      this->EdgeOfPassage[i] = edge;
      this->Net[i] = this->Graph.PassageAt(i).Net;
      if (this->Net[i] != 0)
      {
        ofWalk[this->Graph.PassageAt(i).Walk].push_back(i);
      }
    }
  }
  for (const std::vector<Index>& passagesOfWalk : ofWalk)
  {
    this->AddParts(passagesOfWalk);
  }
}

/// Numbers a part: all of a walk's passages that are connected with the first one. `at` has them by
/// nodes.
void LoopRegions::AddPart(Index start, const std::vector<std::pair<Index, Index>>& at)
{
  const Index part = this->CountParts();
  std::vector<Index> found{ start };
  this->PartOfPassage[start] = part;
  Index divisor = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    divisor = std::gcd(divisor, std::abs(this->Net[found[i]]));
    const Index halfEdge = 2 * this->EdgeOfPassage[found[i]];
    for (const Index node : { this->Graph.Head(halfEdge), this->Graph.Tail(halfEdge) })
    {
      for (auto next = std::lower_bound(at.begin(), at.end(), std::make_pair(node, Index(0)));
           next != at.end() && next->first == node; ++next)
      {
        if (this->PartOfPassage[next->second] == None)
        {
          this->PartOfPassage[next->second] = part;
          found.push_back(next->second);
        }
      }
    }
  }
  this->TurnsOfPart.push_back(divisor);
  this->WalkOfPart.push_back(this->Graph.PassageAt(start).Walk);
  this->ComponentOfPart.push_back(
    this->Graph.ComponentOfNode(this->Graph.Head(2 * this->EdgeOfPassage[start])));
}

/// Groups passages of one walk that are connected.
void LoopRegions::AddParts(const std::vector<Index>& passages)
{
  std::vector<std::pair<Index, Index>> at;
  for (const Index passage : passages)
  {
    const Index halfEdge = 2 * this->EdgeOfPassage[passage];
    at.emplace_back(this->Graph.Head(halfEdge), passage);
    at.emplace_back(this->Graph.Tail(halfEdge), passage);
  }
  std::sort(at.begin(), at.end());
  for (const Index start : passages)
  {
    if (this->PartOfPassage[start] == None)
    {
      this->AddPart(start, at);
    }
  }
}

/// The layers on the left of a half-edge, from those on its right.
LoopRegions::Layers LoopRegions::Step(const Layers& layers, Index halfEdge) const
{
  Layers result = layers;
  const Index sign = halfEdge % 2 == 0 ? 1 : -1;
  const Index edge = halfEdge / 2;
  for (Index i = this->Graph.FirstPassage(edge); i < this->Graph.EndOfPassages(edge); ++i)
  {
    const Index part = this->PartOfPassage[i];
    if (part == None)
    {
      continue;
    }
    const auto place = std::lower_bound(result.begin(), result.end(), part,
      [](const Layer& layer, Index number) { return layer.Part < number; });
    if (place == result.end() || place->Part != part)
    {
      result.insert(place, { part, sign * this->Net[i] });
      continue;
    }
    place->Winding += sign * this->Net[i];
    if (place->Winding == 0)
    {
      result.erase(place);
    }
  }
  return result;
}

/// Winding numbers from the outer face of each component inwards, face by face.
void LoopRegions::SpreadWindings()
{
  const Index faces = this->Graph.CountFaces();
  this->LayersOf.resize(faces);
  std::vector<std::vector<Index>> borders(faces);
  for (Index halfEdge = 0; halfEdge < this->Graph.CountHalfEdges(); ++halfEdge)
  {
    borders[this->Graph.Face(halfEdge)].push_back(halfEdge);
  }
  std::vector<std::uint8_t> isKnown(faces, 0);
  std::vector<Index> front;
  for (Index component = 0; component < this->Graph.CountComponents(); ++component)
  {
    front.push_back(this->Graph.OuterFace(component));
    isKnown[front.back()] = 1;
  }
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    for (const Index border : borders[front[i]])
    {
      const Index other = PlaneFaces::Twin(border);
      const Index face = this->Graph.Face(other);
      if (!isKnown[face])
      {
        isKnown[face] = 1;
        this->LayersOf[face] = this->Step(this->LayersOf[front[i]], other);
        front.push_back(face);
      }
    }
  }
}

/// The winding numbers of a component's parts around a node of another one.
LoopRegions::Layers LoopRegions::WindingsAt(Index node, Index component) const
{
  const Point2& x = this->Walks.Nodes[node];
  Layers layers;
  for (const Index edge : this->EdgesOf[component])
  {
    const Point2& p = this->Walks.Nodes[this->Graph.Tail(2 * edge)];
    const Point2& q = this->Walks.Nodes[this->Graph.Head(2 * edge)];
    // Towards +u from the node, edges that it passes from their right to their left count up.
    if ((p[1] > x[1]) != (q[1] > x[1]) && (SideOf(p, q, x) > 0) == (q[1] > p[1]))
    {
      layers = this->Step(layers, 2 * edge + (q[1] > p[1] ? 0 : 1));
    }
  }
  return layers;
}

/// Adds the parts of other components around each component.
void LoopRegions::AddSurrounding()
{
  const Index components = this->Graph.CountComponents();
  struct Range
  {
    Point2 Low, High;
    Index Node = None;
  };
  std::vector<Range> ranges(components);
  for (std::size_t i = 0; i < this->Walks.Nodes.size(); ++i)
  {
    const Index component = this->Graph.ComponentOfNode(static_cast<Index>(i));
    if (component == None)
    {
      continue;
    }
    Range& range = ranges[component];
    const Point2& p = this->Walks.Nodes[i];
    const bool isFirst = range.Node == None;
    for (int axis = 0; axis < 2; ++axis)
    {
      range.Low[axis] = isFirst ? p[axis] : std::min(range.Low[axis], p[axis]);
      range.High[axis] = isFirst ? p[axis] : std::max(range.High[axis], p[axis]);
    }
    range.Node = static_cast<Index>(i);
  }
  this->EdgesOf.resize(components);
  for (Index edge = 0; edge < this->Graph.CountHalfEdges() / 2; ++edge)
  {
    this->EdgesOf[this->Graph.Component(this->Graph.Face(2 * edge))].push_back(edge);
  }
  std::vector<Layers> around(components);
  for (Index inner = 0; inner < components; ++inner)
  {
    for (Index outer = 0; outer < components; ++outer)
    {
      const Range& a = ranges[inner];
      const Range& b = ranges[outer];
      if (inner != outer && b.Low[0] <= a.Low[0] && b.Low[1] <= a.Low[1] &&
        b.High[0] >= a.High[0] && b.High[1] >= a.High[1])
      {
        const Layers more = this->WindingsAt(a.Node, outer);
        around[inner].insert(around[inner].end(), more.begin(), more.end());
      }
    }
  }
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    const Layers& more = around[this->Graph.Component(face)];
    Layers& layers = this->LayersOf[face];
    layers.insert(layers.end(), more.begin(), more.end());
    std::sort(
      layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.Part < b.Part; });
  }
}

bool LoopRegions::Contains(Index outer, Index inner) const
{
  const std::vector<Index>& containers = this->Containers[inner];
  return std::binary_search(containers.begin(), containers.end(), outer);
}

void LoopRegions::MeasureFaces()
{
  this->AreaOfFace.assign(this->Graph.CountFaces(), 0.0);
  const Point2 origin = this->Walks.Nodes.empty() ? Point2{} : this->Walks.Nodes[0];
  for (Index halfEdge = 0; halfEdge < this->Graph.CountHalfEdges(); ++halfEdge)
  {
    const Point2 p = this->Walks.Nodes[this->Graph.Tail(halfEdge)] - origin;
    const Point2 q = this->Walks.Nodes[this->Graph.Head(halfEdge)] - origin;
    this->AreaOfFace[this->Graph.Face(halfEdge)] += 0.5 * Cross(p, q);
  }
  this->AreaOfPart.assign(this->CountParts(), 0.0);
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    for (const Layer& layer : this->LayersOf[face])
    {
      if (this->IsAtHome(layer.Part, face))
      {
        this->AreaOfPart[layer.Part] += this->AreaOfFace[face];
      }
    }
  }
}

/// A part is contained in those that surround all of its area but for a little; but not two parts in
/// each other.
void LoopRegions::FindContainers()
{
  std::map<std::pair<Index, Index>, double> common;
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    for (const Layer& inner : this->LayersOf[face])
    {
      for (const Layer& outer : this->LayersOf[face])
      {
        if (inner.Part != outer.Part && this->IsAtHome(inner.Part, face))
        {
          common[{ inner.Part, outer.Part }] += this->AreaOfFace[face];
        }
      }
    }
  }
  const auto isWithin = [&](Index inner, Index outer)
  {
    const auto entry = common.find({ inner, outer });
    return entry != common.end() && entry->second >= (1.0 - LittleArea) * this->AreaOfPart[inner];
  };
  this->Containers.resize(this->CountParts());
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

double LoopRegions::LengthOf(Index edge) const
{
  return Distance(
    this->Walks.Nodes[this->Graph.Tail(2 * edge)], this->Walks.Nodes[this->Graph.Head(2 * edge)]);
}

void LoopRegions::FindRepeated()
{
  const Index parts = this->CountParts();
  this->IsRepeated.assign(parts, 0);
  std::vector<double> length(parts, 0.0);
  std::map<std::pair<Index, Index>, double> common; // of two parts, the interior on the same side
  for (Index edge = 0; edge < this->Graph.CountHalfEdges() / 2; ++edge)
  {
    const Layers& left = this->LayersOf[this->Graph.Face(2 * edge)];
    const auto isLeft = [&](Index part)
    {
      return std::any_of(
        left.begin(), left.end(), [&](const Layer& layer) { return layer.Part == part; });
    };
    const double more = this->LengthOf(edge);
    for (Index i = this->Graph.FirstPassage(edge); i < this->Graph.EndOfPassages(edge); ++i)
    {
      const Index part = this->PartOfPassage[i];
      if (part == None)
      {
        continue;
      }
      length[part] += more;
      for (Index j = this->Graph.FirstPassage(edge); j < i; ++j)
      {
        const Index other = this->PartOfPassage[j];
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
  for (Index part = 0; part < this->CountParts(); ++part)
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
  std::vector<Index> order(this->CountParts());
  std::iota(order.begin(), order.end(), 0);
  // Containers are larger.
  std::stable_sort(order.begin(), order.end(),
    [this](Index a, Index b) { return this->AreaOfPart[a] > this->AreaOfPart[b]; });
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
  for (const Layers& layers : this->LayersOf)
  {
    sums.push_back(std::accumulate(layers.begin(), layers.end(), Index(0),
      [&](Index sum, const Layer& layer)
      {
        const Index turns = rule == LoopRule::EvenOdd ? this->TurnsOfPart[layer.Part] : 1;
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
    const Layers& layers = this->LayersOf[face];
    const auto isHoleOf = [&](Index outline, Index hole)
    { return levels[hole] % 2 != 0 && this->Contains(outline, hole); };
    const auto isInOutline = [&](const Layer& outline)
    {
      return levels[outline.Part] % 2 == 0 && !this->IsRepeated[outline.Part] &&
        std::none_of(layers.begin(), layers.end(),
          [&](const Layer& hole) { return isHoleOf(outline.Part, hole.Part); });
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

/// Whether a walk surrounds most once and in one direction, and the rest in little lobes.
bool LoopRegions::AreWalksPlain() const
{
  struct Sums
  {
    Index Parts = 0;
    double All = 0.0;
    std::array<double, 2> Once{}; ///< clockwise and counter-clockwise
    std::array<double, 2> Lobe{}; ///< the largest face that is not surrounded once so
  };
  std::vector<Sums> sums(this->Walks.Walks.size());
  for (Index part = 0; part < this->CountParts(); ++part)
  {
    Sums& sum = sums[this->WalkOfPart[part]];
    sum.Parts += this->AreaOfPart[part] > 0.0 ? 1 : 0;
    sum.All += this->AreaOfPart[part];
  }
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    const double area = this->AreaOfFace[face];
    for (const Layer& layer : this->LayersOf[face])
    {
      Sums& sum = sums[this->WalkOfPart[layer.Part]];
      for (const int turn : { 0, 1 })
      {
        const bool isOnce = layer.Winding == 2 * turn - 1;
        const bool isAtHome = this->IsAtHome(layer.Part, face);
        sum.Once[turn] += isAtHome && isOnce ? area : 0.0;
        sum.Lobe[turn] = std::max(sum.Lobe[turn], isAtHome && !isOnce ? area : 0.0);
      }
    }
  }
  return std::all_of(sums.begin(), sums.end(),
    [](const Sums& sum)
    {
      const int main = sum.Once[1] >= sum.Once[0] ? 1 : 0;
      return sum.Parts < 2 && sum.Lobe[main] <= LittleArea * sum.Once[main] &&
        sum.All <= (1.0 + MostInLobes) * sum.Once[main];
    });
}

/// Whether no walks run along each other for more than a little.
bool LoopRegions::AreWalksApart() const
{
  std::vector<double> length(this->Walks.Walks.size(), 0.0), common(length);
  for (Index edge = 0; edge < this->Graph.CountHalfEdges() / 2; ++edge)
  {
    const Index first = this->Graph.FirstPassage(edge), end = this->Graph.EndOfPassages(edge);
    for (Index i = first; i < end; ++i)
    {
      const Index walk = this->Graph.PassageAt(i).Walk;
      length[walk] += this->LengthOf(edge);
      common[walk] += end - first > 1 ? this->LengthOf(edge) : 0.0;
    }
  }
  for (std::size_t walk = 0; walk < length.size(); ++walk)
  {
    if (common[walk] > LittleArea * length[walk])
    {
      return false;
    }
  }
  return true;
}

bool LoopRegions::AreMeetingsSlight() const
{
  if (!this->AreWalksPlain() || !this->AreWalksApart())
  {
    return false;
  }
  std::map<std::pair<Index, Index>, double> common;
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    const Layers& layers = this->LayersOf[face];
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      for (std::size_t j = 0; j < i && this->IsAtHome(layers[i].Part, face); ++j)
      {
        if (this->IsAtHome(layers[j].Part, face))
        {
          common[{ layers[j].Part, layers[i].Part }] += this->AreaOfFace[face];
        }
      }
    }
  }
  for (const auto& entry : common)
  {
    const double a = this->AreaOfPart[entry.first.first];
    const double b = this->AreaOfPart[entry.first.second];
    const double little = LittleArea * std::min(a, b);
    const bool isIn = a - entry.second <= little || b - entry.second <= little;
    const bool isSame = a - entry.second <= little && b - entry.second <= little;
    if (entry.second > little && (!isIn || isSame))
    {
      return false;
    }
  }
  return true;
}
}
