// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/LoopWindings.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;
}

LoopWindings::LoopWindings(const PlaneWalks& walks, const PlaneFaces& faces)
  : Walks(walks)
  , Graph(faces)
{
  this->FindParts();
  this->SpreadWindings();
  this->AddSurrounding();
  this->MeasureFaces();
}

void LoopWindings::FindParts()
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
void LoopWindings::AddPart(Index start, const std::vector<std::pair<Index, Index>>& at)
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
void LoopWindings::AddParts(const std::vector<Index>& passages)
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
LoopWindings::Layers LoopWindings::Step(const Layers& layers, Index halfEdge) const
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
void LoopWindings::SpreadWindings()
{
  const Index faces = this->Graph.CountFaces();
  this->LayersOfFace.resize(faces);
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
        this->LayersOfFace[face] = this->Step(this->LayersOfFace[front[i]], other);
        front.push_back(face);
      }
    }
  }
}

/// The winding numbers of a component's parts around a node of another one.
LoopWindings::Layers LoopWindings::WindingsAt(Index node, Index component) const
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
void LoopWindings::AddSurrounding()
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
    Layers& layers = this->LayersOfFace[face];
    layers.insert(layers.end(), more.begin(), more.end());
    std::sort(
      layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.Part < b.Part; });
  }
}

void LoopWindings::MeasureFaces()
{
  this->FaceAreas.assign(this->Graph.CountFaces(), 0.0);
  const Point2 origin = this->Walks.Nodes.empty() ? Point2{} : this->Walks.Nodes[0];
  for (Index halfEdge = 0; halfEdge < this->Graph.CountHalfEdges(); ++halfEdge)
  {
    const Point2 p = this->Walks.Nodes[this->Graph.Tail(halfEdge)] - origin;
    const Point2 q = this->Walks.Nodes[this->Graph.Head(halfEdge)] - origin;
    this->FaceAreas[this->Graph.Face(halfEdge)] += 0.5 * Cross(p, q);
  }
  this->PartAreas.assign(this->CountParts(), 0.0);
  for (Index face = 0; face < this->Graph.CountFaces(); ++face)
  {
    for (const Layer& layer : this->LayersOfFace[face])
    {
      if (this->IsAtHome(layer.Part, face))
      {
        this->PartAreas[layer.Part] += this->FaceAreas[face];
      }
    }
  }
}

double LoopWindings::LengthOf(Index edge) const
{
  return Distance(
    this->Walks.Nodes[this->Graph.Tail(2 * edge)], this->Walks.Nodes[this->Graph.Head(2 * edge)]);
}
}
