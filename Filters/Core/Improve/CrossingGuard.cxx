// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/CrossingGuard.h"

#include "Core/Base/Predicates.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
Box3 BoxOf(const std::array<Point3, 3>& places)
{
  Box3 box;
  for (const Point3& place : places)
  {
    box.Add(place);
  }
  return box;
}

bool HaveCommonCorner(const std::array<Index, 3>& s, const std::array<Index, 3>& t)
{
  return std::any_of(
    s.begin(), s.end(), [&](Index i) { return i == t[0] || i == t[1] || i == t[2]; });
}
}

Box3 BoxOf(const CornerTable& corners, const std::vector<Point3>& points, Index triangle)
{
  Box3 box;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3 && corners.IsAlive(corner); ++corner)
  {
    box.Add(points[corners.VertexOf(corner)]);
  }
  return box;
}

std::vector<Box3> BoxesOf(const CornerTable& corners, const std::vector<Point3>& points)
{
  std::vector<Box3> boxes;
  boxes.reserve(static_cast<std::size_t>(corners.CornerCount()) / 3);
  for (Index triangle = 0; 3 * triangle < corners.CornerCount(); ++triangle)
  {
    boxes.push_back(BoxOf(corners, points, triangle));
  }
  return boxes;
}

CrossingGuard::CrossingGuard(const CornerTable& corners, const std::vector<Point3>& points,
  const BoxTree& boxes, const SheetBorders& borders)
  : Corners(corners)
  , Points(points)
  , Boxes(boxes)
  , Borders(borders)
{
}

bool CrossingGuard::IsCornerOfAdded(Index point) const
{
  return std::any_of(this->AddedCorners.begin(), this->AddedCorners.end(),
    [point](const Corner& corner) { return corner.Point == point; });
}

CrossingGuard::Places CrossingGuard::PlacesOf(const std::array<Index, 3>& triangle) const
{
  return { this->PlaceOf(triangle[0]), this->PlaceOf(triangle[1]), this->PlaceOf(triangle[2]) };
}

std::array<Index, 3> CrossingGuard::CornersOf(Index triangle) const
{
  const auto at = [&](Index i) { return this->Borders.SiteOf(this->Corners.VertexOf(i)); };
  return { at(3 * triangle), at(3 * triangle + 1), at(3 * triangle + 2) };
}

bool CrossingGuard::IsRemoved(Index triangle) const
{
  const std::vector<Index>& removed = this->Change->Removed;
  return std::find(removed.begin(), removed.end(), triangle) != removed.end();
}

Point2 CrossingGuard::Project(const Point3& place) const
{
  return { place[FirstAxis(this->Axis)], place[SecondAxis(this->Axis)] };
}

/// Along the axis that is nearest to the normal of what is added.
void CrossingGuard::ChooseAxis()
{
  Point3 normal{ 0.0, 0.0, 0.0 };
  for (const AddedTriangle& triangle : this->Added)
  {
    const Places& p = triangle.Corners;
    normal = normal + Cross(p[1] - p[0], p[2] - p[0]);
  }
  this->Axis = 0;
  for (const int axis : { 1, 2 })
  {
    this->Axis = std::abs(normal[axis]) > std::abs(normal[this->Axis]) ? axis : this->Axis;
  }
  this->Direction = normal[this->Axis] > 0.0 ? 1 : -1;
}

void CrossingGuard::SetChange(const SurfaceChange& change)
{
  this->Change = &change;
  this->Added.clear();
  for (const std::array<Index, 3>& triangle : change.Added)
  {
    const Places places = this->PlacesOf(triangle);
    this->Added.push_back({ { this->Borders.SiteOf(triangle[0]), this->Borders.SiteOf(triangle[1]),
                              this->Borders.SiteOf(triangle[2]) },
      places, BoxOf(places) });
  }
  this->ChooseAxis();
  this->AddedCorners.clear();
  for (const AddedTriangle& triangle : this->Added)
  {
    for (const Index point : triangle.Points)
    {
      if (!this->IsCornerOfAdded(point))
      {
        const Point3& place = this->PlaceOf(point);
        this->AddedCorners.push_back({ point, place, this->Project(place) });
      }
    }
  }
}

/// Lists the triangles that there would be at a point, each from there on, first those that are
/// added.
void CrossingGuard::ListAround(Index point)
{
  this->Around.clear();
  for (const AddedTriangle& added : this->Added)
  {
    const std::array<Index, 3>& triangle = added.Points;
    for (int i = 0; i < 3; ++i)
    {
      if (triangle[i] == point)
      {
        this->Around.push_back({ point, triangle[(i + 1) % 3], triangle[(i + 2) % 3] });
      }
    }
  }
  this->AddedAround = this->Around.size();
  if (point >= this->Corners.PointCount())
  {
    return;
  }
  const auto add = [&](Index corner)
  {
    if (!this->IsRemoved(corner / 3) && !this->Borders.IsBeyond(this->Corners, corner / 3))
    {
      this->Around.push_back({ point, this->Borders.SiteOf(this->Corners.StartOf(corner)),
        this->Borders.SiteOf(this->Corners.EndOf(corner)) });
    }
  };
  this->Borders.ForCopiesOf(point, [&](Index copy) { this->Corners.ForCornersAt(copy, add); });
}

/// Whether the triangles that were listed around a point pass around it once in the projection, all
/// in the same direction: then they meet nowhere but in common sides.
bool CrossingGuard::IsFan(Index point) const
{
  if (this->Borders.HasCopies(point))
  {
    return false; // several fans, which may overlap
  }
  const Point2 center = this->Project(this->PlaceOf(point));
  int turns = 0;
  for (const std::array<Index, 3>& triangle : this->Around)
  {
    const Point2 p = this->Project(this->PlaceOf(triangle[1]));
    const Point2 q = this->Project(this->PlaceOf(triangle[2]));
    if (SideOf(center, p, q) != this->Direction)
    {
      return false;
    }
    // Each turn passes the ray to the right of the centre once.
    const bool before = p[1] >= center[1], after = q[1] >= center[1];
    turns += this->Direction > 0 ? (!before && after ? 1 : 0) : (before && !after ? 1 : 0);
  }
  return turns == 1;
}

/// Whether what is added meets the other triangles at one of its corners in common corners only.
bool CrossingGuard::AreApartAround(Index point)
{
  this->ListAround(point);
  if (this->IsFan(point))
  {
    return true;
  }
  CommonCorners common;
  for (std::size_t i = 0; i < this->AddedAround; ++i)
  {
    for (std::size_t k = i + 1; k < this->Around.size(); ++k)
    {
      common.Find(this->Around[i], this->Around[k]);
      if (!CertainlyApartBeyond(
            common, this->PlacesOf(this->Around[i]), this->PlacesOf(this->Around[k])))
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether, in the projection, the line of a side of a triangle has the triangle on one side and
/// all that is added, but for corners that are ends of that side, strictly on the other.
bool CrossingGuard::LineSeparates(const std::array<Index, 3>& triangle) const
{
  const std::array<Point2, 3> p{ this->Project(this->PlaceOf(triangle[0])),
    this->Project(this->PlaceOf(triangle[1])), this->Project(this->PlaceOf(triangle[2])) };
  const int own = SideOf(p[0], p[1], p[2]);
  for (int i = 0; i < 3 && own != 0; ++i)
  {
    const int next = (i + 1) % 3;
    const bool separates = std::all_of(this->AddedCorners.begin(), this->AddedCorners.end(),
      [&](const Corner& corner)
      {
        return corner.Point == triangle[i] || corner.Point == triangle[next] ||
          SideOf(p[i], p[next], corner.Projected) == -own;
      });
    if (separates)
    {
      return true;
    }
  }
  return false;
}

/// Whether all that is added lies strictly on one side of the plane of a triangle.
bool CrossingGuard::PlaneSeparates(const std::array<Index, 3>& triangle) const
{
  const Places t = this->PlacesOf(triangle);
  const int side = CertainSide(t[0], t[1], t[2], this->AddedCorners.front().Place);
  return side != 0 &&
    std::all_of(this->AddedCorners.begin() + 1, this->AddedCorners.end(),
      [&](const Corner& corner) { return CertainSide(t[0], t[1], t[2], corner.Place) == side; });
}

/// Lists what is added and has a box that meets that of a triangle, but no corner of it: what has
/// one is tested around that corner.
void CrossingGuard::ListClose(Index triangle, const std::array<Index, 3>& corners, bool isBeside)
{
  this->Close.clear();
  const Box3& box = this->Boxes[triangle];
  for (std::size_t i = 0; i < this->Added.size(); ++i)
  {
    if (this->Added[i].Box.Meets(box) &&
      !(isBeside && HaveCommonCorner(this->Added[i].Points, corners)))
    {
      this->Close.push_back(i);
    }
  }
}

/// Whether a triangle that stays meets none of those that are added and have no corner of it.
bool CrossingGuard::IsApart(Index triangle)
{
  const std::array<Index, 3> corners = this->CornersOf(triangle);
  const bool isBeside = std::any_of(
    corners.begin(), corners.end(), [&](Index point) { return this->IsCornerOfAdded(point); });
  this->ListClose(triangle, corners, isBeside);
  if (this->Close.empty() || this->LineSeparates(corners) ||
    (!isBeside && this->PlaneSeparates(corners)))
  {
    return true;
  }
  const Places own = this->PlacesOf(corners);
  return std::all_of(this->Close.begin(), this->Close.end(),
    [&](std::size_t i) { return CertainlyApart(own, this->Added[i].Corners); });
}

/// Whether a side is new and joins places that another side joins, or a place with itself.
bool CrossingGuard::DoublesSide(Index a, Index b) const
{
  const bool mayBe = this->Borders.HasCopies(a) || this->Borders.HasCopies(b);
  if (!mayBe || std::max(a, b) >= this->Corners.PointCount() || this->Corners.FindEdge(a, b) >= 0)
  {
    return false;
  }
  bool doubles = this->Borders.AreCopies(a, b);
  this->Borders.ForCopiesOf(a,
    [&](Index p)
    {
      this->Borders.ForCopiesOf(
        b, [&](Index q) { doubles = doubles || this->Corners.AreAdjacent(p, q); });
    });
  return doubles;
}

bool CrossingGuard::DoublesAnySide() const
{
  return std::any_of(this->Change->Added.begin(), this->Change->Added.end(),
    [&](const std::array<Index, 3>& t)
    {
      return this->DoublesSide(t[0], t[1]) || this->DoublesSide(t[1], t[2]) ||
        this->DoublesSide(t[2], t[0]);
    });
}

bool CrossingGuard::Allows(const SurfaceChange& change)
{
  this->SetChange(change);
  if (this->Borders.Beyond > 0 && this->DoublesAnySide())
  {
    return false;
  }
  Box3 box;
  for (const Corner& corner : this->AddedCorners)
  {
    if (!this->AreApartAround(corner.Point))
    {
      return false;
    }
    box.Add(corner.Place);
  }
  this->Near.clear();
  this->Boxes.ForBoxesAt(box, [&](Index triangle) { this->Near.push_back(triangle); });
  return std::all_of(this->Near.begin(), this->Near.end(),
    [&](Index triangle) { return this->IsRemoved(triangle) || this->IsApart(triangle); });
}
}
