// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/SnapPlanes.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Means of planes, and vertices of one plane, differ by no more than so many typical distances.
constexpr double FactorOfMeans = 3.0;
constexpr double FactorOfVertices = 6.0;

/// A group and its mean coordinate.
struct Level
{
  double Coordinate;
  Index Group;
};

/// Sets the coordinates of groups on one plane to the mean of their points.
void LevelRuns(const std::vector<PieceGroup>& groups, double gap, std::vector<Level>& levels)
{
  std::sort(levels.begin(), levels.end(),
    [](const Level& a, const Level& b)
    { return a.Coordinate != b.Coordinate ? a.Coordinate < b.Coordinate : a.Group < b.Group; });
  for (std::size_t first = 0, last = 0; first < levels.size(); first = last)
  {
    // From the first one, so that no digits are lost far from zero.
    const double start = levels[first].Coordinate;
    double sum = 0.0, points = 0.0;
    for (last = first; last < levels.size() && levels[last].Coordinate - start <= gap; ++last)
    {
      const double weight = groups[levels[last].Group].Points.Points;
      sum += weight * (levels[last].Coordinate - start);
      points += weight;
    }
    for (std::size_t i = first; i < last; ++i)
    {
      levels[i].Coordinate = start + sum / points;
    }
  }
}
}

void SnapPlanes(const std::vector<PieceGroup>& groups, const Point3& normal,
  const PlaneNoise& noise, Pieces& pieces)
{
  std::vector<Index> lines;
  for (const std::int64_t line : pieces.Cell)
  {
    lines.push_back(static_cast<Index>(line));
  }
  std::vector<Level> levels;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    if (groups[i].IsFinite() &&
      std::binary_search(lines.begin(), lines.end(), groups[i].Members.front()))
    {
      levels.push_back({ Dot(normal, groups[i].Center), static_cast<Index>(i) });
    }
  }
  LevelRuns(groups, std::max(noise.Tolerance, FactorOfMeans * noise.Typical), levels);
  for (const Level& level : levels)
  {
    const double most = std::max(noise.Tolerance, FactorOfVertices * noise.Of(groups[level.Group]));
    for (const Index line : groups[level.Group].Members)
    {
      const auto piece = std::lower_bound(lines.begin(), lines.end(), line) - lines.begin();
      for (Index i = pieces.Offsets[piece]; i < pieces.Offsets[piece + 1]; ++i)
      {
        double& w = pieces.W[i];
        w = std::abs(w - level.Coordinate) <= most ? level.Coordinate : w;
      }
    }
  }
}
}
