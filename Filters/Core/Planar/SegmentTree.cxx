// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/SegmentTree.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Consecutive segments in one box of the lowest level. Boxes of fewer segments are too many,
/// those of more are too wide; it changes the time only.
constexpr Index SegmentsInRun = 8;

template <typename Box>
bool Overlap(const Box& a, const Box& b)
{
  return a.LowU <= b.HighU && b.LowU <= a.HighU && a.LowV <= b.HighV && b.LowV <= a.HighV;
}

template <typename Box>
Box Union(const Box& a, const Box& b)
{
  return { std::min(a.LowU, b.LowU), std::min(a.LowV, b.LowV), std::max(a.HighU, b.HighU),
    std::max(a.HighV, b.HighV) };
}
}

SegmentTree::SegmentTree(const Contours& contours, std::vector<Index> members)
  : Source(contours)
{
  this->Boxes.emplace_back();
  for (const Index contour : members)
  {
    this->AddRuns(contour);
  }
  this->AddLevels();
}

Index SegmentTree::NextVertex(Index contour, Index vertex) const
{
  return vertex + 1 < this->Source.Offsets[contour + 1] ? vertex + 1
                                                        : this->Source.Offsets[contour];
}

SegmentTree::Box SegmentTree::BoxOfSegment(Index contour, Index vertex) const
{
  const Index next = this->NextVertex(contour, vertex);
  const auto u = std::minmax(this->Source.U[vertex], this->Source.U[next]);
  const auto v = std::minmax(this->Source.V[vertex], this->Source.V[next]);
  return { u.first, v.first, u.second, v.second };
}

void SegmentTree::AddRuns(Index contour)
{
  const Index end = this->Source.Offsets[contour + 1];
  for (Index first = this->Source.Offsets[contour]; first < end; first += SegmentsInRun)
  {
    const Index last = std::min(end, first + SegmentsInRun);
    Box box = this->BoxOfSegment(contour, first);
    for (Index vertex = first + 1; vertex < last; ++vertex)
    {
      box = Union(box, this->BoxOfSegment(contour, vertex));
    }
    this->Runs.push_back({ contour, first, last });
    this->Boxes[0].push_back(box);
  }
}

void SegmentTree::AddLevels()
{
  while (this->Boxes.back().size() > 1)
  {
    const std::vector<Box>& below = this->Boxes.back();
    std::vector<Box> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < level.size(); ++i)
    {
      level[i] = 2 * i + 1 < below.size() ? Union(below[2 * i], below[2 * i + 1]) : below[2 * i];
    }
    this->Boxes.push_back(std::move(level));
  }
}

void SegmentTree::VisitOverlaps(const std::function<void(Segment, Segment)>& visit) const
{
  if (!this->Runs.empty())
  {
    this->VisitWithin({ this->Boxes.size() - 1, 0 }, visit);
  }
}

void SegmentTree::VisitWithin(Node node, const std::function<void(Segment, Segment)>& visit) const
{
  if (node.Level == 0)
  {
    const Run& run = this->Runs[node.Number];
    this->VisitRuns(run, run, visit);
    return;
  }
  const Node left{ node.Level - 1, 2 * node.Number };
  const Node right{ node.Level - 1, 2 * node.Number + 1 };
  this->VisitWithin(left, visit);
  if (this->IsValid(right))
  {
    this->VisitWithin(right, visit);
    this->VisitBetween(left, right, visit);
  }
}

void SegmentTree::VisitBetween(
  Node a, Node b, const std::function<void(Segment, Segment)>& visit) const
{
  if (!Overlap(this->BoxOf(a), this->BoxOf(b)))
  {
    return;
  }
  if (a.Level == 0 && b.Level == 0)
  {
    this->VisitRuns(this->Runs[a.Number], this->Runs[b.Number], visit);
    return;
  }
  if (a.Level < b.Level)
  {
    std::swap(a, b);
  }
  for (std::size_t child = 2 * a.Number; child <= 2 * a.Number + 1; ++child)
  {
    const Node part{ a.Level - 1, child };
    if (this->IsValid(part))
    {
      this->VisitBetween(part, b, visit);
    }
  }
}

void SegmentTree::VisitRuns(
  const Run& a, const Run& b, const std::function<void(Segment, Segment)>& visit) const
{
  for (Index s = a.First; s < a.Last; ++s)
  {
    const Box box = this->BoxOfSegment(a.Contour, s);
    const Index after = this->NextVertex(a.Contour, s);
    for (Index r = a.First == b.First ? s + 2 : b.First; r < b.Last; ++r)
    {
      if (r != after && this->NextVertex(b.Contour, r) != s &&
        Overlap(box, this->BoxOfSegment(b.Contour, r)))
      {
        visit({ a.Contour, s }, { b.Contour, r });
      }
    }
  }
}

void SegmentTree::VisitAlongU(double u, double v, const std::function<void(Segment)>& visit) const
{
  if (!this->Runs.empty())
  {
    this->VisitAlongU({ this->Boxes.size() - 1, 0 }, u, v, visit);
  }
}

void SegmentTree::VisitAlongU(
  Node node, double u, double v, const std::function<void(Segment)>& visit) const
{
  const auto isMet = [&](const Box& box)
  { return v >= box.LowV && v <= box.HighV && u <= box.HighU; };
  if (!isMet(this->BoxOf(node)))
  {
    return;
  }
  if (node.Level > 0)
  {
    const Node right{ node.Level - 1, 2 * node.Number + 1 };
    this->VisitAlongU(Node{ node.Level - 1, 2 * node.Number }, u, v, visit);
    if (this->IsValid(right))
    {
      this->VisitAlongU(right, u, v, visit);
    }
    return;
  }
  const Run& run = this->Runs[node.Number];
  for (Index vertex = run.First; vertex < run.Last; ++vertex)
  {
    if (isMet(this->BoxOfSegment(run.Contour, vertex)))
    {
      visit({ run.Contour, vertex });
    }
  }
}

Index SegmentTree::CountAbove(double u, double v, Index contour) const
{
  return this->Runs.empty() ? 0 : this->CountAbove({ this->Boxes.size() - 1, 0 }, u, v, contour);
}

Index SegmentTree::CountAbove(Node node, double u, double v, Index contour) const
{
  const Box& box = this->BoxOf(node);
  if (u < box.LowU || u > box.HighU || v > box.HighV)
  {
    return 0;
  }
  if (node.Level == 0)
  {
    const Run& run = this->Runs[node.Number];
    return run.Contour == contour ? 0 : this->CountAboveInRun(run, u, v);
  }
  Index count = this->CountAbove(Node{ node.Level - 1, 2 * node.Number }, u, v, contour);
  const Node right{ node.Level - 1, 2 * node.Number + 1 };
  return this->IsValid(right) ? count + this->CountAbove(right, u, v, contour) : count;
}

Index SegmentTree::CountAboveInRun(const Run& run, double u, double v) const
{
  Index count = 0;
  for (Index s = run.First; s < run.Last; ++s)
  {
    const Index next = this->NextVertex(run.Contour, s);
    const double u0 = this->Source.U[s];
    const double u1 = this->Source.U[next];
    if ((u0 > u) != (u1 > u))
    {
      const double v0 = this->Source.V[s];
      const double v1 = this->Source.V[next];
      count += v0 + (u - u0) / (u1 - u0) * (v1 - v0) > v;
    }
  }
  return count;
}
}
