// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/RegisterCrossings.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
void GridCrossings::Resize(std::size_t count)
{
  this->Edge.resize(count);
  this->Position.resize(count);
  this->Direction.resize(count);
  this->Family.resize(count);
  for (std::vector<Index>* array : { &this->Next, &this->Previous, &this->RunContour,
         &this->RunFirst, &this->RunCount, &this->RunNext, &this->ArcLastRun })
  {
    array->resize(count);
  }
}

Index GridCrossings::Insert(std::uint64_t edge, double position, int direction, int family)
{
  const Index c = this->Count();
  this->Resize(static_cast<std::size_t>(c) + 1);
  this->Edge[c] = edge;
  this->Position[c] = position;
  this->Direction[c] = static_cast<std::int8_t>(direction);
  this->Family[c] = static_cast<std::int8_t>(family);
  this->RunContour[c] = None;
  this->RunFirst[c] = 0;
  this->RunCount[c] = 0;
  this->RunNext[c] = None;
  this->ArcLastRun[c] = c;
  return c;
}

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A place at which a contour crosses a plane of one of its slice's two axes, u and v.
struct PlaneCrossing
{
  Index Vertex;    ///< of the contour, before the crossing
  bool CrossesU;   ///< whether the plane is one of constant u
  Index Plane;     ///< its number
  int Direction;   ///< 1 to the plane's upper side, -1 to its lower side
  Index Slab;      ///< of the other axis, in which the contour is
  double Position; ///< along the other axis, within that slab
};

/// One contour's walk through the faces of its slice, with the planes of its two in-plane axes.
class ContourWalk
{
public:
  ContourWalk(const Contours& contours, Index contour, const SpatialGrid& grid)
    : Set(contours)
    , Begin(contours.Offsets[contour])
    , End(contours.Offsets[contour + 1])
    , Grid(grid)
    , Axis(contours.Axis[contour])
    , U(grid.Planes[FirstAxis(contours.Axis[contour])])
    , V(grid.Planes[SecondAxis(contours.Axis[contour])])
  {
  }

  /// Calls visit(PlaneCrossing) for each crossing, in the order of the contour.
  template <typename Visit>
  void Run(Visit&& visit);

private:
  static bool Inside(const std::vector<double>& planes, Index slab, double x)
  {
    return (slab == 0 || planes[slab - 1] <= x) &&
      (slab == static_cast<Index>(planes.size()) || x < planes[slab]);
  }

  template <typename Visit>
  void CrossSegment(Index vertex, Index next, Visit&& visit);

  /// Parameter along the segment at which the next plane of an axis is crossed.
  static double NextParameter(
    const std::vector<double>& planes, Index slab, Index target, double from, double to)
  {
    if (slab == target)
    {
      return Infinity;
    }
    return (planes[target > slab ? slab : slab - 1] - from) / (to - from);
  }

  const Contours& Set;
  Index Begin, End;
  const SpatialGrid& Grid;
  int Axis;
  const std::vector<double>& U;
  const std::vector<double>& V;
  Index SlabU = 0, SlabV = 0;
};

template <typename Visit>
void ContourWalk::Run(Visit&& visit)
{
  this->SlabU = this->Grid.Slab(FirstAxis(this->Axis), this->Set.U[this->Begin]);
  this->SlabV = this->Grid.Slab(SecondAxis(this->Axis), this->Set.V[this->Begin]);
  for (Index i = this->Begin; i < this->End; ++i)
  {
    const Index next = i + 1 < this->End ? i + 1 : this->Begin;
    if (!Inside(this->U, this->SlabU, this->Set.U[next]) ||
      !Inside(this->V, this->SlabV, this->Set.V[next]))
    {
      this->CrossSegment(i, next, visit);
    }
  }
}

double Interpolate(double from, double to, double t)
{
  return t <= 0.0 ? from : t >= 1.0 ? to : from + t * (to - from);
}
}

double InterpolateFromLesser(double plane, const Point2& p, const Point2& q)
{
  const Point2 &from = p < q ? p : q, &to = p < q ? q : p;
  return Interpolate(from[1], to[1], (plane - from[0]) / (to[0] - from[0]));
}

namespace
{
template <typename Visit>
void ContourWalk::CrossSegment(Index vertex, Index next, Visit&& visit)
{
  const double u0 = this->Set.U[vertex], u1 = this->Set.U[next];
  const double v0 = this->Set.V[vertex], v1 = this->Set.V[next];
  const Index targetU = this->Grid.Slab(FirstAxis(this->Axis), u1);
  const Index targetV = this->Grid.Slab(SecondAxis(this->Axis), v1);
  // Through a vertex of M: the axis with the larger infinitesimal decides.
  const bool uLarger = FirstAxis(this->Axis) < SecondAxis(this->Axis);
  const bool uFirstInTie = uLarger ? u1 > u0 : v1 < v0;
  while (this->SlabU != targetU || this->SlabV != targetV)
  {
    const double tu = NextParameter(this->U, this->SlabU, targetU, u0, u1);
    const double tv = NextParameter(this->V, this->SlabV, targetV, v0, v1);
    if (tu < tv || (tu == tv && uFirstInTie))
    {
      const int direction = targetU > this->SlabU ? 1 : -1;
      const Index plane = direction > 0 ? this->SlabU : this->SlabU - 1;
      visit(PlaneCrossing{ vertex, true, plane, direction, this->SlabV,
        this->Grid.Clamp(SecondAxis(this->Axis), this->SlabV,
          this->Grid.BothWays ? InterpolateFromLesser(this->U[plane], { u0, v0 }, { u1, v1 })
                              : Interpolate(v0, v1, tu)) });
      this->SlabU += direction;
    }
    else
    {
      const int direction = targetV > this->SlabV ? 1 : -1;
      const Index plane = direction > 0 ? this->SlabV : this->SlabV - 1;
      visit(PlaneCrossing{ vertex, false, plane, direction, this->SlabU,
        this->Grid.Clamp(FirstAxis(this->Axis), this->SlabU,
          this->Grid.BothWays ? InterpolateFromLesser(this->V[plane], { v0, u0 }, { v1, u1 })
                              : Interpolate(u0, u1, tv)) });
      this->SlabV += direction;
    }
  }
}

/// Writes the places of one contour's crossings, from number `first` on.
void WriteCrossings(const Contours& contours, Index contour, const SpatialGrid& grid, Index first,
  GridCrossings& crossings)
{
  const GridEdgeCode code(grid);
  const int axis = contours.Axis[contour];
  const Index slice = contours.Plane[contour];
  const Index begin = contours.Offsets[contour];
  const Index size = contours.Size(contour);
  Index c = first;
  ContourWalk(contours, contour, grid)
    .Run(
      [&](const PlaneCrossing& crossed)
      {
        // Across a u-plane the grid line runs along v, whose first axis is that of the slice.
        const GridEdge edge = crossed.CrossesU
          ? GridEdge{ SecondAxis(axis), slice, crossed.Plane, crossed.Slab }
          : GridEdge{ FirstAxis(axis), crossed.Plane, slice, crossed.Slab };
        crossings.Edge[c] = code.Encode(edge);
        crossings.Position[c] = crossed.Position;
        crossings.Direction[c] = static_cast<std::int8_t>(crossed.Direction);
        crossings.Family[c] = crossed.CrossesU ? 0 : 1;
        crossings.RunFirst[c] = crossed.Vertex + 1 < begin + size ? crossed.Vertex + 1 : begin;
        ++c;
      });
}

/// Links the crossings [first, last) of one contour, and gives each the run of vertices after it.
void LinkCrossings(
  const Contours& contours, Index contour, Index first, Index last, GridCrossings& crossings)
{
  const Index begin = contours.Offsets[contour];
  const Index size = contours.Size(contour);
  for (Index c = first; c < last; ++c)
  {
    const Index next = c + 1 < last ? c + 1 : first;
    crossings.Next[c] = next;
    crossings.Previous[next] = c;
    crossings.RunContour[c] = contour;
    crossings.RunNext[c] = GridCrossings::None;
    crossings.ArcLastRun[c] = c;
    const auto segment = [&](Index i)
    { return crossings.RunFirst[i] == begin ? begin + size - 1 : crossings.RunFirst[i] - 1; };
    crossings.RunCount[c] = segment(next) - segment(c) + (next == first ? size : 0);
  }
}
}

GridCrossings RegisterCrossings(const Contours& contours, const SpatialGrid& grid,
  const Execution& execution, std::vector<IsolatedLoop>& isolated)
{
  const std::size_t count = contours.Count();
  std::vector<Index> offsets(count + 1, 0);
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        ContourWalk(contours, static_cast<Index>(i), grid)
          .Run([&](const PlaneCrossing&) { ++offsets[i + 1]; });
      }
    });
  for (std::size_t i = 0; i < count; ++i)
  {
    if (offsets[i + 1] == 0)
    {
      isolated.push_back({ GridCrossings::None, static_cast<Index>(i) });
    }
    offsets[i + 1] += offsets[i];
  }
  GridCrossings crossings;
  crossings.Resize(offsets.back());
  execution.For(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index contour = static_cast<Index>(i);
        WriteCrossings(contours, contour, grid, offsets[i], crossings);
        LinkCrossings(contours, contour, offsets[i], offsets[i + 1], crossings);
      }
    });
  return crossings;
}

EdgeRegister FileOnEdges(const GridCrossings& crossings)
{
  struct Entry
  {
    std::uint64_t EdgeAndFamily;
    double Position;
    Index Crossing;
  };
  std::vector<Entry> entries;
  entries.reserve(crossings.Count());
  for (Index c = 0; c < crossings.Count(); ++c)
  {
    if (!crossings.IsRemoved(c))
    {
      entries.push_back({ 2 * crossings.Edge[c] + crossings.Family[c], crossings.Position[c], c });
    }
  }
  std::sort(entries.begin(), entries.end(),
    [](const Entry& a, const Entry& b)
    {
      return a.EdgeAndFamily != b.EdgeAndFamily ? a.EdgeAndFamily < b.EdgeAndFamily
        : a.Position != b.Position              ? a.Position < b.Position
                                                : a.Crossing < b.Crossing;
    });
  EdgeRegister filed;
  filed.Crossing.reserve(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (i > 0 && entries[i].EdgeAndFamily / 2 != entries[i - 1].EdgeAndFamily / 2)
    {
      filed.Offsets.push_back(static_cast<Index>(i));
    }
    filed.Crossing.push_back(entries[i].Crossing);
  }
  if (!entries.empty())
  {
    filed.Offsets.push_back(static_cast<Index>(entries.size()));
  }
  return filed;
}

Point3 CrossingPoint(
  const SpatialGrid& grid, const GridEdgeCode& code, std::uint64_t edge, double position)
{
  const GridEdge place = code.Decode(edge);
  Point3 point;
  point[place.Direction] = position;
  point[FirstAxis(place.Direction)] = grid.Planes[FirstAxis(place.Direction)][place.First];
  point[SecondAxis(place.Direction)] = grid.Planes[SecondAxis(place.Direction)][place.Second];
  return point;
}
}
