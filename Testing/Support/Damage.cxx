// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Damage.h"

#include "Support/PieceList.h"
#include "Support/Random.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace support
{
namespace
{
double LengthOf(const std::vector<Point3>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

/// Calls change(piece, random numbers, list of pieces to append to) for about this share of the
/// pieces, which are replaced by what is appended.
template <typename Change>
void ForSome(PieceSets& sets, double share, std::uint64_t seed, const Change& change)
{
  Random random(seed);
  for (Pieces& set : sets)
  {
    std::vector<Piece> result;
    for (Piece& piece : TakeApart(set))
    {
      if (piece.Closed && piece.Vertices.size() > 3 && random.Chance(share))
      {
        std::rotate(piece.Vertices.begin(),
          piece.Vertices.begin() + random.Below(piece.Vertices.size()), piece.Vertices.end());
        change(piece, random, result);
      }
      else
      {
        result.push_back(piece);
      }
    }
    PutTogether(result, set);
  }
}

/// Takes vertices from the end until this length is lost, but never all.
void Shorten(std::vector<Point3>& curve, double length, std::size_t leave)
{
  while (curve.size() > leave && length > 0.0)
  {
    const Point3 &a = curve[curve.size() - 2], &b = curve.back();
    length -= std::hypot(b[0] - a[0], b[1] - a[1]);
    if (length >= 0.0)
    {
      curve.pop_back();
    }
  }
}

/// The parts of a closed or open curve on one side of a border, with points on it where they are
/// cut.
std::vector<Piece> PartsBelow(const Piece& piece, int direction, double border, double sign)
{
  const std::size_t size = piece.Vertices.size();
  const auto height = [&](std::size_t i)
  { return sign * (piece.Vertices[i % size][direction] - border); };
  std::size_t start = 0;
  while (start < size && !(height(start + size - 1) > 0.0 && height(start) <= 0.0))
  {
    ++start;
  }
  if (start == size)
  {
    return height(0) <= 0.0 ? std::vector<Piece>{ piece } : std::vector<Piece>();
  }
  const auto cut = [&](std::size_t i)
  {
    const Point3 &a = piece.Vertices[i % size], &b = piece.Vertices[(i + 1) % size];
    const double t = (border - a[direction]) / (b[direction] - a[direction]);
    Point3 point{ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] };
    point[direction] = border;
    return point;
  };
  std::vector<Piece> parts;
  for (std::size_t i = start; i < start + size; ++i)
  {
    const bool enters = height(i + size - 1) > 0.0 && height(i) <= 0.0;
    if (enters)
    {
      parts.push_back({ { cut(i + size - 1) }, 0 });
    }
    if (height(i) <= 0.0)
    {
      parts.back().Vertices.push_back(piece.Vertices[i % size]);
      if (height(i + 1) > 0.0)
      {
        parts.back().Vertices.push_back(cut(i));
      }
    }
  }
  return parts;
}
}

void LoseEnds(PieceSets& sets, double share, double lacking, std::uint64_t seed)
{
  ForSome(sets, share, seed,
    [&](Piece& piece, Random& random, std::vector<Piece>& result)
    {
      Shorten(piece.Vertices, random.Uniform(0.0, lacking) * LengthOf(piece.Vertices), 3);
      piece.Closed = 0;
      result.push_back(piece);
    });
}

void RunPastStart(PieceSets& sets, double share, double beyond, double aside, std::uint64_t seed)
{
  ForSome(sets, share, seed,
    [&](Piece& piece, Random& random, std::vector<Piece>& result)
    {
      std::vector<Point3> curve = piece.Vertices;
      const double length = random.Uniform(0.0, beyond) * LengthOf(curve);
      const double u = random.Uniform(-aside, aside), v = random.Uniform(-aside, aside);
      const std::size_t size = curve.size();
      double way = 0.0;
      for (std::size_t i = 0; i < size / 2 && (i == 0 || way < length); ++i)
      {
        const Point3& at = piece.Vertices[i];
        const Point3& next = piece.Vertices[(i + 1) % size];
        curve.push_back({ at[0] + u, at[1] + v, at[2] });
        way += std::hypot(next[0] - at[0], next[1] - at[1]);
      }
      result.push_back({ curve, 0 });
    });
}

void BreakApart(PieceSets& sets, double share, double lacking, std::uint64_t seed)
{
  ForSome(sets, share, seed,
    [&](Piece& piece, Random& random, std::vector<Piece>& result)
    {
      const std::size_t size = piece.Vertices.size();
      const std::size_t count = std::min<std::size_t>(2 + random.Below(3), size / 8);
      const double length = LengthOf(piece.Vertices);
      piece.Vertices.push_back(piece.Vertices.front());
      for (std::size_t i = 0; i < std::max<std::size_t>(count, 1); ++i)
      {
        const std::size_t from = i * size / std::max<std::size_t>(count, 1);
        const std::size_t to = (i + 1) * size / std::max<std::size_t>(count, 1);
        Piece part{ { piece.Vertices.begin() + from, piece.Vertices.begin() + to + 1 }, 0 };
        Shorten(part.Vertices, random.Uniform(0.0, lacking) * length, 3);
        if (random.Chance(0.5))
        {
          std::reverse(part.Vertices.begin(), part.Vertices.end());
        }
        result.push_back(part);
      }
    });
}

void LeavePlane(PieceSets& sets, double share, double maximum, std::uint64_t seed)
{
  ForSome(sets, share, seed,
    [&](Piece& piece, Random& random, std::vector<Piece>& result)
    {
      for (Point3& vertex : piece.Vertices)
      {
        vertex[2] += random.Uniform(-maximum, maximum);
      }
      result.push_back(piece);
    });
}

void AddJunk(PieceSets& sets, std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  for (Pieces& set : sets)
  {
    std::vector<Piece> list = TakeApart(set);
    const std::vector<Piece> good = list;
    for (std::size_t i = 0; i < count && !good.empty(); ++i)
    {
      const Piece& at = good[random.Below(good.size())];
      const Point3 p = at.Vertices[random.Below(at.Vertices.size())];
      const double size = 1e-3 * LengthOf(at.Vertices);
      const Point3 a{ p[0] + 3.0 * size, p[1] + size, p[2] };
      const Point3 b{ a[0] + 0.5 * size, a[1] + 0.25 * size, a[2] };
      list.push_back({ { a, b }, 0 });
      list.push_back({ { a, b, { a[0] + size, a[1] + 0.5 * size, a[2] } }, 1 });
      list.push_back({ { a, b, { std::nan(""), a[1], a[2] }, p }, 1 });
    }
    PutTogether(list, set);
  }
}

void CutOff(PieceSets& sets, int axis, double border, bool keepsBelow)
{
  const double sign = keepsBelow ? 1.0 : -1.0;
  for (Pieces& set : sets)
  {
    std::vector<Piece> result;
    for (const Piece& piece : TakeApart(set))
    {
      if (set.Axis == axis)
      {
        if (sign * (piece.Vertices.front()[2] - border) < 0.0)
        {
          result.push_back(piece);
        }
        continue;
      }
      const std::vector<Piece> parts =
        PartsBelow(piece, FirstAxis(set.Axis) == axis ? 0 : 1, border, sign);
      result.insert(result.end(), parts.begin(), parts.end());
    }
    PutTogether(result, set);
  }
}

} // namespace support
} // namespace orthoslices
