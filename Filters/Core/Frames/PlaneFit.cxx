// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/PlaneFit.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace orthoslices
{
void Scatter::Add(const Point3& p)
{
  const double products[6] = { p[0] * p[0], p[1] * p[1], p[2] * p[2], p[1] * p[2], p[2] * p[0],
    p[0] * p[1] };
  for (int i = 0; i < 6; ++i)
  {
    this->Sums[i] += products[i];
  }
  ++this->Points;
}

void Scatter::Add(const Scatter& other)
{
  for (int i = 0; i < 6; ++i)
  {
    this->Sums[i] += other.Sums[i];
  }
  this->Points += other.Points;
}

double Scatter::Along(const Point3& d) const
{
  const auto& s = this->Sums;
  const double sum = d[0] * d[0] * s[0] + d[1] * d[1] * s[1] + d[2] * d[2] * s[2] +
    2.0 * (d[1] * d[2] * s[3] + d[2] * d[0] * s[4] + d[0] * d[1] * s[5]);
  return this->Points > 0 ? std::sqrt(std::max(0.0, sum) / this->Points) : 0.0;
}

PlaneFit FitPlane(const Scatter& scatter)
{
  PlaneFit fit;
  if (scatter.Points == 0)
  {
    return fit;
  }
  const auto& s = scatter.Sums;
  Eigen::Matrix3d matrix;
  matrix << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix / scatter.Points);
  const auto root = [&](int i) { return std::sqrt(std::max(0.0, solver.eigenvalues()[i])); };
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  fit.Normal = Unit({ normal[0], normal[1], normal[2] });
  fit.Thickness = root(0);
  fit.Width = root(1);
  fit.Length = root(2);
  return fit;
}

Scatter MeasureScatter(const Polylines& lines, const std::vector<Index>& members, Point3& center)
{
  center = { 0.0, 0.0, 0.0 };
  Index count = 0;
  const auto visit = [&](auto&& visitor)
  {
    for (const Index line : members)
    {
      for (Index i = lines.Offsets[line]; i < lines.Offsets[line + 1]; ++i)
      {
        visitor(lines.PointAt(i));
      }
    }
  };
  visit(
    [&](const Point3& p)
    {
      // A running mean keeps the digits of coordinates far from zero.
      ++count;
      center = center + (1.0 / count) * (p - center);
    });
  Scatter scatter;
  if (std::isfinite(center[0] + center[1] + center[2]))
  {
    visit([&](const Point3& p) { scatter.Add(p - center); });
  }
  return scatter;
}
}
