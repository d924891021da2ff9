// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDiscTriangulation_h
#define OrthoSlicesDiscTriangulation_h

#include "Core/Base/Predicates.h"
#include "Core/Planar/TriangleAdjacency.h"

#include <vector>

namespace orthoslices
{
/**
 * Triangulation of a disc in the plane, whose border is a given polygon and stays as it is. Points
 * are added inside: J. Ruppert, "A Delaunay Refinement Algorithm for Quality 2-Dimensional Mesh
 * Generation" (1995), with the off-centers of A. Ungor (2004). All triangles run counter-clockwise,
 * decided exactly, but for middles of sides (SplitSides), which are rounded.
 */
class DiscTriangulation
{
public:
  /// The fan around a center; false if it does not see all of the border from its left.
  bool StartWithFan(const std::vector<Point2>& border, const Point2& center);
  /// Without points inside; false if the border is not simple and counter-clockwise.
  bool StartWithEars(const std::vector<Point2>& border);
  /// Changes diagonals until each is Delaunay.
  void MakeDelaunay();
  /// Adds points where triangles are badly shaped or larger than an equilateral one with sides of
  /// about `size`, until there are maxPoints with those of the border. Sides shorter than `minimum`
  /// count as long as that: no points crowd around a tiny side of the border.
  void Refine(double size, std::size_t maxPoints, double minimum = 0.0);
  /// Adds a point in the middle of the sides for which the predicate holds.
  template <typename Predicate>
  void SplitSides(Predicate&& isToSplit)
  {
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      int side = 0;
      while (side < 3)
      {
        const LinkedTriangle& triangle = this->Triangles[t];
        const bool split = triangle.Neighbors[side] >= 0 &&
          isToSplit(triangle.Corners[side], triangle.Corners[(side + 1) % 3]);
        if (split)
        {
          this->Split({ static_cast<Index>(t), side });
        }
        side = split ? 0 : side + 1; // the triangle has become another one
      }
    }
  }

  std::vector<Point2> Points; ///< first those of the border
  TriangleAdjacency Triangles;

private:
  bool IsDelaunay(const TriangleSide& side) const;
  void Flip(const TriangleSide& side);
  void Legalize();
  void Split(const TriangleSide& side);
  void Insert(Index t, const Point2& p);
  Index Locate(Index from, const Point2& p) const;
  bool Encroaches(Index t, const Point2& p) const;
  bool FindNewPoint(const LinkedTriangle& t, double size, double minimum, Point2& p) const;

  std::vector<TriangleSide> Doubtful; ///< sides that may have ceased to be Delaunay
  std::vector<Index> Queue;           ///< triangles whose shape is still to be looked at
};
}

#endif
