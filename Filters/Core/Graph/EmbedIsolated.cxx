// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/EmbedIsolated.h"

#include "Core/Graph/EditGraph.h"
#include "Core/Graph/FaceArcs.h"
#include "Core/Planar/UncrossCurves.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace orthoslices
{
namespace
{
bool IsBefore(const Face& a, const Face& b)
{
  return std::tie(a.Axis, a.Plane, a.Slab) < std::tie(b.Axis, b.Plane, b.Slab);
}

bool IsSame(const Face& a, const Face& b) { return !IsBefore(a, b) && !IsBefore(b, a); }

/// An isolated contour on its way into G.
struct Candidate
{
  Index Contour;
  orthoslices::Face Face;
  std::vector<Point2> Polygon;
  double Area; ///< positive if the interior is inside
  bool Keep = true;
};

class LoopEmbedder
{
public:
  LoopEmbedder(const ArcGeometry& geometry, const Execution& execution, IsolatedContours& isolated)
    : Geometry(geometry)
    , Execute(execution)
    , Isolated(isolated)
  {
  }

  std::vector<GraphLoop> Run(double minimum);

private:
  double SizeOf(Index contour) const;
  Candidate Read(Index contour) const;
  std::vector<FaceArcs> FindArcs(const std::vector<Candidate>& candidates);
  void EmbedFace(Candidate* first, Candidate* last, const FaceArcs& arcs) const;
  void Uncross(Candidate* first, Candidate* last) const;
  void AddArcs(const FaceArcs& arcs, PlanarCurves& curves) const;
  std::vector<GraphLoop> ListLoops(const std::vector<Candidate>& candidates) const;

  ArcGeometry Geometry;
  const Execution& Execute;
  IsolatedContours& Isolated;
  ArcsByFace Arcs;
};

/// Diagonal of the bounding box.
double LoopEmbedder::SizeOf(Index contour) const
{
  Point3 size{ 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const Index first = this->Isolated.Offsets[contour];
    double low = this->Isolated.Points[3 * static_cast<std::size_t>(first) + axis];
    double high = low;
    for (Index v = first; v < this->Isolated.Offsets[contour + 1]; ++v)
    {
      low = std::min(low, this->Isolated.Points[3 * static_cast<std::size_t>(v) + axis]);
      high = std::max(high, this->Isolated.Points[3 * static_cast<std::size_t>(v) + axis]);
    }
    size[axis] = high - low;
  }
  return std::hypot(size[0], size[1], size[2]);
}

/// The contour in the axes of its face, off the face's border.
Candidate LoopEmbedder::Read(Index contour) const
{
  const SpatialGrid& grid = this->Geometry.Grid;
  const int axis = this->Isolated.Axis[contour];
  const std::array<int, 2> axes{ FirstAxis(axis), SecondAxis(axis) };
  Candidate candidate{ contour, { axis, this->Isolated.Plane[contour], { 0, 0 } }, {}, 0.0 };
  const Index first = this->Isolated.Offsets[contour];
  const double* points = this->Isolated.Points.data();
  for (int i = 0; i < 2; ++i)
  {
    candidate.Face.Slab[i] =
      grid.Slab(axes[i], points[3 * static_cast<std::size_t>(first) + axes[i]]);
  }
  for (Index v = first; v < this->Isolated.Offsets[contour + 1]; ++v)
  {
    const double* point = points + 3 * static_cast<std::size_t>(v);
    Point2 p;
    for (int i = 0; i < 2; ++i)
    {
      p[i] = grid.MoveInside(axes[i], candidate.Face.Slab[i], point[axes[i]]);
    }
    if (candidate.Polygon.empty() || p != candidate.Polygon.back())
    {
      candidate.Polygon.push_back(p);
    }
  }
  while (candidate.Polygon.size() > 1 && candidate.Polygon.front() == candidate.Polygon.back())
  {
    candidate.Polygon.pop_back();
  }
  candidate.Keep = candidate.Polygon.size() >= 3;
  candidate.Area = candidate.Keep ? SignedArea(candidate.Polygon) : 0.0;
  candidate.Keep = candidate.Area != 0.0;
  return candidate;
}

/// The arcs on the faces of the candidates, which are in the order of faces.
std::vector<FaceArcs> LoopEmbedder::FindArcs(const std::vector<Candidate>& candidates)
{
  this->Arcs = GroupArcsByFace(this->Geometry.Grid, this->Geometry.Crossings, this->Execute);
  std::vector<FaceArcs> found;
  for (const Candidate& candidate : candidates)
  {
    const auto& faces = this->Arcs.Faces;
    const auto at = std::lower_bound(faces.begin(), faces.end(), candidate.Face, IsBefore);
    const bool has = at != faces.end() && IsSame(*at, candidate.Face);
    found.push_back(has ? this->Arcs[static_cast<Index>(at - faces.begin())]
                        : FaceArcs{ candidate.Face, nullptr, nullptr });
  }
  return found;
}

void LoopEmbedder::AddArcs(const FaceArcs& arcs, PlanarCurves& curves) const
{
  for (const Index arc : arcs)
  {
    std::vector<Point2> points;
    this->Geometry.VisitPoints(
      arc, [&](Index point) { points.push_back(this->Geometry.InPlane(arcs.Face, point)); });
    AddCurve(points, curves);
  }
}

/// Takes the loops of a face apart where they cross. If that fails they stay as they are.
void LoopEmbedder::Uncross(Candidate* first, Candidate* last) const
{
  PlanarCurves curves;
  std::vector<Candidate*> members;
  for (Candidate* candidate = first; candidate != last; ++candidate)
  {
    if (candidate->Keep)
    {
      members.push_back(candidate);
      AddClosedCurve(candidate->Polygon, curves);
    }
  }
  if (AreSimple(curves) || !UncrossCurves(curves).Simple)
  {
    return;
  }
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    Candidate& member = *members[i];
    const bool wasLeft = member.Area > 0.0;
    member.Polygon.clear();
    for (std::size_t k = 0; k + 1 < curves.Curves[i].size(); ++k)
    {
      member.Polygon.push_back(curves.Vertices[curves.Curves[i][k]]);
    }
    member.Area = SignedArea(member.Polygon);
    member.Keep = member.Polygon.size() >= 3 && member.Area != 0.0;
    if ((member.Area > 0.0) != wasLeft)
    {
      std::reverse(member.Polygon.begin(), member.Polygon.end());
      member.Area = -member.Area;
    }
  }
}

/// Keeps the loops of one face that touch nothing, the largest first.
void LoopEmbedder::EmbedFace(Candidate* first, Candidate* last, const FaceArcs& arcs) const
{
  this->Uncross(first, last);
  PlanarCurves all;
  this->AddArcs(arcs, all);
  std::vector<Candidate*> bySize;
  for (Candidate* candidate = first; candidate != last; ++candidate)
  {
    if (candidate->Keep)
    {
      bySize.push_back(candidate);
      AddClosedCurve(candidate->Polygon, all);
    }
  }
  if (AreSimple(all))
  {
    return;
  }
  std::stable_sort(bySize.begin(), bySize.end(),
    [](const Candidate* a, const Candidate* b) { return std::abs(a->Area) > std::abs(b->Area); });
  PlanarCurves kept;
  this->AddArcs(arcs, kept);
  for (Candidate* candidate : bySize)
  {
    PlanarCurves with = kept;
    AddClosedCurve(candidate->Polygon, with);
    candidate->Keep = AreSimple(with);
    if (candidate->Keep)
    {
      kept = std::move(with);
    }
  }
}

std::vector<GraphLoop> LoopEmbedder::ListLoops(const std::vector<Candidate>& candidates) const
{
  std::vector<GraphLoop> loops;
  for (const Candidate& candidate : candidates)
  {
    if (!candidate.Keep)
    {
      continue;
    }
    this->Isolated.Loop[candidate.Contour] = static_cast<Index>(loops.size());
    loops.push_back({ candidate.Face, {} });
    for (const Point2& p : candidate.Polygon)
    {
      loops.back().Points.push_back(this->Geometry.InSpace(candidate.Face, p));
    }
  }
  return loops;
}

std::vector<GraphLoop> LoopEmbedder::Run(double minimum)
{
  std::fill(this->Isolated.Loop.begin(), this->Isolated.Loop.end(), IsolatedContours::None);
  std::vector<Candidate> candidates;
  for (Index contour = 0; contour < this->Isolated.Count(); ++contour)
  {
    if (this->Isolated.LeftOut[contour] == 0 && this->SizeOf(contour) >= minimum)
    {
      candidates.push_back(this->Read(contour));
    }
  }
  if (candidates.empty())
  {
    return {};
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return IsBefore(a.Face, b.Face); });
  const std::vector<FaceArcs> arcs = this->FindArcs(candidates);
  std::vector<std::size_t> faces;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (i == 0 || !IsSame(candidates[i - 1].Face, candidates[i].Face))
    {
      faces.push_back(i);
    }
  }
  faces.push_back(candidates.size());
  this->Execute.For(faces.size() - 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t f = begin; f < end; ++f)
      {
        this->EmbedFace(
          candidates.data() + faces[f], candidates.data() + faces[f + 1], arcs[faces[f]]);
      }
    });
  return this->ListLoops(candidates);
}
}

void EmbedIsolated(
  const GraphTables& tables, double minimum, const Execution& execution, IsolatedContours& isolated)
{
  const ArcGeometry geometry{ tables.Grid, tables.Nodes, tables.Crossings, tables.Graph };
  SetLoops(LoopEmbedder(geometry, execution, isolated).Run(minimum), tables.Graph);
}
}
