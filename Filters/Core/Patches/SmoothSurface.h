// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSmoothSurface_h
#define OrthoSlicesSmoothSurface_h

#include "Core/Base/Types.h"
#include "Core/Patches/ResidualTree.h"

#include <vector>

namespace orthoslices
{
/**
 * The function whose zeros are a smooth patch: near its distance, positive outside (our own
 * addition). It has given zeros and gradients, which are the border of the patch and its normals.
 *
 * First, the function a z + p(x, y) with a polynomial p of degree four that fits zeros and
 * gradients best, in local coordinates with z along the mean normal. What that leaves at the border
 * is interpolated inwards from there by the inverse distance method with gradients (D. Shepard,
 * 1968) and added, fading out. The gradient at the border is the given one, whatever the polynomial
 * is: patches that have an arc and its normals in common meet with a common tangent plane. The
 * polynomial has the accuracy: its error grows with the fifth power of the size of the patch.
 *
 * Of borders with many points, those that are far away stand together for one: see ResidualTree.
 */
class SmoothSurface
{
public:
  /// False if zeros and gradients determine no function. `weights` have the sum 1.
  bool Fit(const std::vector<Point3>& zeros, const std::vector<Point3>& gradients,
    const std::vector<double>& weights);

  /// The polynomial alone.
  double Polynomial(const Point3& p, Point3& gradient) const;
  double operator()(const Point3& p, Point3& gradient) const;
  /// Root mean square of what the polynomial leaves at the border.
  double Deviation() const;

private:
  static constexpr int Terms = 15;   ///< of a polynomial of two coordinates, of degree four
  static constexpr int Moments = 45; ///< of products of two such terms, of degree eight
  void SetResidual(const std::vector<Point3>& zeros, const std::vector<Point3>& gradients,
    const std::vector<double>& weights);

  double Coefficients[Terms + 1] = {}; ///< of p, and a

  std::vector<Residual> Residuals; ///< at the points of the border
  ResidualTree Tree;               ///< of them, if there are many
};
}

#endif
