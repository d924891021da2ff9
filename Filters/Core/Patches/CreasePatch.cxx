// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/CreasePatch.h"

#include "Core/Base/LeastSquares.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/**
 * Weight of the middle of the border, where that of all its tangent planes is 1. Along an edge that
 * crosses the cell straight the planes leave the point's place open: it stays beside the middle. A
 * vertex where planes meet is moved towards the middle by a few thousandths of its distance from it.
 */
constexpr double WeightOfMiddle = 1e-3;

/// How far the point may lie from the middle of the border, in its mean radii: planes that are nearly
/// parallel meet anywhere. The corner of a cube in the middle of its
/// cell is 1.1 radii off.
constexpr double MaxOffset = 1.5;
}

bool HasCorner(const PatchBorder& border, const std::vector<std::uint8_t>& corners)
{
  return !corners.empty() &&
    std::any_of(
      border.Points.begin(), border.Points.end(), [&](Index point) { return corners[point] != 0; });
}

double BuildCreasePatch(const SpatialGrid& grid, const PatchBorder& border,
  const std::vector<std::uint8_t>& corners, InnerPatch& patch)
{
  double matrix[3][3] = { { WeightOfMiddle, 0.0, 0.0 }, { 0.0, WeightOfMiddle, 0.0 },
    { 0.0, 0.0, WeightOfMiddle } };
  double right[3] = {};
  double radius2 = 0.0;
  for (std::size_t i = 0; i < border.Points.size(); ++i)
  {
    radius2 += border.Weights[i] * SquaredDistance(border.Center, border.Places[i]);
    if (corners[border.Points[i]] != 0)
    {
      continue;
    }
    const Point3& n = border.Normals[i];
    const double weight = border.Weights[i];
    const double height = Dot(n, border.Places[i] - border.Center);
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        matrix[a][b] += weight * n[a] * n[b];
      }
      right[a] += weight * n[a] * height;
    }
  }
  patch.Clear();
  if (!Factorize(matrix))
  {
    return HUGE_VAL;
  }
  Substitute(matrix, right);
  const Point3 offset{ right[0], right[1], right[2] };
  if (Dot(offset, offset) > MaxOffset * MaxOffset * radius2)
  {
    return HUGE_VAL;
  }
  patch.Points.push_back(border.MoveInside(grid, border.Center + offset));
  patch.Normals.push_back({ 0.0, 0.0, 0.0 });
  for (Index i = 0; i < border.Count(); ++i)
  {
    patch.Triangles.push_back({ -1, i, i + 1 < border.Count() ? i + 1 : 0 });
  }
  double sum = 0.0;
  for (Index i = 0; i < border.Count(); ++i)
  {
    const double distance = Dot(border.Normals[i], patch.Points[0] - border.Places[i]);
    sum += corners[border.Points[i]] != 0 ? 0.0 : border.Weights[i] * distance * distance;
  }
  return std::sqrt(sum);
}
}
