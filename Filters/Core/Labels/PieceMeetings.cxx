// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/PieceMeetings.h"

#include "Core/Base/Predicates.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
double LowOf(const PieceSide& side, int axis) { return std::min(side.From[axis], side.To[axis]); }
double HighOf(const PieceSide& side, int axis) { return std::max(side.From[axis], side.To[axis]); }

/// By slice, then by the lower end along the first axis.
bool IsBefore(const PieceSide& a, const PieceSide& b)
{
  return a.Axis != b.Axis          ? a.Axis < b.Axis
    : a.Coordinate != b.Coordinate ? a.Coordinate < b.Coordinate
    : LowOf(a, 0) != LowOf(b, 0)   ? LowOf(a, 0) < LowOf(b, 0)
                                   : a.Piece < b.Piece;
}

/// Whether two sides have more in common than an end of both.
bool DoMeet(const PieceSide& a, const PieceSide& b)
{
  for (const auto& [end, other] : { std::pair(a.From, a.To), std::pair(a.To, a.From) })
  {
    for (const auto& [endOfB, otherOfB] : { std::pair(b.From, b.To), std::pair(b.To, b.From) })
    {
      if (end == endOfB)
      {
        return other == otherOfB || AreOnOneRay(end, other, otherOfB);
      }
    }
  }
  const auto isApart = [](const PieceSide& line, const PieceSide& side)
  { return SideOf(line.From, line.To, side.From) * SideOf(line.From, line.To, side.To) > 0; };
  return !isApart(a, b) && !isApart(b, a);
}
}

std::vector<std::pair<Index, Index>> FindMeetings(std::vector<PieceSide>& sides)
{
  std::sort(sides.begin(), sides.end(), IsBefore);
  std::vector<std::pair<Index, Index>> meetings;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const PieceSide& a = sides[i];
    if (a.From == a.To)
    {
      meetings.push_back({ a.Piece, a.Piece });
      continue;
    }
    for (std::size_t j = i + 1; j < sides.size() && sides[j].Axis == a.Axis &&
         sides[j].Coordinate == a.Coordinate && LowOf(sides[j], 0) <= HighOf(a, 0);
         ++j)
    {
      const PieceSide& b = sides[j];
      if (LowOf(b, 1) <= HighOf(a, 1) && LowOf(a, 1) <= HighOf(b, 1) && b.From != b.To &&
        DoMeet(a, b))
      {
        meetings.push_back(std::minmax(a.Piece, b.Piece));
      }
    }
  }
  std::sort(meetings.begin(), meetings.end());
  meetings.erase(std::unique(meetings.begin(), meetings.end()), meetings.end());
  return meetings;
}
}
