// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/FieldEquations.h"

#include "Core/Base/Vectors.h"

#include <array>

namespace orthoslices
{
namespace
{
using Matrix = FieldEquations::Matrix;

/// The corners of a regular tetrahedron, of a cube of size 1. The linear polynomial that is 1 at one
/// and 0 at the others is 1/4 plus the product with that corner.
constexpr std::array<Point3, 4> Corners{ Point3{ -0.5, -0.5, -0.5 }, Point3{ -0.5, 0.5, 0.5 },
  Point3{ 0.5, -0.5, 0.5 }, Point3{ 0.5, 0.5, -0.5 } };
/// Where the samples leave a polynomial open, the least of these pivots is zero but for rounding.
constexpr double LeastPivot = 1e-10;

/// Values and slopes of the polynomials at the samples.
Matrix MakePolynomials(const std::vector<ContourSample>& samples)
{
  Matrix result(2 * samples.size(), 4);
  Eigen::Index row = 0;
  for (const ContourSample& sample : samples)
  {
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      result(row, k) = 0.25 + Dot(sample.Position, Corners[k]);
      result(row + 1, k) = Dot(sample.Inwards, Corners[k]);
    }
    row += 2;
  }
  return result;
}

/// Values and slopes of the kernels of the four corners at the samples.
Matrix MakeKernelsOfCorners(const std::vector<ContourSample>& samples)
{
  Matrix result(2 * samples.size(), 4);
  Eigen::Index row = 0;
  for (const ContourSample& sample : samples)
  {
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      const Point3 u = sample.Position - Corners[k];
      const double r = Length(u);
      result(row, k) = r * r * r;
      result(row + 1, k) = 3.0 * r * Dot(u, sample.Inwards);
    }
    row += 2;
  }
  return result;
}

/// What the kernels of the corners are at the corners, and the polynomials' own part.
Eigen::Matrix4d MakeCornerKernels()
{
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  for (Eigen::Index i = 0; i < 4; ++i)
  {
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      const double r = Length(Corners[i] - Corners[k]);
      result(i, k) += r * r * r;
    }
  }
  return result;
}

/// The lower triangle of the columns of a sample, of A alone.
void FillKernels(const std::vector<ContourSample>& samples, std::size_t j, Matrix& matrix)
{
  const auto column = static_cast<Eigen::Index>(2 * j);
  const ContourSample& source = samples[j];
  for (std::size_t i = j; i < samples.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(2 * i);
    const ContourSample& at = samples[i];
    const Point3 u = at.Position - source.Position;
    const double r = Length(u);
    const double atSlope = Dot(u, at.Inwards), sourceSlope = Dot(u, source.Inwards);
    matrix(row, column) = r * r * r;
    matrix(row + 1, column) = 3.0 * r * atSlope;
    matrix(row, column + 1) = -3.0 * r * sourceSlope;
    matrix(row + 1, column + 1) =
      r > 0.0 ? -3.0 * (r * Dot(at.Inwards, source.Inwards) + atSlope * sourceSlope / r) : 0.0;
  }
}

/// The lower triangle of the positive definite matrix.
Matrix MakeMatrix(const std::vector<ContourSample>& samples, const Matrix& polynomials,
  const Matrix& atCorners, const Execution& execution)
{
  const Matrix taken = (atCorners - 0.5 * polynomials * MakeCornerKernels()).transpose();
  const Matrix shares = polynomials.transpose();
  const auto n = static_cast<Eigen::Index>(2 * samples.size());
  Matrix matrix(n, n);
  execution.For(samples.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t j = begin; j < end; ++j)
      {
        FillKernels(samples, j, matrix);
        for (auto column = static_cast<Eigen::Index>(2 * j), last = column + 2; column < last;
             ++column)
        {
          const Eigen::Index below = n - column;
          matrix.col(column).tail(below).noalias() -=
            polynomials.bottomRows(below) * taken.col(column) +
            taken.rightCols(below).transpose() * shares.col(column);
        }
      }
    });
  return matrix;
}

/// Those of the samples that all choices share, and of those that one has besides.
std::vector<Eigen::Index> ListRows(
  Eigen::Index count, Eigen::Index shared, const std::vector<std::uint8_t>& chosen)
{
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < count; ++row)
  {
    if (row < shared || chosen[static_cast<std::size_t>(row - shared) / 2] != 0)
    {
      rows.push_back(row);
    }
  }
  return rows;
}

Matrix SelectRows(const Matrix& matrix, const std::vector<Eigen::Index>& rows,
  const std::vector<Eigen::Index>& columns)
{
  Matrix result(rows.size(), columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j)
  {
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      result(i, j) = matrix(rows[i], columns[j]);
    }
  }
  return result;
}

/// In place. False if the matrix is not positive definite.
bool FactorLower(Eigen::Ref<Matrix> matrix)
{
  return Eigen::LLT<Eigen::Ref<Matrix>>(matrix).info() == Eigen::Success;
}
}

FieldEquations::FieldEquations(
  const std::vector<ContourSample>& samples, const Execution& execution)
  : Polynomials(MakePolynomials(samples))
  , AtPoints(MakeKernelsOfCorners(samples))
{
  this->Factor = MakeMatrix(samples, this->Polynomials, this->AtPoints, execution);
  this->Solved = FactorLower(this->Factor);
  this->Finish();
}

/// The polynomials' own equations.
void FieldEquations::Finish()
{
  if (!this->Solved)
  {
    return;
  }
  const auto lower = this->Factor.triangularView<Eigen::Lower>();
  this->Combinations = lower.solve(this->Polynomials);
  const Eigen::Matrix4d squares = this->Combinations.transpose() * this->Combinations;
  lower.adjoint().solveInPlace(this->Combinations);
  this->Coefficients.compute(squares);
  const Eigen::Vector4d pivots = this->Coefficients.vectorD();
  this->Solved = pivots.minCoeff() > LeastPivot * pivots.maxCoeff();
}

SharedEquations::SharedEquations(
  const std::vector<ContourSample>& samples, std::size_t shared, const Execution& execution)
  : Shared(static_cast<Eigen::Index>(2 * shared))
{
  this->All.Polynomials = MakePolynomials(samples);
  this->All.AtPoints = MakeKernelsOfCorners(samples);
  Matrix& matrix = this->All.Factor;
  matrix = MakeMatrix(samples, this->All.Polynomials, this->All.AtPoints, execution);
  this->All.Solved = true;
  if (shared > 0)
  {
    const Eigen::Index others = matrix.rows() - this->Shared;
    auto common = matrix.topLeftCorner(this->Shared, this->Shared);
    auto below = matrix.bottomLeftCorner(others, this->Shared);
    this->All.Solved = FactorLower(common);
    common.triangularView<Eigen::Lower>().adjoint().solveInPlace<Eigen::OnTheRight>(below);
    matrix.bottomRightCorner(others, others)
      .selfadjointView<Eigen::Lower>()
      .rankUpdate(below, -1.0);
  }
}

FieldEquations SharedEquations::Choose(const std::vector<std::uint8_t>& chosen) const
{
  const std::vector<Eigen::Index> rows = ListRows(this->All.Factor.rows(), this->Shared, chosen);
  const auto others = static_cast<Eigen::Index>(rows.size()) - this->Shared;
  FieldEquations result;
  result.Factor = SelectRows(this->All.Factor, rows, rows);
  result.Polynomials = SelectRows(this->All.Polynomials, rows, { 0, 1, 2, 3 });
  result.AtPoints = SelectRows(this->All.AtPoints, rows, { 0, 1, 2, 3 });
  result.Solved = this->All.Solved && FactorLower(result.Factor.bottomRightCorner(others, others));
  result.Finish();
  return result;
}

Eigen::VectorXd FieldEquations::Solve(const Eigen::VectorXd& values) const
{
  const Eigen::Index n = values.size();
  const auto lower = this->Factor.triangularView<Eigen::Lower>();
  Eigen::VectorXd weights = lower.solve(values);
  lower.adjoint().solveInPlace(weights);
  const Eigen::Vector4d polynomials =
    this->Coefficients.solve(Eigen::Vector4d(this->Polynomials.transpose() * weights));
  weights.noalias() -= this->Combinations * polynomials;
  // What the kernels of the corners have taken away comes back as a polynomial.
  const Eigen::Vector4d ofCorners = polynomials - this->AtPoints.transpose() * weights;
  Eigen::VectorXd result(n + 4);
  result.head(n) = weights;
  result[n] = 0.25 * ofCorners.sum();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    result[n + 1 + axis] = 0.0;
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      result[n + 1 + axis] += ofCorners[k] * Corners[k][axis];
    }
  }
  return result;
}
}
