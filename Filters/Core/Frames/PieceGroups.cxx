// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/PieceGroups.h"

#include "Core/Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthoslices
{
namespace
{
/// Unites open polylines whose ends meet in pairs.
void JoinEnds(const Polylines& lines, DisjointSets& sets)
{
  std::vector<std::pair<Point3, Index>> ends;
  for (Index line = 0; line < lines.Count(); ++line)
  {
    if (lines.Closed[line] == 0)
    {
      ends.emplace_back(lines.PointAt(lines.Offsets[line]), line);
      ends.emplace_back(lines.PointAt(lines.Offsets[line + 1] - 1), line);
    }
  }
  ends.erase(std::remove_if(ends.begin(), ends.end(),
               [](const std::pair<Point3, Index>& end)
               { return !std::isfinite(end.first[0] + end.first[1] + end.first[2]); }),
    ends.end());
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0, next = 0; i < ends.size(); i = next)
  {
    for (next = i; next < ends.size() && ends[next].first == ends[i].first; ++next)
    {
    }
    if (next == i + 2)
    {
      sets.Unite(ends[i].second, ends[i + 1].second);
    }
  }
}
}

std::vector<PieceGroup> GroupPieces(const Polylines& lines)
{
  DisjointSets sets(lines.Count());
  JoinEnds(lines, sets);
  std::vector<PieceGroup> groups;
  std::vector<Index> groupOf(lines.Count(), -1);
  for (Index line = 0; line < lines.Count(); ++line)
  {
    const Index first = sets.Find(line);
    if (groupOf[first] < 0)
    {
      groupOf[first] = static_cast<Index>(groups.size());
      groups.emplace_back();
      groups.back().Port = lines.From.Port[line];
    }
    groups[groupOf[first]].Members.push_back(line);
  }
  for (PieceGroup& group : groups)
  {
    group.Points = MeasureScatter(lines, group.Members, group.Center);
    group.Fit = FitPlane(group.Points);
    for (const Index line : group.Members)
    {
      for (Index i = lines.Offsets[line]; i < lines.Offsets[line + 1]; ++i)
      {
        group.Box.Add(lines.PointAt(i));
      }
    }
  }
  return groups;
}
}
