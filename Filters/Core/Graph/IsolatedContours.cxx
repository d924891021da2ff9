// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/IsolatedContours.h"

#include "Core/Base/Predicates.h"
#include "Core/Crossings/ArcSources.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// A contour that has lost all of its node points stays if a part of at least this share of its
/// area is left: no more than a bulge was cut off then.
constexpr double MinShare = 0.75;

/// The contour in its plane.
std::vector<Point2> PolygonOf(const IsolatedContours& isolated, Index contour)
{
  const int u = FirstAxis(isolated.Axis[contour]), v = SecondAxis(isolated.Axis[contour]);
  std::vector<Point2> polygon;
  for (Index i = isolated.Offsets[contour]; i < isolated.Offsets[contour + 1]; ++i)
  {
    const double* point = isolated.Points.data() + 3 * static_cast<std::size_t>(i);
    polygon.push_back({ point[u], point[v] });
  }
  return polygon;
}

/// Area of a contour, without its sign.
double AreaOf(const IsolatedContours& isolated, Index contour)
{
  return std::abs(SignedArea(PolygonOf(isolated, contour)));
}

/// Calls the function with the contours of which a chain of runs has vertices.
template <typename Visit>
void VisitContours(const GridCrossings& crossings, Index firstRun, Visit&& visit)
{
  for (Index run = firstRun; run != GridCrossings::None; run = crossings.RunNext[run])
  {
    if (crossings.RunCount[run] > 0)
    {
      visit(crossings.RunContour[run]);
    }
  }
}

double AreaOf(const Contours& contours, Index contour)
{
  std::vector<Point2> polygon;
  for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
  {
    polygon.push_back({ contours.U[i], contours.V[i] });
  }
  return std::abs(SignedArea(polygon));
}

/// Contours that have lost all of their node points and little else are not left out: what is left
/// of them stays.
void KeepLargestParts(const std::vector<IsolatedLoop>& loops, const Contours& contours,
  const GridCrossings& crossings, IsolatedContours& isolated)
{
  std::vector<std::uint8_t> hasNodes(contours.Count(), 0);
  for (Index arc = 0; arc < crossings.Count(); ++arc)
  {
    if (!crossings.IsRemoved(arc))
    {
      VisitContours(crossings, arc, [&](Index contour) { hasNodes[contour] = 1; });
    }
  }
  std::vector<Index> largest(contours.Count(), IsolatedContours::None);
  std::vector<double> areas(contours.Count(), 0.0);
  for (Index i = 0; i < isolated.Count(); ++i)
  {
    const double area = AreaOf(isolated, i);
    VisitContours(crossings, loops[i].FirstRun,
      [&](Index contour)
      {
        if (area > areas[contour])
        {
          areas[contour] = area;
          largest[contour] = i;
        }
      });
  }
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    if (hasNodes[contour] == 0 && largest[contour] != IsolatedContours::None &&
      areas[contour] >= MinShare * AreaOf(contours, contour))
    {
      isolated.LeftOut[largest[contour]] = 0;
    }
  }
}
}

IsolatedContours CopyIsolated(const std::vector<IsolatedLoop>& loops, const Contours& contours,
  const GridCrossings& crossings, bool keepGrazing)
{
  IsolatedContours isolated;
  const auto add = [&](Index contour, Index first, Index count)
  {
    for (Index i = 0; i < count; ++i)
    {
      Index vertex = first + i;
      vertex -= vertex >= contours.Offsets[contour + 1] ? contours.Size(contour) : 0;
      const Point3 point = contours.World(contour, vertex);
      isolated.Points.insert(isolated.Points.end(), point.begin(), point.end());
    }
  };
  for (const IsolatedLoop& loop : loops)
  {
    Index member = loop.Contour;
    if (loop.FirstRun == GridCrossings::None)
    {
      add(member, contours.Offsets[member], contours.Size(member));
    }
    for (Index run = loop.FirstRun; run != GridCrossings::None; run = crossings.RunNext[run])
    {
      if (crossings.RunCount[run] > 0)
      {
        member = crossings.RunContour[run];
        add(member, crossings.RunFirst[run], crossings.RunCount[run]);
      }
    }
    isolated.Offsets.push_back(static_cast<Index>(isolated.Points.size() / 3));
    isolated.Axis.push_back(contours.Axis[member]);
    isolated.Plane.push_back(contours.Plane[member]);
    isolated.Source.push_back(SourceOf(contours, member));
    isolated.LeftOut.push_back(loop.FirstRun == GridCrossings::None ? 0 : 1);
  }
  isolated.Loop.assign(isolated.Axis.size(), IsolatedContours::None);
  if (keepGrazing)
  {
    KeepLargestParts(loops, contours, crossings, isolated);
  }
  return isolated;
}

double ThicknessOf(const IsolatedContours& isolated, Index contour)
{
  const std::vector<Point2> polygon = PolygonOf(isolated, contour);
  double length = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    length += std::hypot(q[0] - p[0], q[1] - p[1]);
  }
  return length > 0.0 ? AreaOf(isolated, contour) / length : 0.0;
}

Index CountLeftOut(const IsolatedContours& isolated)
{
  return static_cast<Index>(
    std::count(isolated.Loop.begin(), isolated.Loop.end(), IsolatedContours::None));
}
}
