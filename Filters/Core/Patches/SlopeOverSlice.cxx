// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SlopeOverSlice.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/**
 * Added to the diagonal for the monomials of each degree: keeps coefficients small of which the
 * contour says little, so that of all fitting heights the flattest is taken. Data count about 1 each
 * in the units that places are taken in, so these give way to any data, and are far above rounding
 * (1e-16); higher degrees, which fewer points determine, are held more firmly.
 */
constexpr double Flattening[] = { 1e-12, 1e-12, 1e-8, 1e-7 };

/// The derivatives of all monomials.
template <int Count>
void Differentiate(
  int degree, const double (&values)[Count], double (&dx)[Count], double (&dy)[Count])
{
  ForMonomials(degree,
    [&](int number, int i, int j)
    {
      dx[number] = i > 0 ? i * values[MonomialNumber(i - 1, j)] : 0.0;
      dy[number] = j > 0 ? j * values[MonomialNumber(i, j - 1)] : 0.0;
    });
}
}

void SlopeOverSlice::Start(const Point2& center, double size)
{
  this->Center = center;
  this->Size = size;
  for (double(&row)[Terms] : this->Matrix)
  {
    std::fill(row, row + Terms, 0.0);
  }
  std::fill(this->Coefficients, this->Coefficients + Terms, 0.0);
}

void SlopeOverSlice::Add(const double (&values)[Terms], double right)
{
  for (int i = 0; i < Terms; ++i)
  {
    this->Coefficients[i] += right * values[i];
    for (int j = 0; j <= i; ++j)
    {
      this->Matrix[i][j] += values[i] * values[j];
    }
  }
}

void SlopeOverSlice::AddZero(const Point2& place)
{
  const Point2 p = this->ToLocal(place);
  double values[Terms];
  EvaluateMonomials(p[0], p[1], 1.0, values);
  this->Add(values, 0.0);
}

void SlopeOverSlice::AddSlope(const Point2& place, const Point2& slope)
{
  const Point2 p = this->ToLocal(place);
  double values[Terms], dx[Terms], dy[Terms];
  EvaluateMonomials(p[0], p[1], 1.0, values);
  Differentiate(Degree, values, dx, dy);
  this->Add(dx, slope[0]);
  this->Add(dy, slope[1]);
}

bool SlopeOverSlice::Fit()
{
  ForMonomials(
    Degree, [&](int number, int i, int j) { this->Matrix[number][number] += Flattening[i + j]; });
  if (!Factorize(this->Matrix))
  {
    return false;
  }
  Substitute(this->Matrix, this->Coefficients);
  return true;
}

Point2 SlopeOverSlice::SlopeAt(const Point2& place) const
{
  const Point2 p = this->ToLocal(place);
  double values[Terms], dx[Terms], dy[Terms];
  EvaluateMonomials(p[0], p[1], 1.0, values);
  Differentiate(Degree, values, dx, dy);
  Point2 slope{ 0.0, 0.0 };
  for (int i = 0; i < Terms; ++i)
  {
    slope[0] += this->Coefficients[i] * dx[i];
    slope[1] += this->Coefficients[i] * dy[i];
  }
  return slope;
}
}
