// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLeastSquares_h
#define OrthoSlicesLeastSquares_h

#include <cmath>

/// Solves small symmetric positive definite systems by Cholesky's method.
namespace orthoslices
{
/// Replaces the lower triangle of a matrix by its factor; false if it is not positive definite.
template <int N>
bool Factorize(double (&a)[N][N])
{
  for (int j = 0; j < N; ++j)
  {
    for (int i = j; i < N; ++i)
    {
      double sum = a[i][j];
      for (int k = 0; k < j; ++k)
      {
        sum -= a[i][k] * a[j][k];
      }
      if (i == j && !(sum > 0.0))
      {
        return false;
      }
      a[i][j] = i == j ? std::sqrt(sum) : sum / a[j][j];
    }
  }
  return true;
}

/// Replaces the right side by the solution.
template <int N>
void Substitute(const double (&factor)[N][N], double (&b)[N])
{
  for (int i = 0; i < N; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      b[i] -= factor[i][k] * b[k];
    }
    b[i] /= factor[i][i];
  }
  for (int i = N - 1; i >= 0; --i)
  {
    for (int k = i + 1; k < N; ++k)
    {
      b[i] -= factor[k][i] * b[k];
    }
    b[i] /= factor[i][i];
  }
}
}

#endif
