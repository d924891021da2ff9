// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/BorderHeading.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Places of a cycle: angles between their headings then are known to some degrees, as well as the
/// headings themselves.
constexpr Index PlacesPerCycle = 32;
/// Places of an arc, however short: with one alone, an arc could not be told from its middle.
constexpr Index PlacesPerArc = 2;

/// Takes places evenly from one arc after another.
class HeadingFinder
{
public:
  HeadingFinder(const CycleGeometry& geometry, const std::vector<double>& nodeNormals, Index cycle)
    : Geometry(geometry)
    , NodeNormals(nodeNormals)
    , Cycle(cycle)
  {
    geometry.GetBoundary(cycle, this->Points, this->NodePlaces);
    const std::size_t count = this->Points.size();
    this->Along.assign(count + 1, 0.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Along[i + 1] = this->Along[i] + Length(this->At(i + 1) - this->At(i));
    }
  }

  std::vector<Heading> Find();

private:
  Point3 At(std::size_t place) const
  {
    const Point3 point = this->Geometry.Graph.PointAt(this->Points[place % this->Points.size()]);
    const AxisFrame& metric = this->Geometry.Grid.Metric;
    return metric.IsWorld() ? point : metric.ToWorld(point);
  }
  Point3 Inwards(const HalfArc& half) const;
  double TiltAt(std::size_t place, const Point3& along, const Point3& inwards, bool& known) const;
  void AddArc(std::size_t first, std::size_t last, const Point3& inwards);

  const CycleGeometry& Geometry;
  const std::vector<double>& NodeNormals;
  const Index Cycle;
  std::vector<Index> Points, NodePlaces;
  std::vector<double> Along; ///< length of the border before each place, and of all of it
  std::vector<Heading> Found;
};

/// From the slice of a half-arc into the cell.
Point3 HeadingFinder::Inwards(const HalfArc& half) const
{
  int axis = 0;
  if (this->Geometry.Graph.IsLoop(half.Arc))
  {
    axis = this->Geometry.Graph.Loops[half.Arc - this->Geometry.Graph.Arcs].Axis;
  }
  else
  {
    const GridEdge edge =
      GridEdgeCode(this->Geometry.Grid).Decode(this->Geometry.Crossings.Edge[half.Arc]);
    axis = this->Geometry.Crossings.Family[half.Arc] == 0 ? FirstAxis(edge.Direction)
                                                          : SecondAxis(edge.Direction);
  }
  return (half.Above ? 1.0 : -1.0) * this->Geometry.Grid.Metric.Normal(axis);
}

/// The angle of the surface's normal at a node against the slice, towards the cell. It is not known
/// if the node has no normal.
double HeadingFinder::TiltAt(
  std::size_t place, const Point3& along, const Point3& inwards, bool& known) const
{
  const Index node = this->Points[place % this->Points.size()];
  known = node < this->Geometry.Graph.Nodes;
  if (!known)
  {
    return 0.0;
  }
  const double* n = this->NodeNormals.data() + 3 * static_cast<std::size_t>(node);
  const AxisFrame& metric = this->Geometry.Grid.Metric;
  const Point3 own{ n[0], n[1], n[2] };
  const Point3 normal = metric.IsWorld() ? own : metric.NormalToWorld(own);
  known = Dot(normal, normal) > 0.0;
  return known ? std::atan2(Dot(normal, inwards), std::max(0.0, Dot(normal, Cross(along, inwards))))
               : 0.0;
}

/// The arc between two places of the border that are nodes, or all of a loop.
void HeadingFinder::AddArc(std::size_t first, std::size_t last, const Point3& inwards)
{
  const double length = this->Along[last] - this->Along[first], all = this->Along.back();
  if (!(length > 0.0))
  {
    return;
  }
  bool knownFirst = false, knownLast = false;
  double tiltFirst =
    this->TiltAt(first, Unit(this->At(first + 1) - this->At(first)), inwards, knownFirst);
  double tiltLast =
    this->TiltAt(last, Unit(this->At(last) - this->At(last - 1)), inwards, knownLast);
  tiltFirst = knownFirst ? tiltFirst : tiltLast;
  tiltLast = knownLast ? tiltLast : tiltFirst;
  const Index places =
    std::max(PlacesPerArc, static_cast<Index>(std::ceil(PlacesPerCycle * length / all)));
  std::size_t side = first;
  for (Index i = 0; i < places; ++i)
  {
    const double share = (i + 0.5) / places;
    const double at = this->Along[first] + share * length;
    while (side + 1 < last && this->Along[side + 1] < at)
    {
      ++side;
    }
    const double width = this->Along[side + 1] - this->Along[side];
    const Point3 step = this->At(side + 1) - this->At(side), along = Unit(step);
    const double tilt = (1.0 - share) * tiltFirst + share * tiltLast;
    const Point3 direction = std::cos(tilt) * inwards + std::sin(tilt) * Cross(inwards, along);
    this->Found.push_back(
      { this->At(side) + (width > 0.0 ? (at - this->Along[side]) / width : 0.0) * step, direction,
        Cross(along, direction), length / (all * places) });
  }
}

std::vector<Heading> HeadingFinder::Find()
{
  const CellCycles& cycles = this->Geometry.Cycles;
  const HalfArc* arcs = cycles.Arcs.data() + cycles.Offsets[this->Cycle];
  if (this->Geometry.IsLoop(this->Cycle))
  {
    this->AddArc(0, this->Points.size(), this->Inwards(arcs[0]));
    return std::move(this->Found);
  }
  for (std::size_t i = 0; i < this->NodePlaces.size(); ++i)
  {
    const std::size_t last =
      i + 1 < this->NodePlaces.size() ? this->NodePlaces[i + 1] : this->Points.size();
    this->AddArc(this->NodePlaces[i], last, this->Inwards(arcs[i]));
  }
  return std::move(this->Found);
}

/// The angles of both headings against the line between them.
double TurnOf(const Heading& from, const Heading& to)
{
  const Point3 line = Unit(to.Place - from.Place);
  const auto angle = [&](const Point3& direction, double sign)
  { return std::acos(std::clamp(sign * Dot(direction, line), -1.0, 1.0)); };
  return (angle(from.Direction, 1.0) + angle(to.Direction, -1.0)) / Pi;
}

/// Mean over the first one's headings.
double TurnToNearest(const std::vector<Heading>& from, const std::vector<Heading>& to)
{
  double sum = 0.0;
  for (const Heading& start : from)
  {
    const auto distance = [&](const Heading& end)
    { return Dot(end.Place - start.Place, end.Place - start.Place); };
    const auto nearest = std::min_element(to.begin(), to.end(),
      [&](const Heading& a, const Heading& b) { return distance(a) < distance(b); });
    sum += start.Weight * TurnOf(start, *nearest);
  }
  return sum;
}
}

std::vector<Heading> FindHeadings(
  const CycleGeometry& geometry, const std::vector<double>& nodeNormals, Index cycle)
{
  return HeadingFinder(geometry, nodeNormals, cycle).Find();
}

double TurnAcross(const std::vector<Heading>& headings)
{
  double sum = 0.0;
  for (const Heading& from : headings)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Heading& to : headings)
    {
      least = &from == &to ? least : std::min(least, TurnOf(from, to));
    }
    sum += from.Weight * (std::isfinite(least) ? least : 1.0);
  }
  return headings.empty() ? 1.0 : sum;
}

double TurnBetween(const std::vector<Heading>& first, const std::vector<Heading>& second)
{
  return first.empty() || second.empty()
    ? 0.0
    : 0.5 * (TurnToNearest(first, second) + TurnToNearest(second, first));
}
}
