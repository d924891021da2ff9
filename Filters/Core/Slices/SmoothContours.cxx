// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slices/SmoothContours.h"

#include "Core/Slices/ContourCurve.h"

namespace orthoslices
{
namespace
{
/// The vertices of a smoothed contour, no two consecutive ones equal; as it was if too few are
/// left.
std::vector<Point2> Smooth(const SpatialGrid& grid, double length, double cornerAngle, int axis,
  std::vector<Point2>&& vertices)
{
  const double spacing = MeanSpacingInSlices(grid, axis);
  MeasuredCurve measured;
  measured.Set(std::move(vertices), spacing, cornerAngle);
  const ContourCurve& curve = measured.Curve;
  std::vector<Point2> smooth, before;
  for (Index i = 0; i < curve.Count(); ++i)
  {
    const Point2 place = curve.IsCorner(i) ? curve[i] : curve.FitAt(i, length * spacing).Place;
    const Point2 rounded{ grid.MoveIntoBounds(FirstAxis(axis), place[0]),
      grid.MoveIntoBounds(SecondAxis(axis), place[1]) };
    if (smooth.empty() || rounded != smooth.back())
    {
      smooth.push_back(rounded);
    }
    before.push_back(curve[i]);
  }
  while (smooth.size() > 1 && smooth.back() == smooth.front())
  {
    smooth.pop_back();
  }
  return smooth.size() < 3 ? before : smooth;
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
          : Smooth(grid, length, cornerAngle, contours.Axis[i], std::move(vertices));
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
