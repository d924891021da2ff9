// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SparseSolids.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace support
{
namespace
{
Solid MakeSolid(
  const std::string& name, int components, int genus, std::function<double(const Point3&)> function)
{
  Solid solid;
  solid.Name = name;
  solid.Low = { -1.25, -1.25, -1.25 };
  solid.High = { 1.25, 1.25, 1.25 };
  solid.Components = components;
  solid.Genus = genus;
  solid.Function = std::move(function);
  return solid;
}

std::string NameOf(const std::string& kind, double size)
{
  return kind + std::to_string(static_cast<int>(std::lround(100.0 * size)));
}

/// Distance from the middle of a wall whose outside is a level of `outer` at 0.
double WallOf(double outer, double wall) { return std::abs(outer + 0.5 * wall) - 0.5 * wall; }

double Radial(const Point3& p) { return std::hypot(p[0] - 0.02, p[1] + 0.01); }

double FromBall(const Point3& p, const Point3& center, double radius)
{
  return std::hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]) - radius;
}
}

Solid Pipe(double wall)
{
  return MakeSolid(NameOf("Pipe", wall), 1, 1,
    [=](const Point3& p)
    { return std::max(WallOf(Radial(p) - 1.0, wall), std::abs(p[2] - 0.01) - 1.0); });
}

Solid BallWithCavity(double wall)
{
  return MakeSolid(NameOf("BallWithCavity", wall), 2, 0,
    [=](const Point3& p) {
      return WallOf(FromBall(p, { 0.02, -0.01, 0.01 }, 1.0), wall);
    });
}

Solid OpenShell(double wall)
{
  return MakeSolid(NameOf("OpenShell", wall), 1, 0,
    [=](const Point3& p)
    {
      const double z = (p[2] - 0.2) / 1.2;
      return std::max(WallOf(std::hypot(p[0] - 0.02, p[1] + 0.01, z) - 1.0, wall), p[2] - 0.72);
    });
}

Solid Beaker(double wall)
{
  return MakeSolid(NameOf("Beaker", wall), 1, 0,
    [=](const Point3& p)
    {
      const double height = std::abs(p[2] - 0.01) - 1.0;
      const double inside = std::max(Radial(p) - 1.0 + wall, -0.99 + wall - p[2]);
      return std::max({ Radial(p) - 1.0, height, -inside });
    });
}

Solid TorusAround(int axis, double minor)
{
  Solid solid = MakeSolid(NameOf("Torus" + std::string(1, "XYZ"[axis]), minor), 1, 1, {});
  Point3 direction{ 0.02, 0.03, 0.01 };
  direction[axis] = 1.0;
  solid.Tubes = { Torus({ 0.02, -0.01, 0.01 }, direction, 1.0 - minor, minor) };
  return solid;
}

Solid TwoBalls(int axis, double gap)
{
  Solid solid = MakeSolid(NameOf("TwoBalls" + std::string(1, "XYZ"[axis]), gap), 2, 0, {});
  const double radius = 0.5 - 0.25 * gap;
  Point3 a{ 0.02, -0.01, 0.01 }, b = a;
  a[axis] -= radius + 0.5 * gap;
  b[axis] += radius + 0.5 * gap;
  solid.Tubes = { Ball(a, radius), Ball(b, radius) };
  return solid;
}

Solid PlainBall()
{
  Solid solid = MakeSolid("Ball", 1, 0, {});
  solid.Tubes = { Ball({ 0.02, -0.01, 0.01 }, 1.0) };
  return solid;
}

std::vector<Solid> AllSparseSolids()
{
  std::vector<Solid> solids{ PlainBall(), BranchingTube() };
  for (const double wall : { 0.5, 0.2, 0.08 })
  {
    for (const auto make : { Pipe, BallWithCavity, OpenShell, Beaker })
    {
      solids.push_back(make(wall));
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    solids.push_back(TorusAround(axis, 0.3));
    solids.push_back(TorusAround(axis, 0.15));
    solids.push_back(TwoBalls(axis, 0.3));
  }
  return solids;
}

PlaneSets FewPlanes(
  const Solid& solid, const std::array<int, 3>& count, const std::array<double, 3>& offset)
{
  PlaneSets planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = solid.Low[axis], width = solid.High[axis] - solid.Low[axis];
    for (int i = 0; i < count[axis]; ++i)
    {
      planes[axis].push_back(low + width * ((i + 0.5) / count[axis] + offset[axis]));
    }
  }
  return planes;
}

PieceSets SliceByFewPlanes(const Solid& solid, const PlaneSets& planes, InPlaneGrid grid, int cells)
{
  std::array<int, 3> subdivisions;
  for (int axis = 0; axis < 3; ++axis)
  {
    subdivisions[axis] = cells / (static_cast<int>(planes[axis].size()) + 1) + 1;
  }
  return SliceSolid(solid, planes, subdivisions, grid);
}

} // namespace support
} // namespace orthoslices
