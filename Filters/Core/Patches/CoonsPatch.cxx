// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/CoonsPatch.h"

#include "Core/Patches/PatchView.h"
#include "Core/Patches/Quadrilaterals.h"
#include "Core/Planar/SimplePolygon.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// A side of a quadrilateral that is a part of the border, from 0 at the node point to 1.
struct HalfArcCurve
{
  std::vector<Point3> Places;
  std::vector<double> Shares; ///< of the length, at each place

  void Set(const PatchBorder& border, Index node, Index end)
  {
    const Index n = border.Count();
    const Index step = end >= node ? 1 : -1;
    this->Places.clear();
    this->Shares.clear();
    double length = 0.0;
    for (Index i = node; i != end + step; i += step)
    {
      const Point3& place = border.Places[((i % n) + n) % n];
      length += this->Places.empty() ? 0.0 : Length(place - this->Places.back());
      this->Places.push_back(place);
      this->Shares.push_back(length);
    }
    for (double& share : this->Shares)
    {
      share = length > 0.0 ? share / length : 0.0;
    }
  }

  Point3 At(double share) const
  {
    const auto next = std::lower_bound(this->Shares.begin(), this->Shares.end(), share);
    const std::size_t i = static_cast<std::size_t>(next - this->Shares.begin());
    if (i == 0 || next == this->Shares.end())
    {
      return i == 0 ? this->Places.front() : this->Places.back();
    }
    const double step = this->Shares[i] - this->Shares[i - 1];
    return Between(this->Places[i - 1], this->Places[i],
      step > 0.0 ? (share - this->Shares[i - 1]) / step : 0.0);
  }
};

/// Builds the Coons patch of one polygon.
class CoonsBuilder
{
public:
  CoonsBuilder(const SpatialGrid& grid, const PatchBorder& border, const Point3& centralPoint,
    Index parts, InnerPatch& patch)
    : Grid(grid)
    , Border(border)
    , Center(centralPoint)
    , Parts(parts)
    , Patch(patch)
  {
  }

  void Run();

private:
  Index Corner(std::size_t quadrilateral, Index a, Index b) const;
  void AddPoint(const Point3& place);
  void AddSpoke(std::size_t quadrilateral);
  void AddInside(std::size_t quadrilateral);
  void AddMeshes(std::size_t quadrilateral);
  void AddStrip(std::size_t quadrilateral);
  void SetSides(std::size_t quadrilateral);

  const SpatialGrid& Grid;
  const PatchBorder& Border;
  Point3 Center;
  Index Parts;
  InnerPatch& Patch;
  std::vector<Quadrilateral> Quadrilaterals;
  HalfArcCurve After, Before; ///< of the node point
};

/// The corner of a mesh, a parts along the arc after the node point, b along the one before it.
Index CoonsBuilder::Corner(std::size_t quadrilateral, Index a, Index b) const
{
  const Index k = this->Parts, inside = k - 1;
  const Index count = static_cast<Index>(this->Quadrilaterals.size());
  const Index q = static_cast<Index>(quadrilateral);
  if (a == k && b == k)
  {
    return -1;
  }
  if (a == k || b == k)
  {
    const Index spoke = a == k ? q : (q + count - 1) % count;
    return -1 - (1 + spoke * inside + (a == k ? b : a) - 1);
  }
  return -1 - (1 + count * inside + (q * inside + a - 1) * inside + b - 1);
}

void CoonsBuilder::AddPoint(const Point3& place)
{
  this->Patch.Points.push_back(this->Border.MoveInside(this->Grid, place));
  this->Patch.Normals.push_back({ 0.0, 0.0, 0.0 });
}

void CoonsBuilder::SetSides(std::size_t quadrilateral)
{
  const Quadrilateral& q = this->Quadrilaterals[quadrilateral];
  const Index node = this->Border.NodePlaces[quadrilateral];
  this->After.Set(this->Border, node, q.Last);
  this->Before.Set(this->Border, node, q.First);
}

/// Adds the points from the middle of the arc after the node point to the central point.
void CoonsBuilder::AddSpoke(std::size_t quadrilateral)
{
  this->SetSides(quadrilateral);
  for (Index j = 1; j < this->Parts; ++j)
  {
    this->AddPoint(Between(this->After.Places.back(), this->Center, double(j) / this->Parts));
  }
}

/// Adds the points within a quadrilateral, by blending its four sides.
void CoonsBuilder::AddInside(std::size_t quadrilateral)
{
  this->SetSides(quadrilateral);
  const Point3 &node = this->After.Places.front(), &after = this->After.Places.back(),
               &before = this->Before.Places.back();
  for (Index a = 1; a < this->Parts; ++a)
  {
    for (Index b = 1; b < this->Parts; ++b)
    {
      const double s = double(a) / this->Parts, t = double(b) / this->Parts;
      const Point3 along = Between(this->After.At(s), Between(before, this->Center, s), t);
      const Point3 across = Between(this->Before.At(t), Between(after, this->Center, t), s);
      const Point3 corners = Between(Between(node, after, s), Between(before, this->Center, s), t);
      this->AddPoint(along + across - corners);
    }
  }
}

/// Adds two triangles for each mesh of a quadrilateral that has no side on the border.
void CoonsBuilder::AddMeshes(std::size_t quadrilateral)
{
  const auto corner = [&](Index a, Index b) { return this->Corner(quadrilateral, a, b); };
  for (Index a = 1; a < this->Parts; ++a)
  {
    for (Index b = 1; b < this->Parts; ++b)
    {
      this->Patch.Triangles.push_back({ corner(a, b), corner(a + 1, b), corner(a + 1, b + 1) });
      this->Patch.Triangles.push_back({ corner(a, b), corner(a + 1, b + 1), corner(a, b + 1) });
    }
  }
}

/// Adds the triangles between the vertices of the arcs and the first row of points inside.
void CoonsBuilder::AddStrip(std::size_t quadrilateral)
{
  this->SetSides(quadrilateral);
  const Quadrilateral& q = this->Quadrilaterals[quadrilateral];
  const Index n = this->Border.Count(), node = this->Border.NodePlaces[quadrilateral];
  const Index k = this->Parts;
  std::vector<std::pair<double, Index>> outer, inner; // share of the way from or to the node point
  for (Index i = q.First; i <= q.Last; ++i)
  {
    outer.emplace_back(
      i < node ? -this->Before.Shares[node - i] : this->After.Shares[i - node], ((i % n) + n) % n);
  }
  if (q.First == node)
  {
    // The first row then lies on one line with the node point: no triangles between the two.
    outer[1].first = std::min(outer[1].first, 1.0 / k);
  }
  for (Index b = k; b >= 1; --b)
  {
    inner.emplace_back(-double(b) / k, this->Corner(quadrilateral, 1, b));
  }
  for (Index a = 2; a <= k; ++a)
  {
    inner.emplace_back(double(a) / k, this->Corner(quadrilateral, a, 1));
  }
  std::size_t i = 0, j = 0;
  while (i + 1 < outer.size() || j + 1 < inner.size())
  {
    const bool onOuter =
      j + 1 == inner.size() || (i + 1 < outer.size() && outer[i + 1].first <= inner[j + 1].first);
    if (onOuter)
    {
      this->Patch.Triangles.push_back({ outer[i].second, outer[i + 1].second, inner[j].second });
    }
    else
    {
      this->Patch.Triangles.push_back({ outer[i].second, inner[j + 1].second, inner[j].second });
    }
    ++(onOuter ? i : j);
  }
}

void CoonsBuilder::Run()
{
  this->Patch.Clear();
  SplitIntoQuadrilaterals(this->Border.Count(), this->Border.NodePlaces, this->Quadrilaterals);
  this->AddPoint(this->Center);
  const std::size_t count = this->Quadrilaterals.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    this->AddSpoke(i);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    this->AddInside(i);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    this->AddMeshes(i);
    this->AddStrip(i);
  }
}
}

bool BuildCoonsPatch(const SpatialGrid& grid, const PatchBorder& border, const Point3& centralPoint,
  Index parts, InnerPatch& patch)
{
  CoonsBuilder(grid, border, centralPoint, parts, patch).Run();
  PatchView view;
  return view.Set(border) && IsSimple(view.Border()) && view.SeesAll(patch);
}
}
