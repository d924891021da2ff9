// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CheckSurface.h"

#include "Support/Random.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

namespace orthoslices
{
namespace support
{
namespace
{
/// One side of a triangle, with its ends in ascending order.
struct Side
{
  std::int64_t Low, High;
  std::int64_t Triangle;
  bool Forward; ///< the triangle runs from Low to High

  bool SameEdge(const Side& other) const { return Low == other.Low && High == other.High; }
};

std::vector<Side> SortedSides(const TriangleMesh& mesh)
{
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::int64_t from = mesh.Triangles[t][corner];
      const std::int64_t to = mesh.Triangles[t][(corner + 1) % 3];
      sides.push_back(
        { std::min(from, to), std::max(from, to), static_cast<std::int64_t>(t), from < to });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    {
      return a.Low != b.Low ? a.Low < b.Low
        : a.High != b.High  ? a.High < b.High
                            : a.Triangle < b.Triangle;
    });
  return sides;
}

class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parent(count)
  {
    std::iota(Parent.begin(), Parent.end(), 0);
  }

  std::int64_t Find(std::int64_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }

  void Unite(std::int64_t a, std::int64_t b) { this->Parent[this->Find(a)] = this->Find(b); }

private:
  std::vector<std::int64_t> Parent;
};

bool IsDegenerate(const std::array<std::int64_t, 3>& t, std::int64_t points)
{
  const bool range =
    *std::min_element(t.begin(), t.end()) >= 0 && *std::max_element(t.begin(), t.end()) < points;
  return !range || t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Counts edges by their number of triangles, and joins the triangles of each edge.
std::int64_t CheckEdges(const std::vector<Side>& sides, SurfaceCheck& check, DisjointSets& joined)
{
  std::int64_t edges = 0;
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].SameEdge(sides[i]))
    {
      joined.Unite(sides[end].Triangle, sides[i].Triangle);
      ++end;
    }
    ++edges;
    check.OpenEdges += end - i == 1 ? 1 : 0;
    check.CrowdedEdges += end - i > 2 ? 1 : 0;
    check.InconsistentEdges += end - i == 2 && sides[i].Forward == sides[i + 1].Forward ? 1 : 0;
    i = end;
  }
  return edges;
}

/// The corners of triangles (3 t + corner) that meet at a point, joined across common edges.
void CheckVertices(const TriangleMesh& mesh, const std::vector<Side>& sides, SurfaceCheck& check)
{
  DisjointSets corners(3 * mesh.Triangles.size());
  const auto cornerAt = [&](std::int64_t triangle, std::int64_t point)
  {
    const auto& t = mesh.Triangles[triangle];
    return 3 * triangle + (std::find(t.begin(), t.end(), point) - t.begin());
  };
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    if (sides[i].SameEdge(sides[i - 1]))
    {
      for (const std::int64_t end : { sides[i].Low, sides[i].High })
      {
        corners.Unite(cornerAt(sides[i].Triangle, end), cornerAt(sides[i - 1].Triangle, end));
      }
    }
  }
  std::vector<std::int64_t> fans(mesh.Points.size(), 0);
  for (std::size_t corner = 0; corner < 3 * mesh.Triangles.size(); ++corner)
  {
    const auto c = static_cast<std::int64_t>(corner);
    fans[mesh.Triangles[corner / 3][corner % 3]] += corners.Find(c) == c ? 1 : 0;
  }
  check.UnusedPoints = std::count(fans.begin(), fans.end(), 0);
  check.NonManifoldVertices =
    std::count_if(fans.begin(), fans.end(), [](std::int64_t n) { return n > 1; });
}

void NumberComponents(const TriangleMesh& mesh, DisjointSets& joined, SurfaceCheck& check)
{
  std::vector<std::int64_t> number(mesh.Triangles.size(), -1);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    std::int64_t& n = number[joined.Find(static_cast<std::int64_t>(t))];
    n = n < 0 ? check.Components++ : n;
    check.Component.push_back(n);
  }
}

double Determinant(const Point3& a, const Point3& b, const Point3& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Point3 Minus(const Point3& a, const Point3& b) { return { a[0] - b[0], a[1] - b[1], a[2] - b[2] }; }

double Norm(const Point3& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

double Dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Genus and volume of each component of a closed manifold.
void MeasureComponents(
  const TriangleMesh& mesh, const std::vector<Side>& sides, SurfaceCheck& check)
{
  std::vector<std::int64_t> euler(check.Components, 0);
  check.Volume.assign(check.Components, 0.0);
  std::vector<std::uint8_t> seen(mesh.Points.size(), 0);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const std::int64_t component = check.Component[t];
    ++euler[component];
    const auto& ids = mesh.Triangles[t];
    const Point3& origin = mesh.Points[mesh.Triangles[0][0]];
    check.Volume[component] +=
      Determinant(Minus(mesh.Points[ids[0]], origin), Minus(mesh.Points[ids[1]], origin),
        Minus(mesh.Points[ids[2]], origin)) /
      6.0;
    for (const std::int64_t id : ids)
    {
      euler[component] += seen[id] ? 0 : 1;
      seen[id] = 1;
    }
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const bool newEdge = i == 0 || !sides[i].SameEdge(sides[i - 1]);
    euler[check.Component[sides[i].Triangle]] -= newEdge ? 1 : 0;
  }
  for (const std::int64_t characteristic : euler)
  {
    check.Genus.push_back((2 - characteristic) / 2);
  }
}
}

std::int64_t SurfaceCheck::TotalGenus() const
{
  return std::accumulate(this->Genus.begin(), this->Genus.end(), std::int64_t(0));
}

double SurfaceCheck::TotalVolume() const
{
  return std::accumulate(this->Volume.begin(), this->Volume.end(), 0.0);
}

SurfaceCheck CheckSurface(const TriangleMesh& mesh)
{
  SurfaceCheck check;
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  check.DegenerateTriangles = std::count_if(mesh.Triangles.begin(), mesh.Triangles.end(),
    [&](const auto& t) { return IsDegenerate(t, points); });
  if (check.DegenerateTriangles > 0)
  {
    return check;
  }
  const std::vector<Side> sides = SortedSides(mesh);
  DisjointSets joined(mesh.Triangles.size());
  const std::int64_t edges = CheckEdges(sides, check, joined);
  CheckVertices(mesh, sides, check);
  NumberComponents(mesh, joined, check);
  check.Euler =
    points - check.UnusedPoints - edges + static_cast<std::int64_t>(mesh.Triangles.size());
  if (check.IsClosedManifold())
  {
    MeasureComponents(mesh, sides, check);
  }
  return check;
}

std::ostream& operator<<(std::ostream& os, const SurfaceCheck& check)
{
  return os << check.OpenEdges << " open, " << check.CrowdedEdges << " crowded, "
            << check.InconsistentEdges << " inconsistent edges, " << check.NonManifoldVertices
            << " non-manifold vertices, " << check.DegenerateTriangles << " degenerate triangles, "
            << check.UnusedPoints << " unused points, " << check.Components
            << " components, total genus " << check.TotalGenus() << ", volume "
            << check.TotalVolume();
}

double WindingNumber(const TriangleMesh& mesh, const Point3& point)
{
  constexpr double pi = 3.14159265358979323846;
  double angle = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    const Point3 a = Minus(mesh.Points[t[0]], point);
    const Point3 b = Minus(mesh.Points[t[1]], point);
    const Point3 c = Minus(mesh.Points[t[2]], point);
    const double la = Norm(a), lb = Norm(b), lc = Norm(c);
    // Van Oosterom and Strackee's formula for the solid angle of a triangle.
    angle += 2.0 *
      std::atan2(
        Determinant(a, b, c), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
  }
  return angle / (4.0 * pi);
}

std::vector<Point3> FindMissingVertices(
  const Contours& contours, const TriangleMesh& mesh, double tolerance)
{
  std::vector<Point3> sorted = mesh.Points;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Point3> missing;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      const Point3 p = contours.World(contour, i);
      auto at = std::lower_bound(
        sorted.begin(), sorted.end(), Point3{ p[0] - tolerance, -HUGE_VAL, -HUGE_VAL });
      bool found = false;
      for (; !found && at != sorted.end() && (*at)[0] <= p[0] + tolerance; ++at)
      {
        found = std::abs((*at)[1] - p[1]) <= tolerance && std::abs((*at)[2] - p[2]) <= tolerance;
      }
      if (!found)
      {
        missing.push_back(p);
      }
    }
  }
  return missing;
}

namespace
{
/// How often the contours of one slice wind around a point of it.
int WindingInSlice(const Contours& contours, int axis, Index plane, double u, double v)
{
  int winding = 0;
  for (Index c = 0; c < contours.Count(); ++c)
  {
    if (contours.Axis[c] != axis || contours.Plane[c] != plane)
    {
      continue;
    }
    const Index begin = contours.Offsets[c], end = contours.Offsets[c + 1];
    for (Index i = begin; i < end; ++i)
    {
      const Index j = i + 1 < end ? i + 1 : begin;
      const double v0 = contours.V[i], v1 = contours.V[j];
      if ((v0 > v) != (v1 > v))
      {
        const double u0 = contours.U[i], u1 = contours.U[j];
        const bool right = u0 + (v - v0) / (v1 - v0) * (u1 - u0) > u;
        winding += right ? (v1 > v0 ? 1 : -1) : 0;
      }
    }
  }
  return winding;
}

/// Sum of the areas of all contours, negative for those that run clockwise.
double SignedArea(const Contours& contours)
{
  double area = 0.0;
  for (Index c = 0; c < contours.Count(); ++c)
  {
    const Index begin = contours.Offsets[c], end = contours.Offsets[c + 1];
    for (Index i = begin; i < end; ++i)
    {
      const Index j = i + 1 < end ? i + 1 : begin;
      area += 0.5 * (contours.U[j] - contours.U[i]) *
        (2.0 * contours.V[begin] - contours.V[i] - contours.V[j]);
    }
  }
  return area;
}

/// The label that two of the three slices have, or 0 or 1 if it is below or above.
int VoteOfSlices(
  const Contours& contours, const SpatialGrid& grid, int background, const std::array<Index, 3>& at)
{
  std::array<int, 3> votes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = FirstAxis(axis), v = SecondAxis(axis);
    votes[axis] = background +
      WindingInSlice(contours, axis, at[axis], grid.Planes[u][at[u]], grid.Planes[v][at[v]]);
  }
  std::sort(votes.begin(), votes.end());
  return std::clamp(votes[1], 0, 1);
}
}

SideCheck CheckGridVertices(const TriangleMesh& mesh, const Contours& contours,
  const SpatialGrid& grid, Orientation orientation, std::size_t maximum, std::uint64_t seed)
{
  const int background = orientation == Orientation::AsDrawn && SignedArea(contours) < 0.0 ? 1 : 0;
  SideCheck check;
  Random random(seed);
  const std::size_t all = grid.Planes[0].size() * grid.Planes[1].size() * grid.Planes[2].size();
  for (std::size_t i = 0; i < std::min(all, maximum); ++i)
  {
    std::size_t number = all <= maximum ? i : random.Below(all);
    std::array<Index, 3> at;
    Point3 point;
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = static_cast<Index>(number % grid.Planes[axis].size());
      number /= grid.Planes[axis].size();
      point[axis] = grid.Planes[axis][at[axis]];
    }
    const double winding = background + WindingNumber(mesh, point);
    if (!(std::abs(winding - std::round(winding)) < 1e-6))
    {
      ++check.Skipped;
      continue;
    }
    ++check.Compared;
    if (std::lround(winding) != VoteOfSlices(contours, grid, background, at))
    {
      check.Wrong.push_back(point);
    }
  }
  return check;
}

} // namespace support
} // namespace orthoslices
