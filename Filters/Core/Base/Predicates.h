// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPredicates_h
#define OrthoSlicesPredicates_h

#include "Core/Base/Types.h"

#include <cmath>
#include <vector>

/**
 * Geometric predicates. Those in the plane are exact. Those in space say when they are not
 * certain, and their users are conservative: what is not certainly apart is drawn in another way.
 * So rounding can cost a little accuracy in rare places, never a guarantee. The error bounds are
 * those of J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
 * Geometric Predicates" (1997).
 */
namespace orthoslices
{
/// The sign of SideOf in exact arithmetic, for the rare case that rounding could change it.
int ExactSideOf(const Point2& p, const Point2& q, const Point2& r);

/// Greatest error of the determinant in SideOf, as a share of the sum of its terms' sizes:
/// Shewchuk's ccwerrboundA = (3 + 16 e) e with e = 2^-53.
constexpr double SideOfErrorBound = 3.3306690738754716e-16;

/// Side of r against the line from p to q: 1 left, -1 right, 0 on the line. Exact.
inline int SideOf(const Point2& p, const Point2& q, const Point2& r)
{
  const double left = (p[0] - r[0]) * (q[1] - r[1]);
  const double right = (p[1] - r[1]) * (q[0] - r[0]);
  const double bound = SideOfErrorBound * (std::abs(left) + std::abs(right));
  const double det = left - right;
  return det > bound ? 1 : det < -bound ? -1 : ExactSideOf(p, q, r);
}

/// Whether q and r lie on one ray from p, and neither in p. Exact.
bool AreOnOneRay(const Point2& p, const Point2& q, const Point2& r);

/// Whether r lies on the left of the path from a over b to c, near b. Exact. REQUIRES: neither a
/// and c nor r and one of them lie on one ray from b.
inline bool IsLeftOfPath(const Point2& a, const Point2& b, const Point2& c, const Point2& r)
{
  const bool first = SideOf(a, b, r) > 0;
  const bool second = SideOf(b, c, r) > 0;
  return SideOf(a, b, c) > 0 ? first && second : first || second;
}

/// Area of a polygon, positive if it runs counter-clockwise. Rounded.
double SignedArea(const std::vector<Point2>& polygon);

/// Whether a point lies inside a polygon. It must not lie on its border. Exact.
bool IsInside(const std::vector<Point2>& polygon, const Point2& point);

/// Side of d against the plane of abc: 1 if a, b, c run counter-clockwise seen from d, -1, 0 not
/// certain.
int CertainSide(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Whether two closed triangles certainly have no point in common. Callers compare the triangles'
/// boxes first, which costs less.
bool CertainlyApart(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t);

/// Whether two triangles with common corners certainly have no point in common but those, or, with
/// two of them, the side between. The corners are listed by their places in s and, in the same
/// order, in t. False unless one or two are in common.
bool CertainlyApartBeyond(const std::vector<int>& common, const std::array<Point3, 3>& s,
  const std::vector<int>& commonOfOther, const std::array<Point3, 3>& t);

/// The corners that two triangles have in common, by the numbers of their points.
struct CommonCorners
{
  std::vector<int> OfFirst, OfSecond; ///< their places in each, in the same order

  void Find(const std::array<Index, 3>& first, const std::array<Index, 3>& second);
};

/// Whether two triangles certainly meet in their common corners only.
bool CertainlyApartBeyond(
  const CommonCorners& common, const std::array<Point3, 3>& s, const std::array<Point3, 3>& t);

/// Whether the corners of a triangle lie on one line in every projection.
bool HasNoArea(const std::array<Point3, 3>& triangle);
}

#endif
