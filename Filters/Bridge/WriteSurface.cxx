// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/WriteSurface.h"
#include "Bridge/PointArrays.h"
#include "Bridge/SurfaceArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Appends the cells of one vtkCellArray to pieces.
class PieceReader
{
public:
  PieceReader(vtkPolyData* input, bool round, Pieces& pieces)
    : Round(round)
    , Points(input->GetPoints()->GetData())
    , Ghosts(vtkUnsignedCharArray::SafeDownCast(
        input->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName())))
    , Target(pieces)
  {
  }

  void Read(vtkCellArray* cells, bool polygons, vtkIdType firstCell);

private:
  void AddPoint(vtkIdType point);
  void AddCell(vtkIdType cell, vtkIdType count, const vtkIdType* points, bool polygon);

  bool Round;
  vtkDataArray* Points;
  vtkUnsignedCharArray* Ghosts;
  Pieces& Target;
};

void PieceReader::AddPoint(vtkIdType point)
{
  double x[3];
  if (auto* floats = vtkFloatArray::FastDownCast(this->Points))
  {
    std::copy_n(floats->GetPointer(3 * point), 3, x);
  }
  else if (auto* doubles = vtkDoubleArray::FastDownCast(this->Points))
  {
    std::copy_n(doubles->GetPointer(3 * point), 3, x);
  }
  else
  {
    this->Points->GetTuple(point, x);
  }
  if (this->Round)
  {
    std::transform(x, x + 3, x, [](double value) { return static_cast<float>(value); });
  }
  this->Target.U.push_back(x[FirstAxis(this->Target.Axis)]);
  this->Target.V.push_back(x[SecondAxis(this->Target.Axis)]);
  this->Target.W.push_back(x[this->Target.Axis]);
}

void PieceReader::AddCell(vtkIdType cell, vtkIdType count, const vtkIdType* points, bool polygon)
{
  const unsigned char hidden =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  if (count < 2 || (this->Ghosts && (this->Ghosts->GetValue(cell) & hidden)))
  {
    return;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->AddPoint(points[i]);
  }
  Pieces& pieces = this->Target;
  const std::size_t first = pieces.Offsets.back();
  const bool repeated = pieces.U.back() == pieces.U[first] && pieces.V.back() == pieces.V[first] &&
    pieces.W.back() == pieces.W[first];
  if (repeated)
  {
    pieces.U.pop_back();
    pieces.V.pop_back();
    pieces.W.pop_back();
  }
  pieces.Offsets.push_back(static_cast<Index>(pieces.U.size()));
  pieces.Cell.push_back(cell);
  pieces.Closed.push_back(polygon || repeated ? 1 : 0);
}

void PieceReader::Read(vtkCellArray* cells, bool polygons, vtkIdType firstCell)
{
  const std::size_t count = this->Target.U.size() + cells->GetNumberOfConnectivityIds();
  for (std::vector<double>* values : { &this->Target.U, &this->Target.V, &this->Target.W })
  {
    values->reserve(count);
  }
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(i, size, points);
    this->AddCell(firstCell + i, size, points, polygons);
  }
}

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

/**
 * What was repaired at each polygon: bit 0, one of its nodes disagrees by more than the
 * tolerance; bit 1, one of its arcs was changed; bit 2, its patch was separated from others.
 */
std::vector<unsigned char> FindRepairs(const Reconstruction& result, double tolerance)
{
  const CellCycles& cycles = result.Cycles;
  std::vector<unsigned char> repairs(cycles.Count(), 0);
  const bool any = CountDisagreements(result, tolerance) > 0 || !result.Graph.Redrawn.empty();
  for (Index i = 0; any && i < cycles.Count(); ++i)
  {
    for (Index a = cycles.Offsets[i]; a < cycles.Offsets[i + 1]; ++a)
    {
      const HalfArc& half = cycles.Arcs[a];
      if (result.Graph.IsLoop(half.Arc))
      {
        continue;
      }
      const Index node = StartNode(result.Crossings, result.Nodes, half);
      repairs[i] |= result.Nodes.Disagreement(node) > tolerance ? 1 : 0;
      repairs[i] |= !result.Graph.Redrawn.empty() && result.Graph.Redrawn[half.Arc] != 0 ? 2 : 0;
    }
  }
  for (const PatchMesh& mesh : result.Surface.Meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      repairs[mesh.Cycles.front()] |= repairs[cycle] | (mesh.IsSeparatedDisc() ? 4 : 0);
    }
  }
  return repairs;
}

/// Node points around each patch; a patch with several cycles counts as that of the first one.
std::vector<Index> CountNodePoints(const Reconstruction& result)
{
  const CycleGeometry geometry = GeometryOf(result);
  std::vector<Index> sizes(result.Cycles.Count());
  for (Index i = 0; i < result.Cycles.Count(); ++i)
  {
    sizes[i] = geometry.IsLoop(i) ? 0 : result.Cycles.Size(i);
  }
  for (const PatchMesh& mesh : result.Surface.Meshes)
  {
    for (std::size_t i = 1; i < mesh.Cycles.size(); ++i)
    {
      sizes[mesh.Cycles.front()] += sizes[mesh.Cycles[i]];
    }
  }
  return sizes;
}

/// Distance of the two contours at the node points, 0 at all other points.
void AddDisagreement(const Reconstruction& result, vtkIdType points, vtkPointData* data)
{
  float* out = AddArray<vtkFloatArray>(data, "Disagreement", 1, points)->GetPointer(0);
  std::fill(out, out + points, 0.0f);
  for (Index node = 0; node < result.Graph.Nodes; ++node)
  {
    out[node] = static_cast<float>(result.Nodes.Disagreement(node));
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
  const std::vector<Index> sizes = CountNodePoints(result);
  const std::vector<unsigned char> repairs = FindRepairs(result, reportTolerance);
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

/// Normals of the smooth surface at all points, zero where there is none; empty if there are none
/// at all.
std::vector<float> ListSmoothNormals(const Reconstruction& result, vtkIdType points)
{
  std::vector<float> normals;
  if (result.Normals.Normals.empty())
  {
    return normals;
  }
  normals.assign(3 * static_cast<std::size_t>(points), 0.0f);
  const auto copy = [&](const float* first, const float* last, std::int64_t id)
  { std::copy(first, last, normals.begin() + 3 * id); };
  const float* ofGraph = result.Normals.Normals.data();
  copy(ofGraph, ofGraph + result.Normals.Normals.size(), 0);
  for (std::size_t i = 0; i < result.Normals.Corners.size(); ++i)
  {
    std::fill_n(normals.begin() + 3 * i, result.Normals.Corners[i] != 0 ? 3 : 0, 0.0f);
  }
  const InnerPatches& inner = result.Surface.Inner;
  for (Index i = 0; i < inner.Count(); ++i)
  {
    const float* first = inner.Normals.data() + 3 * inner.PointOffsets[i];
    const float* last = inner.Normals.data() + 3 * inner.PointOffsets[i + 1];
    copy(first, first + 3, std::int64_t(result.Graph.Count()) + inner.Cycle[i]);
    copy(first + 3, last, result.Surface.InnerPointId(i));
  }
  return normals;
}

void AddFieldData(const Reconstruction& result, vtkFieldData* data)
{
  const auto add = [&](const char* name, vtkIdType value)
  { AddArray<vtkIdTypeArray>(data, name, 1, 1)->SetValue(0, value); };
  add("NumberOfComponents", result.Graph.Components);
  add("NumberOfContours",
    vtkIdType(result.ContourCount[0]) + result.ContourCount[1] + result.ContourCount[2]);
  add("NumberOfIsolatedContours", result.Isolated.Count());
  add("NumberOfContoursLeftOut", CountLeftOut(result.Isolated));
  add("NumberOfComponentsLeftOut", result.SmallComponents);
  add("NumberOfUndecidedPlaces", static_cast<vtkIdType>(result.Undecided.Places.size()));
  add("TotalGenus", result.Topology.Genus);
  add("NumberOfNodePoints", result.Graph.Nodes);
  add("NumberOfCellsWithSeveralCycles", result.SharedCells);
  add("NumberOfReconciledVertices", result.Reconciled.Vertices);
  add("NumberOfReconciledEdges", result.Reconciled.Edges);
  add("NumberOfRepairs", static_cast<vtkIdType>(result.Repairs.size()));
}
}

Pieces ReadPieces(vtkPolyData* input, int axis, bool doublePrecision)
{
  Pieces pieces;
  pieces.Axis = axis;
  if (input->GetPoints() == nullptr)
  {
    return pieces;
  }
  PieceReader reader(input, !doublePrecision, pieces);
  const vtkIdType verts = input->GetNumberOfVerts();
  reader.Read(input->GetLines(), false, verts);
  reader.Read(input->GetPolys(), true, verts + input->GetNumberOfLines());
  return pieces;
}

void WriteSurface(Reconstruction&& consumed, const Execution& execution, bool doublePrecision,
  const SurfaceArrayOptions& arrays, double reportTolerance, vtkPolyData* surface)
{
  Reconstruction result = std::move(consumed);
  const bool withNormals = arrays.Normals || arrays.Curvatures;
  const vtkIdType graphPoints = result.Graph.Count();
  const vtkIdType allCenters = graphPoints + result.Cycles.Count();
  std::vector<double> otherPoints = ListOtherPoints(result.Surface);
  const vtkIdType allPoints = allCenters + static_cast<vtkIdType>(otherPoints.size() / 3);
  result.Surface.Inner.Points = {};
  auto points = NewPoints(doublePrecision, allPoints);
  CopyPoints(result.Graph.Points, 0, points);
  CopyPoints(result.Surface.CentralPoints, graphPoints, points);
  CopyPoints(otherPoints, allCenters, points);
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
  AddDisagreement(result, surface->GetNumberOfPoints(), surface->GetPointData());
  const std::vector<float> smooth =
    withNormals ? ListSmoothNormals(result, allPoints) : std::vector<float>();
  FillCellArrays(result, reportTolerance, surface->GetCellData());
  result = Reconstruction();
  AddQuality(surface, execution);
  if (withNormals)
  {
    AddNormals(surface, smooth, execution);
  }
  if (arrays.Curvatures)
  {
    AddCurvatures(surface);
  }
}
}
