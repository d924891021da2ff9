// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesThinContours_h
#define OrthoSlicesThinContours_h

#include "Core/Slicing/PlaneContours.h"

#include <utility>
#include <vector>

namespace orthoslices
{
/**
 * Leaves out vertices of contours that lie within `tolerance` (world units) of the line through
 * those that stay; see MarkKept. Sides that cross planes of the two other axes stay, so that the
 * slice agrees with others as much as before. Contours keep three vertices at least.
 */
class ContourThinner
{
public:
  /// Planes are ascending: those of the slice's first and second axis.
  ContourThinner(
    double tolerance, const std::vector<double>& planesU, const std::vector<double>& planesV);

  PlaneContours Run(const PlaneContours& contours);

private:
  std::pair<Index, Index> SlabsAt(const PlaneContours& contours, Index vertex) const;
  void MarkCrossing(const PlaneContours& contours, Index first, Index last);
  void MarkBetween(const PlaneContours& contours, Index first, std::size_t start, std::size_t end);

  const double Tolerance;
  const std::vector<double>& PlanesU;
  const std::vector<double>& PlanesV;
  std::vector<std::uint8_t> Stays; ///< of each vertex of a contour
  std::vector<Point3> Line;        ///< between two vertices that stay
  std::vector<std::uint8_t> Kept;  ///< of these points
};
}

#endif
