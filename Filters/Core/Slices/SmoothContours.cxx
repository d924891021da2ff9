// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/SmoothContours.h"

#include "Core/Base/Vectors.h"
#include "Core/Slices/ContourCurve.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Vertices that long sides get in addition, so that all parts of a contour count by their lengths:
/// of the steps of an outline of pixels, vertices alone lie outside and inside by turns.
std::vector<Point2> DivideSides(const std::vector<Point2>& vertices, double longest)
{
  constexpr double most = 100.0; // of a side, however short a length is smoothed over
  std::vector<Point2> divided;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Point2 &p = vertices[i], &q = vertices[i + 1 < vertices.size() ? i + 1 : 0];
    const double parts = std::max(1.0, std::min(most, std::ceil(Length(q - p) / longest)));
    for (double part = 0.0; part < parts; ++part)
    {
      divided.push_back(Between(p, q, part / parts));
    }
  }
  return divided;
}

/// The vertices of a smoothed contour, no two consecutive ones equal; as it was if too few are
/// left.
std::vector<Point2> Smooth(const SpatialGrid& grid, double length, double cornerAngle, int axis,
  const std::vector<Point2>& vertices)
{
  constexpr double longestSide = 1.0 / 3.0;
  const double spacing = MeanSpacingInSlices(grid, axis), window = length * spacing;
  std::vector<Point2> divided = DivideSides(vertices, longestSide * window);
  ContourCurve plain; // as if all of it were noise
  plain.Set(std::vector<Point2>(divided));
  MeasuredCurve measured;
  measured.Set(std::move(divided), spacing, cornerAngle);
  ContourCurve& curve = measured.Curve;
  curve.KeepCorners(window, plain.FindNoise(window), cornerAngle);
  std::vector<Point2> smooth;
  for (Index i = 0; i < curve.Count(); ++i)
  {
    const Point2 place = curve.IsCorner(i) ? curve[i] : curve.FitAt(i, window).Place;
    const Point2 rounded{ grid.MoveIntoBounds(FirstAxis(axis), place[0]),
      grid.MoveIntoBounds(SecondAxis(axis), place[1]) };
    if (smooth.empty() || rounded != smooth.back())
    {
      smooth.push_back(rounded);
    }
  }
  while (smooth.size() > 1 && smooth.back() == smooth.front())
  {
    smooth.pop_back();
  }
  return smooth.size() < 3 ? vertices : smooth;
}
}

void SmoothContours(const SpatialGrid& grid, double length, double cornerAngle,
  const Execution& execution, Contours& contours)
{
  if (!(length > 0.0))
  {
    return;
  }
  std::vector<std::vector<Point2>> smoothed(contours.Count());
  execution.For(smoothed.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        std::vector<Point2> vertices;
        for (Index v = contours.Offsets[i]; v < contours.Offsets[i + 1]; ++v)
        {
          vertices.push_back({ contours.U[v], contours.V[v] });
        }
        smoothed[i] = contours.IsVirtual(static_cast<Index>(i))
          ? std::move(vertices)
          : Smooth(grid, length, cornerAngle, contours.Axis[i], vertices);
      }
    });
  contours.U.clear();
  contours.V.clear();
  contours.Offsets.assign(1, 0);
  for (const std::vector<Point2>& vertices : smoothed)
  {
    for (const Point2& vertex : vertices)
    {
      contours.U.push_back(vertex[0]);
      contours.V.push_back(vertex[1]);
    }
    contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
  }
}
}
