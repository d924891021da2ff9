// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourSamples.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace orthoslices
{
namespace baselines
{
namespace
{

using Vector3 = std::array<double, 3>;

//------------------------------------------------------------------------------
double Distance(const Vector3& a, const Vector3& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

//------------------------------------------------------------------------------
Vector3 Move(const Vector3& from, const Vector3& direction, double distance)
{
  return { from[0] + distance * direction[0], from[1] + distance * direction[1],
    from[2] + distance * direction[2] };
}

//------------------------------------------------------------------------------
// Points of the loop at equal distances along it, the first one at half of that.
Loop SampleEvenly(const Loop& loop, std::size_t count)
{
  const double step = Perimeter(loop) / static_cast<double>(count);
  Loop samples;
  double passed = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& a = loop[i];
    const Point2& b = loop[(i + 1) % loop.size()];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    for (double next = (samples.size() + 0.5) * step;
         samples.size() < count && next <= passed + length; next = (samples.size() + 0.5) * step)
    {
      const double fraction = (next - passed) / length;
      samples.push_back({ a[0] + fraction * (b[0] - a[0]), a[1] + fraction * (b[1] - a[1]) });
    }
    passed += length;
  }
  return samples;
}

//------------------------------------------------------------------------------
// The interior lies on the left of a loop, seen from the positive end of the axis. A tangent is the
// chord between the samples before and behind.
void AppendSamples(
  int axis, double coordinate, const Loop& loop, std::vector<ContourSample>& samples)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& before = loop[(i + loop.size() - 1) % loop.size()];
    const Point2& behind = loop[(i + 1) % loop.size()];
    const Point2 chord{ behind[0] - before[0], behind[1] - before[1] };
    const double length = std::hypot(chord[0], chord[1]);
    if (length > 0.0)
    {
      const Point2 left{ -chord[1] / length, chord[0] / length };
      samples.push_back({ PlaceInSpace(axis, coordinate, loop[i]), PlaceInSpace(axis, 0.0, left) });
    }
  }
}

//------------------------------------------------------------------------------
// At least FEWEST samples on each loop.
std::vector<ContourSample> SampleAllLoops(const SliceFamilies& families, double step)
{
  constexpr double fewest = 6.0;
  std::vector<ContourSample> samples;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Slice& slice : families[axis])
    {
      for (const Loop& loop : slice.Loops)
      {
        const double count = std::max(fewest, std::round(Perimeter(loop) / step));
        AppendSamples(
          axis, slice.Coordinate, SampleEvenly(loop, static_cast<std::size_t>(count)), samples);
      }
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
// Where slices cross, one of two samples that are nearly the same is left out.
std::vector<ContourSample> WithoutNeighbours(
  const std::vector<ContourSample>& samples, double closest)
{
  std::vector<ContourSample> kept;
  for (const ContourSample& sample : samples)
  {
    if (std::none_of(kept.begin(), kept.end(),
          [&](const ContourSample& other)
          { return Distance(sample.Position, other.Position) < closest; }))
    {
      kept.push_back(sample);
    }
  }
  return kept;
}

//------------------------------------------------------------------------------
double DistanceFromSamples(const Vector3& position, const std::vector<ContourSample>& samples)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const ContourSample& sample : samples)
  {
    nearest = std::min(nearest, Distance(position, sample.Position));
  }
  return nearest;
}

//------------------------------------------------------------------------------
// A point at the signed DISTANCE from its sample, which is about the nearest one. The distance is
// halved until that holds, or else the point is left out.
void AppendOffSurface(const ContourSample& sample, double distance,
  const std::vector<ContourSample>& samples, std::vector<RadialConstraint>& constraints)
{
  constexpr double own = 0.7; // less than 1: samples of slices that cross lie on both sides
  constexpr int halvings = 4;
  for (int i = 0; i <= halvings; ++i, distance *= 0.5)
  {
    const Vector3 position = Move(sample.Position, sample.Inwards, distance);
    if (DistanceFromSamples(position, samples) >= own * std::abs(distance))
    {
      constraints.push_back({ position, distance });
      return;
    }
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
double TotalLength(const SliceFamilies& families)
{
  double length = 0.0;
  for (const std::vector<Slice>& family : families)
  {
    for (const Slice& slice : family)
    {
      for (const Loop& loop : slice.Loops)
      {
        length += Perimeter(loop);
      }
    }
  }
  return length;
}

//------------------------------------------------------------------------------
std::vector<ContourSample> SampleContours(const SliceFamilies& families, double step)
{
  return WithoutNeighbours(SampleAllLoops(families, step), 0.1 * step);
}

//------------------------------------------------------------------------------
std::vector<RadialConstraint> MakeConstraints(
  const std::vector<ContourSample>& samples, double offset)
{
  std::vector<RadialConstraint> constraints;
  for (const ContourSample& sample : samples)
  {
    constraints.push_back({ sample.Position, 0.0 });
    AppendOffSurface(sample, offset, samples, constraints);
    AppendOffSurface(sample, -offset, samples, constraints);
  }
  return constraints;
}

} // namespace baselines
} // namespace orthoslices
