// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/JoinPieces.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace orthoslices
{
namespace
{
/// End `2 * piece` is the piece's first point, `2 * piece + 1` its last.
using End = Index;
constexpr End None = -1;

class PieceJoiner
{
public:
  PieceJoiner(const Pieces& pieces, const std::vector<std::uint8_t>& isUsable, double tolerance)
    : Input(pieces)
    , Tolerance(tolerance)
    , Partner(2 * static_cast<std::size_t>(pieces.Count()), None)
    , IsFree(isUsable)
  {
  }

  PieceChains Run();

private:
  Index First(Index piece) const { return this->Input.Offsets[piece]; }
  Index Last(Index piece) const { return this->Input.Offsets[piece + 1] - 1; }
  Index VertexOf(End end) const { return end & 1 ? this->Last(end / 2) : this->First(end / 2); }
  double Distance(Index a, Index b) const;
  bool Same(Index a, Index b) const;
  std::uint64_t Hash(Index vertex) const;

  /// Whether a piece has ends to be joined. One of a single point has no direction, and joins
  /// nothing.
  bool IsLoose(Index piece) const
  {
    return !this->Input.Closed[piece] && this->IsFree[piece] &&
      this->First(piece) < this->Last(piece);
  }
  void JoinCoincidentEnds();
  void JoinGroup(std::vector<End>& ends);
  void DropDuplicateSegments(std::vector<End>& ends);
  void PairByAngle(std::vector<End>& ends);
  void JoinNearEnds();
  void FollowFrom(Index piece, PieceChains& chains);

  const Pieces& Input;
  double Tolerance;
  std::vector<End> Partner;         ///< the end that each end is joined to
  std::vector<std::uint8_t> IsFree; ///< usable, and not in a chain
};

double PieceJoiner::Distance(Index a, Index b) const
{
  const double u = this->Input.U[a] - this->Input.U[b];
  const double v = this->Input.V[a] - this->Input.V[b];
  const double w = this->Input.W[a] - this->Input.W[b];
  return std::sqrt(u * u + v * v + w * w);
}

bool PieceJoiner::Same(Index a, Index b) const
{
  return this->Input.U[a] == this->Input.U[b] && this->Input.V[a] == this->Input.V[b] &&
    this->Input.W[a] == this->Input.W[b];
}

std::uint64_t PieceJoiner::Hash(Index vertex) const
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

/// Groups the ends by place. Sorting hashes is several times faster than sorting coordinates.
void PieceJoiner::JoinCoincidentEnds()
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

void PieceJoiner::JoinGroup(std::vector<End>& ends)
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
    this->Partner[ends[0]] = ends[1];
    this->Partner[ends[1]] = ends[0];
  }
}

/// A cutter that meets a mesh edge in its plane leaves one segment for each side of the edge.
void PieceJoiner::DropDuplicateSegments(std::vector<End>& ends)
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
    if (duplicate || !this->IsFree[piece])
    {
      // The smallest index is kept, here and at the segment's other end: groups are sorted.
      this->IsFree[piece] = 0;
    }
    else
    {
      kept.push_back(end);
    }
  }
  ends.swap(kept);
}

/// Where contours touch at a point, neighbours by angle belong together: no two of them cross.
void PieceJoiner::PairByAngle(std::vector<End>& ends)
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
    this->Partner[a] = b;
    this->Partner[b] = a;
  }
}

/// What is still loose is joined to the nearest loose end within the tolerance.
void PieceJoiner::JoinNearEnds()
{
  std::vector<End> loose;
  for (End end = 0; end < 2 * this->Input.Count(); ++end)
  {
    if (this->IsLoose(end / 2) && this->Partner[end] == None)
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
    for (std::size_t j = i + 1; j < loose.size() && this->Partner[loose[i]] == None; ++j)
    {
      const Index other = this->VertexOf(loose[j]);
      if (u[other] - u[at] > this->Tolerance)
      {
        break;
      }
      if (this->Partner[loose[j]] == None && this->Distance(at, other) <= minimum)
      {
        nearest = loose[j];
        minimum = this->Distance(at, other);
      }
    }
    if (nearest != None)
    {
      this->Partner[loose[i]] = nearest;
      this->Partner[nearest] = loose[i];
    }
  }
}

/// Follows the joints from a piece until they return to it, or to a loose end.
void PieceJoiner::FollowFrom(Index piece, PieceChains& chains)
{
  End end = 2 * piece + 1;
  while (this->Partner[end] != None && this->Partner[end] / 2 != piece)
  {
    end = this->Partner[end] ^ 1;
  }
  bool open = this->Partner[end] == None;
  // From the loose end just found, or from the piece itself, the other way round through all
  // pieces.
  const End start = open ? end : 2 * piece;
  for (End at = start; at != None && this->IsFree[at / 2]; at = this->Partner[at ^ 1])
  {
    this->IsFree[at / 2] = 0;
    chains.Links.push_back({ at / 2, (at & 1) == 0 });
  }
  if (this->IsFree[piece])
  {
    // It was joined to a piece that has turned out to be a duplicate: it is left alone.
    this->IsFree[piece] = 0;
    chains.Links.push_back({ piece, true });
    open = true;
  }
  chains.Closed.push_back(open ? 0 : 1);
  chains.Offsets.push_back(static_cast<Index>(chains.Links.size()));
}

PieceChains PieceJoiner::Run()
{
  this->JoinCoincidentEnds();
  this->JoinNearEnds();
  PieceChains chains;
  for (Index piece = 0; piece < this->Input.Count(); ++piece)
  {
    if (!this->IsFree[piece])
    {
      continue;
    }
    if (this->Input.Closed[piece])
    {
      chains.Links.push_back({ piece, true });
      chains.Closed.push_back(1);
      chains.Offsets.push_back(static_cast<Index>(chains.Links.size()));
    }
    else
    {
      this->FollowFrom(piece, chains);
    }
  }
  return chains;
}
}

PieceChains JoinPieces(
  const Pieces& pieces, const std::vector<std::uint8_t>& isUsable, double tolerance)
{
  return PieceJoiner(pieces, isUsable, tolerance).Run();
}
}
