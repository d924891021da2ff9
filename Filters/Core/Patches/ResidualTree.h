// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesResidualTree_h
#define OrthoSlicesResidualTree_h

#include "Core/Base/Types.h"
#include "Core/Base/Vectors.h"

#include <array>
#include <cstddef>
#include <vector>

namespace orthoslices
{
/// What a polynomial leaves at a point of a border; see SmoothSurface.
struct Residual
{
  double Weight;
  Point3 Place;
  double Value;
  Point3 Gradient;
};

/**
 * The residuals of a border with many points, for sums over all of them with weights that fall with
 * the fourth power of the distance: those of points that are close together, as seen from far away,
 * stand for one residual at their middle. A sum costs the logarithm of the number of points.
 */
class ResidualTree
{
public:
  /// Consecutive residuals lie close together, as along a border.
  void Set(const std::vector<Residual>& residuals);
  void Clear() { this->Nodes.clear(); }
  bool IsEmpty() const { return this->Nodes.empty(); }

  /// Calls visit(residual) for residuals that together stand for all as seen from a place.
  template <typename Visit>
  void VisitFrom(const Point3& place, const std::vector<Residual>& residuals, Visit&& visit) const;

private:
  /// Residuals of which no one is farther from their middle than this share of the distance stand
  /// for one: what they weigh is wrong by 10 times its square, 1 / 40, at most.
  static constexpr double MostSpread = 0.05;

  struct Node
  {
    Residual Sum;
    double Radius = 0.0; ///< of a ball around the place of Sum that all residuals are in
    std::size_t First = 0, Last = 0; ///< the residuals
    std::size_t Right = 0;           ///< the second half; the first one follows. 0: none
  };
  /// Adds the node of some residuals, and those of their halves.
  void Add(const std::vector<Residual>& residuals, std::size_t first, std::size_t last);

  std::vector<Node> Nodes;
};

template <typename Visit>
void ResidualTree::VisitFrom(
  const Point3& place, const std::vector<Residual>& residuals, Visit&& visit) const
{
  std::array<std::size_t, 64> open; // as deep as the tree
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0)
  {
    const std::size_t at = open[--count];
    const Node& node = this->Nodes[at];
    const double spread = node.Radius / MostSpread;
    if (spread * spread < SquaredDistance(place, node.Sum.Place))
    {
      visit(node.Sum);
    }
    else if (node.Right == 0)
    {
      for (std::size_t i = node.First; i < node.Last; ++i)
      {
        visit(residuals[i]);
      }
    }
    else
    {
      open[count++] = node.Right;
      open[count++] = at + 1;
    }
  }
}
}

#endif
