// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImageBorder_h
#define OrthoSlicesImageBorder_h

#include "Core/Slices/OpenCurve.h"

namespace orthoslices
{
/// What happens to contours that end at the border of the image.
enum class BorderContours
{
  CloseAlong, ///< they are closed along the border
  LeaveOpen,  ///< the surface ends at the border
  Refuse      ///< they are unusable
};

/**
 * The border of the image, of which the slices of one axis show a rectangle. Its sides are u = const
 * and v = const; where no contour ends at a side, it is where the contours reach farthest.
 */
struct ImageBorder
{
  /// Of u and v, the lower and the upper side.
  std::array<std::array<double, 2>, 2> Side{ { { HUGE_VAL, -HUGE_VAL }, { HUGE_VAL, -HUGE_VAL } } };
  std::array<std::array<bool, 2>, 2> IsFound{ { { false, false }, { false, false } } };
  double Tolerance = 0.0; ///< ends that are at most so far from a side lie on it

  void Add(const Point2& point);
  /// The side nearest to an end, at most `distance` away, counted from below round the rectangle
  /// counter-clockwise; -1 if there is none.
  int SideOfEnd(const Point2& end, double distance) const;
  bool IsOnBorder(const Point2& end) const { return this->SideOfEnd(end, this->Tolerance) >= 0; }
  /// Whether both ends of a curve lie at the border: at most as far from it as its points are apart.
  bool EndsAtBorder(const OpenCurve& curve) const;
};

/**
 * Finds the sides of the border: where the contours of an axis reach farthest along u or v, and two or
 * more loose ends lie. Those of the other axis that sees the same side count, too, so that many ends
 * that are each alone on their slice show it.
 *
 * `borders` has, for each axis, what all contours of that axis reach; the curves are those of all axes.
 */
void FindBorders(const std::vector<OpenCurve>& curves, std::array<ImageBorder, 3>& borders);

/// A loop made of curves and of the parts of the border between their ends.
struct BorderLoop
{
  OpenCurve Curve;
  double AlongBorder = 0.0; ///< length of these parts
};

/**
 * Closes curves of one slice, all of which begin and end at the border, along it. Curves that do not
 * cross divide the rectangle into regions, and going round it one is inside and outside in turn. Of the
 * two possibilities that is chosen which keeps to the sides that were found: at the others no contour
 * ends; then the one with the shorter way along the border.
 */
std::vector<BorderLoop> CloseAlongBorder(
  const ImageBorder& border, const std::vector<OpenCurve>& curves);
}

#endif
