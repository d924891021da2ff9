// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/ReconstructSorted.h"

#include "Core/ReadGuides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orthoslices
{
namespace
{
template <typename Number, typename Map>
void MapTriples(std::vector<Number>& triples, Map&& map)
{
  for (std::size_t i = 0; i + 2 < triples.size(); i += 3)
  {
    const Point3 mapped = map(Point3{ triples[i], triples[i + 1], triples[i + 2] });
    for (int k = 0; k < 3; ++k)
    {
      triples[i + k] = static_cast<Number>(mapped[k]);
    }
  }
}

/// What is said of planes, for each of the polylines on them; 0 if it is not said.
std::vector<std::uint8_t> SpreadOverLines(
  const std::vector<OtherPlane>& planes, const std::vector<std::uint8_t>& ofPlanes, Index count)
{
  std::vector<std::uint8_t> ofLines(count, 0);
  for (std::size_t i = 0; i < ofPlanes.size(); ++i)
  {
    for (const Index line : planes[i].Lines)
    {
      ofLines[line] = ofPlanes[i];
    }
  }
  return ofLines;
}

/// The surface with its normals.
void MapSurface(const AxisFrame& frame, Reconstruction& result)
{
  const auto point = [&](const Point3& p) { return frame.ToWorld(p); };
  const auto normal = [&](const Point3& n) { return frame.NormalToWorld(n); };
  MapTriples(result.Graph.Points, point);
  MapTriples(result.Drawn.Points, point);
  MapTriples(result.Isolated.Points, point);
  MapTriples(result.Surface.CentralPoints, point);
  MapTriples(result.Surface.Inner.Points, point);
  MapTriples(result.Surface.Improved.Points, point);
  MapTriples(result.Normals.Normals, normal);
  MapTriples(result.Surface.Inner.Normals, normal);
  for (PatchMesh& mesh : result.Surface.Meshes)
  {
    for (Point3& p : mesh.Points)
    {
      p = frame.ToWorld(p);
    }
  }
}

/// The places of the report, and the shifts of slices.
void MapReport(const AxisFrame& frame, Reconstruction& result)
{
  const auto mapPlaces = [&](auto& places)
  {
    for (auto& place : places)
    {
      place.Where = frame.ToWorld(place.Where);
    }
  };
  mapPlaces(result.Invalid);
  mapPlaces(result.CrossingProblems);
  mapPlaces(result.Mended);
  mapPlaces(result.Repairs);
  mapPlaces(result.Undecided.Places);
  mapPlaces(result.Doubtful.Places);
  for (std::vector<Point3>& shifts : result.Agreement.Shift)
  {
    for (Point3& shift : shifts)
    {
      shift = frame.ToWorld(shift);
    }
  }
}

/// Cells of the slices are numbers of polylines: names port, block and cell instead.
void NameSources(const PolylineSources& from, Reconstruction& result)
{
  for (std::vector<Problem>* problems :
    { &result.Invalid, &result.CrossingProblems, &result.Mended })
  {
    for (Problem& problem : *problems)
    {
      if (problem.Cell >= 0)
      {
        problem.Port = from.Port[problem.Cell];
        problem.Cell = from.Cell[problem.Cell];
      }
    }
  }
  ContourList& members = result.Members;
  members.Port.assign(members.Cell.size(), 0);
  members.Block.assign(members.Cell.size(), 0);
  for (std::size_t i = 0; i < members.Cell.size(); ++i)
  {
    const std::int64_t line = members.Cell[i];
    members.Port[i] = members.Axis[i];
    if (line >= 0) // contours that were added come from nowhere
    {
      members.Port[i] = from.Port[line];
      members.Block[i] = from.Block[line];
      members.Cell[i] = from.Cell[line];
    }
  }
}
}

double ChooseQuantum(const SortedSlices& sorted, bool singlePrecision)
{
  if (sorted.Frame.IsWorld())
  {
    return 0.0;
  }
  double largest = 0.0;
  for (const Pieces& pieces : sorted.Slices)
  {
    for (const std::vector<double>* values : { &pieces.U, &pieces.V, &pieces.W })
    {
      for (const double value : *values)
      {
        largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
      }
    }
  }
  const int bits = singlePrecision ? 20 : 44;
  return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest) + 1 - bits) : 0.0;
}

bool HasRoomInSinglePrecision(const SortedSlices& sorted, double tolerance)
{
  constexpr double least = 4096.0 * std::numeric_limits<float>::epsilon();
  for (const Pieces& pieces : sorted.Slices)
  {
    std::vector<double> planes; // the first vertex of a piece says where it is
    for (Index piece = 0; piece < pieces.Count(); ++piece)
    {
      if (pieces.Offsets[piece] < pieces.Offsets[piece + 1] &&
        std::isfinite(pieces.W[pieces.Offsets[piece]]))
      {
        planes.push_back(pieces.W[pieces.Offsets[piece]]);
      }
    }
    std::sort(planes.begin(), planes.end());
    for (std::size_t i = 1; i < planes.size(); ++i)
    {
      const double distance = planes[i] - planes[i - 1];
      if (distance > tolerance * (planes.back() - planes.front()) &&
        distance < least * std::max(std::abs(planes.front()), std::abs(planes.back())))
      {
        return false;
      }
    }
  }
  return true;
}

AxisFrame MetricOf(const AxisFrame& frame) { return frame.IsRotation() ? AxisFrame() : frame; }

void ReturnToWorld(SortedSlices&& sorted, Reconstruction& result)
{
  NameSources(sorted.From, result);
  result.Sources = std::move(sorted.From);
  result.Frame = sorted.Frame;
  if (!result.Frame.IsWorld())
  {
    MapSurface(result.Frame, result);
    MapReport(result.Frame, result);
  }
}

Reconstruction ReconstructSorted(SortedSlices&& sorted, const Options& options,
  const Execution& execution, const StageObserver& observer)
{
  Options settings = options;
  settings.Quantum = ChooseQuantum(sorted, options.SinglePrecision);
  settings.Metric = MetricOf(sorted.Frame);
  const std::vector<OtherPlane> planes =
    FindOtherPlanes(sorted.Others, options.PlaneTolerance * DiagonalOf(sorted.Others));
  const std::vector<GuideContours> guides =
    ReadGuides(sorted.Others, planes, sorted.Frame, settings, execution);
  settings.Guides = guides.empty() ? nullptr : &guides;
  Reconstruction result = Reconstruct(std::move(sorted.Slices), settings, execution, observer);
  result.Guiding = SpreadOverLines(planes, result.Guiding, sorted.Others.Count());
  ReturnToWorld(std::move(sorted), result);
  return result;
}
}
