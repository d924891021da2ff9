// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFindFamilies_h
#define OrthoSlicesFindFamilies_h

#include "Core/Frames/PieceGroups.h"

#include <vector>

namespace orthoslices
{
/// How far points lie off their planes although they should not, by what the data themselves say.
struct PlaneNoise
{
  double Tolerance = 0.0; ///< of planes: off them by less counts as on them
  /// The median of the thicknesses of contours with enough points to show one; negative if there
  /// are none.
  double Typical = -1.0;

  /// What a contour may well have, as a root mean square: its own thickness or the typical one; a
  /// thousandth of its size if neither is known.
  double Of(const PieceGroup& group) const;

  /// Whether the group lies on planes with this normal, as far as noise lets one see.
  bool IsExplained(const PieceGroup& group, const Point3& normal) const;
};

PlaneNoise MeasureNoise(const std::vector<PieceGroup>& groups, double tolerance);

/// Slices with the same normal.
struct PlaneFamily
{
  Point3 Normal{ 0.0, 0.0, 0.0 };
  Scatter Points; ///< of all contours, each around its own centre
  Index Contours = 0;
  double Weight = 0.0;                                 ///< of all contours
  double Largest = 0.0;                                ///< weight of one contour
  std::array<double, 3> WeightOfPort{ 0.0, 0.0, 0.0 }; ///< of those from ports 0, 1 and 2

  /// Whether another normal would do as well: off the planes, the points are hardly farther then.
  bool Allows(const Point3& normal, const PlaneNoise& noise) const;
};

/**
 * Up to three families of planes that are well apart, those with the greatest contours and the most
 * nearly orthogonal ones. Their normals are those of least squares through all of their contours,
 * or axes of the world where these do as well: noise makes no families, and no tilt.
 */
std::vector<PlaneFamily> FindFamilies(
  const std::vector<PieceGroup>& groups, const PlaneNoise& noise);
}

#endif
