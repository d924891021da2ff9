// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/ContourSamples.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// On the smallest contour there are that many samples.
constexpr std::size_t FewestSamples = 6;
/// Of samples closer than that share of their distance on the contours, as where slices cross, one
/// is left out.
constexpr double Apart = 0.2;
/// The system of that many takes a second or two.
constexpr double MostSamples = 1600.0;
/// And that of so many, a few hundredths.
constexpr double FewSamples = 600.0;

double LengthOf(const Contours& contours, Index contour)
{
  double length = 0.0;
  const Index first = contours.Offsets[contour], last = contours.Offsets[contour + 1];
  for (Index i = first; i < last; ++i)
  {
    const Index next = i + 1 < last ? i + 1 : first;
    length += std::hypot(contours.U[next] - contours.U[i], contours.V[next] - contours.V[i]);
  }
  return length;
}

/// Where a contour is, at even lengths along it.
std::vector<Point2> PlacesOn(const Contours& contours, Index contour, std::size_t count)
{
  std::vector<Point2> places;
  const double step = LengthOf(contours, contour) / static_cast<double>(count);
  const Index first = contours.Offsets[contour], last = contours.Offsets[contour + 1];
  double done = 0.0;
  for (Index i = first; i < last; ++i)
  {
    const Index next = i + 1 < last ? i + 1 : first;
    const double du = contours.U[next] - contours.U[i], dv = contours.V[next] - contours.V[i];
    const double length = std::hypot(du, dv);
    while (places.size() < count && step * static_cast<double>(places.size()) <= done + length)
    {
      const double t =
        length > 0.0 ? (step * static_cast<double>(places.size()) - done) / length : 0.0;
      places.push_back({ contours.U[i] + t * du, contours.V[i] + t * dv });
    }
    done += length;
  }
  return places;
}

/// At every second place of a contour: the normal is that of the line through the places beside it.
void AddSamples(
  const Contours& contours, Index contour, std::size_t count, std::vector<ContourSample>& samples)
{
  const std::vector<Point2> places = PlacesOn(contours, contour, 2 * count);
  const int axis = contours.Axis[contour];
  const std::size_t n = places.size();
  for (std::size_t i = 0; i + 1 < n; i += 2)
  {
    const Point2& before = places[(i + n - 1) % n];
    const Point2& after = places[i + 1];
    const double du = after[0] - before[0], dv = after[1] - before[1];
    const double length = std::hypot(du, dv);
    if (length > 0.0)
    {
      ContourSample sample;
      sample.Position[axis] = contours.Coordinate[contour];
      sample.Position[FirstAxis(axis)] = places[i][0];
      sample.Position[SecondAxis(axis)] = places[i][1];
      sample.Inwards[axis] = 0.0;
      sample.Inwards[FirstAxis(axis)] = -dv / length;
      sample.Inwards[SecondAxis(axis)] = du / length;
      samples.push_back(sample);
    }
  }
}

}

double SampleStep(const Contours& contours, double wanted)
{
  double length = 0.0;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    length += LengthOf(contours, i);
  }
  return std::clamp(wanted, length / MostSamples, length / FewSamples);
}

std::vector<ContourSample> SampleContours(const Contours& contours, double step)
{
  std::vector<ContourSample> all, samples;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const double count = std::round(LengthOf(contours, i) / step);
    AddSamples(contours, i, std::max(FewestSamples, static_cast<std::size_t>(count)), all);
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
