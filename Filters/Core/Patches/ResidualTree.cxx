// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/ResidualTree.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Residuals of the smallest parts.
constexpr std::size_t LeafSize = 8;

/// One residual that stands for several: the mean of their linear functions, by their weights.
Residual SumOf(const Residual* first, const Residual* last)
{
  Residual sum{ 0.0, { 0.0, 0.0, 0.0 }, 0.0, { 0.0, 0.0, 0.0 } };
  for (const Residual* r = first; r != last; ++r)
  {
    sum.Weight += r->Weight;
    sum.Place = sum.Place + r->Weight * r->Place;
    sum.Gradient = sum.Gradient + r->Weight * r->Gradient;
  }
  if (!(sum.Weight > 0.0))
  {
    return { 0.0, first->Place, 0.0, { 0.0, 0.0, 0.0 } };
  }
  const double inverse = 1.0 / sum.Weight;
  sum.Place = inverse * sum.Place;
  sum.Gradient = inverse * sum.Gradient;
  for (const Residual* r = first; r != last; ++r)
  {
    sum.Value += inverse * r->Weight * (r->Value + Dot(r->Gradient, sum.Place - r->Place));
  }
  return sum;
}
}

void ResidualTree::Set(const std::vector<Residual>& residuals)
{
  this->Nodes.clear();
  if (!residuals.empty())
  {
    this->Add(residuals, 0, residuals.size());
  }
}

void ResidualTree::Add(const std::vector<Residual>& residuals, std::size_t first, std::size_t last)
{
  const std::size_t at = this->Nodes.size();
  Node node;
  node.First = first;
  node.Last = last;
  node.Sum = SumOf(residuals.data() + first, residuals.data() + last);
  double squared = 0.0;
  for (std::size_t i = first; i < last; ++i)
  {
    squared = std::max(squared, SquaredDistance(residuals[i].Place, node.Sum.Place));
  }
  node.Radius = std::sqrt(squared);
  this->Nodes.push_back(node);
  if (last - first > LeafSize)
  {
    const std::size_t middle = first + (last - first) / 2;
    this->Add(residuals, first, middle);
    this->Nodes[at].Right = this->Nodes.size();
    this->Add(residuals, middle, last);
  }
}
}
