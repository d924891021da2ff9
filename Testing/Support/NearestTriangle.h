// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   nearest triangle of a mesh: exact distances from a tree of bounding boxes
 *
 * vtkStaticCellLocator answers the same question, but takes two to three times as long where the
 * surfaces are many triangles apart, and of equally near triangles it may give different ones from
 * call to call.
 */

#ifndef OrthoSlicesNearestTriangle_h
#define OrthoSlicesNearestTriangle_h

#include <array>
#include <cstddef>
#include <vector>

namespace orthoslices
{
namespace support
{

using Vector3 = std::array<double, 3>;

/// A balanced tree; triangles are halved at the median along the longest side of their centres.
class NearestTriangle
{
public:
  using Triangle = std::array<Vector3, 3>;

  explicit NearestTriangle(std::vector<Triangle> triangles);

  struct Result
  {
    std::size_t Triangle; ///< index of the constructor's argument
    double Distance;
  };

  /// Safe from any thread. There must be a triangle.
  Result Find(const Vector3& position) const;

  /// Squared distance of a point from a triangle, which may be collapsed.
  static double Distance2(const Vector3& position, const Triangle& triangle);

private:
  struct Box
  {
    Vector3 Low;
    Vector3 High;

    double Distance2(const Vector3& position) const;
  };

  void Split(std::size_t first, std::size_t last, std::size_t node);
  Box BoundTriangles(std::size_t first, std::size_t last) const;
  void Visit(std::size_t node, const Vector3& position, std::size_t& nearest, double& least2) const;

  std::vector<Triangle> Triangles;
  std::vector<std::size_t> Order;  // of the triangles in the leaves
  std::vector<std::size_t> Firsts; // first triangle of each leaf, in Order; one more at the end
  std::vector<Box> Boxes;          // node i has the children 2 i + 1 and 2 i + 2
  std::size_t Leaves = 1;          // a power of two
};

} // namespace support
} // namespace orthoslices

#endif
