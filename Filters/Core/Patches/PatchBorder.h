// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchBorder_h
#define OrthoSlicesPatchBorder_h

#include "Core/Base/Box.h"
#include "Core/Base/Predicates.h"
#include "Core/Graph/CycleGeometry.h"
#include "Core/Patches/EstimateNormals.h"

#include <vector>

namespace orthoslices
{
/**
 * Least distance of the points inside a patch from the faces of their cell, as a part of the cell's
 * width. The surface may run along a face, so it is far less than CentralPointMargin: points moved
 * by it are off the surface by a hundredth of what smooth patches are accurate to. Where the
 * precision does not resolve it, the grid's Margin takes its place.
 */
constexpr double InnerMargin = 1e-5;

/// The border of a patch of one cycle, with the surface's normals: what patches are made of.
struct PatchBorder
{
  std::vector<Index> Points;     ///< of G
  std::vector<Index> NodePlaces; ///< where the node points are among them
  std::vector<Point3> Places;
  std::vector<Point3> Normals;
  std::vector<double> Weights; ///< length of border that each point stands for; their sum is 1
  Point3 Center;               ///< centroid of the border
  Box3 Room;                   ///< where points inside the cell may be

  void Set(const CycleGeometry& geometry, const SurfaceNormals& normals, Index cycle);
  Index Count() const { return static_cast<Index>(this->Points.size()); }
  /// Makes the least place the first one, whatever the order of the contours. Returns its number.
  Index Turn();
  /// Whether two points are on one face of the cell, or almost.
  bool AreOnOneFace(Index a, Index b) const;
  /// The nearest place for a point, as it will be in the result.
  Point3 MoveInside(const SpatialGrid& grid, const Point3& place) const;
};

/// A patch of one cycle with points inside. Corners of triangles are as in PatchMesh.
struct InnerPatch
{
  std::vector<Point3> Points;  ///< one at least, strictly inside the cell
  std::vector<Point3> Normals; ///< of unit length
  std::vector<std::array<Index, 3>> Triangles;

  void Clear();
};
}

#endif
