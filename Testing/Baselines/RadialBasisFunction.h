// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a function of space through given values: radial basis functions and a linear polynomial
 *
 * s(x) = sum of w_i |x - c_i|^k + a + b x, with the weights w_i orthogonal to all linear
 * polynomials. With k = 1 (biharmonic spline) or k = 3 (triharmonic spline) there is exactly one
 * such function through values at different points that do not all lie on a plane, and of all
 * functions through them it has the least energy, which integrates squared second (third)
 * derivatives: J. Duchon, "Splines minimizing rotation-invariant semi-norms in Sobolev spaces",
 * 1977.
 */

#ifndef OrthoSlicesRadialBasisFunction_h
#define OrthoSlicesRadialBasisFunction_h

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// The power k of the distance.
enum class RadialKernel
{
  Biharmonic = 1,
  Triharmonic = 3
};

/// A value that the function takes at a position.
struct RadialConstraint
{
  std::array<double, 3> Position;
  double Value;
};

class RadialBasisFunction
{
public:
  /**
   * Solves the dense system of all constraints: cubic time, 8 bytes for each pair of them.
   * @throw std::runtime_error if the constraints leave the function open: they are fewer than four,
   * all on one plane of constant x, y or z, or coincide.
   */
  RadialBasisFunction(const std::vector<RadialConstraint>& constraints, RadialKernel kernel);
  RadialBasisFunction(RadialBasisFunction&&) noexcept;
  ~RadialBasisFunction();

  /// Time proportional to the number of constraints. Safe from any thread.
  double Evaluate(const std::array<double, 3>& position) const;

private:
  struct Solution;
  std::unique_ptr<Solution> Solved;
};

/**
 * A function of few centres for many constraints, after Carr et al. (RadialBasis.h): centres are
 * added where the function is farthest off, until all constraints hold within ACCURACY or there are
 * LARGEST centres, for which alone the constraints hold then. Consecutive constraints should be
 * neighbours, as new centres are kept apart by their order.
 */
RadialBasisFunction FitGreedily(const std::vector<RadialConstraint>& constraints,
  RadialKernel kernel, std::size_t largest, double accuracy);

} // namespace baselines
} // namespace orthoslices

#endif
