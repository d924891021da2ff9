// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   slices that are turned, inclined, rounded and shuffled between ports, as polylines
 */

#ifndef OrthoSlicesTurnedSlices_h
#define OrthoSlicesTurnedSlices_h

#include "Core/Base/Polylines.h"
#include "Support/TextContours.h"

#include <cstdint>
#include <functional>

namespace orthoslices
{
namespace support
{

/// The rows of a linear map.
using Matrix3 = std::array<Point3, 3>;

Matrix3 UnitMatrix();

/// The rotation by an angle in radians around an axis, which need not be of unit length.
Matrix3 RotationAround(const Point3& axis, double angle);

/// Any rotation, each as likely as any other.
Matrix3 RandomRotation(std::uint64_t seed);

/// Number 0 to 47 of the ways of exchanging and reflecting the axes; 0 leaves them as they are.
Matrix3 AxisOrder(int number);

Point3 Apply(const Matrix3& matrix, const Point3& point);
Matrix3 Transpose(const Matrix3& matrix);

/// The pieces of all axes in the world, mapped; those of axis a come through port ports[a], their
/// cells numbered anew in each port. Coordinates are rounded to multiples of `step`, if it is not
/// 0.
Polylines MapSlices(const PieceSets& sets, const Matrix3& matrix,
  const std::array<int, 3>& ports = { 0, 1, 2 }, double step = 0.0);

/// Each side of each polyline as a polyline of its own, in random order and direction.
Polylines CutToSegments(const Polylines& lines, std::uint64_t seed);

} // namespace support
} // namespace orthoslices

#endif
