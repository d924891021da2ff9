// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   exact signed distance to the contours of one slice, sampled on a rectilinear raster
 */

#ifndef OrthoSlicesContourDistance_h
#define OrthoSlicesContourDistance_h

#include "PlanarContours.h"

#include <cstddef>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/**
 * Euclidean distance to the nearest segment, positive inside (even-odd rule) and negative outside.
 * The boxes of the search tree enclose runs of consecutive segments, so it is built in linear time.
 */
class ContourDistance
{
public:
  /// The loops have to outlive this object; there must be at least one.
  explicit ContourDistance(const std::vector<Loop>& loops);

  /// Values at (us[0], v), (us[1], v) ...; us ascending.
  void SampleRow(const std::vector<double>& us, double v, double* values) const;

private:
  struct Segment
  {
    Point2 From;
    Point2 To;
  };
  struct Box
  {
    Point2 Low;
    Point2 High;
  };

  void BuildBoxes();
  Box BoxOfSegments(std::size_t first) const;
  void Visit(std::size_t node, const Point2& point, double& nearest2, std::size_t& segment) const;
  void VisitSegments(
    std::size_t first, const Point2& point, double& nearest2, std::size_t& segment) const;
  std::vector<double> CrossingsOfRow(double v) const;

  std::vector<Segment> Segments;
  std::vector<Box> Boxes; // node i has the children 2 i + 1 and 2 i + 2; the leaves come last
  std::size_t Leaves = 1; // a power of two
};

} // namespace baselines
} // namespace orthoslices

#endif
