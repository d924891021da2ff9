// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/OtherPlanes.h"

#include "Core/Frames/FindFamilies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// Sets the plane of least squares through its polylines.
void Fit(const Polylines& lines, OtherPlane& plane)
{
  Point3 center{};
  plane.Normal = FitPlane(MeasureScatter(lines, plane.Lines, center)).Normal;
  plane.Offset = Dot(plane.Normal, center);
}

/// How far points may be off their plane, in typical distances; see SnapPlanes.
constexpr double NoiseFactor = 6.0;

double NoiseOf(const PieceGroup& group, const PlaneNoise& noise)
{
  return std::max(noise.Tolerance, NoiseFactor * noise.Of(group));
}

/// Whether the points of a group are on a plane.
bool IsOn(const PieceGroup& group, const OtherPlane& plane, const PlaneNoise& noise)
{
  return noise.IsExplained(group, plane.Normal) &&
    std::abs(Dot(plane.Normal, group.Center) - plane.Offset) <= NoiseOf(group, noise);
}

/// Two unit vectors that make a right-handed frame with the normal of a plane.
std::array<Point3, 2> AxesWithin(const OtherPlane& plane)
{
  const Point3& n = plane.Normal;
  int least = 0;
  for (const int axis : { 1, 2 })
  {
    least = std::abs(n[axis]) < std::abs(n[least]) ? axis : least;
  }
  Point3 along{};
  along[least] = 1.0;
  const Point3 u = Unit(Cross(along, n));
  return { u, Cross(n, u) };
}
}

std::vector<OtherPlane> FindOtherPlanes(const Polylines& lines, double tolerance)
{
  const std::vector<PieceGroup> groups = GroupPieces(lines);
  const PlaneNoise noise = MeasureNoise(groups, tolerance);
  std::vector<Index> order(groups.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](Index a, Index b) { return groups[a].Weight() > groups[b].Weight(); });
  std::vector<OtherPlane> planes;
  for (const Index i : order)
  {
    const auto found = std::find_if(planes.begin(), planes.end(),
      [&](const OtherPlane& plane) { return IsOn(groups[i], plane, noise); });
    OtherPlane& plane = found == planes.end() ? planes.emplace_back() : *found;
    plane.Lines.insert(plane.Lines.end(), groups[i].Members.begin(), groups[i].Members.end());
    std::sort(plane.Lines.begin(), plane.Lines.end());
    plane.Noise = std::max(plane.Noise, NoiseOf(groups[i], noise));
    Fit(lines, plane);
  }
  std::sort(planes.begin(), planes.end(),
    [](const OtherPlane& a, const OtherPlane& b) { return a.Lines.front() < b.Lines.front(); });
  return planes;
}

Pieces LayOnPlane(const Polylines& lines, const OtherPlane& plane)
{
  const auto [u, v] = AxesWithin(plane);
  Pieces pieces;
  pieces.Axis = 2;
  for (const Index line : plane.Lines)
  {
    for (Index i = lines.Offsets[line]; i < lines.Offsets[line + 1]; ++i)
    {
      const Point3 p = lines.PointAt(i);
      const double height = Dot(plane.Normal, p);
      pieces.U.push_back(Dot(u, p));
      pieces.V.push_back(Dot(v, p));
      pieces.W.push_back(std::abs(height - plane.Offset) <= plane.Noise ? plane.Offset : height);
    }
    pieces.Offsets.push_back(static_cast<Index>(pieces.U.size()));
    pieces.Cell.push_back(line);
    pieces.Closed.push_back(lines.Closed[line]);
  }
  return pieces;
}

Point3 PointOn(const OtherPlane& plane, double u, double v)
{
  const auto [first, second] = AxesWithin(plane);
  return u * first + v * second + plane.Offset * plane.Normal;
}
}
