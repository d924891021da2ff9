// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesQuadraticFit_h
#define OrthoSlicesQuadraticFit_h

#include "Core/Base/LeastSquares.h"
#include "Core/Base/Types.h"

#include <array>

namespace orthoslices
{
/**
 * Least squares for z = c0 + c1 x + c2 y + c3 x^2 + c4 xy + c5 y^2. All products of two of these
 * terms are moments x^i y^j with i + j <= 4, so that only those are summed.
 */
class QuadraticFit
{
public:
  /// What is added to the diagonal of the normal equations (ridge regression). Where little data
  /// leave second derivatives open, the flattest solution is taken: curvatures cost much more than
  /// height and slopes, and both much less than data, if coordinates and weights are of order 1.
  static constexpr double PlaneRidge = 1e-12;
  static constexpr double CurvatureRidge = 1e-6;

  void AddPoint(double x, double y, double z, double weight)
  {
    const double wx = weight * x, wy = weight * y;
    const double xx = x * x, xy = x * y, yy = y * y;
    const double powers[15] = { weight, wx, wy, wx * x, wx * y, wy * y, wx * xx, wy * xx, wx * yy,
      wy * yy, weight * xx * xx, weight * xx * xy, weight * xx * yy, weight * xy * yy,
      weight * yy * yy };
    for (int i = 0; i < 15; ++i)
    {
      this->Moments[i] += powers[i];
    }
    for (int i = 0; i < 6; ++i)
    {
      this->Right[i] += z * powers[i];
    }
  }

  /// The tangent plane with normal (nx, ny, nz) at (x, y).
  void AddNormal(double x, double y, const Point3& normal, double weight)
  {
    const double nz = normal[2];
    this->AddRow({ 0.0, nz, 0.0, 2.0 * x * nz, y * nz, 0.0 }, -normal[0], weight);
    this->AddRow({ 0.0, 0.0, nz, 0.0, x * nz, 2.0 * y * nz }, -normal[1], weight);
  }

  /// Height at the origin; 0 if the data do not determine it.
  double HeightAtOrigin()
  {
    // Which moment each product of two terms is.
    constexpr int product[6][6] = { { 0, 1, 2, 3, 4, 5 }, { 1, 3, 4, 6, 7, 8 },
      { 2, 4, 5, 7, 8, 9 }, { 3, 6, 7, 10, 11, 12 }, { 4, 7, 8, 11, 12, 13 },
      { 5, 8, 9, 12, 13, 14 } };
    for (int i = 0; i < 6; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        this->Matrix[i][j] += this->Moments[product[i][j]];
      }
      this->Matrix[i][i] += i < 3 ? PlaneRidge : CurvatureRidge;
    }
    if (!Factorize(this->Matrix))
    {
      return 0.0;
    }
    Substitute(this->Matrix, this->Right);
    return this->Right[0];
  }

  /// What HeightAtOrigin has found.
  double HeightAt(double x, double y) const
  {
    const double* c = this->Right;
    return c[0] + x * (c[1] + x * c[3] + y * c[4]) + y * (c[2] + y * c[5]);
  }
  /// How much the height grows along x and y.
  std::array<double, 2> SlopesAt(double x, double y) const
  {
    const double* c = this->Right;
    return { c[1] + 2.0 * x * c[3] + y * c[4], c[2] + x * c[4] + 2.0 * y * c[5] };
  }

private:
  void AddRow(const std::array<double, 6>& row, double value, double weight)
  {
    for (int i = 1; i < 6; ++i)
    {
      for (int j = 1; j <= i; ++j)
      {
        this->Matrix[i][j] += weight * row[i] * row[j];
      }
      this->Right[i] += weight * row[i] * value;
    }
  }

  double Moments[15] = {};  ///< of the points, weighted
  double Matrix[6][6] = {}; ///< of the normals
  double Right[6] = {};
};
}

#endif
