// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/AssembleContours.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace orthoslices
{
namespace
{
/// End `2 * piece` is the piece's first point, `2 * piece + 1` its last.
using End = Index;
constexpr End None = -1;

class Assembler
{
public:
  Assembler(
    const Pieces& pieces, double tolerance, Contours& contours, std::vector<Problem>& problems)
    : Input(pieces)
    , Tolerance(tolerance)
    , Output(contours)
    , Problems(problems)
  {
  }

  void Run();

private:
  Index First(Index piece) const { return this->Input.Offsets[piece]; }
  Index Last(Index piece) const { return this->Input.Offsets[piece + 1] - 1; }
  Index VertexOf(End end) const { return end & 1 ? this->Last(end / 2) : this->First(end / 2); }
  double Distance(Index a, Index b) const;
  Point3 World(Index vertex) const;
  bool Same(Index a, Index b) const;
  std::uint64_t Hash(Index vertex) const;

  bool IsLoose(Index piece) const { return !this->Input.Closed[piece] && this->Keep[piece]; }
  void RejectNotFinite();
  void JoinCoincidentEnds();
  void JoinGroup(std::vector<End>& ends);
  void DropDuplicateSegments(std::vector<End>& ends);
  void PairByAngle(std::vector<End>& ends);
  void JoinNearEnds();
  bool ClosesItself(Index piece) const;
  void FollowFrom(Index piece);

  void AddVertices(Index piece, bool forward);
  void AddVertex(Index vertex);
  void FinishContour(Index piece);
  void Report(ProblemKind kind, std::int64_t cell, Index vertex);

  const Pieces& Input;
  double Tolerance;
  Contours& Output;
  std::vector<Problem>& Problems;
  std::vector<End> Link; ///< the end that each end is joined to
  std::vector<std::uint8_t> Keep;
  double CurrentW = 0.0;     ///< plane of the contour that is being built
  Index OffPlaneVertex = -1; ///< its vertex farthest from the plane, if beyond the tolerance
};

double Assembler::Distance(Index a, Index b) const
{
  const double u = this->Input.U[a] - this->Input.U[b];
  const double v = this->Input.V[a] - this->Input.V[b];
  const double w = this->Input.W[a] - this->Input.W[b];
  return std::sqrt(u * u + v * v + w * w);
}

Point3 Assembler::World(Index vertex) const
{
  Point3 point;
  point[this->Input.Axis] = this->Input.W[vertex];
  point[FirstAxis(this->Input.Axis)] = this->Input.U[vertex];
  point[SecondAxis(this->Input.Axis)] = this->Input.V[vertex];
  return point;
}

bool Assembler::Same(Index a, Index b) const
{
  return this->Input.U[a] == this->Input.U[b] && this->Input.V[a] == this->Input.V[b] &&
    this->Input.W[a] == this->Input.W[b];
}

std::uint64_t Assembler::Hash(Index vertex) const
{
  std::uint64_t hash = 0;
  for (double x : { this->Input.U[vertex], this->Input.V[vertex], this->Input.W[vertex] })
  {
    x += 0.0; // -0.0 and 0.0 are the same place
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
  }
  return hash;
}

void Assembler::Report(ProblemKind kind, std::int64_t cell, Index vertex)
{
  this->Problems.push_back({ kind, this->Input.Axis, cell, this->World(vertex), 0.0, true });
}

void Assembler::RejectNotFinite()
{
  for (Index piece = 0; piece < this->Input.Count(); ++piece)
  {
    for (Index i = this->First(piece); i <= this->Last(piece); ++i)
    {
      if (!std::isfinite(this->Input.U[i] + this->Input.V[i] + this->Input.W[i]))
      {
        this->Report(ProblemKind::NotFinite, this->Input.Cell[piece], i);
        this->Keep[piece] = 0;
        break;
      }
    }
  }
}

/// Groups the ends by place. Sorting hashes is several times faster than sorting coordinates.
void Assembler::JoinCoincidentEnds()
{
  std::vector<std::pair<std::uint64_t, End>> keys;
  for (Index piece = 0; piece < this->Input.Count(); ++piece)
  {
    if (this->IsLoose(piece))
    {
      keys.emplace_back(this->Hash(this->First(piece)), 2 * piece);
      keys.emplace_back(this->Hash(this->Last(piece)), 2 * piece + 1);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<End> group;
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    group.push_back(keys[i].second);
    const bool last = i + 1 == keys.size() ||
      !this->Same(this->VertexOf(group[0]), this->VertexOf(keys[i + 1].second));
    if (last)
    {
      this->JoinGroup(group);
      group.clear();
    }
  }
}

void Assembler::JoinGroup(std::vector<End>& ends)
{
  if (ends.size() > 2)
  {
    this->DropDuplicateSegments(ends);
  }
  if (ends.size() > 2)
  {
    this->PairByAngle(ends);
  }
  else if (ends.size() == 2)
  {
    this->Link[ends[0]] = ends[1];
    this->Link[ends[1]] = ends[0];
  }
}

/// A cutter that meets a mesh edge in its plane leaves one segment for each side of the edge.
void Assembler::DropDuplicateSegments(std::vector<End>& ends)
{
  std::vector<End> kept;
  for (const End end : ends)
  {
    const Index piece = end / 2;
    const bool segment = this->Last(piece) - this->First(piece) == 1;
    const bool duplicate = segment &&
      std::any_of(kept.begin(), kept.end(),
        [&](End other)
        {
          return other / 2 != piece && this->Last(other / 2) - this->First(other / 2) == 1 &&
            this->Same(this->VertexOf(other ^ 1), this->VertexOf(end ^ 1));
        });
    if (duplicate || !this->Keep[piece])
    {
      // The smallest index is kept, here and at the segment's other end: groups are sorted.
      this->Keep[piece] = 0;
    }
    else
    {
      kept.push_back(end);
    }
  }
  ends.swap(kept);
}

/// Where contours touch at a point, neighbours by angle belong together: no two of them cross.
void Assembler::PairByAngle(std::vector<End>& ends)
{
  std::vector<std::pair<double, End>> angles;
  for (const End end : ends)
  {
    const Index at = this->VertexOf(end);
    const Index next = end & 1 ? at - 1 : at + 1;
    angles.emplace_back(
      std::atan2(this->Input.V[next] - this->Input.V[at], this->Input.U[next] - this->Input.U[at]),
      end);
  }
  std::sort(angles.begin(), angles.end());
  double evenGaps = 0.0;
  for (std::size_t i = 0; i + 1 < angles.size(); i += 2)
  {
    evenGaps += angles[i + 1].first - angles[i].first;
  }
  constexpr double pi = 3.14159265358979323846;
  const std::size_t shift = evenGaps <= pi ? 0 : 1;
  const std::size_t count = angles.size() & ~std::size_t(1);
  for (std::size_t i = 0; i < count; i += 2)
  {
    const End a = angles[(i + shift) % count].second;
    const End b = angles[(i + 1 + shift) % count].second;
    this->Link[a] = b;
    this->Link[b] = a;
  }
}

/// What is still loose is joined to the nearest loose end within the tolerance.
void Assembler::JoinNearEnds()
{
  std::vector<End> loose;
  for (End end = 0; end < 2 * this->Input.Count(); ++end)
  {
    if (this->IsLoose(end / 2) && this->Link[end] == None)
    {
      loose.push_back(end);
    }
  }
  const auto& u = this->Input.U;
  std::sort(loose.begin(), loose.end(),
    [&](End a, End b)
    {
      const double ua = u[this->VertexOf(a)];
      const double ub = u[this->VertexOf(b)];
      return ua != ub ? ua < ub : a < b;
    });
  for (std::size_t i = 0; i < loose.size(); ++i)
  {
    const Index at = this->VertexOf(loose[i]);
    End nearest = None;
    double minimum = this->Tolerance;
    for (std::size_t j = i + 1; j < loose.size() && this->Link[loose[i]] == None; ++j)
    {
      const Index other = this->VertexOf(loose[j]);
      if (u[other] - u[at] > this->Tolerance)
      {
        break;
      }
      if (this->Link[loose[j]] == None && this->Distance(at, other) <= minimum)
      {
        nearest = loose[j];
        minimum = this->Distance(at, other);
      }
    }
    if (nearest != None)
    {
      this->Link[loose[i]] = nearest;
      this->Link[nearest] = loose[i];
    }
  }
}

bool Assembler::ClosesItself(Index piece) const
{
  if (this->Last(piece) - this->First(piece) < 2)
  {
    return false;
  }
  double longest = 0.0;
  for (Index i = this->First(piece); i < this->Last(piece); ++i)
  {
    longest = std::max(longest, this->Distance(i, i + 1));
  }
  return this->Distance(this->First(piece), this->Last(piece)) <= 2.0 * longest;
}

void Assembler::AddVertices(Index piece, bool forward)
{
  const Index first = this->First(piece);
  const Index last = this->Last(piece);
  for (Index i = first; i <= last; ++i)
  {
    this->AddVertex(forward ? i : last - (i - first));
  }
}

void Assembler::AddVertex(Index vertex)
{
  const bool begins = static_cast<Index>(this->Output.U.size()) == this->Output.Offsets.back();
  if (begins)
  {
    this->CurrentW = this->Input.W[vertex];
    this->OffPlaneVertex = -1;
  }
  if (std::abs(this->Input.W[vertex] - this->CurrentW) > this->Tolerance)
  {
    this->OffPlaneVertex = this->OffPlaneVertex < 0 ? vertex : this->OffPlaneVertex;
  }
  if (begins || this->Input.U[vertex] != this->Output.U.back() ||
    this->Input.V[vertex] != this->Output.V.back())
  {
    this->Output.U.push_back(this->Input.U[vertex]);
    this->Output.V.push_back(this->Input.V[vertex]);
  }
}

/// Ends the contour, which is named after one of its pieces.
void Assembler::FinishContour(Index piece)
{
  const std::int64_t cell = this->Input.Cell[piece];
  Contours& out = this->Output;
  const std::size_t begin = out.Offsets.back();
  while (out.U.size() > begin + 1 && out.U.back() == out.U[begin] && out.V.back() == out.V[begin])
  {
    out.U.pop_back();
    out.V.pop_back();
  }
  if (this->OffPlaneVertex >= 0)
  {
    this->Report(ProblemKind::OffPlane, cell, this->OffPlaneVertex);
  }
  if (this->OffPlaneVertex >= 0 || out.U.size() < begin + 3)
  {
    out.U.resize(begin);
    out.V.resize(begin);
    return;
  }
  out.Offsets.push_back(static_cast<Index>(out.U.size()));
  out.Axis.push_back(static_cast<std::int8_t>(this->Input.Axis));
  out.Coordinate.push_back(this->CurrentW);
  out.Cell.push_back(cell);
  if (!this->Input.Virtual.empty() || !out.Virtual.empty())
  {
    out.Virtual.resize(out.Axis.size(), 0);
    out.Virtual.back() = this->Input.IsVirtual(piece) ? 1 : 0;
  }
}

/// Follows the links from a piece until they return to it, or to a loose end.
void Assembler::FollowFrom(Index piece)
{
  End end = 2 * piece + 1;
  while (this->Link[end] != None && this->Link[end] / 2 != piece)
  {
    end = this->Link[end] ^ 1;
  }
  if (this->Link[end] == None)
  {
    this->Report(ProblemKind::Open, this->Input.Cell[end / 2], this->VertexOf(end));
  }
  const bool open = this->Link[end] == None;
  // From the loose end just found, or from the piece itself, the other way round through all
  // pieces.
  const End start = open ? end : 2 * piece;
  for (End at = start; at != None && this->Keep[at / 2]; at = this->Link[at ^ 1])
  {
    this->Keep[at / 2] = 0;
    if (!open)
    {
      this->AddVertices(at / 2, (at & 1) == 0);
    }
  }
  if (!open)
  {
    this->FinishContour(piece);
  }
}

void Assembler::Run()
{
  this->Link.assign(2 * static_cast<std::size_t>(this->Input.Count()), None);
  this->Keep.assign(this->Input.Count(), 1);
  this->Output.U.reserve(this->Output.U.size() + this->Input.U.size());
  this->Output.V.reserve(this->Output.V.size() + this->Input.V.size());
  this->RejectNotFinite();
  this->JoinCoincidentEnds();
  this->JoinNearEnds();
  for (Index piece = 0; piece < this->Input.Count(); ++piece)
  {
    if (!this->Keep[piece])
    {
      continue;
    }
    const bool alone = this->Link[2 * piece] == None && this->Link[2 * piece + 1] == None;
    if (this->Input.Closed[piece] || (alone && this->ClosesItself(piece)))
    {
      this->AddVertices(piece, true);
      this->FinishContour(piece);
    }
    else
    {
      this->FollowFrom(piece);
    }
  }
}
}

void AssembleContours(
  Pieces&& pieces, double tolerance, Contours& contours, std::vector<Problem>& problems)
{
  const Pieces input = std::move(pieces);
  Assembler(input, tolerance, contours, problems).Run();
}
}
