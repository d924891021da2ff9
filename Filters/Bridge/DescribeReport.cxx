// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/DescribeReport.h"

#include "Bridge/DescribeProblems.h"
#include "Core/Cells/DoubtfulJoins.h"
#include "Core/Reconstruction.h"

#include <algorithm>
#include <sstream>

namespace orthoslices
{
namespace
{
/// Of many slices so many are named.
constexpr std::size_t ListedSlices = 10;

std::string TextOf(const Point3& point)
{
  std::ostringstream text;
  text << "(" << point[0] << ", " << point[1] << ", " << point[2] << ")";
  return text.str();
}

/// The slice that agrees least with the others.
std::string DescribeWorstSlice(const Reconstruction& result)
{
  int worstAxis = 0;
  std::size_t worstPlane = 0;
  double worst = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& planes = result.Agreement.OfPlane[axis];
    for (std::size_t plane = 0; plane < planes.size(); ++plane)
    {
      if (planes[plane].RootMeanSquare() > worst)
      {
        worst = planes[plane].RootMeanSquare();
        worstAxis = axis;
        worstPlane = plane;
      }
    }
  }
  std::ostringstream text;
  if (worst > 0.0)
  {
    text << " Least agreement: the slice " << AxisNames[worstAxis] << " = "
         << result.Grid.Planes[worstAxis][worstPlane] << ", RMS " << worst
         << " (see the table of slices).";
  }
  return text.str();
}

/// The slice that lost most votes on whether a grid vertex is inside.
std::string DescribeOverruledSlice(const Reconstruction& result)
{
  std::array<std::vector<int>, 3> count;
  int worstAxis = 0;
  int worstPlane = -1;
  for (const Repair& repair : result.Repairs)
  {
    if (repair.Kind != RepairKind::VertexRelabelled)
    {
      continue;
    }
    count[repair.Axis].resize(result.Grid.Count(repair.Axis), 0);
    ++count[repair.Axis][repair.Plane];
    if (worstPlane < 0 || count[repair.Axis][repair.Plane] > count[worstAxis][worstPlane])
    {
      worstAxis = repair.Axis;
      worstPlane = repair.Plane;
    }
  }
  std::ostringstream text;
  if (worstPlane >= 0)
  {
    text << " Most often overruled: the slice " << AxisNames[worstAxis] << " = "
         << result.Grid.Planes[worstAxis][worstPlane] << ", at " << count[worstAxis][worstPlane]
         << " grid vertices.";
  }
  return text.str();
}

/// Contours that were mended, and those that cannot be used as they are.
void DescribeContours(
  const Reconstruction& result, const ReportSettings& settings, std::ostringstream& text)
{
  if (!result.Mended.empty())
  {
    text << "\nThe input was mended (see the table of input problems):"
         << DescribeMended(result.Mended);
  }
  if (!result.Invalid.empty())
  {
    text << "\n"
         << result.Invalid.size() << " contours were left out:" << DescribeProblems(result.Invalid);
  }
  if (!result.CrossingProblems.empty())
  {
    text << "\n"
         << result.CrossingProblems.size() << " contours cross and were "
         << (settings.RepairsCrossing ? "repaired:" : "left out:")
         << DescribeProblems(result.CrossingProblems);
  }
}

/// Contours that slices lack and that were interpolated, and on which slices.
void DescribeInserted(const Reconstruction& result, std::ostringstream& text)
{
  std::size_t count = 0;
  std::ostringstream slices;
  for (const Repair& repair : result.Repairs)
  {
    if (repair.Kind == RepairKind::ContourInserted)
    {
      slices << (count == ListedSlices ? ", ..." : count > ListedSlices ? "" : ", ");
      if (count < ListedSlices)
      {
        slices << AxisNames[repair.Axis] << " = " << result.Grid.Planes[repair.Axis][repair.Plane];
      }
      ++count;
    }
  }
  if (count > 0)
  {
    text << "\n"
         << count
         << " contours seem to be missing and were interpolated between those of the slices around "
            "them, on "
         << slices.str().substr(2) << ".";
  }
}

/// Lines of a slice that were changed because they cross or touch, more than the tolerance.
void DescribeRedrawnArcs(const Reconstruction& result, std::ostringstream& text)
{
  const auto count = std::count_if(result.Repairs.begin(), result.Repairs.end(),
    [](const Repair& repair)
    {
      return repair.Kind == RepairKind::ArcsRedrawn || repair.Kind == RepairKind::ArcsReconnected ||
        repair.Kind == RepairKind::ArcsUncrossed;
    });
  if (count > 0)
  {
    text << "\nContours touch or cross between the other slices, and were taken apart, at " << count
         << " places.";
  }
}

/// A number of things, where there are any.
std::string DescribeCount(const char* before, Index count, const char* things)
{
  return count > 0 ? before + std::to_string(count) + things : std::string();
}

/// Repairs that small ones are taken out of, and node points.
void DescribeContradictions(
  const Reconstruction& result, double tolerance, std::ostringstream& text)
{
  const bool reconciled = std::any_of(result.Repairs.begin(), result.Repairs.end(),
    [](const Repair& repair)
    {
      return repair.Kind == RepairKind::VertexRelabelled ||
        repair.Kind == RepairKind::CrossingsSnipped;
    });
  const Reconciliation& counts = result.Reconciled;
  const std::string where = reconciled ? DescribeCount(" at ", counts.Vertices, " grid vertices") +
      (counts.Vertices > 0 && counts.Edges > 0 ? " and" : "") +
      DescribeCount(" on ", counts.Edges, " grid edges")
                                       : std::string();
  const Index disagreements = CountDisagreements(result, tolerance);
  if (where.empty() && disagreements == 0)
  {
    return;
  }
  text << "\nThe slices contradict each other" << where;
  text << (where.empty() ? "" : ", where they were reconciled");
  if (disagreements > 0)
  {
    text << (where.empty() ? "" : ", and") << " by more than " << tolerance << " at "
         << disagreements << " of " << CountRealNodes(result.Grid, result.Crossings, result.Nodes)
         << " node points";
  }
  text << "." << DescribeWorstSlice(result) << DescribeOverruledSlice(result);
}

/// Contours that take no part in the surface although nothing is wrong with them.
void DescribeLeftOut(const Reconstruction& result, std::ostringstream& text)
{
  const Index leftOut = CountLeftOut(result);
  if (leftOut > 0)
  {
    text << "\n"
         << leftOut
         << " contours without node points, or parts of contours that were cut off, take no part "
            "in the surface; they are the lines with ComponentId -1 of the graph output.";
  }
}

/// Places where the surface may well be joined otherwise, and where to slice next on their account.
void DescribeDoubts(const Reconstruction& result, std::ostringstream& text)
{
  const UndecidedPlaces& doubtful = result.Doubtful;
  if (doubtful.Planes.empty())
  {
    return;
  }
  const Point3& first = doubtful.Places.front().Where;
  const ProposedPlane& plane = doubtful.Planes.front();
  text << "\nAt " << doubtful.Places.size() << (doubtful.Places.size() == 1 ? " place" : " places")
       << " the slices hardly say which parts belong together, for example at (" << first[0] << ", "
       << first[1] << ", " << first[2] << "). A slice at " << AxisNames[plane.Axis] << " = "
       << plane.Coordinate << " would settle " << plane.Settles
       << " of them. See the table of undecided places.";
}

/// 0 components and genus -1 are unknown.
void DescribeUnexpected(
  const SurfaceTopology& topology, const PriorKnowledge& expected, std::ostringstream& text)
{
  if (expected.Components > 0 && expected.Components != topology.Components)
  {
    text << "\nThe surface has " << topology.Components << " components, not "
         << expected.Components << " as expected: the undecided places do not allow it.";
  }
  if (expected.Genus >= 0 && expected.Genus != topology.Genus)
  {
    text << "\nThe surface has genus " << topology.Genus << ", not " << expected.Genus
         << " as expected: the undecided places do not allow it.";
  }
}
}

std::string DescribeProblem(const SurfaceProblem& problem)
{
  const std::string edge = "the edge from " + TextOf(problem.From) + " to " + TextOf(problem.To);
  switch (problem.Kind)
  {
    case SurfaceProblemKind::NotFinite:
      return "The surface has the point " + TextOf(problem.From) + ", which is not finite.";
    case SurfaceProblemKind::OpenEdge:
      return "The surface is open: " + edge +
        " belongs to one triangle only. Close it first; if points there are only nearly the same, "
        "merge them (vtkCleanPolyData, ParaView's Clean).";
    case SurfaceProblemKind::OverusedEdge:
      return "The surface is not a manifold: " + edge + " belongs to more than two triangles.";
    case SurfaceProblemKind::InconsistentEdge:
      return "The triangles are not oriented consistently: both triangles at " + edge +
        " pass it in the same direction. Orient them first (vtkPolyDataNormals with "
        "ConsistencyOn, ParaView's Surface Normals).";
    case SurfaceProblemKind::None:
      break;
  }
  return std::string();
}

std::string DescribeReport(const Reconstruction& result, const ReportSettings& settings)
{
  std::ostringstream text;
  DescribeContours(result, settings, text);
  DescribeInserted(result, text);
  DescribeRedrawnArcs(result, text);
  DescribeContradictions(result, settings.Tolerance, text);
  if (result.InsideOut)
  {
    text
      << "\nThe contours run clockwise: the surface is inside out, as drawn. Reverse the contours,"
         " or set Orientation to ByNesting.";
  }
  if (result.DoubtfulCycles > 0)
  {
    text << "\nPlanes lie so close together that " << result.DoubtfulCycles
         << " patches between them may touch others. Use points in double precision, or a greater"
            " PlaneTolerance.";
  }
  DescribeLeftOut(result, text);
  DescribeDoubts(result, text);
  DescribeUnexpected(result.Topology, settings.Expected, text);
  return text.str();
}
}
