// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesIsolatedContours_h
#define OrthoSlicesIsolatedContours_h

#include "Core/Base/Contours.h"
#include "Core/Base/Execution.h"
#include "Core/Graph/NodeGraph.h"

#include <vector>

namespace orthoslices
{
/// Contours without node points, as they are: closed polylines within one face of M each.
struct IsolatedContours
{
  std::vector<double> Points; ///< x, y, z
  std::vector<Index> Offsets{ 0 };
  std::vector<std::int8_t> Axis;
  std::vector<Index> Plane;
  std::vector<std::int64_t> Source; ///< as in FindArcSources
  /// Never a loop of G: a part that the other slices contradict and that was cut off, or a contour
  /// that is too small.
  std::vector<std::uint8_t> LeftOut;
  /// The loop of G, or None for those that take no part in the surface.
  std::vector<Index> Loop;

  static constexpr Index None = -1;
  Index Count() const { return static_cast<Index>(this->Axis.size()); }
};

/**
 * Parts that were cut off are left out. But a contour that has lost all of its crossings and a
 * small part of its area, because it grazed a plane on which the other slices have nothing, is
 * isolated: the rest of it stays, if `keepGrazing`: where the slices agree otherwise.
 */
IsolatedContours CopyIsolated(const std::vector<IsolatedLoop>& loops, const Contours& contours,
  const GridCrossings& crossings, bool keepGrazing = true);

/// Area of a contour, as a part of its length.
double ThicknessOf(const IsolatedContours& isolated, Index contour);

/// How many take no part in the surface.
Index CountLeftOut(const IsolatedContours& isolated);
}

#endif
