// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ContourArrays.h"

#include "Bridge/ReadPieces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace orthoslices
{
namespace
{
/// The polygonal data of all inputs, and which of them each polyline was read from.
struct Origins
{
  explicit Origins(const std::vector<vtkDataObject*>& inputs);
  void FindLines(const PolylineSources& from);

  std::vector<vtkPolyData*> Data;
  std::map<std::pair<int, Index>, std::size_t> Numbers; ///< in Data, by port and block
  std::vector<std::size_t> OfLine;                      ///< in Data
};

Origins::Origins(const std::vector<vtkDataObject*>& inputs)
{
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    VisitPolyData(inputs[port],
      [&](vtkPolyData* data, Index block)
      {
        this->Numbers[{ static_cast<int>(port), block }] = this->Data.size();
        this->Data.push_back(data);
      });
  }
}

void Origins::FindLines(const PolylineSources& from)
{
  for (std::size_t line = 0; line < from.Cell.size(); ++line)
  {
    this->OfLine.push_back(this->Numbers.at({ from.Port[line], from.Block[line] }));
  }
}

/// The names of all arrays that are no ghost markers.
std::vector<std::string> ListNames(const Origins& origins)
{
  std::vector<std::string> names;
  for (vtkPolyData* data : origins.Data)
  {
    vtkCellData* arrays = data->GetCellData();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      const char* name = arrays->GetArrayName(i);
      if (name != nullptr && *name != '\0' &&
        std::string(name) != vtkDataSetAttributes::GhostArrayName() &&
        std::find(names.begin(), names.end(), name) == names.end())
      {
        names.emplace_back(name);
      }
    }
  }
  return names;
}

bool IsNumeric(vtkAbstractArray* array) { return vtkDataArray::SafeDownCast(array) != nullptr; }

/// An empty array that holds the values of all of some arrays, or null if there is none.
vtkSmartPointer<vtkAbstractArray> NewCommonArray(const std::vector<vtkAbstractArray*>& arrays)
{
  vtkAbstractArray* first = nullptr;
  int type = 0;
  for (vtkAbstractArray* array : arrays)
  {
    if (first == nullptr && array != nullptr)
    {
      first = array;
      type = array->GetDataType();
    }
    else if (array != nullptr && array->GetDataType() != type)
    {
      type = VTK_DOUBLE;
    }
    if (array != nullptr &&
      (array->GetNumberOfComponents() != first->GetNumberOfComponents() ||
        IsNumeric(array) != IsNumeric(first)))
    {
      return nullptr;
    }
  }
  // Bits have no addresses.
  type = type == VTK_BIT ? VTK_UNSIGNED_CHAR : type;
  auto common = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  if (common != nullptr && IsNumeric(common) == IsNumeric(first))
  {
    common->SetName(first->GetName());
    common->SetNumberOfComponents(first->GetNumberOfComponents());
    common->CopyComponentNames(first);
    return common;
  }
  return nullptr;
}

/// Sets all tuples to the one that stands for no value.
void FillWithNull(vtkAbstractArray* array)
{
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    const int type = numbers->GetDataType();
    const bool isFloat = type == VTK_FLOAT || type == VTK_DOUBLE;
    numbers->Fill(isFloat ? std::numeric_limits<double>::quiet_NaN() : 0.0);
  }
}

/// Copies a tuple, also from an array of another type of numbers.
void CopyTuple(vtkAbstractArray* from, vtkIdType tuple, vtkIdType target, vtkAbstractArray* to)
{
  if (from->GetDataType() == to->GetDataType())
  {
    to->SetTuple(target, tuple, from);
    return;
  }
  auto* numbers = vtkDataArray::SafeDownCast(from);
  for (int i = 0; i < from->GetNumberOfComponents(); ++i)
  {
    vtkDataArray::SafeDownCast(to)->SetComponent(target, i, numbers->GetComponent(tuple, i));
  }
}

/// False if the arrays of that name do not go together.
bool ReadArray(const Origins& origins, const PolylineSources& from, ContourArray& read)
{
  std::vector<vtkAbstractArray*> arrays;
  for (vtkPolyData* data : origins.Data)
  {
    arrays.push_back(data->GetCellData()->GetAbstractArray(read.Name.c_str()));
  }
  read.Values = NewCommonArray(arrays);
  if (read.Values == nullptr)
  {
    return false;
  }
  const vtkIdType lines = static_cast<vtkIdType>(from.Cell.size());
  read.Values->SetNumberOfTuples(lines + 1);
  FillWithNull(read.Values);
  read.Has.assign(from.Cell.size(), 0);
  for (vtkIdType line = 0; line < lines; ++line)
  {
    vtkAbstractArray* array = arrays[origins.OfLine[line]];
    if (array != nullptr && from.Cell[line] < array->GetNumberOfTuples())
    {
      CopyTuple(array, from.Cell[line], line, read.Values);
      read.Has[line] = 1;
    }
  }
  return true;
}
}

std::vector<ContourArray> ReadContourArrays(
  const std::vector<vtkDataObject*>& inputs, const PolylineSources& from)
{
  Origins origins(inputs);
  const std::vector<std::string> names = ListNames(origins);
  if (!names.empty())
  {
    origins.FindLines(from);
  }
  std::vector<ContourArray> found;
  for (const std::string& name : names)
  {
    ContourArray array{ name, nullptr, {} };
    if (ReadArray(origins, from, array))
    {
      found.push_back(std::move(array));
    }
  }
  return found;
}
}
