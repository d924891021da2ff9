// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/WriteSurface.h"

#include "Bridge/PieceMarks.h"
#include "Bridge/PointArrays.h"
#include "Bridge/SurfaceArrays.h"
#include "Core/Reconstruction.h"
#include "Core/Surface/DescribePatches.h"

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
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

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
  execution.For(static_cast<std::size_t>(count) + 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        offset[i] = static_cast<typename IdArray::ValueType>(3 * i);
      }
    });
  const CycleGeometry geometry = GeometryOf(result);
  WriteTriangles(result.Surface, geometry, execution, connectivity->GetPointer(0));
  cells->SetData(offsets, connectivity);
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
    if (point < 0 || point >= result.Graph.Nodes)
    {
      break;
    }
    out[i] = static_cast<float>(result.Nodes.Disagreement(static_cast<Index>(point)));
  }
}

/// What the triangles of a patch have in common, for each cycle.
struct PatchValues
{
  std::vector<int> Component;
  std::vector<Index> Size;
  std::vector<unsigned char> Repair;
};

PatchValues ListPatchValues(const Reconstruction& result, double reportTolerance)
{
  const CycleGeometry geometry = GeometryOf(result);
  PatchValues values;
  values.Component.resize(result.Cycles.Count());
  for (Index i = 0; i < result.Cycles.Count(); ++i)
  {
    values.Component[i] = result.Graph.Component[geometry.PartOf(i)];
  }
  values.Size = CountNodePoints(geometry, result.Surface.Meshes);
  values.Repair = FindPatchRepairs(geometry, result.Surface.Meshes, reportTolerance);
  return values;
}

/// Component, cell of M and size of the polygon, for each triangle.
void FillCellArrays(const PatchValues& values, const CellCycles& cycles,
  const std::vector<std::int64_t>& offsets, const Execution& execution, vtkCellData* data)
{
  const vtkIdType count = offsets.back();
  int* component = AddArray<vtkIntArray>(data, "ComponentId", 1, count)->GetPointer(0);
  auto* cell = AddArray<vtkUnsignedShortArray>(data, "GridCell", 3, count)->GetPointer(0);
  auto* size = AddArray<vtkUnsignedShortArray>(data, "PolygonSize", 1, count)->GetPointer(0);
  auto* repair = AddArray<vtkUnsignedCharArray>(data, "Repaired", 1, count)->GetPointer(0);
  execution.For(cycles.Cell.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const std::int64_t begin = offsets[i], end = offsets[i + 1];
        std::fill(component + begin, component + end, values.Component[i]);
        std::fill(repair + begin, repair + end, values.Repair[i]);
        std::fill(size + begin, size + end,
          static_cast<unsigned short>(std::min<Index>(values.Size[i], VTK_UNSIGNED_SHORT_MAX)));
        for (std::int64_t triangle = begin; triangle < end; ++triangle)
        {
          std::copy(cycles.Cell[i].begin(), cycles.Cell[i].end(), cell + 3 * triangle);
        }
      }
    });
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
  AddArray<vtkDoubleArray>(data, "Accuracy", 1, 1)->SetValue(0, result.Accuracy);
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
/// From so many triangles on, memory that was released goes back to the system.
constexpr std::int64_t ManyTriangles = 100000;

/// Gives memory that was released back to the system. What small blocks took stays with the process
/// otherwise, and large arrays come on top of it.
void GiveBackMemory(const Reconstruction& result)
{
#ifdef __GLIBC__
  if (result.Surface.TriangleCount() >= ManyTriangles)
  {
    malloc_trim(0);
  }
#else
  static_cast<void>(result);
#endif
}

/// Assigning an empty list would keep the memory.
template <typename Values>
void Release(Values& values)
{
  values = Values();
}

/// Of the patches, and of G, if triangles are not improved; see Patches.
vtkIdType CountPoints(const Patches& patches)
{
  return patches.MeshOffsets.back() + patches.Inner.PointOffsets.back() - patches.Inner.Count();
}

/// The points of the surface in their order, see Patches.
vtkSmartPointer<vtkPoints> MakePoints(
  const Reconstruction& result, bool doublePrecision, const Execution& execution)
{
  const Patches& patches = result.Surface;
  if (patches.Improved.Any())
  {
    auto points =
      NewPoints(doublePrecision, static_cast<vtkIdType>(patches.Improved.Points.size() / 3));
    CopyPoints(patches.Improved.Points, 0, execution, points);
    return points;
  }
  const Index graphPoints = result.Graph.Count();
  const InnerPatches& inner = patches.Inner;
  auto points = NewPoints(doublePrecision, CountPoints(patches));
  CopyPoints(result.Graph.Points, 0, execution, points);
  CopyPoints(patches.CentralPoints, graphPoints, execution, points);
  for (std::size_t m = 0; m < patches.Meshes.size(); ++m)
  {
    const PatchMesh& mesh = patches.Meshes[m];
    for (std::size_t i = mesh.Cycles.size(); i < mesh.Points.size(); ++i)
    {
      points->SetPoint(patches.MeshOffsets[m] + static_cast<vtkIdType>(i - mesh.Cycles.size()),
        mesh.Points[i].data());
    }
  }
  execution.For(static_cast<std::size_t>(inner.Count()),
    [&](std::size_t begin, std::size_t end)
    {
      for (Index i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      {
        CopyPoints(inner.Points.data() + 3 * (inner.PointOffsets[i] + 1),
          inner.Points.data() + 3 * inner.PointOffsets[i + 1], patches.InnerPointId(i), points);
      }
    });
  return points;
}

/// The normals that the smooth surface has at all points, or at those that are left of them; empty
/// if there are none.
std::vector<float> ListNormals(const Reconstruction& result, const Execution& execution)
{
  const Index graphPoints = result.Graph.Count();
  std::vector<float> smooth = ListSmoothNormals(
    result.Normals, result.Surface, graphPoints, CountPoints(result.Surface), execution);
  const ImprovedTriangles& improved = result.Surface.Improved;
  return improved.Any() && !smooth.empty() ? SelectNormals(smooth, improved.Origin) : smooth;
}

void SetTriangles(const Reconstruction& result, const Execution& execution, vtkPolyData* surface)
{
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
}
}

void WriteSurface(Reconstruction&& consumed, const Execution& execution, bool doublePrecision,
  const SurfaceArrayOptions& arrays, double reportTolerance, vtkPolyData* surface)
{
  // Each table is released as soon as nothing is left to be made from it.
  Reconstruction result = std::move(consumed);
  result.Drawn = {};
  Patches& patches = result.Surface;
  const bool isImproved = patches.Improved.Any();
  std::optional<PieceMarks> marks;
  if (result.Part)
  {
    marks.emplace(result, arrays.Processes);
  }
  GiveBackMemory(result);
  SetTriangles(result, execution, surface);
  Release(patches.Inner.Corners);
  const PatchValues values = ListPatchValues(result, reportTolerance);
  AddFieldData(result, surface->GetFieldData());
  Release(result.Cycles.Arcs);
  result.Crossings = GridCrossings();
  surface->SetPoints(MakePoints(result, doublePrecision, execution));
  AddDisagreement(result, surface->GetNumberOfPoints(),
    isImproved ? &patches.Improved.Origin : nullptr, surface->GetPointData());
  Release(result.Graph.Points);
  result.Nodes = NodePoints();
  Release(patches.CentralPoints);
  Release(patches.Inner.Points);
  Release(patches.Improved.Points);
  const bool withNormals = arrays.Normals || arrays.Curvatures;
  std::vector<float> smooth = withNormals ? ListNormals(result, execution) : std::vector<float>();
  result.Normals = SurfaceNormals();
  Release(patches.Inner.Normals);
  if (marks)
  {
    smooth = marks->Apply(smooth, surface);
  }
  if (withNormals)
  {
    AddNormals(surface, smooth, execution, marks ? &marks->GetShared() : nullptr);
  }
  Release(smooth);
  const CellCycles cycles = std::move(result.Cycles);
  const std::vector<std::int64_t> offsets = std::move(patches.Offsets);
  result = Reconstruction();
  FillCellArrays(values, cycles, offsets, execution, surface->GetCellData());
  AddQuality(surface, execution, arrays.Processes);
  if (arrays.Curvatures)
  {
    AddCurvatures(surface);
  }
}
}
