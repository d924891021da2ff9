// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RadialBasisFunction.h"

#include "vtkSMPTools.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orthoslices
{
namespace baselines
{
namespace
{

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>; // one point in each row

//------------------------------------------------------------------------------
Points PositionsOf(const std::vector<RadialConstraint>& constraints)
{
  Points points(static_cast<Eigen::Index>(constraints.size()), 3);
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      points(static_cast<Eigen::Index>(i), k) = constraints[i].Position[k];
    }
  }
  return points;
}

//------------------------------------------------------------------------------
Eigen::ArrayXd DistancesFrom(const Points& points, const Eigen::RowVector3d& position)
{
  return ((points.col(0).array() - position[0]).square() +
    (points.col(1).array() - position[1]).square() + (points.col(2).array() - position[2]).square())
    .sqrt();
}

//------------------------------------------------------------------------------
void ApplyKernel(RadialKernel kernel, Eigen::ArrayXd& distances)
{
  if (kernel == RadialKernel::Triharmonic)
  {
    distances = distances.cube().eval();
  }
}

//------------------------------------------------------------------------------
// Which constraints are centres already, and how far the function through these is off the others.
struct Fit
{
  std::vector<bool> IsCentre;
  std::vector<double> Residuals;
};

//------------------------------------------------------------------------------
// COUNT of SIZE constraints, evenly. A zero and the points on both sides of it follow each other:
// the first of one such three, the second of another one and so on.
Fit ChooseFirst(std::size_t count, std::size_t size)
{
  Fit fit{ std::vector<bool>(size, false), std::vector<double>(size, 0.0) };
  for (std::size_t i = 0; i < count; ++i)
  {
    fit.IsCentre[std::min(size - 1, i * size / count + i % 3)] = true;
  }
  return fit;
}

//------------------------------------------------------------------------------
// Consecutive constraints are neighbours on a contour: of the worst one in each short run of them,
// the COUNT worst become centres, which keeps new centres apart.
void AddWorst(std::size_t count, Fit& fit)
{
  constexpr std::size_t candidates = 3;
  const std::size_t size = fit.Residuals.size();
  const std::size_t run = std::max<std::size_t>(1, size / (candidates * count));
  std::vector<std::size_t> worst;
  for (std::size_t first = 0; first < size; first += run)
  {
    const auto begin = fit.Residuals.begin();
    worst.push_back(std::max_element(begin + first, begin + std::min(size, first + run)) - begin);
  }
  std::stable_sort(worst.begin(), worst.end(),
    [&fit](std::size_t a, std::size_t b) { return fit.Residuals[a] > fit.Residuals[b]; });
  worst.resize(std::min(worst.size(), count));
  for (const std::size_t i : worst)
  {
    fit.IsCentre[i] = true;
  }
}

//------------------------------------------------------------------------------
std::vector<RadialConstraint> CentresOf(
  const Fit& fit, const std::vector<RadialConstraint>& constraints)
{
  std::vector<RadialConstraint> centres;
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    if (fit.IsCentre[i])
    {
      centres.push_back(constraints[i]);
    }
  }
  return centres;
}

//------------------------------------------------------------------------------
double Measure(
  const RadialBasisFunction& function, const std::vector<RadialConstraint>& constraints, Fit& fit)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(constraints.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const RadialConstraint& c = constraints[i];
        fit.Residuals[i] =
          fit.IsCentre[i] ? 0.0 : std::abs(function.Evaluate(c.Position) - c.Value);
      }
    });
  return *std::max_element(fit.Residuals.begin(), fit.Residuals.end());
}

} // anonymous namespace

//------------------------------------------------------------------------------
// Positions are moved and scaled into a box of size 1, so that all parts of the system have about
// the same magnitude.
struct RadialBasisFunction::Solution
{
  RadialKernel Kernel;
  Eigen::RowVector3d Centre;
  double Scale = 1.0;
  Points Centres;
  Eigen::VectorXd Weights;
  Eigen::Vector4d Polynomial; // constant, then the factors of x, y and z

  Eigen::ArrayXd KernelsAt(const Eigen::RowVector3d& scaled) const
  {
    Eigen::ArrayXd kernels = DistancesFrom(this->Centres, scaled);
    ApplyKernel(this->Kernel, kernels);
    return kernels;
  }

  Eigen::MatrixXd MakeSystem() const
  {
    const Eigen::Index count = this->Centres.rows();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 4, count + 4);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      system.col(i).head(count) = this->KernelsAt(this->Centres.row(i)).matrix();
    }
    system.col(count).head(count).setOnes();
    system.block(0, count + 1, count, 3) = this->Centres;
    system.bottomRows(4).leftCols(count) = system.rightCols(4).topRows(count).transpose();
    return system;
  }
};

//------------------------------------------------------------------------------
RadialBasisFunction::RadialBasisFunction(
  const std::vector<RadialConstraint>& constraints, RadialKernel kernel)
  : Solved(std::make_unique<Solution>())
{
  if (constraints.size() < 4)
  {
    throw std::runtime_error("a radial basis function takes four constraints or more");
  }
  Solution& s = *this->Solved;
  s.Kernel = kernel;
  s.Centres = PositionsOf(constraints);
  const Eigen::RowVector3d low = s.Centres.colwise().minCoeff();
  const Eigen::RowVector3d high = s.Centres.colwise().maxCoeff();
  if (!((high - low).minCoeff() > 0.0))
  {
    throw std::runtime_error("a radial basis function takes constraints on more than one plane");
  }
  s.Centre = 0.5 * (low + high);
  s.Scale = 1.0 / (high - low).maxCoeff();
  s.Centres = ((s.Centres.rowwise() - s.Centre) * s.Scale).eval();

  const Eigen::Index count = s.Centres.rows();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(count + 4);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    values[i] = constraints[static_cast<std::size_t>(i)].Value;
  }
  Eigen::MatrixXd system = s.MakeSystem();
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factors(system); // in place
  const Eigen::VectorXd solution = factors.solve(values);
  if (!solution.allFinite())
  {
    throw std::runtime_error("the constraints do not determine a radial basis function");
  }
  s.Weights = solution.head(count);
  s.Polynomial = solution.tail<4>();
}

//------------------------------------------------------------------------------
RadialBasisFunction::RadialBasisFunction(RadialBasisFunction&&) noexcept = default;

//------------------------------------------------------------------------------
RadialBasisFunction::~RadialBasisFunction() = default;

//------------------------------------------------------------------------------
double RadialBasisFunction::Evaluate(const std::array<double, 3>& position) const
{
  const Solution& s = *this->Solved;
  const Eigen::RowVector3d scaled =
    (Eigen::RowVector3d(position[0], position[1], position[2]) - s.Centre) * s.Scale;
  return s.KernelsAt(scaled).matrix().dot(s.Weights) + s.Polynomial[0] +
    scaled.dot(s.Polynomial.tail<3>());
}

//------------------------------------------------------------------------------
RadialBasisFunction FitGreedily(const std::vector<RadialConstraint>& constraints,
  RadialKernel kernel, std::size_t largest, double accuracy)
{
  const std::size_t all = std::min(largest, constraints.size());
  std::size_t count = std::min(all, std::max<std::size_t>(50, all / 8));
  Fit fit = ChooseFirst(count, constraints.size());
  for (;;)
  {
    RadialBasisFunction function(CentresOf(fit, constraints), kernel);
    if (count >= all || Measure(function, constraints, fit) < accuracy)
    {
      return function;
    }
    AddWorst(std::min(count, all - count), fit);
    count = std::min(2 * count, all);
  }
}

} // namespace baselines
} // namespace orthoslices
