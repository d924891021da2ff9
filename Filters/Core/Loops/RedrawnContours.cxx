// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/RedrawnContours.h"

#include "Core/Base/EditContours.h"
#include "Core/Base/Vectors.h"
#include "Core/Loops/ThinWalls.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
struct Range
{
  Point2 Low, High;

  double Width() const
  {
    return std::min(this->High[0] - this->Low[0], this->High[1] - this->Low[1]);
  }
};

class RepetitionFinder
{
public:
  RepetitionFinder(const Contours& contours, double share)
    : Set(contours)
    , Share(share)
  {
  }

  std::vector<Repetition> FindInSlice(const std::vector<Index>& slice) const;

private:
  Point2 At(Index vertex) const { return { this->Set.U[vertex], this->Set.V[vertex] }; }
  Index After(Index contour, Index vertex) const
  {
    return vertex + 1 < this->Set.Offsets[contour + 1] ? vertex + 1 : this->Set.Offsets[contour];
  }
  Range RangeOf(Index contour) const;
  Index ExtremeVertex(Index contour) const;
  bool IsCopy(Index a, Index b) const;
  bool Compare(Index a, Index b, Repetition& repetition) const;
  double FarthestFrom(Index a, Index b, double limit) const;

  const Contours& Set;
  double Share;
};

Range RepetitionFinder::RangeOf(Index contour) const
{
  const Index first = this->Set.Offsets[contour];
  Range range{ this->At(first), this->At(first) };
  for (Index i = first + 1; i < this->Set.Offsets[contour + 1]; ++i)
  {
    range.Low = { std::min(range.Low[0], this->Set.U[i]), std::min(range.Low[1], this->Set.V[i]) };
    range.High = { std::max(range.High[0], this->Set.U[i]),
      std::max(range.High[1], this->Set.V[i]) };
  }
  return range;
}

/// The vertex with the least u, of several the one with the least v.
Index RepetitionFinder::ExtremeVertex(Index contour) const
{
  Index extreme = this->Set.Offsets[contour];
  for (Index i = extreme + 1; i < this->Set.Offsets[contour + 1]; ++i)
  {
    extreme = this->At(i) < this->At(extreme) ? i : extreme;
  }
  return extreme;
}

/// Whether two contours pass the same vertices, from whatever start and in whichever direction.
bool RepetitionFinder::IsCopy(Index a, Index b) const
{
  const Index size = this->Set.Size(a);
  if (size != this->Set.Size(b))
  {
    return false;
  }
  const Index beginA = this->Set.Offsets[a];
  const Index beginB = this->Set.Offsets[b];
  const Index startA = this->ExtremeVertex(a) - beginA;
  const Index startB = this->ExtremeVertex(b) - beginB;
  const auto same = [&](Index i, Index step)
  {
    const Index p = beginA + (startA + i) % size;
    const Index q = beginB + (startB + (step > 0 ? i : size - i)) % size;
    return this->Set.U[p] == this->Set.U[q] && this->Set.V[p] == this->Set.V[q];
  };
  bool forward = true, backward = true;
  for (Index i = 0; i < size && (forward || backward); ++i)
  {
    forward = forward && same(i, 1);
    backward = backward && same(i, -1);
  }
  return forward || backward;
}

/// The greatest distance of the vertices of one contour from another; more than the limit if one
/// is.
double RepetitionFinder::FarthestFrom(Index a, Index b, double limit) const
{
  double farthest = 0.0;
  Index start = 0;
  for (Index i = this->Set.Offsets[a]; i < this->Set.Offsets[a + 1] && farthest <= limit; ++i)
  {
    farthest = std::max(farthest, DistanceToContour(this->Set, b, this->At(i), limit, start));
  }
  return farthest;
}

/// Whether the contours may be the same.
bool RepetitionFinder::Compare(Index a, Index b, Repetition& repetition) const
{
  repetition = { a, b, 0.0, 0.0, false };
  if (this->IsCopy(a, b))
  {
    return true;
  }
  const double areaA = TwiceSignedArea(this->Set, a);
  const double areaB = TwiceSignedArea(this->Set, b);
  double length = 0.0;
  for (Index i = this->Set.Offsets[a]; i < this->Set.Offsets[a + 1]; ++i)
  {
    length += Distance(this->At(i), this->At(this->After(a, i)));
  }
  repetition.Limit = this->Share * std::abs(areaA) / length;
  repetition.IsOpposite = (areaA > 0.0) != (areaB > 0.0);
  // A strip along the contour is as near to it, but has a quite different area.
  const double most = 2.0 * (1.0 + this->Share) * repetition.Limit * length;
  if (repetition.Limit <= 0.0 || std::abs(std::abs(areaA) - std::abs(areaB)) > most)
  {
    return false;
  }
  repetition.Distance = std::max(
    this->FarthestFrom(b, a, repetition.Limit), this->FarthestFrom(a, b, repetition.Limit));
  return repetition.Distance <= repetition.Limit;
}

std::vector<Repetition> RepetitionFinder::FindInSlice(const std::vector<Index>& slice) const
{
  std::vector<std::pair<Index, Range>> members;
  double widest = 0.0;
  for (const Index contour : slice)
  {
    if (slice.size() > 1 && !this->Set.IsVirtual(contour))
    {
      members.emplace_back(contour, this->RangeOf(contour));
      widest = std::max(widest, members.back().second.Width());
    }
  }
  std::stable_sort(members.begin(), members.end(),
    [](const auto& a, const auto& b) { return a.second.Low[0] < b.second.Low[0]; });
  std::vector<Repetition> found;
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const Range& a = members[i].second;
    for (std::size_t j = i + 1; j < members.size(); ++j)
    {
      // The thickness of a contour is at most the width of its range.
      const Range& b = members[j].second;
      if (b.Low[0] - a.Low[0] > this->Share * widest)
      {
        break;
      }
      const double most = this->Share * std::max(a.Width(), b.Width());
      const bool isNear = std::abs(b.Low[0] - a.Low[0]) <= most &&
        std::abs(b.Low[1] - a.Low[1]) <= most && std::abs(b.High[0] - a.High[0]) <= most &&
        std::abs(b.High[1] - a.High[1]) <= most;
      const auto pair = std::minmax(members[i].first, members[j].first);
      Repetition repetition;
      if (isNear && this->Compare(pair.first, pair.second, repetition))
      {
        found.push_back(repetition);
      }
    }
  }
  std::sort(found.begin(), found.end(),
    [](const Repetition& a, const Repetition& b)
    { return a.First != b.First ? a.First < b.First : a.Second < b.Second; });
  return found;
}
}

void RemoveRedrawn(double share, bool directionsCount, const Execution& execution,
  Contours& contours, std::vector<Problem>& mended)
{
  const RepetitionFinder finder(contours, share);
  const std::vector<std::vector<Index>> slices = GroupBySlice(contours);
  std::vector<std::vector<Repetition>> found(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        found[i] = finder.FindInSlice(slices[i]);
      }
    });
  std::vector<Repetition> all;
  for (const std::vector<Repetition>& list : found)
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  if (all.empty())
  {
    return;
  }
  const std::vector<std::uint8_t> walls = FindWalls(contours, all, execution);
  std::vector<std::uint8_t> removed(contours.Count(), 0);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const bool isWall = walls[i] || (directionsCount && all[i].IsOpposite);
    if (!isWall && !removed[all[i].First] && !removed[all[i].Second])
    {
      removed[all[i].Second] = 1;
      mended.push_back(
        { ProblemKind::DrawnTwice, contours.Axis[all[i].Second], contours.Cell[all[i].Second],
          contours.World(all[i].Second, contours.Offsets[all[i].Second]), all[i].Distance, true });
    }
  }
  RemoveMarked(removed, contours);
}
}
