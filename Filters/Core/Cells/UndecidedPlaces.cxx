// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/UndecidedPlaces.h"

#include "Core/Base/Box.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Bits of uncertainty of a place where the slices speak for a join that cannot be made: nothing is
/// known of it.
constexpr double OfImpossible = 1.0;

/// Where an interval begins, or ends with negative uncertainty.
struct End
{
  double Coordinate, Uncertainty;

  /// At the same coordinate intervals begin before others end.
  bool operator<(const End& other) const
  {
    return this->Coordinate != other.Coordinate ? this->Coordinate < other.Coordinate
                                                : this->Uncertainty > other.Uncertainty;
  }
};

/// Planes of an axis that settle a place: all with coordinates between the two.
struct Interval
{
  Index Place;
  int Axis;
  double Low, High;
};

Box3 BoxOf(const CycleGeometry& geometry, Index cycle)
{
  Box3 box;
  for (const Index point : geometry.GetBorders({ cycle }))
  {
    box.Add(geometry.Graph.PointAt(point));
  }
  return box;
}

class Proposer
{
public:
  explicit Proposer(const CycleGeometry& geometry)
    : Geometry(geometry)
  {
  }

  UndecidedPlaces Run(const std::vector<CycleJoin>& joins, Index maxPlanes);

private:
  void AddPlace(const CycleJoin& join);
  void AddIntervals(const CycleJoin& join, const Box3& a, const Box3& b);
  void AddThroughLoop(Index cycle, const Box3& box);
  void AddInterval(int axis, double low, double high);
  std::vector<End> EndsOn(int axis) const;
  ProposedPlane FindBest() const;
  bool ProposePlane();

  const CycleGeometry& Geometry;
  UndecidedPlaces Result;
  std::vector<Interval> Intervals; ///< of places without a plane
};

/// Adds planes of the last place. Intervals that overlap become one: a plane settles a place once.
void Proposer::AddInterval(int axis, double low, double high)
{
  const Index place = static_cast<Index>(this->Result.Places.size()) - 1;
  for (auto other = this->Intervals.rbegin();
       other != this->Intervals.rend() && other->Place == place; ++other)
  {
    if (other->Axis == axis && low <= other->High && other->Low <= high)
    {
      other->Low = std::min(other->Low, low);
      other->High = std::max(other->High, high);
      return;
    }
  }
  this->Intervals.push_back({ place, axis, low, high });
}

/// Planes across the contour: they give it node points.
void Proposer::AddThroughLoop(Index cycle, const Box3& box)
{
  const int axis = this->Geometry.Graph.Loops[this->Geometry.LoopOf(cycle)].Axis;
  for (const int across : { FirstAxis(axis), SecondAxis(axis) })
  {
    // The middle half, where a plane does not just touch it.
    const double quarter = 0.25 * (box.High[across] - box.Low[across]);
    this->AddInterval(across, box.Low[across] + quarter, box.High[across] - quarter);
  }
}

void Proposer::AddIntervals(const CycleJoin& join, const Box3& a, const Box3& b)
{
  const Index place = static_cast<Index>(this->Result.Places.size()) - 1;
  const bool firstIsLoop = this->Geometry.IsLoop(join.First);
  const bool secondIsLoop = this->Geometry.IsLoop(join.Second);
  if (firstIsLoop)
  {
    this->AddThroughLoop(join.First, a);
  }
  if (secondIsLoop)
  {
    this->AddThroughLoop(join.Second, b);
  }
  if (firstIsLoop || secondIsLoop)
  {
    return;
  }
  int widest = 0;
  Point3 distance;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = std::min(a.High[axis], b.High[axis]);
    const double high = std::max(a.Low[axis], b.Low[axis]);
    if (low < high)
    {
      const double quarter = 0.25 * (high - low);
      this->AddInterval(axis, low + quarter, high - quarter);
    }
    distance[axis] = std::abs(a.Low[axis] + a.High[axis] - b.Low[axis] - b.High[axis]);
    widest = distance[axis] > distance[widest] ? axis : widest;
  }
  if (this->Intervals.empty() || this->Intervals.back().Place != place)
  {
    // They lie beside each other along every axis: halve the cell.
    const double middle = 0.25 * (a.Low[widest] + a.High[widest] + b.Low[widest] + b.High[widest]);
    this->AddInterval(widest, middle, middle);
  }
}

void Proposer::AddPlace(const CycleJoin& join)
{
  const Box3 a = BoxOf(this->Geometry, join.First);
  const Box3 b = BoxOf(this->Geometry, join.Second);
  const Index loops =
    (this->Geometry.IsLoop(join.First) ? 1 : 0) + (this->Geometry.IsLoop(join.Second) ? 1 : 0);
  UndecidedPlace place;
  place.Where = 0.25 * ((a.Low + a.High) + (b.Low + b.High));
  place.Kind = loops == 0 ? UndecidedKind::TwoCycles
    : loops == 1          ? UndecidedKind::IsolatedContour
                          : UndecidedKind::IsolatedContours;
  place.Choice = join.Impossible ? UndecidedChoice::Impossible
    : join.Chosen                ? UndecidedChoice::Joined
                                 : UndecidedChoice::Separate;
  place.Evidence = join.Evidence;
  place.Uncertainty = join.Impossible ? OfImpossible : UncertaintyOf(join.Evidence);
  place.PlaneRank = -1;
  this->Result.Places.push_back(place);
  this->AddIntervals(join, a, b);
}

/// The ends of all intervals on an axis, in order.
std::vector<End> Proposer::EndsOn(int axis) const
{
  std::vector<End> ends;
  for (const Interval& interval : this->Intervals)
  {
    if (interval.Axis == axis)
    {
      const double uncertainty = this->Result.Places[interval.Place].Uncertainty;
      ends.push_back({ interval.Low, uncertainty });
      ends.push_back({ interval.High, -uncertainty });
    }
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// The plane in the intervals with the greatest sum of uncertainty.
ProposedPlane Proposer::FindBest() const
{
  ProposedPlane best{ 0, 0.0, 0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<End> ends = this->EndsOn(axis);
    double open = 0.0;
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      open += ends[i].Uncertainty;
      // Where one begins, so that what rounding leaves of those that have ended is no plane.
      if (ends[i].Uncertainty > 0.0 && open > best.Gain)
      {
        // It ends somewhere: there is a next one.
        best = { axis, 0.5 * (ends[i].Coordinate + ends[i + 1].Coordinate), 0, open };
      }
    }
  }
  return best;
}

/// Proposes the best plane, and takes out the places that it settles.
bool Proposer::ProposePlane()
{
  if (this->Intervals.empty())
  {
    return false;
  }
  ProposedPlane best = this->FindBest();
  const int rank = static_cast<int>(this->Result.Planes.size());
  for (const Interval& interval : this->Intervals)
  {
    UndecidedPlace& place = this->Result.Places[interval.Place];
    if (place.PlaneRank < 0 && interval.Axis == best.Axis && interval.Low <= best.Coordinate &&
      best.Coordinate <= interval.High)
    {
      place.PlaneRank = rank;
      ++best.Settles;
    }
  }
  this->Result.Planes.push_back(best);
  this->Intervals.erase(
    std::remove_if(this->Intervals.begin(), this->Intervals.end(),
      [&](const Interval& interval) { return this->Result.Places[interval.Place].PlaneRank >= 0; }),
    this->Intervals.end());
  return true;
}

UndecidedPlaces Proposer::Run(const std::vector<CycleJoin>& joins, Index maxPlanes)
{
  for (const CycleJoin& join : joins)
  {
    if ((join.Impossible || std::abs(join.Evidence) < DecisiveEvidence) &&
      this->Geometry.IsReal(join.First) && this->Geometry.IsReal(join.Second))
    {
      this->AddPlace(join);
    }
  }
  for (Index i = 0; i < maxPlanes && this->ProposePlane(); ++i)
  {
  }
  std::stable_sort(this->Result.Places.begin(), this->Result.Places.end(),
    [](const UndecidedPlace& a, const UndecidedPlace& b)
    {
      // Without a plane at the end.
      const unsigned rankA = static_cast<unsigned>(a.PlaneRank);
      const unsigned rankB = static_cast<unsigned>(b.PlaneRank);
      return rankA != rankB ? rankA < rankB : a.Evidence > b.Evidence;
    });
  return std::move(this->Result);
}
}

double UncertaintyOf(double evidence)
{
  // With the probability p = 1 / (1 + exp(-|evidence|)) of what is likelier, -log p is the first
  // logarithm, and -log(1 - p) is greater by |evidence|. No exponential overflows.
  const double against = std::exp(-std::abs(evidence));
  const double nats = std::log1p(against) + std::abs(evidence) * against / (1.0 + against);
  return nats / std::log(2.0);
}

UndecidedPlaces FindUndecidedPlaces(
  const CycleGeometry& geometry, const std::vector<CycleJoin>& joins, Index maxPlanes)
{
  return Proposer(geometry).Run(joins, maxPlanes);
}
}
