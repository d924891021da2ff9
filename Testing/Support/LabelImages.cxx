// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/LabelImages.h"

#include "Support/Random.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace orthoslices
{
namespace support
{
namespace
{
double DistanceOf(const Point3& p, const Point3& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

int NearestOf(const std::vector<Point3>& places, const Point3& p)
{
  const auto nearest = std::min_element(places.begin(), places.end(),
    [&](const Point3& a, const Point3& b) { return DistanceOf(p, a) < DistanceOf(p, b); });
  return static_cast<int>(nearest - places.begin());
}

using LabelFunction = std::function<int(const Point3&)>;

/// Fills an image with the labels that places have, in units of 0.4 times its size from its middle.
LabelImage Fill(int size, const LabelFunction& labelAt)
{
  LabelImage image;
  image.Size = size;
  image.Labels.resize(static_cast<std::size_t>(size) * size * size);
  const double middle = 0.5 * (size - 1), radius = 0.4 * size;
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        image.At(i, j, k) = static_cast<std::uint8_t>(
          labelAt({ (i - middle) / radius, (j - middle) / radius, (k - middle) / radius }));
      }
    }
  }
  return image;
}

std::vector<Point3> RandomPlaces(int count, double reach, Random& random)
{
  std::vector<Point3> places;
  while (static_cast<int>(places.size()) < count)
  {
    const Point3 p{ random.Uniform(-reach, reach), random.Uniform(-reach, reach),
      random.Uniform(-reach, reach) };
    const bool isApart = std::all_of(places.begin(), places.end(),
      [&](const Point3& q) { return DistanceOf(p, q) > 0.8 * reach / std::cbrt(count); });
    if (isApart)
    {
      places.push_back(p);
    }
  }
  return places;
}

bool IsInBall(const Point3& p) { return DistanceOf(p, { 0.0, 0.0, 0.0 }) < 1.0; }

/// Two-part balls within a ball of label 1.
LabelFunction NestBalls(int labels, Random& random)
{
  const std::vector<Point3> places = RandomPlaces(std::max(1, labels / 2), 0.55, random);
  std::vector<double> radii;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double radius = 0.9 - DistanceOf(places[i], { 0.0, 0.0, 0.0 });
    for (std::size_t j = 0; j < places.size(); ++j)
    {
      radius = j == i ? radius : std::min(radius, 0.5 * DistanceOf(places[i], places[j]));
    }
    radii.push_back(std::max(0.1, radius));
  }
  return [=](const Point3& p)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const double distance = DistanceOf(p, places[i]);
      const int label = static_cast<int>(2 + 2 * i);
      if (distance < radii[i])
      {
        return distance < 0.55 * radii[i] && label < labels ? label + 1 : label;
      }
    }
    return IsInBall(p) ? 1 : 0;
  };
}

LabelFunction Layers(int labels, int size, Random& random)
{
  const double thickness = random.Uniform(2.0, 4.0) / (0.4 * size);
  const double wave = random.Uniform(2.0, 4.0), depth = random.Uniform(0.05, 0.15);
  const Point3 normal{ random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(0.5, 1) };
  return [=](const Point3& p)
  {
    const double height = (p[0] * normal[0] + p[1] * normal[1] + p[2] * normal[2]) /
        DistanceOf(normal, { 0.0, 0.0, 0.0 }) +
      depth * std::sin(wave * p[0]) * std::cos(wave * p[1]);
    const int layer = static_cast<int>(std::floor((height + 2.0) / thickness));
    return IsInBall(p) ? 1 + layer % labels : 0;
  };
}

/// Blocks of five to nine samples.
LabelFunction Blocks(int labels, int size, Random& random)
{
  const double side = random.Uniform(5.0, 9.0) / (0.4 * size);
  std::vector<int> ofBlock;
  for (int i = 0; i < 4096; ++i)
  {
    ofBlock.push_back(static_cast<int>(random.Below(labels + 1)));
  }
  return [=](const Point3& p)
  {
    const auto number = [&](int axis)
    { return static_cast<int>(std::floor((p[axis] + 2.0) / side)); };
    return IsInBall(p) ? ofBlock[(number(0) + 16 * (number(1) + 16 * number(2))) % 4096] : 0;
  };
}
}

LabelImage DivideBall(const std::vector<Point3>& places, int size)
{
  return Fill(size, [&](const Point3& p) { return IsInBall(p) ? 1 + NearestOf(places, p) : 0; });
}

LabelImage MakeLabelImage(LabelKind kind, int labels, std::uint64_t seed, int size)
{
  Random random(seed);
  switch (kind)
  {
    case LabelKind::Nested:
      return Fill(size, NestBalls(labels, random));
    case LabelKind::Layers:
      return Fill(size, Layers(labels, size, random));
    case LabelKind::Corners:
      return Fill(size, Blocks(labels, size, random));
    default:
      break;
  }
  const std::vector<Point3> places = RandomPlaces(labels, 0.7, random);
  const Point3 sides{ random.Uniform(0.7, 1.1), random.Uniform(0.7, 1.1),
    random.Uniform(0.7, 1.1) };
  const Point3 phase{ random.Uniform(0, 6), random.Uniform(0, 6), random.Uniform(0, 6) };
  return Fill(size,
    [&](const Point3& p)
    {
      Point3 moved = p;
      bool isInBox = true;
      for (int i = 0; i < 3; ++i)
      {
        isInBox &= std::abs(p[i]) < sides[i];
        moved[i] +=
          kind == LabelKind::Wavy ? 0.12 * std::sin(6.0 * p[(i + 1) % 3] + phase[i]) : 0.0;
      }
      const bool isInside = kind == LabelKind::Box ? isInBox : IsInBall(p);
      return isInside ? 1 + NearestOf(places, moved) : 0;
    });
}

LabelImage Coarsen(const LabelImage& image, int block)
{
  LabelImage coarse = image;
  for (int k = 0; k < image.Size; ++k)
  {
    for (int j = 0; j < image.Size; ++j)
    {
      for (int i = 0; i < image.Size; ++i)
      {
        coarse.At(i, j, k) = image.At(i / block * block, j / block * block, k / block * block);
      }
    }
  }
  return coarse;
}

} // namespace support
} // namespace orthoslices
