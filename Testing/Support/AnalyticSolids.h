// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   solids given by an implicit function, with known topology
 *
 * A solid is the union of tubes around skeletons: points, line segments, circles, curves. Its value
 * is the distance to the nearest tube's surface, negative inside. Or it is given by any function
 * that is negative inside.
 */

#ifndef OrthoSlicesAnalyticSolids_h
#define OrthoSlicesAnalyticSolids_h

#include "Core/Base/Types.h"

#include <functional>
#include <string>
#include <vector>

namespace orthoslices
{
namespace support
{

/// All points at most Radius away from the skeleton.
struct Tube
{
  std::function<Point3(const Point3&)> Nearest; ///< point of the skeleton
  double Radius;
};

class Solid
{
public:
  std::string Name;
  Point3 Low, High;    ///< box with the solid well inside
  int Components = -1; ///< -1: not known
  int Genus = -1;      ///< sum over the components; -1: not known
  std::vector<Tube> Tubes;
  std::function<double(const Point3&)> Function; ///< if set, instead of Tubes

  double Value(const Point3& p) const;
  Point3 Gradient(const Point3& p) const;

private:
  const Tube& NearestTube(const Point3& p) const;
};

Tube Ball(const Point3& center, double radius);
Tube Capsule(const Point3& a, const Point3& b, double radius);
Tube Torus(const Point3& center, const Point3& axis, double majorRadius, double minorRadius);
Tube CurveTube(std::vector<Point3> points, bool closed, double radius);

Solid TiltedTorus();
Solid InclinedThinTube(); ///< contours of consecutive z-slices do not overlap
Solid BranchingTube();    ///< one tube that becomes two
Solid KnottedTube();      ///< trefoil
Solid LinkedTori();
Solid Cochlea();         ///< spiral that turns back within the slices
Solid HollowBall();      ///< outer surface and the surface of a cavity: two components
Solid TwoDistantBalls(); ///< with empty planes between them

std::vector<Solid> AllAnalyticSolids();

/// Union of 1 to 6 balls, capsules and tori at random places; topology not known.
Solid RandomSolid(std::uint64_t seed);

/// Components and total genus.
struct CountedTopology
{
  std::int64_t Components, Genus;
};

} // namespace support
} // namespace orthoslices

#endif
