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

/// Of the extent of all triangles: rounding is some 1e-16, and what is so close is tested anyway.
constexpr double MarginShare = 1e-12;

/// The place of a point along a direction and across it.
Point2 InFrame(const Point2& direction, const Point2& p)
{
  return { Dot(direction, p), Cross(direction, p) };
}
}

TriangleTree::TriangleTree(const std::vector<PatchTriangle>& triangles)
  : Triangles(triangles)
  , Order(triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  this->ChooseAxis();
  for (Index i = 0; i < static_cast<Index>(triangles.size()); ++i)
  {
    this->OfTriangle.push_back(this->Frame(i, i + 1));
  }
  this->Nodes.reserve(triangles.size());
  if (!triangles.empty())
  {
    this->Build(0, static_cast<Index>(triangles.size()));
  }
}

/// The axis along which triangles are long for the box of all.
void TriangleTree::ChooseAxis()
{
  Box3 all;
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (const PatchTriangle& triangle : this->Triangles)
  {
    all.Add(triangle.Extent);
    sum = sum + (triangle.Extent.High - triangle.Extent.Low);
  }
  const Point3 size = all.High - all.Low;
  double best = -1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double reach = size[axis] > 0.0 ? sum[axis] / size[axis] : 0.0;
    if (reach > best)
    {
      best = reach;
      this->Axis = axis;
    }
  }
  this->Origin = { all.Low[FirstAxis(this->Axis)], all.Low[SecondAxis(this->Axis)] };
  this->Margin = MarginShare * (size[FirstAxis(this->Axis)] + size[SecondAxis(this->Axis)]);
}

Point2 TriangleTree::Corner(Index triangle, int i) const
{
  const Point3& p = this->Triangles[triangle].Corners[i];
  return Point2{ p[FirstAxis(this->Axis)], p[SecondAxis(this->Axis)] } - this->Origin;
}

/// The rectangle around some triangles, turned to the mean direction of their longest sides. As
/// sides have no sense, it is the mean of their angles doubled.
TriangleTree::Rectangle TriangleTree::Frame(Index first, Index last) const
{
  Point2 doubled{ 0.0, 0.0 };
  for (Index k = first; k < last; ++k)
  {
    Point2 longest{ 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      const Point2 side =
        this->Corner(this->Order[k], (i + 1) % 3) - this->Corner(this->Order[k], i);
      longest = Dot(side, side) > Dot(longest, longest) ? side : longest;
    }
    doubled = doubled +
      Point2{ longest[0] * longest[0] - longest[1] * longest[1], 2.0 * longest[0] * longest[1] };
  }
  const double angle = 0.5 * std::atan2(doubled[1], doubled[0]);
  Rectangle frame{ { std::cos(angle), std::sin(angle) }, { HUGE_VAL, HUGE_VAL },
    { -HUGE_VAL, -HUGE_VAL } };
  for (Index k = first; k < last; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Point2 p = InFrame(frame.U, this->Corner(this->Order[k], i));
      for (int side = 0; side < 2; ++side)
      {
        frame.Low[side] = std::min(frame.Low[side], p[side] - this->Margin);
        frame.High[side] = std::max(frame.High[side], p[side] + this->Margin);
      }
    }
  }
  return frame;
}

Index TriangleTree::Build(Index first, Index last)
{
  const Index number = static_cast<Index>(this->Nodes.size());
  const Rectangle frame = this->Frame(first, last);
  const Index greatest = *std::max_element(this->Order.begin() + first, this->Order.begin() + last);
  this->Nodes.push_back({ frame, first, last, -1, -1, greatest });
  if (last - first <= TrianglesInLeaf)
  {
    return number;
  }
  const int along = frame.High[0] - frame.Low[0] >= frame.High[1] - frame.Low[1] ? 0 : 1;
  const auto middleOf = [&](Index triangle)
  {
    const Point2 sum =
      (this->Corner(triangle, 0) + this->Corner(triangle, 1)) + this->Corner(triangle, 2);
    return std::make_pair(InFrame(frame.U, sum)[along], triangle);
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

/// Whether no side of either rectangle separates them, or the triangle itself from the other one.
bool TriangleTree::MayMeet(Index triangle, const Rectangle& other) const
{
  const std::array<Point2, 3> corners{ this->Corner(triangle, 0), this->Corner(triangle, 1),
    this->Corner(triangle, 2) };
  const auto isBeyond = [](const Rectangle& frame, const auto& points)
  {
    Point2 low{ HUGE_VAL, HUGE_VAL };
    Point2 high{ -HUGE_VAL, -HUGE_VAL };
    for (const Point2& point : points)
    {
      const Point2 p = InFrame(frame.U, point);
      low = { std::min(low[0], p[0]), std::min(low[1], p[1]) };
      high = { std::max(high[0], p[0]), std::max(high[1], p[1]) };
    }
    return low[0] > frame.High[0] || high[0] < frame.Low[0] || low[1] > frame.High[1] ||
      high[1] < frame.Low[1];
  };
  const auto corner = [&](double along, double across)
  {
    return Point2{ along * other.U[0] - across * other.U[1],
      along * other.U[1] + across * other.U[0] };
  };
  const std::array<Point2, 4> rectangle{ corner(other.Low[0], other.Low[1]),
    corner(other.High[0], other.Low[1]), corner(other.High[0], other.High[1]),
    corner(other.Low[0], other.High[1]) };
  return !isBeyond(other, corners) && !isBeyond(this->OfTriangle[triangle], rectangle);
}

void TriangleTree::FindAfter(Index triangle, std::vector<Index>& found) const
{
  found.clear();
  std::vector<Index> open{ 0 };
  while (!open.empty())
  {
    const Node& node = this->Nodes[open.back()];
    open.pop_back();
    if (node.LastTriangle <= triangle || !this->MayMeet(triangle, node.Around))
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
