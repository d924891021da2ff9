// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/BendingOperator.h"

#include <algorithm>
#include <utility>

namespace orthoslices
{
namespace
{
/// Weight of the edge of a corner, as seen from its triangle.
double HalfWeight(const SurfaceMesh& mesh, Index corner)
{
  // Angles of less than 3 degrees say nothing about the surface.
  constexpr double largest = 20.0;
  return std::clamp(0.5 * mesh.Cotangent(corner), -largest, largest);
}
}

BendingOperator MakeBendingOperator(EdgeWeights weights, const SurfaceMesh& mesh)
{
  const CornerTable& corners = mesh.Corners;
  const Index points = corners.PointCount();
  BendingOperator result{ SparseMatrix(points, points), std::vector<double>(points, 0.0) };
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> sum(points, 0.0);
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (!corners.IsAlive(corner))
    {
      continue;
    }
    const Index a = corners.StartOf(corner);
    const Index b = corners.EndOf(corner);
    const bool uniform = weights == EdgeWeights::Uniform;
    const double weight = uniform ? 0.5 : HalfWeight(mesh, corner);
    for (const auto& [row, column] : { std::pair(a, b), std::pair(b, a) })
    {
      entries.emplace_back(row, column, weight);
      sum[row] -= weight;
    }
    const Index c = corners.VertexOf(corner);
    const double area = Length(Cross(mesh.Edge(c, a), mesh.Edge(c, b))) / 6.0;
    const Point3& stretch = mesh.Stretch[c];
    result.Area[c] += uniform ? 1.0 : area / (stretch[0] * stretch[1] * stretch[2]);
  }
  for (Index point = 0; point < points; ++point)
  {
    entries.emplace_back(point, point, sum[point]);
  }
  result.Laplacian.setFromTriplets(entries.begin(), entries.end());
  return result;
}
}
