// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/KeepPart.h"

#include "Core/Patches/DivideCycles.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// A bit besides those of PartsOfPoint: the point has triangles in the part.
constexpr std::uint8_t InPart = 4;

/// In which parts points have triangles, of which those from `first` to `last` - 1 are the part.
std::vector<std::uint8_t> FindParts(
  const ImprovedTriangles& all, std::int64_t first, std::int64_t last)
{
  std::vector<std::uint8_t> parts(all.Origin.size(), 0);
  const auto mark = [&](std::int64_t from, std::int64_t to, std::uint8_t part)
  {
    for (std::int64_t i = 3 * from; i < 3 * to; ++i)
    {
      parts[all.Corners[i]] |= part;
    }
  };
  mark(0, first, BeforePart);
  mark(first, last, InPart);
  mark(last, static_cast<std::int64_t>(all.Corners.size()) / 3, AfterPart);
  return parts;
}

ImprovedTriangles SelectPart(const ImprovedTriangles& all, std::int64_t first, std::int64_t last)
{
  ImprovedTriangles part;
  part.IsPart = true;
  part.TrianglesBefore = first;
  const std::vector<std::uint8_t> parts = FindParts(all, first, last);
  std::vector<Index> places(parts.size(), -1);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if ((parts[i] & InPart) != 0)
    {
      places[i] = static_cast<Index>(part.Ids.size());
      part.Ids.push_back(static_cast<std::int64_t>(i));
      part.OtherParts.push_back(static_cast<std::uint8_t>(parts[i] & ~InPart));
      part.Origin.push_back(all.Origin[i]);
      part.Points.insert(
        part.Points.end(), all.Points.begin() + 3 * i, all.Points.begin() + 3 * (i + 1));
    }
  }
  for (std::int64_t i = 3 * first; i < 3 * last; ++i)
  {
    part.Corners.push_back(places[all.Corners[i]]);
  }
  return part;
}
}

Portion KeepPart(const Ranks& ranks, Patches& patches)
{
  std::vector<std::int64_t>& offsets = patches.Offsets;
  const Portion part = PortionOf(ranks, offsets.size() - 1,
    [&](std::size_t cycle) { return static_cast<double>(offsets[cycle + 1] - offsets[cycle]); });
  const std::int64_t first = offsets[part.First], last = offsets[part.Last];
  patches.Improved = SelectPart(patches.Improved, first, last);
  for (std::int64_t& offset : offsets)
  {
    offset = std::min(std::max(offset, first), last) - first;
  }
  return part;
}
}
