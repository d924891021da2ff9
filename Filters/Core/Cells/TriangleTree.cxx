// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/TriangleTree.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// Triangles in a leaf. It changes the time only.
constexpr Index TrianglesInLeaf = 4;

/// Of the diagonal of all triangles: rounding is some 1e-16, and what is so close is tested anyway.
constexpr double MarginShare = 1e-12;

/// A direction along which most vectors lie, whatever their senses are; longer ones count more.
Point3 MainDirection(const std::vector<Point3>& vectors)
{
  Point3 direction = *std::max_element(vectors.begin(), vectors.end(),
    [](const Point3& a, const Point3& b) { return Dot(a, a) < Dot(b, b); });
  constexpr int rounds = 2; // it need not be exact
  for (int i = 0; i < rounds; ++i)
  {
    Point3 sum{ 0.0, 0.0, 0.0 };
    for (const Point3& vector : vectors)
    {
      sum = Dot(vector, direction) < 0.0 ? sum - vector : sum + vector;
    }
    direction = sum;
  }
  return Unit(direction);
}

Point3 InBox(const std::array<Point3, 3>& axes, const Point3& p)
{
  return { Dot(axes[0], p), Dot(axes[1], p), Dot(axes[2], p) };
}
}

TriangleTree::TriangleTree(const std::vector<PatchTriangle>& triangles)
  : Triangles(triangles)
  , Order(triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  Box3 all;
  for (const PatchTriangle& triangle : triangles)
  {
    all.Add(triangle.Extent);
  }
  if (!triangles.empty())
  {
    this->Origin = all.Low;
    this->Margin = MarginShare * all.Diagonal();
  }
  for (Index i = 0; i < static_cast<Index>(triangles.size()); ++i)
  {
    this->OfTriangle.push_back(this->Enclose(i, i + 1));
  }
  this->Nodes.reserve(triangles.size());
  if (!triangles.empty())
  {
    this->Build(0, static_cast<Index>(triangles.size()));
  }
}

Point3 TriangleTree::Corner(Index triangle, int i) const
{
  return this->Triangles[triangle].Corners[i] - this->Origin;
}

/// Along the longest sides, and across the triangles.
std::array<Point3, 3> TriangleTree::ChooseAxes(Index first, Index last) const
{
  std::vector<Point3> sides, normals;
  for (Index k = first; k < last; ++k)
  {
    const Point3 a = this->Corner(this->Order[k], 0);
    const Point3 b = this->Corner(this->Order[k], 1);
    const Point3 c = this->Corner(this->Order[k], 2);
    const std::array<Point3, 3> all{ b - a, c - b, a - c };
    sides.push_back(*std::max_element(all.begin(), all.end(),
      [](const Point3& p, const Point3& q) { return Dot(p, p) < Dot(q, q); }));
    normals.push_back(Cross(b - a, c - a));
  }
  const Point3 along = MainDirection(sides);
  const Point3 normal = MainDirection(normals);
  const Point3 across = Unit(normal - Dot(normal, along) * along);
  if (Dot(along, along) == 0.0 || Dot(across, across) == 0.0)
  {
    return CompleteFrame(Dot(along, along) > 0.0 ? along : Point3{ 0.0, 0.0, 1.0 });
  }
  return { along, across, Cross(along, across) };
}

TriangleTree::TurnedBox TriangleTree::Enclose(Index first, Index last) const
{
  constexpr double none = HUGE_VAL;
  TurnedBox box{ this->ChooseAxes(first, last), { none, none, none }, { -none, -none, -none } };
  for (Index k = first; k < last; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Point3 p = InBox(box.Axes, this->Corner(this->Order[k], i));
      for (int axis = 0; axis < 3; ++axis)
      {
        box.Low[axis] = std::min(box.Low[axis], p[axis] - this->Margin);
        box.High[axis] = std::max(box.High[axis], p[axis] + this->Margin);
      }
    }
  }
  return box;
}

Index TriangleTree::Build(Index first, Index last)
{
  const Index number = static_cast<Index>(this->Nodes.size());
  const TurnedBox box = this->Enclose(first, last);
  const Index greatest = *std::max_element(this->Order.begin() + first, this->Order.begin() + last);
  const Index patch = this->Triangles[this->Order[first]].Patch;
  const bool isOne = std::all_of(this->Order.begin() + first, this->Order.begin() + last,
    [&](Index triangle) { return this->Triangles[triangle].Patch == patch; });
  this->Nodes.push_back({ box, first, last, -1, -1, greatest, isOne ? patch : -1 });
  if (last - first <= TrianglesInLeaf)
  {
    return number;
  }
  const Point3 size = box.High - box.Low;
  const auto widest = std::max_element(size.begin(), size.end()) - size.begin();
  const auto middleOf = [&](Index triangle)
  {
    const Point3 sum =
      (this->Corner(triangle, 0) + this->Corner(triangle, 1)) + this->Corner(triangle, 2);
    return std::make_pair(Dot(box.Axes[widest], sum), triangle);
  };
  const Index half = first + (last - first) / 2;
  std::nth_element(this->Order.begin() + first, this->Order.begin() + half,
    this->Order.begin() + last, [&](Index a, Index b) { return middleOf(a) < middleOf(b); });
  const Index left = this->Build(first, half);
  const Index right = this->Build(half, last);
  this->Nodes[number].Left = left;
  this->Nodes[number].Right = right;
  return number;
}

/// Whether no side of either box separates the triangle and the other box.
bool TriangleTree::MayMeet(Index triangle, const TurnedBox& other) const
{
  const TurnedBox& own = this->OfTriangle[triangle];
  const Point3 a = this->Corner(triangle, 0);
  const Point3 b = this->Corner(triangle, 1);
  const Point3 c = this->Corner(triangle, 2);
  Point3 center{ 0.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    const double p = Dot(other.Axes[i], a);
    const double q = Dot(other.Axes[i], b);
    const double r = Dot(other.Axes[i], c);
    if (std::min({ p, q, r }) > other.High[i] || std::max({ p, q, r }) < other.Low[i])
    {
      return false;
    }
    center = center + (0.5 * (other.Low[i] + other.High[i])) * other.Axes[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    const double middle = Dot(own.Axes[i], center);
    double reach = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      reach += 0.5 * (other.High[j] - other.Low[j]) * std::abs(Dot(own.Axes[i], other.Axes[j]));
    }
    if (middle - reach > own.High[i] || middle + reach < own.Low[i])
    {
      return false;
    }
  }
  return true;
}

void TriangleTree::FindAfter(
  Index triangle, const PatchFilter& isWanted, std::vector<Index>& found) const
{
  const Index patch = this->Triangles[triangle].Patch;
  found.clear();
  std::vector<Index> open{ 0 };
  while (!open.empty())
  {
    const Node& node = this->Nodes[open.back()];
    open.pop_back();
    if (node.LastTriangle <= triangle || (node.Patch >= 0 && !isWanted(patch, node.Patch)) ||
      !this->MayMeet(triangle, node.Around))
    {
      continue;
    }
    if (node.Left >= 0)
    {
      open.push_back(node.Left);
      open.push_back(node.Right);
      continue;
    }
    for (Index k = node.First; k < node.Last; ++k)
    {
      const Index other = this->Order[k];
      if (other > triangle && this->MayMeet(triangle, this->OfTriangle[other]))
      {
        found.push_back(other);
      }
    }
  }
  std::sort(found.begin(), found.end());
}
}
