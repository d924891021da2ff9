// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/ArcShells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Depth of the outermost shell as a part of the way from the border to the centre of the face.
constexpr double DeepestShell = 0.3;

/// An end of an arc on the border of its face.
struct BorderEnd
{
  int Edge; ///< see BorderEdge
  Index Node;
  Index Crossing;
  bool IsStart; ///< of its arc
  Index Arc;
};

class ShellDrawer
{
public:
  ShellDrawer(const ArcGeometry& geometry, const Face& face)
    : Geometry(geometry)
    , Rectangle(face)
  {
  }

  FaceDrawing Run(const FaceArcs& face);

private:
  void SortEnds(const FaceArcs& face);
  bool Interlock() const;
  void Reconnect();
  void FindRectangle();
  void ClipToBounds();
  bool IsWithinBounds() const;
  void Draw();
  void DrawArc(std::size_t first, std::size_t last, double depth);
  Point3 Inward(const Point2& p, double depth) const;
  void Describe(bool reconnected);

  const ArcGeometry& Geometry;
  const Face& Rectangle;
  std::array<double, 2> Low, High;
  std::vector<BorderEnd> Ends;
  FaceDrawing Result;
};

/// Counter-clockwise around the face. Nodes on one grid edge are numbered upwards.
void ShellDrawer::SortEnds(const FaceArcs& face)
{
  const GridCrossings& crossings = this->Geometry.Crossings;
  for (const Index arc : face)
  {
    const Index stop = crossings.Next[arc];
    this->Ends.push_back(
      { BorderEdge(crossings, arc, true), this->Geometry.StartNode(arc), arc, true, arc });
    this->Ends.push_back(
      { BorderEdge(crossings, stop, false), this->Geometry.EndNode(arc), stop, false, arc });
  }
  std::sort(this->Ends.begin(), this->Ends.end(),
    [](const BorderEnd& a, const BorderEnd& b) {
      return a.Edge != b.Edge ? a.Edge < b.Edge : a.Edge < 2 ? a.Node < b.Node : a.Node > b.Node;
    });
}

bool ShellDrawer::Interlock() const
{
  std::vector<Index> open;
  for (const BorderEnd& end : this->Ends)
  {
    const Index arc = end.Arc;
    if (!open.empty() && open.back() == arc)
    {
      open.pop_back();
    }
    else
    {
      open.push_back(arc);
    }
  }
  return !open.empty();
}

/// Joins every start to the nearest free end around the border; starts and ends alternate there.
void ShellDrawer::Reconnect()
{
  std::vector<BorderEnd*> open;
  for (BorderEnd& end : this->Ends)
  {
    if (open.empty() || open.back()->IsStart == end.IsStart)
    {
      open.push_back(&end);
      continue;
    }
    BorderEnd& start = end.IsStart ? end : *open.back();
    BorderEnd& stop = end.IsStart ? *open.back() : end;
    stop.Arc = start.Arc;
    this->Result.Joins.push_back({ start.Crossing, stop.Crossing });
    open.pop_back();
  }
}

void ShellDrawer::FindRectangle()
{
  for (int side = 0; side < 2; ++side)
  {
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    for (const BorderEnd& end : this->Ends)
    {
      const double x = this->Geometry.InPlane(this->Rectangle, end.Node)[side];
      minimum = std::min(minimum, x);
      maximum = std::max(maximum, x);
    }
    const int axis = (this->Rectangle.Axis + 1 + side) % 3;
    this->Geometry.Grid.GetExtent(
      axis, this->Rectangle.Slab[side], minimum, maximum, this->Low[side], this->High[side]);
  }
}

void ShellDrawer::ClipToBounds()
{
  for (int side = 0; side < 2; ++side)
  {
    this->Geometry.Grid.ClipToBounds(
      (this->Rectangle.Axis + 1 + side) % 3, this->Low[side], this->High[side]);
  }
}

bool ShellDrawer::IsWithinBounds() const
{
  return std::all_of(this->Result.Points.begin(), this->Result.Points.end(),
    [this](const Point3& point) { return this->Geometry.Grid.IsWithinBounds(point); });
}

/// A point of the border moved towards the centre.
Point3 ShellDrawer::Inward(const Point2& p, double depth) const
{
  Point2 moved;
  for (int side = 0; side < 2; ++side)
  {
    const double middle = this->Low[side] + 0.5 * (this->High[side] - this->Low[side]);
    moved[side] = this->Geometry.Grid.Round(p[side] + depth * (middle - p[side]));
  }
  return this->Geometry.InSpace(this->Rectangle, moved);
}

/// An arc between two ends, counter-clockwise along the border.
void ShellDrawer::DrawArc(std::size_t first, std::size_t last, double depth)
{
  // Corner e lies at the end of edge e.
  const Point2 corners[4] = { { this->High[0], this->Low[1] }, { this->High[0], this->High[1] },
    { this->Low[0], this->High[1] }, { this->Low[0], this->Low[1] } };
  const BorderEnd& from = this->Ends[first];
  const BorderEnd& to = this->Ends[last];
  std::vector<Point3>& points = this->Result.Points;
  const std::size_t begin = points.size();
  points.push_back(this->Inward(this->Geometry.InPlane(this->Rectangle, from.Node), depth));
  for (int edge = from.Edge; edge < to.Edge; ++edge)
  {
    points.push_back(this->Inward(corners[edge], depth));
  }
  points.push_back(this->Inward(this->Geometry.InPlane(this->Rectangle, to.Node), depth));
  if (to.IsStart)
  {
    std::reverse(points.begin() + begin, points.end());
  }
  this->Result.Arcs.push_back(from.Arc);
  this->Result.Offsets.push_back(points.size());
}

void ShellDrawer::Draw()
{
  this->Result.Points.clear();
  this->Result.Arcs.clear();
  this->Result.Offsets.assign(1, 0);
  struct Open
  {
    std::size_t End;
    int Height; ///< greatest number of arcs nested beneath, so far
  };
  const double step = DeepestShell / (0.5 * this->Ends.size());
  std::vector<Open> open;
  for (std::size_t i = 0; i < this->Ends.size(); ++i)
  {
    if (open.empty() || this->Ends[open.back().End].Arc != this->Ends[i].Arc)
    {
      open.push_back({ i, 0 });
      continue;
    }
    const std::size_t first = open.back().End;
    const int height = open.back().Height + 1;
    open.pop_back();
    if (!open.empty())
    {
      open.back().Height = std::max(open.back().Height, height);
    }
    this->DrawArc(first, i, step * height);
  }
}

void ShellDrawer::Describe(bool reconnected)
{
  Point3 sum{ 0.0, 0.0, 0.0 };
  double length = 0.0;
  for (std::size_t arc = 0; arc < this->Result.Arcs.size(); ++arc)
  {
    for (std::size_t i = this->Result.Offsets[arc]; i < this->Result.Offsets[arc + 1]; ++i)
    {
      const Point3& p = this->Result.Points[i];
      const Point3& q = this->Result.Points[i > this->Result.Offsets[arc] ? i - 1 : i];
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += p[axis];
      }
    }
  }
  const double count = static_cast<double>(this->Result.Points.size());
  this->Result.What = { reconnected ? RepairKind::ArcsReconnected : RepairKind::ArcsRedrawn,
    this->Rectangle.Axis, this->Rectangle.Plane, { sum[0] / count, sum[1] / count, sum[2] / count },
    length };
}

FaceDrawing ShellDrawer::Run(const FaceArcs& face)
{
  this->SortEnds(face);
  const bool reconnect = this->Interlock();
  if (reconnect)
  {
    this->Reconnect();
  }
  this->FindRectangle();
  this->Draw();
  if (!this->IsWithinBounds())
  {
    this->ClipToBounds();
    this->Draw();
  }
  this->Describe(reconnect);
  return std::move(this->Result);
}
}

FaceDrawing DrawArcShells(const ArcGeometry& geometry, const FaceArcs& face)
{
  return ShellDrawer(geometry, face.Face).Run(face);
}
}
