// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Correspondence/EllipticalCylinders.h"
#include "Core/Base/Vectors.h"

#include "Core/Correspondence/ContourEllipse.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
constexpr double MaxMisfit = 0.12;   ///< of an ellipse, as a share of the contour's area
constexpr double MaxError = 1.0;     ///< of a prediction, in mean semi-axes
constexpr double MaxChange = 0.5;    ///< of shape from slice to slice at first, likewise
constexpr double SlopePenalty = 0.1; ///< for each mean semi-axis that a seed moves per slice
constexpr Index None = -1;

/// Centre and shape.
struct Parameters
{
  Point2 Center;
  Point3 Shape;
};

/// Length of a shape (uu, uv, vv) as a symmetric matrix (Frobenius norm).
double Norm(const Point3& m) { return std::sqrt(m[0] * m[0] + 2 * m[1] * m[1] + m[2] * m[2]); }

Point2 CenterOffset(const Parameters& a, const Parameters& b) { return b.Center - a.Center; }

Point3 ShapeOffset(const Parameters& a, const Parameters& b) { return b.Shape - a.Shape; }

double Distance(const Parameters& a, const Parameters& b)
{
  return std::hypot(Length(CenterOffset(a, b)), Norm(ShapeOffset(a, b)));
}

/// Three contours on consecutive slices.
struct Seed
{
  double Cost;
  std::array<Index, 3> Contours;
  double Error; ///< of the prediction of the third

  bool operator<(const Seed& other) const
  {
    return std::tie(this->Cost, this->Contours) < std::tie(other.Cost, other.Contours);
  }
};

class CylinderBuilder
{
public:
  explicit CylinderBuilder(const ContourStack& stack);
  std::vector<Correspondence> Run();

private:
  /// Directions along the axis, as places in Neighbour.
  enum Direction
  {
    Down,
    Up
  };

  struct Found
  {
    Index Contour = None;
    double Error = std::numeric_limits<double>::infinity();
  };

  static Direction Opposite(Direction direction) { return direction == Up ? Down : Up; }
  Index SliceBeyond(Index contour, Direction direction) const;
  double Scale(Index contour) const;
  bool MayBelong(Index a, Index b) const { return this->Sense[a] * this->Sense[b] > 0; }
  bool IsAlone(Index i) const
  {
    return this->Neighbour[Down][i] == None && this->Neighbour[Up][i] == None;
  }
  Parameters Extrapolate(Index from, Index last, Index slice) const;
  Parameters PredictBeyond(Index contour, Direction direction) const;
  template <typename Function>
  void VisitNear(Index slice, const Point2& center, double radius, const Function& visit) const;

  std::vector<Seed> FindSeeds() const;
  void AddSeedsAbove(Index lower, Index middle, std::vector<Seed>& seeds) const;
  void Link(Index lower, Index upper, double error);
  void Grow(Index end, Direction direction);
  void LinkPairs();
  Found NearestAlike(Index contour, Direction direction) const;
  void JoinEnds(Direction direction);

  const ContourStack& Stack;
  std::vector<Index> First;
  std::vector<ContourEllipse> Ellipses;
  std::vector<Parameters> Values;
  std::vector<int> Sense;                      ///< 0: complex, left out
  std::vector<std::vector<Index>> BySlice;     ///< those not left out, by centre u
  std::array<std::vector<Index>, 2> Neighbour; ///< in the same cylinder
  std::vector<Correspondence> Pairs;
};

CylinderBuilder::CylinderBuilder(const ContourStack& stack)
  : Stack(stack)
  , First(FirstContourOfSlices(stack))
  , Ellipses(FitEllipses(stack))
  , BySlice(stack.Coordinate.size())
{
  const std::vector<double> areas = SignedAreas(stack);
  for (Index i = 0; i < stack.Count(); ++i)
  {
    this->Values.push_back({ this->Ellipses[i].Center, this->Ellipses[i].Shape() });
    this->Sense.push_back(this->Ellipses[i].Misfit > MaxMisfit ? 0 : areas[i] > 0.0 ? 1 : -1);
    if (this->Sense[i] != 0)
    {
      this->BySlice[stack.Slice[i]].push_back(i);
    }
  }
  for (std::vector<Index>& slice : this->BySlice)
  {
    std::stable_sort(slice.begin(), slice.end(),
      [this](Index a, Index b) { return this->Values[a].Center[0] < this->Values[b].Center[0]; });
  }
  this->Neighbour.fill(std::vector<Index>(stack.Slice.size(), None));
}

/// The slice after that of the contour, or None.
Index CylinderBuilder::SliceBeyond(Index contour, Direction direction) const
{
  const Index slice = this->Stack.Slice[contour] + (direction == Up ? 1 : -1);
  return slice >= 0 && slice < this->Stack.SliceCount() ? slice : None;
}

double CylinderBuilder::Scale(Index contour) const
{
  return 0.5 * (this->Ellipses[contour].Major + this->Ellipses[contour].Minor);
}

Parameters CylinderBuilder::Extrapolate(Index from, Index last, Index slice) const
{
  const std::vector<double>& z = this->Stack.Coordinate;
  const Index a = this->Stack.Slice[from], b = this->Stack.Slice[last];
  const double t = (z[slice] - z[b]) / (z[b] - z[a]);
  const Point2 center = CenterOffset(this->Values[from], this->Values[last]);
  const Point3 shape = ShapeOffset(this->Values[from], this->Values[last]);
  Parameters next = this->Values[last];
  for (int i = 0; i < 2; ++i)
  {
    next.Center[i] += t * center[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    next.Shape[i] += t * shape[i];
  }
  return next;
}

/// On the next slice; a cylinder of one contour is taken for upright.
Parameters CylinderBuilder::PredictBeyond(Index contour, Direction direction) const
{
  const Index before = this->Neighbour[Opposite(direction)][contour];
  return before == None ? this->Values[contour]
                        : this->Extrapolate(before, contour, this->SliceBeyond(contour, direction));
}

/// Calls visit(contour) for the ellipses of a slice with centres in a square.
template <typename Function>
void CylinderBuilder::VisitNear(
  Index slice, const Point2& center, double radius, const Function& visit) const
{
  const std::vector<Index>& members = this->BySlice[slice];
  auto at = std::lower_bound(members.begin(), members.end(), center[0] - radius,
    [this](Index contour, double u) { return this->Values[contour].Center[0] < u; });
  for (; at != members.end() && this->Values[*at].Center[0] <= center[0] + radius; ++at)
  {
    if (std::abs(this->Values[*at].Center[1] - center[1]) <= radius)
    {
      visit(*at);
    }
  }
}

void CylinderBuilder::AddSeedsAbove(Index lower, Index middle, std::vector<Seed>& seeds) const
{
  const double scale = this->Scale(middle);
  const Point3 change = ShapeOffset(this->Values[lower], this->Values[middle]);
  const Index slice = this->SliceBeyond(middle, Up);
  if (slice == None || !this->MayBelong(lower, middle) || Norm(change) > MaxChange * scale)
  {
    return;
  }
  const Parameters predicted = this->Extrapolate(lower, middle, slice);
  const double slope = Length(CenterOffset(this->Values[lower], this->Values[middle]));
  this->VisitNear(slice, predicted.Center, MaxError * scale,
    [&](Index upper)
    {
      const double error = Distance(predicted, this->Values[upper]);
      if (this->MayBelong(middle, upper) && error <= MaxError * scale)
      {
        const double cost = (error + SlopePenalty * slope) / scale;
        seeds.push_back({ cost, { lower, middle, upper }, error / scale });
      }
    });
}

std::vector<Seed> CylinderBuilder::FindSeeds() const
{
  std::vector<Seed> seeds;
  for (std::size_t slice = 1; slice < this->BySlice.size(); ++slice)
  {
    for (const Index lower : this->BySlice[slice - 1])
    {
      for (const Index middle : this->BySlice[slice])
      {
        this->AddSeedsAbove(lower, middle, seeds);
      }
    }
  }
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

void CylinderBuilder::Link(Index lower, Index upper, double error)
{
  this->Neighbour[Up][lower] = upper;
  this->Neighbour[Down][upper] = lower;
  this->Pairs.push_back({ lower, upper, error });
}

/// Adds contour after contour until none that is free fits the prediction.
void CylinderBuilder::Grow(Index end, Direction direction)
{
  for (Index slice; (slice = this->SliceBeyond(end, direction)) != None;)
  {
    const Parameters predicted = this->PredictBeyond(end, direction);
    const double scale = this->Scale(end);
    Found best;
    this->VisitNear(slice, predicted.Center, MaxError * scale,
      [&](Index contour)
      {
        const double error = Distance(predicted, this->Values[contour]) / scale;
        if (this->IsAlone(contour) && this->MayBelong(end, contour) && error <= MaxError &&
          error < best.Error)
        {
          best = { contour, error };
        }
      });
    if (best.Contour == None)
    {
      return;
    }
    this->Link(std::min(end, best.Contour), std::max(end, best.Contour), best.Error);
    end = best.Contour;
  }
}

/// The closest contour of similar shape that is in no cylinder yet.
CylinderBuilder::Found CylinderBuilder::NearestAlike(Index contour, Direction direction) const
{
  Found best;
  const Index slice = this->SliceBeyond(contour, direction);
  for (Index other = slice == None ? 0 : this->First[slice];
       slice != None && other < this->First[slice + 1]; ++other)
  {
    const Parameters& a = this->Values[contour];
    const Parameters& b = this->Values[other];
    const double scale = std::min(this->Scale(contour), this->Scale(other));
    const double reach = this->Ellipses[contour].Major + this->Ellipses[other].Major;
    if (this->IsAlone(other) && this->MayBelong(contour, other) &&
      Norm(ShapeOffset(a, b)) <= MaxChange * scale && Length(CenterOffset(a, b)) <= reach &&
      Distance(a, b) < best.Error)
    {
      best = { other, Distance(a, b) };
    }
  }
  return best;
}

void CylinderBuilder::LinkPairs()
{
  std::vector<std::pair<Index, Index>> found;
  for (Index lower = 0; lower < this->Stack.Count(); ++lower)
  {
    const Index upper = this->IsAlone(lower) ? this->NearestAlike(lower, Up).Contour : None;
    if (upper != None && this->NearestAlike(upper, Down).Contour == lower)
    {
      found.push_back({ lower, upper });
    }
  }
  for (const auto& pair : found)
  {
    if (this->IsAlone(pair.first) && this->IsAlone(pair.second))
    {
      const double distance = Distance(this->Values[pair.first], this->Values[pair.second]);
      this->Link(pair.first, pair.second, distance / this->Scale(pair.first));
    }
  }
}

/// Where a cylinder ends, the nearest ellipse beyond that overlaps a prediction.
void CylinderBuilder::JoinEnds(Direction direction)
{
  for (Index end = 0; end < this->Stack.Count(); ++end)
  {
    const Index slice = this->SliceBeyond(end, direction);
    if (this->Sense[end] == 0 || this->Neighbour[direction][end] != None || slice == None)
    {
      continue;
    }
    const Parameters beyond = this->PredictBeyond(end, direction);
    Found best;
    for (const Index other : this->BySlice[slice])
    {
      const Parameters back = this->PredictBeyond(other, Opposite(direction));
      const double error = std::min(Length(CenterOffset(beyond, this->Values[other])),
                             Length(CenterOffset(back, this->Values[end]))) /
        this->Scale(end);
      if (this->MayBelong(end, other) && error < best.Error &&
        (DoOverlap(EllipseOfShape(beyond.Center, beyond.Shape), this->Ellipses[other]) ||
          DoOverlap(EllipseOfShape(back.Center, back.Shape), this->Ellipses[end])))
      {
        best = { other, error };
      }
    }
    if (best.Contour != None)
    {
      this->Pairs.push_back(
        { std::min(end, best.Contour), std::max(end, best.Contour), best.Error });
    }
  }
}

std::vector<Correspondence> CylinderBuilder::Run()
{
  for (const Seed& seed : this->FindSeeds())
  {
    const auto& [lower, middle, upper] = seed.Contours;
    if (this->IsAlone(lower) && this->IsAlone(middle) && this->IsAlone(upper))
    {
      this->Link(lower, middle, seed.Error);
      this->Link(middle, upper, seed.Error);
      this->Grow(upper, Up);
      this->Grow(lower, Down);
    }
  }
  this->LinkPairs();
  this->JoinEnds(Up);
  this->JoinEnds(Down);
  std::stable_sort(this->Pairs.begin(), this->Pairs.end());
  const auto same = [](const Correspondence& a, const Correspondence& b)
  { return a.First == b.First && a.Second == b.Second; };
  this->Pairs.erase(std::unique(this->Pairs.begin(), this->Pairs.end(), same), this->Pairs.end());
  return this->Pairs;
}
}

std::vector<Correspondence> CorrespondencesByCylinders(const ContourStack& stack)
{
  return CylinderBuilder(stack).Run();
}
}
