// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/EstimateNormals.h"

#include "Core/Base/Vectors.h"
#include "Core/Crossings/NodeNormals.h"
#include "Core/Patches/SlopeOverSlice.h"
#include "Core/Slices/ContourCurve.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Node points closer than this along a contour, as a part of the mean plane spacing, count as one.
constexpr double MergedNodes = 0.2;

/// Sine of the angle between the contours of a node point below which they give no normal.
constexpr double MinSine = 0.15;

/// Tilt (radians) beyond which the slope over the slice is interpolated instead.
constexpr double MinSteepTilt = 0.5;

/// Component across the slice of the unit normals from which the slope over the slice is known.
constexpr double MinUp = 0.45;

/// The points of a contour in G, in order from a crossing.
struct ContourRing
{
  int Axis = 0;
  double Spacing = 0.0; ///< the lesser mean spacing of the planes across the contour
  std::vector<Index> Points;
  std::vector<Index> Crossing; ///< of each point, or None
  MeasuredCurve Measured;
};

/// What is known of the tilt at a place on a contour.
struct TiltSample
{
  Index Place;   ///< point of the ring
  double Length; ///< along the contour
  double Tilt;
  double Weight;
  double Slope;
  bool CornerAfter; ///< between this sample and the next
};

/// The slope over the slice between two samples, and by how much it misses their tilts.
struct SlopeFit
{
  SlopeOverSlice Slope;
  bool Valid = false;
  double Sign = 1.0; ///< of the tilt
  double MissedBefore = 0.0, MissedAfter = 0.0;
};

class NormalEstimator
{
public:
  NormalEstimator(const CycleGeometry& geometry, double cornerAngle)
    : Geometry(geometry)
    , Code(geometry.Grid)
    , CornerAngle(cornerAngle)
    , ArcTangents(geometry.Graph.Count())
    , CrossingTangents(geometry.Crossings.Count())
    , NodeNormals(geometry.Nodes.Count())
  {
    this->Result.Normals.assign(3 * static_cast<std::size_t>(geometry.Graph.Count()), 0.0f);
    this->Result.Corners.assign(geometry.Graph.Count(), 0);
  }

  SurfaceNormals Run(const std::vector<double>& loopTilts, const Execution& execution);

  std::vector<TiltSample> SampleTilt(const ContourRing& ring);
  void FitSlope(const ContourRing& ring, const std::vector<TiltSample>& samples, std::size_t before,
    SlopeFit& fit);
  double FittedTilt(const ContourRing& ring, Index i, const SlopeFit& fit, double other);

private:
  /// The tangent at a point, of unit length, as floats: as many as there are contour points.
  using Tangent = std::array<float, 2>;

  std::array<std::vector<Index>, 3> FindRings() const;
  int AxisOf(Index crossing) const;
  void SetRing(Index start, ContourRing& ring) const;
  Tangent& TangentAt(const ContourRing& ring, Index i)
  {
    return ring.Crossing[i] == GridCrossings::None ? this->ArcTangents[ring.Points[i]]
                                                   : this->CrossingTangents[ring.Crossing[i]];
  }
  void FindTangents(ContourRing& ring);
  Point3 NodeNormal(Index node) const;
  Point3 NodeNormalAt(Index node) const
  {
    const std::array<float, 3>& n = this->NodeNormals[node];
    return { n[0], n[1], n[2] };
  }
  Point3 ContourTangent(Index crossing, int axis) const;
  static void SetSlopes(double total, std::vector<TiltSample>& samples);
  void AddPart(const ContourRing& ring, Index first, Index count, SlopeFit& fit);
  void WriteNormals(const ContourRing& ring);
  void WriteLoop(Index loop, double tilt);

  const CycleGeometry& Geometry;
  GridEdgeCode Code;
  double CornerAngle;
  std::vector<Tangent> ArcTangents;
  std::vector<Tangent> CrossingTangents;
  std::vector<std::array<float, 3>> NodeNormals; ///< as long as the sine of the contours' angle
  SurfaceNormals Result;
};

/// Of the slice of a crossing's contour.
int NormalEstimator::AxisOf(Index crossing) const
{
  const int direction = this->Code.Decode(this->Geometry.Crossings.Edge[crossing]).Direction;
  return this->Geometry.Crossings.Family[crossing] == 0 ? FirstAxis(direction)
                                                        : SecondAxis(direction);
}

/// One crossing of each contour, by the axis of its slice: always the same one, however contours are
/// numbered.
std::array<std::vector<Index>, 3> NormalEstimator::FindRings() const
{
  const GridCrossings& crossings = this->Geometry.Crossings;
  std::array<std::vector<Index>, 3> starts;
  std::vector<std::uint8_t> seen(crossings.Count(), 0);
  for (Index start = 0; start < crossings.Count(); ++start)
  {
    if (seen[start] != 0 || crossings.IsRemoved(start))
    {
      continue;
    }
    Index minimum = start;
    for (Index c = start; seen[c] == 0; c = crossings.Next[c])
    {
      seen[c] = 1;
      const bool isLess = crossings.Edge[c] != crossings.Edge[minimum]
        ? crossings.Edge[c] < crossings.Edge[minimum]
        : crossings.Position[c] < crossings.Position[minimum];
      minimum = isLess ? c : minimum;
    }
    starts[this->AxisOf(start)].push_back(minimum);
  }
  return starts;
}

void NormalEstimator::SetRing(Index start, ContourRing& ring) const
{
  const NodeGraph& graph = this->Geometry.Graph;
  const GridCrossings& crossings = this->Geometry.Crossings;
  ring.Axis = this->AxisOf(start);
  const int u = FirstAxis(ring.Axis), v = SecondAxis(ring.Axis);
  ring.Spacing = MeanSpacingInSlices(this->Geometry.Grid, ring.Axis);
  ring.Points.clear();
  ring.Crossing.clear();
  Index c = start;
  do
  {
    ring.Points.push_back(this->Geometry.Nodes.NodeOf[c]);
    ring.Crossing.push_back(c);
    for (Index i = 0; i < graph.PointCount(c); ++i)
    {
      ring.Points.push_back(graph.FirstPoint(c) + i);
      ring.Crossing.push_back(GridCrossings::None);
    }
    c = crossings.Next[c];
  } while (c != start);
  std::vector<Point2> points(ring.Points.size());
  std::transform(ring.Points.begin(), ring.Points.end(), points.begin(),
    [&](Index point) -> Point2
    {
      const Point3 p = graph.PointAt(point);
      return { p[u], p[v] };
    });
  ring.Measured.Set(std::move(points), ring.Spacing, this->CornerAngle);
}

void NormalEstimator::FindTangents(ContourRing& ring)
{
  for (Index i = 0; i < ring.Measured.Curve.Count(); ++i)
  {
    const Point2 tangent = ring.Measured.Curve.FitAt(i, ring.Measured.Window).Tangent;
    this->TangentAt(ring, i) = { static_cast<float>(tangent[0]), static_cast<float>(tangent[1]) };
    if (ring.Measured.Curve.IsCorner(i))
    {
      this->Result.Corners[ring.Points[i]] = 1;
    }
  }
}

Point3 NormalEstimator::ContourTangent(Index crossing, int axis) const
{
  Point3 tangent{ 0.0, 0.0, 0.0 };
  tangent[FirstAxis(axis)] = this->CrossingTangents[crossing][0];
  tangent[SecondAxis(axis)] = this->CrossingTangents[crossing][1];
  return tangent;
}

/// From the tangents of both contours; zero where they contradict each other or one has a corner.
Point3 NormalEstimator::NodeNormal(Index node) const
{
  if (this->Result.Corners[node] != 0)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const Index first = this->Geometry.Nodes.First[node];
  const Index second = this->Geometry.Nodes.Second[node];
  const int t = this->Code.Decode(this->Geometry.Crossings.Edge[first]).Direction;
  return OutwardNormal(this->ContourTangent(first, FirstAxis(t)), FirstAxis(t),
    this->ContourTangent(second, SecondAxis(t)), SecondAxis(t));
}

/// The tilt at the node points, with slopes.
std::vector<TiltSample> NormalEstimator::SampleTilt(const ContourRing& ring)
{
  const int u = FirstAxis(ring.Axis), v = SecondAxis(ring.Axis);
  std::vector<TiltSample> samples;
  bool corner = false; // since the last sample
  bool firstCorner = false;
  for (Index i = 0; i < ring.Measured.Curve.Count(); ++i)
  {
    corner |= ring.Measured.Curve.IsCorner(i);
    if (ring.Crossing[i] == GridCrossings::None)
    {
      continue;
    }
    const Point3 normal = this->NodeNormalAt(ring.Points[i]);
    const Tangent& tangent = this->TangentAt(ring, i);
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
      corner = samples.size() > 1 ? samples[samples.size() - 2].CornerAfter : firstCorner;
      samples.pop_back();
    }
    if (!samples.empty())
    {
      samples.back().CornerAfter = corner;
    }
    else
    {
      firstCorner = corner;
    }
    samples.push_back({ i, length, tilt, weight, 0.0, false });
    corner = false;
  }
  if (!samples.empty())
  {
    samples.back().CornerAfter = corner || firstCorner;
  }
  SetSlopes(ring.Measured.Curve.LengthTo(ring.Measured.Curve.Count()), samples);
  return samples;
}

/// Those of the parabolas through a sample and its neighbours (Catmull and Rom).
void NormalEstimator::SetSlopes(double total, std::vector<TiltSample>& samples)
{
  const std::size_t n = samples.size();
  for (std::size_t i = 0; i < n && n > 2; ++i)
  {
    const TiltSample &p = samples[i > 0 ? i - 1 : n - 1], &q = samples[i + 1 < n ? i + 1 : 0];
    TiltSample& s = samples[i];
    const double before = s.Length - p.Length + (i > 0 ? 0.0 : total);
    const double after = q.Length - s.Length + (i + 1 < n ? 0.0 : total);
    if (!p.CornerAfter && !s.CornerAfter && before > 0.0 && after > 0.0)
    {
      s.Slope = ((s.Tilt - p.Tilt) / before * after + (q.Tilt - s.Tilt) / after * before) /
        (before + after);
    }
  }
}

/// A surface tilted by more than a right angle would have its outside inside the contour.
double Clamp(double tilt)
{
  constexpr double right = 1.5707963267948966;
  return std::max(-right, std::min(right, tilt));
}

/// The tilt between two samples, `x` of the way of this length along.
double InterpolateTilt(const TiltSample& p, const TiltSample& q, double length, double x)
{
  if (p.CornerAfter)
  {
    return x < 0.5 ? p.Tilt : q.Tilt;
  }
  const double y = 1.0 - x;
  const double tilt = y * y * (1.0 + 2.0 * x) * p.Tilt + x * x * (1.0 + 2.0 * y) * q.Tilt +
    length * x * y * (y * p.Slope - x * q.Slope);
  return Clamp(tilt);
}

/// The tilt that the slope of the height gives a point of a ring; `other` where it gives none.
double NormalEstimator::FittedTilt(
  const ContourRing& ring, Index i, const SlopeFit& fit, double other)
{
  const Point2 slope = fit.Slope.SlopeAt(ring.Measured.Curve[i]);
  const Tangent& tangent = this->TangentAt(ring, i);
  const double right = slope[0] * tangent[1] - slope[1] * tangent[0];
  return right > 0.0 ? fit.Sign * std::atan2(1.0, right) : other;
}

/// Adds the points of a ring from one sample to another.
void NormalEstimator::AddPart(const ContourRing& ring, Index first, Index count, SlopeFit& fit)
{
  const int u = FirstAxis(ring.Axis), v = SecondAxis(ring.Axis);
  const Index n = ring.Measured.Curve.Count();
  for (Index k = 0; k <= count; ++k)
  {
    const Index i = (first + k) % n;
    fit.Slope.AddZero(ring.Measured.Curve[i]);
    if (ring.Crossing[i] == GridCrossings::None)
    {
      continue;
    }
    const Point3 normal = this->NodeNormalAt(ring.Points[i]);
    const double weight = Dot(normal, normal), up = fit.Sign * normal[ring.Axis];
    if (weight >= MinSine * MinSine && up > 0.0 && up * up >= MinUp * MinUp * weight)
    {
      fit.Slope.AddSlope(ring.Measured.Curve[i], { normal[u] / up, normal[v] / up });
    }
  }
}

/// The slope of the surface between a sample and the next one, if the surface is nearly parallel to
/// the slice there.
void NormalEstimator::FitSlope(const ContourRing& ring, const std::vector<TiltSample>& samples,
  std::size_t before, SlopeFit& fit)
{
  // In radians: a height function that misses known normals by more is none.
  constexpr double maxMissed = 0.1;
  const std::size_t n = samples.size();
  const auto at = [&](std::size_t shift) -> const TiltSample&
  { return samples[(before + shift) % n]; };
  const TiltSample &o = at(n - 1), &p = at(0), &q = at(1), &r = at(2);
  fit.Valid = false;
  if (!ring.Measured.Curve.IsExact() || n < 3 || p.CornerAfter ||
    std::min(std::abs(p.Tilt), std::abs(q.Tilt)) < MinSteepTilt || (p.Tilt > 0.0) != (q.Tilt > 0.0))
  {
    return;
  }
  const auto isUsed = [&](const TiltSample& s)
  { return std::abs(s.Tilt) >= MinSteepTilt && (s.Tilt > 0.0) == (p.Tilt > 0.0); };
  const Index total = ring.Measured.Curve.Count();
  const Index first = isUsed(o) && !o.CornerAfter ? o.Place : p.Place;
  const Index last = isUsed(r) && !q.CornerAfter && (n > 3 || first == p.Place) ? r.Place : q.Place;
  fit.Sign = p.Tilt > 0.0 ? 1.0 : -1.0;
  const Point2 &a = ring.Measured.Curve[p.Place], &b = ring.Measured.Curve[q.Place];
  fit.Slope.Start({ 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) }, 1.5 * ring.Spacing);
  this->AddPart(ring, first, (last - first + total) % total, fit);
  if (!fit.Slope.Fit())
  {
    return;
  }
  fit.MissedBefore = p.Tilt - this->FittedTilt(ring, p.Place, fit, HUGE_VAL);
  fit.MissedAfter = q.Tilt - this->FittedTilt(ring, q.Place, fit, HUGE_VAL);
  fit.Valid = std::abs(fit.MissedBefore) < maxMissed && std::abs(fit.MissedAfter) < maxMissed;
}

/// Goes along a ring and tells the tilt at each point.
class TiltWalk
{
public:
  TiltWalk(NormalEstimator& estimator, const ContourRing& ring)
    : Estimator(estimator)
    , Ring(ring)
    , Samples(estimator.SampleTilt(ring))
    , Total(ring.Measured.Curve.LengthTo(ring.Measured.Curve.Count()))
    , Fitted(this->Samples.size())
  {
  }

  bool KnowsTilt() const { return !this->Samples.empty(); }
  /// At the next point, i, which is after the last one. 0 if nothing is known.
  double TiltAt(Index i);

private:
  NormalEstimator& Estimator;
  const ContourRing& Ring;
  std::vector<TiltSample> Samples;
  double Total;
  std::size_t Next = 0;
  std::size_t Fitted; ///< the sample before the points that the fit is for
  SlopeFit Fit;
};

double TiltWalk::TiltAt(Index i)
{
  const std::size_t n = this->Samples.size();
  const double length = this->Ring.Measured.Curve.LengthTo(i);
  while (this->Next < n && this->Samples[this->Next].Length <= length)
  {
    ++this->Next;
  }
  if (n == 0)
  {
    return 0.0;
  }
  const std::size_t next = this->Next, before = next > 0 ? next - 1 : n - 1;
  const TiltSample &p = this->Samples[before], &q = this->Samples[next < n ? next : 0];
  const double gone = length - p.Length + (next > 0 ? 0.0 : this->Total);
  const double step = q.Length - p.Length + (next > 0 && next < n ? 0.0 : this->Total);
  if (n == 1 || !(step > 0.0))
  {
    return p.Tilt;
  }
  if (before != this->Fitted)
  {
    this->Fitted = before;
    this->Estimator.FitSlope(this->Ring, this->Samples, before, this->Fit);
  }
  const double tilt = InterpolateTilt(p, q, step, gone / step);
  if (!this->Fit.Valid)
  {
    return tilt;
  }
  const double missed =
    this->Fit.MissedBefore + gone / step * (this->Fit.MissedAfter - this->Fit.MissedBefore);
  return Clamp(this->Estimator.FittedTilt(this->Ring, i, this->Fit, tilt - missed) + missed);
}

void NormalEstimator::WriteNormals(const ContourRing& ring)
{
  const int u = FirstAxis(ring.Axis), v = SecondAxis(ring.Axis);
  TiltWalk walk(*this, ring);
  for (Index i = 0; i < ring.Measured.Curve.Count(); ++i)
  {
    const double tilt = walk.TiltAt(i);
    const Tangent& tangent = this->TangentAt(ring, i);
    Point3 normal;
    normal[u] = std::cos(tilt) * tangent[1];
    normal[v] = -std::cos(tilt) * tangent[0];
    normal[ring.Axis] = std::sin(tilt);
    float* out = this->Result.Normals.data() + 3 * static_cast<std::size_t>(ring.Points[i]);
    if (ring.Crossing[i] == GridCrossings::None)
    {
      std::copy(normal.begin(), normal.end(), out);
    }
    else
    {
      // Of both contours of a node point, whose own normal says nothing. One of which nothing is
      // known hardly counts.
      const double share = walk.KnowsTilt() ? 1.0 : 1e-3;
      const Point3 own = this->NodeNormalAt(ring.Points[i]);
      const bool known = Dot(own, own) >= MinSine * MinSine;
      for (int k = 0; k < 3; ++k)
      {
        out[k] = static_cast<float>(known ? own[k] : out[k] + share * normal[k]);
      }
    }
  }
}

void NormalEstimator::WriteLoop(Index loop, double tilt)
{
  const NodeGraph& graph = this->Geometry.Graph;
  const int axis = graph.Loops[loop].Axis;
  const Index first = graph.FirstPoint(graph.Arcs + loop), n = graph.PointCount(graph.Arcs + loop);
  for (Index i = 0; i < n; ++i)
  {
    const Point3 along =
      graph.PointAt(first + (i + 1) % n) - graph.PointAt(first + (i + n - 1) % n);
    Point3 normal = std::sqrt(1.0 - tilt * tilt) * Unit(RightOf(along, axis));
    normal[axis] = tilt;
    std::copy(normal.begin(), normal.end(),
      this->Result.Normals.begin() + 3 * static_cast<std::size_t>(first + i));
  }
}

SurfaceNormals NormalEstimator::Run(
  const std::vector<double>& loopTilts, const Execution& execution)
{
  const std::array<std::vector<Index>, 3> starts = this->FindRings();
  // Contours of one axis have no points in common.
  const auto forRings = [&](auto&& visit)
  {
    for (const std::vector<Index>& ofAxis : starts)
    {
      execution.For(ofAxis.size(),
        [&](std::size_t begin, std::size_t end)
        {
          ContourRing ring;
          for (std::size_t i = begin; i < end; ++i)
          {
            this->SetRing(ofAxis[i], ring);
            visit(ring);
          }
        });
    }
  };
  forRings([this](ContourRing& ring) { this->FindTangents(ring); });
  execution.For(this->NodeNormals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t node = begin; node < end; ++node)
      {
        const Point3 normal = this->NodeNormal(static_cast<Index>(node));
        std::copy(normal.begin(), normal.end(), this->NodeNormals[node].begin());
      }
    });
  forRings([this](ContourRing& ring) { this->WriteNormals(ring); });
  for (std::size_t loop = 0; loop < this->Geometry.Graph.Loops.size(); ++loop)
  {
    this->WriteLoop(static_cast<Index>(loop), loopTilts.empty() ? 0.0 : loopTilts[loop]);
  }
  execution.For(this->Geometry.Graph.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      for (float* n = this->Result.Normals.data() + 3 * begin;
           n != this->Result.Normals.data() + 3 * end; n += 3)
      {
        const Point3 unit = Unit({ n[0], n[1], n[2] });
        std::copy(unit.begin(), unit.end(), n);
      }
    });
  const auto& corners = this->Result.Corners;
  if (std::none_of(corners.begin(), corners.end(), [](std::uint8_t c) { return c != 0; }))
  {
    this->Result.Corners.clear();
  }
  return std::move(this->Result);
}
}

SurfaceNormals EstimateNormals(const CycleGeometry& geometry, double cornerAngle,
  const std::vector<double>& loopTilts, const Execution& execution)
{
  return NormalEstimator(geometry, cornerAngle).Run(loopTilts, execution);
}
}
