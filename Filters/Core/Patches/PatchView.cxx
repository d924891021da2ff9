// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/PatchView.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Length of the mean of unit normals below which they point all around, and their mean nowhere.
constexpr double MinMeanNormal = 1e-3;

/// Twice the area of a projected triangle, in squared mean radii, from which its orientation is
/// certain: places are about 1, and known to some 1e-15; a thousand times that is left for growth.
constexpr double CertainArea = 1e-12;
}

Point3 PatchView::Turn(const Point3& d) const
{
  return { Dot(d, this->Axes[0]), Dot(d, this->Axes[1]), Dot(d, this->Axes[2]) };
}

Point3 PatchView::DirectionToWorld(const Point3& local) const
{
  return local[0] * this->Axes[0] + local[1] * this->Axes[1] + local[2] * this->Axes[2];
}

Point3 PatchView::ToWorld(const Point3& local) const
{
  return this->Origin + this->Unit * this->DirectionToWorld(local);
}

bool PatchView::Set(const PatchBorder& border)
{
  const std::size_t n = border.Places.size();
  this->Origin = border.Center;
  Point3 normal{ 0.0, 0.0, 0.0 };
  double radius2 = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    normal = normal + border.Weights[i] * border.Normals[i];
    radius2 += border.Weights[i] * SquaredDistance(border.Center, border.Places[i]);
  }
  this->Unit = std::sqrt(radius2);
  if (!(this->Unit > 0.0) || !(Length(normal) > MinMeanNormal))
  {
    return false;
  }
  normal = orthoslices::Unit(normal);
  this->Axes = CompleteFrame(normal);
  this->LocalPlaces.resize(n);
  this->LocalNormals.resize(n);
  double divergence = 0.0, extent = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point3 p = this->LocalPlaces[i] = this->ToLocal(border.Places[i]);
    const Point3 m = this->LocalNormals[i] = this->Turn(border.Normals[i]);
    divergence += border.Weights[i] * (p[0] * m[0] + p[1] * m[1]);
    extent += border.Weights[i] * (p[0] * p[0] + p[1] * p[1]);
  }
  this->Bend = extent > 0.0 ? divergence / extent : 0.0;
  this->Bend = std::max(-MaxBend, std::min(MaxBend, this->Bend));
  for (const Point3& p : this->LocalPlaces)
  {
    this->Bend = 1.0 + this->Bend * p[2] < MinDistanceFromCenter
      ? (MinDistanceFromCenter - 1.0) / p[2]
      : this->Bend;
  }
  this->Projected.resize(n);
  std::transform(this->LocalPlaces.begin(), this->LocalPlaces.end(), this->Projected.begin(),
    [this](const Point3& p) { return this->Project(p); });
  this->HasOutline = false;
  return true;
}

void PatchView::SetOutline(const PatchBorder& outline)
{
  this->HasOutline = true;
  this->ProjectedOutline.resize(outline.Places.size());
  std::transform(outline.Places.begin(), outline.Places.end(), this->ProjectedOutline.begin(),
    [this](const Point3& p) { return this->Project(this->ToLocal(p)); });
}

double PatchView::Clamp(const Point2& p, const Box3& box, double z) const
{
  const Point3 from = this->ToWorld(this->OnLine(p, 0.0));
  const Point3 along = this->Unit * this->DirectionToWorld(this->LineAt(p));
  double low = -HUGE_VAL, high = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (along[axis] != 0.0)
    {
      const double first = (box.Low[axis] - from[axis]) / along[axis];
      const double last = (box.High[axis] - from[axis]) / along[axis];
      low = std::max(low, std::min(first, last));
      high = std::min(high, std::max(first, last));
    }
  }
  return low <= high ? std::max(low, std::min(high, z)) : z;
}

bool PatchView::SeesAll(const InnerPatch& patch) const
{
  std::vector<Point2> inner(patch.Points.size());
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    const Point3 local = this->ToLocal(patch.Points[i]);
    if (!(1.0 + this->Bend * local[2] > 0.0))
    {
      return false;
    }
    inner[i] = this->Project(local);
  }
  const std::vector<Point2>& outline = this->Outline();
  const auto at = [&](Index corner) -> const Point2&
  { return corner >= 0 ? outline[corner] : inner[-1 - corner]; };
  return std::all_of(patch.Triangles.begin(), patch.Triangles.end(),
    [&](const std::array<Index, 3>& t)
    {
      const Point2 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > CertainArea;
    });
}
}
