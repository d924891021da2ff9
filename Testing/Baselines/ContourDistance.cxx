// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace baselines
{
namespace
{

constexpr std::size_t SegmentsPerLeaf = 4;
constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
double Distance2(const Point2& point, const Point2& from, const Point2& to)
{
  const double du = to[0] - from[0];
  const double dv = to[1] - from[1];
  const double length2 = du * du + dv * dv;
  const double dot = (point[0] - from[0]) * du + (point[1] - from[1]) * dv;
  const double along = length2 > 0.0 ? std::clamp(dot / length2, 0.0, 1.0) : 0.0;
  const double eu = point[0] - from[0] - along * du;
  const double ev = point[1] - from[1] - along * dv;
  return eu * eu + ev * ev;
}

} // anonymous namespace

//------------------------------------------------------------------------------
ContourDistance::ContourDistance(const std::vector<Loop>& loops)
{
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      this->Segments.push_back({ loop[i], loop[(i + 1) % loop.size()] });
    }
  }
  while (this->Leaves * SegmentsPerLeaf < this->Segments.size())
  {
    this->Leaves *= 2;
  }
  this->BuildBoxes();
}

//------------------------------------------------------------------------------
void ContourDistance::BuildBoxes()
{
  this->Boxes.resize(2 * this->Leaves - 1);
  for (std::size_t node = this->Boxes.size(); node-- > 0;)
  {
    if (node >= this->Leaves - 1)
    {
      this->Boxes[node] = this->BoxOfSegments((node - this->Leaves + 1) * SegmentsPerLeaf);
      continue;
    }
    const Box& a = this->Boxes[2 * node + 1];
    const Box& b = this->Boxes[2 * node + 2];
    this->Boxes[node] = { { std::min(a.Low[0], b.Low[0]), std::min(a.Low[1], b.Low[1]) },
      { std::max(a.High[0], b.High[0]), std::max(a.High[1], b.High[1]) } };
  }
}

//------------------------------------------------------------------------------
ContourDistance::Box ContourDistance::BoxOfSegments(std::size_t first) const
{
  Box box{ { Infinity, Infinity }, { -Infinity, -Infinity } };
  const std::size_t last = std::min(first + SegmentsPerLeaf, this->Segments.size());
  for (std::size_t i = first; i < last; ++i)
  {
    for (const Point2& point : { this->Segments[i].From, this->Segments[i].To })
    {
      for (int k = 0; k < 2; ++k)
      {
        box.Low[k] = std::min(box.Low[k], point[k]);
        box.High[k] = std::max(box.High[k], point[k]);
      }
    }
  }
  return box;
}

//------------------------------------------------------------------------------
void ContourDistance::VisitSegments(
  std::size_t first, const Point2& point, double& nearest2, std::size_t& segment) const
{
  const std::size_t last = std::min(first + SegmentsPerLeaf, this->Segments.size());
  for (std::size_t i = first; i < last; ++i)
  {
    const double distance2 = Distance2(point, this->Segments[i].From, this->Segments[i].To);
    if (distance2 < nearest2)
    {
      nearest2 = distance2;
      segment = i;
    }
  }
}

//------------------------------------------------------------------------------
// Depth first, the nearer box first; boxes beyond the best distance are skipped.
void ContourDistance::Visit(
  std::size_t node, const Point2& point, double& nearest2, std::size_t& segment) const
{
  if (node >= this->Leaves - 1)
  {
    this->VisitSegments((node - this->Leaves + 1) * SegmentsPerLeaf, point, nearest2, segment);
    return;
  }
  const auto distance2 = [&](const Box& box)
  {
    const double u = std::max({ box.Low[0] - point[0], 0.0, point[0] - box.High[0] });
    const double v = std::max({ box.Low[1] - point[1], 0.0, point[1] - box.High[1] });
    return u * u + v * v;
  };
  std::size_t children[2] = { 2 * node + 1, 2 * node + 2 };
  double distances2[2] = { distance2(this->Boxes[children[0]]),
    distance2(this->Boxes[children[1]]) };
  if (distances2[1] < distances2[0])
  {
    std::swap(children[0], children[1]);
    std::swap(distances2[0], distances2[1]);
  }
  for (int k = 0; k < 2; ++k)
  {
    if (distances2[k] < nearest2)
    {
      this->Visit(children[k], point, nearest2, segment);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<double> ContourDistance::CrossingsOfRow(double v) const
{
  std::vector<double> crossings;
  for (const Segment& s : this->Segments)
  {
    if ((s.From[1] <= v) != (s.To[1] <= v))
    {
      const double along = (v - s.From[1]) / (s.To[1] - s.From[1]);
      crossings.push_back(s.From[0] + along * (s.To[0] - s.From[0]));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

//------------------------------------------------------------------------------
void ContourDistance::SampleRow(const std::vector<double>& us, double v, double* values) const
{
  const std::vector<double> crossings = this->CrossingsOfRow(v);
  std::size_t passed = 0;
  std::size_t segment = 0; // the neighbour's nearest segment bounds the search from above
  for (std::size_t i = 0; i < us.size(); ++i)
  {
    while (passed < crossings.size() && crossings[passed] <= us[i])
    {
      ++passed;
    }
    const Point2 point{ us[i], v };
    const Segment& guess = this->Segments[segment];
    double nearest2 = Distance2(point, guess.From, guess.To);
    this->Visit(0, point, nearest2, segment);
    values[i] = (passed % 2 == 1 ? 1.0 : -1.0) * std::sqrt(nearest2);
  }
}

} // namespace baselines
} // namespace orthoslices
