// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/SnapVertices.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
std::int64_t SnapTarget::CellOf(double x) const
{
  return static_cast<std::int64_t>(std::floor(x / this->CellSize));
}

std::uint64_t SnapTarget::KeyOf(std::int64_t i, std::int64_t j)
{
  return static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(j);
}

void SnapTarget::Add(const std::vector<Point2>& polygon)
{
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Point2 &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const Index side = static_cast<Index>(this->Sides.size());
    this->Sides.push_back({ from, to });
    // In parts no longer than a square, each filed in the squares around it.
    const int parts = 1 + static_cast<int>(Distance(from, to) / this->CellSize);
    for (int part = 0; part < parts; ++part)
    {
      const Point2 p = Between(from, to, double(part) / parts);
      const Point2 q = Between(from, to, double(part + 1) / parts);
      std::array<std::int64_t, 2> low, high;
      for (int i = 0; i < 2; ++i)
      {
        low[i] = this->CellOf(std::min(p[i], q[i]) - this->Reach);
        high[i] = this->CellOf(std::max(p[i], q[i]) + this->Reach);
      }
      for (std::int64_t i = low[0]; i <= high[0]; ++i)
      {
        for (std::int64_t j = low[1]; j <= high[1]; ++j)
        {
          std::vector<Index>& sides = this->SidesIn[KeyOf(i, j)];
          if (sides.empty() || sides.back() != side)
          {
            sides.push_back(side);
          }
        }
      }
    }
  }
}

bool SnapTarget::Snap(Point2& point) const
{
  const auto found = this->SidesIn.find(KeyOf(this->CellOf(point[0]), this->CellOf(point[1])));
  if (found == this->SidesIn.end())
  {
    return false;
  }
  double nearestCorner = this->Reach * this->Reach, nearestPlace = nearestCorner;
  Point2 corner = point, place = point;
  for (const Index number : found->second)
  {
    const Side& side = this->Sides[number];
    const double toCorner = SquaredDistance(point, side.From);
    if (toCorner < nearestCorner)
    {
      nearestCorner = toCorner;
      corner = side.From;
    }
    const Point2 along = side.To - side.From;
    const double length = Dot(along, along);
    const double share = length > 0.0 ? Dot(point - side.From, along) / length : 0.0;
    const Point2 foot = Between(side.From, side.To, std::clamp(share, 0.0, 1.0));
    const double toPlace = SquaredDistance(point, foot);
    if (toPlace < nearestPlace)
    {
      nearestPlace = toPlace;
      place = foot;
    }
  }
  const Point2 before = point;
  point = nearestCorner < this->Reach * this->Reach ? corner : place;
  return point != before;
}
}
