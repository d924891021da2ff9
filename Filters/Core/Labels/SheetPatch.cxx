// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/SheetPatch.h"

#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
/// The border of a sheet as it is put together.
struct SheetBuilder::Outline
{
  std::vector<Index> Points;
  std::vector<Point3> Normals;
  Index Center = -1; ///< the point around which it can be a fan; -1: none on its border

  void Add(Index point, const Point3& normal)
  {
    this->Points.push_back(point);
    this->Normals.push_back(normal);
  }
};

namespace
{
/// An end of a curve on the border.
struct CurveEnd
{
  Index Place; ///< on the border
  Index Curve;
};

/// The ends of curves along a border, turned so that both of each curve are neighbours. Empty if
/// that is impossible.
std::vector<CurveEnd> OrderEnds(
  const std::vector<Index>& border, const std::vector<JunctionCurve>& curves)
{
  std::vector<CurveEnd> ends;
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      if (curves[c].First == border[i] || curves[c].Last == border[i])
      {
        ends.push_back({ static_cast<Index>(i), static_cast<Index>(c) });
      }
    }
  }
  const auto arePaired = [&]()
  {
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    {
      if (ends[i].Curve != ends[i + 1].Curve)
      {
        return false;
      }
    }
    return true;
  };
  if (ends.size() != 2 * curves.size() || ends.empty())
  {
    return {};
  }
  if (!arePaired())
  {
    std::rotate(ends.begin(), ends.begin() + 1, ends.end());
  }
  return arePaired() ? ends : std::vector<CurveEnd>();
}

/// A closed border from its least number towards the lesser one of the neighbours.
std::vector<Index> Canonical(std::vector<Index> border, bool& isReversed)
{
  std::rotate(border.begin(), std::min_element(border.begin(), border.end()), border.end());
  isReversed = border.back() < border[1];
  if (isReversed)
  {
    std::reverse(border.begin() + 1, border.end());
  }
  return border;
}
}

/// Adds a part of a border, both ends included. The normals at its ends, where other sheets begin,
/// are those of the points next to them.
void SheetBuilder::AddPath(const SheetBorder& border, Index from, Index to, Outline& outline) const
{
  const Index size = static_cast<Index>(border.Points.size());
  const Index count = (to - from + size - 1) % size + 2; // points
  for (Index i = 0; i < count; ++i)
  {
    const Index inner = count > 2 ? std::max<Index>(1, std::min(count - 2, i)) : i;
    outline.Add(border.Points[(from + i) % size],
      border.Normals.empty() ? Point3{ 0.0, 0.0, 0.0 } : border.Normals[(from + inner) % size]);
  }
}

/// Adds the points inside a curve, from one of its ends on. `beside` is a side of the sheet's own
/// border next to it.
void SheetBuilder::AddCurve(
  const JunctionCurve& curve, Index from, const CellEdge& beside, Outline& outline) const
{
  Point3 mean{ 0.0, 0.0, 0.0 };
  for (const Point3& normal : outline.Normals)
  {
    mean = mean + normal;
  }
  const bool isOnSurface = curve.OnSurface.count(beside) > 0;
  const Point3 along = this->Points.PlaceOf(curve.Last) - this->Points.PlaceOf(curve.First);
  const std::size_t count = curve.Inside.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::size_t i = from == curve.First ? k : count - 1 - k;
    Point3 normal = isOnSurface ? curve.Normals[i] : Unit(Cross(along, curve.Normals[i]));
    normal = Dot(normal, mean) < 0.0 ? -1.0 * normal : normal;
    outline.Add(curve.Inside[i], normal);
  }
  outline.Center = outline.Center == -1 ? curve.Inside[count / 2] : -2; // of one curve only
}

bool SheetBuilder::Build(
  const SheetBorder& border, const std::vector<JunctionCurve>& curves, InnerPatch& patch)
{
  const std::vector<CurveEnd> ends = OrderEnds(border.Points, curves);
  if (ends.empty())
  {
    return false;
  }
  patch.Clear();
  const auto sideAt = [&](Index place)
  {
    return CellEdgeOf(
      border.Points[place], border.Points[(place + 1) % static_cast<Index>(border.Points.size())]);
  };
  std::vector<Outline> outlines;
  Outline rest;
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    const JunctionCurve& curve = curves[ends[i].Curve];
    const Index first = ends[i].Place, last = ends[i + 1].Place;
    const Index next = ends[(i + 2) % ends.size()].Place;
    outlines.emplace_back();
    this->AddPath(border, first, last, outlines.back());
    this->AddCurve(curve, border.Points[last], sideAt(first), outlines.back());
    Outline between;
    this->AddPath(border, last, next, between);
    rest.Points.insert(rest.Points.end(), between.Points.begin(), between.Points.end());
    rest.Normals.insert(rest.Normals.end(), between.Normals.begin(), between.Normals.end());
    const JunctionCurve& following = curves[ends[(i + 2) % ends.size()].Curve];
    this->AddCurve(following, border.Points[next], sideAt(last), rest);
  }
  outlines.push_back(std::move(rest));
  this->AppendAll(border, outlines, patch);
  return true;
}

bool SheetBuilder::Build(const SheetBorder& border, const JunctionStar& star, InnerPatch& patch)
{
  const Index size = static_cast<Index>(border.Points.size());
  std::vector<Index> ends; // places on the border
  for (Index i = 0; i < size; ++i)
  {
    if (star.CurveFrom.count(border.Points[i]) > 0)
    {
      ends.push_back(i);
    }
  }
  std::vector<Outline> outlines;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const Index first = ends[i], last = ends[(i + 1) % ends.size()];
    const CellEdge beside = CellEdgeOf(border.Points[first], border.Points[(first + 1) % size]);
    outlines.emplace_back();
    this->AddPath(border, first, last, outlines.back());
    this->AddCurve(
      star.CurveFrom.at(border.Points[last]), border.Points[last], beside, outlines.back());
    const bool isOnSurface = star.OnSurface.count(beside) > 0;
    const bool isAlong = Dot(star.Normal, outlines.back().Normals.front()) >= 0.0;
    outlines.back().Add(
      star.Middle, isOnSurface ? (isAlong ? 1.0 : -1.0) * star.Normal : Point3{ 0.0, 0.0, 0.0 });
    this->AddCurve(star.CurveFrom.at(border.Points[first]), star.Middle, beside, outlines.back());
  }
  patch.Clear();
  this->AppendAll(border, outlines, patch);
  return ends.size() > 1;
}

/// Sheets that are a patch together.
void SheetBuilder::AppendAll(
  const SheetBorder& border, const std::vector<Outline>& outlines, InnerPatch& patch)
{
  std::map<Index, Index> corner;
  for (std::size_t i = 0; i < border.Points.size(); ++i)
  {
    corner[border.Points[i]] = static_cast<Index>(i);
  }
  for (const Outline& outline : outlines)
  {
    bool isReversed;
    const Sheet& sheet = this->FindSheet(outline, isReversed);
    this->Append(sheet, isReversed, corner, patch);
  }
}

/// The sheet of an outline, and whether it was built for the other direction.
const SheetBuilder::Sheet& SheetBuilder::FindSheet(const Outline& outline, bool& isReversed)
{
  bool wantsReversed;
  const std::vector<Index> key = Canonical(outline.Points, wantsReversed);
  for (const Sheet& sheet : this->Sheets)
  {
    bool wasReversed;
    if (Canonical(sheet.Border, wasReversed) == key)
    {
      isReversed = wasReversed != wantsReversed;
      return sheet;
    }
  }
  isReversed = false;
  this->Sheets.push_back(this->MakeSheet(outline));
  return this->Sheets.back();
}

SheetBuilder::Sheet SheetBuilder::MakeSheet(const Outline& outline)
{
  Sheet sheet;
  sheet.Border = outline.Points;
  if (!this->MakeSmooth(outline, sheet))
  {
    this->MakeFan(outline, sheet);
  }
  return sheet;
}

bool SheetBuilder::MakeSmooth(const Outline& outline, Sheet& sheet)
{
  if (std::any_of(outline.Normals.begin(), outline.Normals.end(),
        [](const Point3& normal) { return Dot(normal, normal) == 0.0; }))
  {
    return false;
  }
  // From the least place on, so that the sheet does not depend on who asks for it first.
  PatchBorder border;
  border.Points = outline.Points;
  border.Normals = outline.Normals;
  for (const Index point : outline.Points)
  {
    border.Places.push_back(this->Points.PlaceOf(point));
  }
  border.Room = this->Room;
  const Index first = border.Turn(), size = border.Count();
  InnerPatch patch;
  if (!this->Smooth.Build(border, patch))
  {
    return false;
  }
  for (const Point3& place : patch.Points)
  {
    sheet.Inside.push_back(this->Points.NumberOf(place));
  }
  sheet.Normals = patch.Normals;
  for (const std::array<Index, 3>& triangle : patch.Triangles)
  {
    std::array<Index, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = triangle[i] >= 0 ? outline.Points[(triangle[i] + first) % size]
                                    : sheet.Inside[-1 - triangle[i]];
    }
    sheet.Triangles.push_back(corners);
  }
  return true;
}

/// A fan around the middle of its curve, or around a point inside if it has several.
void SheetBuilder::MakeFan(const Outline& outline, Sheet& sheet)
{
  sheet.Inside.clear();
  sheet.Normals.clear();
  sheet.Triangles.clear();
  Index center = outline.Center;
  if (center < 0)
  {
    std::vector<Point3> places;
    for (const Index point : outline.Points)
    {
      places.push_back(this->Points.PlaceOf(point));
    }
    std::sort(places.begin(), places.end());
    Point3 middle{ 0.0, 0.0, 0.0 };
    for (const Point3& place : places)
    {
      middle = middle + (1.0 / static_cast<double>(places.size())) * place;
    }
    PatchBorder border;
    border.Room = this->Room;
    center = this->Points.NumberOf(border.MoveInside(this->Grid, middle));
    sheet.Inside.push_back(center);
    sheet.Normals.push_back({ 0.0, 0.0, 0.0 });
  }
  const std::size_t size = outline.Points.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Index a = outline.Points[i], b = outline.Points[(i + 1) % size];
    if (a != center && b != center)
    {
      sheet.Triangles.push_back({ a, b, center });
    }
  }
}

/// Adds a sheet to a patch. `corner` has the corners that its points have there; those that have
/// none become points inside.
void SheetBuilder::Append(
  const Sheet& sheet, bool isReversed, std::map<Index, Index>& corner, InnerPatch& patch) const
{
  const auto cornerOf = [&](Index point)
  {
    const auto [at, isNew] = corner.emplace(point, -1 - static_cast<Index>(patch.Points.size()));
    if (isNew)
    {
      patch.Points.push_back(this->Points.PlaceOf(point));
      const auto own = std::find(sheet.Inside.begin(), sheet.Inside.end(), point);
      const Point3 normal = own == sheet.Inside.end() ? Point3{ 0.0, 0.0, 0.0 }
                                                      // surfaces meet there at an edge
                                                      : sheet.Normals[own - sheet.Inside.begin()];
      patch.Normals.push_back(isReversed ? -1.0 * normal : normal);
    }
    return at->second;
  };
  for (const std::array<Index, 3>& triangle : sheet.Triangles)
  {
    const Index a = cornerOf(triangle[0]), b = cornerOf(triangle[1]), c = cornerOf(triangle[2]);
    patch.Triangles.push_back(
      isReversed ? std::array<Index, 3>{ a, c, b } : std::array<Index, 3>{ a, b, c });
  }
}
}
