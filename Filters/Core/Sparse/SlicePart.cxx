// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SlicePart.h"

#include "Core/Base/Predicates.h"
#include "Core/Sparse/InterpolatePolygon.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
using Polygon = std::vector<Point2>;

/// Vertices of a contour that are tried for whether they are inside another one.
constexpr std::size_t TriedVertices = 16;

bool HasVertexInside(const Polygon& polygon, const Polygon& other)
{
  const std::size_t step = 1 + (polygon.size() - 1) / TriedVertices;
  for (std::size_t i = 0; i < polygon.size(); i += step)
  {
    if (IsInside(other, polygon[i]))
    {
      return true;
    }
  }
  return false;
}
}

SlicePart MakeSlicePart(const Contours& contours, Index contour)
{
  SlicePart part;
  part.Plane = contours.Plane[contour];
  for (Index v = contours.Offsets[contour]; v < contours.Offsets[contour + 1]; ++v)
  {
    part.Vertices.push_back({ contours.U[v], contours.V[v] });
    for (int i = 0; i < 2; ++i)
    {
      part.Low[i] = std::min(part.Low[i], part.Vertices.back()[i]);
      part.High[i] = std::max(part.High[i], part.Vertices.back()[i]);
    }
  }
  part.Middle = MiddleOf(part.Vertices);
  part.Area = SignedArea(part.Vertices);
  return part;
}

bool DoOverlap(const SlicePart& a, const SlicePart& b)
{
  for (int i = 0; i < 2; ++i)
  {
    if (a.High[i] < b.Low[i] || b.High[i] < a.Low[i])
    {
      return false;
    }
  }
  return a.Area * b.Area > 0.0 &&
    (HasVertexInside(a.Vertices, b.Vertices) || HasVertexInside(b.Vertices, a.Vertices));
}
}
