// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SurfacePieces.h"

#include "Core/Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace orthoslices
{
namespace support
{
namespace
{
std::pair<Index, Index> SidesOf(const Correspondence& pair)
{
  return { 2 * pair.First + (pair.Where == Passage::Below ? 1 : 0),
    2 * pair.Second + (pair.Where == Passage::Above ? 0 : 1) };
}

SurfacePieces NumbersOf(DisjointSets& sides, Index count)
{
  SurfacePieces pieces(count);
  for (Index side = 0; side < count; ++side)
  {
    pieces[side] = sides.Find(side);
  }
  return pieces;
}

Index CountPieces(const SurfacePieces& pieces)
{
  return static_cast<Index>(std::set<Index>(pieces.begin(), pieces.end()).size());
}

/// Parity of the crossings of a ray.
bool Encloses(const ContourStack& stack, Index contour, double u, double v)
{
  bool within = false;
  for (Index i = stack.Offsets[contour]; i < stack.Offsets[contour + 1]; ++i)
  {
    const Point2 a = stack.At(i), b = stack.At(stack.Next(contour, i));
    if ((a[1] <= v) != (b[1] <= v) && a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > u)
    {
      within = !within;
    }
  }
  return within;
}

/// The grid between two heights, both included; points of the solid are flooded.
class Slab
{
public:
  Slab(const Solid& solid, double low, double high, int layers, double distance)
    : Shape(solid)
    , Distance(distance)
    , Columns(static_cast<Index>((solid.High[0] - solid.Low[0]) / distance) + 1)
    , Rows(static_cast<Index>((solid.High[1] - solid.Low[1]) / distance) + 1)
    , Layers(layers + 1)
    , Inside(static_cast<std::size_t>(Columns) * Rows * Layers)
    , Sets(static_cast<Index>(Inside.size()))
  {
    for (Index k = 0; k < this->Layers; ++k)
    {
      const double z = k == layers ? high : low + (high - low) * k / layers;
      this->AddLayer(k, z);
    }
  }

  /// A number for the piece to which the inside of a contour belongs; -1 if no grid point is in it.
  Index PieceAt(const ContourStack& stack, Index contour, bool top)
  {
    const Index layer = top ? this->Layers - 1 : 0;
    for (Index j = 0; j < this->Rows; ++j)
    {
      for (Index i = 0; i < this->Columns; ++i)
      {
        const Index at = this->Number(i, j, layer);
        if (this->Inside[at] && Encloses(stack, contour, this->X(i), this->Y(j)))
        {
          return this->Sets.Find(at);
        }
      }
    }
    return -1;
  }

private:
  double X(Index i) const { return this->Shape.Low[0] + i * this->Distance; }
  double Y(Index j) const { return this->Shape.Low[1] + j * this->Distance; }
  Index Number(Index i, Index j, Index k) const { return (k * this->Rows + j) * this->Columns + i; }

  void AddLayer(Index k, double z)
  {
    for (Index j = 0; j < this->Rows; ++j)
    {
      for (Index i = 0; i < this->Columns; ++i)
      {
        const Index at = this->Number(i, j, k);
        this->Inside[at] = this->Shape.Value({ this->X(i), this->Y(j), z }) < 0.0;
        const auto connect = [&](bool exists, Index step)
        {
          if (exists && this->Inside[at] && this->Inside[at - step])
          {
            this->Sets.Unite(at, at - step);
          }
        };
        connect(i > 0, 1);
        connect(j > 0, this->Columns);
        connect(k > 0, this->Columns * this->Rows);
      }
    }
  }

  const Solid& Shape;
  double Distance;
  Index Columns, Rows, Layers;
  std::vector<std::uint8_t> Inside;
  DisjointSets Sets;
};
}

SurfacePieces PiecesOf(const std::vector<Correspondence>& pairs, Index contourCount)
{
  DisjointSets sides(2 * contourCount);
  for (const Correspondence& pair : pairs)
  {
    const auto [first, second] = SidesOf(pair);
    sides.Unite(first, second);
  }
  return NumbersOf(sides, 2 * contourCount);
}

std::optional<SurfacePieces> TruePieces(
  const Solid& solid, const ContourStack& stack, int layers, double distance)
{
  const std::vector<Index> first = FirstContourOfSlices(stack);
  DisjointSets sides(2 * stack.Count());
  for (Index slice = -1; slice < stack.SliceCount(); ++slice)
  {
    const bool hasLower = slice >= 0, hasUpper = slice + 1 < stack.SliceCount();
    Slab slab(solid, hasLower ? stack.Coordinate[slice] : solid.Low[2],
      hasUpper ? stack.Coordinate[slice + 1] : solid.High[2], layers, distance);
    std::map<Index, Index> sideOfPiece;
    for (const bool top : { false, true })
    {
      const Index members = top ? slice + 1 : slice;
      const bool exists = top ? hasUpper : hasLower;
      for (Index i = exists ? first[members] : 0; exists && i < first[members + 1]; ++i)
      {
        const Index piece = slab.PieceAt(stack, i, top);
        if (piece < 0)
        {
          return std::nullopt;
        }
        const Index side = 2 * i + (top ? 1 : 0);
        sides.Unite(side, sideOfPiece.insert({ piece, side }).first->second);
      }
    }
  }
  return NumbersOf(sides, 2 * stack.Count());
}

CountedTopology TopologyOf(const SurfacePieces& pieces)
{
  // Sides 2 i and 2 i + 1 are connected by contour i; pieces connect what has their number.
  const auto contours = static_cast<Index>(pieces.size() / 2);
  DisjointSets sides(2 * contours);
  for (Index i = 0; i < contours; ++i)
  {
    sides.Unite(2 * i, 2 * i + 1);
    sides.Unite(2 * i, pieces[2 * i]);
    sides.Unite(2 * i + 1, pieces[2 * i + 1]);
  }
  const Index components = CountPieces(NumbersOf(sides, 2 * contours));
  return { components, contours - CountPieces(pieces) + components };
}

Mistakes CountMistakes(const std::vector<Correspondence>& pairs, const SurfacePieces& truth)
{
  std::vector<Correspondence> right;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(right),
    [&](const Correspondence& pair)
    {
      const auto [first, second] = SidesOf(pair);
      return truth[first] == truth[second];
    });
  Mistakes mistakes;
  mistakes.Wrong = static_cast<std::int64_t>(pairs.size() - right.size());
  mistakes.Missing =
    CountPieces(PiecesOf(right, static_cast<Index>(truth.size() / 2))) - CountPieces(truth);
  return mistakes;
}

std::int64_t CountTurns(const SurfacePieces& pieces, const ContourStack& stack)
{
  std::map<Index, std::vector<Index>> slices;
  for (std::size_t side = 0; side < pieces.size(); ++side)
  {
    slices[pieces[side]].push_back(stack.Slice[side / 2]);
  }
  return std::count_if(slices.begin(), slices.end(),
    [](const auto& piece)
    {
      return piece.second.size() > 1 &&
        std::count(piece.second.begin(), piece.second.end(), piece.second.front()) ==
        static_cast<std::ptrdiff_t>(piece.second.size());
    });
}

} // namespace support
} // namespace orthoslices
