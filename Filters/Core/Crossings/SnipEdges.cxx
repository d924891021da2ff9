// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/SnipEdges.h"

#include "Core/Crossings/MatchAlternating.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace orthoslices
{
namespace
{
/// The crossings of one family on an edge, in the order of those of the other that they match.
struct ListOfEdge
{
  Index Edge;
  int Family;
  std::vector<Index> Crossings;
};

/// Matches the crossings on every edge of M, and takes out those that stay unmatched, or gives them
/// to the other slice.
class EdgeSnipper
{
public:
  EdgeSnipper(const CrossingTables& tables, int background, std::vector<Repair>& repairs)
    : Tables(tables)
    , Background(background)
    , Repairs(repairs)
  {
  }

  Index Run(const Execution& execution);

private:
  using Lists = std::array<std::vector<Index>, 2>; ///< crossings of both families on an edge
  using Pairs = std::vector<std::pair<Index, Index>>;

  void MatchEdge(Index edge, int label);
  void MendEdge(Index edge, const Lists& lists, const Pairs& pairs);
  Pairs Match(const Lists& lists) const;
  bool IsVirtual(Index edge, int family) const;
  std::vector<Index> Alternate(Index begin, Index end, int label);
  void SnipUnmatched(const std::vector<Index>& list, const std::vector<std::uint8_t>& matched);
  void AddMissing(Index edge, int family, const Lists& lists, const Pairs& pairs);
  void FileCompleted();
  bool IsInserted(Index crossing) const;
  void ReportSnip(Index a, Index b);
  void Snip(Index a, Index b);
  bool IsOfVirtual(Index crossing) const;
  bool JoinAtTip(Index first, Index last);
  void JoinArcs(Index incoming, Index outgoing);
  void AddIsolated(Index firstRun);

  CrossingTables Tables;
  int Background;
  std::vector<Repair>& Repairs;
  std::vector<ListOfEdge> Completed; ///< lists that got crossings, which are not filed yet
  Index SnippedEdges = 0;
};

/**
 * The crossings of one family on an edge in alternating order, from the label at the edge's lower
 * end. They already alternate unless contours touch or cross, or a loop was inserted; then rising
 * and falling ones are interleaved, each in their order, and positions are made ascending again.
 */
std::vector<Index> EdgeSnipper::Alternate(Index begin, Index end, int label)
{
  std::vector<Index> list(
    this->Tables.Edges.Crossing.begin() + begin, this->Tables.Edges.Crossing.begin() + end);
  int expected = label == 0 ? 1 : -1;
  bool alternates = true;
  for (const Index c : list)
  {
    alternates &= this->Tables.Crossings.Sign(c) == expected;
    expected = -expected;
  }
  if (alternates)
  {
    return list;
  }
  std::vector<Index> rising, falling;
  for (const Index c : list)
  {
    (this->Tables.Crossings.Sign(c) > 0 ? rising : falling).push_back(c);
  }
  bool rises = label == 0;
  auto rise = rising.begin();
  auto fall = falling.begin();
  double position = this->Tables.Crossings.Position[list.front()];
  for (Index& c : list)
  {
    c = rises ? *rise++ : *fall++;
    rises = !rises;
    position = std::max(position, this->Tables.Crossings.Position[c]);
    this->Tables.Crossings.Position[c] = position;
  }
  return list;
}

/// Joins the arc that ends at one crossing with the one that starts at another, past both.
void EdgeSnipper::JoinArcs(Index incoming, Index outgoing)
{
  const Index arc = this->Tables.Crossings.Previous[incoming];
  if (arc == outgoing)
  {
    this->AddIsolated(outgoing);
    return;
  }
  this->Tables.Crossings.RunNext[this->Tables.Crossings.ArcLastRun[arc]] = outgoing;
  this->Tables.Crossings.ArcLastRun[arc] = this->Tables.Crossings.ArcLastRun[outgoing];
  this->Tables.Crossings.Next[arc] = this->Tables.Crossings.Next[outgoing];
  this->Tables.Crossings.Previous[this->Tables.Crossings.Next[outgoing]] = arc;
}

/**
 * Where contours of structures have been drawn anew with vertices on grid lines, one may touch a
 * line in a vertex. This counts as a tip beyond the line, from one crossing to the other one at the
 * same place. If both are taken out, the arcs before and after it are joined in the vertex: else all
 * would be cut off that lies between its neighbours. False: this is no tip, or nothing but the tip
 * meets any line, and what is left is isolated as ever.
 */
bool EdgeSnipper::JoinAtTip(Index first, Index last)
{
  GridCrossings& crossings = this->Tables.Crossings;
  if (!this->Tables.Grid.BothWays || crossings.Next[first] != last ||
    crossings.Previous[first] == last || crossings.Position[first] != crossings.Position[last] ||
    crossings.RunCount[first] != 1 || crossings.ArcLastRun[first] != first)
  {
    return false;
  }
  const Index before = crossings.Previous[first];
  crossings.RunNext[crossings.ArcLastRun[before]] = first;
  crossings.ArcLastRun[before] = first;
  this->JoinArcs(first, last);
  return true;
}

/// Lists an arc that has closed in itself, if it has enough vertices for a contour.
void EdgeSnipper::AddIsolated(Index firstRun)
{
  Index vertices = 0;
  for (Index run = firstRun; run != GridCrossings::None; run = this->Tables.Crossings.RunNext[run])
  {
    vertices += this->Tables.Crossings.RunCount[run];
  }
  if (vertices >= 3)
  {
    this->Tables.Isolated.push_back({ firstRun, GridCrossings::None });
  }
}

/// Whether a crossing belongs to a loop around a vertex, which is reported there.
bool EdgeSnipper::IsInserted(Index crossing) const
{
  return this->Tables.Crossings.RunContour[crossing] == GridCrossings::None;
}

/// Whether a crossing belongs to a virtual slice, of which nothing is reported.
bool EdgeSnipper::IsOfVirtual(Index crossing) const
{
  const GridEdge edge = this->Tables.Code.Decode(this->Tables.Crossings.Edge[crossing]);
  return IsVirtualSlice(this->Tables.Grid, edge, this->Tables.Crossings.Family[crossing]);
}

void EdgeSnipper::ReportSnip(Index a, Index b)
{
  const double from = this->Tables.Crossings.Position[a];
  const double to = this->Tables.Crossings.Position[b];
  const GridEdge edge = this->Tables.Code.Decode(this->Tables.Crossings.Edge[a]);
  const bool first = this->Tables.Crossings.Family[a] == 0;
  this->Repairs.push_back(
    { RepairKind::CrossingsSnipped, first ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction),
      first ? edge.First : edge.Second,
      CrossingPoint(this->Tables.Grid, this->Tables.Code, this->Tables.Crossings.Edge[a],
        from + 0.5 * (to - from)),
      std::abs(to - from) });
}

/// Takes two crossings out: on each side of the crossed plane, the arc that ends at one of the two
/// goes on from the other.
void EdgeSnipper::Snip(Index a, Index b)
{
  if ((!this->IsInserted(a) || !this->IsInserted(b)) && !this->IsOfVirtual(a))
  {
    this->ReportSnip(a, b);
  }
  if (!this->JoinAtTip(a, b) && !this->JoinAtTip(b, a))
  {
    this->JoinArcs(a, b);
    this->JoinArcs(b, a);
  }
  this->Tables.Crossings.Next[a] = GridCrossings::Removed;
  this->Tables.Crossings.Next[b] = GridCrossings::Removed;
}

void EdgeSnipper::SnipUnmatched(
  const std::vector<Index>& list, const std::vector<std::uint8_t>& matched)
{
  // Unmatched entries between two matched ones are even in number: neighbours go together.
  for (std::size_t i = 0; i + 1 < list.size(); ++i)
  {
    if (!matched[i])
    {
      this->Snip(list[i], list[i + 1]);
      ++i;
    }
  }
}

/**
 * Completes the crossings of `family`, a virtual slice, by those that only the real one has. These
 * are pairs of neighbours: each becomes a loop around the part of the edge between them, of two
 * arcs without vertices, one in each of the two faces beside it. Their positions are those of the
 * real ones, but stay ascending among those that the virtual slice has.
 */
void EdgeSnipper::AddMissing(Index edge, int family, const Lists& lists, const Pairs& pairs)
{
  GridCrossings& crossings = this->Tables.Crossings;
  ListOfEdge completed{ edge, family, {} };
  auto next = pairs.begin();
  double low = -HUGE_VAL;
  Index open = GridCrossings::None; // the first of two neighbours
  for (const Index real : lists[1 - family])
  {
    const bool isPast = next == pairs.end();
    const Index match =
      isPast ? GridCrossings::None : lists[family][family == 0 ? next->first : next->second];
    if (!isPast && lists[1 - family][family == 0 ? next->second : next->first] == real)
    {
      completed.Crossings.push_back(match);
      low = crossings.Position[match];
      ++next;
      continue;
    }
    const double high = isPast ? HUGE_VAL : crossings.Position[match];
    low = std::min(std::max(crossings.Position[real], low), high);
    const int sign = crossings.Sign(real);
    const Index c = crossings.Insert(crossings.Edge[real], low, family == 0 ? sign : -sign, family);
    completed.Crossings.push_back(c);
    if (open != GridCrossings::None)
    {
      crossings.Next[open] = crossings.Previous[open] = c;
      crossings.Next[c] = crossings.Previous[c] = open;
    }
    open = open == GridCrossings::None ? c : GridCrossings::None;
  }
  this->Completed.push_back(std::move(completed));
}

/// Files the completed lists on their edges, which are ascending.
void EdgeSnipper::FileCompleted()
{
  if (this->Completed.empty())
  {
    return;
  }
  const EdgeRegister& edges = this->Tables.Edges;
  EdgeRegister filed;
  auto next = this->Completed.begin();
  for (Index edge = 0; edge < edges.Count(); ++edge)
  {
    const bool isCompleted = next != this->Completed.end() && next->Edge == edge;
    const auto copyFiled = [&](int family)
    {
      std::copy_if(edges.Crossing.begin() + edges.Offsets[edge],
        edges.Crossing.begin() + edges.Offsets[edge + 1], std::back_inserter(filed.Crossing),
        [&](Index c) { return this->Tables.Crossings.Family[c] == family; });
    };
    for (int family = 0; family < 2; ++family)
    {
      if (isCompleted && next->Family == family)
      {
        filed.Crossing.insert(filed.Crossing.end(), next->Crossings.begin(), next->Crossings.end());
      }
      else
      {
        copyFiled(family);
      }
    }
    filed.Offsets.push_back(static_cast<Index>(filed.Crossing.size()));
    next += isCompleted ? 1 : 0;
  }
  this->Tables.Edges = std::move(filed);
}

/// Whether the slice of a family at an edge is virtual.
bool EdgeSnipper::IsVirtual(Index edge, int family) const
{
  return IsVirtualSlice(this->Tables.Grid, this->Tables.EdgeOf(edge), family);
}

EdgeSnipper::Pairs EdgeSnipper::Match(const Lists& lists) const
{
  std::array<std::vector<double>, 2> positions;
  for (int family = 0; family < 2; ++family)
  {
    for (const Index c : lists[family])
    {
      positions[family].push_back(this->Tables.Crossings.Position[c]);
    }
  }
  Pairs pairs;
  MatchAlternating(positions[0], positions[1], pairs);
  return pairs;
}

/// Makes the crossings of both families on an edge the same in number and signs. `label` is that of
/// its lower end.
void EdgeSnipper::MatchEdge(Index edge, int label)
{
  const Index begin = this->Tables.Edges.Offsets[edge];
  const Index end = this->Tables.Edges.Offsets[edge + 1];
  Index middle = begin;
  while (middle < end && this->Tables.Crossings.Family[this->Tables.Edges.Crossing[middle]] == 0)
  {
    ++middle;
  }
  if (middle - begin == 1 && end - middle == 1)
  {
    return;
  }
  const Lists lists{ this->Alternate(begin, middle, label), this->Alternate(middle, end, label) };
  std::copy(lists[0].begin(), lists[0].end(), this->Tables.Edges.Crossing.begin() + begin);
  std::copy(lists[1].begin(), lists[1].end(), this->Tables.Edges.Crossing.begin() + middle);
  const Pairs pairs = this->Match(lists);
  if (2 * pairs.size() < static_cast<std::size_t>(end - begin))
  {
    this->MendEdge(edge, lists, pairs);
  }
}

/// Takes out what is unmatched on an edge, but gives what only a real slice has to a virtual one.
void EdgeSnipper::MendEdge(Index edge, const Lists& lists, const Pairs& pairs)
{
  std::vector<std::uint8_t> matched[2];
  matched[0].assign(lists[0].size(), 0);
  matched[1].assign(lists[1].size(), 0);
  for (const auto& pair : pairs)
  {
    matched[0][pair.first] = 1;
    matched[1][pair.second] = 1;
  }
  const bool isVirtual[2] = { this->IsVirtual(edge, 0), this->IsVirtual(edge, 1) };
  const std::size_t reported = this->Repairs.size();
  for (int family = 0; family < 2; ++family)
  {
    if (isVirtual[family] || !isVirtual[1 - family])
    {
      this->SnipUnmatched(lists[family], matched[family]);
    }
    else if (pairs.size() < lists[family].size())
    {
      this->AddMissing(edge, 1 - family, lists, pairs);
    }
  }
  this->SnippedEdges += this->Repairs.size() > reported ? 1 : 0;
}

/// Follows the label, which is now the same for both families, along every grid line.
Index EdgeSnipper::Run(const Execution& execution)
{
  GridEdge previous{ -1, 0, 0, 0 };
  int label = 0;
  ForInOrder(execution, static_cast<std::size_t>(this->Tables.Edges.Count()),
    [&](std::size_t number)
    {
      const Index e = static_cast<Index>(number);
      const GridEdge edge = this->Tables.EdgeOf(e);
      const int change = this->Tables.SignSum(e, 0);
      label = OnSameLine(edge, previous) ? label : this->Background;
      this->MatchEdge(e, label);
      label += change;
      previous = edge;
    });
  this->FileCompleted();
  return this->SnippedEdges;
}
}

Index SnipEdges(const CrossingTables& tables, int background, std::vector<Repair>& repairs,
  const Execution& execution)
{
  return EdgeSnipper(tables, background, repairs).Run(execution);
}
}
