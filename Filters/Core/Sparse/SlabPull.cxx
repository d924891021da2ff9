// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SlabPull.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Where in its slab a surface is in the mean that is farther from all contours than the slices
/// from each other, from the inside of the solid to the outside: there are more tops than pits.
constexpr double MeanPlace = 0.55;
/// Strength, in widths of the slab, for shapes of this roughness: half of the pull shows two
/// spacings from the contours, as the true surfaces of a dozen scans do.
constexpr double UsualRoughness = 0.3;
constexpr double UsualStrength = 3.0;
/// The strength grows with this power of the roughness. Were all shapes of one kind, the square of
/// their deviations from least bending would grow with the roughness, and so would the strength;
/// contours of smooth shapes, moreover, say more about the place between.
constexpr double PowerOfRoughness = 1.5;
/// At most so much more than the usual strength: the reach does not change much then.
constexpr double MaxGrowth = 8.0;
/// Beyond the last slice the surface ends at half a slab anyway, so that it says less.
constexpr double ShareAtEnds = 0.25;

/// A slab, from its lower plane to its upper one; an end is as wide as the others.
struct Slab
{
  double Low, High;
  bool IsEnd;
};

std::vector<Slab> FindSlabs(const SurfaceMesh& mesh)
{
  const int axis = mesh.StretchAxis;
  Box3 all;
  for (const Box3& cell : mesh.Cells)
  {
    all.Add(cell.Low);
    all.Add(cell.High);
  }
  std::vector<Slab> slabs;
  for (const Box3& cell : mesh.Cells)
  {
    const double low = cell.Low[axis];
    const double high = cell.High[axis];
    const bool isFirst = low == all.Low[axis];
    const bool isLast = high == all.High[axis];
    slabs.push_back({ isFirst ? low - (high - low) : low, isLast ? high + (high - low) : high,
      isFirst || isLast });
  }
  return slabs;
}
}

SlabPull PullIntoSlabs(const SurfaceMesh& mesh, double roughness)
{
  const CornerTable& corners = mesh.Corners;
  const int axis = mesh.StretchAxis;
  SlabPull pull{ std::vector<double>(mesh.Points.size(), 0.0),
    std::vector<double>(mesh.Points.size(), 0.0) };
  std::vector<double> upwards(mesh.Points.size(), 0.0);
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (corners.IsAlive(corner))
    {
      const Index point = corners.VertexOf(corner);
      const Point3 normal = Cross(
        mesh.InWorld(point, corners.StartOf(corner)), mesh.InWorld(point, corners.EndOf(corner)));
      const double length = std::max(Length(normal), 1e-300);
      const double up = Dot(normal, mesh.Metric.Normal(axis));
      pull.Strength[point] += up / length * up / 6.0;
      upwards[point] += up;
    }
  }
  const double strength = UsualStrength *
    std::min(MaxGrowth, std::pow(std::max(roughness, 0.0) / UsualRoughness, PowerOfRoughness));
  const std::vector<Slab> slabs = FindSlabs(mesh);
  for (Index point = 0; point < corners.PointCount(); ++point)
  {
    if (!corners.IsUsed(point) || mesh.Fixed[point])
    {
      pull.Strength[point] = 0.0;
      continue;
    }
    const Slab& slab = slabs[mesh.Cell[corners.CornerAt(point) / 3]];
    const double width = slab.High - slab.Low;
    pull.Strength[point] *= strength * (slab.IsEnd ? ShareAtEnds : 1.0) / std::pow(width, 4.0);
    pull.Aim[point] =
      upwards[point] > 0.0 ? slab.Low + MeanPlace * width : slab.High - MeanPlace * width;
  }
  return pull;
}
}
