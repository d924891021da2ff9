// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/TiltAlongContour.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
// The percentages are changes of the errors that Testing/Benchmarks/PatchErrors prints for 10 and
// 16 planes.

/**
 * Tilt, in radians, beyond which the height over the slice is fitted: its slope is then above 1/2,
 * so that the tilt is well determined by it. Half and twice as much change the distances to exact
 * cuts by +3 % and -10 % at most and the angles of their normals by -5 % and -20 %; a greater value
 * has not been judged by other data yet.
 */
constexpr double MinSteepTilt = 0.5;

/// Component across the slice of the unit normals from which the slope over the slice is known: all
/// steep samples are to take part (the sine of MinSteepTilt is 0.48), with some room for their
/// errors. Half as much changes nothing.
constexpr double MinUp = 0.45;

/// In radians: a height function that misses known tilts by more is none. It guards against
/// surfaces that fold over within a few spacings; half and twice as much change nothing.
constexpr double MaxMissedTilt = 0.1;

/// The length, in mean plane spacings, in which places are given to the fit of a height: about as
/// far as its data reach from the middle, so that Flattening (SlopeOverSlice.cxx) is small beside
/// them. With half as much, angles grow by 15 %; with twice as much they fall by 3 to 5 %.
constexpr double SizeOfFit = 1.5;

/// A surface tilted by more than a right angle would have its outside inside the contour.
double Clamp(double tilt)
{
  constexpr double right = 1.5707963267948966;
  return std::max(-right, std::min(right, tilt));
}
}

TiltAlongContour::TiltAlongContour(const ContourRing& ring)
  : Ring(ring)
  , Total(ring.Measured.Curve.LengthTo(ring.Measured.Curve.Count()))
{
  this->SampleNodePoints();
  this->MergeEnds();
  this->FindCorners();
  this->SetSlopes();
  this->Fitted = this->Samples.size();
}

/// Lists the node points whose normal is known. Of several that are close together the one with the
/// greatest angle between its contours is taken.
void TiltAlongContour::SampleNodePoints()
{
  const ContourRing& ring = this->Ring;
  const int u = FirstAxis(ring.Axis), v = SecondAxis(ring.Axis);
  std::vector<Sample>& samples = this->Samples;
  bool corner = false; // since the last sample
  for (Index i = 0; i < ring.Measured.Curve.Count(); ++i)
  {
    corner |= ring.Measured.Curve.IsCorner(i);
    const Point3 normal = ring.KnownNormal(i);
    const std::array<float, 2>& tangent = ring.Tangents[i];
    const double weight = Dot(normal, normal);
    if (weight < MinSine * MinSine)
    {
      continue;
    }
    const double right = normal[u] * tangent[1] - normal[v] * tangent[0];
    const double tilt = std::atan2(normal[ring.Axis], right);
    const double length = ring.Measured.Curve.LengthTo(i);
    const bool isNear =
      !samples.empty() && !corner && length - samples.back().Length < MergedNodes * ring.Spacing;
    if (isNear && weight <= samples.back().Weight)
    {
      continue;
    }
    if (isNear)
    {
      samples.pop_back();
    }
    samples.push_back({ i, length, tilt, weight, 0.0 });
    corner = false;
  }
}

/// The last node point and the first one may be close together, too.
void TiltAlongContour::MergeEnds()
{
  const ContourCurve& curve = this->Ring.Measured.Curve;
  if (this->Samples.size() < 2)
  {
    return;
  }
  const Sample &last = this->Samples.back(), &first = this->Samples.front();
  bool isNear = first.Length + this->Total - last.Length < MergedNodes * this->Ring.Spacing;
  for (Index i = last.Place; isNear && i != first.Place; i = i + 1 < curve.Count() ? i + 1 : 0)
  {
    isNear = !curve.IsCorner(i);
  }
  if (isNear)
  {
    this->Samples.erase(
      first.Weight < last.Weight ? this->Samples.begin() : this->Samples.end() - 1);
  }
}

/// Files the corners of the contour with the samples before them.
void TiltAlongContour::FindCorners()
{
  const std::size_t n = this->Samples.size();
  const ContourCurve& curve = this->Ring.Measured.Curve;
  if (n == 0)
  {
    return;
  }
  // Those before the first sample come after the last one, once around.
  std::size_t next = 0;
  const Index first = this->Samples[0].Place;
  for (Index k = 0; k < curve.Count(); ++k)
  {
    const Index point = (first + k) % curve.Count();
    while (next < n && this->Samples[next].Place == point)
    {
      ++next;
    }
    if (curve.IsCorner(point))
    {
      Sample& before = this->Samples[next - 1];
      const double length = curve.LengthTo(point) - before.Length;
      const double gone = length < 0.0 ? length + this->Total : length;
      before.FirstCorner = before.CornerAfter() ? before.FirstCorner : gone;
      before.LastCorner = gone;
    }
  }
}

/// Gives each sample the slope of the parabola through it and its neighbours (Catmull and Rom).
void TiltAlongContour::SetSlopes()
{
  const std::size_t n = this->Samples.size();
  for (std::size_t i = 0; i < n && n > 2; ++i)
  {
    const Sample &p = this->Samples[i > 0 ? i - 1 : n - 1],
                 &q = this->Samples[i + 1 < n ? i + 1 : 0];
    Sample& s = this->Samples[i];
    const double before = s.Length - p.Length + (i > 0 ? 0.0 : this->Total);
    const double after = q.Length - s.Length + (i + 1 < n ? 0.0 : this->Total);
    if (!p.CornerAfter() && !s.CornerAfter() && before > 0.0 && after > 0.0)
    {
      s.Slope = ((s.Tilt - p.Tilt) / before * after + (q.Tilt - s.Tilt) / after * before) /
        (before + after);
    }
  }
}

/// The tilt between two samples with corners between them, `gone` from the first one: that of the
/// sample on the same side of all corners, and between corners of the nearer one.
double TiltAlongContour::TiltBesideCorners(
  const Sample& p, const Sample& q, double length, double gone)
{
  const double border = std::clamp(0.5 * length, p.FirstCorner, p.LastCorner);
  return gone < border ? p.Tilt : q.Tilt;
}

/// The tilt between two samples that are `length` apart, at a share of the way from 0 to 1.
double TiltAlongContour::Interpolate(const Sample& p, const Sample& q, double length, double share)
{
  const double x = share;
  if (p.CornerAfter())
  {
    return TiltBesideCorners(p, q, length, x * length);
  }
  const double y = 1.0 - x;
  const double tilt = y * y * (1.0 + 2.0 * x) * p.Tilt + x * x * (1.0 + 2.0 * y) * q.Tilt +
    length * x * y * (y * p.Slope - x * q.Slope);
  return Clamp(tilt);
}

/// The tilt that the fitted height gives a point of the ring; `other` where it gives none.
double TiltAlongContour::FittedTilt(Index point, double other) const
{
  const Point2 slope = this->Height.Slope.SlopeAt(this->Ring.Measured.Curve[point]);
  const std::array<float, 2>& tangent = this->Ring.Tangents[point];
  const double right = slope[0] * tangent[1] - slope[1] * tangent[0];
  return right > 0.0 ? this->Height.Sign * std::atan2(1.0, right) : other;
}

/// Gives the fit what is known at the points of the ring from one on: a height of zero, and the
/// slope at node points.
void TiltAlongContour::AddPart(Index first, Index count)
{
  const ContourRing& ring = this->Ring;
  const int u = FirstAxis(ring.Axis), v = SecondAxis(ring.Axis);
  const Index n = ring.Measured.Curve.Count();
  for (Index k = 0; k <= count; ++k)
  {
    const Index i = (first + k) % n;
    this->Height.Slope.AddZero(ring.Measured.Curve[i]);
    const Point3 normal = ring.KnownNormal(i);
    const double weight = Dot(normal, normal), up = this->Height.Sign * normal[ring.Axis];
    if (weight >= MinSine * MinSine && up > 0.0 && up * up >= MinUp * MinUp * weight)
    {
      this->Height.Slope.AddSlope(ring.Measured.Curve[i], { normal[u] / up, normal[v] / up });
    }
  }
}

/// Fits a height over the slice between a sample and the next one, if the surface is nearly
/// parallel to the slice there. The samples on either side of the two take part if it is so there,
/// too.
void TiltAlongContour::FitSlope(std::size_t before)
{
  const ContourCurve& curve = this->Ring.Measured.Curve;
  const std::size_t n = this->Samples.size();
  const auto at = [&](std::size_t shift) -> const Sample&
  { return this->Samples[(before + shift) % n]; };
  const Sample &o = at(n - 1), &p = at(0), &q = at(1), &r = at(2);
  Fit& fit = this->Height;
  fit.Valid = false;
  if (!curve.IsExact() || n < 3 || p.CornerAfter() ||
    std::min(std::abs(p.Tilt), std::abs(q.Tilt)) < MinSteepTilt || (p.Tilt > 0.0) != (q.Tilt > 0.0))
  {
    return;
  }
  const auto isUsed = [&](const Sample& s)
  { return std::abs(s.Tilt) >= MinSteepTilt && (s.Tilt > 0.0) == (p.Tilt > 0.0); };
  const Index total = curve.Count();
  const Index first = isUsed(o) && !o.CornerAfter() ? o.Place : p.Place;
  const Index last =
    isUsed(r) && !q.CornerAfter() && (n > 3 || first == p.Place) ? r.Place : q.Place;
  fit.Sign = p.Tilt > 0.0 ? 1.0 : -1.0;
  const Point2 &a = curve[p.Place], &b = curve[q.Place];
  fit.Slope.Start({ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) }, SizeOfFit * this->Ring.Spacing);
  this->AddPart(first, (last - first + total) % total);
  if (!fit.Slope.Fit())
  {
    return;
  }
  fit.MissedBefore = p.Tilt - this->FittedTilt(p.Place, HUGE_VAL);
  fit.MissedAfter = q.Tilt - this->FittedTilt(q.Place, HUGE_VAL);
  fit.Valid =
    std::abs(fit.MissedBefore) < MaxMissedTilt && std::abs(fit.MissedAfter) < MaxMissedTilt;
}

double TiltAlongContour::At(Index point)
{
  const std::size_t n = this->Samples.size();
  const double length = this->Ring.Measured.Curve.LengthTo(point);
  while (this->Next < n && this->Samples[this->Next].Length <= length)
  {
    ++this->Next;
  }
  if (n == 0)
  {
    return 0.0;
  }
  const std::size_t next = this->Next, before = next > 0 ? next - 1 : n - 1;
  const Sample &p = this->Samples[before], &q = this->Samples[next < n ? next : 0];
  const double gone = length - p.Length + (next > 0 ? 0.0 : this->Total);
  const double step = q.Length - p.Length + (next > 0 && next < n ? 0.0 : this->Total);
  if (n == 1 || !(step > 0.0))
  {
    return p.Tilt;
  }
  if (before != this->Fitted)
  {
    this->Fitted = before;
    this->FitSlope(before);
  }
  const double tilt = Interpolate(p, q, step, gone / step);
  if (!this->Height.Valid)
  {
    return tilt;
  }
  const double missed = this->Height.MissedBefore +
    gone / step * (this->Height.MissedAfter - this->Height.MissedBefore);
  return Clamp(this->FittedTilt(point, tilt - missed) + missed);
}
}
