// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CheckPatch.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace orthoslices
{
namespace support
{
namespace
{
using Side = std::pair<Index, Index>;

/// The sides of the borders, as places on them one after another.
std::set<Side> SidesOfBorders(const CycleGeometry& geometry, const PatchMesh& patch)
{
  std::set<Side> sides;
  Index first = 0;
  for (const Index cycle : patch.Cycles)
  {
    const auto count = static_cast<Index>(geometry.GetBorders({ cycle }).size());
    for (Index i = 0; i < count; ++i)
    {
      sides.insert({ first + i, first + (i + 1) % count });
    }
    first += count;
  }
  return sides;
}

/// Whether all triangles are connected through sides.
bool IsConnected(const PatchMesh& patch)
{
  std::map<Side, std::size_t> triangleAt;
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      triangleAt[{ patch.Triangles[t][i], patch.Triangles[t][(i + 1) % 3] }] = t;
    }
  }
  std::vector<std::uint8_t> reached(patch.Triangles.size(), 0);
  std::vector<std::size_t> front(1, 0);
  reached[0] = 1;
  while (!front.empty())
  {
    const auto triangle = patch.Triangles[front.back()];
    front.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const auto other = triangleAt.find({ triangle[(i + 1) % 3], triangle[i] });
      if (other != triangleAt.end() && !reached[other->second])
      {
        reached[other->second] = 1;
        front.push_back(other->second);
      }
    }
  }
  return std::all_of(reached.begin(), reached.end(), [](std::uint8_t r) { return r != 0; });
}
}

std::string DescribePatchFlaws(const CycleGeometry& geometry, const PatchMesh& patch)
{
  std::ostringstream flaws;
  if (patch.Triangles.empty() || patch.Cycles.empty())
  {
    return "no triangles";
  }
  if (!std::is_sorted(patch.Cycles.begin(), patch.Cycles.end()))
  {
    flaws << "cycles do not ascend\n";
  }
  std::map<Side, int> sides;
  std::set<Index> corners;
  for (const auto& t : patch.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++sides[{ t[i], t[(i + 1) % 3] }];
      corners.insert(t[i]);
    }
  }
  std::set<Side> open;
  for (const auto& side : sides)
  {
    if (side.second != 1)
    {
      flaws << "side " << side.first.first << " " << side.first.second << " is passed "
            << side.second << " times\n";
    }
    if (sides.count({ side.first.second, side.first.first }) == 0)
    {
      open.insert(side.first);
    }
  }
  const std::set<Side> borders = SidesOfBorders(geometry, patch);
  if (open != borders)
  {
    flaws << open.size() << " open sides are not the " << borders.size() << " of the borders\n";
  }
  if (corners.size() != borders.size() + patch.Points.size() ||
    *corners.begin() != -static_cast<Index>(patch.Points.size()))
  {
    flaws << "points that are not in use\n";
  }
  // A sphere with one hole for each cycle.
  const auto edges = static_cast<std::int64_t>((sides.size() + open.size()) / 2);
  const std::int64_t euler = static_cast<std::int64_t>(corners.size()) - edges +
    static_cast<std::int64_t>(patch.Triangles.size());
  if (euler != 2 - static_cast<std::int64_t>(patch.Cycles.size()))
  {
    flaws << "Euler characteristic " << euler << " with " << patch.Cycles.size() << " cycles\n";
  }
  if (!IsConnected(patch))
  {
    flaws << "not connected\n";
  }
  const auto& cell = geometry.Cycles.Cell[patch.Cycles.front()];
  for (const Index cycle : patch.Cycles)
  {
    flaws << (geometry.Cycles.Cell[cycle] == cell ? "" : "cycles of several cells\n");
  }
  for (const Point3& p : patch.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!geometry.Grid.IsInside(axis, cell[axis], p[axis]))
      {
        flaws << "a point is not inside the cell\n";
      }
    }
  }
  return flaws.str();
}

TriangleMesh MeshOf(const CycleGeometry& geometry, const PatchMesh& patch)
{
  const std::vector<Index> borders = geometry.GetBorders(patch.Cycles);
  TriangleMesh mesh;
  for (const Index point : borders)
  {
    mesh.Points.push_back(geometry.Graph.PointAt(point));
  }
  mesh.Points.insert(mesh.Points.end(), patch.Points.begin(), patch.Points.end());
  for (const auto& t : patch.Triangles)
  {
    std::array<std::int64_t, 3> ids;
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = t[i] >= 0 ? t[i] : static_cast<std::int64_t>(borders.size()) - 1 - t[i];
    }
    mesh.Triangles.push_back(ids);
  }
  return mesh;
}

} // namespace support
} // namespace orthoslices
