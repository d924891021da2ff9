// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   logistic regression: weights that make what was observed most likely
 */

#ifndef OrthoSlicesLogisticRegression_h
#define OrthoSlicesLogisticRegression_h

#include "Core/Base/LeastSquares.h"

#include <array>
#include <cmath>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/// One observation: its N features, of which the first may be 1 for all, and its outcome.
template <int N>
struct Observation
{
  std::array<double, N> Features;
  bool Outcome;
};

template <int N>
struct LogisticModel
{
  bool Converged = false;
  std::array<double, N> Weights{};
  std::array<double, N> Errors{}; ///< standard errors of the weights, from the inverse Hessian
};

/// The logarithm of the odds that weights give to an observation.
template <int N>
double LogOdds(const std::array<double, N>& weights, const std::array<double, N>& features)
{
  double sum = 0.0;
  for (int i = 0; i < N; ++i)
  {
    sum += weights[i] * features[i];
  }
  return sum;
}

/**
 * Maximizes the likelihood of all outcomes by Newton's method, in which each step is a weighted
 * linear least squares problem. Does not converge if a plane separates the outcomes, which makes
 * the weights infinite, or if features depend on each other.
 */
template <int N>
LogisticModel<N> FitLogistic(const std::vector<Observation<N>>& observations)
{
  constexpr int maxSteps = 50;
  constexpr double tolerance = 1e-10;
  LogisticModel<N> model;
  for (int step = 0; step < maxSteps && !model.Converged; ++step)
  {
    double hessian[N][N] = {};
    double gradient[N] = {};
    for (const Observation<N>& each : observations)
    {
      const double p = 1.0 / (1.0 + std::exp(-LogOdds<N>(model.Weights, each.Features)));
      for (int i = 0; i < N; ++i)
      {
        gradient[i] += ((each.Outcome ? 1.0 : 0.0) - p) * each.Features[i];
        for (int j = 0; j <= i; ++j)
        {
          hessian[i][j] += p * (1.0 - p) * each.Features[i] * each.Features[j];
        }
      }
    }
    if (!Factorize(hessian))
    {
      return model;
    }
    Substitute(hessian, gradient);
    double change = 0.0;
    for (int i = 0; i < N; ++i)
    {
      model.Weights[i] += gradient[i];
      change = std::max(change, std::abs(gradient[i]));
      double unit[N] = {};
      unit[i] = 1.0;
      Substitute(hessian, unit);
      model.Errors[i] = std::sqrt(unit[i]);
    }
    model.Converged = change < tolerance;
  }
  return model;
}

} // namespace baselines
} // namespace orthoslices

#endif
