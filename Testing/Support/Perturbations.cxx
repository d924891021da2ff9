// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Perturbations.h"

#include "Support/PieceList.h"
#include "Support/Random.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace orthoslices
{
namespace support
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Calls change(vertices of one slice, random numbers) for every plane of every axis.
template <typename Change>
void ForEachSlice(PieceSets& sets, std::uint64_t seed, Change&& change)
{
  Random random(seed);
  for (Pieces& pieces : sets)
  {
    std::map<double, std::vector<Index>> slices;
    for (Index i = 0; i < pieces.Count(); ++i)
    {
      const double plane = pieces.W[pieces.Offsets[i]];
      for (Index vertex = pieces.Offsets[i]; vertex < pieces.Offsets[i + 1]; ++vertex)
      {
        slices[plane].push_back(vertex);
      }
    }
    for (const auto& slice : slices)
    {
      change(pieces, slice.second, random);
    }
  }
}
}

void MoveVertices(PieceSets& sets, double maximum, std::uint64_t seed)
{
  Random random(seed);
  for (Pieces& pieces : sets)
  {
    for (std::size_t i = 0; i < pieces.U.size(); ++i)
    {
      pieces.U[i] += random.Uniform(-maximum, maximum);
      pieces.V[i] += random.Uniform(-maximum, maximum);
    }
  }
}

void BendSlices(PieceSets& sets, double maximum, double wave, std::uint64_t seed)
{
  ForEachSlice(sets, seed,
    [&](Pieces& pieces, const std::vector<Index>& vertices, Random& random)
    {
      const double a = random.Uniform(-maximum, maximum), b = random.Uniform(-maximum, maximum);
      const double p = random.Uniform(0.0, 2.0 * Pi), q = random.Uniform(0.0, 2.0 * Pi);
      for (const Index i : vertices)
      {
        pieces.U[i] += a * std::sin(2.0 * Pi * pieces.V[i] / wave + p);
        pieces.V[i] += b * std::sin(2.0 * Pi * pieces.U[i] / wave + q);
      }
    });
}

void MoveSlices(PieceSets& sets, double maximum, std::uint64_t seed)
{
  ForEachSlice(sets, seed,
    [&](Pieces& pieces, const std::vector<Index>& vertices, Random& random)
    {
      const double u = random.Uniform(-maximum, maximum), v = random.Uniform(-maximum, maximum);
      for (const Index i : vertices)
      {
        pieces.U[i] += u;
        pieces.V[i] += v;
      }
    });
}

void ShiftPlanes(PieceSets& sets, double maximum, std::uint64_t seed)
{
  ForEachSlice(sets, seed,
    [&](Pieces& pieces, const std::vector<Index>& vertices, Random& random)
    {
      const double w = random.Uniform(-maximum, maximum);
      for (const Index i : vertices)
      {
        pieces.W[i] += w;
      }
    });
}

void RotateSets(PieceSets& sets, double degrees)
{
  const double c = std::cos(degrees * Pi / 180.0);
  const double s = std::sin(degrees * Pi / 180.0);
  for (Pieces& pieces : sets)
  {
    for (std::size_t i = 0; i < pieces.U.size(); ++i)
    {
      const double u = pieces.U[i], v = pieces.V[i];
      pieces.U[i] = c * u - s * v;
      pieces.V[i] = s * u + c * v;
    }
  }
}

void DropContours(PieceSets& sets, double share, std::uint64_t seed)
{
  Random random(seed);
  for (Pieces& pieces : sets)
  {
    std::vector<Piece> kept;
    for (Piece& piece : TakeApart(pieces))
    {
      if (!random.Chance(share))
      {
        kept.push_back(std::move(piece));
      }
    }
    if (!kept.empty())
    {
      PutTogether(kept, pieces);
    }
  }
}

void ThinOut(Pieces& pieces, Index every)
{
  std::vector<Piece> list = TakeApart(pieces);
  for (Piece& piece : list)
  {
    const std::size_t size = piece.Vertices.size();
    const std::size_t step = std::max<std::size_t>(1, std::min<std::size_t>(every, size / 3));
    std::vector<Point3> kept;
    for (std::size_t i = 0; i < size; i += step)
    {
      kept.push_back(piece.Vertices[i]);
    }
    piece.Vertices = std::move(kept);
  }
  PutTogether(list, pieces);
}

void ReverseContours(PieceSets& sets, double share, std::uint64_t seed)
{
  Random random(seed);
  for (Pieces& pieces : sets)
  {
    std::vector<Piece> list = TakeApart(pieces);
    for (Piece& piece : list)
    {
      if (random.Chance(share))
      {
        std::reverse(piece.Vertices.begin(), piece.Vertices.end());
      }
    }
    PutTogether(list, pieces);
  }
}

void RoundToFloat(PieceSets& sets)
{
  for (Pieces& pieces : sets)
  {
    for (std::vector<double>* values : { &pieces.U, &pieces.V, &pieces.W })
    {
      for (double& x : *values)
      {
        x = static_cast<float>(x);
      }
    }
  }
}

void ShufflePieces(PieceSets& sets, std::uint64_t seed)
{
  Random random(seed);
  for (Pieces& pieces : sets)
  {
    std::vector<Piece> list = TakeApart(pieces);
    random.Shuffle(list);
    for (Piece& piece : list)
    {
      if (piece.Closed)
      {
        std::rotate(piece.Vertices.begin(),
          piece.Vertices.begin() + static_cast<std::ptrdiff_t>(random.Below(piece.Vertices.size())),
          piece.Vertices.end());
      }
    }
    PutTogether(list, pieces);
  }
}

void SplitIntoSegments(PieceSets& sets, std::uint64_t seed)
{
  Random random(seed);
  for (Pieces& pieces : sets)
  {
    std::vector<Piece> segments;
    for (const Piece& piece : TakeApart(pieces))
    {
      const std::size_t size = piece.Vertices.size();
      for (std::size_t i = 0; i + (piece.Closed ? 0 : 1) < size; ++i)
      {
        segments.push_back({ { piece.Vertices[i], piece.Vertices[(i + 1) % size] }, 0 });
        if (random.Chance(0.5))
        {
          std::swap(segments.back().Vertices[0], segments.back().Vertices[1]);
        }
      }
    }
    random.Shuffle(segments);
    PutTogether(segments, pieces);
  }
}

void DuplicatePieces(PieceSets& sets)
{
  for (Pieces& pieces : sets)
  {
    std::vector<Piece> list = TakeApart(pieces);
    const std::vector<Piece> copy = list;
    list.insert(list.end(), copy.begin(), copy.end());
    PutTogether(list, pieces);
  }
}

void PermuteAxes(PieceSets& sets)
{
  // The in-plane axes follow in the same order, so nothing but the names changes.
  std::rotate(sets.begin(), sets.begin() + 2, sets.end());
  for (int axis = 0; axis < 3; ++axis)
  {
    sets[axis].Axis = axis;
  }
}

void ExchangeXAndY(PieceSets& sets)
{
  std::swap(sets[0], sets[1]);
  for (int axis = 0; axis < 3; ++axis)
  {
    sets[axis].Axis = axis;
    std::swap(sets[axis].U, sets[axis].V);
  }
}

void Mirror(PieceSets& sets, int axis)
{
  for (Pieces& pieces : sets)
  {
    std::vector<double>& values = axis == pieces.Axis ? pieces.W
      : axis == FirstAxis(pieces.Axis)                ? pieces.U
                                                      : pieces.V;
    for (double& x : values)
    {
      x = -x;
    }
  }
}

void Scale(PieceSets& sets, double factor)
{
  for (Pieces& pieces : sets)
  {
    for (std::vector<double>* values : { &pieces.U, &pieces.V, &pieces.W })
    {
      for (double& x : *values)
      {
        x *= factor;
      }
    }
  }
}

void Translate(PieceSets& sets, const Point3& by)
{
  for (Pieces& pieces : sets)
  {
    for (std::size_t i = 0; i < pieces.U.size(); ++i)
    {
      pieces.U[i] += by[FirstAxis(pieces.Axis)];
      pieces.V[i] += by[SecondAxis(pieces.Axis)];
      pieces.W[i] += by[pieces.Axis];
    }
  }
}

} // namespace support
} // namespace orthoslices
