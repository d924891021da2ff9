// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Reconstruct.h"

#include "AssembleContours.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Diagonal of the bounding box of all finite coordinates.
double FindDiagonal(const std::array<Pieces, 3>& pieces)
{
  Point3 low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  for (const Pieces& set : pieces)
  {
    const auto extend = [&](int axis, const std::vector<double>& values)
    {
      for (const double x : values)
      {
        if (std::isfinite(x))
        {
          low[axis] = std::min(low[axis], x);
          high[axis] = std::max(high[axis], x);
        }
      }
    };
    extend(FirstAxis(set.Axis), set.U);
    extend(SecondAxis(set.Axis), set.V);
    extend(set.Axis, set.W);
  }
  const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  return std::isfinite(diagonal) ? diagonal : 0.0;
}

IsolatedContours CopyIsolated(
  const std::vector<IsolatedLoop>& loops, const Contours& contours, const Crossings& crossings)
{
  IsolatedContours isolated;
  const auto add = [&](Index contour, Index first, Index count)
  {
    for (Index i = 0; i < count; ++i)
    {
      Index vertex = first + i;
      vertex -= vertex >= contours.Offsets[contour + 1] ? contours.Size(contour) : 0;
      const Point3 point = contours.World(contour, vertex);
      isolated.Points.insert(isolated.Points.end(), point.begin(), point.end());
    }
  };
  for (const IsolatedLoop& loop : loops)
  {
    Index member = loop.Contour;
    if (loop.FirstRun == Crossings::None)
    {
      add(member, contours.Offsets[member], contours.Size(member));
    }
    for (Index run = loop.FirstRun; run != Crossings::None; run = crossings.RunNext[run])
    {
      if (crossings.RunCount[run] > 0)
      {
        member = crossings.RunContour[run];
        add(member, crossings.RunFirst[run], crossings.RunCount[run]);
      }
    }
    isolated.Offsets.push_back(static_cast<Index>(isolated.Points.size() / 3));
    isolated.Axis.push_back(contours.Axis[member]);
    isolated.Plane.push_back(contours.Plane[member]);
  }
  return isolated;
}

/// Names the share of the work that is done, and asks whether to go on.
bool GoOn(const Execution& execution, Reconstruction& result, double progress)
{
  result.Stopped = !execution.Continue(progress);
  return !result.Stopped;
}

void Append(const std::vector<Repair>& more, std::vector<Repair>& repairs)
{
  repairs.insert(repairs.end(), more.begin(), more.end());
}

/// One repair for each patch that became a shell.
std::vector<Repair> DescribeShells(const Reconstruction& result)
{
  std::vector<Repair> repairs;
  std::vector<Index> border, nodePlaces;
  for (const ShellPatch& shell : result.Surface.Shells)
  {
    GetBoundary(
      result.Graph, result.Lattice, result.Nodes, result.Polygons, shell.Cycle, border, nodePlaces);
    Point3 sum{ 0.0, 0.0, 0.0 };
    double length = 0.0;
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const double* p = result.Graph.Points.data() + 3 * static_cast<std::size_t>(border[i]);
      const double* q =
        result.Graph.Points.data() + 3 * static_cast<std::size_t>(border[(i + 1) % border.size()]);
      length += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += p[axis] / border.size();
      }
    }
    repairs.push_back({ RepairKind::PatchesSeparated, -1, -1, sum, length });
  }
  return repairs;
}

void CountContours(const Contours& contours, Reconstruction& result)
{
  for (const std::int8_t axis : contours.Axis)
  {
    ++result.ContourCount[axis];
  }
}

/// Arcs of the given cycles.
std::vector<Index> ArcsOf(const Cycles& polygons, const std::vector<Index>& cycles)
{
  std::vector<Index> arcs;
  for (const Index cycle : cycles)
  {
    for (Index i = polygons.Offsets[cycle]; i < polygons.Offsets[cycle + 1]; ++i)
    {
      arcs.push_back(polygons.Arcs[i].Arc);
    }
  }
  return arcs;
}

/// Cycles, central points and shells. Cells that rounding leaves unresolved get new arcs and a
/// second try.
void MakePatches(const Options& options, const std::vector<double>& normals,
  const Execution& execution, Reconstruction& result)
{
  constexpr int mostRounds = 3;
  for (int round = 1; round <= mostRounds; ++round)
  {
    result.Polygons = TraceCycles(result.Grid, result.Lattice, result.Nodes);
    result.Surface.CentralPoints = LocateCentralPoints(options.Central, result.Grid, result.Graph,
      result.Lattice, result.Nodes, normals, result.Polygons, execution);
    SeparatedPatches separated = SeparatePatches(result.Grid, result.Graph, result.Lattice,
      result.Nodes, result.Polygons, result.Surface.CentralPoints, execution);
    result.SharedCells = separated.SharedCells;
    result.Surface.Shells = std::move(separated.Shells);
    result.DoubtfulCycles = static_cast<Index>(separated.Unresolved.size());
    if (separated.Unresolved.empty() || round == mostRounds)
    {
      break;
    }
    Append(EmbedArcs(result.Grid, result.Nodes, execution, result.Lattice, result.Graph,
             ArcsOf(result.Polygons, separated.Unresolved)),
      result.Repairs);
  }
}
}

Index CountDisagreements(const Reconstruction& result, double tolerance)
{
  Index count = 0;
  for (Index node = 0; node < result.Nodes.Count(); ++node)
  {
    count += result.Nodes.Disagreement(node) > tolerance ? 1 : 0;
  }
  return count;
}

Reconstruction Reconstruct(
  std::array<Pieces, 3>&& pieces, const Options& options, const Execution& execution)
{
  Reconstruction result;
  result.Diagonal = FindDiagonal(pieces);
  const double tolerance = options.PlaneTolerance * result.Diagonal;
  Contours contours;
  for (Pieces& set : pieces)
  {
    AssembleContours(std::move(set), tolerance, contours, result.Invalid);
  }
  if (!GoOn(execution, result, 0.15))
  {
    return result;
  }
  result.Grid = BuildSpatialGrid(contours, tolerance, options.SinglePrecision);
  const Index assembled = contours.Count();
  OrientContours(options.Orient, options.Crossing == CrossingContours::Repair, execution, contours,
    result.Crossing);
  if (contours.Count() < assembled)
  {
    // A plane whose contours were all removed says nothing: it must not count as empty.
    result.Grid = BuildSpatialGrid(contours, tolerance, options.SinglePrecision);
  }
  CountContours(contours, result);
  result.InsideOut = options.Orient == Orientation::AsDrawn && BoundOutside(contours);
  result.Refused = (options.RefuseInvalid && !result.Invalid.empty()) ||
    (options.Crossing == CrossingContours::Refuse && !result.Crossing.empty());
  if (result.Refused || !GoOn(execution, result, 0.35))
  {
    return result;
  }
  std::vector<IsolatedLoop> isolated;
  result.Lattice = RegisterCrossings(contours, result.Grid, execution, isolated);
  EdgeRegister edges = FileOnEdges(result.Lattice);
  if (!GoOn(execution, result, 0.5))
  {
    return result;
  }
  result.Reconciled = ReconcileSlices(
    result.Grid, result.Lattice, edges, isolated, options.Weights, result.InsideOut ? 1 : 0);
  result.Repairs.swap(result.Reconciled.Repairs);
  result.Nodes = PairNodePoints(result.Grid, result.Lattice, edges, options.Weights);
  edges = EdgeRegister();
  result.Graph =
    BuildNodeGraph(contours, result.Grid, result.Lattice, result.Nodes, tolerance, execution);
  const std::vector<double> normals =
    ComputeNodeNormals(contours, result.Grid, result.Lattice, result.Nodes, execution);
  result.Isolated = CopyIsolated(isolated, contours, result.Lattice);
  result.Agreement = MeasureAgreement(contours, result.Grid, result.Lattice, result.Nodes, normals);
  result.Members = { contours.Axis, contours.Plane, contours.Cell };
  Append(
    EmbedArcs(result.Grid, result.Nodes, execution, result.Lattice, result.Graph), result.Repairs);
  contours = Contours();
  if (!GoOn(execution, result, 0.65))
  {
    return result;
  }
  MakePatches(options, normals, execution, result);
  FindComponents(result.Lattice, result.Nodes, result.Graph);
  Append(DescribeShells(result), result.Repairs);
  LayOutTriangles(result.Graph, result.Polygons, result.Surface);
  GoOn(execution, result, 0.8);
  return result;
}
}
