// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSliceMetric_h
#define OrthoSlicesSliceMetric_h

#include "Core/Base/AxisFrame.h"

namespace orthoslices
{
/**
 * Lengths and angles within the slices across an axis and against them, where families are not at
 * right angles to each other: *true* coordinates of points and vectors, in which lengths and angles
 * are those of the world. The first two are within the slice, the third is along its unit normal;
 * they are written where those along FirstAxis, SecondAxis and the axis of the slices are. Where
 * the metric is that of the world, they are the same, bit for bit.
 *
 * A *normal* is what is at right angles to the tangents of a surface, of any length; along the axes
 * as in true coordinates.
 */
class SliceMetric
{
public:
  SliceMetric(const AxisFrame& metric, int axis)
    : Metric(metric)
    , U(orthoslices::FirstAxis(axis))
    , V(orthoslices::SecondAxis(axis))
    , W(axis)
  {
    this->First = Unit(metric.Edge(this->U));
    this->Second = Cross(metric.Normal(axis), this->First);
    this->Shear = Dot(metric.Edge(this->V), this->First);
    this->Width = Length(metric.Edge(this->U));
    this->Height = Dot(metric.Edge(this->V), this->Second);
  }

  /// The true coordinates of a point within the slice.
  Point2 ToTrue(const Point3& point) const
  {
    const double u = point[this->U], v = point[this->V];
    return this->Metric.IsWorld() ? Point2{ u, v }
                                  : Point2{ this->Width * u + this->Shear * v, this->Height * v };
  }

  /// Along the axes, a vector that lies within the slice.
  Point3 ToAxes(double first, double second) const
  {
    Point3 result{ 0.0, 0.0, 0.0 };
    result[this->U] = first;
    result[this->V] = second;
    if (!this->Metric.IsWorld())
    {
      result[this->V] = second / this->Height;
      result[this->U] = (first - this->Shear * result[this->V]) / this->Width;
    }
    return result;
  }

  /// The true coordinates of a normal.
  Point3 NormalToTrue(const Point3& normal) const
  {
    if (this->Metric.IsWorld())
    {
      return normal;
    }
    const Point3 inWorld = normal[0] * this->Metric.Normal(0) + normal[1] * this->Metric.Normal(1) +
      normal[2] * this->Metric.Normal(2);
    Point3 result;
    result[this->U] = Dot(inWorld, this->First);
    result[this->V] = Dot(inWorld, this->Second);
    result[this->W] = Dot(inWorld, this->Metric.Normal(this->W));
    return result;
  }

  /// The inverse of NormalToTrue.
  Point3 NormalToAxes(const Point3& normal) const
  {
    if (this->Metric.IsWorld())
    {
      return normal;
    }
    const Point3 inWorld = normal[this->U] * this->First + normal[this->V] * this->Second +
      normal[this->W] * this->Metric.Normal(this->W);
    return { Dot(inWorld, this->Metric.Edge(0)), Dot(inWorld, this->Metric.Edge(1)),
      Dot(inWorld, this->Metric.Edge(2)) };
  }

private:
  const AxisFrame& Metric;
  int U, V, W;
  Point3 First, Second; ///< unit vectors of the world within the slice
  double Width, Shear;  ///< along First, of a step along U and of one along V
  double Height;        ///< along Second, of a step along V
};
}

#endif
