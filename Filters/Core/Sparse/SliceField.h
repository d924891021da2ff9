// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSliceField_h
#define OrthoSlicesSliceField_h

#include "Core/Base/Execution.h"
#include "Core/Sparse/ContourSamples.h"

#include <memory>
#include <vector>

namespace orthoslices
{
/**
 * A smooth function of space that is 0 on the contours of slices of any directions, positive inside
 * and negative outside: of all functions with these values, and with these slopes across the
 * contours within their planes, the one with the least third derivatives (J. Duchon, "Splines
 * minimizing rotation-invariant semi-norms in Sobolev spaces", 1977; its use for surfaces: J. C.
 * Carr et al., "Reconstruction and representation of 3D objects with radial basis functions",
 * SIGGRAPH 2001; derivatives as constraints: I. Macedo, J. P. Gois, L. Velho, "Hermite radial basis
 * functions implicits", 2011).
 *
 * A distance has the slope 1 across its surface, but across a contour within its plane only the
 * sine of the angle between surface and plane. That is taken from the function itself, which is
 * solved a few times with the same factors.
 *
 * The system is dense, and has two unknowns for each sample: time grows with the third
 * power of their number, and memory with its square. Deterministic.
 */
class SliceField
{
public:
  SliceField(std::vector<ContourSample>&& samples, const Execution& execution);
  /// One through each of several choices of samples, as from these alone, in less time: what the
  /// choices have in common is factored once.
  static std::vector<SliceField> ThroughEach(
    const std::vector<std::vector<ContourSample>>& choices, const Execution& execution);
  SliceField(SliceField&&) noexcept;
  ~SliceField();

  /// Whether the contours determine it: they do not if all of them lie in one plane.
  bool IsSolved() const;

  /// About the distance from the surface, in world units, near it. Time is linear in the samples.
  double Value(const Point3& position) const;
  /// How far a position is from the surface, near it: by the slope there, taken for at least a
  /// half.
  double Distance(const Point3& position) const;

private:
  SliceField();

  struct Solution;
  std::unique_ptr<Solution> Solved;
};
}

#endif
