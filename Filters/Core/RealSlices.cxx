// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/RealSlices.h"

#include "Core/Base/EditContours.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The number of a plane in another grid; -1 if that has not got it.
Index NumberOf(const SpatialGrid& from, const SpatialGrid& to, int axis, Index plane)
{
  return to.FindPlane(axis, from.Planes[axis][plane]);
}

/// Takes the repairs of the first surface, but for those on planes that the other one has not.
void TakeRepairs(const Reconstruction& first, Reconstruction& result)
{
  result.Repairs.clear();
  for (Repair repair : first.Repairs)
  {
    repair.Plane =
      repair.Axis < 0 ? -1 : NumberOf(first.Grid, result.Grid, repair.Axis, repair.Plane);
    if (repair.Axis < 0 || repair.Plane >= 0)
    {
      result.Repairs.push_back(repair);
    }
  }
}

/// Takes how contours and slices of the first surface agree, but for planes that the other one has
/// not.
void TakeAgreement(const Reconstruction& first, Reconstruction& result)
{
  const ContourList& from = first.Members;
  ContourList& to = result.Members;
  to = ContourList();
  result.Agreement.OfContour.clear();
  for (std::size_t i = 0; i < from.Plane.size(); ++i)
  {
    const Index plane = NumberOf(first.Grid, result.Grid, from.Axis[i], from.Plane[i]);
    if (plane < 0)
    {
      continue;
    }
    to.Axis.push_back(from.Axis[i]);
    to.Plane.push_back(plane);
    to.Cell.push_back(from.Cell[i]);
    if (!from.Virtual.empty())
    {
      to.Virtual.push_back(from.Virtual[i]);
    }
    result.Agreement.OfContour.push_back(first.Agreement.OfContour[i]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (Index plane = 0; plane < first.Grid.Count(axis); ++plane)
    {
      const Index number = NumberOf(first.Grid, result.Grid, axis, plane);
      if (number >= 0)
      {
        result.Agreement.OfPlane[axis][number] = first.Agreement.OfPlane[axis][plane];
        result.Agreement.Shift[axis][number] = first.Agreement.Shift[axis][plane];
      }
    }
  }
}

/// Lists contours of the first surface that take no part in either.
void AppendLeftOut(
  const Reconstruction& first, const std::vector<Index>& leftOut, Reconstruction& result)
{
  const IsolatedContours& from = first.Isolated;
  IsolatedContours& to = result.Isolated;
  for (const Index i : leftOut)
  {
    const Index plane = NumberOf(first.Grid, result.Grid, from.Axis[i], from.Plane[i]);
    if (plane < 0)
    {
      continue;
    }
    to.Points.insert(to.Points.end(), from.Points.begin() + 3 * from.Offsets[i],
      from.Points.begin() + 3 * from.Offsets[i + 1]);
    to.Offsets.push_back(static_cast<Index>(to.Points.size() / 3));
    to.Axis.push_back(from.Axis[i]);
    to.Plane.push_back(plane);
    to.Source.push_back(from.Source[i]);
    to.LeftOut.push_back(1);
    to.Loop.push_back(IsolatedContours::None);
  }
}
}

std::vector<Index> FindLeftOut(
  const IsolatedContours& isolated, const std::vector<IsolatedLoop>& parts)
{
  std::vector<Index> found;
  for (Index i = 0; i < isolated.Count(); ++i)
  {
    if (isolated.Loop[i] == IsolatedContours::None && parts[i].FirstRun == GridCrossings::None)
    {
      found.push_back(i);
    }
  }
  return found;
}

void RemoveContours(
  const std::vector<Index>& leftOut, const std::vector<IsolatedLoop>& parts, Contours& contours)
{
  std::vector<std::uint8_t> isRemoved(contours.Axis.size(), 0);
  std::array<std::vector<Index>, 3> count; // of each plane
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    std::vector<Index>& planes = count[contours.Axis[contour]];
    planes.resize(std::max<std::size_t>(planes.size(), contours.Plane[contour] + 1), 0);
    ++planes[contours.Plane[contour]];
  }
  for (const Index i : leftOut)
  {
    const Index contour = parts[i].Contour;
    Index& left = count[contours.Axis[contour]][contours.Plane[contour]];
    if (left > 1)
    {
      isRemoved[contour] = 1;
      --left;
    }
  }
  RemoveMarked(isRemoved, contours);
}

Reconstruction ReportOf(Reconstruction& first)
{
  Reconstruction report;
  report.Grid = std::move(first.Grid);
  report.Reconciled = first.Reconciled;
  report.Repairs = std::move(first.Repairs);
  report.Members = std::move(first.Members);
  report.Agreement = std::move(first.Agreement);
  report.Nodes.Difference = std::move(first.Nodes.Difference);
  return report;
}

void TakeReport(
  const Reconstruction& first, const std::vector<Index>& leftOut, Reconstruction& result)
{
  result.Reconciled = first.Reconciled;
  result.SmallComponents = first.SmallComponents;
  result.RealDifferences = first.Nodes.Difference;
  TakeRepairs(first, result);
  TakeAgreement(first, result);
  AppendLeftOut(first, leftOut, result);
}

namespace
{
/// Ends a contour whose points have been added.
void CloseContour(int axis, double coordinate, bool isVirtual, Contours& contours)
{
  contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
  contours.Axis.push_back(static_cast<std::int8_t>(axis));
  contours.Coordinate.push_back(coordinate);
  contours.Plane.push_back(0);
  contours.Cell.push_back(-1);
  contours.Virtual.push_back(isVirtual ? 1 : 0);
}

void AddPoint(int axis, const Point3& point, Contours& contours)
{
  const double u = point[FirstAxis(axis)], v = point[SecondAxis(axis)];
  const bool isNew = static_cast<Index>(contours.U.size()) == contours.Offsets.back() ||
    contours.U.back() != u || contours.V.back() != v;
  if (isNew)
  {
    contours.U.push_back(u);
    contours.V.push_back(v);
  }
}

/// The contour that an arc is part of, with all of its arcs.
void ReadContour(
  const Reconstruction& result, Index arc, std::vector<std::uint8_t>& isRead, Contours& contours)
{
  const GridCrossings& crossings = result.Crossings;
  const GridEdge edge = GridEdgeCode(result.Grid).Decode(crossings.Edge[arc]);
  const bool isFirst = crossings.Family[arc] == 0;
  const int axis = isFirst ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction);
  for (Index next = arc; isRead[next] == 0; next = crossings.Next[next])
  {
    isRead[next] = 1;
    AddPoint(axis, result.Graph.PointAt(result.Nodes.NodeOf[next]), contours);
    for (Index i = 0; i < result.Graph.PointCount(next); ++i)
    {
      AddPoint(axis, result.Graph.PointAt(result.Graph.FirstPoint(next) + i), contours);
    }
  }
  const Index plane = isFirst ? edge.First : edge.Second;
  CloseContour(axis, result.Grid.Planes[axis][plane], result.Grid.IsVirtual(axis, plane), contours);
}

/// The contours of all slices, or of virtual ones alone.
Contours ReadContours(const Reconstruction& result, bool withReal)
{
  Contours contours;
  const GridEdgeCode code(result.Grid);
  std::vector<std::uint8_t> isRead(result.Crossings.Count(), 0);
  for (Index arc = 0; arc < result.Crossings.Count(); ++arc)
  {
    if (!result.Crossings.IsRemoved(arc) && isRead[arc] == 0 &&
      (withReal ||
        IsVirtualSlice(
          result.Grid, code.Decode(result.Crossings.Edge[arc]), result.Crossings.Family[arc])))
    {
      ReadContour(result, arc, isRead, contours);
    }
  }
  const IsolatedContours& isolated = result.Isolated;
  for (Index i = 0; i < isolated.Count(); ++i)
  {
    const int axis = isolated.Axis[i];
    const bool isVirtual = result.Grid.IsVirtual(axis, isolated.Plane[i]);
    if ((withReal || isVirtual) && isolated.LeftOut[i] == 0)
    {
      for (Index k = isolated.Offsets[i]; k < isolated.Offsets[i + 1]; ++k)
      {
        const double* p = isolated.Points.data() + 3 * static_cast<std::size_t>(k);
        AddPoint(axis, { p[0], p[1], p[2] }, contours);
      }
      CloseContour(axis, result.Grid.Planes[axis][isolated.Plane[i]], isVirtual, contours);
    }
  }
  return contours;
}
}

void RemoveOnPlanes(const SpatialGrid& known, Contours& contours)
{
  std::vector<std::uint8_t> isKnown;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    isKnown.push_back(known.FindPlane(contours.Axis[i], contours.Coordinate[i]) >= 0 ? 1 : 0);
  }
  RemoveMarked(isKnown, contours);
}

Contours ReadAll(const Reconstruction& result) { return ReadContours(result, true); }

Contours ReadVirtual(const Reconstruction& result, const SpatialGrid& known)
{
  Contours contours = ReadContours(result, false);
  RemoveOnPlanes(known, contours);
  return contours;
}
}
