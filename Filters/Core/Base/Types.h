// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTypes_h
#define OrthoSlicesTypes_h

#include <array>
#include <cstddef>
#include <cstdint>

/**
 * Conventions of all plain data that pass between the stages of the reconstruction; no VTK types.
 *
 * Lengths are world units. A slice of axis a lies on a plane of constant coordinate a and has
 * the in-plane axes u = FirstAxis(a) and v = SecondAxis(a), so that (u, v, a) is right-handed:
 * seen from the positive end of a, u points right, v points up and the interior of an oriented
 * contour lies on its left.
 */
namespace orthoslices
{
/// Numbers contours, vertices, crossings, nodes and cycles. At most 2^31 - 1 of each.
using Index = std::int32_t;

/// A point or vector in a plane, of its coordinates u and v.
using Point2 = std::array<double, 2>;
/// A point or vector in space.
using Point3 = std::array<double, 3>;

constexpr int FirstAxis(int axis) { return (axis + 1) % 3; }
constexpr int SecondAxis(int axis) { return (axis + 2) % 3; }
}

#endif
