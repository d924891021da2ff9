// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesAxisFrame_h
#define OrthoSlicesAxisFrame_h

#include "Core/Base/Vectors.h"

namespace orthoslices
{
/**
 * The axes along which the families of slices are numbered. Coordinate a of a point along these
 * axes is its distance from the origin of the world along the unit normal of family a: positions of
 * planes are true distances, whatever the angles between the families. Normals of three orthogonal
 * families make it a rotation; else it is an affine map that makes boxes of the oblique cells
 * between the planes. Either keeps the sense of rotation: what is outside remains outside.
 */
class AxisFrame
{
public:
  /// The axes of the world, which leave all coordinates as they are, bit for bit.
  AxisFrame() = default;

  /// REQUIRES: unit vectors whose triple product is positive.
  explicit AxisFrame(const std::array<Point3, 3>& normals);

  /// The unit normal of the slices across an axis.
  const Point3& Normal(int axis) const { return this->Normals[axis]; }

  /// What a step of 1 along an axis is in the world: along the intersection of the planes of the
  /// other two families, as long as takes one from a plane of the axis to that at a distance of 1.
  const Point3& Edge(int axis) const { return this->Edges[axis]; }

  /// The volume in the world of a unit cube along the axes.
  double Volume() const { return Dot(this->Edges[0], Cross(this->Edges[1], this->Edges[2])); }

  /// Whether these are the axes of the world.
  bool IsWorld() const { return this->World; }

  /// Whether lengths and angles are those of the world, but for rounding.
  bool IsRotation() const;

  Point3 ToAxes(const Point3& world) const
  {
    return { Dot(this->Normals[0], world), Dot(this->Normals[1], world),
      Dot(this->Normals[2], world) };
  }

  /// The inverse of ToAxes.
  Point3 ToWorld(const Point3& along) const
  {
    return along[0] * this->Edges[0] + along[1] * this->Edges[1] + along[2] * this->Edges[2];
  }

  /// The normal in the world of a surface that has a normal along the axes; zero stays zero.
  Point3 NormalToWorld(const Point3& along) const
  {
    return Unit(
      along[0] * this->Normals[0] + along[1] * this->Normals[1] + along[2] * this->Normals[2]);
  }

private:
  std::array<Point3, 3> Normals{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  std::array<Point3, 3> Edges = Normals;
  bool World = true;
};
}

#endif
