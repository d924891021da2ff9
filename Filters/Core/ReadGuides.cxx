// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReadGuides.h"

#include "Core/ReadSlices.h"

#include <utility>

namespace orthoslices
{
namespace
{
/// Pieces of slices across z alone.
std::array<Pieces, 3> AcrossZ(Pieces&& pieces)
{
  std::array<Pieces, 3> sets;
  sets[0].Axis = 0;
  sets[1].Axis = 1;
  sets[2] = std::move(pieces);
  return sets;
}

/// A plane of the world along the axes of a frame. Its normal points to the same side.
GuidePlane MapPlane(const OtherPlane& plane, const AxisFrame& frame)
{
  Point3 normal;
  for (int axis = 0; axis < 3; ++axis)
  {
    Point3 along{};
    along[axis] = 1.0;
    normal[axis] = Dot(plane.Normal, frame.ToWorld(along));
  }
  const double length = Length(normal);
  return { (1.0 / length) * normal, plane.Offset / length };
}

/// The contours of a plane in its own frame, along the axes of another one.
std::vector<std::vector<Point3>> MapLoops(
  const Contours& contours, const OtherPlane& plane, const AxisFrame& frame)
{
  std::vector<std::vector<Point3>> loops(contours.Count());
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      loops[contour].push_back(frame.ToAxes(PointOn(plane, contours.U[i], contours.V[i])));
    }
  }
  return loops;
}
}

std::vector<GuideContours> ReadGuides(const Polylines& lines, const std::vector<OtherPlane>& planes,
  const AxisFrame& frame, const Options& options, const Execution& execution)
{
  Options settings = options;
  settings.InsertMissing = false;
  settings.GivenBorder = Box3(); // its sides are not across the axes of the planes' own frames
  Execution quietly = execution;
  quietly.Continue = [](double) { return true; };
  std::vector<GuideContours> guides;
  for (const OtherPlane& plane : planes)
  {
    const StageObserver none;
    Pass pass(settings, quietly, none);
    guides.push_back({ MapPlane(plane, frame), {} });
    if (ReadSlices(AcrossZ(LayOnPlane(lines, plane)), pass) && !pass.Result.InsideOut)
    {
      guides.back().Loops = MapLoops(pass.Tables.Contours, plane, frame);
    }
  }
  return guides;
}
}
