// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   volume-based reconstruction from all three families: a blend of three distance fields
 *
 * The field f of each family (DistanceInterpolation) is divided by the length g of its gradient,
 * which makes it an estimate of the distance in space, and weighted with 1 / (d g^3)^2, where d is
 * the distance from the family's nearest slice (inverse-distance weights: D. Shepard, "A
 * two-dimensional interpolation function for irregularly-spaced data", ACM National Conference
 * 1968). The factor g prefers families whose slices cut the surface steeply. On a slice the weight
 * is infinite: there the field of that slice alone is left, so the contours of all families lie on
 * the surface wherever they agree.
 *
 * Neither g nor its power is in the literature; they nearly halve the error of plain weights
 * 1 / d^2, so that the comparison is with the best that could be made of the idea.
 */

#ifndef OrthoSlicesDistanceInterpolationThreeFamilies_h
#define OrthoSlicesDistanceInterpolationThreeFamilies_h

#include "Baseline.h"

namespace orthoslices
{
namespace baselines
{

class DistanceInterpolationThreeFamilies : public Baseline
{
public:
  /**
   * PARTS: samples per interval between two slices. At 6, the default, the RMS error is within one
   * per cent of its limit (`CompareMethods --sweep`, five shapes at 32 planes per axis).
   */
  explicit DistanceInterpolationThreeFamilies(int parts = 6);

  std::string Name() const override { return "volume-xyz"; }
  std::string Description() const override;
  std::array<bool, 3> UsesFamilies() const override { return { true, true, true }; }
  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets& slices) const override;

private:
  int Parts;
};

} // namespace baselines
} // namespace orthoslices

#endif
