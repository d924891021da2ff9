// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/WriteSurface.h"

#include "Bridge/PointArrays.h"
#include "Bridge/SurfaceArrays.h"
#include "Bridge/TakePiece.h"
#include "Core/Patches/DivideCycles.h"
#include "Core/Reconstruction.h"
#include "Core/Surface/DescribePatches.h"
#include "Core/Surface/PointNormals.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace orthoslices
{
namespace
{
template <typename Array>
Array* AddArray(vtkFieldData* data, const char* name, int components, vtkIdType count)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  data->AddArray(array);
  return array; // owned by the data from here on
}

/// Triangles in the smaller of VTK's two storages that holds them.
template <typename IdArray>
void FillTriangles(const Reconstruction& result, const Execution& execution, vtkCellArray* cells)
{
  const vtkIdType count = result.Surface.TriangleCount();
  vtkNew<IdArray> offsets;
  vtkNew<IdArray> connectivity;
  offsets->SetNumberOfValues(count + 1);
  connectivity->SetNumberOfValues(3 * count);
  auto* offset = offsets->GetPointer(0);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offset[i] = static_cast<typename IdArray::ValueType>(3 * i);
  }
  const CycleGeometry geometry = GeometryOf(result);
  WriteTriangles(result.Surface, geometry, execution, connectivity->GetPointer(0));
  cells->SetData(offsets, connectivity);
}

/// The normals of some of all points, x, y and z of each.
std::vector<float> SelectNormals(
  const std::vector<float>& normals, const std::vector<std::int64_t>& points)
{
  std::vector<float> selected;
  selected.reserve(3 * points.size());
  for (const std::int64_t point : points)
  {
    const auto first = normals.begin() + static_cast<std::ptrdiff_t>(3 * point);
    selected.insert(selected.end(), first, first + 3);
  }
  return selected;
}

/// Distance of the two contours at the node points, which are the first of all points, 0 at all
/// other ones; of `count` points, or of some of all, ascending.
void AddDisagreement(const Reconstruction& result, vtkIdType count,
  const std::vector<std::int64_t>* some, vtkPointData* data)
{
  float* out = AddArray<vtkFloatArray>(data, "Disagreement", 1, count)->GetPointer(0);
  std::fill(out, out + count, 0.0f);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::int64_t point = some ? (*some)[i] : i;
    if (point >= result.Graph.Nodes)
    {
      break;
    }
    out[i] = static_cast<float>(result.Nodes.Disagreement(static_cast<Index>(point)));
  }
}

/**
 * Component, cell of M and size of the polygon, for each triangle. Everything but that is released
 * before the arrays are made.
 */
void FillCellArrays(Reconstruction& result, double reportTolerance, vtkCellData* data)
{
  const CellCycles& cycles = result.Cycles;
  const CycleGeometry geometry = GeometryOf(result);
  std::vector<int> components(cycles.Count());
  for (Index i = 0; i < cycles.Count(); ++i)
  {
    components[i] = result.Graph.Component[geometry.PartOf(i)];
  }
  const std::vector<Index> sizes = CountNodePoints(geometry, result.Surface.Meshes);
  const std::vector<unsigned char> repairs =
    FindPatchRepairs(geometry, result.Surface.Meshes, reportTolerance);
  result.Crossings = GridCrossings();
  result.Nodes = NodePoints();
  result.Graph = NodeGraph();
  result.Cycles.Arcs = {};
  const vtkIdType count = result.Surface.TriangleCount();
  int* component = AddArray<vtkIntArray>(data, "ComponentId", 1, count)->GetPointer(0);
  auto* cell = AddArray<vtkUnsignedShortArray>(data, "GridCell", 3, count)->GetPointer(0);
  auto* size = AddArray<vtkUnsignedShortArray>(data, "PolygonSize", 1, count)->GetPointer(0);
  auto* repair = AddArray<vtkUnsignedCharArray>(data, "Repaired", 1, count)->GetPointer(0);
  for (Index i = 0; i < cycles.Count(); ++i)
  {
    const std::int64_t begin = result.Surface.Offsets[i];
    const std::int64_t end = result.Surface.Offsets[i + 1];
    std::fill(component + begin, component + end, components[i]);
    std::fill(repair + begin, repair + end, repairs[i]);
    std::fill(size + begin, size + end,
      static_cast<unsigned short>(std::min<Index>(sizes[i], VTK_UNSIGNED_SHORT_MAX)));
    for (std::int64_t triangle = begin; triangle < end; ++triangle)
    {
      std::copy(cycles.Cell[i].begin(), cycles.Cell[i].end(), cell + 3 * triangle);
    }
  }
}

void AddFieldData(const Reconstruction& result, vtkFieldData* data)
{
  const auto add = [&](const char* name, vtkIdType value)
  { AddArray<vtkIdTypeArray>(data, name, 1, 1)->SetValue(0, value); };
  add("NumberOfComponents", result.Graph.Components);
  add("NumberOfContours",
    vtkIdType(result.ContourCount[0]) + result.ContourCount[1] + result.ContourCount[2]);
  add("NumberOfIsolatedContours", result.Isolated.Count());
  add("NumberOfContoursLeftOut", CountLeftOut(result));
  add("NumberOfComponentsLeftOut", result.SmallComponents);
  add("NumberOfUndecidedPlaces", static_cast<vtkIdType>(result.Undecided.Places.size()));
  add("TotalGenus", result.Topology.Genus);
  add("NumberOfNodePoints", result.Graph.Nodes);
  add("NumberOfCellsWithSeveralCycles", result.SharedCells);
  add("NumberOfReconciledVertices", result.Reconciled.Vertices);
  add("NumberOfReconciledEdges", result.Reconciled.Edges);
  add("NumberOfRepairs", static_cast<vtkIdType>(result.Repairs.size()));
  if (!result.Frame.IsWorld())
  {
    auto* normals = AddArray<vtkDoubleArray>(data, "FamilyNormals", 3, 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      normals->SetTypedTuple(axis, result.Frame.Normal(axis).data());
    }
  }
}
}

namespace
{
/// What a piece has to know of the whole surface; made before the result is consumed.
class PieceMarks
{
public:
  /// REQUIRES: result.Part.
  PieceMarks(const Reconstruction& result, const Ranks& ranks);

  /// Leaves the points of the piece, and marks these; returns their ids before.
  std::vector<std::int64_t> Apply(vtkPolyData* surface);

  /// REQUIRES: Apply.
  const SharedPoints& GetShared() const { return this->Shared; }

private:
  std::vector<std::uint8_t> PartsOfPoints; ///< of the points of G
  std::int64_t FirstInner;                 ///< the ids of what only this piece has begin here
  std::int64_t InnerBefore = 0;            ///< number of such points of the pieces before
  std::int64_t TrianglesBefore = 0;
  SharedPoints Shared;
};

PieceMarks::PieceMarks(const Reconstruction& result, const Ranks& ranks)
  : PartsOfPoints(FindPartsOfPoints(GeometryOf(result), result.Surface.Meshes, *result.Part))
  , FirstInner(result.Surface.MeshOffsets.back())
  , Shared{ ranks, {}, {}, !result.Normals.Normals.empty() }
{
  const InnerPatches& inner = result.Surface.Inner;
  const std::vector<std::int64_t> own{ inner.PointOffsets.back() - inner.Count(),
    result.Surface.TriangleCount() };
  const auto all = GatherValues(ranks, own);
  for (int rank = 0; rank < ranks.Rank; ++rank)
  {
    this->InnerBefore += all[rank][0];
    this->TrianglesBefore += all[rank][1];
  }
}

std::vector<std::int64_t> PieceMarks::Apply(vtkPolyData* surface)
{
  const std::vector<vtkIdType> used = KeepUsedPoints(surface);
  std::vector<vtkIdType> ids(used.size());
  std::vector<unsigned char> isDuplicate(used.size(), 0);
  this->Shared.IsShared.assign(used.size(), 0);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    ids[i] = used[i] + (used[i] < this->FirstInner ? 0 : this->InnerBefore);
    if (used[i] < static_cast<vtkIdType>(this->PartsOfPoints.size()))
    {
      const std::uint8_t parts = this->PartsOfPoints[used[i]];
      isDuplicate[i] = (parts & BeforePart) != 0 ? 1 : 0;
      this->Shared.IsShared[i] = parts != 0 ? 1 : 0;
    }
  }
  this->Shared.Ids.assign(ids.begin(), ids.end());
  MarkPiece(ids, this->TrianglesBefore, isDuplicate, surface);
  return std::vector<std::int64_t>(used.begin(), used.end());
}
}

void WriteSurface(Reconstruction&& consumed, const Execution& execution, bool doublePrecision,
  const SurfaceArrayOptions& arrays, double reportTolerance, vtkPolyData* surface)
{
  Reconstruction result = std::move(consumed);
  const bool withNormals = arrays.Normals || arrays.Curvatures;
  const Index graphPoints = result.Graph.Count();
  const vtkIdType allCenters = vtkIdType(graphPoints) + result.Cycles.Count();
  std::vector<double> otherPoints = ListOtherPoints(result.Surface);
  const vtkIdType allPoints = allCenters + static_cast<vtkIdType>(otherPoints.size() / 3);
  const bool isPart = result.Part.has_value();
  std::optional<PieceMarks> marks;
  if (isPart)
  {
    marks.emplace(result, *arrays.Processes);
  }
  std::vector<std::int64_t> origins = std::move(result.Surface.Improved.Origin);
  const bool isImproved = result.Surface.Improved.Any();
  result.Surface.Inner.Points = {};
  auto points =
    NewPoints(doublePrecision, isImproved ? static_cast<vtkIdType>(origins.size()) : allPoints);
  if (isImproved)
  {
    CopyPoints(result.Surface.Improved.Points, 0, points);
  }
  else
  {
    CopyPoints(result.Graph.Points, 0, points);
    CopyPoints(result.Surface.CentralPoints, graphPoints, points);
    CopyPoints(otherPoints, allCenters, points);
  }
  otherPoints = {};
  result.Graph.Points = {};
  result.Surface.CentralPoints = {};
  surface->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  if (3 * result.Surface.TriangleCount() < std::numeric_limits<std::int32_t>::max())
  {
    FillTriangles<vtkTypeInt32Array>(result, execution, cells);
  }
  else
  {
    FillTriangles<vtkTypeInt64Array>(result, execution, cells);
  }
  surface->SetPolys(cells);
  AddFieldData(result, surface->GetFieldData());
  AddDisagreement(
    result, surface->GetNumberOfPoints(), isImproved ? &origins : nullptr, surface->GetPointData());
  std::vector<float> smooth = withNormals
    ? ListSmoothNormals(result.Normals, result.Surface, graphPoints, allPoints)
    : std::vector<float>();
  FillCellArrays(result, reportTolerance, surface->GetCellData());
  result = Reconstruction();
  if (isPart)
  {
    origins = marks->Apply(surface);
  }
  if ((isImproved || isPart) && !smooth.empty())
  {
    smooth = SelectNormals(smooth, origins);
  }
  AddQuality(surface, execution, isPart ? *arrays.Processes : Ranks());
  if (withNormals)
  {
    AddNormals(surface, smooth, execution, isPart ? &marks->GetShared() : nullptr);
  }
  if (arrays.Curvatures)
  {
    AddCurvatures(surface);
  }
}
}
