// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/SliceSolid.h"

#include "Support/Random.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace support
{
namespace
{
/// Where the surface meets the line through p along `axis`, between two places on different sides.
double FindRoot(const Solid& solid, Point3 p, int axis, double low, double high)
{
  p[axis] = low;
  const bool lowInside = solid.Value(p) < 0.0;
  double x = 0.5 * (low + high);
  for (int i = 0; i < 60 && low < high; ++i)
  {
    p[axis] = x;
    const double value = solid.Value(p);
    ((value < 0.0) == lowInside ? low : high) = x;
    const double slope = solid.Gradient(p)[axis];
    double next = slope != 0.0 ? x - value / slope : low;
    if (!(next > low && next < high))
    {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - x) <= 1e-15)
    {
      return next;
    }
    x = next;
  }
  return x;
}

/// Marching squares on one plane.
class PlaneTracer
{
public:
  PlaneTracer(const Solid& solid, int axis, double plane, const std::vector<double>& us,
    const std::vector<double>& vs)
    : Shape(solid)
    , Axis(axis)
    , Plane(plane)
    , U(us)
    , V(vs)
    , Columns(us.size())
  {
  }

  void Run(Pieces& pieces);

private:
  /// Grid edges are numbered 2 (row * columns + column), plus 1 if they run along v.
  using Edge = std::size_t;

  Point3 At(double u, double v) const
  {
    Point3 p;
    p[this->Axis] = this->Plane;
    p[FirstAxis(this->Axis)] = u;
    p[SecondAxis(this->Axis)] = v;
    return p;
  }
  bool IsInside(std::size_t i, std::size_t j) const
  {
    return this->Inside[j * this->Columns + i] != 0;
  }
  void Classify();
  void LinkCell(std::size_t i, std::size_t j);
  std::array<double, 2> VertexOn(Edge edge) const;

  const Solid& Shape;
  int Axis;
  double Plane;
  const std::vector<double>& U;
  const std::vector<double>& V;
  std::size_t Columns;
  std::vector<std::uint8_t> Inside;
  std::vector<std::int64_t> Next; ///< edge on which the contour goes on, or -1
};

void PlaneTracer::Classify()
{
  this->Inside.resize(this->Columns * this->V.size());
  for (std::size_t j = 0; j < this->V.size(); ++j)
  {
    for (std::size_t i = 0; i < this->Columns; ++i)
    {
      this->Inside[j * this->Columns + i] =
        this->Shape.Value(this->At(this->U[i], this->V[j])) < 0.0 ? 1 : 0;
    }
  }
}

/// Around the cell, counter-clockwise: a contour begins where the interior ends.
void PlaneTracer::LinkCell(std::size_t i, std::size_t j)
{
  const bool corner[4] = { this->IsInside(i, j), this->IsInside(i + 1, j),
    this->IsInside(i + 1, j + 1), this->IsInside(i, j + 1) };
  const Edge base = 2 * (j * this->Columns + i);
  const Edge edges[4] = { base, base + 3, base + 2 * this->Columns, base + 1 };
  const bool saddle = corner[0] == corner[2] && corner[1] == corner[3] && corner[0] != corner[1];
  const bool centerInside = saddle &&
    this->Shape.Value(
      this->At(0.5 * (this->U[i] + this->U[i + 1]), 0.5 * (this->V[j] + this->V[j + 1]))) < 0.0;
  for (int k = 0; k < 4; ++k)
  {
    if (!corner[k] || corner[(k + 1) % 4])
    {
      continue;
    }
    // The other end: the next edge around where the interior begins, or the one before if the
    // saddle's center parts the two insides.
    const int step = saddle && !centerInside ? 3 : 1;
    int end = (k + step) % 4;
    while (corner[end] || !corner[(end + 1) % 4])
    {
      end = (end + step) % 4;
    }
    this->Next[edges[k]] = static_cast<std::int64_t>(edges[end]);
  }
}

std::array<double, 2> PlaneTracer::VertexOn(Edge edge) const
{
  const std::size_t i = edge / 2 % this->Columns;
  const std::size_t j = edge / 2 / this->Columns;
  const Point3 p = this->At(this->U[i], this->V[j]);
  if (edge % 2 == 1)
  {
    const int v = SecondAxis(this->Axis);
    return { this->U[i], FindRoot(this->Shape, p, v, this->V[j], this->V[j + 1]) };
  }
  const int u = FirstAxis(this->Axis);
  return { FindRoot(this->Shape, p, u, this->U[i], this->U[i + 1]), this->V[j] };
}

void PlaneTracer::Run(Pieces& pieces)
{
  this->Classify();
  this->Next.assign(2 * this->Inside.size() + 4, -1);
  for (std::size_t j = 0; j + 1 < this->V.size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < this->Columns; ++i)
    {
      this->LinkCell(i, j);
    }
  }
  for (std::size_t start = 0; start < this->Next.size(); ++start)
  {
    std::vector<std::array<double, 2>> vertices;
    for (std::size_t at = start; this->Next[at] >= 0;)
    {
      vertices.push_back(this->VertexOn(at));
      const auto next = static_cast<std::size_t>(this->Next[at]);
      this->Next[at] = -1;
      at = next;
    }
    if (!vertices.empty())
    {
      AddPiece(pieces, vertices, this->Plane);
    }
  }
}

std::vector<double> AlignedLines(
  double low, const std::vector<double>& planes, double high, int subdivisions)
{
  std::vector<double> lines;
  for (std::size_t slab = 0; slab <= planes.size(); ++slab)
  {
    const double from = slab == 0 ? low : planes[slab - 1];
    const double to = slab == planes.size() ? high : planes[slab];
    for (int i = 0; i < subdivisions; ++i)
    {
      lines.push_back(i == 0 ? from : from + (to - from) * i / subdivisions);
    }
  }
  lines.push_back(high);
  return lines;
}

std::vector<double> FreeLines(double low, double high, std::size_t cells, double phase)
{
  std::vector<double> lines{ low };
  for (std::size_t i = 0; i < cells; ++i)
  {
    lines.push_back(low + (high - low) * (static_cast<double>(i) + phase) / cells);
  }
  lines.push_back(high);
  return lines;
}
}

PlaneSets EqualPlanes(const Solid& solid, const std::array<int, 3>& count)
{
  PlaneSets planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < count[axis]; ++i)
    {
      planes[axis].push_back(
        solid.Low[axis] + (solid.High[axis] - solid.Low[axis]) * (i + 0.5) / count[axis]);
    }
  }
  return planes;
}

PlaneSets RandomPlanes(const Solid& solid, const std::array<int, 3>& count, std::uint64_t seed)
{
  Random random(seed);
  PlaneSets planes = EqualPlanes(solid, count);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double distance = (solid.High[axis] - solid.Low[axis]) / count[axis];
    for (double& plane : planes[axis])
    {
      plane += random.Uniform(-0.375, 0.375) * distance;
    }
  }
  return planes;
}

PieceSets SliceSolid(
  const Solid& solid, const PlaneSets& planes, int subdivisions, InPlaneGrid grid)
{
  return SliceSolid(
    solid, planes, std::array<int, 3>{ subdivisions, subdivisions, subdivisions }, grid);
}

PieceSets SliceSolid(const Solid& solid, const PlaneSets& planes,
  const std::array<int, 3>& subdivisions, InPlaneGrid grid)
{
  PieceSets sets = EmptySets();
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<std::vector<double>, 3> lines;
    for (const int other : { FirstAxis(axis), SecondAxis(axis) })
    {
      const std::size_t cells = (planes[other].size() + 1) * subdivisions[other];
      lines[other] = grid == InPlaneGrid::Aligned
        ? AlignedLines(solid.Low[other], planes[other], solid.High[other], subdivisions[other])
        : FreeLines(solid.Low[other], solid.High[other], cells, 0.137 + 0.211 * axis);
    }
    for (const double plane : planes[axis])
    {
      PlaneTracer(solid, axis, plane, lines[FirstAxis(axis)], lines[SecondAxis(axis)])
        .Run(sets[axis]);
    }
  }
  return sets;
}

const PieceSets& TorusSlices()
{
  static const PieceSets sets = []
  {
    const Solid solid = TiltedTorus();
    return SliceSolid(solid, EqualPlanes(solid, { 8, 9, 10 }), 6, InPlaneGrid::Aligned);
  }();
  return sets;
}

} // namespace support
} // namespace orthoslices
