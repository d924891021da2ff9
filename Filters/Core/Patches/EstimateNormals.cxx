// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/EstimateNormals.h"

#include "Core/Base/Vectors.h"
#include "Core/Crossings/NodeNormals.h"
#include "Core/Graph/ContourRings.h"
#include "Core/Patches/SliceMetric.h"
#include "Core/Patches/TiltAlongContour.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// A contour that is cut into arcs, and itself in true coordinates (SliceMetric).
struct MeasuredRing : ArcRing
{
  ContourRing Contour;
};

/// A tilt of which nothing is known is taken as 0. At a node point it says little beside that of
/// the other contour, and all if that one knows nothing either: so any weight much below 1 will do.
constexpr double WeightOfUnknownTilt = 1e-3;

class NormalEstimator
{
public:
  NormalEstimator(const CycleGeometry& geometry, double cornerAngle, const Ranks& ranks)
    : Geometry(geometry)
    , Processes(ranks)
    , Code(geometry.Grid)
    , Rings(geometry.Grid, geometry.Crossings, geometry.Nodes, geometry.Graph)
    , CornerAngle(cornerAngle)
    , ArcTangents(geometry.Graph.Count())
    , CrossingTangents(geometry.Crossings.Count())
    , NodeNormals(geometry.Nodes.Count())
    , Metrics{ SliceMetric(geometry.Grid.Metric, 0), SliceMetric(geometry.Grid.Metric, 1),
      SliceMetric(geometry.Grid.Metric, 2) }
  {
    this->Result.Normals.assign(3 * static_cast<std::size_t>(geometry.Graph.Count()), 0.0f);
    this->Result.Corners.assign(geometry.Graph.Count(), 0);
  }

  SurfaceNormals Run(const std::vector<double>& loopTilts, const Execution& execution);

private:
  /// The tangent at a point, of unit length, as floats: as many as there are contour points.
  using Tangent = std::array<float, 2>;

  /// The contours of an axis.
  struct AxisRings
  {
    std::vector<Index> Starts;            ///< one crossing of each
    std::vector<std::size_t> FirstOfRank; ///< and their number; see DivideWork
  };

  std::array<AxisRings, 3> FindRings() const;
  template <typename Value, typename Access>
  void ExchangeAlong(const AxisRings& rings, bool nodesOnly, Access&& valueAt);
  void ExchangeTangents(const std::array<AxisRings, 3>& rings);
  void SetRing(Index start, MeasuredRing& ring) const;
  void FindTangents(const MeasuredRing& ring);
  void LookUp(MeasuredRing& ring) const;
  Point3 NodeNormal(Index node) const;
  Point3 TangentInSpace(Index crossing, int axis) const;
  std::array<float, 3> TrueNormal(Index node, int axis) const;
  void WriteNormals(const MeasuredRing& ring);
  void WriteLoop(Index loop, double tilt);

  const CycleGeometry& Geometry;
  const Ranks& Processes;
  GridEdgeCode Code;
  ContourRings Rings;
  double CornerAngle;
  std::vector<Tangent> ArcTangents;
  std::vector<Tangent> CrossingTangents;
  std::vector<std::array<float, 3>> NodeNormals; ///< as long as the sine of the contours' angle
  std::array<SliceMetric, 3> Metrics;            ///< of the slices across each axis
  SurfaceNormals Result;
};

std::array<NormalEstimator::AxisRings, 3> NormalEstimator::FindRings() const
{
  std::array<AxisRings, 3> rings;
  std::array<std::vector<Index>, 3> starts = this->Rings.FindStarts();
  ArcRing ring;
  for (int axis = 0; axis < 3; ++axis)
  {
    AxisRings& ofAxis = rings[axis];
    ofAxis.Starts = std::move(starts[axis]);
    std::vector<double> work(ofAxis.Starts.size(), 0.0);
    for (std::size_t i = 0; i < work.size() && this->Processes.AreSeveral(); ++i)
    {
      this->Rings.List(ofAxis.Starts[i], ring);
      work[i] = static_cast<double>(ring.Points.size());
    }
    ofAxis.FirstOfRank =
      DivideWork(this->Processes.Count, work.size(), [&](std::size_t i) { return work[i]; });
  }
  return rings;
}

/// Gives all processes what each has found along its contours. `valueAt(point, crossing)` is the
/// place of a value; with `nodesOnly`, there are values at crossings only.
template <typename Value, typename Access>
void NormalEstimator::ExchangeAlong(const AxisRings& rings, bool nodesOnly, Access&& valueAt)
{
  if (!this->Processes.AreSeveral())
  {
    return;
  }
  ArcRing ring;
  const auto forValues = [&](int rank, auto&& visit)
  {
    for (std::size_t i = rings.FirstOfRank[rank]; i < rings.FirstOfRank[rank + 1]; ++i)
    {
      this->Rings.List(rings.Starts[i], ring);
      for (std::size_t k = 0; k < ring.Points.size(); ++k)
      {
        if (!nodesOnly || ring.Crossing[k] != GridCrossings::None)
        {
          visit(valueAt(ring.Points[k], ring.Crossing[k]));
        }
      }
    }
  };
  std::vector<Value> own;
  forValues(this->Processes.Rank, [&](Value* value) { own.push_back(*value); });
  const auto all = GatherValues(this->Processes, own);
  for (int rank = 0; rank < this->Processes.Count; ++rank)
  {
    auto next = all[rank].begin();
    forValues(rank, [&](Value* value) { *value = *next++; });
  }
}

/// What all processes have to know before the normals at node points: tangents there, and corners.
void NormalEstimator::ExchangeTangents(const std::array<AxisRings, 3>& rings)
{
  if (!this->Processes.AreSeveral())
  {
    return;
  }
  for (const AxisRings& ofAxis : rings)
  {
    this->ExchangeAlong<Tangent>(
      ofAxis, true, [&](Index, Index crossing) { return &this->CrossingTangents[crossing]; });
  }
  std::vector<std::uint8_t>& corners = this->Result.Corners;
  std::vector<Index> own;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (corners[i] != 0)
    {
      own.push_back(static_cast<Index>(i));
    }
  }
  for (const std::vector<Index>& marked : GatherValues(this->Processes, own))
  {
    std::for_each(marked.begin(), marked.end(), [&](Index point) { corners[point] = 1; });
  }
}

/// Reads the points of a contour from a crossing on, and measures its noise and its corners.
void NormalEstimator::SetRing(Index start, MeasuredRing& ring) const
{
  const NodeGraph& graph = this->Geometry.Graph;
  ContourRing& contour = ring.Contour;
  contour.Axis = this->Rings.AxisOf(start);
  const SliceMetric& metric = this->Metrics[contour.Axis];
  contour.Spacing = MeanSpacingInSlices(this->Geometry.Grid, contour.Axis);
  this->Rings.List(start, ring);
  std::vector<Point2> points(ring.Points.size());
  std::transform(ring.Points.begin(), ring.Points.end(), points.begin(),
    [&](Index point) -> Point2 { return metric.ToTrue(graph.PointAt(point)); });
  contour.Measured.Set(std::move(points), contour.Spacing, this->CornerAngle);
}

/// Fits the tangents of a contour, and marks its corners.
void NormalEstimator::FindTangents(const MeasuredRing& ring)
{
  const MeasuredCurve& measured = ring.Contour.Measured;
  for (Index i = 0; i < measured.Curve.Count(); ++i)
  {
    const Point2 fitted = measured.Curve.FitAt(i, measured.Window).Tangent;
    Tangent& tangent = ring.Crossing[i] == GridCrossings::None
      ? this->ArcTangents[ring.Points[i]]
      : this->CrossingTangents[ring.Crossing[i]];
    tangent = { static_cast<float>(fitted[0]), static_cast<float>(fitted[1]) };
    if (measured.Curve.IsCorner(i))
    {
      this->Result.Corners[ring.Points[i]] = 1;
    }
  }
}

/// Copies what is known of the tangents and normals along a contour.
void NormalEstimator::LookUp(MeasuredRing& ring) const
{
  const std::size_t n = ring.Points.size();
  ring.Contour.Tangents.resize(n);
  ring.Contour.KnownNormals.resize(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Index crossing = ring.Crossing[i];
    const bool isNode = crossing != GridCrossings::None;
    ring.Contour.Tangents[i] =
      isNode ? this->CrossingTangents[crossing] : this->ArcTangents[ring.Points[i]];
    ring.Contour.KnownNormals[i] = isNode ? this->TrueNormal(ring.Points[i], ring.Contour.Axis)
                                          : std::array<float, 3>{ 0.0f, 0.0f, 0.0f };
  }
}

/// The fitted tangent of a crossing's contour, in a slice across `axis`.
Point3 NormalEstimator::TangentInSpace(Index crossing, int axis) const
{
  const Tangent& tangent = this->CrossingTangents[crossing];
  return this->Metrics[axis].ToAxes(tangent[0], tangent[1]);
}

/// The normal at a node point in true coordinates of the slices across an axis.
std::array<float, 3> NormalEstimator::TrueNormal(Index node, int axis) const
{
  const std::array<float, 3>& normal = this->NodeNormals[node];
  const Point3 known = this->Metrics[axis].NormalToTrue({ normal[0], normal[1], normal[2] });
  return { static_cast<float>(known[0]), static_cast<float>(known[1]),
    static_cast<float>(known[2]) };
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
  const Point3 normal = OutwardNormal(this->TangentInSpace(first, FirstAxis(t)), FirstAxis(t),
    this->TangentInSpace(second, SecondAxis(t)), SecondAxis(t));
  const AxisFrame& metric = this->Geometry.Grid.Metric;
  // In the world, it is as long as the sine of the angle between the tangents.
  return metric.IsWorld() ? normal : metric.Volume() * normal;
}

/// Writes the normals of a contour, or adds them at node points, which two contours have in common.
void NormalEstimator::WriteNormals(const MeasuredRing& ring)
{
  const ContourRing& contour = ring.Contour;
  const int u = FirstAxis(contour.Axis), v = SecondAxis(contour.Axis);
  const SliceMetric& metric = this->Metrics[contour.Axis];
  TiltAlongContour tiltAlong(contour);
  for (Index i = 0; i < contour.Measured.Curve.Count(); ++i)
  {
    const double tilt = tiltAlong.At(i);
    const Tangent& tangent = contour.Tangents[i];
    Point3 normal;
    normal[u] = std::cos(tilt) * tangent[1];
    normal[v] = -std::cos(tilt) * tangent[0];
    normal[contour.Axis] = std::sin(tilt);
    normal = metric.NormalToAxes(normal);
    float* out = this->Result.Normals.data() + 3 * static_cast<std::size_t>(ring.Points[i]);
    if (ring.Crossing[i] == GridCrossings::None)
    {
      std::copy(normal.begin(), normal.end(), out);
      continue;
    }
    const Point3 own = contour.KnownNormal(i);
    const bool known = Dot(own, own) >= MinSine * MinSine;
    const Point3 given = metric.NormalToAxes(own);
    const double share = tiltAlong.IsKnown() ? 1.0 : WeightOfUnknownTilt;
    for (int k = 0; k < 3; ++k)
    {
      out[k] = static_cast<float>(known ? given[k] : out[k] + share * normal[k]);
    }
  }
}

/// Writes the normals of a contour without node points; `tilt` is their component across its slice.
void NormalEstimator::WriteLoop(Index loop, double tilt)
{
  const NodeGraph& graph = this->Geometry.Graph;
  const int axis = graph.Loops[loop].Axis;
  const SliceMetric& metric = this->Metrics[axis];
  const Index first = graph.FirstPoint(graph.Arcs + loop), n = graph.PointCount(graph.Arcs + loop);
  for (Index i = 0; i < n; ++i)
  {
    const Point2 before = metric.ToTrue(graph.PointAt(first + (i + n - 1) % n));
    const Point2 after = metric.ToTrue(graph.PointAt(first + (i + 1) % n));
    Point3 along{ 0.0, 0.0, 0.0 };
    along[FirstAxis(axis)] = after[0] - before[0];
    along[SecondAxis(axis)] = after[1] - before[1];
    Point3 normal = std::sqrt(1.0 - tilt * tilt) * Unit(RightOf(along, axis));
    normal[axis] = tilt;
    normal = metric.NormalToAxes(normal);
    std::copy(normal.begin(), normal.end(),
      this->Result.Normals.begin() + 3 * static_cast<std::size_t>(first + i));
  }
}

SurfaceNormals NormalEstimator::Run(
  const std::vector<double>& loopTilts, const Execution& execution)
{
  const std::array<AxisRings, 3> rings = this->FindRings();
  // Contours of one axis have no points in common.
  const auto forRings = [&](const AxisRings& ofAxis, auto&& visit)
  {
    const std::size_t first = ofAxis.FirstOfRank[this->Processes.Rank];
    execution.For(ofAxis.FirstOfRank[this->Processes.Rank + 1] - first,
      [&](std::size_t begin, std::size_t end)
      {
        MeasuredRing ring;
        for (std::size_t i = first + begin; i < first + end; ++i)
        {
          this->SetRing(ofAxis.Starts[i], ring);
          visit(ring);
        }
      });
  };
  for (const AxisRings& ofAxis : rings)
  {
    forRings(ofAxis, [this](const MeasuredRing& ring) { this->FindTangents(ring); });
  }
  this->ExchangeTangents(rings);
  execution.For(this->NodeNormals.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t node = begin; node < end; ++node)
      {
        const Point3 normal = this->NodeNormal(static_cast<Index>(node));
        std::copy(normal.begin(), normal.end(), this->NodeNormals[node].begin());
      }
    });
  for (const AxisRings& ofAxis : rings)
  {
    forRings(ofAxis,
      [this](MeasuredRing& ring)
      {
        this->LookUp(ring);
        this->WriteNormals(ring);
      });
    using Normal = std::array<float, 3>;
    this->ExchangeAlong<Normal>(ofAxis, false,
      [&](Index point, Index)
      { return reinterpret_cast<Normal*>(this->Result.Normals.data() + 3 * std::size_t(point)); });
  }
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
  const std::vector<double>& loopTilts, const Execution& execution, const Ranks& ranks)
{
  return NormalEstimator(geometry, cornerAngle, ranks).Run(loopTilts, execution);
}
}
