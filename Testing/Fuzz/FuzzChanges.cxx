// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzChanges.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace orthoslices
{
namespace support
{
namespace
{
using FuzzVertex = std::array<FuzzNumber, 2>;

int Between(int low, int high, Random& random)
{
  return low + static_cast<int>(random.Below(static_cast<std::size_t>(high - low + 1)));
}

template <typename Items>
auto& Any(Items& items, Random& random)
{
  return items[random.Below(items.size())];
}

/// A rectangle on a plane of a box.
FuzzPiece Rectangle(
  int axis, int plane, const std::array<int, 3>& low, const std::array<int, 3>& high)
{
  FuzzPiece piece;
  piece.Axis = axis;
  piece.Plane.Whole = plane;
  const int u = FirstAxis(axis), v = SecondAxis(axis);
  for (const auto& corner : { std::array<int, 2>{ low[u], low[v] }, { high[u], low[v] },
         { high[u], high[v] }, { low[u], high[v] } })
  {
    FuzzVertex vertex;
    vertex[0].Whole = corner[0];
    vertex[1].Whole = corner[1];
    piece.Vertices.push_back(vertex);
  }
  return piece;
}

/// A box with some of the planes that cut it. Boxes often touch others.
void AddBox(FuzzInput& input, Random& random)
{
  std::array<int, 3> low, high;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = Between(0, 5, random);
    high[axis] = low[axis] + Between(1, 5, random);
  }
  const bool hasLabel = random.Chance(input.HasLabels() ? 0.9 : 0.1);
  const int label = hasLabel ? Between(0, FuzzInput::Labels - 1, random) : -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int plane = low[axis]; plane <= high[axis]; ++plane)
    {
      if (random.Chance(0.4) && input.Pieces.size() < FuzzInput::MaxPieces)
      {
        input.Pieces.push_back(Rectangle(axis, plane, low, high));
        input.Pieces.back().Label = label;
      }
    }
  }
}

/// The axis of the world along which a coordinate of a piece's vertices runs.
int AxisOf(const FuzzPiece& piece, int coordinate)
{
  return coordinate == 0 ? FirstAxis(piece.Axis) : SecondAxis(piece.Axis);
}

/// Sides no longer than 1, as far as integers allow: a contour whose gap is no more than twice as
/// long as its sides only lacks the last one.
void DivideSides(std::vector<FuzzVertex>& vertices)
{
  for (std::size_t i = 0; i + 1 < vertices.size();)
  {
    const FuzzVertex &a = vertices[i], &b = vertices[i + 1];
    const int u = b[0].Whole - a[0].Whole, v = b[1].Whole - a[1].Whole;
    if (std::max(std::abs(u), std::abs(v)) <= 1 || vertices.size() >= FuzzInput::MaxVertices)
    {
      ++i;
      continue;
    }
    FuzzVertex middle;
    middle[0].Whole = a[0].Whole + u / 2;
    middle[1].Whole = a[1].Whole + v / 2;
    vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
  }
}

/// Where a side crosses a line, at the nearest integer on it.
FuzzVertex OnBorder(const FuzzVertex& a, const FuzzVertex& b, int coordinate, int border)
{
  const double length = b[coordinate].Value() - a[coordinate].Value();
  const double share = length == 0.0 ? 0.0 : (border - a[coordinate].Value()) / length;
  const double from = a[1 - coordinate].Value(), to = b[1 - coordinate].Value();
  FuzzVertex vertex;
  vertex[coordinate].Whole = border;
  vertex[1 - coordinate].Whole = static_cast<int>(std::lround(from + share * (to - from)));
  return vertex;
}

/// What a closed contour has on one side of a line, as an open piece with its ends on that line.
/// Those that cross the line more than twice stay as they are.
void CutPiece(FuzzPiece& piece, int coordinate, int border, bool keepLower)
{
  const auto& vertices = piece.Vertices;
  const std::size_t count = vertices.size();
  const auto isInside = [&](std::size_t i)
  { return (vertices[i % count][coordinate].Value() < border) == keepLower; };
  std::vector<std::size_t> entries;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!isInside(i) && isInside(i + 1))
    {
      entries.push_back(i);
    }
  }
  if (entries.size() != 1)
  {
    return;
  }
  const auto onBorder = [&](std::size_t i)
  { return OnBorder(vertices[i % count], vertices[(i + 1) % count], coordinate, border); };
  std::vector<FuzzVertex> kept{ onBorder(entries[0]) };
  std::size_t i = entries[0] + 1;
  for (; isInside(i); ++i)
  {
    kept.push_back(vertices[i % count]);
  }
  kept.push_back(onBorder(i - 1));
  kept.resize(std::min(kept.size(), FuzzInput::MaxVertices));
  DivideSides(kept);
  piece.Vertices = std::move(kept);
  piece.Open = true;
}

/// Cuts all contours off at a side of the image.
void CutAtBorder(FuzzInput& input, Random& random)
{
  const int axis = Between(0, 2, random);
  const int border = Between(0, 8, random);
  const bool keepLower = random.Chance(0.5);
  const auto isBeyond = [&](const FuzzPiece& piece)
  { return piece.Axis == axis && (piece.Plane.Value() > border) == keepLower; };
  auto& pieces = input.Pieces;
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isBeyond), pieces.end());
  for (FuzzPiece& piece : pieces)
  {
    for (int coordinate = 0; coordinate < 2; ++coordinate)
    {
      if (piece.Axis < 3 && AxisOf(piece, coordinate) == axis && !piece.Open)
      {
        CutPiece(piece, coordinate, border, keepLower);
      }
    }
  }
  input.Flags += input.Has('M') ? "" : "M";
}

void ChangeNumber(FuzzNumber& number, Random& random)
{
  switch (random.Below(16))
  {
    case 0:
    case 1:
      number.Middle = Between(-3, 3, random);
      break;
    case 2:
    case 3:
      number.Last = Between(-3, 3, random);
      break;
    case 4:
    case 5:
      number.Middle = number.Last = number.Height = 0;
      break;
    case 6:
      number.Height = random.Chance(0.3) ? Between(-3, 3, random) : 0;
      break;
    default:
      number.Whole = std::clamp(
        number.Whole + Between(-3, 3, random), -FuzzInput::Greatest, FuzzInput::Greatest);
  }
}

/// Where a piece belongs: its axis, port and label.
void ChangePlace(FuzzPiece& piece, Random& random)
{
  switch (random.Below(4))
  {
    case 0:
      piece.Open = random.Chance(0.4);
      break;
    case 1:
      piece.Axis = random.Chance(0.2) ? FuzzPiece::Oblique : Between(0, 2, random);
      break;
    case 2:
      piece.Port = random.Chance(0.5) ? -1 : Between(0, 2, random);
      break;
    default:
      piece.Label = random.Chance(0.3) ? -1 : Between(0, FuzzInput::Labels - 1, random);
  }
}

void ChangeVertices(FuzzPiece& piece, Random& random)
{
  auto& vertices = piece.Vertices;
  const auto at = [&]
  { return vertices.begin() + static_cast<std::ptrdiff_t>(random.Below(vertices.size())); };
  switch (random.Below(8))
  {
    case 0:
      vertices.erase(at());
      break;
    case 1:
    case 2:
    {
      const FuzzVertex copy = *at();
      const auto inserted = vertices.insert(at(), copy);
      ChangeNumber(Any(*inserted, random), random);
      break;
    }
    case 3:
      random.Chance(0.5) ? std::reverse(vertices.begin(), vertices.end()) : std::swap(*at(), *at());
      break;
    default:
      ChangeNumber(Any(*at(), random), random);
  }
}

void ChangePiece(FuzzPiece& piece, Random& random)
{
  if (piece.Vertices.empty())
  {
    piece.Vertices.emplace_back();
    return;
  }
  switch (random.Below(10))
  {
    case 0:
      ChangeNumber(piece.Plane, random);
      break;
    case 1:
      ChangePlace(piece, random);
      break;
    default:
      ChangeVertices(piece, random);
  }
}

/// A piece once more, or a part of it as a piece of its own.
void CopyPiece(FuzzInput& input, Random& random)
{
  FuzzPiece& piece = Any(input.Pieces, random);
  FuzzPiece copy = piece;
  auto& vertices = copy.Vertices;
  if (random.Chance(0.2) && vertices.size() >= 2)
  {
    // From one vertex on; that vertex is the loose end of both.
    const std::size_t first = random.Below(vertices.size());
    piece.Vertices.resize(first + 1);
    vertices.erase(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(first));
    vertices.insert(
      vertices.end(), piece.Vertices.begin(), piece.Vertices.begin() + (piece.Open ? 0 : 1));
    piece.Open = copy.Open = true;
  }
  else
  {
    copy.Plane.Whole += Between(-1, 1, random);
    copy.Label = random.Chance(0.2) ? Between(0, FuzzInput::Labels - 1, random) : copy.Label;
  }
  input.Pieces.push_back(copy);
}

void ChangeFlags(FuzzInput& input, Random& random)
{
  const char flag = FuzzInput::AllFlags[random.Below(std::strlen(FuzzInput::AllFlags))];
  const std::size_t place = input.Flags.find(flag);
  place == std::string::npos ? input.Flags.push_back(flag)
                             : static_cast<void>(input.Flags.erase(place, 1));
}

void ChangeFrame(FuzzInput& input, Random& random)
{
  if (random.Chance(0.3))
  {
    input.Frame = {};
  }
  else
  {
    // More often turned than inclined.
    ChangeNumber(input.Frame[random.Below(random.Chance(0.7) ? 3 : 6)], random);
  }
}
}

void ChangeFuzzInput(FuzzInput& input, Random& random)
{
  if (random.Chance(0.3))
  {
    // Virtual slices take a hundred times as long: they are to stay the exception.
    input.Flags.erase(std::remove(input.Flags.begin(), input.Flags.end(), 'V'), input.Flags.end());
  }
  const std::size_t count = input.Pieces.size();
  const std::size_t choice = count == 0 ? 0 : random.Below(24);
  switch (choice)
  {
    case 0:
      AddBox(input, random);
      break;
    case 1:
    case 2:
      count < FuzzInput::MaxPieces ? CopyPiece(input, random) : CutAtBorder(input, random);
      break;
    case 3:
    case 4:
      input.Pieces.erase(input.Pieces.begin() + static_cast<std::ptrdiff_t>(random.Below(count)));
      break;
    case 5:
    case 6:
      ChangeFlags(input, random);
      break;
    case 7:
      ChangeFrame(input, random);
      break;
    case 8:
      CutAtBorder(input, random);
      break;
    default:
      ChangePiece(Any(input.Pieces, random), random);
  }
}

} // namespace support
} // namespace orthoslices
