// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SmoothSurface.h"

#include "Core/Base/LeastSquares.h"
#include "Core/Base/Monomials.h"
#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The degree of the polynomial. Its error falls with the fifth power of the patch's size; that of
/// the normals it is fitted to falls with the third power, and makes heights wrong by the fourth.
/// So a higher degree would gain nothing, and a lower one would lose what the normals tell.
constexpr int Degree = 4;

/// Products with normals are derivatives of monomials, which have one degree less.
constexpr int DerivativeTerms = MonomialCount(Degree - 1);

/// Added to squared distances, in squared mean radii of the border: no division by zero at a point
/// of the border, and 1e-12 of a radius from it no longer matters.
constexpr double Softening = 1e-24;

/**
 * The weight of nothing being left by the polynomial. What is left fades out at about two thirds of
 * the border's mean radius: noise of the contours stays near the border. Half and twice the value
 * change distances by +2 % and -2 % for noisy contours, +3 % and -2 % for exact ones, at most
 * (Testing/Benchmarks/PatchErrors).
 */
constexpr double Fading = 5.0;

/// Added to the diagonal for the monomials of each degree: keeps coefficients small of which the
/// border says little, so that the flattest surface is taken. Data count about 1, so these give way
/// to them. Half and twice as much change distances by 0.1 % (Testing/Benchmarks/PatchErrors).
constexpr double Flattening[Degree + 1] = { 1e-12, 1e-12, 1e-7, 1e-5, 1e-4 };

/// Borders with more points get a tree: points inside are as many or more, and the time would grow
/// with the square. Fewer are summed up as fast one by one.
constexpr std::size_t ManyPoints = 512;
}

bool SmoothSurface::Fit(const std::vector<Point3>& zeros, const std::vector<Point3>& gradients,
  const std::vector<double>& weights)
{
  double moments[Moments] = {};
  double withZ[Terms] = {}, withX[DerivativeTerms] = {}, withY[DerivativeTerms] = {};
  double zz = 0.0, gz = 0.0;
  for (std::size_t i = 0; i < zeros.size(); ++i)
  {
    const Point3 &p = zeros[i], &g = gradients[i];
    double values[Moments];
    EvaluateMonomials(p[0], p[1], weights[i], values);
    for (int k = 0; k < Moments; ++k)
    {
      moments[k] += values[k];
    }
    for (int k = 0; k < Terms; ++k)
    {
      withZ[k] += p[2] * values[k];
    }
    for (int k = 0; k < DerivativeTerms; ++k)
    {
      withX[k] += g[0] * values[k];
      withY[k] += g[1] * values[k];
    }
    zz += weights[i] * (p[2] * p[2] + 1.0);
    gz += weights[i] * g[2];
  }
  double matrix[Terms + 1][Terms + 1];
  ForMonomials(Degree,
    [&](int row, int i, int j)
    {
      double right = i > 0 ? i * withX[MonomialNumber(i - 1, j)] : 0.0;
      right += j > 0 ? j * withY[MonomialNumber(i, j - 1)] : 0.0;
      this->Coefficients[row] = right;
      matrix[Terms][row] = withZ[row];
      ForMonomials(Degree,
        [&](int column, int k, int l)
        {
          double sum = moments[MonomialNumber(i + k, j + l)];
          sum += i > 0 && k > 0 ? i * k * moments[MonomialNumber(i + k - 2, j + l)] : 0.0;
          sum += j > 0 && l > 0 ? j * l * moments[MonomialNumber(i + k, j + l - 2)] : 0.0;
          matrix[row][column] = sum;
        });
      matrix[row][row] += Flattening[i + j];
    });
  matrix[Terms][Terms] = zz;
  this->Coefficients[Terms] = gz;
  if (!Factorize(matrix))
  {
    return false;
  }
  Substitute(matrix, this->Coefficients);
  this->SetResidual(zeros, gradients, weights);
  return true;
}

void SmoothSurface::SetResidual(const std::vector<Point3>& zeros,
  const std::vector<Point3>& gradients, const std::vector<double>& weights)
{
  this->Residuals.resize(zeros.size());
  for (std::size_t i = 0; i < zeros.size(); ++i)
  {
    Point3 gradient;
    const double value = this->Polynomial(zeros[i], gradient);
    this->Residuals[i] = { weights[i], zeros[i], -value, gradients[i] - gradient };
  }
  this->Tree.Clear();
  if (zeros.size() > ManyPoints)
  {
    this->Tree.Set(this->Residuals);
  }
}

double SmoothSurface::Deviation() const
{
  double sum = 0.0;
  for (const Residual& r : this->Residuals)
  {
    sum += r.Weight * r.Value * r.Value;
  }
  return std::sqrt(sum);
}

double SmoothSurface::Polynomial(const Point3& p, Point3& gradient) const
{
  const double* c = this->Coefficients;
  const double x = p[0], y = p[1];
  // Horner's rule in y for each power of x.
  const double c0 = c[0] + y * (c[2] + y * (c[5] + y * (c[9] + y * c[14])));
  const double c1 = c[1] + y * (c[4] + y * (c[8] + y * c[13]));
  const double c2 = c[3] + y * (c[7] + y * c[12]);
  const double c3 = c[6] + y * c[11];
  const double c4 = c[10];
  const double d0 = c[2] + y * (2.0 * c[5] + y * (3.0 * c[9] + y * 4.0 * c[14]));
  const double d1 = c[4] + y * (2.0 * c[8] + y * 3.0 * c[13]);
  const double d2 = c[7] + y * 2.0 * c[12];
  const double d3 = c[11];
  gradient = { c1 + x * (2.0 * c2 + x * (3.0 * c3 + x * 4.0 * c4)),
    d0 + x * (d1 + x * (d2 + x * d3)), c[Terms] };
  return c0 + x * (c1 + x * (c2 + x * (c3 + x * c4))) + c[Terms] * p[2];
}

double SmoothSurface::operator()(const Point3& p, Point3& gradient) const
{
  // Sums over the border of the weights, of the values that they weigh, and of the derivatives of
  // both, which all point from the border to p: the weight of a point falls with the fourth power.
  double weights = Fading, values = 0.0;
  double gx = 0.0, gy = 0.0, gz = 0.0;
  double wx = 0.0, wy = 0.0, wz = 0.0;
  double vx = 0.0, vy = 0.0, vz = 0.0;
  const auto add = [&](const Residual& r)
  {
    const double dx = p[0] - r.Place[0], dy = p[1] - r.Place[1], dz = p[2] - r.Place[2];
    const double inverse = 1.0 / (dx * dx + dy * dy + dz * dz + Softening);
    const double w = r.Weight * inverse * inverse;
    const double value = r.Value + r.Gradient[0] * dx + r.Gradient[1] * dy + r.Gradient[2] * dz;
    const double change = w * inverse, changeOfValue = change * value;
    weights += w;
    values += w * value;
    gx += w * r.Gradient[0];
    gy += w * r.Gradient[1];
    gz += w * r.Gradient[2];
    wx += change * dx;
    wy += change * dy;
    wz += change * dz;
    vx += changeOfValue * dx;
    vy += changeOfValue * dy;
    vz += changeOfValue * dz;
  };
  if (this->Tree.IsEmpty())
  {
    std::for_each(this->Residuals.begin(), this->Residuals.end(), add);
  }
  else
  {
    this->Tree.VisitFrom(p, this->Residuals, add);
  }
  const double inverse = 1.0 / weights;
  const double mean = inverse * values;
  const double value = this->Polynomial(p, gradient);
  gradient[0] += inverse * (gx - 4.0 * (vx - mean * wx));
  gradient[1] += inverse * (gy - 4.0 * (vy - mean * wy));
  gradient[2] += inverse * (gz - 4.0 * (vz - mean * wz));
  return value + mean;
}
}
