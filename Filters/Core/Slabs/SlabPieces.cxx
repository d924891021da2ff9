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

/**
 * Vertices minus edges plus triangles of each piece. Its open edges are those of its contours, each
 * with one triangle; all others have two.
 */
std::vector<Index> EulerOfPieces(const SlabOverlay& overlay, const std::vector<Index>& loopOf,
  const std::vector<Index>& pieceOfLoop, std::size_t pieces)
{
  std::vector<Index> vertices(pieces, 0), open(pieces, 0), triangles(pieces, 0);
  for (const Index loop : loopOf)
  {
    ++vertices[pieceOfLoop[loop]];
    ++open[pieceOfLoop[loop]];
  }
  std::vector<std::uint8_t> isCounted(overlay.Points.size(), 0);
  for (std::size_t t = 0; t < overlay.Triangles.size(); ++t)
  {
    const Index piece = overlay.Piece[t];
    ++triangles[piece];
    for (const Index corner : overlay.Triangles[t])
    {
      const std::size_t own = static_cast<std::size_t>(corner) - loopOf.size();
      if (corner >= static_cast<Index>(loopOf.size()) && isCounted[own] == 0)
      {
        isCounted[own] = 1;
        ++vertices[piece];
      }
    }
  }
  std::vector<Index> euler(pieces);
  for (std::size_t i = 0; i < pieces; ++i)
  {
    euler[i] = vertices[i] - (3 * triangles[i] + open[i]) / 2 + triangles[i];
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
  std::vector<Index> pieceOfLoop(group.Outlines.size(), 0);
  for (std::size_t t = 0; t < overlay.Triangles.size(); ++t)
  {
    for (const Index corner : overlay.Triangles[t])
    {
      if (corner < static_cast<Index>(loopOf.size()))
      {
        pieceOfLoop[loopOf[corner]] = overlay.Piece[t];
      }
    }
  }
  for (std::size_t loop = 0; loop < pieceOfLoop.size(); ++loop)
  {
    SlabPiece& piece = pieces[pieceOfLoop[loop]];
    piece.Loops.push_back(static_cast<Index>(loop));
    const SlabLoop& first = group.Outlines[piece.Loops.front()];
    piece.Across |= group.Outlines[loop].Upper != first.Upper;
    piece.Mixed |= IsHole(group.Outlines[loop]) != IsHole(first);
  }
  const std::vector<Index> euler = EulerOfPieces(overlay, loopOf, pieceOfLoop, pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    pieces[i].Handles = (2 - static_cast<Index>(pieces[i].Loops.size()) - euler[i]) / 2;
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
