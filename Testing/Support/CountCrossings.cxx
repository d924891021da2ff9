// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CheckSurface.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace orthoslices
{
namespace support
{
namespace
{
/// Side of d against the plane of a, b, c: 1, -1, or 0 if rounding leaves it open.
int SideOf(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  double m[3][3];
  for (int i = 0; i < 3; ++i)
  {
    m[0][i] = a[i] - d[i];
    m[1][i] = b[i] - d[i];
    m[2][i] = c[i] - d[i];
  }
  double value = 0.0, size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double p = m[0][i] * m[1][j] * m[2][k], q = m[0][i] * m[1][k] * m[2][j];
    value += p - q;
    size += std::abs(p) + std::abs(q);
  }
  const double bound = 1e-15 * size;
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

/// Whether the segment pq certainly passes through the inside of the triangle.
bool Pierces(const Point3& p, const Point3& q, const std::array<Point3, 3>& t)
{
  if (SideOf(t[0], t[1], t[2], p) * SideOf(t[0], t[1], t[2], q) >= 0)
  {
    return false;
  }
  const int side = SideOf(p, q, t[0], t[1]);
  return side != 0 && SideOf(p, q, t[1], t[2]) == side && SideOf(p, q, t[2], t[0]) == side;
}

class CrossingCounter
{
public:
  explicit CrossingCounter(const TriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  std::int64_t Run();

private:
  using Ids = std::array<std::int64_t, 3>;

  std::array<Point3, 3> Corners(const Ids& ids) const
  {
    return { this->Mesh.Points[ids[0]], this->Mesh.Points[ids[1]], this->Mesh.Points[ids[2]] };
  }
  /// A side of `a` without a corner of `b` passes through `b`.
  bool SidePierces(const Ids& a, const Ids& b) const;
  bool Cross(std::int64_t a, std::int64_t b) const;
  double Low(std::int64_t t, int axis) const;
  double High(std::int64_t t, int axis) const;

  const TriangleMesh& Mesh;
};

bool CrossingCounter::SidePierces(const Ids& a, const Ids& b) const
{
  const auto isCorner = [&](std::int64_t id) { return std::count(b.begin(), b.end(), id) > 0; };
  for (int i = 0; i < 3; ++i)
  {
    const std::int64_t p = a[i], q = a[(i + 1) % 3];
    if (!isCorner(p) && !isCorner(q) &&
      Pierces(this->Mesh.Points[p], this->Mesh.Points[q], this->Corners(b)))
    {
      return true;
    }
  }
  return false;
}

bool CrossingCounter::Cross(std::int64_t a, std::int64_t b) const
{
  const Ids &s = this->Mesh.Triangles[a], &t = this->Mesh.Triangles[b];
  return this->SidePierces(s, t) || this->SidePierces(t, s);
}

double CrossingCounter::Low(std::int64_t t, int axis) const
{
  const auto c = this->Corners(this->Mesh.Triangles[t]);
  return std::min({ c[0][axis], c[1][axis], c[2][axis] });
}

double CrossingCounter::High(std::int64_t t, int axis) const
{
  const auto c = this->Corners(this->Mesh.Triangles[t]);
  return std::max({ c[0][axis], c[1][axis], c[2][axis] });
}

/// Sweeps along x: the triangles whose range of x has begun and not ended, ordered by their low y.
std::int64_t CrossingCounter::Run()
{
  const auto count = static_cast<std::int64_t>(this->Mesh.Triangles.size());
  std::vector<std::array<double, 6>> boxes;
  double longest = 0.0; // range of y
  for (std::int64_t t = 0; t < count; ++t)
  {
    boxes.push_back({ this->Low(t, 0), this->High(t, 0), this->Low(t, 1), this->High(t, 1),
      this->Low(t, 2), this->High(t, 2) });
    longest = std::max(longest, boxes[t][3] - boxes[t][2]);
  }
  std::vector<std::pair<double, std::int64_t>> begins, ends;
  for (std::int64_t t = 0; t < count; ++t)
  {
    begins.emplace_back(boxes[t][0], t);
    ends.emplace_back(boxes[t][1], t);
  }
  std::sort(begins.begin(), begins.end());
  std::sort(ends.begin(), ends.end());
  std::set<std::pair<double, std::int64_t>> active;
  std::int64_t crossings = 0;
  std::size_t end = 0;
  for (const auto& begin : begins)
  {
    for (; ends[end].first < begin.first; ++end)
    {
      active.erase({ boxes[ends[end].second][2], ends[end].second });
    }
    const auto& box = boxes[begin.second];
    for (auto at = active.lower_bound({ box[2] - longest, -1 });
         at != active.end() && at->first <= box[3]; ++at)
    {
      const auto& other = boxes[at->second];
      const bool overlap = other[3] >= box[2] && other[4] <= box[5] && box[4] <= other[5];
      crossings += overlap && this->Cross(begin.second, at->second) ? 1 : 0;
    }
    active.insert({ box[2], begin.second });
  }
  return crossings;
}
}

std::int64_t CountCrossings(const TriangleMesh& mesh) { return CrossingCounter(mesh).Run(); }

} // namespace support
} // namespace orthoslices
