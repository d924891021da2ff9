// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/MeasureAgreement.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
void Agreement::Add(double disagreement)
{
  ++this->NodePoints;
  this->SumOfSquares += disagreement * disagreement;
  this->Greatest = std::max(this->Greatest, std::abs(disagreement));
}

double Agreement::RootMeanSquare() const
{
  return this->NodePoints > 0 ? std::sqrt(this->SumOfSquares / this->NodePoints) : 0.0;
}

namespace
{
/// Determinant of the equations by their squared trace below which all normals count as parallel.
/// It is about a quarter of the squared angle between them: 6e-5 radians, far less than contours
/// tell.
constexpr double MinDeterminant = 1e-9;

/// Least squares for the shift (u, v) of one slice.
struct ShiftEquations
{
  double UU = 0.0, UV = 0.0, VV = 0.0, U = 0.0, V = 0.0;

  /// A point of the contour with unit normal (nu, nv) should move by `distance` along the normal.
  void Add(double nu, double nv, double distance)
  {
    this->UU += nu * nu;
    this->UV += nu * nv;
    this->VV += nv * nv;
    this->U += nu * distance;
    this->V += nv * distance;
  }

  std::array<double, 2> Solve() const
  {
    const double det = this->UU * this->VV - this->UV * this->UV;
    const double trace = this->UU + this->VV;
    if (!(det > MinDeterminant * trace * trace))
    {
      return { 0.0, 0.0 }; // nothing is known of a shift across the normals
    }
    return { (this->VV * this->U - this->UV * this->V) / det,
      (this->UU * this->V - this->UV * this->U) / det };
  }
};
}

SliceAgreement MeasureAgreement(const Contours& contours, const SpatialGrid& grid,
  const GridCrossings& crossings, const NodePoints& nodes, const std::vector<double>& nodeNormals)
{
  const GridEdgeCode code(grid);
  SliceAgreement result;
  result.OfContour.resize(contours.Count());
  std::array<std::vector<ShiftEquations>, 3> equations;
  for (int axis = 0; axis < 3; ++axis)
  {
    result.OfPlane[axis].resize(grid.Count(axis));
    result.Shift[axis].assign(grid.Count(axis), Point3{ 0.0, 0.0, 0.0 });
    equations[axis].resize(grid.Count(axis));
  }
  for (Index node = 0; node < nodes.Count(); ++node)
  {
    const GridEdge edge = code.Decode(crossings.Edge[nodes.First[node]]);
    const int t = edge.Direction;
    if (!AreReal(grid, edge))
    {
      continue;
    }
    const double* normal = nodeNormals.data() + 3 * static_cast<std::size_t>(node);
    for (const Index crossing : { nodes.First[node], nodes.Second[node] })
    {
      const Index contour = crossings.RunContour[crossing];
      if (contour == GridCrossings::None)
      {
        continue;
      }
      const double difference = nodes.Difference[node];
      const double distance = crossing == nodes.First[node] ? difference : -difference;
      const int axis = contours.Axis[contour];
      const Index plane = contours.Plane[contour];
      result.OfContour[contour].Add(distance);
      result.OfPlane[axis][plane].Add(distance);
      const double nu = normal[FirstAxis(axis)];
      const double nv = normal[SecondAxis(axis)];
      const double length = std::sqrt(nu * nu + nv * nv);
      if (length > 0.0)
      {
        equations[axis][plane].Add(nu / length, nv / length, normal[t] / length * distance);
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (Index plane = 0; plane < grid.Count(axis); ++plane)
    {
      const auto shift = equations[axis][plane].Solve();
      result.Shift[axis][plane][FirstAxis(axis)] = shift[0];
      result.Shift[axis][plane][SecondAxis(axis)] = shift[1];
    }
  }
  return result;
}
}
