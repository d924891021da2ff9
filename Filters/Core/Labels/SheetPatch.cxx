// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/SheetPatch.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <utility>

namespace orthoslices
{
namespace
{
/// An end of a curve on the border.
struct CurveEnd
{
  Index Place; ///< on the border
  Index Curve;
};

/// The ends of curves along a border, turned so that both of each curve are neighbours. Empty if that
/// is impossible.
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
  if (ends.size() != 2 * curves.size())
  {
    return {};
  }
  if (!arePaired())
  {
    std::rotate(ends.begin(), ends.begin() + 1, ends.end());
  }
  return arePaired() ? ends : std::vector<CurveEnd>();
}

/// Appends the places on a border of a size from one to another.
void AppendPath(Index from, Index to, Index size, std::vector<Index>& path)
{
  for (Index place = from; place != to; place = (place + 1) % size)
  {
    path.push_back(place);
  }
  path.push_back(to);
}

void AddFan(Index center, const std::vector<Index>& path, InnerPatch& patch)
{
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    patch.Triangles.push_back({ path[i], path[i + 1], center });
  }
}

/// The mean of points, whatever their order.
Point3 MeanOf(std::vector<Point3> points)
{
  std::sort(points.begin(), points.end());
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (const Point3& point : points)
  {
    sum = sum + point;
  }
  return (1.0 / static_cast<double>(points.size())) * sum;
}

/// The fan of what curves leave of a patch; its center becomes the first point.
void AddRest(const std::vector<Index>& corners, const std::vector<Point3>& at,
  const std::function<Point3(const Point3&)>& placeInside, InnerPatch& patch)
{
  patch.Points.front() = placeInside(MeanOf(at));
  AddFan(-1, corners, patch);
  patch.Triangles.push_back({ corners.back(), corners.front(), -1 });
}
}

bool BuildSheets(const std::vector<Index>& border, const std::vector<Point3>& places,
  const std::vector<JunctionCurve>& curves,
  const std::function<Point3(const Point3&)>& placeInside, InnerPatch& patch)
{
  const std::vector<CurveEnd> ends = OrderEnds(border, curves);
  if (ends.empty())
  {
    return false;
  }
  patch.Clear();
  const Index size = static_cast<Index>(border.size());
  const bool hasRest = curves.size() > 1;
  if (hasRest)
  {
    patch.Points.emplace_back();
  }
  std::vector<Index> rest;
  std::vector<Point3> restAt;
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    const Point3& middle = curves[ends[i].Curve].Middle;
    patch.Points.push_back(middle);
    const Index center = -static_cast<Index>(patch.Points.size());
    std::vector<Index> sheet, between;
    AppendPath(ends[i].Place, ends[i + 1].Place, size, sheet);
    AddFan(center, sheet, patch);
    AppendPath(ends[i + 1].Place, ends[(i + 2) % ends.size()].Place, size, between);
    if (!hasRest)
    {
      AddFan(center, between, patch);
    }
    rest.push_back(center);
    restAt.push_back(middle);
    rest.insert(rest.end(), between.begin(), between.end());
    for (const Index place : between)
    {
      restAt.push_back(places[border[place]]);
    }
  }
  if (hasRest)
  {
    AddRest(rest, restAt, placeInside, patch);
  }
  patch.Normals.assign(patch.Points.size(), Point3{ 0.0, 0.0, 0.0 });
  return true;
}
}
