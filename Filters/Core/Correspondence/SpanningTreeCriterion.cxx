// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/SpanningTreeCriterion.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Correspondence/ContourEllipse.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// Edges of the tree that cost more than so many times the median edge are out of all proportion:
/// costs are squared distances, so that these are three times as long (Zahn; see the header).
constexpr double MaxCostOfMedian = 9.0;

double Square(double x) { return x * x; }

/// The cost of joining two contours by their ellipses, in squared world units (Skinner).
double SkinnerCost(const ContourEllipse& i, const ContourEllipse& j)
{
  return Square(i.Center[0] - j.Center[0]) + Square(i.Center[1] - j.Center[1]) +
    Square(i.Major - j.Major) + Square(i.Minor - j.Minor);
}

bool IsCheaper(const Correspondence& a, const Correspondence& b)
{
  return std::tie(a.Cost, a.First, a.Second) < std::tie(b.Cost, b.First, b.Second);
}

/**
 * The spanning tree of the pairs between two slices (Prim's algorithm). Edges of the tree of the
 * whole stack are among the edges of these trees, so that no list of all pairs is needed.
 */
void AddTreeBetween(const std::vector<ContourEllipse>& ellipses, const std::vector<Index>& lower,
  const std::vector<Index>& upper, std::vector<Correspondence>& edges)
{
  if (lower.empty() || upper.empty())
  {
    return;
  }
  struct Side
  {
    const std::vector<Index>& Contours;
    std::vector<Correspondence> Best; ///< edge to the tree so far
    std::vector<bool> Taken;
  };
  const Correspondence worst{ 0, 0, std::numeric_limits<double>::infinity() };
  std::array<Side, 2> sides{
    { { lower, std::vector<Correspondence>(lower.size(), worst), std::vector<bool>(lower.size()) },
      { upper, std::vector<Correspondence>(upper.size(), worst), std::vector<bool>(upper.size()) } }
  };
  std::size_t side = 0, at = 0;
  for (std::size_t taken = 1; taken < lower.size() + upper.size(); ++taken)
  {
    sides[side].Taken[at] = true;
    const Index contour = sides[side].Contours[at];
    Side& others = sides[1 - side];
    for (std::size_t k = 0; k < others.Contours.size(); ++k)
    {
      const Index other = others.Contours[k];
      const Correspondence edge{ std::min(contour, other), std::max(contour, other),
        SkinnerCost(ellipses[contour], ellipses[other]) };
      if (!others.Taken[k] && IsCheaper(edge, others.Best[k]))
      {
        others.Best[k] = edge;
      }
    }
    Correspondence minimum = worst;
    for (std::size_t s = 0; s < 2; ++s)
    {
      for (std::size_t k = 0; k < sides[s].Contours.size(); ++k)
      {
        if (!sides[s].Taken[k] && IsCheaper(sides[s].Best[k], minimum))
        {
          minimum = sides[s].Best[k];
          side = s;
          at = k;
        }
      }
    }
    edges.push_back(minimum);
  }
}

/// Outer boundaries and holes of each slice.
std::array<std::vector<std::vector<Index>>, 2> GroupBySliceAndSense(const ContourStack& stack)
{
  std::array<std::vector<std::vector<Index>>, 2> groups;
  groups.fill(std::vector<std::vector<Index>>(stack.Coordinate.size()));
  const std::vector<double> areas = SignedAreas(stack);
  for (Index contour = 0; contour < stack.Count(); ++contour)
  {
    groups[areas[contour] > 0.0 ? 0 : 1][stack.Slice[contour]].push_back(contour);
  }
  return groups;
}

std::vector<Correspondence> SpanningForest(
  const ContourStack& stack, const std::vector<ContourEllipse>& ellipses)
{
  std::vector<Correspondence> edges;
  for (const auto& slices : GroupBySliceAndSense(stack))
  {
    for (std::size_t slice = 0; slice + 1 < slices.size(); ++slice)
    {
      AddTreeBetween(ellipses, slices[slice], slices[slice + 1], edges);
    }
  }
  std::sort(edges.begin(), edges.end(), IsCheaper);
  DisjointSets trees(stack.Count());
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                [&](const Correspondence& edge) { return !trees.Unite(edge.First, edge.Second); }),
    edges.end());
  return edges;
}
}

std::vector<Correspondence> CorrespondencesBySpanningTree(const ContourStack& stack)
{
  const std::vector<ContourEllipse> ellipses = FitEllipses(stack);
  std::vector<Correspondence> edges = SpanningForest(stack, ellipses);
  const double median = edges.empty() ? 0.0 : edges[edges.size() / 2].Cost;
  const auto isTooLong = [&](const Correspondence& edge)
  {
    const double reach = ellipses[edge.First].Major + ellipses[edge.Second].Major;
    return edge.Cost > MaxCostOfMedian * median && edge.Cost > Square(reach);
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), isTooLong), edges.end());
  return edges;
}
}
