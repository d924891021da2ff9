// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesNodeFinder_h
#define OrthoSlicesNodeFinder_h

#include "Core/Base/Vectors.h"

#include <cmath>
#include <unordered_map>
#include <vector>

namespace orthoslices
{
/// Finds nodes by their place.
class NodeFinder
{
public:
  static constexpr Index None = -1;

  /// Nodes that are appended later have to be added. `resolution`: a quarter of the size of a cell.
  NodeFinder(const std::vector<Point2>& nodes, double resolution)
    : Nodes(nodes)
    , CellSize(4.0 * resolution)
  {
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      this->Add(static_cast<Index>(i));
    }
  }

  void Add(Index node) { this->Cells[this->KeyOf(this->Nodes[node], 0, 0)].push_back(node); }

  /// The node at most `distance` (up to the size of a cell) away that is nearest; None if there is
  /// none.
  Index Nearest(const Point2& place, double distance) const
  {
    Index best = None;
    double least = distance;
    for (int i = -1; i <= 1; ++i)
    {
      for (int j = -1; j <= 1; ++j)
      {
        const auto cell = this->Cells.find(this->KeyOf(place, i, j));
        for (std::size_t k = 0; cell != this->Cells.end() && k < cell->second.size(); ++k)
        {
          const double d = Distance(place, this->Nodes[cell->second[k]]);
          if (d < least || (d == least && (best == None || cell->second[k] < best)))
          {
            best = cell->second[k];
            least = d;
          }
        }
      }
    }
    return best;
  }

private:
  std::uint64_t KeyOf(const Point2& place, int i, int j) const
  {
    const auto u = static_cast<std::int64_t>(std::floor(place[0] / this->CellSize)) + i;
    const auto v = static_cast<std::int64_t>(std::floor(place[1] / this->CellSize)) + j;
    // Cells that share a key cost time only.
    return static_cast<std::uint64_t>(u) * 0x9e3779b97f4a7c15ull + static_cast<std::uint64_t>(v);
  }

  const std::vector<Point2>& Nodes;
  double CellSize;
  std::unordered_map<std::uint64_t, std::vector<Index>> Cells;
};
}

#endif
