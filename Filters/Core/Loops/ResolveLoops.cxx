// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/ResolveLoops.h"

#include "Core/Base/Box.h"
#include "Core/Base/EditContours.h"
#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Core/Loops/LoopMeetings.h"
#include "Core/Loops/LoopRegions.h"
#include "Core/Loops/SlightMeetings.h"
#include "Core/Loops/TraceRegion.h"
#include "Core/Slices/OrientContours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Loops that are thinner (twice their area by their length), as a share of the extent of their
/// slice, are what rounding leaves between contours that should run along each other.
constexpr double LeastThickness = 1e-4;

/// Where the interior is.
enum class LoopSide
{
  Surrounded, ///< whatever the directions of the loops are
  Left,       ///< of the loops as drawn
  InsideOut   ///< the same, where all loops together run clockwise: they bound the outside
};

/// What becomes of the contours of one slice.
struct ResolvedSlice
{
  bool IsResolved = false;
  Contours Loops;
  std::vector<Problem> Mended;
};

class SliceResolver
{
public:
  SliceResolver(const Contours& contours, const std::vector<Index>& members)
    : Set(contours)
    , Members(members)
  {
  }

  ResolvedSlice Run(LoopRule rule, LoopSide side, bool partTouching);

private:
  std::vector<std::vector<Point2>> ReadPolygons() const;
  void FindLoneWalks(const PlaneWalks& walks, const PlaneFaces& faces);
  void AddLoops(const PlaneFaces& faces, std::vector<TracedLoop>& loops);
  void AddLoop(Index contour, const std::vector<Point2>& points);
  bool IsThin(const std::vector<Point2>& points) const;
  void ReportSlight(const std::vector<LoopMeeting>& meetings);
  void ReportMeetings(const std::vector<LoopMeeting>& meetings);
  void ReportWalks(
    const PlaneWalks& walks, const PlaneFaces& faces, const std::vector<LoopMeeting>& meetings);
  void Report(ProblemKind kind, Index contour, const Point2& where, double size, bool isLeftOut);

  const Contours& Set;
  const std::vector<Index>& Members;
  std::vector<std::vector<Point2>> Polygons;
  double Extent = 0.0;
  /// Of each walk: whether it is a simple polygon that no other one meets, with the polygon's
  /// corners.
  std::vector<std::uint8_t> IsLone;
  ResolvedSlice Result;
};

std::vector<std::vector<Point2>> SliceResolver::ReadPolygons() const
{
  std::vector<std::vector<Point2>> polygons;
  for (const Index contour : this->Members)
  {
    polygons.emplace_back();
    for (Index i = this->Set.Offsets[contour]; i < this->Set.Offsets[contour + 1]; ++i)
    {
      polygons.back().push_back({ this->Set.U[i], this->Set.V[i] });
    }
  }
  return polygons;
}

void SliceResolver::FindLoneWalks(const PlaneWalks& walks, const PlaneFaces& faces)
{
  // Edges that no other walk passes, and of which the nodes have no others.
  std::vector<std::size_t> ownEdges(walks.Walks.size(), 0);
  for (Index edge = 0; edge < faces.CountHalfEdges() / 2; ++edge)
  {
    const Index first = faces.FirstPassage(edge);
    const bool isOwn = faces.EndOfPassages(edge) - first == 1 &&
      faces.Leaving(faces.Head(2 * edge)).size() == 2 &&
      faces.Leaving(faces.Tail(2 * edge)).size() == 2;
    ownEdges[faces.PassageAt(first).Walk] += isOwn ? 1 : 0;
  }
  this->IsLone.resize(walks.Walks.size());
  for (std::size_t i = 0; i < walks.Walks.size(); ++i)
  {
    const std::size_t corners = this->Polygons[i].size();
    this->IsLone[i] = corners == walks.Walks[i].size() && corners == ownEdges[i];
  }
}

void SliceResolver::AddLoop(Index contour, const std::vector<Point2>& points)
{
  Contours& loops = this->Result.Loops;
  for (const Point2& p : points)
  {
    const bool isNew = static_cast<Index>(loops.U.size()) == loops.Offsets.back() ||
      loops.U.back() != p[0] || loops.V.back() != p[1];
    if (isNew)
    {
      loops.U.push_back(p[0]);
      loops.V.push_back(p[1]);
    }
  }
  loops.Offsets.push_back(static_cast<Index>(loops.U.size()));
  loops.Axis.push_back(this->Set.Axis[contour]);
  loops.Coordinate.push_back(this->Set.Coordinate[contour]);
  loops.Plane.push_back(this->Set.Plane[contour]);
  loops.Cell.push_back(this->Set.Cell[contour]);
}

bool SliceResolver::IsThin(const std::vector<Point2>& points) const
{
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    length += Distance(points[i], points[(i + 1) % points.size()]);
  }
  return 2.0 * std::abs(SignedArea(points)) <= LeastThickness * this->Extent * length;
}

void SliceResolver::AddLoops(const PlaneFaces& faces, std::vector<TracedLoop>& loops)
{
  std::stable_sort(loops.begin(), loops.end(),
    [](const TracedLoop& a, const TracedLoop& b) { return a.Walk < b.Walk; });
  for (const TracedLoop& loop : loops)
  {
    const Index contour = this->Members[loop.Walk];
    if (!this->IsLone[loop.Walk])
    {
      if (!this->IsThin(loop.Points))
      {
        this->AddLoop(contour, loop.Points);
      }
      continue;
    }
    std::vector<Point2> polygon = this->Polygons[loop.Walk];
    const Index halfEdge = loop.HalfEdges[0];
    const Index net = faces.PassageAt(faces.FirstPassage(halfEdge / 2)).Net;
    if ((net > 0) != (halfEdge % 2 == 0))
    {
      std::reverse(polygon.begin(), polygon.end());
    }
    this->AddLoop(contour, polygon);
  }
}

void SliceResolver::Report(
  ProblemKind kind, Index contour, const Point2& where, double size, bool isLeftOut)
{
  const int axis = this->Set.Axis[contour];
  Problem problem{ kind, axis, this->Set.Cell[contour], {}, size, isLeftOut };
  problem.Where[axis] = this->Set.Coordinate[contour];
  problem.Where[FirstAxis(axis)] = where[0];
  problem.Where[SecondAxis(axis)] = where[1];
  this->Result.Mended.push_back(problem);
}

/// Each contour that meets others once.
void SliceResolver::ReportMeetings(const std::vector<LoopMeeting>& meetings)
{
  std::vector<std::uint8_t> isKnown(this->Members.size(), 0);
  for (const LoopMeeting& meeting : meetings)
  {
    for (const Index contour : { meeting.Contour, meeting.Other })
    {
      const std::size_t member =
        std::lower_bound(this->Members.begin(), this->Members.end(), contour) -
        this->Members.begin();
      if (meeting.Contour != meeting.Other && !meeting.IsTouch && !isKnown[member])
      {
        isKnown[member] = 1;
        this->Report(ProblemKind::LoopsUnited, contour, meeting.Where, 0.0, false);
      }
    }
  }
}

/// Of the contours that cross themselves, and of pairs that cross, each later one.
void SliceResolver::ReportSlight(const std::vector<LoopMeeting>& meetings)
{
  for (const LoopMeeting& meeting : meetings)
  {
    const bool isOne = meeting.Contour == meeting.Other;
    this->Report(isOne ? ProblemKind::CrossesItself : ProblemKind::CrossesOther, meeting.Other,
      meeting.Where, 0.0, false);
  }
}

/// Walks that meet themselves: with bridges, or without.
void SliceResolver::ReportWalks(
  const PlaneWalks& walks, const PlaneFaces& faces, const std::vector<LoopMeeting>& meetings)
{
  std::vector<double> bridges(walks.Walks.size(), 0.0);
  for (Index edge = 0; edge < faces.CountHalfEdges() / 2; ++edge)
  {
    for (Index i = faces.FirstPassage(edge); i < faces.EndOfPassages(edge); ++i)
    {
      if (faces.PassageAt(i).Net == 0)
      {
        bridges[faces.PassageAt(i).Walk] +=
          Distance(walks.Nodes[faces.Tail(2 * edge)], walks.Nodes[faces.Head(2 * edge)]);
      }
    }
  }
  for (const LoopMeeting& meeting : meetings)
  {
    if (meeting.Contour == meeting.Other)
    {
      const std::size_t walk =
        std::lower_bound(this->Members.begin(), this->Members.end(), meeting.Contour) -
        this->Members.begin();
      this->Report(bridges[walk] > 0.0 ? ProblemKind::BridgeRemoved : ProblemKind::LoopSplit,
        meeting.Contour, meeting.Where, bridges[walk], false);
    }
  }
}

ResolvedSlice SliceResolver::Run(LoopRule rule, LoopSide side, bool partTouching)
{
  std::vector<LoopMeeting> meetings = FindLoopMeetings(this->Set, this->Members);
  const auto isTouch = [](const LoopMeeting& meeting) { return meeting.IsTouch; };
  const bool doAnyCross = !std::all_of(meetings.begin(), meetings.end(), isTouch);
  const bool isNested = rule == LoopRule::NonZero && this->Members.size() > 1;
  const auto leaveOutTouches = [&]
  { meetings.erase(std::remove_if(meetings.begin(), meetings.end(), isTouch), meetings.end()); };
  if (!partTouching)
  {
    leaveOutTouches();
  }
  if (meetings.empty() && !isNested)
  {
    return {};
  }
  this->Polygons = this->ReadPolygons();
  PlaneWalks walks;
  if (!SplitPolygons(this->Polygons, walks))
  {
    return {};
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto range = std::minmax_element(walks.Nodes.begin(), walks.Nodes.end(),
      [axis](const Point2& a, const Point2& b) { return a[axis] < b[axis]; });
    this->Extent = std::max(this->Extent, (*range.second)[axis] - (*range.first)[axis]);
  }
  const PlaneFaces faces(walks);
  const LoopWindings windings(walks, faces);
  const bool doTouch = partTouching && (!doAnyCross || !DoLoopsCross(windings));
  if (rule == LoopRule::Union && !doTouch && AreMeetingsSlight(windings))
  {
    leaveOutTouches();
    this->ReportSlight(meetings);
    return std::move(this->Result);
  }
  const LoopRegions regions(windings);
  std::vector<TracedLoop> loops = TraceRegion(walks, faces,
    side == LoopSide::Surrounded ? regions.FindInside(rule)
                                 : regions.FindInsideAsDrawn(rule, side == LoopSide::InsideOut));
  this->FindLoneWalks(walks, faces);
  this->AddLoops(faces, loops);
  this->ReportMeetings(meetings);
  this->ReportWalks(walks, faces, meetings);
  this->Result.IsResolved = true;
  return std::move(this->Result);
}
}

namespace
{
/// Vertices of a slice that only rounding has parted, by 2^-40 of its extent, become one place: else
/// loops that are meant to touch there would be too close to each other for what follows.
void UniteVertices(const std::vector<Index>& members, Contours& contours)
{
  struct Vertex
  {
    double Column; ///< in which columns of the plane, as wide as the distance
    double V;
    Index Contour, Number;
  };
  std::vector<Vertex> vertices;
  Box3 box;
  double largest = 0.0;
  for (const Index contour : members)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      vertices.push_back({ 0.0, contours.V[i], contour, i });
      box.Add(Point3{ contours.U[i], contours.V[i], 0.0 });
      largest = std::max({ largest, std::abs(contours.U[i]), std::abs(contours.V[i]) });
    }
  }
  const double distance = std::max(
    std::ldexp(box.Diagonal(), -40), 8.0 * std::numeric_limits<double>::epsilon() * largest);
  for (Vertex& vertex : vertices)
  {
    vertex.Column = std::nearbyint(contours.U[vertex.Number] / distance);
  }
  std::sort(vertices.begin(), vertices.end(),
    [](const Vertex& a, const Vertex& b)
    {
      return a.Column != b.Column ? a.Column < b.Column
        : a.V != b.V              ? a.V < b.V
                                  : a.Number < b.Number;
    });
  for (std::size_t i = 1; i < vertices.size(); ++i)
  {
    const Vertex& to = vertices[i - 1];
    const Vertex& from = vertices[i];
    const Index apart = std::abs(to.Number - from.Number);
    const bool areNeighbours =
      to.Contour == from.Contour && (apart == 1 || apart + 1 == contours.Size(to.Contour));
    if (to.Column == from.Column && !areNeighbours &&
      contours.V[from.Number] - contours.V[to.Number] <= distance)
    {
      contours.U[from.Number] = contours.U[to.Number];
      contours.V[from.Number] = contours.V[to.Number];
    }
  }
}
}

Index ResolveLoops(LoopRule rule, bool asDrawn, bool partTouching, const Execution& execution,
  Contours& contours, std::vector<Problem>& mended)
{
  const std::vector<std::vector<Index>> slices = GroupBySlice(contours);
  const LoopSide side = !asDrawn ? LoopSide::Surrounded
    : BoundOutside(contours)     ? LoopSide::InsideOut
                                 : LoopSide::Left;
  std::vector<ResolvedSlice> resolved(slices.size());
  execution.For(slices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        std::vector<Index> members;
        std::copy_if(slices[i].begin(), slices[i].end(), std::back_inserter(members),
          [&](Index contour) { return !contours.IsVirtual(contour); });
        if (partTouching)
        {
          UniteVertices(members, contours);
        }
        resolved[i] = SliceResolver(contours, members).Run(rule, side, partTouching);
      }
    });
  std::vector<std::uint8_t> isReplaced(contours.Count(), 0);
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    for (const Index contour : slices[i])
    {
      isReplaced[contour] = resolved[i].IsResolved;
    }
    mended.insert(mended.end(), resolved[i].Mended.begin(), resolved[i].Mended.end());
  }
  if (std::find(isReplaced.begin(), isReplaced.end(), 1) != isReplaced.end())
  {
    RemoveMarked(isReplaced, contours);
  }
  const Index first = contours.Count();
  for (const ResolvedSlice& slice : resolved)
  {
    AppendContours(slice.Loops, contours);
  }
  return first;
}
}
