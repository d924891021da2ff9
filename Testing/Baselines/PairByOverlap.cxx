// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PairByOverlap.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
struct Range
{
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();

  bool IsEmpty() const { return !(this->Low < this->High); }

  Range CommonWith(const Range& other) const
  {
    return { std::max(this->Low, other.Low), std::min(this->High, other.High) };
  }
};

//------------------------------------------------------------------------------
Range RangeOf(const Loop& loop, int coordinate)
{
  Range range;
  for (const Point2& point : loop)
  {
    range.Low = std::min(range.Low, point[coordinate]);
    range.High = std::max(range.High, point[coordinate]);
  }
  return range;
}

//------------------------------------------------------------------------------
// Where the line of constant V enters and leaves the loop, ascending.
std::vector<double> Crossings(const Loop& loop, double v)
{
  std::vector<double> crossings;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& a = loop[i];
    const Point2& b = loop[(i + 1) % loop.size()];
    if ((a[1] <= v) != (b[1] <= v))
    {
      crossings.push_back(a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

//------------------------------------------------------------------------------
// Length common to two sets of intervals.
double CommonLength(const std::vector<double>& a, const std::vector<double>& b)
{
  double length = 0.0;
  for (std::size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();)
  {
    length += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    (a[i + 1] < b[j + 1] ? i : j) += 2;
  }
  return length;
}

//------------------------------------------------------------------------------
struct Candidate
{
  LoopPair Pair;
  double Overlap;
};

//------------------------------------------------------------------------------
std::vector<Candidate> FindCandidates(const Slice& below, const Slice& above)
{
  const std::vector<int> depthsBelow = NestingDepths(below);
  const std::vector<int> depthsAbove = NestingDepths(above);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < below.Loops.size(); ++i)
  {
    for (std::size_t j = 0; j < above.Loops.size(); ++j)
    {
      const bool sameKind = depthsBelow[i] % 2 == depthsAbove[j] % 2;
      const double overlap = sameKind ? OverlapArea(below.Loops[i], above.Loops[j]) : 0.0;
      if (overlap > 0.0)
      {
        candidates.push_back({ { i, j }, overlap });
      }
    }
  }
  return candidates;
}

} // anonymous namespace

//------------------------------------------------------------------------------
double OverlapArea(const Loop& a, const Loop& b, int rows)
{
  const Range us = RangeOf(a, 0).CommonWith(RangeOf(b, 0));
  const Range vs = RangeOf(a, 1).CommonWith(RangeOf(b, 1));
  if (us.IsEmpty() || vs.IsEmpty())
  {
    return 0.0;
  }
  const double height = (vs.High - vs.Low) / rows;
  double area = 0.0;
  for (int row = 0; row < rows; ++row)
  {
    const double v = vs.Low + (row + 0.5) * height;
    area += height * CommonLength(Crossings(a, v), Crossings(b, v));
  }
  return area;
}

//------------------------------------------------------------------------------
std::vector<LoopPair> PairByOverlap(const Slice& below, const Slice& above)
{
  std::vector<Candidate> candidates = FindCandidates(below, above);
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Overlap > b.Overlap; });
  std::vector<bool> takenBelow(below.Loops.size(), false);
  std::vector<bool> takenAbove(above.Loops.size(), false);
  std::vector<LoopPair> pairs;
  for (const Candidate& candidate : candidates)
  {
    const LoopPair& pair = candidate.Pair;
    if (!takenBelow[pair.Below] && !takenAbove[pair.Above])
    {
      takenBelow[pair.Below] = true;
      takenAbove[pair.Above] = true;
      pairs.push_back(pair);
    }
  }
  return pairs;
}

} // namespace baselines
} // namespace orthoslices
