// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/OverlaySurface.h"

#include "Core/Base/DisjointSets.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
constexpr Index None = -1;

using Triangle = std::array<Index, 3>;

/// Makes the surface of an overlay.
class OverlaySurface
{
public:
  OverlaySurface(const OverlayGraph& graph, const Point2& displacement)
    : Graph(graph)
    , Displacement(displacement)
  {
    this->Result.Insertions = graph.GetInsertions();
  }

  void AddRegion(const PlaneRegion& region, const TriangleAdjacency& triangles, bool clockwise);
  SlabOverlay Finish()
  {
    this->NumberPieces();
    this->Result.Valid = true;
    return std::move(this->Result);
  }

private:
  std::vector<std::int8_t> ChooseLevels(
    const PlaneRegion& region, const TriangleAdjacency& triangles) const;
  void AddTriangle(const Triangle& corners, const Triangle& middles, bool clockwise);
  void Add(Index a, Index b, Index c, bool clockwise);
  Index AddPoint(double u, double v, bool above);
  void NumberPieces();

  const OverlayGraph& Graph;
  const Point2 Displacement;
  SlabOverlay Result;
};

/**
 * The triangles at a crossing all use one of its two corners, and a vertical triangle beside the
 * contour of the other one closes the gap. Chosen so that few edges are flat.
 */
std::vector<std::int8_t> OverlaySurface::ChooseLevels(
  const PlaneRegion& region, const TriangleAdjacency& triangles) const
{
  std::vector<std::int8_t> levels = this->Graph.GetLevels();
  std::vector<std::array<Index, 2>> edges; // from crossings
  for (const LinkedTriangle& triangle : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangle.Corners[i];
      const Index b = triangle.Corners[(i + 1) % 3];
      if (triangle.Neighbors[i] != None && this->Graph.IsCrossing(a))
      {
        edges.push_back({ a, b });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t edge = 0;
  for (Index node = this->Graph.CountVertices(); node < static_cast<Index>(levels.size()); ++node)
  {
    std::array<int, 3> count{ 0, 0, 0 };
    // Beside a contour between two crossings it is better to have an edge that goes up.
    for (const Index beside : { region.Next[node], region.Previous[node] })
    {
      const int level = region.Level[beside == region.Next[node] ? node : beside];
      if (this->Graph.IsCrossing(beside) && levels[beside] == 1 - level)
      {
        ++count[1 - level];
      }
    }
    for (; edge < edges.size() && edges[edge][0] == node; ++edge)
    {
      ++count[levels[edges[edge][1]]];
    }
    levels[node] = count[1] < count[0] ? 1 : 0;
  }
  return levels;
}

Index OverlaySurface::AddPoint(double u, double v, bool above)
{
  // The displacement is sheared back here, so that it does not show at all.
  this->Result.Points.push_back(
    { u - 0.5 * this->Displacement[0], v - 0.5 * this->Displacement[1], 0.5 });
  this->Result.Above.push_back(above ? 1 : 0);
  return this->Graph.CountVertices() +
    static_cast<Index>(this->Result.Insertions.size() + this->Result.Points.size()) - 1;
}

void OverlaySurface::Add(Index a, Index b, Index c, bool clockwise)
{
  this->Result.Triangles.push_back(clockwise ? Triangle{ a, c, b } : Triangle{ a, b, c });
}

/// Cuts up a triangle with points in the middle of edges.
void OverlaySurface::AddTriangle(const Triangle& corners, const Triangle& middles, bool clockwise)
{
  const auto count =
    std::count_if(middles.begin(), middles.end(), [](Index i) { return i != None; });
  int first = 0; // the first of the edges with points
  while (count > 0 && count < 3 && (middles[first] == None || middles[(first + 2) % 3] != None))
  {
    ++first;
  }
  const Index a = corners[first];
  const Index b = corners[(first + 1) % 3];
  const Index c = corners[(first + 2) % 3];
  const Index ab = middles[first];
  const Index bc = middles[(first + 1) % 3];
  const Index ca = middles[(first + 2) % 3];
  if (count == 0)
  {
    this->Add(a, b, c, clockwise);
    return;
  }
  if (count == 1)
  {
    this->Add(a, ab, c, clockwise);
    this->Add(ab, b, c, clockwise);
    return;
  }
  this->Add(ab, b, bc, clockwise);
  if (count == 2)
  {
    this->Add(a, ab, bc, clockwise);
    this->Add(a, bc, c, clockwise);
    return;
  }
  this->Add(a, ab, ca, clockwise);
  this->Add(ca, bc, c, clockwise);
  this->Add(ab, bc, ca, clockwise);
}

void OverlaySurface::AddRegion(
  const PlaneRegion& region, const TriangleAdjacency& triangles, bool clockwise)
{
  const std::vector<std::int8_t> levels = this->ChooseLevels(region, triangles);
  const std::vector<Point2>& places = this->Graph.GetPlaces();
  const auto cornerAt = [&](Index node, int level) { return this->Graph.CornerAt(node, level); };
  const auto addMiddle = [&](Index a, Index b)
  {
    return this->AddPoint(
      0.5 * (places[a][0] + places[b][0]), 0.5 * (places[a][1] + places[b][1]), clockwise);
  };
  std::vector<Triangle> middles(triangles.size(), Triangle{ None, None, None });
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Triangle& nodes = triangles[t].Corners;
    Triangle corners;
    bool isFlat = true;
    for (int i = 0; i < 3; ++i)
    {
      const Index a = nodes[i];
      const Index b = nodes[(i + 1) % 3];
      const int from = levels[a];
      const int to = levels[b];
      corners[i] = cornerAt(a, from);
      const Index other = triangles[t].Neighbors[i];
      if (other != None)
      {
        if (from == to && middles[t][i] == None)
        {
          const int back = triangles[other].SideTo(static_cast<Index>(t));
          middles[t][i] = middles[other][back] = addMiddle(a, b);
        }
        isFlat = false;
        continue;
      }
      // Between the triangle's edge and the contour there is a vertical gap.
      const int level = region.Level[a];
      const Index start = cornerAt(a, level);
      const Index end = cornerAt(b, level);
      isFlat = isFlat && from == level && to == level;
      if (from != level && to != level)
      {
        const Index middle = middles[t][i] = addMiddle(a, b);
        this->Add(start, end, middle, clockwise);
        this->Add(end, cornerAt(b, to), middle, clockwise);
        this->Add(middle, cornerAt(a, from), start, clockwise);
      }
      else if (from != level || to != level)
      {
        this->Add(start, end, from != level ? cornerAt(a, from) : cornerAt(b, to), clockwise);
      }
    }
    if (isFlat)
    {
      // A contour of three vertices, without partner.
      const Index middle =
        this->AddPoint((places[nodes[0]][0] + places[nodes[1]][0] + places[nodes[2]][0]) / 3.0,
          (places[nodes[0]][1] + places[nodes[1]][1] + places[nodes[2]][1]) / 3.0, clockwise);
      for (int i = 0; i < 3; ++i)
      {
        this->Add(corners[i], corners[(i + 1) % 3], middle, clockwise);
      }
      continue;
    }
    this->AddTriangle(corners, middles[t], clockwise);
  }
}

void OverlaySurface::NumberPieces()
{
  DisjointSets pieces(static_cast<Index>(
    this->Graph.CountVertices() + this->Result.Insertions.size() + this->Result.Points.size()));
  for (const Triangle& t : this->Result.Triangles)
  {
    pieces.Unite(t[0], t[1]);
    pieces.Unite(t[1], t[2]);
  }
  std::vector<Index> number(pieces.Count(), None);
  Index count = 0;
  for (const Triangle& t : this->Result.Triangles)
  {
    Index& piece = number[pieces.Find(t[0])];
    piece = piece == None ? count++ : piece;
    this->Result.Piece.push_back(piece);
  }
}
}

SlabOverlay MakeOverlaySurface(const OverlayGraph& graph, const std::array<PlaneRegion, 2>& regions,
  const std::array<TriangleAdjacency, 2>& triangles, const Point2& displacement)
{
  OverlaySurface surface(graph, displacement);
  for (const bool above : { false, true })
  {
    surface.AddRegion(regions[above], triangles[above], above);
  }
  return surface.Finish();
}
}
