// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SmoothPatch.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
// Lengths are in mean radii of the border, as everywhere in PatchView. Half and twice as much of
// MinSlope, MaxDeviation and MaxStep change the errors that Testing/Benchmarks/PatchErrors prints
// by less than 0.05 %.

/// Slope of the function along a line below which it says nothing of where the zero is. The
/// gradient is about 1 where the surface is: there the line meets it at less than 6 degrees.
constexpr double MinSlope = 0.1;

/// Sides of the border that are shorter do not make the triangles beside them as small: points
/// would crowd around them.
constexpr double MinSide = 1e-3;

/// The same where triangles are to be few: what is beside short sides is improved afterwards.
constexpr double MinLightSide = 0.3;

/// The height of the surface over the sides of triangles inside a patch, by the accuracy that is
/// asked for. As their ends are moved out by the mean height, less than half of it is left beside
/// any place. With a third less or more, the RMS error of twelve shapes at 32 planes per axis
/// changes by 1 %, and the number of triangles by 5 %.
constexpr double HeightByAccuracy = 0.3;

/// The share of the mean height of the surface over the sides at a point inside a patch by which the
/// point is moved out. All of it would divide the error evenly if the surface were known; but
/// smooth patches bulge somewhat more than objects do. From all to 0.4, the RMS error of nine
/// shapes at 16 and 32 planes per axis gets smaller or stays, of the knot from 1.11 to 1.06 times
/// that of all triangles.
constexpr double ShareOfHeight = 0.4;

/// How far zeros may lie from the middle of the border, or from its heights. The top of a
/// hemisphere lies 1 off the middle of its rim: farther zeros are others, of another part of the
/// function.
constexpr double MaxDeviation = 1.5;

/// Normals of the border nearer to the middle than this (its border may pass close by) count as so
/// far away: else the curvature that they tell would have no bound.
constexpr double MinDistanceForCurvature = 0.5;

/// Newton's steps are cut to this: the polynomial is known on a few radii, and where its slope is
/// small, steps would leave them.
constexpr double MaxStep = 0.3;

/// Step of the polynomial after which the function itself, which takes all points of the border, is
/// asked: what it adds is about as large.
constexpr double MaxPolynomialStep = 1e-3;

/// Step of the function that is the last one: the next would be about its square, 1e-10.
constexpr double LastStep = 1e-5;

/// After that many steps there is none near: MaxDeviation takes 5 of MaxStep, and convergence some
/// 5.
constexpr int MaxSteps = 16;

/// Distance of the places at which a sign is looked for where Newton's method fails: 25 on each
/// side up to MaxDeviation. Sheets of the function closer than that are not told apart.
constexpr double SearchStep = 0.06;

/// Bisections of a SearchStep: to 6e-11.
constexpr int SearchBisections = 30;

/// How many times as far as the nearest place in the cell a place on the line may be. Where the
/// line runs along a face of the cell, any place on it in the cell may be far off the surface.
constexpr double MaxDetour = 3.0;

/// Points of a border times points inside: all of a border's points count for each. That many take
/// about 50 ms.
constexpr std::size_t MaxWork = 2000000;

/// Added to squared distances: no division by zero at a point of the border.
constexpr double Softening = 1e-24;

/// The greatest number of points of a triangulation with so many on the border. Two thousand more
/// suffice for an edge length of 0.025 plane spacings, a tenth of the default; the bound guards
/// against one near zero.
std::size_t MaxPoints(std::size_t border)
{
  return border + std::min(9 * border + 2000, MaxWork / border);
}
}

/// The length of triangle sides that the resolution asks for, in the plane of the view.
double SmoothPatchBuilder::SizeOfTriangles() const
{
  const bool isLight = this->Resolution.Accuracy > 0.0;
  const double tolerance = isLight
    ? HeightByAccuracy * this->Resolution.Accuracy * MinMeanSpacing(this->Grid)
    : this->Resolution.ChordTolerance;
  double size = this->Resolution.EdgeLength * (isLight ? this->View.Radius() : 1.0);
  if (tolerance > 0.0)
  {
    // How much the normals change over the patch is its curvature; a chord lies length^2 / 8 of it
    // off the surface.
    double change = 0.0;
    const std::vector<Point3>& places = this->View.Places();
    const std::vector<Point3>& normals = this->View.Normals();
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const double distance = std::hypot(places[i][0], places[i][1]);
      const double tilt = std::hypot(normals[i][0], normals[i][1]);
      change = distance > 0.0 ? std::max(change, tilt / std::max(distance, MinDistanceForCurvature))
                              : change;
    }
    const double curvature = change / this->View.Radius();
    const double length = std::sqrt(8.0 * tolerance / curvature);
    size = std::min(size, length);
  }
  return size / this->View.Radius();
}

/// The mean height of the border, as seen from a point: where the surface cannot be far.
double SmoothPatchBuilder::HeightAtBorder(const Point2& p) const
{
  double weights = 0.0, sum = 0.0;
  const std::vector<Point2>& border = this->View.Border();
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    const double x = p[0] - border[i][0], y = p[1] - border[i][1];
    const double w = 1.0 / (x * x + y * y + Softening);
    weights += w;
    sum += w * this->View.Places()[i][2];
  }
  return sum / weights;
}

/// Newton's method: with the polynomial, which costs little, and then with the function. The
/// gradient is that of the function at z or hardly off it.
bool SmoothPatchBuilder::FindHeight(const Point2& p, double& z, Point3& gradient) const
{
  const Point3 line = this->View.LineAt(p);
  z = 0.0;
  bool polynomial = true;
  for (int i = 0; i < MaxSteps; ++i)
  {
    const Point3 at = this->View.OnLine(p, z);
    const double value =
      polynomial ? this->Surface.Polynomial(at, gradient) : this->Surface(at, gradient);
    const double slope = Dot(gradient, line);
    if (slope < MinSlope)
    {
      return false;
    }
    const double step = std::max(-MaxStep, std::min(MaxStep, value / slope));
    z -= step;
    if (!polynomial && std::abs(step) < LastStep)
    {
      return std::abs(z) < MaxDeviation;
    }
    polynomial = polynomial && std::abs(step) > MaxPolynomialStep;
  }
  return false;
}

/// The nearest place on a line at which the function passes from inside to outside.
bool SmoothPatchBuilder::SearchHeight(
  const Point2& p, double guess, double& z, Point3& gradient) const
{
  const auto valueAt = [&](double height)
  { return this->Surface(this->View.OnLine(p, height), gradient); };
  double above = valueAt(guess), below = above;
  for (double d = SearchStep; d < MaxDeviation; d += SearchStep)
  {
    const double nextAbove = valueAt(guess + d), nextBelow = valueAt(guess - d);
    const bool isAbove = above < 0.0 && nextAbove >= 0.0;
    if (isAbove || (nextBelow < 0.0 && below >= 0.0))
    {
      double inside = isAbove ? guess + d - SearchStep : guess - d;
      double outside = inside + SearchStep;
      for (int i = 0; i < SearchBisections; ++i)
      {
        z = 0.5 * (inside + outside);
        (valueAt(z) < 0.0 ? inside : outside) = z;
      }
      return true;
    }
    above = nextAbove;
    below = nextBelow;
  }
  return false;
}

/// Whether a place lies a whole spacing or more beyond the contours, half of it beyond the bounds:
/// had the surface been there, one more slice would have cut it.
bool SmoothPatchBuilder::RunsAway(const Point3& place) const
{
  bool away = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beyond = 0.5 * this->Grid.SpacingAtEnds[axis];
    away = away || place[axis] < this->Grid.Lowest[axis] - beyond ||
      place[axis] > this->Grid.Highest[axis] + beyond;
  }
  return away;
}

/// Adds a point to the patch. False if the surface runs away from the contours there.
bool SmoothPatchBuilder::PlacePoint(
  const PatchBorder& border, const Point2& p, InnerPatch& patch) const
{
  double z;
  Point3 gradient;
  if (!this->FindHeight(p, z, gradient))
  {
    const double guess = this->HeightAtBorder(p);
    if (!this->SearchHeight(p, guess, z, gradient))
    {
      z = guess;
      gradient = { 0.0, 0.0, 0.0 }; // the triangles say more of the normal
    }
  }
  // Along the line, unless that is much farther.
  const Point3 wanted = this->View.ToWorld(this->View.OnLine(p, z));
  if (this->RunsAway(wanted))
  {
    return false;
  }
  const Point3 nearest = border.MoveInside(this->Grid, wanted);
  const Point3 onLine =
    this->View.ToWorld(this->View.OnLine(p, this->View.Clamp(p, border.Room, z)));
  const bool isNear =
    SquaredDistance(wanted, onLine) <= MaxDetour * MaxDetour * SquaredDistance(wanted, nearest);
  const Point3 place = isNear ? border.MoveInside(this->Grid, onLine) : nearest;
  patch.Points.push_back(place);
  patch.Normals.push_back(Unit(this->View.DirectionToWorld(gradient)));
  return true;
}

bool SmoothPatchBuilder::Fit(const PatchBorder& border)
{
  return this->View.Set(border) &&
    this->Surface.Fit(this->View.Places(), this->View.Normals(), border.Weights);
}

/// Triangulates the outline as it is seen in the plane.
bool SmoothPatchBuilder::Triangulate(const PatchBorder& border, const PatchBorder& outline)
{
  if (&outline != &border)
  {
    this->View.SetOutline(outline);
  }
  const std::vector<Point2>& polygon = this->View.Outline();
  if (!this->Disc.StartWithFan(polygon, { 0.0, 0.0 }) && !this->Disc.StartWithEars(polygon))
  {
    return false;
  }
  const Index n = outline.Count();
  const std::size_t maxPoints = MaxPoints(polygon.size());
  this->Disc.MakeDelaunay();
  const double minSide =
    this->Resolution.Accuracy > 0.0 && !this->Resolution.KeepsBorder ? MinLightSide : MinSide;
  this->Disc.Refine(this->SizeOfTriangles(), maxPoints, minSide);
  // No side between two points of the border may lie on a face of the cell.
  this->Disc.SplitSides(
    [&](Index a, Index b) { return a < n && b < n && outline.AreOnOneFace(a, b); });
  if (this->Disc.Points.size() == polygon.size())
  {
    this->Disc.SplitSides([n](Index a, Index b) { return a < n && b < n; });
  }
  return true;
}

/// Moves the points inside a patch with few triangles to the side to which the surface bulges, by
/// the mean height of the surface over the sides that meet there.
void SmoothPatchBuilder::Balance(const PatchBorder& outline, InnerPatch& patch) const
{
  std::vector<double> sums(patch.Points.size(), 0.0), counts(patch.Points.size(), 0.0);
  const auto place = [&](Index corner)
  { return corner >= 0 ? outline.Places[corner] : patch.Points[-1 - corner]; };
  const auto normal = [&](Index corner)
  { return corner >= 0 ? outline.Normals[corner] : patch.Normals[-1 - corner]; };
  for (const std::array<Index, 3>& triangle : patch.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangle[i], b = triangle[(i + 1) % 3];
      if (a >= 0)
      {
        continue;
      }
      // A circle is an eighth of this above its chord.
      sums[-1 - a] += 0.125 * Dot(place(b) - place(a), normal(b) - normal(a));
      counts[-1 - a] += 1.0;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const Point3 moved = patch.Points[i] + (ShareOfHeight * sums[i] / counts[i]) * patch.Normals[i];
    patch.Points[i] = outline.MoveInside(this->Grid, moved);
  }
}

bool SmoothPatchBuilder::Build(
  const PatchBorder& border, const PatchBorder& outline, InnerPatch& patch)
{
  patch.Clear();
  if (!this->Fit(border) || !this->Triangulate(border, outline))
  {
    return false;
  }
  const Index n = outline.Count();
  for (std::size_t i = static_cast<std::size_t>(n); i < this->Disc.Points.size(); ++i)
  {
    if (!this->PlacePoint(border, this->Disc.Points[i], patch))
    {
      return false;
    }
  }
  for (const LinkedTriangle& triangle : this->Disc.Triangles)
  {
    std::array<Index, 3> corners = triangle.Corners;
    for (Index& corner : corners)
    {
      corner = corner < n ? corner : n - 1 - corner;
    }
    patch.Triangles.push_back(corners);
  }
  if (this->Resolution.Accuracy > 0.0)
  {
    this->Balance(outline, patch);
  }
  return !patch.Points.empty() && this->View.SeesAll(patch);
}
}
