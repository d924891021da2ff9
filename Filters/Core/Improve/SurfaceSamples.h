// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSurfaceSamples_h
#define OrthoSlicesSurfaceSamples_h

#include "Core/Improve/CrossingGuard.h"
#include "Core/Improve/ImprovableMesh.h"
#include "Core/Improve/MeshBlock.h"
#include "Core/Improve/PointStar.h"

#include <vector>

namespace orthoslices
{
/**
 * The points that a surface had at first, which have to stay near it however often it is changed:
 * each is a corner of the surface until that moves or vanishes, and belongs to the nearest of the
 * triangles around it from then on. Points inside plain patches say nothing and are no samples.
 */
class SurfaceSamples
{
public:
  SurfaceSamples(const ImprovableMesh& mesh, const ImprovementLimits& limits);

  /// The samples of a part of a surface: at its points, and on those of its triangles that may
  /// change.
  SurfaceSamples(const SurfaceSamples& whole, const MeshBlock& block);
  /// Those of a part on one of its triangles, by their numbers in the whole, are appended.
  void AppendSamplesOn(Index triangle, std::vector<Index>& samples) const;
  /// The samples of the whole on a triangle are these from now on. Several triangles may get theirs
  /// at the same time.
  void Put(Index triangle, Index plain, const Index* begin, const Index* end);
  /// Makes room for new triangles.
  void Grow(Index triangles);

  /// See ImprovableMesh.
  Index PlainOf(Index triangle) const { return this->Plain[triangle]; }

  /// How far the side between two triangles may move.
  double ToleranceOfSide(Index triangle, Index other) const;

  /// How far the surface may move inside plain patches.
  double ToleranceInside() const { return this->PlainTolerance; }

  /// Whether the samples on a star, and the middles of its sides, are near the triangles that would
  /// take its place: within `slack` tolerances.
  bool AreNear(const PointStar& star, double slack) const;
  /// Whether the samples on triangles that are removed are near those that are added.
  bool AreNear(const SurfaceChange& change, const std::vector<Point3>& points, double slack) const;

  /// Picks up the samples on triangles that are removed, and a point that moves or vanishes or -1,
  void Take(const std::vector<Index>& triangles, Index point);
  /// and puts them down on the nearest triangle at a point that may change, or of two.
  void PutDown(Index point);
  void PutDown(Index triangle, Index other);

  /// Has to be called for each new triangle: it is part of the patch of another one.
  void AddTriangle(Index like);

private:
  bool IsCornerYet(Index point) const
  {
    return point < this->Corners && this->Next[point] == IsCorner;
  }
  double DistanceTo(Index triangle, Index sample) const;
  void PutDown(const std::vector<Index>& triangles);
  void CopyFiled(const SurfaceSamples& whole, const MeshBlock& block);

  static constexpr Index IsCorner = -2; ///< the sample is a corner where it was at first
  static constexpr Index IsNone = -3;   ///< the point is no sample

  const ImprovableMesh& Mesh;
  const MeshBlock* Block = nullptr; ///< that these are samples of; null: the whole
  Index Corners;                    ///< the first so many samples are those of points
  double Tolerance, PlainTolerance;
  std::vector<Point3> Places; ///< of samples
  std::vector<Index> Plain;   ///< of each triangle; see ImprovableMesh
  std::vector<Index> First;   ///< of each triangle the first of its samples; -1: none
  std::vector<Index> Next;    ///< of each sample the next one of its triangle; -1: none
  std::vector<Index> Others;  ///< of a part: of each of the other samples its number in the whole
  std::vector<Index> Taken, Candidates;
};
}

#endif
