// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceSurface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// Contours pass this far below a vertex that lies on the plane (above one that lies just under
/// it), as a fraction of the largest coordinate: a few units in the last place of what is stored.
constexpr double kDepth[] = { 0x1p-22, 0x1p-40 };

/// On edges inclined less than this against the plane the depth counts as if they were inclined
/// this much, which bounds how far a vertex is moved: to kDepth / kFlatness.
constexpr double kFlatness[] = { 1.0, 0x1p-7 };

/// Side of a triangle, filed under its end with the smaller id.
struct Side
{
  Index Far; ///< the end with the larger id
  Index Triangle;
  std::uint8_t Number; ///< 0, 1, 2
  bool Ascends;        ///< whether the triangle passes it from the smaller id to the larger

  bool operator<(const Side& other) const
  {
    return this->Far != other.Far ? this->Far < other.Far : this->Triangle < other.Triangle;
  }
};

constexpr int Next(int number) { return number == 2 ? 0 : number + 1; }

//----------------------------------------------------------------------------
/// Finds the neighbours of all triangles, edge by edge.
class NeighborLinker
{
public:
  explicit NeighborLinker(TriangleSurface& surface)
    : Surface(surface)
  {
  }

  SurfaceProblem Run();

private:
  void FileSides();
  SurfaceProblemKind LinkEdge(const Side* first, const Side* last);

  TriangleSurface& Surface;
  std::vector<std::size_t> Offsets;
  std::vector<Side> Sides;
};

SurfaceProblem NeighborLinker::Run()
{
  this->FileSides();
  this->Surface.Neighbors.assign(this->Surface.Triangles.size(), { -1, -1, -1 });
  for (std::size_t near = 0; near + 1 < this->Offsets.size(); ++near)
  {
    Side* const end = this->Sides.data() + this->Offsets[near + 1];
    Side* first = this->Sides.data() + this->Offsets[near];
    std::sort(first, end);
    while (first != end)
    {
      Side* const last =
        std::find_if(first, end, [first](const Side& side) { return side.Far != first->Far; });
      const SurfaceProblemKind kind = this->LinkEdge(first, last);
      if (kind != SurfaceProblemKind::None)
      {
        return { kind, this->Surface.Points[near], this->Surface.Points[first->Far] };
      }
      first = last;
    }
  }
  return {};
}

/// Counting sort of all sides by their end with the smaller id.
void NeighborLinker::FileSides()
{
  const auto& triangles = this->Surface.Triangles;
  this->Offsets.assign(this->Surface.Points.size() + 2, 0);
  for (const auto& triangle : triangles)
  {
    for (int s = 0; s < 3; ++s)
    {
      ++this->Offsets[std::min(triangle[s], triangle[Next(s)]) + 2];
    }
  }
  std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
  this->Sides.resize(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int s = 0; s < 3; ++s)
    {
      const Index from = triangles[t][s];
      const Index to = triangles[t][Next(s)];
      this->Sides[this->Offsets[std::min(from, to) + 1]++] = { std::max(from, to),
        static_cast<Index>(t), static_cast<std::uint8_t>(s), from < to };
    }
  }
  this->Offsets.pop_back();
}

SurfaceProblemKind NeighborLinker::LinkEdge(const Side* first, const Side* last)
{
  if (last - first != 2)
  {
    return last - first == 1 ? SurfaceProblemKind::OpenEdge : SurfaceProblemKind::OverusedEdge;
  }
  if (first[0].Ascends == first[1].Ascends)
  {
    return SurfaceProblemKind::InconsistentEdge;
  }
  this->Surface.Neighbors[first[0].Triangle][first[0].Number] = first[1].Triangle;
  this->Surface.Neighbors[first[1].Triangle][first[1].Number] = first[0].Triangle;
  return SurfaceProblemKind::None;
}

//----------------------------------------------------------------------------
SurfaceProblem FindNotFinite(const TriangleSurface& surface)
{
  for (const auto& triangle : surface.Triangles)
  {
    for (const Index vertex : triangle)
    {
      const Point3& p = surface.Points[vertex];
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      {
        return { SurfaceProblemKind::NotFinite, p, p };
      }
    }
  }
  return {};
}

void DropCollapsedTriangles(TriangleSurface& surface)
{
  auto& triangles = surface.Triangles;
  triangles.erase(
    std::remove_if(triangles.begin(), triangles.end(),
      [](const std::array<Index, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
    triangles.end());
}

/// Lets all triangles refer to the first of several points with identical coordinates.
void JoinIdenticalPoints(TriangleSurface& surface)
{
  const auto& points = surface.Points;
  std::vector<Index> order;
  order.reserve(3 * surface.Triangles.size());
  for (const auto& triangle : surface.Triangles)
  {
    order.insert(order.end(), triangle.begin(), triangle.end());
  }
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::sort(order.begin(), order.end(),
    [&points](Index a, Index b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });

  std::vector<Index> leader(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool repeats = i > 0 && points[order[i]] == points[order[i - 1]];
    leader[order[i]] = repeats ? leader[order[i - 1]] : order[i];
  }
  for (auto& triangle : surface.Triangles)
  {
    std::transform(triangle.begin(), triangle.end(), triangle.begin(),
      [&leader](Index vertex) { return leader[vertex]; });
  }
}

void ReverseTriangles(TriangleSurface& surface)
{
  for (auto& triangle : surface.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  for (auto& neighbors : surface.Neighbors)
  {
    std::swap(neighbors[0], neighbors[2]);
  }
}
}

//----------------------------------------------------------------------------
SurfaceProblem CloseSurface(TriangleSurface& surface)
{
  SurfaceProblem problem = FindNotFinite(surface);
  if (problem.Kind != SurfaceProblemKind::None)
  {
    return problem;
  }
  DropCollapsedTriangles(surface);
  problem = NeighborLinker(surface).Run();
  if (problem.Kind != SurfaceProblemKind::None)
  {
    JoinIdenticalPoints(surface);
    DropCollapsedTriangles(surface);
    problem = NeighborLinker(surface).Run();
  }
  if (problem.Kind == SurfaceProblemKind::None && SixfoldVolume(surface) < 0.0)
  {
    ReverseTriangles(surface);
  }
  return problem;
}

double SixfoldVolume(const TriangleSurface& surface)
{
  if (surface.Triangles.empty())
  {
    return 0.0;
  }
  // Relative to a point of the surface, so that a large offset does not cancel digits.
  const Point3 origin = surface.Points[surface.Triangles[0][0]];
  const auto relative = [&surface, &origin](Index vertex) -> Point3
  {
    const Point3& p = surface.Points[vertex];
    return { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] };
  };
  double sum = 0.0;
  for (const auto& triangle : surface.Triangles)
  {
    const Point3 a = relative(triangle[0]);
    const Point3 b = relative(triangle[1]);
    const Point3 c = relative(triangle[2]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

//----------------------------------------------------------------------------
namespace
{
/// Cuts one surface on the planes of one axis.
class SurfaceSlicer
{
public:
  SurfaceSlicer(const TriangleSurface& surface, int axis, const std::vector<double>& planes,
    Precision precision);

  std::vector<PlaneContours> Run(const Execution& execution);

private:
  void RankPoints();
  std::array<Index, 2> CrossedPlanes(std::size_t triangle) const;
  void FileTriangles();
  void Trace(Index plane, std::vector<Index>& visited, PlaneContours& contours) const;
  int UpwardSide(Index triangle, Index plane) const;
  void AddCrossing(Index triangle, int side, double height, PlaneContours& contours) const;
  double Fraction(const Point3& below, const Point3& above, double height) const;

  const TriangleSurface& Surface;
  const int Axis;
  const std::vector<double>& Planes;
  const Precision Stored;
  double Depth = 0.0;
  double Flatness = 0.0;
  std::vector<Index> Rank;          ///< of each point: how many planes it is above
  std::vector<std::size_t> Offsets; ///< of each plane into Crossed
  std::vector<Index> Crossed;       ///< the triangles that each plane crosses, ascending
};

SurfaceSlicer::SurfaceSlicer(
  const TriangleSurface& surface, int axis, const std::vector<double>& planes, Precision precision)
  : Surface(surface)
  , Axis(axis)
  , Planes(planes)
  , Stored(precision)
{
  double largest = 0.0;
  for (const auto& triangle : surface.Triangles)
  {
    for (const Index vertex : triangle)
    {
      for (const double x : surface.Points[vertex])
      {
        largest = std::max(largest, std::abs(x));
      }
    }
  }
  this->Depth = kDepth[static_cast<int>(precision)] * largest;
  this->Flatness = kFlatness[static_cast<int>(precision)];
}

void SurfaceSlicer::RankPoints()
{
  this->Rank.resize(this->Surface.Points.size());
  std::transform(this->Surface.Points.begin(), this->Surface.Points.end(), this->Rank.begin(),
    [this](const Point3& point)
    {
      const auto above =
        std::upper_bound(this->Planes.begin(), this->Planes.end(), point[this->Axis]);
      return static_cast<Index>(above - this->Planes.begin());
    });
}

/// First and last + 1 of the planes that separate the triangle's vertices.
std::array<Index, 2> SurfaceSlicer::CrossedPlanes(std::size_t triangle) const
{
  const auto& vertices = this->Surface.Triangles[triangle];
  const auto range =
    std::minmax({ this->Rank[vertices[0]], this->Rank[vertices[1]], this->Rank[vertices[2]] });
  return { range.first, range.second };
}

/// Counting sort of the crossed triangles by plane.
void SurfaceSlicer::FileTriangles()
{
  this->Offsets.assign(this->Planes.size() + 2, 0);
  const std::size_t count = this->Surface.Triangles.size();
  for (std::size_t t = 0; t < count; ++t)
  {
    const auto planes = this->CrossedPlanes(t);
    for (Index plane = planes[0]; plane < planes[1]; ++plane)
    {
      ++this->Offsets[plane + 2];
    }
  }
  std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
  this->Crossed.resize(this->Offsets.back());
  for (std::size_t t = 0; t < count; ++t)
  {
    const auto planes = this->CrossedPlanes(t);
    for (Index plane = planes[0]; plane < planes[1]; ++plane)
    {
      this->Crossed[this->Offsets[plane + 1]++] = static_cast<Index>(t);
    }
  }
  this->Offsets.pop_back();
}

std::vector<PlaneContours> SurfaceSlicer::Run(const Execution& execution)
{
  std::vector<PlaneContours> contours(this->Planes.size());
  this->RankPoints();
  this->FileTriangles();
  execution.For(contours.size(),
    [this, &contours](std::size_t begin, std::size_t end)
    {
      std::vector<Index> visited(this->Surface.Triangles.size(), -1); // last plane that passed
      for (std::size_t plane = begin; plane < end; ++plane)
      {
        this->Trace(static_cast<Index>(plane), visited, contours[plane]);
      }
    });
  return contours;
}

/// Follows every cycle of crossed triangles, each from its triangle with the smallest id.
void SurfaceSlicer::Trace(Index plane, std::vector<Index>& visited, PlaneContours& contours) const
{
  const double height = this->Planes[plane];
  for (std::size_t i = this->Offsets[plane]; i < this->Offsets[plane + 1]; ++i)
  {
    const Index first = this->Crossed[i];
    if (visited[first] == plane)
    {
      continue;
    }
    Index triangle = first;
    do
    {
      visited[triangle] = plane;
      const int side = this->UpwardSide(triangle, plane);
      this->AddCrossing(triangle, side, height, contours);
      triangle = this->Surface.Neighbors[triangle][side];
    } while (triangle != first);
    contours.CloseContour();
  }
}

/// The side whose first vertex is below the plane and whose second is above.
int SurfaceSlicer::UpwardSide(Index triangle, Index plane) const
{
  const auto& vertices = this->Surface.Triangles[triangle];
  const bool above[] = { this->Rank[vertices[0]] > plane, this->Rank[vertices[1]] > plane,
    this->Rank[vertices[2]] > plane };
  return !above[0] && above[1] ? 0 : !above[1] && above[2] ? 1 : 2;
}

void SurfaceSlicer::AddCrossing(
  Index triangle, int side, double height, PlaneContours& contours) const
{
  const auto& vertices = this->Surface.Triangles[triangle];
  const Point3& below = this->Surface.Points[vertices[side]];
  const Point3& above = this->Surface.Points[vertices[Next(side)]];
  const double t = this->Fraction(below, above, height);
  const int u = FirstAxis(this->Axis);
  const int v = SecondAxis(this->Axis);
  const double x = RoundTo(this->Stored, below[u] + t * (above[u] - below[u]));
  const double y = RoundTo(this->Stored, below[v] + t * (above[v] - below[v]));
  if (this->Surface.NamesEdges)
  {
    contours.AddVertex(x, y, { vertices[side], vertices[Next(side)], t });
  }
  else
  {
    contours.AddVertex(x, y);
  }
}

/// Where on the edge the plane crosses it, kept away from both ends.
double SurfaceSlicer::Fraction(const Point3& below, const Point3& above, double height) const
{
  const double du = above[FirstAxis(this->Axis)] - below[FirstAxis(this->Axis)];
  const double dv = above[SecondAxis(this->Axis)] - below[SecondAxis(this->Axis)];
  const double dw = above[this->Axis] - below[this->Axis];
  const double rise = std::max(dw, this->Flatness * std::sqrt(du * du + dv * dv));
  const double margin = std::min(0.5, this->Depth / rise);
  return std::max(margin, std::min(1.0 - margin, (height - below[this->Axis]) / dw));
}
}

std::vector<PlaneContours> SliceSurface(const TriangleSurface& surface, int axis,
  const std::vector<double>& planes, Precision precision, const Execution& execution)
{
  return SurfaceSlicer(surface, axis, planes, precision).Run(execution);
}
}
