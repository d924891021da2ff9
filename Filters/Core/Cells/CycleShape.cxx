// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CycleShape.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
/// Surface normals at the node points; for a loop, normals of the contour in its plane.
void CycleDescriber::AddNormals(CycleShape& shape) const
{
  double total = 0.0;
  const auto add = [&](const Point3& normal, double weight)
  {
    shape.Normals.push_back(Unit(normal));
    shape.Weights.push_back(weight);
    total += weight;
  };
  if (shape.Loop)
  {
    const int axis = this->Geometry.Graph.Loops[this->Geometry.LoopOf(shape.Cycle)].Axis;
    const double sign = this->Geometry.FirstArc(shape.Cycle).Above ? 1.0 : -1.0;
    const Point3 up = sign * this->Geometry.Grid.Metric.Normal(axis);
    for (std::size_t i = 0; i < shape.Border.size(); ++i)
    {
      const Point3 along = shape.Border[(i + 1) % shape.Border.size()] - shape.Border[i];
      add(Cross(along, up), Length(along));
    }
  }
  shape.Disagreement = 0.0;
  for (const Index place : this->NodePlaces)
  {
    shape.Disagreement =
      std::max(shape.Disagreement, this->Geometry.Nodes.Disagreement(this->Points[place]));
    const double* n = this->NodeNormals.data() + 3 * static_cast<std::size_t>(this->Points[place]);
    const Point3 normal{ n[0], n[1], n[2] };
    if (Dot(normal, normal) > 0.0)
    {
      add(this->Geometry.Grid.Metric.IsWorld() ? normal
                                               : this->Geometry.Grid.Metric.NormalToWorld(normal),
        1.0);
    }
  }
  for (double& weight : shape.Weights)
  {
    weight /= total > 0.0 ? total : 1.0;
  }
}

/**
 * The border is that of a sheet if normals all along it point to the same side as the disc does, or
 * if the surface goes straight across: 1 if it need not turn, 0 if by 90 degrees in the mean.
 */
void CycleDescriber::AddHeadings(CycleShape& shape) const
{
  const SpatialGrid& grid = this->Geometry.Grid;
  if (shape.Loop || std::min({ grid.Count(0), grid.Count(1), grid.Count(2) }) >= MinPlanes)
  {
    return;
  }
  shape.Headings = FindHeadings(this->Geometry, this->NodeNormals, shape.Cycle);
  shape.Turn = TurnAcross(shape.Headings);
  double flatness = 0.0;
  for (const Heading& heading : shape.Headings)
  {
    flatness += heading.Weight * Dot(heading.Normal, shape.Area);
  }
  shape.Flatness = std::max({ shape.Flatness, flatness, 1.0 - 2.0 * shape.Turn });
}

CycleShape CycleDescriber::Describe(Index cycle)
{
  CycleShape shape;
  shape.Cycle = cycle;
  shape.Loop = this->Geometry.IsLoop(cycle);
  this->Geometry.GetBoundary(cycle, this->Points, this->NodePlaces);
  for (const Index point : this->Points)
  {
    shape.Border.push_back(this->InWorld(this->Geometry.Graph.PointAt(point)));
  }
  const Point3& origin = shape.Border.front();
  CurveCenter center(origin);
  Point3 area{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < shape.Border.size(); ++i)
  {
    const Point3& p = shape.Border[i];
    const Point3& q = shape.Border[(i + 1) % shape.Border.size()];
    center.Add(p, q);
    area = area + Cross(p - origin, q - origin);
  }
  const double length = center.TotalLength();
  shape.Center = center.Get();
  shape.Area = Unit(area);
  double square = 0.0;
  for (std::size_t i = 0; i < shape.Border.size(); ++i)
  {
    const std::size_t before = i > 0 ? i - 1 : shape.Border.size() - 1;
    const Point3 arm = shape.Border[i] - shape.Center;
    square += 0.5 * Dot(arm, arm) *
      (Length(shape.Border[i] - shape.Border[before]) +
        Length(shape.Border[(i + 1) % shape.Border.size()] - shape.Border[i]));
  }
  shape.Radius = length > 0.0 ? std::sqrt(square / length) : 0.0;
  const double* apex = this->CentralPoints.data() + 3 * static_cast<std::size_t>(cycle);
  shape.Apex = shape.Loop ? shape.Center : this->InWorld({ apex[0], apex[1], apex[2] });
  this->AddNormals(shape);
  // Contours that touch each other's planes without crossing them give no normals: then nothing
  // speaks for a tube.
  shape.Flatness = shape.Normals.empty() ? 1.0 : 0.0;
  for (std::size_t i = 0; i < shape.Normals.size() && !shape.Loop; ++i)
  {
    shape.Flatness += shape.Weights[i] * Dot(shape.Normals[i], shape.Area);
  }
  this->AddHeadings(shape);
  return shape;
}
}
