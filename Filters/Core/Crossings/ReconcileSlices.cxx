// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/ReconcileSlices.h"

#include "Core/Crossings/MatchAlternating.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// A vertex of M where the slice across `Axis` has a doubtful winding number.
struct Doubt
{
  std::uint64_t Vertex;
  int Axis;
  int Winding;
};

/// Adds `Amount` loops (counter-clockwise if positive) around a vertex to its slice across Axis.
struct Correction
{
  std::array<Index, 3> Vertex;
  int Axis;
  int Amount;
};

class Reconciler
{
public:
  Reconciler(const SpatialGrid& grid, GridCrossings& crossings, EdgeRegister& edges,
    std::vector<IsolatedLoop>& isolated, const AxisWeights& weights, int background)
    : Grid(grid)
    , Code(grid)
    , Crossings(crossings)
    , Edges(edges)
    , Isolated(isolated)
    , Weights(weights)
    , Background(background)
  {
  }

  Reconciliation Run();

private:
  GridEdge EdgeOf(Index edge) const
  {
    return this->Code.Decode(this->Crossings.Edge[this->Edges.Crossing[this->Edges.Offsets[edge]]]);
  }
  std::vector<Doubt> FindDoubts() const;
  int SignSum(Index edge, int family) const;
  void AddDoubts(
    const GridEdge& edge, Index end, const int winding[2], std::vector<Doubt>& doubts) const;
  std::vector<Correction> Decide(std::vector<Doubt>& doubts);
  int Vote(const std::array<int, 3>& winding) const;
  void ReportVertex(const Correction& correction);
  double DistanceTo(const GridEdge& edge, int family, double position) const;
  void InsertLoop(const Correction& correction);

  void MatchEdges();
  void MatchEdge(Index edge, int label);
  std::vector<Index> Alternate(Index begin, Index end, int label);
  void SnipUnmatched(const std::vector<Index>& list, const std::vector<std::uint8_t>& matched);
  bool IsInserted(Index crossing) const;
  void ReportSnip(Index a, Index b);
  void Snip(Index a, Index b);
  void JoinArcs(Index incoming, Index outgoing);
  void AddIsolated(Index firstRun);

  const SpatialGrid& Grid;
  GridEdgeCode Code;
  GridCrossings& Crossings;
  EdgeRegister& Edges;
  std::vector<IsolatedLoop>& Isolated;
  AxisWeights Weights;
  int Background;
  Reconciliation Report;
};

int Reconciler::SignSum(Index edge, int family) const
{
  int sum = 0;
  for (Index i = this->Edges.Offsets[edge]; i < this->Edges.Offsets[edge + 1]; ++i)
  {
    const Index crossing = this->Edges.Crossing[i];
    sum += this->Crossings.Family[crossing] == family ? this->Crossings.Sign(crossing) : 0;
  }
  return sum;
}

bool OnSameLine(const GridEdge& a, const GridEdge& b)
{
  return a.Direction == b.Direction && a.First == b.First && a.Second == b.Second;
}

bool IsDoubtful(const int winding[2])
{
  return winding[0] != winding[1] || winding[0] < 0 || winding[0] > 1;
}

/// Vertices from the upper end of the edge to the lower end of slab `end` of the same grid line.
void Reconciler::AddDoubts(
  const GridEdge& edge, Index end, const int winding[2], std::vector<Doubt>& doubts) const
{
  std::array<Index, 3> place;
  place[FirstAxis(edge.Direction)] = edge.First;
  place[SecondAxis(edge.Direction)] = edge.Second;
  for (Index k = edge.Slab; k < end; ++k)
  {
    place[edge.Direction] = k;
    const std::uint64_t vertex =
      (static_cast<std::uint64_t>(place[0]) * this->Grid.Count(1) + place[1]) *
        this->Grid.Count(2) +
      place[2];
    doubts.push_back({ vertex, FirstAxis(edge.Direction), winding[0] });
    doubts.push_back({ vertex, SecondAxis(edge.Direction), winding[1] });
  }
}

/// Sums the signs along every grid line. A vertex with any doubt is found on two of its three
/// lines.
std::vector<Doubt> Reconciler::FindDoubts() const
{
  std::vector<Doubt> doubts;
  GridEdge previous{ -1, 0, 0, 0 };
  int winding[2] = { this->Background, this->Background };
  for (Index e = 0; e < this->Edges.Count(); ++e)
  {
    const GridEdge edge = this->EdgeOf(e);
    if (!OnSameLine(edge, previous))
    {
      winding[0] = winding[1] = this->Background;
    }
    else if (IsDoubtful(winding))
    {
      this->AddDoubts(previous, edge.Slab, winding, doubts);
    }
    winding[0] += this->SignSum(e, 0);
    winding[1] += this->SignSum(e, 1);
    previous = edge;
  }
  return doubts;
}

/// The label with the greater weight. Windings beyond 0 and 1 count as outside and inside.
int Reconciler::Vote(const std::array<int, 3>& winding) const
{
  double inside = 0.0;
  double outside = 0.0;
  int heaviest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    (winding[axis] > 0 ? inside : outside) += this->Weights[axis];
    heaviest = this->Weights[axis] > this->Weights[heaviest] ? axis : heaviest;
  }
  return inside != outside ? inside > outside : winding[heaviest] > 0;
}

/// Records that a slice was overruled at a vertex, before its crossings are changed.
void Reconciler::ReportVertex(const Correction& correction)
{
  const int u = FirstAxis(correction.Axis);
  const int v = SecondAxis(correction.Axis);
  const Index slice = correction.Vertex[correction.Axis];
  const Index i = correction.Vertex[u];
  const Index j = correction.Vertex[v];
  const double spacing = std::max(this->Grid.MeanSpacing(u), this->Grid.MeanSpacing(v));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Index above : { 0, 1 })
  {
    nearest =
      std::min(nearest, this->DistanceTo({ v, slice, i, j + above }, 0, this->Grid.Planes[v][j]));
    nearest =
      std::min(nearest, this->DistanceTo({ u, j, slice, i + above }, 1, this->Grid.Planes[u][i]));
  }
  Point3 where;
  for (int axis = 0; axis < 3; ++axis)
  {
    where[axis] = this->Grid.Planes[axis][correction.Vertex[axis]];
  }
  this->Report.Repairs.push_back({ RepairKind::VertexRelabelled, correction.Axis, slice, where,
    std::isfinite(nearest) ? nearest : spacing });
}

/// Distance from a place on an edge to the nearest crossing of a family; infinite if there is
/// none.
double Reconciler::DistanceTo(const GridEdge& edge, int family, double position) const
{
  const std::uint64_t code = this->Code.Encode(edge);
  const auto codeOf = [this](Index e)
  { return this->Crossings.Edge[this->Edges.Crossing[this->Edges.Offsets[e]]]; };
  Index low = 0;
  Index high = this->Edges.Count();
  while (low < high)
  {
    const Index middle = low + (high - low) / 2;
    codeOf(middle) < code ? low = middle + 1 : high = middle;
  }
  double nearest = std::numeric_limits<double>::infinity();
  if (low < this->Edges.Count() && codeOf(low) == code)
  {
    for (Index i = this->Edges.Offsets[low]; i < this->Edges.Offsets[low + 1]; ++i)
    {
      const Index crossing = this->Edges.Crossing[i];
      const double distance = std::abs(this->Crossings.Position[crossing] - position);
      nearest = this->Crossings.Family[crossing] == family ? std::min(nearest, distance) : nearest;
    }
  }
  return nearest;
}

std::vector<Correction> Reconciler::Decide(std::vector<Doubt>& doubts)
{
  std::sort(doubts.begin(), doubts.end(),
    [](const Doubt& a, const Doubt& b)
    { return a.Vertex != b.Vertex ? a.Vertex < b.Vertex : a.Axis < b.Axis; });
  std::vector<Correction> corrections;
  for (std::size_t i = 0; i < doubts.size();)
  {
    const std::uint64_t vertex = doubts[i].Vertex;
    std::array<int, 3> winding;
    winding.fill(this->Background);
    for (; i < doubts.size() && doubts[i].Vertex == vertex; ++i)
    {
      winding[doubts[i].Axis] = doubts[i].Winding;
    }
    const int label = this->Vote(winding);
    const std::uint64_t nz = this->Grid.Count(2);
    const std::uint64_t ny = this->Grid.Count(1);
    const std::array<Index, 3> place{ static_cast<Index>(vertex / nz / ny),
      static_cast<Index>(vertex / nz % ny), static_cast<Index>(vertex % nz) };
    for (int axis = 0; axis < 3; ++axis)
    {
      if (winding[axis] != label)
      {
        corrections.push_back({ place, axis, label - winding[axis] });
      }
    }
    ++this->Report.Vertices;
  }
  return corrections;
}

/// Four crossings around the vertex, on the four edges that leave it within the slice.
void Reconciler::InsertLoop(const Correction& correction)
{
  const int u = FirstAxis(correction.Axis);
  const int v = SecondAxis(correction.Axis);
  const Index slice = correction.Vertex[correction.Axis];
  const Index i = correction.Vertex[u];
  const Index j = correction.Vertex[v];
  const double atU = this->Grid.Planes[u][i];
  const double atV = this->Grid.Planes[v][j];
  // Counter-clockwise from the upper right face.
  struct Step
  {
    bool CrossesU;
    Index Slab;
    int Direction;
  };
  const Step steps[4] = { { true, j + 1, -1 }, { false, i, -1 }, { true, j, 1 },
    { false, i + 1, 1 } };
  const int turn = correction.Amount > 0 ? 1 : -1;
  const Index first = this->Crossings.Count();
  this->Crossings.Resize(first + 4);
  for (int s = 0; s < 4; ++s)
  {
    const Index c = first + s;
    const Step& step = steps[turn > 0 ? s : 3 - s];
    const GridEdge edge =
      step.CrossesU ? GridEdge{ v, slice, i, step.Slab } : GridEdge{ u, j, slice, step.Slab };
    this->Crossings.Edge[c] = this->Code.Encode(edge);
    this->Crossings.Position[c] = step.CrossesU ? atV : atU;
    this->Crossings.Direction[c] = static_cast<std::int8_t>(turn * step.Direction);
    this->Crossings.Family[c] = step.CrossesU ? 0 : 1;
    this->Crossings.Next[c] = first + (s + 1) % 4;
    this->Crossings.Previous[c] = first + (s + 3) % 4;
    this->Crossings.RunContour[c] = GridCrossings::None;
    this->Crossings.RunFirst[c] = 0;
    this->Crossings.RunCount[c] = 0;
    this->Crossings.RunNext[c] = GridCrossings::None;
    this->Crossings.ArcLastRun[c] = c;
  }
}

/**
 * The crossings of one family on an edge in alternating order, from the label at the edge's lower
 * end. They already alternate unless contours touch or cross, or a loop was inserted; then rising
 * and falling ones are interleaved, each in their order, and positions are made ascending again.
 */
std::vector<Index> Reconciler::Alternate(Index begin, Index end, int label)
{
  std::vector<Index> list(this->Edges.Crossing.begin() + begin, this->Edges.Crossing.begin() + end);
  int expected = label == 0 ? 1 : -1;
  bool alternates = true;
  for (const Index c : list)
  {
    alternates &= this->Crossings.Sign(c) == expected;
    expected = -expected;
  }
  if (alternates)
  {
    return list;
  }
  std::vector<Index> rising, falling;
  for (const Index c : list)
  {
    (this->Crossings.Sign(c) > 0 ? rising : falling).push_back(c);
  }
  bool rises = label == 0;
  auto rise = rising.begin();
  auto fall = falling.begin();
  double position = this->Crossings.Position[list.front()];
  for (Index& c : list)
  {
    c = rises ? *rise++ : *fall++;
    rises = !rises;
    position = std::max(position, this->Crossings.Position[c]);
    this->Crossings.Position[c] = position;
  }
  return list;
}

void Reconciler::JoinArcs(Index incoming, Index outgoing)
{
  const Index arc = this->Crossings.Previous[incoming];
  if (arc == outgoing)
  {
    this->AddIsolated(outgoing);
    return;
  }
  this->Crossings.RunNext[this->Crossings.ArcLastRun[arc]] = outgoing;
  this->Crossings.ArcLastRun[arc] = this->Crossings.ArcLastRun[outgoing];
  this->Crossings.Next[arc] = this->Crossings.Next[outgoing];
  this->Crossings.Previous[this->Crossings.Next[outgoing]] = arc;
}

void Reconciler::AddIsolated(Index firstRun)
{
  Index vertices = 0;
  for (Index run = firstRun; run != GridCrossings::None; run = this->Crossings.RunNext[run])
  {
    vertices += this->Crossings.RunCount[run];
  }
  if (vertices >= 3)
  {
    this->Isolated.push_back({ firstRun, GridCrossings::None });
  }
}

/// Whether a crossing belongs to a loop around a vertex, which is reported there.
bool Reconciler::IsInserted(Index crossing) const
{
  return this->Crossings.RunContour[crossing] == GridCrossings::None;
}

void Reconciler::ReportSnip(Index a, Index b)
{
  const double from = this->Crossings.Position[a];
  const double to = this->Crossings.Position[b];
  const GridEdge edge = this->Code.Decode(this->Crossings.Edge[a]);
  const bool first = this->Crossings.Family[a] == 0;
  this->Report.Repairs.push_back(
    { RepairKind::CrossingsSnipped, first ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction),
      first ? edge.First : edge.Second,
      CrossingPoint(this->Grid, this->Code, this->Crossings.Edge[a], from + 0.5 * (to - from)),
      std::abs(to - from) });
}

/// On each side of the crossed plane, the arc that ends at one of the two goes on from the other.
void Reconciler::Snip(Index a, Index b)
{
  if (!this->IsInserted(a) || !this->IsInserted(b))
  {
    this->ReportSnip(a, b);
  }
  this->JoinArcs(a, b);
  this->JoinArcs(b, a);
  this->Crossings.Next[a] = GridCrossings::Removed;
  this->Crossings.Next[b] = GridCrossings::Removed;
}

void Reconciler::SnipUnmatched(
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

void Reconciler::MatchEdge(Index edge, int label)
{
  const Index begin = this->Edges.Offsets[edge];
  const Index end = this->Edges.Offsets[edge + 1];
  Index middle = begin;
  while (middle < end && this->Crossings.Family[this->Edges.Crossing[middle]] == 0)
  {
    ++middle;
  }
  if (middle - begin == 1 && end - middle == 1)
  {
    return;
  }
  const std::vector<Index> lists[2] = { this->Alternate(begin, middle, label),
    this->Alternate(middle, end, label) };
  std::copy(lists[0].begin(), lists[0].end(), this->Edges.Crossing.begin() + begin);
  std::copy(lists[1].begin(), lists[1].end(), this->Edges.Crossing.begin() + middle);
  std::vector<double> positions[2];
  std::vector<std::uint8_t> matched[2];
  for (int family = 0; family < 2; ++family)
  {
    for (const Index c : lists[family])
    {
      positions[family].push_back(this->Crossings.Position[c]);
    }
    matched[family].assign(lists[family].size(), 0);
  }
  std::vector<std::pair<Index, Index>> pairs;
  MatchAlternating(positions[0], positions[1], pairs);
  for (const auto& pair : pairs)
  {
    matched[0][pair.first] = 1;
    matched[1][pair.second] = 1;
  }
  if (2 * pairs.size() < static_cast<std::size_t>(end - begin))
  {
    const std::size_t reported = this->Report.Repairs.size();
    this->SnipUnmatched(lists[0], matched[0]);
    this->SnipUnmatched(lists[1], matched[1]);
    this->Report.Edges += this->Report.Repairs.size() > reported ? 1 : 0;
  }
}

/// Follows the label, which is now the same for both families, along every grid line.
void Reconciler::MatchEdges()
{
  GridEdge previous{ -1, 0, 0, 0 };
  int label = 0;
  for (Index e = 0; e < this->Edges.Count(); ++e)
  {
    const GridEdge edge = this->EdgeOf(e);
    const int change = this->SignSum(e, 0);
    label = OnSameLine(edge, previous) ? label : this->Background;
    this->MatchEdge(e, label);
    label += change;
    previous = edge;
  }
}

Reconciliation Reconciler::Run()
{
  std::vector<Doubt> doubts = this->FindDoubts();
  const std::vector<Correction> corrections = this->Decide(doubts);
  for (const Correction& correction : corrections)
  {
    this->ReportVertex(correction);
  }
  for (const Correction& correction : corrections)
  {
    for (int i = 0; i < std::abs(correction.Amount); ++i)
    {
      this->InsertLoop(correction);
    }
  }
  if (this->Report.Vertices > 0)
  {
    this->Edges = FileOnEdges(this->Crossings);
  }
  this->MatchEdges();
  return this->Report;
}
}

Reconciliation ReconcileSlices(const SpatialGrid& grid, GridCrossings& crossings,
  EdgeRegister& edges, std::vector<IsolatedLoop>& isolated, const AxisWeights& weights,
  int background)
{
  return Reconciler(grid, crossings, edges, isolated, weights, background).Run();
}
}
