// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/ContourSamples.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace orthoslices
{
namespace
{
/// On the smallest contour there are that many samples.
constexpr std::size_t FewestSamples = 6;
/// Of samples closer than that share of their distance on the contours, as where slices cross, one
/// is left out.
constexpr double Apart = 0.2;
/// The system of that many takes a second or two,
constexpr double MostSamples = 1600.0;
/// and that of so many, a few hundredths.
constexpr double FewSamples = 600.0;

double LengthOf(const WorldLoop& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.Points.size(); ++i)
  {
    length += Length(loop.Points[(i + 1) % loop.Points.size()] - loop.Points[i]);
  }
  return length;
}

/// The same to the last bit whichever axis is the first one.
double SumOfSquares(Point3 p)
{
  for (double& x : p)
  {
    x *= x;
  }
  std::sort(p.begin(), p.end());
  return p[0] + p[1] + p[2];
}

/// Where a contour is, at even lengths along it.
std::vector<Point3> PlacesOn(const WorldLoop& loop, std::size_t count)
{
  std::vector<Point3> places;
  const double step = LengthOf(loop) / static_cast<double>(count);
  double done = 0.0;
  for (std::size_t i = 0; i < loop.Points.size(); ++i)
  {
    const Point3& from = loop.Points[i];
    const Point3 side = loop.Points[(i + 1) % loop.Points.size()] - from;
    const double length = Length(side);
    const auto next = [&] { return step * static_cast<double>(places.size()); };
    while (places.size() < count && next() <= done + length)
    {
      const double share = length > 0.0 ? (next() - done) / length : 0.0;
      places.push_back(from + share * side);
    }
    done += length;
  }
  return places;
}

/// At every second place of a contour: the normal is that of the line through the places beside it.
void AddSamples(const WorldLoop& loop, std::size_t count, std::vector<ContourSample>& samples)
{
  const std::vector<Point3> places = PlacesOn(loop, 2 * count);
  const std::size_t n = places.size();
  for (std::size_t i = 0; i + 1 < n; i += 2)
  {
    const Point3 inwards = Cross(loop.Normal, places[i + 1] - places[(i + n - 1) % n]);
    const double length = Length(inwards);
    if (length > 0.0)
    {
      samples.push_back({ places[i], (1.0 / length) * inwards });
    }
  }
}
}

std::vector<WorldLoop> MapToWorld(const Contours& contours, const AxisFrame& metric)
{
  std::vector<WorldLoop> loops(contours.Count());
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    loops[contour].Normal = metric.Normal(contours.Axis[contour]);
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      loops[contour].Points.push_back(metric.ToWorld(contours.World(contour, i)));
    }
  }
  return loops;
}

void AppendGuides(
  const std::vector<GuideContours>& guides, const AxisFrame& metric, std::vector<WorldLoop>& loops)
{
  for (const GuideContours& guide : guides)
  {
    for (const std::vector<Point3>& points : guide.Loops)
    {
      loops.push_back({ {}, metric.NormalToWorld(guide.Plane.Normal) });
      for (const Point3& point : points)
      {
        loops.back().Points.push_back(metric.ToWorld(point));
      }
    }
  }
}

void SortLoops(std::vector<WorldLoop>& loops)
{
  Box3 box;
  for (const WorldLoop& loop : loops)
  {
    std::for_each(loop.Points.begin(), loop.Points.end(), [&](const Point3& p) { box.Add(p); });
  }
  const Point3 middle = 0.5 * (box.Low + box.High);
  const auto isFarther = [&](const Point3& a, const Point3& b)
  {
    const double ofA = SumOfSquares(a - middle), ofB = SumOfSquares(b - middle);
    return ofA != ofB ? ofA > ofB : a < b;
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (WorldLoop& loop : loops)
  {
    std::vector<Point3>& points = loop.Points;
    std::rotate(
      points.begin(), std::min_element(points.begin(), points.end(), isFarther), points.end());
    order.emplace_back(-LengthOf(loop), order.size());
  }
  std::sort(order.begin(), order.end(),
    [&](const auto& a, const auto& b)
    {
      const WorldLoop &ofA = loops[a.second], &ofB = loops[b.second];
      return std::tie(a.first, ofA.Normal, ofA.Points) < std::tie(b.first, ofB.Normal, ofB.Points);
    });
  std::vector<WorldLoop> sorted;
  for (const auto& [length, number] : order)
  {
    sorted.push_back(std::move(loops[number]));
  }
  loops.swap(sorted);
}

double SampleStep(const std::vector<WorldLoop>& loops, double wanted)
{
  double length = 0.0;
  for (const WorldLoop& loop : loops)
  {
    length += LengthOf(loop);
  }
  return std::clamp(wanted, length / MostSamples, length / FewSamples);
}

std::vector<ContourSample> SampleLoops(const std::vector<WorldLoop>& loops, double step)
{
  std::vector<ContourSample> all, samples;
  for (const WorldLoop& loop : loops)
  {
    const double count = std::round(LengthOf(loop) / step);
    AddSamples(loop, std::max(FewestSamples, static_cast<std::size_t>(count)), all);
  }
  for (const ContourSample& sample : all)
  {
    const auto isNear = [&](const ContourSample& other)
    { return Length(other.Position - sample.Position) < Apart * step; };
    if (std::none_of(samples.begin(), samples.end(), isNear))
    {
      samples.push_back(sample);
    }
  }
  return samples;
}
}
