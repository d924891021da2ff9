// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MeshImprover.h"

#include "Core/Base/Vectors.h"
#include "Core/Improve/MakesFold.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

/// Operations for each triangle that there is, at most: a guard, as each makes something better.
constexpr std::size_t MaxWork = 10;

/// Triangles below that share of the angle are split, if nothing else helps: 20 of 22 degrees.
constexpr double SplitBound = 0.91;

/// The bounds, as shares of the one asked for: the worst come first.
constexpr std::array<double, 3> Bounds{ 0.12, 0.5, 1.0 };

/// The same of a collapse, which leaves two triangles less, so that the next one may gain more.
constexpr double LeastOfFirstCollapse = 0.95;

/// The cosine of the angle by which a triangle may turn: 60 degrees.
constexpr double MostTurn = 0.5;

/// What may be done in addition to the worst triangles that are left: those below the share of the
/// angle may move the surface by so many tolerances, and turn by 84 degrees.
constexpr double WorstBound = 0.23;
constexpr double MoreForWorst = 1.4;
constexpr double MostTurnOfWorst = 0.1;

/// What is split and does not get better may move the surface by so many tolerances: with 1.4, 1.7
/// and 2, the boot at 16 planes per axis has 97.9, 98.5 and 98.9 % of its triangles without an angle
/// below 20 degrees, at the same RMS error; but with 2, contours come to lie farther off than the
/// accuracy.
constexpr double MoreForLast = 1.7;

/// Below that share of the angle triangles may turn by any angle: folds and spikes, as thin as the
/// tolerance.
constexpr double FoldBound = 0.17;
constexpr double AnyTurn = -2.0;

/// Triangles that are looked at together, before anything is done to them: of a few, so many that
/// they are not beside each other: of 256, two of five were in vain on thin shapes. It does not
/// depend on the number of threads, so that the result does not either.
std::size_t SizeOfBatch(std::size_t count)
{
  constexpr std::size_t least = 8, most = 64, apart = 32;
  return std::max(least, std::min(most, count / apart));
}

/// The numbers from 0 on below a count, neighbours as far from each other as batches have to be.
std::vector<std::size_t> ListApart(std::size_t count)
{
  std::vector<std::size_t> order;
  order.reserve(count);
  const std::size_t step = (count + SizeOfBatch(count) - 1) / SizeOfBatch(count);
  for (std::size_t first = 0; first < step; ++first)
  {
    for (std::size_t i = first; i < count; i += step)
    {
      order.push_back(i);
    }
  }
  return order;
}
}

MeshImprover::MeshImprover(const SpatialGrid& grid, const ImprovementLimits& limits,
  const Execution& execution, ImprovableMesh& mesh)
  : Limits(limits)
  , Execute(execution)
  , Mesh(mesh)
  , State(grid, limits, mesh)
  , Guard(mesh.Corners, mesh.Points, this->State.Boxes, mesh.Borders)
  , TrianglesAtFirst(this->State.Qualities.size())
  , TouchedAt(mesh.Points.size(), 1)
  , FailedAt(this->TrianglesAtFirst)
  , ListedAt(this->TrianglesAtFirst, 0)
{
  this->State.LeastCosine = MostTurn;
  this->State.LeastOfCollapse = LeastOfFirstCollapse;
}

/// Notes that a triangle has changed.
void MeshImprover::Note(Index triangle)
{
  if (this->State.Update(triangle))
  {
    this->Open.push_back(triangle);
  }
}

/// Notes that the triangles at a point have changed.
void MeshImprover::Touch(Index point)
{
  this->Mesh.Corners.ForCornersAt(point,
    [&](Index corner)
    {
      this->TouchedAt[this->Mesh.Corners.StartOf(corner)] = this->Now;
      this->Note(corner / 3);
    });
  this->TouchedAt[point] = this->Now;
}

void MeshImprover::Apply(const LocalOperation& operation)
{
  CornerTable& corners = this->Mesh.Corners;
  ++this->Now;
  this->State.Samples.Take(operation.Change.Removed,
    operation.What == LocalOperation::Kind::Move         ? operation.Point
      : operation.What == LocalOperation::Kind::Collapse ? corners.StartOf(operation.Corner)
                                                         : -1);
  if (operation.What == LocalOperation::Kind::Flip)
  {
    const Index across = corners.OppositeOf(operation.Corner);
    for (const Index at : { operation.Corner, CornerTable::Next(operation.Corner),
           CornerTable::Previous(operation.Corner), across })
    {
      this->TouchedAt[corners.VertexOf(at)] = this->Now;
    }
    corners.Flip(operation.Corner);
    this->Note(operation.Corner / 3);
    this->Note(across / 3);
    this->State.Samples.PutDown(operation.Corner / 3, across / 3);
    return;
  }
  if (operation.What == LocalOperation::Kind::Split)
  {
    this->ApplySplit(operation);
    return;
  }
  Index point = operation.Point;
  if (operation.What == LocalOperation::Kind::Collapse)
  {
    const Index across = corners.OppositeOf(operation.Corner);
    point = corners.EndOf(operation.Corner);
    corners.Collapse(operation.Corner);
    this->Note(operation.Corner / 3);
    this->Note(across / 3);
  }
  else
  {
    this->Mesh.Points[point] = operation.Place;
  }
  this->Touch(point);
  this->State.Samples.PutDown(point);
}

void MeshImprover::ApplySplit(const LocalOperation& operation)
{
  CornerTable& corners = this->Mesh.Corners;
  const Index beside[2] = { operation.Corner / 3, corners.OppositeOf(operation.Corner) / 3 };
  // The corners of these sides, which are split, may be in other triangles then; those across are
  // not.
  std::vector<Index> beyond;
  for (const Index side : operation.Flipped)
  {
    beyond.push_back(corners.OppositeOf(side));
  }
  const Index start = corners.StartOf(operation.Corner), end = corners.EndOf(operation.Corner);
  const Point3 normal = this->Mesh.Normals[start] + this->Mesh.Normals[end];
  const Index point = corners.Split(operation.Corner);
  this->Mesh.Points.push_back(operation.Place);
  this->Mesh.Normals.push_back(Dot(normal, normal) > 0.0 ? Unit(normal) : normal);
  this->TouchedAt.push_back(this->Now);
  if (!this->Mesh.RoomOf.empty())
  {
    this->Mesh.RoomOf.push_back(this->Mesh.RoomOf[start]);
  }
  for (const Index triangle : beside)
  {
    const Index origin = static_cast<std::size_t>(triangle) < this->TrianglesAtFirst
      ? triangle
      : this->Mesh.Origins[triangle - this->TrianglesAtFirst];
    this->Mesh.Origins.push_back(origin);
    this->State.Qualities.push_back(0.0);
    this->FailedAt.push_back({});
    this->State.Boxes.Add(Box3(), triangle);
    this->ListedAt.push_back(0);
    this->State.Samples.AddTriangle(triangle);
  }
  for (const Index corner : beyond)
  {
    corners.Flip(corner);
  }
  this->Touch(point);
  this->State.Samples.PutDown(point);
}

/// Whether anything beside a triangle has changed since nothing helped it.
bool MeshImprover::MayHelp(Index triangle, Means means) const
{
  Index touched = 0;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    touched = std::max(touched, this->TouchedAt[this->Mesh.Corners.VertexOf(corner)]);
  }
  return touched > this->FailedAt[triangle][static_cast<std::size_t>(means)];
}

/// Sorts out of the open triangles those that are worse than a bound and may be helped.
std::vector<Index> MeshImprover::ListWorse(double quality, Means means)
{
  ++this->Listed;
  std::vector<Index> worse;
  for (const Index triangle : this->Open)
  {
    if (this->State.QualityOf(triangle) < quality && this->ListedAt[triangle] != this->Listed &&
      this->MayHelp(triangle, means))
    {
      this->ListedAt[triangle] = this->Listed;
      worse.push_back(triangle);
    }
  }
  this->Open.clear();
  return worse;
}

/// Does what was found for some triangles, one after another, but for what others of them have
/// changed or made impossible: that stays open.
void MeshImprover::ApplyFound(const std::vector<Index>& triangles, Means means)
{
  const Index before = this->Now;
  this->Extents.clear();
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    LocalOperation& found = this->Found[i];
    if (found.What == LocalOperation::Kind::None)
    {
      for (std::size_t failed = 0; failed <= static_cast<std::size_t>(means); ++failed)
      {
        this->FailedAt[triangles[i]][failed] = before;
      }
    }
    else if (this->IsUntouched(found, before) && this->IsStillAllowed(found))
    {
      this->Extents.push_back(found.Extent);
      this->Apply(found);
    }
    else
    {
      this->Open.push_back(triangles[i]);
    }
  }
}

/// Whether nothing beside what an operation changes was changed after others.
bool MeshImprover::IsUntouched(const LocalOperation& found, Index before) const
{
  for (const std::array<Index, 3>& triangle : found.Change.Added)
  {
    for (const Index point : triangle)
    {
      if (point != found.Change.Point && this->TouchedAt[point] > before)
      {
        return false;
      }
    }
  }
  return found.What != LocalOperation::Kind::Move || this->TouchedAt[found.Point] <= before;
}

/// Whether an operation that was allowed is so after others that were done since.
bool MeshImprover::IsStillAllowed(LocalOperation& found)
{
  if (found.What == LocalOperation::Kind::Split)
  {
    // Others may have got the number of the point.
    const Index point = this->Mesh.Corners.PointCount();
    for (std::array<Index, 3>& triangle : found.Change.Added)
    {
      std::replace(triangle.begin(), triangle.end(), found.Change.Point, point);
    }
    found.Change.Point = point;
  }
  return std::none_of(this->Extents.begin(), this->Extents.end(),
           [&](const Box3& other) { return other.Meets(found.Extent); }) ||
    (!MakesFold(this->Mesh.Corners, this->Mesh.Points, found.Change, this->Mesh.Borders) &&
      this->Guard.Allows(found.Change));
}

/// Improves some triangles as far as possible at the same time.
void MeshImprover::ImproveTogether(const std::vector<Index>& triangles, Means means)
{
  const bool mayGrow =
    static_cast<double>(this->Mesh.Origins.size()) < this->Limits.Growth * this->TrianglesAtFirst;
  const Means now = means >= Means::Splits && !mayGrow ? Means::Moves : means;
  this->Found.assign(triangles.size(), LocalOperation());
  this->Execute.For(triangles.size(),
    [&](std::size_t begin, std::size_t end)
    {
      OperationFinder finder(this->State);
      for (std::size_t i = begin; i < end; ++i)
      {
        finder.Find(triangles[i], now, this->Found[i]);
      }
    });
  this->ApplyFound(triangles, means);
}

/// Improves the triangles that are worse than a bound, and those that become so.
void MeshImprover::RunBelow(double quality, Means means)
{
  this->Open.resize(this->State.Qualities.size());
  std::iota(this->Open.begin(), this->Open.end(), 0);
  std::size_t work = MaxWork * this->Open.size();
  std::vector<Index> batch;
  for (std::vector<Index> worse = this->ListWorse(quality, means); !worse.empty() && work > 0;
       worse = this->ListWorse(quality, means))
  {
    for (const std::size_t i : ListApart(worse.size()))
    {
      if (this->State.QualityOf(worse[i]) < quality)
      {
        batch.push_back(worse[i]);
      }
      if (batch.size() == SizeOfBatch(worse.size()))
      {
        this->ImproveTogether(batch, means);
        batch.clear();
      }
    }
    this->ImproveTogether(batch, means);
    batch.clear();
    work -= std::min(work, worse.size());
  }
}

void MeshImprover::Run()
{
  const auto qualityOf = [](double degrees)
  {
    const double sine = std::sin(degrees * Degree);
    return sine * sine;
  };
  for (const double share : Bounds)
  {
    const double quality = qualityOf(share * this->Limits.SmallAngle);
    this->RunBelow(quality, Means::SameShape);
    this->RunBelow(quality, Means::Moves);
  }
  this->State.Slack = MoreForWorst;
  this->State.LeastCosine = MostTurnOfWorst;
  this->ForgetFailures();
  this->RunBelow(qualityOf(WorstBound * this->Limits.SmallAngle), Means::Moves);
  this->State.LeastOfCollapse = LeastGain; // else it might undo splits for ever
  const double wanted = qualityOf(SplitBound * this->Limits.SmallAngle);
  this->RunBelow(wanted, Means::Splits);
  this->State.Slack = MoreForLast;
  this->ForgetFailures();
  this->RunBelow(wanted, Means::Beside);
  this->State.LeastCosine = AnyTurn;
  this->ForgetFailures();
  this->RunBelow(qualityOf(FoldBound * this->Limits.SmallAngle), Means::Beside);
}

void MeshImprover::ForgetFailures()
{
  std::fill(this->FailedAt.begin(), this->FailedAt.end(), std::array<Index, MeansCount>{});
}
}
