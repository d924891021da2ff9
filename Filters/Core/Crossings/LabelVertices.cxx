// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/LabelVertices.h"

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

/// Finds the vertices of M on which the slices do not agree, and makes them agree there.
class VertexLabeller
{
public:
  VertexLabeller(const CrossingTables& tables, const AxisWeights& weights, int background)
    : Tables(tables)
    , Weights(weights)
    , Background(background)
  {
  }

  Index Run(const Execution& execution, std::vector<Repair>& repairs);

private:
  std::vector<Doubt> FindDoubts(const Execution& execution) const;
  void AddDoubts(
    const GridEdge& edge, Index end, const int winding[2], std::vector<Doubt>& doubts) const;
  std::vector<Correction> Decide(std::vector<Doubt>& doubts);
  bool IsVirtual(const std::array<Index, 3>& vertex, int axis) const
  {
    return this->Tables.Grid.IsVirtual(axis, vertex[axis]);
  }
  int Vote(const std::array<Index, 3>& vertex, const std::array<int, 3>& winding) const;
  bool DoRealAgree(const std::array<Index, 3>& vertex, const std::array<int, 3>& winding) const;
  Repair Describe(const Correction& correction) const;
  double DistanceTo(const GridEdge& edge, int family, double position) const;
  void InsertLoop(const Correction& correction);

  CrossingTables Tables;
  AxisWeights Weights;
  int Background;
  Index Vertices = 0; ///< on which the real slices do not agree
};

bool IsDoubtful(const int winding[2])
{
  return winding[0] != winding[1] || winding[0] < 0 || winding[0] > 1;
}

/// Adds the vertices from the upper end of the edge to the lower end of slab `end` of the same grid
/// line.
void VertexLabeller::AddDoubts(
  const GridEdge& edge, Index end, const int winding[2], std::vector<Doubt>& doubts) const
{
  std::array<Index, 3> place;
  place[FirstAxis(edge.Direction)] = edge.First;
  place[SecondAxis(edge.Direction)] = edge.Second;
  for (Index k = edge.Slab; k < end; ++k)
  {
    place[edge.Direction] = k;
    const std::uint64_t vertex =
      (static_cast<std::uint64_t>(place[0]) * this->Tables.Grid.Count(1) + place[1]) *
        this->Tables.Grid.Count(2) +
      place[2];
    doubts.push_back({ vertex, FirstAxis(edge.Direction), winding[0] });
    doubts.push_back({ vertex, SecondAxis(edge.Direction), winding[1] });
  }
}

/// Finds doubtful vertices by summing the signs of crossings along every grid line. A vertex with
/// any doubt is found on two of its three lines.
std::vector<Doubt> VertexLabeller::FindDoubts(const Execution& execution) const
{
  std::vector<Doubt> doubts;
  GridEdge previous{ -1, 0, 0, 0 };
  int winding[2] = { this->Background, this->Background };
  ForInOrder(execution, static_cast<std::size_t>(this->Tables.Edges.Count()),
    [&](std::size_t number)
    {
      const Index e = static_cast<Index>(number);
      const GridEdge edge = this->Tables.EdgeOf(e);
      if (!OnSameLine(edge, previous))
      {
        winding[0] = winding[1] = this->Background;
      }
      else if (IsDoubtful(winding))
      {
        this->AddDoubts(previous, edge.Slab, winding, doubts);
      }
      winding[0] += this->Tables.SignSum(e, 0);
      winding[1] += this->Tables.SignSum(e, 1);
      previous = edge;
    });
  return doubts;
}

/**
 * The label with the greater weight among the real slices. Between two of them that are as heavy
 * the virtual one decides; virtual ones alone are equal. Windings beyond 0 and 1 count as outside
 * and inside.
 */
int VertexLabeller::Vote(
  const std::array<Index, 3>& vertex, const std::array<int, 3>& winding) const
{
  double inside = 0.0;
  double outside = 0.0;
  int heaviest = -1;
  int virtually = 0; // more virtual slices inside than outside
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->IsVirtual(vertex, axis))
    {
      virtually += winding[axis] > 0 ? 1 : -1;
      continue;
    }
    (winding[axis] > 0 ? inside : outside) += this->Weights[axis];
    heaviest = heaviest < 0 || this->Weights[axis] > this->Weights[heaviest] ? axis : heaviest;
  }
  const bool isTied = heaviest < 0 || (inside == outside && inside > 0.0 && virtually != 0);
  return isTied ? virtually > 0 : inside != outside ? inside > outside : winding[heaviest] > 0;
}

/// Whether the real slices have one label at a vertex, inside or outside.
bool VertexLabeller::DoRealAgree(
  const std::array<Index, 3>& vertex, const std::array<int, 3>& winding) const
{
  int label = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!this->IsVirtual(vertex, axis))
    {
      if (winding[axis] < 0 || winding[axis] > 1 || (label >= 0 && label != winding[axis]))
      {
        return false;
      }
      label = winding[axis];
    }
  }
  return true;
}

/// The repair of a slice that is overruled at a vertex. REQUIRES: its crossings are not changed
/// yet.
Repair VertexLabeller::Describe(const Correction& correction) const
{
  const int u = FirstAxis(correction.Axis);
  const int v = SecondAxis(correction.Axis);
  const Index slice = correction.Vertex[correction.Axis];
  const Index i = correction.Vertex[u];
  const Index j = correction.Vertex[v];
  const double spacing =
    std::max(this->Tables.Grid.MeanSpacing(u), this->Tables.Grid.MeanSpacing(v));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Index above : { 0, 1 })
  {
    nearest = std::min(
      nearest, this->DistanceTo({ v, slice, i, j + above }, 0, this->Tables.Grid.Planes[v][j]));
    nearest = std::min(
      nearest, this->DistanceTo({ u, j, slice, i + above }, 1, this->Tables.Grid.Planes[u][i]));
  }
  Point3 where;
  for (int axis = 0; axis < 3; ++axis)
  {
    where[axis] = this->Tables.Grid.Planes[axis][correction.Vertex[axis]];
  }
  return { RepairKind::VertexRelabelled, correction.Axis, slice, where,
    std::isfinite(nearest) ? nearest : spacing };
}

/// Distance from a place on an edge to the nearest crossing of a family; infinite if there is
/// none.
double VertexLabeller::DistanceTo(const GridEdge& edge, int family, double position) const
{
  const std::uint64_t code = this->Tables.Code.Encode(edge);
  const auto codeOf = [this](Index e) {
    return this->Tables.Crossings.Edge[this->Tables.Edges.Crossing[this->Tables.Edges.Offsets[e]]];
  };
  Index low = 0;
  Index high = this->Tables.Edges.Count();
  while (low < high)
  {
    const Index middle = low + (high - low) / 2;
    codeOf(middle) < code ? low = middle + 1 : high = middle;
  }
  double nearest = std::numeric_limits<double>::infinity();
  if (low < this->Tables.Edges.Count() && codeOf(low) == code)
  {
    for (Index i = this->Tables.Edges.Offsets[low]; i < this->Tables.Edges.Offsets[low + 1]; ++i)
    {
      const Index crossing = this->Tables.Edges.Crossing[i];
      const double distance = std::abs(this->Tables.Crossings.Position[crossing] - position);
      nearest =
        this->Tables.Crossings.Family[crossing] == family ? std::min(nearest, distance) : nearest;
    }
  }
  return nearest;
}

/// Sorts the doubts by their vertices, and lets the slices vote at each.
std::vector<Correction> VertexLabeller::Decide(std::vector<Doubt>& doubts)
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
    const std::uint64_t nz = this->Tables.Grid.Count(2);
    const std::uint64_t ny = this->Tables.Grid.Count(1);
    const std::array<Index, 3> place{ static_cast<Index>(vertex / nz / ny),
      static_cast<Index>(vertex / nz % ny), static_cast<Index>(vertex % nz) };
    const int label = this->Vote(place, winding);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (winding[axis] != label)
      {
        corrections.push_back({ place, axis, label - winding[axis] });
      }
    }
    this->Vertices += this->DoRealAgree(place, winding) ? 0 : 1;
  }
  return corrections;
}

/// Inserts four crossings around a vertex, on the four edges that leave it within the slice.
void VertexLabeller::InsertLoop(const Correction& correction)
{
  const int u = FirstAxis(correction.Axis);
  const int v = SecondAxis(correction.Axis);
  const Index slice = correction.Vertex[correction.Axis];
  const Index i = correction.Vertex[u];
  const Index j = correction.Vertex[v];
  const double atU = this->Tables.Grid.Planes[u][i];
  const double atV = this->Tables.Grid.Planes[v][j];
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
  GridCrossings& crossings = this->Tables.Crossings;
  const Index first = crossings.Count();
  for (int s = 0; s < 4; ++s)
  {
    const Step& step = steps[turn > 0 ? s : 3 - s];
    const GridEdge edge =
      step.CrossesU ? GridEdge{ v, slice, i, step.Slab } : GridEdge{ u, j, slice, step.Slab };
    const Index c = crossings.Insert(this->Tables.Code.Encode(edge), step.CrossesU ? atV : atU,
      turn * step.Direction, step.CrossesU ? 0 : 1);
    crossings.Next[c] = first + (s + 1) % 4;
    crossings.Previous[c] = first + (s + 3) % 4;
  }
}

Index VertexLabeller::Run(const Execution& execution, std::vector<Repair>& repairs)
{
  std::vector<Doubt> doubts = this->FindDoubts(execution);
  const std::vector<Correction> corrections = this->Decide(doubts);
  for (const Correction& correction : corrections)
  {
    if (!this->IsVirtual(correction.Vertex, correction.Axis))
    {
      repairs.push_back(this->Describe(correction));
    }
  }
  for (const Correction& correction : corrections)
  {
    for (int i = 0; i < std::abs(correction.Amount); ++i)
    {
      this->InsertLoop(correction);
    }
  }
  if (!corrections.empty())
  {
    this->Tables.Edges = FileOnEdges(this->Tables.Crossings);
  }
  return this->Vertices;
}
}

Index LabelVertices(const CrossingTables& tables, const AxisWeights& weights, int background,
  std::vector<Repair>& repairs, const Execution& execution)
{
  return VertexLabeller(tables, weights, background).Run(execution, repairs);
}
}
