// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BlockImprover.h"

#include "Core/Base/Vectors.h"
#include "Core/Improve/MakesFold.h"

#include <algorithm>
#include <cmath>

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

/// LeastGain of a collapse, at first: it leaves two triangles less, so that the next may gain more.
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

/// Some triangles, neighbours far from each other: where one after another is improved beside the one
/// before, the shapes of thin parts are worse.
std::vector<Index> Spread(const std::vector<Index>& triangles)
{
  constexpr std::size_t apart = 64;
  const std::size_t step = triangles.size() / apart + 1;
  std::vector<Index> spread;
  spread.reserve(triangles.size());
  for (std::size_t first = 0; first < step; ++first)
  {
    for (std::size_t i = first; i < triangles.size(); i += step)
    {
      spread.push_back(triangles[i]);
    }
  }
  return spread;
}

/// The squared sine of that share of an angle.
double QualityOf(double share, double degrees)
{
  const double sine = std::sin(share * degrees * Degree);
  return sine * sine;
}
}

double BlockImprover::WantedQuality(const ImprovementLimits& limits, Round round)
{
  return QualityOf(round == Round::First ? 1.0 : SplitBound, limits.SmallAngle);
}

BlockImprover::BlockImprover(const SpatialGrid& grid, const ImprovementLimits& limits,
  std::size_t mostNew, MeshBlock& block, const SurfaceSamples& samples)
  : Limits(limits)
  , MostNew(mostNew)
  , Block(block)
  , Mesh(block.Mesh)
  , State(grid, block, samples)
  , Finder(this->State)
  , TouchedAt(this->Mesh.Points.size(), AtFirst)
  , FailedAt(this->State.Qualities.size())
  , CutShort(this->State.Qualities.size(), 0)
  , ListedAt(this->State.Qualities.size(), 0)
  , IsWanted(this->State.Qualities.size(), 0)
  , TrianglesAtFirst(this->State.Qualities.size())
{
  this->State.LeastCosine = MostTurn;
  this->State.LeastOfCollapse = LeastOfFirstCollapse;
}

/// Lets a triangle be looked at, if it is bad and nothing around it is frozen.
void BlockImprover::Want(Index triangle)
{
  if (this->State.QualityOf(triangle) < this->Bad && this->Block.IsFree(triangle))
  {
    this->Open.push_back(triangle);
    if (this->IsWanted[triangle] == 0)
    {
      this->IsWanted[triangle] = 1;
      this->Wanted.push_back(triangle);
    }
  }
}

/// Notes that a triangle has changed.
void BlockImprover::Note(Index triangle)
{
  if (this->State.Update(triangle))
  {
    this->Want(triangle);
  }
}

/// Notes that the triangles at a point have changed.
void BlockImprover::Touch(Index point)
{
  this->Mesh.Corners.ForCornersAt(point,
    [&](Index corner)
    {
      this->TouchedAt[this->Mesh.Corners.StartOf(corner)] = this->Now;
      this->Note(corner / 3);
    });
  this->TouchedAt[point] = this->Now;
}

void BlockImprover::Apply(const LocalOperation& operation)
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

void BlockImprover::ApplySplit(const LocalOperation& operation)
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
    this->CutShort.push_back(0);
    this->State.Boxes.Add(Box3(), triangle);
    this->ListedAt.push_back(0);
    this->IsWanted.push_back(0);
    this->State.Samples.AddTriangle(triangle);
  }
  for (const Index corner : beyond)
  {
    corners.Flip(corner);
  }
  this->Touch(point);
  this->State.Samples.PutDown(point);
}

/// When something beside a triangle has changed at last.
Index BlockImprover::LastTouch(Index triangle) const
{
  Index touched = 0;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    touched = std::max(touched, this->TouchedAt[this->Mesh.Corners.VertexOf(corner)]);
  }
  return touched;
}

/// Whether anything beside a triangle has changed since nothing helped it.
bool BlockImprover::MayHelp(Index triangle, Means means) const
{
  return this->LastTouch(triangle) > this->FailedAt[triangle][static_cast<std::size_t>(means)];
}

/// Sorts out of the open triangles those that are worse than a bound and may be helped.
std::vector<Index> BlockImprover::ListWorse(double quality, Means means)
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

/// Does what helps a triangle most.
void BlockImprover::Improve(Index triangle, Means means)
{
  const bool mayGrow = this->Mesh.Origins.size() < this->MostNew;
  const Means now = means >= Means::Splits && !mayGrow ? Means::Moves : means;
  if (this->Finder.Find(triangle, now, this->Found))
  {
    this->Apply(this->Found);
    return;
  }
  for (std::size_t failed = 0; failed <= static_cast<std::size_t>(means); ++failed)
  {
    this->FailedAt[triangle][failed] = this->Now;
  }
  this->CutShort[triangle] = this->Finder.WasCutShort() ? 1 : 0;
}

/// Improves the triangles that are worse than a bound, and those that become so.
void BlockImprover::RunBelow(double quality, Means means)
{
  this->Open = this->Wanted;
  std::size_t work = MaxWork * this->State.Qualities.size();
  for (std::vector<Index> worse = this->ListWorse(quality, means); !worse.empty() && work > 0;
       worse = this->ListWorse(quality, means))
  {
    for (const Index triangle : Spread(worse))
    {
      if (this->State.QualityOf(triangle) < quality)
      {
        this->Improve(triangle, means);
      }
    }
    work -= std::min(work, worse.size());
  }
}

void BlockImprover::Run(Round round, const std::vector<std::uint8_t>& tried)
{
  this->Bad = WantedQuality(this->Limits, round);
  for (std::size_t i = 0; i < this->TrianglesAtFirst; ++i)
  {
    if (tried[this->Block.Triangles[i]] == 0)
    {
      this->Want(static_cast<Index>(i));
      if (this->Block.IsFree(static_cast<Index>(i)))
      {
        this->Asked.push_back(static_cast<Index>(i));
      }
    }
  }
  if (round == Round::First)
  {
    this->RunFirst();
  }
  else
  {
    this->RunLast();
  }
}

void BlockImprover::RunFirst()
{
  for (const double share : Bounds)
  {
    const double quality = QualityOf(share, this->Limits.SmallAngle);
    this->RunBelow(quality, Means::SameShape);
    this->RunBelow(quality, Means::Moves);
  }
}

/// Moves corners of a triangle away from planes that they are pressed onto. Whether one was.
bool BlockImprover::Lift(Index triangle)
{
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    if (this->Finder.FindLift(this->Mesh.Corners.VertexOf(corner), this->Found))
    {
      this->Apply(this->Found);
      return true;
    }
  }
  return false;
}

/// Lets the ends of a short side of a triangle become one, or opens a fold at a side. Whether
/// something was done.
bool BlockImprover::Unfold(Index triangle)
{
  const CornerTable& corners = this->Mesh.Corners;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    const Index across = corners.OppositeOf(corner);
    if (corners.IsCurve(corner) || !this->Block.IsFree(across / 3))
    {
      continue;
    }
    const bool isShort = this->State.IsShort(corner);
    if (!isShort && !IsFolded(corners, this->Mesh.Points, corner))
    {
      continue;
    }
    if (isShort ? this->Finder.FindMerge(corner, this->Found)
                : this->Finder.FindUnfolding(corner, this->Found))
    {
      this->Apply(this->Found);
      return true;
    }
    this->CutShort[triangle] = this->Finder.WasCutShort() ? 1 : 0;
  }
  return false;
}

/// Opens folds, also those that are left beside what was changed.
void BlockImprover::Unfold()
{
  std::size_t work = MaxWork * this->Asked.size();
  while (!this->Asked.empty() && work > 0)
  {
    const Index triangle = this->Asked.back();
    this->Asked.pop_back();
    if (this->Mesh.Corners.IsAlive(3 * triangle) &&
      (this->Lift(triangle) || this->Unfold(triangle)))
    {
      --work;
      for (const Index changed : this->Found.Change.Removed)
      {
        if (this->Mesh.Corners.IsAlive(3 * changed) && this->Block.IsFree(changed))
        {
          this->Asked.push_back(changed);
        }
      }
    }
  }
}

void BlockImprover::RunLast()
{
  this->State.Slack = MoreForLast;
  this->Unfold();
  this->State.Slack = MoreForWorst;
  this->State.LeastCosine = MostTurnOfWorst;
  this->RunBelow(QualityOf(WorstBound, this->Limits.SmallAngle), Means::Moves);
  this->State.LeastOfCollapse = LeastGain; // else it might undo splits for ever
  this->RunBelow(this->Bad, Means::Splits);
  this->State.Slack = MoreForLast;
  this->ForgetFailures();
  this->RunBelow(this->Bad, Means::Beside);
  this->State.LeastCosine = AnyTurn;
  this->ForgetFailures();
  this->RunBelow(QualityOf(FoldBound, this->Limits.SmallAngle), Means::Beside);
}

void BlockImprover::ForgetFailures()
{
  std::fill(this->FailedAt.begin(), this->FailedAt.end(), std::array<Index, MeansCount>{});
}
}
