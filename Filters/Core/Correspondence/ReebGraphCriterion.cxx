// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/ReebGraphCriterion.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"
#include "Core/Correspondence/ContourNesting.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Places on each contour between which distances are measured. A smooth contour with so many lies
/// within half a percent of its radius from the polygon through them.
constexpr int SampleCount = 32;
using Samples = std::array<Point2, SampleCount>;

/// Places at equal distances along a contour.
Samples SampleContour(const ContourStack& stack, Index contour)
{
  const Index begin = stack.Offsets[contour], end = stack.Offsets[contour + 1];
  const auto length = [&](Index i)
  {
    const Point2 p = stack.At(i), q = stack.At(stack.Next(contour, i));
    return Distance(p, q);
  };
  double total = 0.0;
  for (Index i = begin; i < end; ++i)
  {
    total += length(i);
  }
  Samples samples;
  Index i = begin;
  double passed = 0.0;
  for (int k = 0; k < SampleCount; ++k)
  {
    const double target = total * k / SampleCount;
    while (i + 1 < end && passed + length(i) <= target)
    {
      passed += length(i++);
    }
    const Point2 p = stack.At(i), q = stack.At(stack.Next(contour, i));
    const double t = length(i) > 0.0 ? std::min((target - passed) / length(i), 1.0) : 0.0;
    samples[k] = Between(p, q, t);
  }
  return samples;
}

/// Mean distance of the points of one contour from the other.
double MeanDistance(const Samples& from, const Samples& to)
{
  double sum = 0.0;
  for (const Point2& p : from)
  {
    double minimum = HUGE_VAL;
    for (int k = 0; k < SampleCount; ++k)
    {
      minimum = std::min(minimum, DistanceToSegment(p, to[k], to[(k + 1) % SampleCount]));
    }
    sum += minimum;
  }
  return sum / SampleCount;
}

bool IsCloser(const Correspondence& a, const Correspondence& b)
{
  return std::tie(a.Cost, a.First, a.Second, a.Where) <
    std::tie(b.Cost, b.First, b.Second, b.Where);
}

class ReebGraphBuilder
{
public:
  ReebGraphBuilder(const ContourStack& stack, const PriorKnowledge& known);
  std::vector<Correspondence> Run();

private:
  /// Contours of the stack that are outer boundaries (or holes) on a slice.
  std::vector<Index> Members(Index slice, bool outer) const;
  bool IsOuter(Index contour) const { return this->Areas[contour] > 0.0; }
  bool NumberChanges(Index lowerSlice, bool outer) const;
  bool BoundCommonArea(Index a, Index b) const;
  double CostOf(Index a, Index b) const;

  /// The two sides of a contour are 2 contour (above) and 2 contour + 1 (below).
  static std::pair<Index, Index> SidesOf(const Correspondence& pair);
  bool HasPartner(Index side) const { return this->Partners[side] > 0; }

  std::vector<Correspondence> PairsBetween(Index lowerSlice, bool alsoMixed) const;
  std::vector<Correspondence> PairsWithin(Passage where) const;
  void ConnectOneToOne(Index lowerSlice, bool outer);
  void ConnectUndecided();
  void ConnectFurther(std::vector<Correspondence> pairs, bool undecidedOnly);
  bool IsLacking() const;
  void Connect(const Correspondence& pair);

  const ContourStack& Stack;
  PriorKnowledge Known;
  std::vector<Index> First;
  std::vector<double> Areas;
  std::vector<Index> Parents;
  std::vector<Samples> Outlines;
  std::vector<Index> Partners; ///< for each side: connections
  DisjointSets Pieces;         ///< of the surface between two slices, over sides
  DisjointSets Components;     ///< of the surface, over contours
  Index ComponentCount;
  Index HandleCount = 0;
  std::vector<Correspondence> Pairs;
};

ReebGraphBuilder::ReebGraphBuilder(const ContourStack& stack, const PriorKnowledge& known)
  : Stack(stack)
  , Known(known)
  , First(FirstContourOfSlices(stack))
  , Areas(SignedAreas(stack))
  , Parents(FindParents(stack))
  , Partners(2 * stack.Slice.size(), 0)
  , Pieces(2 * stack.Count())
  , Components(stack.Count())
  , ComponentCount(stack.Count())
{
  for (Index contour = 0; contour < stack.Count(); ++contour)
  {
    this->Outlines.push_back(SampleContour(stack, contour));
  }
}

std::vector<Index> ReebGraphBuilder::Members(Index slice, bool outer) const
{
  std::vector<Index> members;
  for (Index i = this->First[slice]; i < this->First[slice + 1]; ++i)
  {
    if (this->IsOuter(i) == outer)
    {
      members.push_back(i);
    }
  }
  return members;
}

bool ReebGraphBuilder::NumberChanges(Index lowerSlice, bool outer) const
{
  return this->Members(lowerSlice, outer).size() != this->Members(lowerSlice + 1, outer).size();
}

bool ReebGraphBuilder::BoundCommonArea(Index a, Index b) const
{
  return this->Parents[a] == this->Parents[b] || this->Parents[a] == b || this->Parents[b] == a;
}

double ReebGraphBuilder::CostOf(Index a, Index b) const
{
  return 0.5 *
    (MeanDistance(this->Outlines[a], this->Outlines[b]) +
      MeanDistance(this->Outlines[b], this->Outlines[a]));
}

std::pair<Index, Index> ReebGraphBuilder::SidesOf(const Correspondence& pair)
{
  return { 2 * pair.First + (pair.Where == Passage::Below ? 1 : 0),
    2 * pair.Second + (pair.Where == Passage::Above ? 0 : 1) };
}

void ReebGraphBuilder::Connect(const Correspondence& pair)
{
  const auto [first, second] = SidesOf(pair);
  ++this->Partners[first];
  ++this->Partners[second];
  if (this->Pieces.Unite(first, second))
  {
    const bool joins = this->Components.Unite(pair.First, pair.Second);
    (joins ? this->ComponentCount : this->HandleCount) += joins ? -1 : 1;
  }
  this->Pairs.push_back(pair);
}

std::vector<Correspondence> ReebGraphBuilder::PairsBetween(Index lowerSlice, bool alsoMixed) const
{
  std::vector<Correspondence> pairs;
  for (Index lower = this->First[lowerSlice]; lower < this->First[lowerSlice + 1]; ++lower)
  {
    for (Index upper = this->First[lowerSlice + 1]; upper < this->First[lowerSlice + 2]; ++upper)
    {
      if (alsoMixed || this->IsOuter(lower) == this->IsOuter(upper))
      {
        pairs.push_back({ lower, upper, this->CostOf(lower, upper) });
      }
    }
  }
  return pairs;
}

/// Pairs of one slice without partners on one side.
std::vector<Correspondence> ReebGraphBuilder::PairsWithin(Passage where) const
{
  std::vector<Correspondence> pairs;
  for (Index slice = 0; slice < this->Stack.SliceCount(); ++slice)
  {
    for (Index a = this->First[slice]; a < this->First[slice + 1]; ++a)
    {
      for (Index b = a + 1; b < this->First[slice + 1]; ++b)
      {
        Correspondence pair{ a, b, 0.0, where };
        const auto [first, second] = SidesOf(pair);
        if (!this->HasPartner(first) && !this->HasPartner(second) && this->BoundCommonArea(a, b))
        {
          pair.Cost = this->CostOf(a, b);
          pairs.push_back(pair);
        }
      }
    }
  }
  return pairs;
}

void ReebGraphBuilder::ConnectOneToOne(Index lowerSlice, bool outer)
{
  std::vector<Correspondence> pairs;
  for (const Index lower : this->Members(lowerSlice, outer))
  {
    for (const Index upper : this->Members(lowerSlice + 1, outer))
    {
      pairs.push_back({ lower, upper, this->CostOf(lower, upper) });
    }
  }
  std::sort(pairs.begin(), pairs.end(), IsCloser);
  for (const Correspondence& pair : pairs)
  {
    const auto [above, below] = SidesOf(pair);
    if (!this->HasPartner(above) && !this->HasPartner(below))
    {
      this->Connect(pair);
    }
  }
}

/// Step 2.
void ReebGraphBuilder::ConnectUndecided()
{
  std::vector<Correspondence> pairs;
  for (Index slice = 0; slice + 1 < this->Stack.SliceCount(); ++slice)
  {
    const std::array<bool, 2> changes{ this->NumberChanges(slice, false),
      this->NumberChanges(slice, true) };
    for (const Correspondence& pair : this->PairsBetween(slice, false))
    {
      if (changes[this->IsOuter(pair.First) ? 1 : 0])
      {
        pairs.push_back(pair);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(), IsCloser);
  for (const Correspondence& pair : pairs)
  {
    const auto [above, below] = SidesOf(pair);
    const bool undecided = !this->HasPartner(above) || !this->HasPartner(below);
    const bool joins = this->Components.Find(pair.First) != this->Components.Find(pair.Second);
    const bool allowed = joins
      ? this->Known.Components == 0 || this->ComponentCount > this->Known.Components
      : this->Known.Genus < 0 || this->HandleCount < this->Known.Genus;
    if (undecided && allowed)
    {
      this->Connect(pair);
    }
  }
}

/// Steps 3 and 4: only what is known to be lacking.
void ReebGraphBuilder::ConnectFurther(std::vector<Correspondence> pairs, bool undecidedOnly)
{
  std::sort(pairs.begin(), pairs.end(), IsCloser);
  for (const Correspondence& pair : pairs)
  {
    const auto [first, second] = SidesOf(pair);
    const bool joins = this->Components.Find(pair.First) != this->Components.Find(pair.Second);
    const bool lacking = joins
      ? this->Known.Components > 0 && this->ComponentCount > this->Known.Components
      : this->HandleCount < this->Known.Genus;
    const bool decided = this->HasPartner(first) || this->HasPartner(second);
    if (lacking && !(undecidedOnly && decided) &&
      this->Pieces.Find(first) != this->Pieces.Find(second))
    {
      this->Connect(pair);
    }
  }
}

bool ReebGraphBuilder::IsLacking() const
{
  return (this->Known.Components > 0 && this->ComponentCount > this->Known.Components) ||
    this->HandleCount < this->Known.Genus;
}

std::vector<Correspondence> ReebGraphBuilder::Run()
{
  for (Index slice = 0; slice + 1 < this->Stack.SliceCount(); ++slice)
  {
    for (const bool outer : { true, false })
    {
      if (!this->NumberChanges(slice, outer))
      {
        this->ConnectOneToOne(slice, outer);
      }
    }
  }
  this->ConnectUndecided();
  if (this->IsLacking())
  {
    std::vector<Correspondence> pairs;
    for (Index slice = 0; slice + 1 < this->Stack.SliceCount(); ++slice)
    {
      if (this->NumberChanges(slice, true) || this->NumberChanges(slice, false))
      {
        const std::vector<Correspondence> between = this->PairsBetween(slice, true);
        pairs.insert(pairs.end(), between.begin(), between.end());
      }
    }
    this->ConnectFurther(std::move(pairs), false);
  }
  if (this->IsLacking())
  {
    std::vector<Correspondence> pairs = this->PairsWithin(Passage::Above);
    const std::vector<Correspondence> below = this->PairsWithin(Passage::Below);
    pairs.insert(pairs.end(), below.begin(), below.end());
    this->ConnectFurther(std::move(pairs), true);
  }
  return this->Pairs;
}
}

std::vector<Correspondence> CorrespondencesByReebGraph(
  const ContourStack& stack, const PriorKnowledge& known)
{
  return ReebGraphBuilder(stack, known).Run();
}
}
