// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/StitchSlabs.h"

#include "Core/Base/Vectors.h"
#include "Core/Planar/UncrossCurves.h"
#include "Core/Slabs/OverlaySlab.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace orthoslices
{
namespace
{
/// The cycle of a loop below its slice, or above.
Index CycleOf(const CellCycles& cycles, const NodeGraph& graph, Index loop, bool above)
{
  return cycles.Count() - 2 * static_cast<Index>(graph.Loops.size()) + 2 * loop + (above ? 1 : 0);
}

std::vector<Point2> PolygonOf(const NodeGraph& graph, Index loop)
{
  const int axis = graph.Loops[loop].Axis;
  const Index arc = graph.Arcs + loop;
  std::vector<Point2> polygon;
  for (Index i = 0; i < graph.PointCount(arc); ++i)
  {
    const Point3 p = graph.PointAt(graph.FirstPoint(arc) + i);
    polygon.push_back({ p[FirstAxis(axis)], p[SecondAxis(axis)] });
  }
  return polygon;
}

/// The loops across an axis as a stack, and their numbers.
ContourStack StackOf(const CycleGeometry& geometry, int axis, std::vector<Index>& loops)
{
  ContourStack stack;
  stack.Coordinate = geometry.Grid.Planes[axis];
  for (std::size_t loop = 0; loop < geometry.Graph.Loops.size(); ++loop)
  {
    if (geometry.Graph.Loops[loop].Axis == axis)
    {
      loops.push_back(static_cast<Index>(loop));
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
    [&](Index a, Index b)
    { return geometry.Graph.Loops[a].Plane < geometry.Graph.Loops[b].Plane; });
  for (const Index loop : loops)
  {
    for (const Point2& p : PolygonOf(geometry.Graph, loop))
    {
      stack.U.push_back(p[0]);
      stack.V.push_back(p[1]);
    }
    stack.Offsets.push_back(static_cast<Index>(stack.U.size()));
    stack.Slice.push_back(geometry.Graph.Loops[loop].Plane);
  }
  return stack;
}
}

std::vector<LoopPair> PairLoops(
  const CycleGeometry& geometry, CorrespondenceCriterion criterion, const PriorKnowledge& known)
{
  std::vector<LoopPair> pairs;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Index> loops;
    const ContourStack stack = StackOf(geometry, axis, loops);
    for (const Correspondence& match : FindCorrespondences(criterion, stack, known))
    {
      const auto cycle = [&](Index contour, bool above)
      { return CycleOf(geometry.Cycles, geometry.Graph, loops[contour], above); };
      const Index a = cycle(match.First, match.Where != Passage::Below);
      const Index b = cycle(match.Second, match.Where == Passage::Above);
      if (geometry.Cycles.Cell[a] == geometry.Cycles.Cell[b])
      {
        pairs.push_back({ std::min(a, b), std::max(a, b) });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(),
    [](const LoopPair& a, const LoopPair& b)
    { return std::tie(a.First, a.Second) < std::tie(b.First, b.Second); });
  return pairs;
}

namespace
{
/// Loops that are overlaid together, and the outcome.
struct SlabGroup
{
  Index Slab;
  std::vector<Index> Loops; ///< of G
  std::vector<SlabLoop> Outlines;
  Point2 Shift{ 0.0, 0.0 };
  SlabOverlay Overlay;
};

/// A new vertex of a loop of G.
struct NewVertex
{
  Index After;
  double Share;
  std::size_t Group;
  Index Insertion; ///< of that group's overlay
};

/// Where the vertices of a loop are now.
struct LoopPlaces
{
  std::vector<Index> OfVertex;
  Index Count = 0;
};

class PatchMaker;

class SlabStitcher
{
public:
  SlabStitcher(const SpatialGrid& grid, const CellCycles& cycles, int axis, NodeGraph& graph)
    : Grid(grid)
    , Cycles(cycles)
    , Axis(axis)
    , Graph(graph)
  {
  }

  std::vector<PatchMesh> Run(CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs,
    const Execution& execution);

private:
  void FormGroups(CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs);
  void Overlay(SlabGroup& group, bool mayShear) const;
  void InsertVertices(const Execution& execution);
  void TryInsertVertices();
  bool LeaveOutSpoilt(const Execution& execution);
  bool AreLoopsSimple(const std::vector<Index>& loops) const;
  void Append(Index loop, const std::vector<NewVertex>& vertices, std::vector<double>& points);
  void AddPatches(std::size_t group, std::vector<PatchMesh>& meshes) const;
  Point3 Place(const SlabGroup& group, const Point3& point) const;

  friend class PatchMaker;

  const SpatialGrid& Grid;
  const CellCycles& Cycles;
  int Axis;
  NodeGraph& Graph;
  std::vector<SlabGroup> Groups;
  std::vector<LoopPlaces> Places;              ///< of each loop
  std::vector<std::vector<Index>> InsertionAt; ///< of each group: places of its insertions
};

/// All loops of a slab together, or those that the criterion joins.
void SlabStitcher::FormGroups(CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs)
{
  const bool together = criterion == CorrespondenceCriterion::ByEvidence ||
    criterion == CorrespondenceCriterion::Overlap;
  DisjointSets sets(this->Cycles.Count());
  for (const LoopPair& pair : pairs)
  {
    sets.Unite(pair.First, pair.Second);
  }
  std::map<std::pair<Index, Index>, std::size_t> groupOf;
  for (Index loop = 0; loop < static_cast<Index>(this->Graph.Loops.size()); ++loop)
  {
    const std::vector<Point2> polygon = PolygonOf(this->Graph, loop);
    for (const bool above : { false, true })
    {
      const Index slab = this->Graph.Loops[loop].Plane + (above ? 1 : 0);
      const Index set = together ? 0 : sets.Find(CycleOf(this->Cycles, this->Graph, loop, above));
      const auto at = groupOf.emplace(std::make_pair(slab, set), this->Groups.size());
      if (at.second)
      {
        this->Groups.push_back({ slab, {}, {}, { 0.0, 0.0 }, {} });
      }
      SlabGroup& group = this->Groups[at.first->second];
      group.Loops.push_back(loop);
      group.Outlines.push_back({ polygon, !above });
    }
  }
}

Point2 CentreOf(const std::vector<SlabLoop>& loops, bool upper)
{
  CurveCenter center(Point3{ 0.0, 0.0, 0.0 });
  for (const SlabLoop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.Points.size() && loop.Upper == upper; ++i)
    {
      const Point2& p = loop.Points[i];
      const Point2& q = loop.Points[(i + 1) % loop.Points.size()];
      center.Add({ p[0], p[1], 0.0 }, { q[0], q[1], 0.0 });
    }
  }
  const Point3 result = center.Get();
  return { result[0], result[1] };
}

Index CountPieces(const SlabOverlay& overlay)
{
  return overlay.Piece.empty() ? 0
                               : *std::max_element(overlay.Piece.begin(), overlay.Piece.end()) + 1;
}

/// Straight, or sheared so that the middles of both slices lie above each other.
void SlabStitcher::Overlay(SlabGroup& group, bool mayShear) const
{
  group.Overlay = OverlaySlab(group.Outlines, group.Shift);
  if (!mayShear || (group.Overlay.Valid && CountPieces(group.Overlay) == 1))
  {
    return;
  }
  const Point2 lower = CentreOf(group.Outlines, false);
  const Point2 upper = CentreOf(group.Outlines, true);
  const Point2 shift{ upper[0] - lower[0], upper[1] - lower[1] };
  SlabOverlay sheared = OverlaySlab(group.Outlines, shift);
  if (sheared.Valid && CountPieces(sheared) == 1)
  {
    group.Shift = shift;
    group.Overlay = std::move(sheared);
  }
  else
  {
    group.Overlay.Valid = false;
  }
}

/// Writes the points of a loop with its new vertices, and notes where all of them are.
void SlabStitcher::Append(
  Index loop, const std::vector<NewVertex>& vertices, std::vector<double>& points)
{
  const Index arc = this->Graph.Arcs + loop;
  const Index count = this->Graph.PointCount(arc);
  LoopPlaces& places = this->Places[loop];
  const auto add = [&](const Point3& point)
  {
    points.insert(points.end(), point.begin(), point.end());
    return places.Count++;
  };
  auto next = vertices.begin();
  for (Index i = 0; i < count; ++i)
  {
    const Point3 from = this->Graph.PointAt(this->Graph.FirstPoint(arc) + i);
    const Point3 to = this->Graph.PointAt(this->Graph.FirstPoint(arc) + (i + 1) % count);
    places.OfVertex.push_back(add(from));
    Point3 last = from;
    for (; next != vertices.end() && next->After == i; ++next)
    {
      Point3 point = from + next->Share * (to - from);
      for (double& x : point)
      {
        x = this->Grid.Round(x);
      }
      point[this->Axis] = from[this->Axis];
      // Two slabs may ask for the same vertex, and rounding may move it to an old one.
      Index& place = this->InsertionAt[next->Group][next->Insertion];
      place = point == last ? places.Count - 1 : point == to ? -1 - i : add(point);
      if (place < 0)
      {
        continue;
      }
      last = point;
    }
  }
}

/// Inserts the vertices of the overlays, but for those that rounding would spoil.
void SlabStitcher::InsertVertices(const Execution& execution)
{
  const std::vector<double> points = this->Graph.Points;
  const std::vector<Index> offsets = this->Graph.Offsets;
  this->TryInsertVertices();
  while (this->LeaveOutSpoilt(execution))
  {
    this->Graph.Points = points;
    this->Graph.Offsets = offsets;
    this->TryInsertVertices();
  }
}

/// Gives up the overlays beside slices on which loops touch: a new vertex, once rounded, lies
/// beside its segment and may lie on another one. Returns whether there are any.
bool SlabStitcher::LeaveOutSpoilt(const Execution& execution)
{
  const std::size_t planes = this->Grid.Planes[this->Axis].size();
  std::vector<std::uint8_t> isNew(planes, 0), isSpoilt(planes, 0);
  for (const SlabGroup& group : this->Groups)
  {
    for (const SlabOverlay::Insertion& insertion : group.Overlay.Insertions)
    {
      isNew[this->Graph.Loops[group.Loops[insertion.Loop]].Plane] |= group.Overlay.Valid ? 1 : 0;
    }
  }
  std::vector<std::vector<Index>> loopsOn(planes);
  for (Index loop = 0; loop < static_cast<Index>(this->Graph.Loops.size()); ++loop)
  {
    loopsOn[this->Graph.Loops[loop].Plane].push_back(loop);
  }
  execution.For(planes,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t plane = begin; plane < end; ++plane)
      {
        isSpoilt[plane] = isNew[plane] != 0 && !this->AreLoopsSimple(loopsOn[plane]);
      }
    });
  for (SlabGroup& group : this->Groups)
  {
    const auto below = static_cast<std::size_t>(group.Slab);
    if ((below > 0 && isSpoilt[below - 1] != 0) || (below < planes && isSpoilt[below] != 0))
    {
      group.Overlay.Valid = false;
    }
  }
  return std::find(isSpoilt.begin(), isSpoilt.end(), 1) != isSpoilt.end();
}

/// Whether loops of one slice touch neither each other nor themselves.
bool SlabStitcher::AreLoopsSimple(const std::vector<Index>& loops) const
{
  PlanarCurves curves;
  for (const Index loop : loops)
  {
    AddClosedCurve(PolygonOf(this->Graph, loop), curves);
  }
  return AreSimple(curves);
}

void SlabStitcher::TryInsertVertices()
{
  this->InsertionAt.clear();
  this->Places.clear();
  const Index loops = static_cast<Index>(this->Graph.Loops.size());
  std::vector<std::vector<NewVertex>> ofLoop(loops);
  for (std::size_t g = 0; g < this->Groups.size(); ++g)
  {
    const SlabGroup& group = this->Groups[g];
    this->InsertionAt.emplace_back(group.Overlay.Valid ? group.Overlay.Insertions.size() : 0, 0);
    for (std::size_t i = 0; i < this->InsertionAt.back().size(); ++i)
    {
      const SlabOverlay::Insertion& insertion = group.Overlay.Insertions[i];
      ofLoop[group.Loops[insertion.Loop]].push_back(
        { insertion.After, insertion.Share, g, static_cast<Index>(i) });
    }
  }
  this->Places.resize(loops);
  std::vector<double> points(this->Graph.Points.begin(),
    this->Graph.Points.begin() +
      3 * static_cast<std::ptrdiff_t>(this->Graph.FirstPoint(this->Graph.Arcs)));
  std::vector<Index> offsets(
    this->Graph.Offsets.begin(), this->Graph.Offsets.begin() + this->Graph.Arcs + 1);
  for (Index loop = 0; loop < loops; ++loop)
  {
    std::stable_sort(ofLoop[loop].begin(), ofLoop[loop].end(),
      [](const NewVertex& a, const NewVertex& b)
      { return std::tie(a.After, a.Share) < std::tie(b.After, b.Share); });
    this->Append(loop, ofLoop[loop], points);
    for (const NewVertex& vertex : ofLoop[loop])
    {
      // At the end of its segment: the vertex after.
      Index& place = this->InsertionAt[vertex.Group][vertex.Insertion];
      const std::vector<Index>& old = this->Places[loop].OfVertex;
      place = place < 0 ? old[(-place) % old.size()] : place;
    }
    offsets.push_back(static_cast<Index>(points.size() / 3) - this->Graph.Nodes);
  }
  this->Graph.Points.swap(points);
  this->Graph.Offsets.swap(offsets);
}

/// An own point of the overlay in space, strictly inside the slab.
Point3 SlabStitcher::Place(const SlabGroup& group, const Point3& point) const
{
  const auto& planes = this->Grid.Planes[this->Axis];
  const double width = this->Grid.Width(this->Axis, group.Slab);
  const double low = group.Slab > 0 ? planes[group.Slab - 1] : planes[0] - width;
  Point3 placed;
  placed[this->Axis] = this->Grid.MoveInside(this->Axis, group.Slab, low + point[2] * width);
  placed[FirstAxis(this->Axis)] = this->Grid.Round(point[0] + point[2] * group.Shift[0]);
  placed[SecondAxis(this->Axis)] = this->Grid.Round(point[1] + point[2] * group.Shift[1]);
  return placed;
}

/// A vertex of a contour: its loop among those of the group, and its place on it now.
struct ContourCorner
{
  Index Member, Place;
};

/// One piece of an overlay as a patch.
class PatchMaker
{
public:
  PatchMaker(const SlabStitcher& stitcher, std::size_t group, Index piece);
  PatchMesh Run();

private:
  void FindMembers();
  Index CornerOf(Index corner);
  Point3 PointOf(Index corner) const;
  bool IsOnContour(Index a, Index b) const;
  void AddSide(Index a, Index b, std::vector<Index>& ring);
  void AddMiddle(const std::vector<Index>& ring, const std::array<Index, 3>& corners);

  const SlabStitcher& Stitcher;
  const SlabGroup& Group;
  Index Piece;
  std::vector<ContourCorner> Corners;         ///< of the overlay, before its own points
  std::vector<std::pair<Index, Index>> Edges; ///< of its triangles, ascending
  std::vector<Index> FirstPlace;              ///< of each member on the border of the patch
  std::vector<Index> Border;                  ///< points of G
  std::vector<Index> Own;                     ///< corners of the patch for the overlay's own points
  PatchMesh Mesh;
};

PatchMaker::PatchMaker(const SlabStitcher& stitcher, std::size_t group, Index piece)
  : Stitcher(stitcher)
  , Group(stitcher.Groups[group])
  , Piece(piece)
  , FirstPlace(Group.Loops.size(), -1)
  , Own(Group.Overlay.Points.size(), 0)
{
  for (std::size_t member = 0; member < this->Group.Loops.size(); ++member)
  {
    for (const Index place : stitcher.Places[this->Group.Loops[member]].OfVertex)
    {
      this->Corners.push_back({ static_cast<Index>(member), place });
    }
  }
  for (std::size_t i = 0; i < this->Group.Overlay.Insertions.size(); ++i)
  {
    this->Corners.push_back(
      { this->Group.Overlay.Insertions[i].Loop, stitcher.InsertionAt[group][i] });
  }
  for (std::size_t t = 0; t < this->Group.Overlay.Triangles.size(); ++t)
  {
    const auto& triangle = this->Group.Overlay.Triangles[t];
    for (int i = 0; i < 3 && this->Group.Overlay.Piece[t] == piece; ++i)
    {
      this->Edges.emplace_back(triangle[i], triangle[(i + 1) % 3]);
    }
  }
  std::sort(this->Edges.begin(), this->Edges.end());
  this->Mesh.Kind = PatchKind::Stitched;
}

/// The loops of the piece, in the order of their cycles.
void PatchMaker::FindMembers()
{
  std::vector<std::pair<Index, Index>> members; // cycle, member
  for (const auto& edge : this->Edges)
  {
    if (edge.first < static_cast<Index>(this->Corners.size()))
    {
      const Index member = this->Corners[edge.first].Member;
      members.emplace_back(CycleOf(this->Stitcher.Cycles, this->Stitcher.Graph,
                             this->Group.Loops[member], !this->Group.Outlines[member].Upper),
        member);
    }
  }
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  for (const auto& member : members)
  {
    this->Mesh.Cycles.push_back(member.first);
    this->FirstPlace[member.second] = static_cast<Index>(this->Border.size());
    const Index loop = this->Group.Loops[member.second];
    const Index count = this->Stitcher.Places[loop].Count;
    const Index first = this->Stitcher.Graph.FirstPoint(this->Stitcher.Graph.Arcs + loop);
    for (Index i = 0; i < count; ++i)
    {
      // Cycles below a slice are passed backwards.
      const bool backwards = this->Group.Outlines[member.second].Upper;
      this->Border.push_back(first + (backwards ? count - 1 - i : i));
    }
  }
}

Index PatchMaker::CornerOf(Index corner)
{
  const Index contours = static_cast<Index>(this->Corners.size());
  if (corner < contours)
  {
    const ContourCorner& at = this->Corners[corner];
    const Index count = this->Stitcher.Places[this->Group.Loops[at.Member]].Count;
    return this->FirstPlace[at.Member] +
      (this->Group.Outlines[at.Member].Upper ? count - 1 - at.Place : at.Place);
  }
  Index& own = this->Own[corner - contours];
  if (own == 0)
  {
    this->Mesh.Points.push_back(
      this->Stitcher.Place(this->Group, this->Group.Overlay.Points[corner - contours]));
    own = -static_cast<Index>(this->Mesh.Points.size());
  }
  return own;
}

Point3 PatchMaker::PointOf(Index corner) const
{
  return corner >= 0 ? this->Stitcher.Graph.PointAt(this->Border[corner])
                     : this->Mesh.Points[-1 - corner];
}

/// Whether a side of a triangle is a part of a contour: open, and both ends on it.
bool PatchMaker::IsOnContour(Index a, Index b) const
{
  return !std::binary_search(this->Edges.begin(), this->Edges.end(), std::make_pair(b, a));
}

/// A corner, and the vertices after it that the slab on the other side of the slice has inserted.
void PatchMaker::AddSide(Index a, Index b, std::vector<Index>& ring)
{
  const Index from = this->CornerOf(a);
  if (from == this->CornerOf(b))
  {
    return; // rounding has moved a new vertex to an old one
  }
  ring.push_back(from);
  if (this->IsOnContour(a, b))
  {
    const Index member = this->Corners[a].Member;
    const Index first = this->FirstPlace[member];
    const Index count = this->Stitcher.Places[this->Group.Loops[member]].Count;
    const Index to = this->CornerOf(b);
    for (Index p = first + (from - first + 1) % count; p != to; p = first + (p - first + 1) % count)
    {
      ring.push_back(p);
    }
  }
}

/// A fan around a new point in the middle of a triangle.
void PatchMaker::AddMiddle(const std::vector<Index>& ring, const std::array<Index, 3>& corners)
{
  Point3 middle = (1.0 / 3.0) *
    ((this->PointOf(corners[0]) + this->PointOf(corners[1])) + this->PointOf(corners[2]));
  for (double& x : middle)
  {
    x = this->Stitcher.Grid.Round(x);
  }
  this->Mesh.Points.push_back(middle);
  const Index own = -static_cast<Index>(this->Mesh.Points.size());
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    this->Mesh.Triangles.push_back({ ring[k], ring[(k + 1) % ring.size()], own });
  }
}

PatchMesh PatchMaker::Run()
{
  this->FindMembers();
  for (std::size_t t = 0; t < this->Group.Overlay.Triangles.size(); ++t)
  {
    if (this->Group.Overlay.Piece[t] != this->Piece)
    {
      continue;
    }
    const auto& triangle = this->Group.Overlay.Triangles[t];
    std::vector<Index> ring;
    for (int i = 0; i < 3; ++i)
    {
      this->AddSide(triangle[i], triangle[(i + 1) % 3], ring);
    }
    if (ring.size() < 3)
    {
      continue;
    }
    if (ring.size() == 3)
    {
      this->Mesh.Triangles.push_back({ ring[0], ring[1], ring[2] });
      continue;
    }
    this->AddMiddle(ring,
      { this->CornerOf(triangle[0]), this->CornerOf(triangle[1]), this->CornerOf(triangle[2]) });
  }
  // Every patch needs as many own points as it has cycles.
  while (this->Mesh.Points.size() < this->Mesh.Cycles.size())
  {
    const std::array<Index, 3> triangle = this->Mesh.Triangles.front();
    this->Mesh.Triangles.erase(this->Mesh.Triangles.begin());
    this->AddMiddle({ triangle[0], triangle[1], triangle[2] }, triangle);
  }
  return std::move(this->Mesh);
}

void SlabStitcher::AddPatches(std::size_t index, std::vector<PatchMesh>& meshes) const
{
  const SlabOverlay& overlay = this->Groups[index].Overlay;
  for (Index piece = 0; overlay.Valid && piece < CountPieces(overlay); ++piece)
  {
    meshes.push_back(PatchMaker(*this, index, piece).Run());
  }
}

std::vector<PatchMesh> SlabStitcher::Run(
  CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs, const Execution& execution)
{
  this->FormGroups(criterion, pairs);
  const bool mayShear = criterion != CorrespondenceCriterion::ByEvidence &&
    criterion != CorrespondenceCriterion::Overlap;
  execution.For(this->Groups.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Overlay(this->Groups[i], mayShear);
      }
    });
  this->InsertVertices(execution);
  std::vector<std::vector<PatchMesh>> found(this->Groups.size());
  execution.For(found.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->AddPatches(i, found[i]);
      }
    });
  std::vector<PatchMesh> meshes;
  for (std::vector<PatchMesh>& part : found)
  {
    std::move(part.begin(), part.end(), std::back_inserter(meshes));
  }
  std::sort(meshes.begin(), meshes.end(),
    [](const PatchMesh& a, const PatchMesh& b) { return a.Cycles.front() < b.Cycles.front(); });
  return meshes;
}
}

std::vector<PatchMesh> StitchSlabs(const SpatialGrid& grid, const CellCycles& cycles,
  CorrespondenceCriterion criterion, const std::vector<LoopPair>& pairs, const Execution& execution,
  NodeGraph& graph)
{
  int families = 0;
  int axis = 0;
  for (int i = 0; i < 3; ++i)
  {
    families += grid.Count(i) > 0 ? 1 : 0;
    axis = grid.Count(i) > 0 ? i : axis;
  }
  if (families != 1 || graph.Loops.empty())
  {
    return {};
  }
  return SlabStitcher(grid, cycles, axis, graph).Run(criterion, pairs, execution);
}
}
