// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/EndRims.h"

#include "Core/Base/TriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orthoslices
{
namespace
{
/// So much of a guide's way, seen along the stack, has to keep its level: corners may be rounded.
/// Of a dome like a parabola, less than that is within a fifth of its height from the top.
constexpr double LevelShare = 0.5;
constexpr double LevelDepth = 0.2;
/// A corner of a rim is at most so much farther out than its sides.
constexpr double MaxMitre = 2.0;

/// A place on a loop.
struct LoopPlace
{
  Index Loop = -1;
  Index Side = -1; ///< from which point of the loop to the next
  double Along = 0.0;
};

/// What a piece shows that does not go on to another slice.
struct PieceEnd
{
  double Height = 0.0;             ///< its greatest distance from the slice
  std::size_t First = 0, Last = 0; ///< points on the level that it keeps; the same if it keeps none
  LoopPlace AtStart, AtEnd;        ///< of no loop where it begins or ends at another guide
};

class LoopEndFinder
{
public:
  LoopEndFinder(const NodeGraph& graph, const GuideCurves& guides)
    : Graph(graph)
    , Guides(guides)
    , Flat(FlatShare * guides.Spacing())
    , Ends(2 * graph.Loops.size())
  {
  }

  PieceEnd Look(const GuidePiece& piece) const;
  std::vector<LoopEnd> Run();

private:
  LoopPlace FindPlace(Index plane, const Point3& point) const;
  double Rise(const GuidePiece& piece, const Point3& point) const;
  void FindLevel(const GuidePiece& piece, PieceEnd& end) const;
  void Note(const GuidePiece& piece);

  const NodeGraph& Graph;
  const GuideCurves& Guides;
  const double Flat;
  std::vector<LoopEnd> Ends;
};

/// The nearest place to a point on a plane; of no loop if there is no plane.
LoopPlace LoopEndFinder::FindPlace(Index plane, const Point3& point) const
{
  double least = std::numeric_limits<double>::infinity();
  LoopPlace found;
  for (Index loop = 0; loop < static_cast<Index>(this->Graph.Loops.size()); ++loop)
  {
    if (this->Graph.Loops[loop].Plane != plane)
    {
      continue;
    }
    const Index arc = this->Graph.Arcs + loop, count = this->Graph.PointCount(arc);
    double along = 0.0;
    for (Index i = 0; i < count; ++i)
    {
      const Point3 p = this->Graph.PointAt(this->Graph.FirstPoint(arc) + i);
      const Point3 q = this->Graph.PointAt(this->Graph.FirstPoint(arc) + (i + 1) % count);
      const double distance = SquaredDistanceToSegment(point, p, q);
      if (distance < least)
      {
        least = distance;
        found = { loop, i, along + std::min(Length(point - p), Length(q - p)) };
      }
      along += Length(q - p);
    }
  }
  return found;
}

/// The unit vector at right angles to a side within the slice, away from the interior on its left.
Point3 OutwardsOf(const NodeGraph& graph, Index loop, Index side)
{
  const Index arc = graph.Arcs + loop, first = graph.FirstPoint(arc);
  const Index count = graph.PointCount(arc);
  Point3 axis{};
  axis[graph.Loops[loop].Axis] = 1.0;
  return Unit(Cross(graph.PointAt(first + (side + 1) % count) - graph.PointAt(first + side), axis));
}

/// The plane on which a piece begins and ends; the only one, if at one end it meets another guide;
/// -1 if it goes from one plane to another, or from guide to guide.
Index PlaneOf(const GuidePiece& piece)
{
  const auto& [from, to] = piece.Planes;
  return from < 0 || to < 0 || from == to ? std::max(from, to) : -1;
}

/// How far a point is from the plane of its piece. REQUIRES: there is one.
double LoopEndFinder::Rise(const GuidePiece& piece, const Point3& point) const
{
  const Index plane = PlaneOf(piece);
  const double above = point[this->Guides.StackAxis] - this->Guides.StackPlanes[plane];
  return piece.Slab > plane ? above : -above;
}

/// Finds the first and the last point of a piece on the level of its greatest height, if most of it
/// is there.
void LoopEndFinder::FindLevel(const GuidePiece& piece, PieceEnd& end) const
{
  const auto& points = piece.Points;
  std::size_t first = points.size(), last = 0;
  double all = 0.0, level = 0.0;
  const double depth = std::min(this->Flat, LevelDepth * end.Height);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const bool isLevel = this->Rise(piece, points[i]) >= end.Height - depth;
    Point3 way = i > 0 ? points[i] - points[i - 1] : Point3{};
    way[this->Guides.StackAxis] = 0.0;
    all += Length(way);
    level += isLevel && first < i && last + 1 == i ? Length(way) : 0.0;
    first = isLevel ? std::min(first, i) : first;
    last = isLevel ? i : last;
  }
  if (level > LevelShare * all)
  {
    end.First = first;
    end.Last = last;
  }
}

PieceEnd LoopEndFinder::Look(const GuidePiece& piece) const
{
  PieceEnd end;
  for (const Point3& point : piece.Points)
  {
    end.Height = std::max(end.Height, this->Rise(piece, point));
  }
  this->FindLevel(piece, end);
  end.AtStart = this->FindPlace(piece.Planes[0], piece.Points.front());
  end.AtEnd = this->FindPlace(piece.Planes[1], piece.Points.back());
  return end;
}

/// Notes what a piece says to the loops at its ends.
void LoopEndFinder::Note(const GuidePiece& piece)
{
  const PieceEnd end = this->Look(piece);
  for (const bool atStart : { true, false })
  {
    const LoopPlace& place = atStart ? end.AtStart : end.AtEnd;
    if (place.Loop < 0)
    {
      continue;
    }
    const Point3& corner = piece.Points[atStart ? end.First : end.Last];
    const Point3 way = corner - (atStart ? piece.Points.front() : piece.Points.back());
    const double outwards = Dot(way, OutwardsOf(this->Graph, place.Loop, place.Side));
    const double upwards = this->Rise(piece, corner);
    const bool isRim = end.First < end.Last && std::abs(outwards) <= upwards;
    LoopEnd& known = this->Ends[2 * place.Loop + (piece.Slab > PlaneOf(piece) ? 1 : 0)];
    known.Kind = CombineEnds(
      known.Kind, end.Height < this->Flat ? EndKind::Flat : (isRim ? EndKind::Rim : EndKind::Dome));
    known.Height = std::max(known.Height, end.Height);
    known.Anchors.push_back({ place.Along, outwards, upwards });
  }
}

std::vector<LoopEnd> LoopEndFinder::Run()
{
  for (const GuideSlice& slice : this->Guides.Slices)
  {
    for (const GuidePiece& piece : slice.Pieces)
    {
      if (PlaneOf(piece) >= 0)
      {
        this->Note(piece);
      }
    }
  }
  for (LoopEnd& end : this->Ends)
  {
    std::stable_sort(end.Anchors.begin(), end.Anchors.end(),
      [](const RimAnchor& a, const RimAnchor& b) { return a.Place < b.Place; });
  }
  return std::move(this->Ends);
}

/// Appends the parts of a piece between these points, from its start to its end.
void AppendCut(
  const GuidePiece& piece, const std::vector<std::size_t>& at, std::vector<GuidePiece>& parts)
{
  const auto begin = piece.Points.begin();
  std::size_t from = 0;
  for (const std::size_t to : at)
  {
    if (from < to)
    {
      parts.push_back({ { begin + static_cast<std::ptrdiff_t>(from),
                          begin + static_cast<std::ptrdiff_t>(to) + 1 },
        piece.Slab, {} });
      from = to;
    }
  }
}

/// Between the anchors before and after a place on a loop of this length.
RimAnchor InterpolateAnchors(const std::vector<RimAnchor>& anchors, double place, double length)
{
  const auto after = std::find_if(
    anchors.begin(), anchors.end(), [&](const RimAnchor& at) { return at.Place > place; });
  const RimAnchor& high = after == anchors.end() ? anchors.front() : *after;
  const RimAnchor& low = after == anchors.begin() ? anchors.back() : *(after - 1);
  double way = high.Place - low.Place, from = place - low.Place;
  way += way <= 0.0 ? length : 0.0;
  from += from < 0.0 ? length : 0.0;
  const double share = from / way;
  return { place, low.Outwards + share * (high.Outwards - low.Outwards),
    low.Upwards + share * (high.Upwards - low.Upwards) };
}
}

std::vector<LoopEnd> FindLoopEnds(const NodeGraph& graph, const GuideCurves& guides)
{
  return LoopEndFinder(graph, guides).Run();
}

void CutAtRims(const NodeGraph& graph, const std::vector<LoopEnd>& ends, GuideCurves& guides)
{
  const LoopEndFinder finder(graph, guides);
  for (GuideSlice& slice : guides.Slices)
  {
    std::vector<GuidePiece> parts;
    for (const GuidePiece& piece : slice.Pieces)
    {
      std::vector<std::size_t> at;
      if (PlaneOf(piece) >= 0)
      {
        const PieceEnd end = finder.Look(piece);
        const Index side = piece.Slab > PlaneOf(piece) ? 1 : 0;
        for (const auto& [place, corner] :
          { std::pair(end.AtStart, end.First), std::pair(end.AtEnd, end.Last) })
        {
          if (place.Loop >= 0 && ends[2 * place.Loop + side].Kind == EndKind::Rim)
          {
            at.push_back(corner);
          }
        }
      }
      at.push_back(piece.Points.size() - 1);
      AppendCut(piece, at, parts);
    }
    slice.Pieces.swap(parts);
  }
}

EndKind CombineEnds(EndKind one, EndKind other)
{
  if (one == EndKind::Unknown || other == EndKind::Unknown)
  {
    return one == EndKind::Unknown ? other : one;
  }
  return one == other ? one : EndKind::Dome;
}

std::vector<Point3> PlaceRim(
  const NodeGraph& graph, Index loop, double up, const std::vector<RimAnchor>& anchors)
{
  const Index arc = graph.Arcs + loop, first = graph.FirstPoint(arc);
  const Index count = graph.PointCount(arc);
  std::vector<double> places{ 0.0 };
  for (Index i = 0; i < count; ++i)
  {
    const Point3 side = graph.PointAt(first + (i + 1) % count) - graph.PointAt(first + i);
    places.push_back(places.back() + Length(side));
  }
  std::vector<Point3> rim;
  for (Index i = 0; i < count; ++i)
  {
    const Point3 before = OutwardsOf(graph, loop, (i + count - 1) % count);
    const Point3 after = OutwardsOf(graph, loop, i);
    const double mitre = std::min(MaxMitre, 2.0 / std::max(1.0 + Dot(before, after), 0.1));
    const Point3 outwards = 0.5 * mitre * (before + after);
    const RimAnchor at = InterpolateAnchors(anchors, places[i], places.back());
    Point3 point = graph.PointAt(first + i) + at.Outwards * outwards;
    point[graph.Loops[loop].Axis] += up * at.Upwards;
    rim.push_back(point);
  }
  return rim;
}

Box3 BoxOf(const GuideCurves& guides)
{
  Box3 box;
  for (const GuideSlice& slice : guides.Slices)
  {
    for (const GuidePiece& piece : slice.Pieces)
    {
      for (const Point3& point : piece.Points)
      {
        box.Add(point);
      }
    }
  }
  return box;
}
}
