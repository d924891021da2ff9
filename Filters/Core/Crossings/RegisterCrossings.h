// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRegisterCrossings_h
#define OrthoSlicesRegisterCrossings_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Slices/SpatialGrid.h"

#include <vector>

namespace orthoslices
{
/**
 * Where the contours cross the lattice of the orthogonal planes (the paper's section 4.2, step 1).
 *
 * Crossing c lies on the edge Edge[c] of M, at the coordinate Position[c] along it. Its contour
 * goes on to Next[c] and comes from Previous[c]; Next[c] = Removed marks a crossing that
 * reconciliation took out.
 *
 * *Arc* c is the part of the contour from crossing c to Next[c]. It lies on one face of M. Its
 * geometry is a chain of runs of contour vertices: run r has RunCount[r] vertices of
 * RunContour[r], cyclic from vertex RunFirst[r], and is followed by run RunNext[r]. Arc c begins
 * with run c; ArcLastRun[c] is its last run.
 */
struct GridCrossings
{
  static constexpr Index Removed = -1;
  static constexpr Index None = -1;

  std::vector<std::uint64_t> Edge;
  std::vector<double> Position;
  /// 1 if the contour goes from the lower to the upper side of the plane that it crosses, else -1.
  std::vector<std::int8_t> Direction;
  /// 0 for a contour on a slice of FirstAxis(edge direction), 1 for one of SecondAxis.
  std::vector<std::int8_t> Family;
  std::vector<Index> Next, Previous;
  std::vector<Index> RunContour, RunFirst, RunCount, RunNext;
  std::vector<Index> ArcLastRun;

  Index Count() const { return static_cast<Index>(this->Edge.size()); }
  bool IsRemoved(Index crossing) const { return this->Next[crossing] == Removed; }
  void Resize(std::size_t count);

  /// Adds a crossing that belongs to no contour, without a run of vertices; Next and Previous are
  /// left to the caller. Returns its number.
  Index Insert(std::uint64_t edge, double position, int direction, int family);

  /// 1 if the interior begins here in the direction of the edge, -1 if it ends.
  int Sign(Index crossing) const
  {
    return this->Family[crossing] == 0 ? this->Direction[crossing] : -this->Direction[crossing];
  }
};

/// A run of vertices that closes in itself: a contour, or a part of one, without node points.
struct IsolatedLoop
{
  Index FirstRun; ///< run in the Crossings, or None for a whole contour
  Index Contour;  ///< the whole contour, if FirstRun is None
};

/**
 * Crossings filed on the edges of M, ascending by edge, family and position: edge e has the
 * crossings Crossing[Offsets[e]] to Crossing[Offsets[e + 1] - 1].
 */
struct EdgeRegister
{
  std::vector<Index> Crossing;
  std::vector<Index> Offsets{ 0 };

  Index Count() const { return static_cast<Index>(this->Offsets.size()) - 1; }
};

/**
 * Walks along every contour and registers its crossings with the planes of the two other axes.
 *
 * A contour changes its slab one plane at a time, so consecutive crossings lie on the boundary of
 * the same face and the sequence of faces is consistent whatever the rounding; positions are
 * clamped into their edge. Where a contour passes exactly through a vertex of M, the planes count
 * as moved down by infinitesimals, largest for x, smallest for z. Contours without a crossing are
 * appended to `isolated`.
 */
GridCrossings RegisterCrossings(const Contours& contours, const SpatialGrid& grid,
  const Execution& execution, std::vector<IsolatedLoop>& isolated);

/// Where a side from p to q passes a plane across its first coordinate: the second one there, the
/// same to the last bit for either direction of the side (SpatialGrid::BothWays).
double InterpolateFromLesser(double plane, const Point2& p, const Point2& q);

/// Files the crossings that are not removed on their edges.
EdgeRegister FileOnEdges(const GridCrossings& crossings);

/// The point of the lattice line at a crossing, in world coordinates.
Point3 CrossingPoint(
  const SpatialGrid& grid, const GridEdgeCode& code, std::uint64_t edge, double position);
}

#endif
