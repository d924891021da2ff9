// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/UnionOfPieces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <cstring>
#include <set>
#include <sstream>

namespace orthoslices
{
namespace support
{

namespace
{
bool IsSameTuple(vtkAbstractArray* a, vtkIdType i, vtkAbstractArray* b, vtkIdType j)
{
  const int components = a->GetNumberOfComponents();
  if (auto* numbers = vtkDataArray::SafeDownCast(a))
  {
    auto* others = vtkDataArray::SafeDownCast(b);
    const std::size_t bytes = static_cast<std::size_t>(components) * numbers->GetDataTypeSize();
    return others != nullptr &&
      std::memcmp(numbers->GetVoidPointer(i * components), others->GetVoidPointer(j * components),
        bytes) == 0;
  }
  for (int k = 0; k < components; ++k)
  {
    if (a->GetVariantValue(i * components + k).ToString() !=
      b->GetVariantValue(j * components + k).ToString())
    {
      return false;
    }
  }
  return true;
}

bool IsSameKind(vtkAbstractArray* a, vtkAbstractArray* b)
{
  return b != nullptr && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents();
}

/// Compares what pieces have with one surface, and keeps the first difference.
class UnionCheck
{
public:
  explicit UnionCheck(vtkPolyData* surface)
    : Surface(surface)
    , Owners(surface->GetNumberOfPoints(), 0)
    , Seen(surface->GetNumberOfPoints(), 0)
    , Triangles(surface->GetNumberOfCells(), 0)
  {
  }

  void Add(vtkPolyData* piece, std::size_t rank);
  std::string Finish();

private:
  template <typename... Parts>
  void Differ(const Parts&... parts)
  {
    if (this->Text.empty())
    {
      std::ostringstream text;
      (text << ... << parts);
      this->Text = text.str();
    }
  }
  void ComparePoints(vtkPolyData* piece, vtkIdTypeArray* ids);
  void CompareTriangles(vtkPolyData* piece, vtkIdTypeArray* ofPoints, vtkIdTypeArray* ofCells);
  void CompareArrays(vtkDataSetAttributes* piece, vtkIdTypeArray* ids,
    vtkDataSetAttributes* surface, const char* what);
  void CompareFields(vtkFieldData* piece);

  vtkPolyData* Surface;
  std::vector<int> Owners, Seen, Triangles;
  std::string Text;
};

void UnionCheck::ComparePoints(vtkPolyData* piece, vtkIdTypeArray* ids)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    piece->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (ghosts == nullptr)
  {
    this->Differ("no ghost points are marked");
    return;
  }
  for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
  {
    const vtkIdType id = ids->GetValue(i);
    if (id < 0 || id >= this->Surface->GetNumberOfPoints() ||
      !IsSameTuple(piece->GetPoints()->GetData(), i, this->Surface->GetPoints()->GetData(), id))
    {
      this->Differ("point ", id, " is another one");
      return;
    }
    const bool owned = (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT) == 0;
    this->Owners[id] += owned ? 1 : 0;
    if (owned && this->Seen[id] > 0)
    {
      this->Differ("point ", id, " is not that of the first piece that has it");
    }
    ++this->Seen[id];
  }
}

void UnionCheck::CompareTriangles(
  vtkPolyData* piece, vtkIdTypeArray* ofPoints, vtkIdTypeArray* ofCells)
{
  vtkNew<vtkIdList> own, other;
  for (vtkIdType i = 0; i < piece->GetNumberOfCells(); ++i)
  {
    const vtkIdType id = ofCells->GetValue(i);
    if (id < 0 || id >= this->Surface->GetNumberOfCells())
    {
      this->Differ("there is no triangle ", id);
      return;
    }
    ++this->Triangles[id];
    piece->GetCellPoints(i, own);
    this->Surface->GetCellPoints(id, other);
    for (int k = 0; k < 3; ++k)
    {
      if (ofPoints->GetValue(own->GetId(k)) != other->GetId(k))
      {
        this->Differ("triangle ", id, " has other corners");
      }
    }
  }
}

void UnionCheck::CompareArrays(
  vtkDataSetAttributes* piece, vtkIdTypeArray* ids, vtkDataSetAttributes* surface, const char* what)
{
  std::set<std::string> names;
  for (int a = 0; a < surface->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* whole = surface->GetAbstractArray(a);
    names.insert(whole->GetName());
    vtkAbstractArray* part = piece->GetAbstractArray(whole->GetName());
    if (!IsSameKind(whole, part))
    {
      this->Differ("the ", what, " lack ", whole->GetName());
      return;
    }
    for (vtkIdType i = 0; i < part->GetNumberOfTuples(); ++i)
    {
      if (!IsSameTuple(part, i, whole, ids->GetValue(i)))
      {
        this->Differ(whole->GetName(), " of ", what, " differs at ", ids->GetValue(i));
        return;
      }
    }
  }
  for (int a = 0; a < piece->GetNumberOfArrays(); ++a)
  {
    const std::string name = piece->GetArrayName(a);
    const bool own =
      piece->GetAbstractArray(a) == ids || name == vtkDataSetAttributes::GhostArrayName();
    if (!own && names.count(name) == 0)
    {
      this->Differ("the ", what, " have ", name, ", too");
    }
  }
  if ((piece->GetNormals() == nullptr) != (surface->GetNormals() == nullptr))
  {
    this->Differ("normals are attributes in one only");
  }
}

void UnionCheck::CompareFields(vtkFieldData* piece)
{
  vtkFieldData* whole = this->Surface->GetFieldData();
  if (piece->GetNumberOfArrays() != whole->GetNumberOfArrays())
  {
    this->Differ(
      "there are ", piece->GetNumberOfArrays(), " field arrays, not ", whole->GetNumberOfArrays());
  }
  for (int a = 0; a < whole->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = whole->GetAbstractArray(a);
    vtkAbstractArray* own = piece->GetAbstractArray(array->GetName());
    if (!IsSameKind(array, own) || array->GetNumberOfTuples() != own->GetNumberOfTuples())
    {
      this->Differ("the field array ", array->GetName(), " is another one");
      return;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      if (!IsSameTuple(array, i, own, i))
      {
        this->Differ("the field array ", array->GetName(), " differs");
      }
    }
  }
}

void UnionCheck::Add(vtkPolyData* piece, std::size_t rank)
{
  auto* ofPoints = vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetGlobalIds());
  auto* ofCells = vtkIdTypeArray::SafeDownCast(piece->GetCellData()->GetGlobalIds());
  if (piece->GetNumberOfPoints() == 0 && piece->GetNumberOfCells() == 0)
  {
    return; // what is sent of it has no arrays
  }
  if (ofPoints == nullptr || ofCells == nullptr)
  {
    this->Differ("piece ", rank, " has no global ids");
    return;
  }
  this->ComparePoints(piece, ofPoints);
  this->CompareTriangles(piece, ofPoints, ofCells);
  this->CompareArrays(piece->GetPointData(), ofPoints, this->Surface->GetPointData(), "points");
  this->CompareArrays(piece->GetCellData(), ofCells, this->Surface->GetCellData(), "triangles");
  this->CompareFields(piece->GetFieldData());
}

std::string UnionCheck::Finish()
{
  for (std::size_t i = 0; i < this->Owners.size(); ++i)
  {
    if (this->Owners[i] != 1)
    {
      this->Differ("point ", i, " belongs to ", this->Owners[i], " pieces");
    }
  }
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    if (this->Triangles[i] != 1)
    {
      this->Differ("triangle ", i, " is in ", this->Triangles[i], " pieces");
    }
  }
  return this->Text;
}
}

std::string CompareUnion(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkPolyData* surface)
{
  UnionCheck check(surface);
  for (std::size_t rank = 0; rank < pieces.size(); ++rank)
  {
    check.Add(pieces[rank], rank);
  }
  return check.Finish();
}

} // namespace support
} // namespace orthoslices
