// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBox_h
#define OrthoSlicesBox_h

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
/// The least box along the axes around points; at first it is empty.
struct Box3
{
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  Point3 Low{ Infinity, Infinity, Infinity };
  Point3 High{ -Infinity, -Infinity, -Infinity };

  void Add(int axis, double x)
  {
    this->Low[axis] = std::min(this->Low[axis], x);
    this->High[axis] = std::max(this->High[axis], x);
  }
  void Add(const Point3& point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Add(axis, point[axis]);
    }
  }
  void Add(const Box3& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
      this->High[axis] = std::max(this->High[axis], other.High[axis]);
    }
  }
  /// Whether they have a point in common along one axis.
  bool Meets(const Box3& other, int axis) const
  {
    return this->Low[axis] <= other.High[axis] && other.Low[axis] <= this->High[axis];
  }
  bool Meets(const Box3& other) const
  {
    return this->Meets(other, 0) && this->Meets(other, 1) && this->Meets(other, 2);
  }
  /// Whether a point is in it, and not on a face.
  bool HasInside(const Point3& point) const
  {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      inside = inside && this->Low[axis] < point[axis] && point[axis] < this->High[axis];
    }
    return inside;
  }
  /// Of a point; infinite if the box is empty.
  double SquaredDistanceTo(const Point3& point) const
  {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double beyond =
        std::max({ this->Low[axis] - point[axis], point[axis] - this->High[axis], 0.0 });
      sum += beyond * beyond;
    }
    return sum;
  }
  /// Not finite if the box is empty.
  double Diagonal() const
  {
    const Point3 d = this->High - this->Low;
    return std::hypot(d[0], d[1], d[2]);
  }
};

/// The box that everything lies in.
inline Box3 Everywhere()
{
  constexpr double infinity = Box3::Infinity;
  return { { -infinity, -infinity, -infinity }, { infinity, infinity, infinity } };
}
}

#endif
