// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   reconstruction by radial basis functions through the contours of any families
 *
 * After J. C. Carr, R. K. Beatson, J. B. Cherrie, T. J. Mitchell, W. R. Fright, B. C. McCallum,
 * T. R. Evans, "Reconstruction and representation of 3D objects with radial basis functions",
 * SIGGRAPH 2001: an interpolated signed distance, zero at points on the surface and known at
 * points a little off it, inside and outside, along the normals; the surface is where it is zero.
 * The normals of contours are known only within their planes, and off-surface points are moved
 * along these, as is usual where contours are the input.
 *
 * - The contours are sampled evenly. The system is dense, which limits the number of centres; they
 *   are chosen greedily, as in the article.
 * - An off-surface point that comes near another part of the contours is moved closer to its own,
 *   or left out, so that thin parts keep their two sides.
 * - The article follows the surface from the points that are given. Likewise, sheets that are the
 *   nearest ones to no sample are left out.
 * - Outside the contours' box, enlarged on each axis by one mean gap between its planes (a tenth
 *   of the side if there are no two), the surface is cut off and closed.
 */

#ifndef OrthoSlicesRadialBasis_h
#define OrthoSlicesRadialBasis_h

#include "Baseline.h"
#include "RadialBasisFunction.h"

namespace orthoslices
{
namespace baselines
{

class RadialBasis : public Baseline
{
public:
  /**
   * CENTRES: at most as many basis functions, and points on the contours about as many; each has up
   * to three constraints. RESOLUTION: steps of the lattice along the longest side of the contours'
   * box. The triharmonic kernel is the closer one on most shapes and planes.
   */
  explicit RadialBasis(
    int centres = 3000, int resolution = 128, RadialKernel kernel = RadialKernel::Triharmonic);

  std::string Name() const override { return "radial-basis"; }
  std::string Description() const override;
  std::array<bool, 3> UsesFamilies() const override { return { true, true, true }; }

  /// Families may be null or empty.
  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets& slices) const override;

private:
  int Centres;
  int Resolution;
  RadialKernel Kernel;
};

} // namespace baselines
} // namespace orthoslices

#endif
