// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/SplitByLabel.h"

namespace orthoslices
{
namespace
{
/// Appends a piece, as polyline `line` of the others.
void CopyPiece(const Pieces& from, Index piece, std::int64_t line, Pieces& to)
{
  const auto begin = from.Offsets[piece];
  const auto end = from.Offsets[piece + 1];
  to.U.insert(to.U.end(), from.U.begin() + begin, from.U.begin() + end);
  to.V.insert(to.V.end(), from.V.begin() + begin, from.V.begin() + end);
  to.W.insert(to.W.end(), from.W.begin() + begin, from.W.begin() + end);
  to.Offsets.push_back(static_cast<Index>(to.U.size()));
  to.Cell.push_back(line);
  to.Closed.push_back(from.Closed[piece]);
}

/// Whether two sources of polylines are one.
bool IsSame(const PolylineSources& a, Index i, const PolylineSources& b, Index j)
{
  return a.Port[i] == b.Port[j] && a.Block[i] == b.Block[j] && a.Cell[i] == b.Cell[j];
}

/// Those on planes of no family, which come in the order of all polylines.
void SplitOthers(
  const SortedSlices& sorted, const std::vector<Index>& labels, std::vector<SortedSlices>& parts)
{
  Index line = 0;
  for (Index other = 0; other < sorted.Others.Count(); ++other)
  {
    while (!IsSame(sorted.From, line, sorted.Others.From, other))
    {
      ++line;
    }
    if (labels[line] != NoLabel)
    {
      AppendLine(sorted.Others, other, parts[labels[line]].Others);
    }
  }
}
}

std::vector<SortedSlices> SplitByLabel(
  const SortedSlices& sorted, const std::vector<Index>& labels, Index count)
{
  std::vector<SortedSlices> parts(count);
  for (SortedSlices& part : parts)
  {
    part.Frame = sorted.Frame;
  }
  for (std::size_t axis = 0; axis < sorted.Slices.size(); ++axis)
  {
    const Pieces& pieces = sorted.Slices[axis];
    for (SortedSlices& part : parts)
    {
      part.Slices[axis].Axis = pieces.Axis;
    }
    for (Index piece = 0; piece < pieces.Count(); ++piece)
    {
      const std::int64_t line = pieces.Cell[piece];
      if (labels[line] == NoLabel)
      {
        continue;
      }
      SortedSlices& part = parts[labels[line]];
      CopyPiece(pieces, piece, static_cast<std::int64_t>(part.From.Cell.size()), part.Slices[axis]);
      part.From.Port.push_back(sorted.From.Port[line]);
      part.From.Block.push_back(sorted.From.Block[line]);
      part.From.Cell.push_back(sorted.From.Cell[line]);
    }
  }
  SplitOthers(sorted, labels, parts);
  return parts;
}

std::size_t CountVertices(const SortedSlices& sorted)
{
  return sorted.Slices[0].U.size() + sorted.Slices[1].U.size() + sorted.Slices[2].U.size();
}
}
