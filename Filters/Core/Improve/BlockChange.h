// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBlockChange_h
#define OrthoSlicesBlockChange_h

#include "Core/Base/Ranks.h"
#include "Core/Improve/BlockImprover.h"

#include <vector>

namespace orthoslices
{
/// What is known of triangles, besides where they are.
struct TriangleMarks
{
  std::vector<std::uint8_t> Tried;    ///< it was looked at as it is
  std::vector<std::uint8_t> IsFolded; ///< onto one with a greater number, as far as is known
};

/// A triangle of a block that may have changed. Numbers are those of the whole surface.
struct ChangedTriangle
{
  Index Number;
  std::array<Index, 3> Vertices;      ///< -1 if the triangle is gone
  std::array<std::uint8_t, 3> Curves; ///< whether its edges are
  Index Origin;                       ///< of new ones; see ImprovableMesh
  Index Plain;                        ///< see ImprovableMesh
  Index SampleCount;                  ///< how many samples are on it

  bool IsGone() const { return this->Vertices[0] < 0; }
};

/// A triangle of a block, with marks that are others than they were.
struct ChangedMarks
{
  Index Number;
  std::uint8_t Tried, IsFolded;
};

/// A point of a block that may have moved.
struct ChangedPoint
{
  Index Number;
  Index Room; ///< see ImprovableMesh
  Point3 Place, Normal;
};

/**
 * What comes of a block that was improved by itself: all that may differ in the surface from then
 * on. Plain data: processes that improve a surface together hand it on.
 *
 * New triangles and points have the next numbers after those of the surface, as if there were no
 * other block, until Renumber gives each block its own.
 */
struct BlockChange
{
  struct Counts
  {
    Index Triangles = 0, Points = 0;
  };

  Counts New; ///< how many are
  std::vector<ChangedTriangle> Triangles;
  std::vector<ChangedPoint> Points;
  std::vector<ChangedMarks> Marks;
  std::vector<Index> Samples; ///< those on the triangles, one after another

  /// `there` is what the surface has, and `before` what is new of other blocks.
  void Renumber(const Counts& there, const Counts& before);
};

/// Lists what has changed in a block that was improved. The whole is as it was before.
BlockChange ListChange(const MeshBlock& block, const BlockImprover& improver,
  const ImprovableMesh& whole, const TriangleMarks& marks);

/// Gives all processes the changes of all: each has made those of its rank.
void ExchangeChanges(
  const Ranks& ranks, const int* rankOfChange, std::vector<BlockChange>& changes);
}

#endif
