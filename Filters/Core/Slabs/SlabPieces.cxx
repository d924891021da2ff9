// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/SlabPieces.h"

#include "Core/Base/Vectors.h"
#include "Core/Correspondence/ContourNesting.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The loop of each corner of the overlay that is on a contour.
std::vector<Index> LoopsOfCorners(const SlabGroup& group)
{
  std::vector<Index> loops;
  for (std::size_t i = 0; i < group.Outlines.size(); ++i)
  {
    loops.insert(loops.end(), group.Outlines[i].Points.size(), static_cast<Index>(i));
  }
  for (const SlabOverlay::Insertion& insertion : group.Overlay.Insertions)
  {
    loops.push_back(insertion.Loop);
  }
  return loops;
}

/// Where the corners of a straight overlay are, seen along the axis.
std::vector<Point2> PlacesOfCorners(const SlabGroup& group)
{
  std::vector<Point2> places;
  for (const SlabLoop& loop : group.Outlines)
  {
    places.insert(places.end(), loop.Points.begin(), loop.Points.end());
  }
  for (const SlabOverlay::Insertion& insertion : group.Overlay.Insertions)
  {
    const std::vector<Point2>& points = group.Outlines[insertion.Loop].Points;
    const Point2& p = points[insertion.After];
    const Point2& q = points[(insertion.After + 1) % points.size()];
    places.push_back(p + insertion.Share * (q - p));
  }
  for (const Point3& p : group.Overlay.Points)
  {
    places.push_back({ p[0], p[1] });
  }
  return places;
}

/// Distinct pairs of a piece and something of it, counted by piece.
template <typename Item>
std::vector<Index> CountByPiece(std::vector<std::pair<Index, Item>>& items, std::size_t pieces)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  std::vector<Index> count(pieces, 0);
  for (const auto& item : items)
  {
    ++count[item.first];
  }
  return count;
}

/// Vertices minus edges plus triangles of each piece.
std::vector<Index> EulerOfPieces(const SlabOverlay& overlay, std::size_t pieces)
{
  std::vector<std::pair<Index, Index>> corners;
  std::vector<std::pair<Index, std::pair<Index, Index>>> edges;
  std::vector<Index> euler(pieces, 0);
  for (std::size_t t = 0; t < overlay.Triangles.size(); ++t)
  {
    const Index piece = overlay.Piece[t];
    ++euler[piece];
    for (int i = 0; i < 3; ++i)
    {
      const Index a = overlay.Triangles[t][i];
      const Index b = overlay.Triangles[t][(i + 1) % 3];
      corners.emplace_back(piece, a);
      edges.emplace_back(piece, std::minmax(a, b));
    }
  }
  const std::vector<Index> vertices = CountByPiece(corners, pieces);
  const std::vector<Index> sides = CountByPiece(edges, pieces);
  for (std::size_t piece = 0; piece < pieces; ++piece)
  {
    euler[piece] += vertices[piece] - sides[piece];
  }
  return euler;
}
}

bool IsHole(const SlabLoop& loop) { return SignedArea(loop.Points) < 0.0; }

std::vector<SlabPiece> DescribePieces(const SlabGroup& group)
{
  const SlabOverlay& overlay = group.Overlay;
  std::vector<SlabPiece> pieces(static_cast<std::size_t>(CountPieces(overlay)));
  const std::vector<Index> loopOf = LoopsOfCorners(group);
  for (std::size_t t = 0; t < overlay.Triangles.size(); ++t)
  {
    for (const Index corner : overlay.Triangles[t])
    {
      std::vector<Index>& loops = pieces[overlay.Piece[t]].Loops;
      if (corner < static_cast<Index>(loopOf.size()) &&
        (loops.empty() || loops.back() != loopOf[corner]))
      {
        loops.push_back(loopOf[corner]);
      }
    }
  }
  const std::vector<Index> euler = EulerOfPieces(overlay, pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    SlabPiece& piece = pieces[i];
    std::sort(piece.Loops.begin(), piece.Loops.end());
    piece.Loops.erase(std::unique(piece.Loops.begin(), piece.Loops.end()), piece.Loops.end());
    piece.Handles = (2 - static_cast<Index>(piece.Loops.size()) - euler[i]) / 2;
    const SlabLoop& first = group.Outlines[piece.Loops.front()];
    for (const Index loop : piece.Loops)
    {
      piece.Across |= group.Outlines[loop].Upper != first.Upper;
      piece.Mixed |= IsHole(group.Outlines[loop]) != IsHole(first);
    }
  }
  return pieces;
}

std::vector<Index> FindNesting(const std::vector<SlabLoop>& loops)
{
  ContourStack stack;
  stack.Coordinate = { 0.0, 1.0 };
  std::vector<Index> members;
  for (const bool upper : { false, true })
  {
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      if (loops[i].Upper != upper)
      {
        continue;
      }
      members.push_back(static_cast<Index>(i));
      for (const Point2& p : loops[i].Points)
      {
        stack.U.push_back(p[0]);
        stack.V.push_back(p[1]);
      }
      stack.Offsets.push_back(static_cast<Index>(stack.U.size()));
      stack.Slice.push_back(upper ? 1 : 0);
    }
  }
  const std::vector<Index> parents = FindParents(stack);
  std::vector<Index> nesting(loops.size(), -1);
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    nesting[members[i]] = parents[i] < 0 ? -1 : members[parents[i]];
  }
  return nesting;
}

double CommonShare(const SlabGroup& group, const std::vector<Index>& loops)
{
  std::array<double, 2> inside{ 0.0, 0.0 };
  for (const Index loop : loops)
  {
    inside[group.Outlines[loop].Upper ? 1 : 0] += SignedArea(group.Outlines[loop].Points);
  }
  // What is inside below only is seen from above.
  const std::vector<SlabPiece> pieces = DescribePieces(group);
  std::vector<std::uint8_t> counts(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    counts[i] = std::binary_search(loops.begin(), loops.end(), pieces[i].Loops.front()) ? 1 : 0;
  }
  const std::vector<Point2> places = PlacesOfCorners(group);
  double belowOnly = 0.0;
  for (std::size_t t = 0; t < group.Overlay.Triangles.size(); ++t)
  {
    const auto& [a, b, c] = group.Overlay.Triangles[t];
    const double area = 0.5 * Cross(places[b] - places[a], places[c] - places[a]);
    belowOnly += counts[group.Overlay.Piece[t]] != 0 ? std::max(0.0, area) : 0.0;
  }
  const double smaller = std::min(inside[0], inside[1]);
  return smaller > 0.0 ? (inside[0] - belowOnly) / smaller : 0.0;
}
}
