// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/GuideCurves.h"

#include <algorithm>
#include <utility>

namespace orthoslices
{
namespace
{
/// A point of a contour that is being cut.
struct Station
{
  Point3 Place;
  bool IsCut;  ///< lies on a plane that cuts the contour
  Index Plane; ///< that of the stack; -1 if it is another
  Index Slab;  ///< behind it
};

/// A point of a piece that is not at its ends.
Point3 MiddleOf(const GuidePiece& piece)
{
  const std::size_t half = piece.Points.size() / 2;
  return piece.Points.size() > 2 ? piece.Points[half]
                                 : Between(piece.Points.front(), piece.Points.back(), 0.5);
}

/// Cuts one contour after another by the planes of a stack and by others.
class ContourCutter
{
public:
  ContourCutter(const GuideCurves& curves)
    : Curves(curves)
    , Tolerance(FlatShare * curves.Spacing())
  {
    for (const int axis : { 0, 1, 2 })
    {
      for (const double plane : curves.Planes[axis])
      {
        this->Others.emplace_back();
        this->Others.back().Normal[axis] = 1.0;
        this->Others.back().Offset = plane;
      }
    }
    for (const GuideSlice& slice : curves.Slices)
    {
      this->Others.push_back(slice.Plane);
    }
  }

  void Run(const std::vector<Point3>& contour, std::vector<GuidePiece>& pieces);

private:
  double LevelOf(Index plane) const;
  Index SlabOf(const Point3& point) const;
  void CutSide(const Point3& from, const Point3& to);

  const GuideCurves& Curves;
  const double Tolerance;
  std::vector<GuidePlane> Others; ///< that cut, beside those of the stack
  std::vector<Station> Stations;
};

/// Where a contour passes a plane of the stack: a little before the first and the last one.
double ContourCutter::LevelOf(Index plane) const
{
  const auto& planes = this->Curves.StackPlanes;
  const bool isFirst = plane == 0, isLast = plane + 1 == static_cast<Index>(planes.size());
  return planes[plane] + (isFirst ? this->Tolerance : 0.0) - (isLast ? this->Tolerance : 0.0);
}

Index ContourCutter::SlabOf(const Point3& point) const
{
  Index slab = 0;
  while (slab < static_cast<Index>(this->Curves.StackPlanes.size()) &&
    point[this->Curves.StackAxis] >= this->LevelOf(slab))
  {
    ++slab;
  }
  return slab;
}

/// Appends the start of a side and where it is cut.
void ContourCutter::CutSide(const Point3& from, const Point3& to)
{
  const int axis = std::max(this->Curves.StackAxis, 0); // without a stack there are no planes of it
  const Index slab = this->SlabOf(from), end = this->SlabOf(to);
  this->Stations.push_back({ from, false, -1, slab });
  std::vector<std::pair<double, Index>> cuts; // share of the side, and the plane of the stack or -1
  const double rise = to[axis] - from[axis];
  for (Index i = slab; i != end; i += slab < end ? 1 : -1)
  {
    const Index plane = slab < end ? i : i - 1;
    const double share = (this->Curves.StackPlanes[plane] - from[axis]) / rise;
    cuts.emplace_back(std::clamp(share, 0.0, 1.0), plane);
  }
  for (const GuidePlane& other : this->Others)
  {
    const double a = other.HeightOf(from), b = other.HeightOf(to);
    if ((a < 0.0) != (b < 0.0))
    {
      cuts.emplace_back(a / (a - b), -1);
    }
  }
  std::stable_sort(
    cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [share, plane] : cuts)
  {
    const Index before = this->Stations.back().Slab;
    const Index behind = plane < 0 ? before : (slab < end ? plane + 1 : plane);
    Point3 place = Between(from, to, share);
    place[axis] = plane < 0 ? place[axis] : this->Curves.StackPlanes[plane];
    this->Stations.push_back({ place, true, plane, behind });
  }
}

void ContourCutter::Run(const std::vector<Point3>& contour, std::vector<GuidePiece>& pieces)
{
  this->Stations.clear();
  for (std::size_t i = 0; i < contour.size(); ++i)
  {
    this->CutSide(contour[i], contour[i + 1 < contour.size() ? i + 1 : 0]);
  }
  const auto first = std::find_if(
    this->Stations.begin(), this->Stations.end(), [](const Station& at) { return at.IsCut; });
  if (first == this->Stations.end())
  {
    return;
  }
  std::rotate(this->Stations.begin(), first, this->Stations.end());
  this->Stations.push_back(this->Stations.front());
  GuidePiece piece;
  for (const Station& at : this->Stations)
  {
    if (piece.Points.empty() || SquaredDistance(piece.Points.back(), at.Place) > 0.0)
    {
      piece.Points.push_back(at.Place);
    }
    if (at.IsCut)
    {
      piece.Planes[1] = at.Plane;
      if (piece.Points.size() > 1)
      {
        piece.Slab = this->Curves.StackAxis < 0 ? this->Curves.SlabAt(MiddleOf(piece)) : piece.Slab;
        pieces.push_back(std::move(piece));
      }
      piece = { { at.Place }, at.Slab, { at.Plane, -1 } };
    }
  }
}
}

double GuideCurves::Spacing() const
{
  const std::size_t count = this->StackPlanes.size();
  return count > 1
    ? (this->StackPlanes.back() - this->StackPlanes.front()) / static_cast<double>(count - 1)
    : 1.0;
}

Index GuideCurves::SlabAt(const Point3& point) const
{
  const auto countBelow = [](const std::vector<double>& planes, double coordinate)
  {
    return static_cast<Index>(
      std::upper_bound(planes.begin(), planes.end(), coordinate) - planes.begin());
  };
  if (this->StackAxis >= 0)
  {
    return countBelow(this->StackPlanes, point[this->StackAxis]);
  }
  Index slab = 0;
  for (const int axis : { 0, 1, 2 })
  {
    slab = slab * (static_cast<Index>(this->Planes[axis].size()) + 1) +
      countBelow(this->Planes[axis], point[axis]);
  }
  return slab;
}

GuideCurves CutGuides(const Contours& contours, const SpatialGrid& grid, int stackAxis)
{
  GuideCurves curves;
  curves.StackAxis = stackAxis;
  curves.StackPlanes = grid.Planes[stackAxis];
  for (const int axis : { FirstAxis(stackAxis), SecondAxis(stackAxis) })
  {
    for (const double plane : grid.Planes[axis])
    {
      GuideSlice slice;
      slice.Plane.Normal[axis] = 1.0;
      slice.Plane.Offset = plane;
      ContourCutter cutter(curves);
      for (Index contour = 0; contour < contours.Count(); ++contour)
      {
        std::vector<Point3> points;
        for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1] &&
             contours.Axis[contour] == axis && contours.Coordinate[contour] == plane;
             ++i)
        {
          points.push_back(contours.World(contour, i));
        }
        cutter.Run(points, slice.Pieces);
      }
      curves.Slices.push_back(std::move(slice));
    }
  }
  return curves;
}

void AddGuides(const std::vector<GuideContours>& others, GuideCurves& curves)
{
  for (const GuideContours& contours : others)
  {
    GuideSlice slice;
    slice.Plane = contours.Plane;
    ContourCutter cutter(curves);
    for (const std::vector<Point3>& loop : contours.Loops)
    {
      cutter.Run(loop, slice.Pieces);
    }
    curves.Slices.push_back(std::move(slice));
  }
}
}
