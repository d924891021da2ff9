// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/NearestTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace orthoslices
{
namespace support
{
namespace
{

constexpr std::size_t TrianglesPerLeaf = 4;
constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
Vector3 Subtract(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

//------------------------------------------------------------------------------
double DistanceFromSegment2(const Vector3& position, const Vector3& from, const Vector3& to)
{
  const Vector3 along = Subtract(to, from);
  const Vector3 offset = Subtract(position, from);
  const double length2 = Dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(Dot(offset, along) / length2, 0.0, 1.0) : 0.0;
  const Vector3 rest{ offset[0] - t * along[0], offset[1] - t * along[1],
    offset[2] - t * along[2] };
  return Dot(rest, rest);
}

//------------------------------------------------------------------------------
double CentreOf(const NearestTriangle::Triangle& triangle, int axis)
{
  return triangle[0][axis] + triangle[1][axis] + triangle[2][axis]; // three times
}

} // anonymous namespace

//------------------------------------------------------------------------------
NearestTriangle::NearestTriangle(std::vector<Triangle> triangles)
  : Triangles(std::move(triangles))
  , Order(this->Triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
  while (this->Leaves * TrianglesPerLeaf < this->Triangles.size())
  {
    this->Leaves *= 2;
  }
  this->Firsts.resize(this->Leaves + 1, this->Triangles.size());
  this->Boxes.resize(2 * this->Leaves - 1);
  this->Split(0, this->Triangles.size(), 0);
}

//------------------------------------------------------------------------------
void NearestTriangle::Split(std::size_t first, std::size_t last, std::size_t node)
{
  this->Boxes[node] = this->BoundTriangles(first, last);
  if (node >= this->Leaves - 1)
  {
    this->Firsts[node - (this->Leaves - 1)] = first;
    return;
  }
  const Box& box = this->Boxes[node];
  int axis = 0;
  for (int k = 1; k < 3; ++k)
  {
    axis = box.High[k] - box.Low[k] > box.High[axis] - box.Low[axis] ? k : axis;
  }
  const std::size_t middle = (first + last) / 2;
  const auto begin = this->Order.begin();
  std::nth_element(begin + first, begin + middle, begin + last,
    [this, axis](std::size_t a, std::size_t b)
    { return CentreOf(this->Triangles[a], axis) < CentreOf(this->Triangles[b], axis); });
  this->Split(first, middle, 2 * node + 1);
  this->Split(middle, last, 2 * node + 2);
}

//------------------------------------------------------------------------------
NearestTriangle::Box NearestTriangle::BoundTriangles(std::size_t first, std::size_t last) const
{
  Box box{ { Infinity, Infinity, Infinity }, { -Infinity, -Infinity, -Infinity } };
  for (std::size_t i = first; i < last; ++i)
  {
    for (const Vector3& corner : this->Triangles[this->Order[i]])
    {
      for (int k = 0; k < 3; ++k)
      {
        box.Low[k] = std::min(box.Low[k], corner[k]);
        box.High[k] = std::max(box.High[k], corner[k]);
      }
    }
  }
  return box;
}

//------------------------------------------------------------------------------
double NearestTriangle::Box::Distance2(const Vector3& position) const
{
  double distance2 = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double d = std::max({ this->Low[k] - position[k], 0.0, position[k] - this->High[k] });
    distance2 += d * d;
  }
  return distance2;
}

//------------------------------------------------------------------------------
// The nearest point lies within the face if the point is on the inner side of all three edges, else
// on an edge.
double NearestTriangle::Distance2(const Vector3& position, const Triangle& triangle)
{
  const Vector3 normal =
    Cross(Subtract(triangle[1], triangle[0]), Subtract(triangle[2], triangle[0]));
  const double length2 = Dot(normal, normal);
  bool isAbove = length2 > 0.0;
  for (int k = 0; k < 3 && isAbove; ++k)
  {
    const Vector3 edge = Subtract(triangle[(k + 1) % 3], triangle[k]);
    isAbove = Dot(Cross(edge, Subtract(position, triangle[k])), normal) >= 0.0;
  }
  if (isAbove)
  {
    const double height = Dot(Subtract(position, triangle[0]), normal);
    return height * height / length2;
  }
  return std::min({ DistanceFromSegment2(position, triangle[0], triangle[1]),
    DistanceFromSegment2(position, triangle[1], triangle[2]),
    DistanceFromSegment2(position, triangle[2], triangle[0]) });
}

//------------------------------------------------------------------------------
// Depth first, the nearer box first; boxes beyond the best distance are skipped.
void NearestTriangle::Visit(
  std::size_t node, const Vector3& position, std::size_t& nearest, double& least2) const
{
  if (node >= this->Leaves - 1)
  {
    const std::size_t leaf = node - (this->Leaves - 1);
    for (std::size_t i = this->Firsts[leaf]; i < this->Firsts[leaf + 1]; ++i)
    {
      const double distance2 = Distance2(position, this->Triangles[this->Order[i]]);
      if (distance2 < least2)
      {
        least2 = distance2;
        nearest = this->Order[i];
      }
    }
    return;
  }
  std::size_t near = 2 * node + 1;
  std::size_t far = 2 * node + 2;
  double near2 = this->Boxes[near].Distance2(position);
  double far2 = this->Boxes[far].Distance2(position);
  if (far2 < near2)
  {
    std::swap(near, far);
    std::swap(near2, far2);
  }
  if (near2 < least2)
  {
    this->Visit(near, position, nearest, least2);
  }
  if (far2 < least2)
  {
    this->Visit(far, position, nearest, least2);
  }
}

//------------------------------------------------------------------------------
NearestTriangle::Result NearestTriangle::Find(const Vector3& position) const
{
  std::size_t nearest = 0;
  double least2 = Infinity;
  this->Visit(0, position, nearest, least2);
  return { nearest, std::sqrt(least2) };
}

} // namespace support
} // namespace orthoslices
