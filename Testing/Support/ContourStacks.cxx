// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/ContourStacks.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace orthoslices
{
namespace support
{

Index AddContour(ContourStack& stack, Index slice, const std::vector<Point2>& vertices)
{
  for (const Point2& p : vertices)
  {
    stack.U.push_back(p[0]);
    stack.V.push_back(p[1]);
  }
  stack.Offsets.push_back(static_cast<Index>(stack.U.size()));
  stack.Slice.push_back(slice);
  return stack.Count() - 1;
}

Index AddEllipse(ContourStack& stack, Index slice, const Point2& center, double a, double b)
{
  std::vector<Point2> vertices;
  for (int i = 0; i < 48; ++i)
  {
    const double angle = 3.14159265358979323846 * i / 24.0;
    vertices.push_back({ center[0] + a * std::cos(angle), center[1] + b * std::sin(angle) });
  }
  return AddContour(stack, slice, vertices);
}

ContourStack EmptyStack(Index count)
{
  ContourStack stack;
  for (Index i = 0; i < count; ++i)
  {
    stack.Coordinate.push_back(i);
  }
  return stack;
}

ContourStack ParseStack(const std::string& text)
{
  const Pieces pieces = ParsePieces(text)[2];
  std::set<double> planes;
  for (Index i = 0; i < pieces.Count(); ++i)
  {
    planes.insert(pieces.W[pieces.Offsets[i]]);
  }
  return StackOf(pieces, { planes.begin(), planes.end() });
}

ContourStack StackOf(const Pieces& pieces, const std::vector<double>& planes)
{
  ContourStack stack;
  stack.Coordinate = planes;
  for (std::size_t slice = 0; slice < planes.size(); ++slice)
  {
    for (Index i = 0; i < pieces.Count(); ++i)
    {
      if (pieces.W[pieces.Offsets[i]] == planes[slice])
      {
        std::vector<Point2> vertices;
        for (Index k = pieces.Offsets[i]; k < pieces.Offsets[i + 1]; ++k)
        {
          vertices.push_back({ pieces.U[k], pieces.V[k] });
        }
        AddContour(stack, static_cast<Index>(slice), vertices);
      }
    }
  }
  return stack;
}

ContourPairs PairsOf(const std::vector<Correspondence>& pairs, Passage where)
{
  ContourPairs result;
  for (const Correspondence& pair : pairs)
  {
    if (pair.Where == where)
    {
      result.push_back({ pair.First, pair.Second });
    }
  }
  return result;
}

ContourPairs FindPairs(
  CorrespondenceCriterion criterion, const ContourStack& stack, const PriorKnowledge& known)
{
  return PairsOf(FindCorrespondences(criterion, stack, known));
}

} // namespace support
} // namespace orthoslices
