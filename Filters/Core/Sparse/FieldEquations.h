// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFieldEquations_h
#define OrthoSlicesFieldEquations_h

#include "Core/Base/Execution.h"
#include "Core/Sparse/ContourSamples.h"

#include <Eigen/Dense>

#include <cstdint>
#include <vector>

namespace orthoslices
{
/**
 * The equations of a SliceField: with A, the values and slopes of the kernel of each sample at each
 * other, and the linear polynomials P there, [A P; P^T 0] [w; c] = [b; 0]. Row and column 2i are
 * those of the value at sample i, 2i + 1 those of its slope.
 *
 * A is positive definite only on weights w that are orthogonal to P. Minus the linear interpolation
 * of the kernel between four fixed points, plus the linear polynomials that are 1 at one of these
 * and 0 at the others, it becomes so on all (the positive definite kernel of a conditionally
 * positive definite one; H. Wendland, "Scattered Data Approximation", 2005, chapter 10), and w
 * stays the same: what is added vanishes where P^T w = 0, or is a linear polynomial. So one
 * factorisation after Cholesky, in place, is enough, and part of one is that of a part of the
 * samples.
 *
 * REQUIRES: positions within a box of size 1 around the origin; no two the same.
 */
class FieldEquations
{
public:
  using Matrix = Eigen::MatrixXd;

  /// Of all samples; time grows with the third power of their number, memory with its square.
  FieldEquations(const std::vector<ContourSample>& samples, const Execution& execution);

  /// Whether the samples determine the field.
  bool IsSolved() const { return this->Solved; }
  /// The weights of values and slopes, in the order of the rows, then those of 1, x, y and z.
  Eigen::VectorXd Solve(const Eigen::VectorXd& values) const;

private:
  friend class SharedEquations;
  FieldEquations() = default;
  void Finish();

  Matrix Factor;       ///< its lower triangle, after Cholesky
  Matrix Polynomials;  ///< of each row, those of the four points
  Matrix AtPoints;     ///< of each row, the kernels of the four points
  Matrix Combinations; ///< of each row, which weights give the four polynomials
  Eigen::LDLT<Eigen::Matrix4d> Coefficients;
  bool Solved = false;
};

/// The equations of several choices of samples, which have most of them in common: that part is
/// factored once.
class SharedEquations
{
public:
  /// Of all samples, of which the first `shared` ones belong to each choice.
  SharedEquations(
    const std::vector<ContourSample>& samples, std::size_t shared, const Execution& execution);

  /// Those of the samples that are shared, and of the others that are chosen, in the same order: as
  /// from these alone. `chosen` says it of each sample that is not shared.
  FieldEquations Choose(const std::vector<std::uint8_t>& chosen) const;

private:
  Eigen::Index Shared; ///< rows
  FieldEquations All;  ///< factored as far as they are shared
};
}

#endif
