// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartsInCells.h"

#include <algorithm>

namespace orthoslices
{
namespace baselines
{

PartsInCells::PartsInCells(const TriangleSurface& surface, const SpatialGrid& grid)
  : Grid(grid)
{
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (std::size_t side = 0; side < 3; ++side)
    {
      const Index neighbor = surface.Neighbors[t][side];
      if (static_cast<Index>(t) < neighbor)
      {
        this->Connect(static_cast<Index>(t), neighbor, surface.Points[surface.Triangles[t][side]],
          surface.Points[surface.Triangles[t][(side + 1) % 3]]);
      }
    }
  }
}

Index PartsInCells::PieceOf(Index triangle, const std::array<Index, 3>& cell)
{
  const auto at =
    this->Pieces.emplace(std::make_pair(triangle, cell), static_cast<Index>(this->Parent.size()));
  if (at.second)
  {
    this->Parent.push_back(at.first->second);
  }
  return at.first->second;
}

Index PartsInCells::Root(Index piece)
{
  while (this->Parent[piece] != piece)
  {
    this->Parent[piece] = this->Parent[this->Parent[piece]];
    piece = this->Parent[piece];
  }
  return piece;
}

/// Two triangles with a common edge, in each cell that the edge passes through.
void PartsInCells::Connect(Index first, Index second, const Point3& from, const Point3& to)
{
  std::vector<double> shares{ 0.0, 1.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double plane : this->Grid.Planes[axis])
    {
      const double share = (plane - from[axis]) / (to[axis] - from[axis]);
      if (share > 0.0 && share < 1.0)
      {
        shares.push_back(share);
      }
    }
  }
  std::sort(shares.begin(), shares.end());
  for (std::size_t i = 1; i < shares.size(); ++i)
  {
    const double middle = 0.5 * (shares[i - 1] + shares[i]);
    std::array<Index, 3> cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = this->Grid.Slab(axis, from[axis] + middle * (to[axis] - from[axis]));
    }
    const Index a = this->Root(this->PieceOf(first, cell));
    const Index b = this->Root(this->PieceOf(second, cell));
    this->Parent[std::max(a, b)] = std::min(a, b);
  }
}

Index PartsInCells::PartOf(Index triangle, const std::array<Index, 3>& cell)
{
  return this->Root(this->PieceOf(triangle, cell));
}

} // namespace baselines
} // namespace orthoslices
