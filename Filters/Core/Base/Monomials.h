// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMonomials_h
#define OrthoSlicesMonomials_h

/// Polynomials of two variables as lists of coefficients: 1, x, y, x^2, xy, y^2, ...
namespace orthoslices
{
/// Number of the monomial x^i y^j.
constexpr int MonomialNumber(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }

/// How many there are up to a degree.
constexpr int MonomialCount(int degree) { return (degree + 1) * (degree + 2) / 2; }

/// Calls visit(number, i, j) for all monomials up to a degree.
template <typename Visit>
void ForMonomials(int degree, Visit&& visit)
{
  int number = 0;
  for (int d = 0; d <= degree; ++d)
  {
    for (int j = 0; j <= d; ++j)
    {
      visit(number++, d - j, j);
    }
  }
}

/// All monomials up to a degree, times a factor.
template <int Count>
void EvaluateMonomials(double x, double y, double factor, double (&values)[Count])
{
  values[0] = factor;
  int before = 0;
  for (int d = 1, at = 1; at < Count; ++d)
  {
    for (int j = 0; j < d; ++j)
    {
      values[at + j] = x * values[before + j];
    }
    values[at + d] = y * values[before + d - 1];
    before = at;
    at += d + 1;
  }
}
}

#endif
