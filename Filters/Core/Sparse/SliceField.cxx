// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SliceField.h"

#include "Core/Base/Box.h"
#include "Core/Base/Vectors.h"
#include "Core/Sparse/FieldEquations.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
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
  void Place(const Box3& box, std::vector<ContourSample>&& samples);
  void FindSlopes(const Execution& execution, Eigen::VectorXd& values) const;
  double ValueAt(const Point3& p) const;
  Point3 GradientAt(const Point3& p) const;
  void Solve(const FieldEquations& equations, const Execution& execution);
};

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

namespace
{
/// The samples of several choices, each once: those of all choices first.
struct SampleUnion
{
  explicit SampleUnion(const std::vector<std::vector<ContourSample>>& choices);
  /// The samples of a choice, in the same order.
  std::vector<ContourSample> Choose(const std::vector<std::uint8_t>& chosen) const;

  std::vector<ContourSample> Samples;
  std::size_t Shared = 0;
  std::vector<std::vector<std::uint8_t>> Chosen; ///< of each choice, which of the others it has
};

SampleUnion::SampleUnion(const std::vector<std::vector<ContourSample>>& choices)
{
  using Key = std::pair<Point3, Point3>;
  std::map<Key, std::vector<std::uint8_t>> chosenBy;
  for (std::size_t i = 0; i < choices.size(); ++i)
  {
    for (const ContourSample& sample : choices[i])
    {
      auto& by = chosenBy[{ sample.Position, sample.Inwards }];
      if (by.empty())
      {
        by.assign(choices.size(), 0);
        this->Samples.push_back(sample);
      }
      by[i] = 1;
    }
  }
  const auto usersOf = [&](const ContourSample& sample) -> const std::vector<std::uint8_t>&
  { return chosenBy.find(Key(sample.Position, sample.Inwards))->second; };
  const auto others = std::stable_partition(this->Samples.begin(), this->Samples.end(),
    [&](const ContourSample& sample)
    {
      const std::vector<std::uint8_t>& by = usersOf(sample);
      return std::find(by.begin(), by.end(), 0) == by.end();
    });
  this->Shared = static_cast<std::size_t>(others - this->Samples.begin());
  this->Chosen.resize(choices.size());
  for (auto sample = others; sample != this->Samples.end(); ++sample)
  {
    for (std::size_t i = 0; i < choices.size(); ++i)
    {
      this->Chosen[i].push_back(usersOf(*sample)[i]);
    }
  }
}

std::vector<ContourSample> SampleUnion::Choose(const std::vector<std::uint8_t>& chosen) const
{
  std::vector<ContourSample> samples;
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    if (i < this->Shared || chosen[i - this->Shared] != 0)
    {
      samples.push_back(this->Samples[i]);
    }
  }
  return samples;
}
}

/// The sine of the angle between the surface and the plane of each slice.
void SliceField::Solution::FindSlopes(const Execution& execution, Eigen::VectorXd& values) const
{
  execution.For(this->Count(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const ContourSample& at = this->Samples[i];
        const Point3 gradient = this->GradientAt(at.Position);
        const double length = Length(gradient);
        const double slope = length > 0.0 ? Dot(gradient, at.Inwards) / length : 1.0;
        values[2 * static_cast<Eigen::Index>(i) + 1] = std::max(slope, LeastSlope);
      }
    });
}

void SliceField::Solution::Solve(const FieldEquations& equations, const Execution& execution)
{
  const auto n = static_cast<Eigen::Index>(this->Count());
  this->IsSolved = equations.IsSolved();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    values[2 * i + 1] = 1.0;
  }
  for (int round = 0; round < Rounds && this->IsSolved; ++round)
  {
    if (round > 0)
    {
      this->FindSlopes(execution, values);
    }
    const Eigen::VectorXd solved = equations.Solve(values);
    this->IsSolved = solved.allFinite();
    this->Weights.resize(solved.size());
    for (Eigen::Index i = 0; i < n; ++i)
    {
      this->Weights[i] = solved[2 * i];
      this->Weights[n + i] = solved[2 * i + 1];
    }
    this->Weights.tail<4>() = solved.tail<4>();
  }
}

/// Moves and scales the samples, which lie in `box`.
void SliceField::Solution::Place(const Box3& box, std::vector<ContourSample>&& samples)
{
  const Point3 extent = box.High - box.Low;
  this->Samples = std::move(samples);
  this->Centre = 0.5 * (box.Low + box.High);
  this->Scale = 1.0 / std::max({ extent[0], extent[1], extent[2] });
  this->Columns.resize(static_cast<Eigen::Index>(this->Count()), 6);
  Eigen::Index row = 0;
  for (ContourSample& sample : this->Samples)
  {
    sample.Position = this->Scale * (sample.Position - this->Centre);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Columns(row, axis) = sample.Position[axis];
      this->Columns(row, 3 + axis) = sample.Inwards[axis];
    }
    ++row;
  }
}

SliceField::SliceField()
  : Solved(std::make_unique<Solution>())
{
}

SliceField::SliceField(std::vector<ContourSample>&& samples, const Execution& execution)
  : SliceField()
{
  Box3 box;
  for (const ContourSample& sample : samples)
  {
    box.Add(sample.Position);
  }
  this->Solved->Place(box, std::move(samples));
  this->Solved->Solve(FieldEquations(this->Solved->Samples, execution), execution);
}

std::vector<SliceField> SliceField::ThroughEach(
  const std::vector<std::vector<ContourSample>>& choices, const Execution& execution)
{
  const SampleUnion all(choices);
  Box3 box;
  for (const ContourSample& sample : all.Samples)
  {
    box.Add(sample.Position);
  }
  SliceField whole;
  whole.Solved->Place(box, std::vector<ContourSample>(all.Samples));
  const SharedEquations equations(whole.Solved->Samples, all.Shared, execution);
  std::vector<SliceField> fields;
  for (const std::vector<std::uint8_t>& chosen : all.Chosen)
  {
    fields.push_back(SliceField());
    fields.back().Solved->Place(box, all.Choose(chosen));
    fields.back().Solved->Solve(equations.Choose(chosen), execution);
  }
  return fields;
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
