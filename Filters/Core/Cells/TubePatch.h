// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTubePatch_h
#define OrthoSlicesTubePatch_h

#include "Core/Cells/PatchMesh.h"

#include <limits>
#include <vector>

namespace orthoslices
{
/// A closed curve: corners as in PatchMesh, and where they are.
struct PatchCurve
{
  std::vector<Index> Corners;
  std::vector<Point3> Points;

  Index Count() const { return static_cast<Index>(this->Corners.size()); }
};

/// A point of one curve and one of another.
struct PointPair
{
  Index First = 0, Second = 0;
  double Distance2 = std::numeric_limits<double>::infinity();
};

/// The nearest two points of two curves, among places on borders.
PointPair FindNearestOnBorders(const PatchCurve& a, const PatchCurve& b);

/**
 * Pairs along both curves, the second one backwards, from their nearest points around to them
 * again: from each pair to the next, one or both points advance. Least sum of squared distances,
 * by dynamic time warping (H. Sakoe and S. Chiba, 1978).
 */
std::vector<PointPair> PairPoints(const PatchCurve& a, const PatchCurve& b);

/**
 * Builds a patch of a cell from tubes between closed curves (our own addition).
 *
 * A ring of new points lies between the paired points of the two curves, the `share` of the way
 * from one to the other and strictly inside the cell, and is joined to both. Between points of one
 * face it forms an arch. Every triangle has a corner on the ring, so that the tube touches the
 * boundary of its cell in the two curves only.
 */
class TubePatch
{
public:
  /// Starts a patch of these cycles of one cell, which ascend. Keeps the address of the geometry.
  TubePatch(const CycleGeometry& geometry, const std::vector<Index>& cycles);

  /// A new corner, moved strictly into the cell.
  Index AddPoint(const Point3& point);
  /// Adds the tube between two curves that are paired; the second one runs backwards. Its ring lies
  /// the `share` of the way from the first to the second; arches are as high as the part
  /// `archHeight` of the distance that they bridge.
  void AddTube(const PatchCurve& a, const PatchCurve& b, const std::vector<PointPair>& pairs,
    double share, double archHeight);

  /// The border of the cycle at this place in the list.
  PatchCurve BorderOf(std::size_t cycle) const;
  Point3 PointAt(Index corner) const;

  PatchMesh Mesh;

private:
  Point3 Arch(const Point3& from, const Point3& to, Point3 between, double height) const;
  void AddStrip(
    const PatchCurve& curve, Index from, Index to, Index ringFrom, Index ringTo, bool flip);

  const CycleGeometry& Geometry;
  const std::array<Index, 3>& Cell;
  std::vector<Index> Borders;           ///< points of all borders, one after another
  std::vector<std::size_t> FirstPlaces; ///< of each cycle among them, and one past the last
};
}

#endif
