// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/CentralPoints.h"

#include "Core/Base/QuadraticFit.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The greatest height of a dome over a loop, as a part of the cell's width. The slices only say
/// that the surface ends within the cell: the expected height of a top that may be anywhere in it.
constexpr double MaxDome = 0.5;

/// The greatest height of a central point over the centroid, in mean radii of the polygon. That of
/// a hemisphere over its rim is 1: a quadratic that is higher has left the data.
constexpr double MaxHeight = 1.0;

/// Finds the central point of one spatial polygon.
class PolygonCenter
{
public:
  PolygonCenter(const NodeGraph& graph, const std::vector<double>& nodeNormals)
    : Graph(graph)
    , NodeNormals(nodeNormals)
  {
  }

  /// Scratch memory for GetBoundary, reused from polygon to polygon.
  std::vector<Index> Boundary, NodePlaces;

  Point3 Centroid();
  Point3 LeastSquares();
  Point3 Dome(int axis, double maximum);

private:
  Point3 MeanNormal() const;
  Point3 NormalAt(Index node) const
  {
    const double* n = this->NodeNormals.data() + 3 * static_cast<std::size_t>(node);
    return { n[0], n[1], n[2] };
  }

  const NodeGraph& Graph;
  const std::vector<double>& NodeNormals;
  std::vector<Point3> Points;
  std::vector<double> Weights; ///< length of boundary that each point stands for
};

Point3 PolygonCenter::Centroid()
{
  const std::size_t n = this->Boundary.size();
  this->Points.resize(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    this->Points[i] = this->Graph.PointAt(this->Boundary[i]);
  }
  return WeighByLength(this->Points, this->Weights);
}

/**
 * The top of a dome over a loop, towards +axis or, if `maximum` is negative, -axis: as high as the
 * loop is wide, as if the surface was round, but not higher than |maximum|.
 */
Point3 PolygonCenter::Dome(int axis, double maximum)
{
  Point3 apex = this->Centroid();
  double radius2 = 0.0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const Point3 d = this->Points[i] - apex;
    radius2 += this->Weights[i] * Dot(d, d);
  }
  apex[axis] += std::copysign(std::min(std::sqrt(radius2), std::abs(maximum)), maximum);
  return apex;
}

/// Unit normal of the plane that the heights refer to; zero if there is none.
Point3 PolygonCenter::MeanNormal() const
{
  Point3 mean{ 0.0, 0.0, 0.0 };
  for (const Index place : this->NodePlaces)
  {
    mean = mean + NormalAt(this->Boundary[place]);
  }
  Point3 area{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const std::size_t j = i + 1 < this->Points.size() ? i + 1 : 0;
    area = area + Cross(this->Points[i] - this->Points[0], this->Points[j] - this->Points[0]);
  }
  const double meanLength = Length(mean);
  const double areaLength = Length(area);
  if (areaLength > 0.0)
  {
    mean = (meanLength > 0.0 ? 1.0 / meanLength : 0.0) * mean + (1.0 / areaLength) * area;
  }
  const double length = Length(mean);
  return length > 0.0 ? (1.0 / length) * mean : Point3{ 0.0, 0.0, 0.0 };
}

Point3 PolygonCenter::LeastSquares()
{
  const Point3 centroid = this->Centroid();
  const Point3 normal = this->MeanNormal();
  double radius2 = 0.0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const Point3 d = this->Points[i] - centroid;
    radius2 += this->Weights[i] * Dot(d, d);
  }
  const double radius = std::sqrt(radius2);
  if (!(radius > 0.0) || Dot(normal, normal) == 0.0)
  {
    return centroid;
  }
  const std::array<Point3, 3> frame = CompleteFrame(normal);
  QuadraticFit fit;
  const auto local = [&](const Point3& d) -> Point3 {
    return { Dot(d, frame[0]), Dot(d, frame[1]), Dot(d, frame[2]) };
  };
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const Point3 p = local((1.0 / radius) * (this->Points[i] - centroid));
    fit.AddPoint(p[0], p[1], p[2], this->Weights[i]);
  }
  for (const Index place : this->NodePlaces)
  {
    const Point3 p = local((1.0 / radius) * (this->Points[place] - centroid));
    const Point3 n = local(NormalAt(this->Boundary[place]));
    fit.AddNormal(p[0], p[1], n, 1.0 / this->NodePlaces.size());
  }
  const double height = fit.HeightAtOrigin();
  return std::abs(height) < MaxHeight ? centroid + (height * radius) * normal : centroid;
}
}

std::vector<double> LocateCentralPoints(CentralPointMethod method, const CycleGeometry& geometry,
  const std::vector<double>& nodeNormals, const Execution& execution, const Ranks& ranks)
{
  const SpatialGrid& grid = geometry.Grid;
  const NodeGraph& graph = geometry.Graph;
  const CellCycles& cycles = geometry.Cycles;
  std::vector<double> centers(3 * static_cast<std::size_t>(cycles.Count()));
  const Portion own = PortionOf(ranks, static_cast<std::size_t>(cycles.Count()),
    [&](std::size_t cycle) { return cycles.Size(static_cast<Index>(cycle)) + 1.0; });
  execution.For(own.Last - own.First,
    [&](std::size_t begin, std::size_t end)
    {
      PolygonCenter polygon(graph, nodeNormals);
      for (std::size_t cycle = own.First + begin; cycle < own.First + end; ++cycle)
      {
        const Index c = static_cast<Index>(cycle);
        geometry.GetBoundary(c, polygon.Boundary, polygon.NodePlaces);
        const HalfArc& half = cycles.Arcs[cycles.Offsets[cycle]];
        Point3 center;
        if (graph.IsLoop(half.Arc))
        {
          const int axis = graph.Loops[half.Arc - graph.Arcs].Axis;
          const double maximum = MaxDome * grid.Width(axis, cycles.Cell[cycle][axis]);
          center = polygon.Dome(axis, half.Above ? maximum : -maximum);
        }
        else
        {
          center = method == CentralPointMethod::LeastSquares ? polygon.LeastSquares()
                                                              : polygon.Centroid();
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          centers[3 * cycle + axis] =
            grid.MoveInside(axis, cycles.Cell[cycle][axis], center[axis], CentralPointMargin);
        }
      }
    });
  if (ranks.AreSeveral())
  {
    const auto first = centers.begin() + static_cast<std::ptrdiff_t>(3 * own.First);
    const auto last = centers.begin() + static_cast<std::ptrdiff_t>(3 * own.Last);
    auto next = centers.begin();
    for (const auto& part : GatherValues(ranks, std::vector<double>(first, last)))
    {
      next = std::copy(part.begin(), part.end(), next);
    }
  }
  return centers;
}
}
