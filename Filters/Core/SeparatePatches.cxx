// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeparatePatches.h"

#include "Predicates.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// Depth of the deepest shell as a part of the way to the middle of the cell.
constexpr double DeepestShell = 0.4;

/// Place on the border of one of the faces of a cell: a node of the cycle, or a corner of the
/// cell.
struct RingVertex
{
  bool IsCorner;
  Index
    Place; ///< node: place among the nodes of the cycle; corner: bits 0, 1, 2 = upper in x, y, z
};

/// One cycle of a cell with what the construction of its shell needs.
struct CellCycle
{
  Index Cycle;
  std::vector<Index> Border, NodePlaces;
  std::vector<Index> Nodes;     ///< node points, in the order of the cycle
  std::vector<int> NodeEdge;    ///< edge of the cell on which each lies
  std::vector<int> ArcFace;     ///< face of the cell on which the arc after each node lies
  std::array<bool, 8> InRegion; ///< corners of the cell
  bool RegionOnLeft = true;     ///< of the cycle, seen from outside the cell
  int Height = 0;               ///< 1 plus the number of regions nested within, one in another
};

/// Edges of a cell: 4 * direction + 2 * upper in SecondAxis + upper in FirstAxis.
int EdgeOfCell(int direction, int upperFirst, int upperSecond)
{
  return 4 * direction + 2 * upperSecond + upperFirst;
}

/// The corner at the lower end of an edge of a cell.
int LowerCorner(int edge)
{
  const int t = edge / 4;
  return ((edge & 1) << FirstAxis(t)) | (((edge >> 1) & 1) << SecondAxis(t));
}

/// The shells of one cell.
class CellShells
{
public:
  CellShells(const SpatialGrid& grid, const NodeGraph& graph, const Crossings& crossings,
    const NodePoints& nodes, const Cycles& cycles)
    : Grid(grid)
    , Code(grid)
    , Graph(graph)
    , Lattice(crossings)
    , Nodes(nodes)
    , Polygons(cycles)
  {
  }

  bool MayCross(const Index* first, const Index* last, const std::vector<double>& centers);
  void Build(const Index* first, const Index* last, std::vector<ShellPatch>& shells);
  bool AreCertainlyApart(const std::vector<ShellPatch>& shells) const;

private:
  Point3 PointOf(Index point) const;
  CellCycle Describe(Index cycle) const;
  void SetExtent(const std::vector<CellCycle>& members);
  void FindRegion(CellCycle& member) const;
  bool IsWithin(const CellCycle& inner, const CellCycle& outer) const;
  void FindHeights(std::vector<CellCycle>& members) const;

  ShellPatch BuildShell(const CellCycle& member, double depth) const;
  std::vector<RingVertex> RingOf(const CellCycle& member, int face) const;
  bool IsRegionOnLeft(const CellCycle& member) const;
  void AddWall(const CellCycle& member, ShellPatch& shell) const;
  void AddFace(const CellCycle& member, int face, ShellPatch& shell) const;
  void AddRegion(
    const CellCycle& member, int face, const std::vector<Index>& vertices, ShellPatch& shell) const;
  Point3 Corner(int corner) const;
  Point3 Inward(const Point3& point, double depth) const;

  const SpatialGrid& Grid;
  GridEdgeCode Code;
  const NodeGraph& Graph;
  const Crossings& Lattice;
  const NodePoints& Nodes;
  const Cycles& Polygons;
  Point3 Low, High; ///< the cell, bounded
};

Point3 CellShells::PointOf(Index point) const
{
  const double* p = this->Graph.Points.data() + 3 * static_cast<std::size_t>(point);
  return { p[0], p[1], p[2] };
}

/// A triangle of a patch, its corners' places in a list of all points of the cell, and its box.
struct PatchTriangle
{
  PatchTriangle(Index patch, const std::array<Point3, 3>& corners, const std::array<Index, 3>& ids)
    : Patch(patch)
    , Corners(corners)
    , Ids(ids)
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto range = std::minmax({ corners[0][i], corners[1][i], corners[2][i] });
      this->Low[i] = range.first;
      this->High[i] = range.second;
    }
  }
  bool BoxMeets(const PatchTriangle& other, int axis) const
  {
    return this->Low[axis] <= other.High[axis] && other.Low[axis] <= this->High[axis];
  }

  Index Patch;
  std::array<Point3, 3> Corners;
  std::array<Index, 3> Ids;
  Point3 Low, High;
};

/// Whether two triangles certainly meet in their common corners only.
bool AreCompatible(const PatchTriangle& a, const PatchTriangle& b)
{
  if (!a.BoxMeets(b, 1) || !a.BoxMeets(b, 2))
  {
    return true;
  }
  std::vector<int> commonOfA, commonOfB;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (a.Ids[i] == b.Ids[j])
      {
        commonOfA.push_back(i);
        commonOfB.push_back(j);
      }
    }
  }
  return commonOfA.empty() ? CertainlyApart(a.Corners, b.Corners)
                           : CertainlyApartBeyond(commonOfA, a.Corners, commonOfB, b.Corners);
}

/// Whether all triangles that the filter compares are compatible. Sorts them along x.
template <typename Filter>
bool AreAllCompatible(std::vector<PatchTriangle>& triangles, Filter&& isCompared)
{
  std::sort(triangles.begin(), triangles.end(),
    [](const PatchTriangle& a, const PatchTriangle& b) { return a.Low[0] < b.Low[0]; });
  for (auto a = triangles.begin(); a != triangles.end(); ++a)
  {
    for (auto b = a + 1; b != triangles.end() && b->Low[0] <= a->High[0]; ++b)
    {
      if (isCompared(*a, *b) && !AreCompatible(*a, *b))
      {
        return false;
      }
    }
  }
  return true;
}

/// Whether fans of different cycles may cross. A fan cannot cross itself.
bool CellShells::MayCross(const Index* first, const Index* last, const std::vector<double>& centers)
{
  std::vector<PatchTriangle> triangles;
  std::vector<Index> border, places;
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    GetBoundary(this->Graph, this->Lattice, this->Nodes, this->Polygons, *cycle, border, places);
    const double* c = centers.data() + 3 * static_cast<std::size_t>(*cycle);
    const Point3 center{ c[0], c[1], c[2] };
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const Index j = border[(i + 1) % border.size()];
      triangles.push_back({ *cycle, { center, this->PointOf(border[i]), this->PointOf(j) },
        { -1 - *cycle, border[i], j } });
    }
  }
  return !AreAllCompatible(
    triangles, [](const PatchTriangle& a, const PatchTriangle& b) { return a.Patch != b.Patch; });
}

CellCycle CellShells::Describe(Index cycle) const
{
  CellCycle member;
  member.Cycle = cycle;
  GetBoundary(this->Graph, this->Lattice, this->Nodes, this->Polygons, cycle, member.Border,
    member.NodePlaces);
  const auto& cell = this->Polygons.Cell[cycle];
  for (Index i = this->Polygons.Offsets[cycle]; i < this->Polygons.Offsets[cycle + 1]; ++i)
  {
    const HalfArc& half = this->Polygons.Arcs[i];
    const Index node = StartNode(this->Lattice, this->Nodes, half);
    const GridEdge at = this->Code.Decode(this->Lattice.Edge[this->Nodes.First[node]]);
    const int t = at.Direction;
    member.Nodes.push_back(node);
    member.NodeEdge.push_back(EdgeOfCell(
      t, at.First == cell[FirstAxis(t)] ? 1 : 0, at.Second == cell[SecondAxis(t)] ? 1 : 0));
    const GridEdge start = this->Code.Decode(this->Lattice.Edge[half.Arc]);
    const int axis = this->Lattice.Family[half.Arc] == 0 ? FirstAxis(start.Direction)
                                                         : SecondAxis(start.Direction);
    // The cell above a slice has it as its lower face.
    member.ArcFace.push_back(2 * axis + (half.Above ? 0 : 1));
  }
  return member;
}

void CellShells::SetExtent(const std::vector<CellCycle>& members)
{
  Point3 least, most;
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-std::numeric_limits<double>::infinity());
  for (const CellCycle& member : members)
  {
    for (const Index point : member.Border)
    {
      const Point3 p = this->PointOf(point);
      for (int axis = 0; axis < 3; ++axis)
      {
        least[axis] = std::min(least[axis], p[axis]);
        most[axis] = std::max(most[axis], p[axis]);
      }
    }
  }
  const auto& cell = this->Polygons.Cell[members.front().Cycle];
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Grid.GetExtent(
      axis, cell[axis], least[axis], most[axis], this->Low[axis], this->High[axis]);
  }
}

/// A corner is in the region if a path along edges from corner 0 passes an odd number of nodes.
void CellShells::FindRegion(CellCycle& member) const
{
  std::array<bool, 12> odd{};
  for (const int edge : member.NodeEdge)
  {
    odd[edge] = !odd[edge];
  }
  member.InRegion[0] = false;
  for (int corner = 1; corner < 8; ++corner)
  {
    // From the neighbour that is lower along the last axis in which this corner is upper.
    const int t = corner >= 4 ? 2 : corner >= 2 ? 1 : 0;
    const int edge = EdgeOfCell(t, (corner >> FirstAxis(t)) & 1, (corner >> SecondAxis(t)) & 1);
    member.InRegion[corner] = member.InRegion[corner ^ (1 << t)] != odd[edge];
  }
}

/// Whether a node of one cycle lies in the region of another. Nodes are numbered upwards along an
/// edge.
bool CellShells::IsWithin(const CellCycle& inner, const CellCycle& outer) const
{
  const int edge = inner.NodeEdge.front();
  bool within = outer.InRegion[LowerCorner(edge)];
  for (std::size_t i = 0; i < outer.Nodes.size(); ++i)
  {
    within ^= outer.NodeEdge[i] == edge && outer.Nodes[i] < inner.Nodes.front();
  }
  return within;
}

void CellShells::FindHeights(std::vector<CellCycle>& members) const
{
  // Passes until nothing changes: as many as regions are nested, which are few.
  for (CellCycle& member : members)
  {
    member.Height = 1;
  }
  bool changed = true;
  for (std::size_t pass = 0; changed && pass < members.size(); ++pass)
  {
    changed = false;
    for (CellCycle& outer : members)
    {
      for (const CellCycle& inner : members)
      {
        if (&inner != &outer && outer.Height <= inner.Height && this->IsWithin(inner, outer))
        {
          outer.Height = inner.Height + 1;
          changed = true;
        }
      }
    }
  }
}

Point3 CellShells::Corner(int corner) const
{
  Point3 point;
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = (corner >> axis) & 1 ? this->High[axis] : this->Low[axis];
  }
  return point;
}

Point3 CellShells::Inward(const Point3& point, double depth) const
{
  Point3 inner;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = this->Low[axis] + 0.5 * (this->High[axis] - this->Low[axis]);
    inner[axis] = this->Grid.Round(point[axis] + depth * (middle - point[axis]));
  }
  return inner;
}

/// Corners of a face and nodes of the cycle on its border, counter-clockwise seen from outside.
std::vector<RingVertex> CellShells::RingOf(const CellCycle& member, int face) const
{
  const int axis = face / 2;
  const bool upper = face % 2 == 1;
  const int u = 1 << (upper ? FirstAxis(axis) : SecondAxis(axis));
  const int v = 1 << (upper ? SecondAxis(axis) : FirstAxis(axis));
  const int base = upper ? 1 << axis : 0;
  const int corners[4] = { base, base | u, base | u | v, base | v };
  std::vector<RingVertex> ring;
  for (int i = 0; i < 4; ++i)
  {
    const int from = corners[i];
    const int to = corners[(i + 1) % 4];
    const int bit = from ^ to;
    const int t = bit == 4 ? 2 : bit == 2 ? 1 : 0;
    const int edge = EdgeOfCell(t, (from >> FirstAxis(t)) & 1, (from >> SecondAxis(t)) & 1);
    std::vector<Index> places;
    for (std::size_t n = 0; n < member.Nodes.size(); ++n)
    {
      if (member.NodeEdge[n] == edge)
      {
        places.push_back(static_cast<Index>(n));
      }
    }
    const bool upwards = to > from;
    std::sort(places.begin(), places.end(),
      [&](Index a, Index b)
      { return upwards ? member.Nodes[a] < member.Nodes[b] : member.Nodes[a] > member.Nodes[b]; });
    ring.push_back({ true, from });
    for (const Index place : places)
    {
      ring.push_back({ false, place });
    }
  }
  return ring;
}

/// Whether one comes from the region to the start of the first arc, counter-clockwise around its
/// face.
bool CellShells::IsRegionOnLeft(const CellCycle& member) const
{
  const std::vector<RingVertex> ring = this->RingOf(member, member.ArcFace.front());
  bool label = member.InRegion[ring.front().Place];
  for (const RingVertex& vertex : ring)
  {
    if (!vertex.IsCorner)
    {
      if (vertex.Place == 0)
      {
        break;
      }
      label = !label;
    }
  }
  return label;
}

/// The strip between the cycle and its copy further inside.
void CellShells::AddWall(const CellCycle& member, ShellPatch& shell) const
{
  const Index size = static_cast<Index>(member.Border.size());
  for (Index i = 0; i < size; ++i)
  {
    const Index j = (i + 1) % size;
    shell.Triangles.push_back({ i, j, -1 - j });
    shell.Triangles.push_back({ i, -1 - j, -1 - i });
  }
}

/// Triangulates a part of the region on one face. Vertices are places on the border, or -1 -
/// corner.
void CellShells::AddRegion(
  const CellCycle& member, int face, const std::vector<Index>& vertices, ShellPatch& shell) const
{
  const int axis = face / 2;
  const bool upper = face % 2 == 1;
  const int u = upper ? FirstAxis(axis) : SecondAxis(axis);
  const int v = upper ? SecondAxis(axis) : FirstAxis(axis);
  const Index size = static_cast<Index>(member.Border.size());
  // Shell points: the copies of the border, then the eight corners.
  const auto shellPoint = [&](Index place)
  {
    const Index vertex = vertices[place];
    return vertex >= 0 ? vertex : size + (-1 - vertex);
  };
  // The copies are triangulated, not the border, because rounding has moved them already.
  std::vector<Point2> polygon;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Point3& p = shell.Points[shellPoint(static_cast<Index>(i))];
    polygon.push_back({ p[u], p[v] });
  }
  for (const auto& triangle : TriangulatePolygon(polygon))
  {
    const Index a = -1 - shellPoint(triangle[0]);
    const Index b = -1 - shellPoint(triangle[1]);
    const Index c = -1 - shellPoint(triangle[2]);
    shell.Triangles.push_back(
      member.RegionOnLeft ? std::array<Index, 3>{ a, b, c } : std::array<Index, 3>{ a, c, b });
  }
}

/// Follows the border of each part of the region on a face: along the face's border, across on
/// arcs.
void CellShells::AddFace(const CellCycle& member, int face, ShellPatch& shell) const
{
  const std::vector<RingVertex> ring = this->RingOf(member, face);
  const std::size_t count = ring.size();
  const Index nodes = static_cast<Index>(member.Nodes.size());
  std::vector<std::size_t> ringPlace(nodes, 0);
  std::vector<std::uint8_t> inside(count, 0); // the piece of the border after each ring vertex
  bool label = member.InRegion[ring.front().Place];
  for (std::size_t r = 0; r < count; ++r)
  {
    label = ring[r].IsCorner ? label : !label;
    inside[r] = label;
    if (!ring[r].IsCorner)
    {
      ringPlace[ring[r].Place] = r;
    }
  }
  for (std::size_t start = 0; start < count; ++start)
  {
    std::vector<Index> vertices;
    std::size_t r = start;
    while (inside[r] == 1)
    {
      inside[r] = 2;
      vertices.push_back(ring[r].IsCorner ? -1 - ring[r].Place : member.NodePlaces[ring[r].Place]);
      r = (r + 1) % count;
      if (ring[r].IsCorner)
      {
        continue;
      }
      // The arc of the cycle on this face that starts or ends at the node.
      const Index node = ring[r].Place;
      const Index size = static_cast<Index>(member.Border.size());
      const bool forward = member.RegionOnLeft;
      const Index other = forward ? (node + 1) % nodes : (node + nodes - 1) % nodes;
      const Index last = member.NodePlaces[other];
      for (Index p = member.NodePlaces[node]; p != last;
           p = forward ? (p + 1) % size : (p + size - 1) % size)
      {
        vertices.push_back(p);
      }
      r = ringPlace[other];
    }
    if (!vertices.empty())
    {
      this->AddRegion(member, face, vertices, shell);
    }
  }
}

ShellPatch CellShells::BuildShell(const CellCycle& member, double depth) const
{
  ShellPatch shell;
  shell.Cycle = member.Cycle;
  for (const Index point : member.Border)
  {
    shell.Points.push_back(this->Inward(this->PointOf(point), depth));
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    shell.Points.push_back(this->Inward(this->Corner(corner), depth));
  }
  this->AddWall(member, shell);
  for (int face = 0; face < 6; ++face)
  {
    this->AddFace(member, face, shell);
  }
  return shell;
}

/// Drops the corners that are not used.
void Compact(ShellPatch& shell)
{
  std::vector<Index> place(shell.Points.size(), -1);
  std::vector<Point3> used;
  for (auto& triangle : shell.Triangles)
  {
    for (Index& corner : triangle)
    {
      if (corner < 0)
      {
        Index& p = place[-1 - corner];
        if (p < 0)
        {
          p = static_cast<Index>(used.size());
          used.push_back(shell.Points[-1 - corner]);
        }
        corner = -1 - p;
      }
    }
  }
  shell.Points.swap(used);
}

void CellShells::Build(const Index* first, const Index* last, std::vector<ShellPatch>& shells)
{
  std::vector<CellCycle> members;
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    members.push_back(this->Describe(*cycle));
    this->FindRegion(members.back());
    members.back().RegionOnLeft = this->IsRegionOnLeft(members.back());
  }
  this->SetExtent(members);
  this->FindHeights(members);
  for (const CellCycle& member : members)
  {
    shells.push_back(this->BuildShell(member, DeepestShell * member.Height / members.size()));
    Compact(shells.back());
  }
}

/// Whether rounding has left all triangles with an area, and apart but for common corners.
bool CellShells::AreCertainlyApart(const std::vector<ShellPatch>& shells) const
{
  std::vector<PatchTriangle> triangles;
  std::vector<Index> border, places;
  Index firstId = 0;
  for (const ShellPatch& shell : shells)
  {
    GetBoundary(
      this->Graph, this->Lattice, this->Nodes, this->Polygons, shell.Cycle, border, places);
    const Index size = static_cast<Index>(border.size());
    for (const auto& triangle : shell.Triangles)
    {
      std::array<Point3, 3> corners;
      std::array<Index, 3> ids;
      for (int i = 0; i < 3; ++i)
      {
        const Index place = triangle[i];
        corners[i] = place >= 0 ? this->PointOf(border[place]) : shell.Points[-1 - place];
        ids[i] = firstId + (place >= 0 ? place : size - 1 - place);
      }
      if (HasNoArea(corners))
      {
        return false;
      }
      triangles.push_back({ shell.Cycle, corners, ids });
    }
    firstId += size + static_cast<Index>(shell.Points.size());
  }
  return AreAllCompatible(
    triangles, [](const PatchTriangle&, const PatchTriangle&) { return true; });
}

/// Whether the triangle at a vertex turns left and has no other vertex inside or on its border.
bool IsEmptyEar(const std::vector<Point2>& polygon, const std::vector<Index>& left, std::size_t ear)
{
  const std::size_t n = left.size();
  const Index a = left[(ear + n - 1) % n];
  const Index b = left[ear];
  const Index c = left[(ear + 1) % n];
  if (SideOf(polygon[a], polygon[b], polygon[c]) <= 0)
  {
    return false;
  }
  return std::none_of(left.begin(), left.end(),
    [&](Index i)
    {
      return i != a && i != b && i != c && SideOf(polygon[a], polygon[b], polygon[i]) >= 0 &&
        SideOf(polygon[b], polygon[c], polygon[i]) >= 0 &&
        SideOf(polygon[c], polygon[a], polygon[i]) >= 0;
    });
}
}

std::vector<std::array<Index, 3>> TriangulatePolygon(const std::vector<Point2>& polygon)
{
  std::vector<Index> left(polygon.size());
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    left[i] = static_cast<Index>(i);
  }
  std::vector<std::array<Index, 3>> triangles;
  std::size_t from = 0;
  while (left.size() > 3)
  {
    const std::size_t n = left.size();
    // Start where the last ear was: long thin runs of triangles instead of one fan.
    std::size_t ear = from % n;
    std::size_t tried = 0;
    while (tried < n && !IsEmptyEar(polygon, left, ear))
    {
      ear = (ear + 1) % n;
      ++tried;
    }
    triangles.push_back({ left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n] });
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    from = ear + 1;
  }
  triangles.push_back({ left[0], left[1], left[2] });
  return triangles;
}

SeparatedPatches SeparatePatches(const SpatialGrid& grid, const NodeGraph& graph,
  const Crossings& crossings, const NodePoints& nodes, const Cycles& cycles,
  const std::vector<double>& centralPoints, const Execution& execution)
{
  const CellGroups groups = GroupByCell(grid, cycles, execution);
  std::vector<SeparatedPatches> found(groups.Several.size());
  execution.For(found.size(),
    [&](std::size_t begin, std::size_t end)
    {
      CellShells cell(grid, graph, crossings, nodes, cycles);
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index* first = groups.Cycles.data() + groups.Several[i].first;
        const Index* last = groups.Cycles.data() + groups.Several[i].second;
        if (cell.MayCross(first, last, centralPoints))
        {
          cell.Build(first, last, found[i].Shells);
          if (!cell.AreCertainlyApart(found[i].Shells))
          {
            found[i].Unresolved.assign(first, last);
          }
        }
      }
    });
  SeparatedPatches result;
  result.SharedCells = static_cast<Index>(found.size());
  for (SeparatedPatches& part : found)
  {
    std::move(part.Shells.begin(), part.Shells.end(), std::back_inserter(result.Shells));
    result.Unresolved.insert(
      result.Unresolved.end(), part.Unresolved.begin(), part.Unresolved.end());
  }
  std::sort(result.Shells.begin(), result.Shells.end(),
    [](const ShellPatch& a, const ShellPatch& b) { return a.Cycle < b.Cycle; });
  return result;
}
}
