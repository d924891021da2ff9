// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/TakePiece.h"

#include "Bridge/VisitTriangles.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <type_traits>

namespace orthoslices
{
namespace
{
/// The points of some of all triangles.
struct PointsOfPiece
{
  std::vector<vtkIdType> Ids; ///< ascending
  std::vector<unsigned char> IsDuplicate;
  std::vector<vtkIdType> Corners; ///< of the triangles, by places among these points
};

PointsOfPiece FindPoints(vtkPolyData* surface, vtkIdType first, vtkIdType last)
{
  constexpr unsigned char before = 1, here = 2;
  PointsOfPiece piece;
  VisitTriangles(surface,
    [&](const auto*, const auto* ids, vtkIdType)
    {
      std::vector<unsigned char> used(surface->GetNumberOfPoints(), 0);
      std::for_each(ids, ids + 3 * first, [&](vtkIdType id) { used[id] |= before; });
      std::for_each(ids + 3 * first, ids + 3 * last, [&](vtkIdType id) { used[id] |= here; });
      std::vector<vtkIdType> places(used.size(), -1);
      for (std::size_t id = 0; id < used.size(); ++id)
      {
        if ((used[id] & here) != 0)
        {
          places[id] = static_cast<vtkIdType>(piece.Ids.size());
          piece.Ids.push_back(static_cast<vtkIdType>(id));
          piece.IsDuplicate.push_back(used[id] & before);
        }
      }
      for (vtkIdType i = 3 * first; i < 3 * last; ++i)
      {
        piece.Corners.push_back(places[ids[i]]);
      }
    });
  return piece;
}

/// A new array with the tuples of some points.
vtkSmartPointer<vtkAbstractArray> Select(vtkAbstractArray* from, const std::vector<vtkIdType>& ids)
{
  const vtkIdType count = static_cast<vtkIdType>(ids.size());
  auto to = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
  to->SetName(from->GetName());
  to->SetNumberOfComponents(from->GetNumberOfComponents());
  to->CopyComponentNames(from);
  to->SetNumberOfTuples(count);
  if (vtkDataArray::SafeDownCast(from) == nullptr)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      to->SetTuple(i, ids[i], from);
    }
    return to;
  }
  const std::size_t bytes =
    static_cast<std::size_t>(from->GetDataTypeSize()) * from->GetNumberOfComponents();
  const char* source = static_cast<const char*>(from->GetVoidPointer(0));
  char* target = static_cast<char*>(to->GetVoidPointer(0));
  for (const vtkIdType id : ids)
  {
    std::memcpy(target, source + static_cast<std::size_t>(id) * bytes, bytes);
    target += bytes;
  }
  return to;
}

/// Points and point data of a surface for some of its points.
void CopyPointsOf(vtkPolyData* surface, const std::vector<vtkIdType>& ids, vtkPolyData* piece)
{
  vtkNew<vtkPoints> points;
  const auto coordinates = Select(surface->GetPoints()->GetData(), ids);
  points->SetData(vtkDataArray::SafeDownCast(coordinates));
  piece->SetPoints(points);
  vtkPointData* data = surface->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const int at = piece->GetPointData()->AddArray(Select(data->GetAbstractArray(i), ids));
    const int attribute = data->IsArrayAnAttribute(i);
    if (attribute >= 0)
    {
      piece->GetPointData()->SetActiveAttribute(at, attribute);
    }
  }
}

template <typename IdArray>
void SetTriangles(const std::vector<vtkIdType>& corners, vtkPolyData* piece)
{
  const vtkIdType count = static_cast<vtkIdType>(corners.size());
  vtkNew<IdArray> offsets, connectivity;
  offsets->SetNumberOfValues(count / 3 + 1);
  connectivity->SetNumberOfValues(count);
  std::copy(corners.begin(), corners.end(), connectivity->GetPointer(0));
  for (vtkIdType i = 0; i <= count / 3; ++i)
  {
    offsets->SetValue(i, static_cast<typename IdArray::ValueType>(3 * i));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  piece->SetPolys(cells);
}

/// In the storage of the surface.
void SetTrianglesLike(
  vtkPolyData* surface, const std::vector<vtkIdType>& corners, vtkPolyData* piece)
{
  if (surface->GetPolys()->IsStorage64Bit())
  {
    SetTriangles<vtkTypeInt64Array>(corners, piece);
  }
  else
  {
    SetTriangles<vtkTypeInt32Array>(corners, piece);
  }
}

void CopyCellsOf(vtkPolyData* surface, vtkIdType first, vtkIdType last, vtkPolyData* piece)
{
  vtkCellData* data = piece->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(surface->GetCellData(), last - first);
  data->SetNumberOfTuples(last - first);
  data->CopyData(surface->GetCellData(), 0, last - first, first);
}
}

void MarkPiece(const std::vector<vtkIdType>& pointIds, vtkIdType firstTriangle,
  const std::vector<unsigned char>& isDuplicate, vtkPolyData* piece)
{
  vtkNew<vtkIdTypeArray> ofPoints, ofCells;
  ofPoints->SetName("GlobalPointIds");
  ofPoints->SetNumberOfValues(static_cast<vtkIdType>(pointIds.size()));
  std::copy(pointIds.begin(), pointIds.end(), ofPoints->GetPointer(0));
  ofCells->SetName("GlobalCellIds");
  const vtkIdType triangles = piece->GetNumberOfPolys();
  ofCells->SetNumberOfValues(triangles);
  std::iota(ofCells->GetPointer(0), ofCells->GetPointer(0) + triangles, firstTriangle);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(static_cast<vtkIdType>(isDuplicate.size()));
  std::transform(isDuplicate.begin(), isDuplicate.end(), ghosts->GetPointer(0),
    [](unsigned char is) -> unsigned char
    { return is != 0 ? vtkDataSetAttributes::DUPLICATEPOINT : 0; });
  piece->GetPointData()->SetGlobalIds(ofPoints);
  piece->GetPointData()->AddArray(ghosts);
  piece->GetCellData()->SetGlobalIds(ofCells);
}

std::vector<vtkIdType> KeepUsedPoints(vtkPolyData* surface)
{
  std::vector<vtkIdType> used, places(surface->GetNumberOfPoints(), -1);
  const auto forIds = [&](auto&& visit)
  {
    VisitTriangles(surface,
      [&](const auto*, auto* ids, vtkIdType count) { std::for_each(ids, ids + 3 * count, visit); });
  };
  forIds([&](const auto& id) { places[id] = 0; });
  for (std::size_t id = 0; id < places.size(); ++id)
  {
    if (places[id] == 0)
    {
      places[id] = static_cast<vtkIdType>(used.size());
      used.push_back(static_cast<vtkIdType>(id));
    }
  }
  forIds([&](auto& id) { id = static_cast<std::decay_t<decltype(id)>>(places[id]); });
  vtkNew<vtkPolyData> piece;
  CopyPointsOf(surface, used, piece);
  surface->SetPoints(piece->GetPoints());
  surface->GetPointData()->ShallowCopy(piece->GetPointData());
  return used;
}

void TakePiece(const Ranks& ranks, vtkPolyData* surface)
{
  if (!ranks.AreSeveral() || surface->GetPoints() == nullptr)
  {
    return;
  }
  const Portion portion = PortionOf(
    ranks, static_cast<std::size_t>(surface->GetNumberOfPolys()), [](std::size_t) { return 1.0; });
  const vtkIdType first = static_cast<vtkIdType>(portion.First);
  const vtkIdType last = static_cast<vtkIdType>(portion.Last);
  const PointsOfPiece points = FindPoints(surface, first, last);
  vtkNew<vtkPolyData> piece;
  CopyPointsOf(surface, points.Ids, piece);
  SetTrianglesLike(surface, points.Corners, piece);
  CopyCellsOf(surface, first, last, piece);
  MarkPiece(points.Ids, first, points.IsDuplicate, piece);
  piece->GetFieldData()->ShallowCopy(surface->GetFieldData());
  surface->ShallowCopy(piece);
}
}
