// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImageBorder_h
#define OrthoSlicesImageBorder_h

#include "Core/Pieces/OpenCurve.h"

namespace orthoslices
{
/// What happens to contours that end at the border of the image.
enum class BorderContours
{
  CloseAlong, ///< they are closed along the border
  LeaveOpen,  ///< they are continued beyond the border, where the surface is to be cut off
  Refuse      ///< they are unusable
};

/// The direction (0 is u, 1 is v) across a side and which of the two it is, by its number round the
/// rectangle: below, right, above, left.
inline int DirectionOf(int side) { return side % 2 == 0 ? 1 : 0; }
inline int WhichOf(int side) { return side == 1 || side == 2 ? 1 : 0; }

/**
 * The border of the image, of which the slices of one axis show a rectangle. Its sides are u =
 * const and v = const; where no contour ends at a side, it is where the contours reach farthest.
 */
struct ImageBorder
{
  /// Of u and v, the lower and the upper side.
  std::array<std::array<double, 2>, 2> Side{ { { HUGE_VAL, -HUGE_VAL }, { HUGE_VAL, -HUGE_VAL } } };
  std::array<std::array<bool, 2>, 2> IsFound{ { { false, false }, { false, false } } };
  double Tolerance = 0.0; ///< ends that are at most so far from a side lie on it
  /// So far beyond the sides that were found, at right angles to them, curves go on before they are
  /// closed.
  double Beyond = 0.0;

  void Add(const Point2& point);
  /// The side nearest to an end, at most `distance` away, counted from below round the rectangle
  /// counter-clockwise; -1 if there is none.
  int SideOfEnd(const Point2& end, double distance) const;
  bool IsOnBorder(const Point2& end) const { return this->SideOfEnd(end, this->Tolerance) >= 0; }
  /// Whether both ends of a curve lie at the border: at most as far from it as its points are
  /// apart.
  bool EndsAtBorder(const OpenCurve& curve) const;
};

/// A loop made of curves and of the parts of the border between their ends.
struct BorderLoop
{
  OpenCurve Curve;
  double AlongBorder = 0.0; ///< length of these parts
};

/**
 * Closes curves of one slice, all of which begin and end at the border, along it. Curves that do
 * not cross divide the rectangle into regions, and going round it one is inside and outside in
 * turn. Of the two possibilities that is chosen which keeps to the sides that were found: at the
 * others no contour ends; then the one with the shorter way along the border.
 */
std::vector<BorderLoop> CloseAlongBorder(
  const ImageBorder& border, const std::vector<OpenCurve>& curves);
}

#endif
