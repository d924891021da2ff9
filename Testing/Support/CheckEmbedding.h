// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether triangles meet in common edges and vertices only, decided exactly
 *
 * A checker of its own: no code, no predicate and no search structure of the reconstruction, and no
 * library either. Every sign is exact, whatever the coordinates, as long as no product of three of
 * them leaves the range of double.
 */

#ifndef OrthoSlicesCheckEmbedding_h
#define OrthoSlicesCheckEmbedding_h

#include "Support/TriangleMesh.h"

#include <string>

namespace orthoslices
{
namespace support
{

/// Two triangles that meet where they must not; the same one twice if it has no area.
struct Meeting
{
  std::int64_t First, Second;
};

/**
 * Pairs of triangles with a point in common that is on neither a common edge nor a common vertex,
 * at most `maximum` of them. Vertices are common if their ids are the same; two ids at one place
 * are two vertices, and meet.
 */
std::vector<Meeting> FindMeetings(const TriangleMesh& mesh, std::size_t maximum = 10);

/**
 * Pairs of triangles of which one has a side that passes through the inside of the other. Pairs
 * that only touch or overlap in a plane are not counted: the figure is fair to any surface, also to
 * one whose triangles do not share their points.
 */
std::int64_t CountCrossings(const TriangleMesh& mesh);

/**
 * What is wrong with the surface: edges and vertices (G1 to G3) and triangles that meet (G6), with
 * coordinates. Empty if all is right.
 */
std::string DescribeFlaws(const TriangleMesh& mesh);

/// Sign of the determinant of (a - d, b - d, c - d), exactly.
int ExactOrientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Sign of the area of abc, seen along the axis, exactly.
int ExactTurn(const Point3& a, const Point3& b, const Point3& c, int axis);

/// Whether the closed segments ab and cd have a point in common, seen along the axis, exactly.
bool SegmentsMeet(const Point3& a, const Point3& b, const Point3& c, const Point3& d, int axis);

/// Whether a side of a triangle passes from one side of another one to the other, through its
/// inside, exactly. Corners that both have in common are marked; sides that begin or end there do
/// not.
bool Pierces(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t,
  const std::array<bool, 3>& isCommon);

} // namespace support
} // namespace orthoslices

#endif
