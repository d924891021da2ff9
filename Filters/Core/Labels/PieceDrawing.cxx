// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/PieceDrawing.h"

namespace orthoslices
{
PieceDrawing DrawPiece(const SpatialGrid& grid, const BorderPiece& piece, double tolerance)
{
  const int first = FirstAxis(piece.Axis), second = SecondAxis(piece.Axis);
  std::vector<Point2> curve;
  for (const Point3& point : piece.Points)
  {
    curve.push_back({ point[first], point[second] });
  }
  BalancedCurve balanced = BalanceCurve(curve, tolerance);
  PieceDrawing drawing;
  drawing.Places.swap(balanced.Places);
  for (const Point2& p : balanced.Vertices)
  {
    Point3 vertex = piece.Points.front();
    vertex[first] = grid.Round(p[0]);
    vertex[second] = grid.Round(p[1]);
    drawing.Vertices.push_back(vertex);
  }
  for (int end = 0; end < 2; ++end)
  {
    drawing.Bulges[end] = Point3{ 0.0, 0.0, 0.0 };
    drawing.Bulges[end][first] = balanced.Bulges[end][0];
    drawing.Bulges[end][second] = balanced.Bulges[end][1];
  }
  return drawing;
}

PieceDrawing KeepPiece(const BorderPiece& piece)
{
  PieceDrawing drawing;
  for (std::size_t i = 1; i + 1 < piece.Points.size(); ++i)
  {
    drawing.Places.push_back({ i, 0.0, {} });
    drawing.Vertices.push_back(piece.Points[i]);
  }
  return drawing;
}

void AddSides(const BorderPiece& piece, const PieceDrawing& drawing,
  const std::map<Point3, Point3>& moved, Index number, std::vector<PieceSide>& sides)
{
  std::vector<Point3> points{ piece.Points.front() };
  points.insert(points.end(), drawing.Vertices.begin(), drawing.Vertices.end());
  points.push_back(piece.Points.back());
  for (Point3* end : { &points.front(), &points.back() })
  {
    const auto found = moved.find(*end);
    *end = found != moved.end() ? found->second : *end;
  }
  const int u = FirstAxis(piece.Axis), v = SecondAxis(piece.Axis);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    sides.push_back({ piece.Axis, points[i][piece.Axis], { points[i][u], points[i][v] },
      { points[i + 1][u], points[i + 1][v] }, number });
  }
}
}
