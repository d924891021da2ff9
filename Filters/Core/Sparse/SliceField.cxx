// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SliceField.h"

#include "Core/Base/Box.h"
#include "Core/Base/Vectors.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace
{
/// Slopes change little after that.
constexpr int Rounds = 4;
/// A slope below that is no more than the noise of a contour on a flat end.
constexpr double LeastSlope = 0.05;
}

/// Weights of the values and of the slopes at all samples, and a linear polynomial. Positions are
/// moved and scaled into a box of size 1, so that all parts of the system have about the same
/// magnitude.
struct SliceField::Solution
{
  Point3 Centre{};
  double Scale = 1.0;
  std::vector<ContourSample> Samples;
  Eigen::Array<double, Eigen::Dynamic, 6> Columns; ///< their positions and directions
  Eigen::VectorXd Weights;
  bool IsSolved = false;

  std::size_t Count() const { return this->Samples.size(); }
  Eigen::MatrixXd MakeSystem(const Execution& execution) const;
  Eigen::MatrixXd MakePolynomials() const;
  void FindSlopes(const Execution& execution, Eigen::VectorXd& values) const;
  void FillColumn(std::size_t column, Eigen::MatrixXd& system) const;
  double ValueAt(const Point3& p) const;
  Point3 GradientAt(const Point3& p) const;
  void Solve(const Execution& execution);
};

/// Column of the value at a sample, and of its slope.
void SliceField::Solution::FillColumn(std::size_t j, Eigen::MatrixXd& system) const
{
  const auto n = static_cast<Eigen::Index>(this->Count());
  const auto c = static_cast<Eigen::Index>(j);
  const ContourSample& source = this->Samples[j];
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const ContourSample& at = this->Samples[static_cast<std::size_t>(i)];
    const Point3 u = at.Position - source.Position;
    const double r = Length(u);
    const double atSlope = Dot(u, at.Inwards), sourceSlope = Dot(u, source.Inwards);
    system(i, c) = r * r * r;
    system(n + i, c) = 3.0 * r * atSlope;
    system(i, n + c) = -3.0 * r * sourceSlope;
    system(n + i, n + c) =
      r > 0.0 ? -3.0 * (r * Dot(at.Inwards, source.Inwards) + atSlope * sourceSlope / r) : 0.0;
  }
}

Eigen::MatrixXd SliceField::Solution::MakeSystem(const Execution& execution) const
{
  const auto n = static_cast<Eigen::Index>(this->Count());
  Eigen::MatrixXd system(2 * n, 2 * n);
  execution.For(this->Count(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t j = begin; j < end; ++j)
      {
        this->FillColumn(j, system);
      }
    });
  return system;
}

/// Values and slopes of 1, x, y and z at the samples.
Eigen::MatrixXd SliceField::Solution::MakePolynomials() const
{
  const auto n = static_cast<Eigen::Index>(this->Count());
  Eigen::MatrixXd polynomials = Eigen::MatrixXd::Zero(2 * n, 4);
  polynomials.col(0).head(n).setOnes();
  polynomials.topRightCorner(n, 3) = this->Columns.leftCols(3).matrix();
  polynomials.bottomRightCorner(n, 3) = this->Columns.rightCols(3).matrix();
  return polynomials;
}

double SliceField::Solution::ValueAt(const Point3& p) const
{
  // By columns, so that the loop runs on several samples at once.
  const Eigen::Index n = this->Columns.rows();
  const auto ux = p[0] - this->Columns.col(0), uy = p[1] - this->Columns.col(1),
             uz = p[2] - this->Columns.col(2);
  const auto squared = ux * ux + uy * uy + uz * uz;
  const auto along =
    ux * this->Columns.col(3) + uy * this->Columns.col(4) + uz * this->Columns.col(5);
  const auto weights = this->Weights.array();
  const double* last = this->Weights.data() + 2 * n;
  return (squared.sqrt() * (weights.head(n) * squared - 3.0 * weights.segment(n, n) * along))
           .sum() +
    last[0] + last[1] * p[0] + last[2] * p[1] + last[3] * p[2];
}

Point3 SliceField::Solution::GradientAt(const Point3& p) const
{
  const std::size_t n = this->Count();
  const double* weights = this->Weights.data();
  const double* last = weights + 2 * n;
  Point3 sum{ last[1], last[2], last[3] };
  for (std::size_t j = 0; j < n; ++j)
  {
    const Point3& inwards = this->Samples[j].Inwards;
    const Point3 u = p - this->Samples[j].Position;
    const double r = Length(u);
    const double slope = r > 0.0 ? Dot(u, inwards) / r : 0.0;
    sum = sum + 3.0 * (weights[j] * r - weights[n + j] * slope) * u -
      3.0 * weights[n + j] * r * inwards;
  }
  return sum;
}

/**
 * The system with the linear polynomials P: [A P; P^T 0] [w; c] = [b; 0]. On weights that are
 * orthogonal to all of them A is positive definite: in a basis that starts with the directions of
 * P, what is left of A without the first four takes a Cholesky factorisation.
 */
class Factors
{
public:
  Factors(Eigen::MatrixXd&& system, const Eigen::MatrixXd& polynomials)
    : System(std::move(system))
    , Basis(polynomials)
  {
    const Eigen::Index n = this->System.rows();
    this->System.applyOnTheLeft(this->Basis.householderQ().transpose());
    this->System.applyOnTheRight(this->Basis.householderQ());
    this->Above = this->System.topRightCorner(Linear, n - Linear);
    this->Cholesky.compute(this->System.bottomRightCorner(n - Linear, n - Linear));
  }

  bool IsSolved() const { return this->Cholesky.info() == Eigen::Success; }

  /// Weights, then the polynomial.
  Eigen::VectorXd Solve(const Eigen::VectorXd& values) const
  {
    const Eigen::Index n = values.size();
    Eigen::VectorXd turned = values;
    turned.applyOnTheLeft(this->Basis.householderQ().transpose());
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
    weights.tail(n - Linear) = this->Cholesky.solve(turned.tail(n - Linear));
    Eigen::VectorXd result(n + Linear);
    result.tail<Linear>() =
      this->Basis.matrixQR().topRows(Linear).template triangularView<Eigen::Upper>().solve(
        turned.head(Linear) - this->Above * weights.tail(n - Linear));
    weights.applyOnTheLeft(this->Basis.householderQ());
    result.head(n) = weights;
    return result;
  }

private:
  static constexpr int Linear = 4;
  Eigen::MatrixXd System, Above;
  Eigen::HouseholderQR<Eigen::MatrixXd> Basis;
  Eigen::LLT<Eigen::MatrixXd> Cholesky;
};

/// The sine of the angle between the surface and the plane of each slice.
void SliceField::Solution::FindSlopes(const Execution& execution, Eigen::VectorXd& values) const
{
  const auto n = static_cast<Eigen::Index>(this->Count());
  execution.For(this->Count(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const ContourSample& at = this->Samples[i];
        const Point3 gradient = this->GradientAt(at.Position);
        const double length = Length(gradient);
        const double slope = length > 0.0 ? Dot(gradient, at.Inwards) / length : 1.0;
        values[n + static_cast<Eigen::Index>(i)] = std::max(slope, LeastSlope);
      }
    });
}

void SliceField::Solution::Solve(const Execution& execution)
{
  const auto n = static_cast<Eigen::Index>(this->Count());
  const Factors factors(this->MakeSystem(execution), this->MakePolynomials());
  this->IsSolved = factors.IsSolved();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(2 * n);
  values.tail(n).setOnes();
  for (int round = 0; round < Rounds && this->IsSolved; ++round)
  {
    if (round > 0)
    {
      this->FindSlopes(execution, values);
    }
    this->Weights = factors.Solve(values);
    this->IsSolved = this->Weights.allFinite();
  }
}

SliceField::SliceField(std::vector<ContourSample>&& samples, const Execution& execution)
  : Solved(std::make_unique<Solution>())
{
  Solution& s = *this->Solved;
  s.Samples = std::move(samples);
  Box3 box;
  for (const ContourSample& sample : s.Samples)
  {
    box.Add(sample.Position);
  }
  const Point3 extent = box.High - box.Low;
  s.Centre = 0.5 * (box.Low + box.High);
  s.Scale = 1.0 / std::max({ extent[0], extent[1], extent[2] });
  s.Columns.resize(static_cast<Eigen::Index>(s.Count()), 6);
  Eigen::Index row = 0;
  for (ContourSample& sample : s.Samples)
  {
    sample.Position = s.Scale * (sample.Position - s.Centre);
    for (int axis = 0; axis < 3; ++axis)
    {
      s.Columns(row, axis) = sample.Position[axis];
      s.Columns(row, 3 + axis) = sample.Inwards[axis];
    }
    ++row;
  }
  s.Solve(execution);
}

SliceField::SliceField(SliceField&&) noexcept = default;
SliceField::~SliceField() = default;

bool SliceField::IsSolved() const { return this->Solved->IsSolved; }

double SliceField::Distance(const Point3& position) const
{
  const Solution& s = *this->Solved;
  const Point3 place = s.Scale * (position - s.Centre);
  return std::abs(s.ValueAt(place)) / (s.Scale * std::max(0.5, Length(s.GradientAt(place))));
}

double SliceField::Value(const Point3& position) const
{
  const Solution& s = *this->Solved;
  return s.ValueAt(s.Scale * (position - s.Centre)) / s.Scale;
}
}
