// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/CarryFieldData.h"

#include "Bridge/ReadPieces.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace orthoslices
{
namespace
{
/// The names of the input ports within those of arrays.
constexpr const char* PortNames[] = { "X", "Y", "Z", "Contours" };

struct FieldArray
{
  int Port;
  Index Block;
  vtkAbstractArray* Array;
};

/// All arrays of one name.
using SameName = std::vector<FieldArray>;

bool IsSameNumber(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool IsSame(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (a == b)
  {
    return true;
  }
  if (a->GetDataType() != b->GetDataType() || a->GetNumberOfTuples() != b->GetNumberOfTuples() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return false;
  }
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    const vtkVariant p = a->GetVariantValue(i), q = b->GetVariantValue(i);
    const bool areFloats = p.IsFloat() || p.IsDouble();
    if (areFloats ? !IsSameNumber(p.ToDouble(), q.ToDouble()) : p != q)
    {
      return false;
    }
  }
  return true;
}

bool AreSame(const SameName& arrays)
{
  return std::all_of(arrays.begin(), arrays.end(),
    [&](const FieldArray& array) { return IsSame(array.Array, arrays.front().Array); });
}

/// The arrays that have names, by these, in the order of the inputs.
std::vector<SameName> ListArrays(const std::vector<vtkDataObject*>& inputs)
{
  std::vector<SameName> names;
  const auto add = [&](int port, Index block, vtkFieldData* data)
  {
    for (int i = 0; data != nullptr && i < data->GetNumberOfArrays(); ++i)
    {
      const char* name = data->GetArrayName(i);
      if (name == nullptr || *name == '\0')
      {
        continue;
      }
      auto same = std::find_if(names.begin(), names.end(),
        [&](const SameName& arrays)
        { return std::string(arrays.front().Array->GetName()) == name; });
      same = same == names.end() ? names.insert(same, SameName()) : same;
      same->push_back({ port, block, data->GetAbstractArray(i) });
    }
  };
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    const int number = static_cast<int>(port);
    if (inputs[port] != nullptr && vtkPolyData::SafeDownCast(inputs[port]) == nullptr)
    {
      add(number, 0, inputs[port]->GetFieldData());
    }
    VisitPolyData(inputs[port],
      [&](vtkPolyData* data, Index block) { add(number, block, data->GetFieldData()); });
  }
  return names;
}

/// Adds field data to both outputs.
class FieldWriter
{
public:
  FieldWriter(vtkPolyData* surface, vtkPolyData* graph)
    : Surface(surface->GetFieldData())
    , Graph(graph->GetFieldData())
  {
  }

  void Add(const SameName& arrays);

private:
  void AddPort(const SameName& arrays);
  void AddArray(vtkAbstractArray* array, std::string name);

  vtkFieldData* Surface;
  vtkFieldData* Graph;
};

void FieldWriter::AddArray(vtkAbstractArray* array, std::string name)
{
  while (this->Surface->HasArray(name.c_str()) || this->Graph->HasArray(name.c_str()))
  {
    name = "Input" + name;
  }
  vtkSmartPointer<vtkAbstractArray> named = array;
  if (name != array->GetName())
  {
    named.TakeReference(array->NewInstance());
    named->DeepCopy(array);
    named->SetName(name.c_str());
  }
  this->Graph->AddArray(named);
  if (std::string(array->GetName()) != "PlaneCoordinates")
  {
    this->Surface->AddArray(named);
  }
}

/// Adds those of one port.
void FieldWriter::AddPort(const SameName& arrays)
{
  const bool areSame = AreSame(arrays);
  for (const FieldArray& array : arrays)
  {
    const std::string name = array.Array->GetName();
    const std::string block = areSame ? "" : "Block" + std::to_string(array.Block);
    this->AddArray(array.Array, PortNames[array.Port] + block + name);
    if (areSame)
    {
      return;
    }
  }
}

void FieldWriter::Add(const SameName& arrays)
{
  if (AreSame(arrays))
  {
    this->AddArray(arrays.front().Array, arrays.front().Array->GetName());
    return;
  }
  for (auto first = arrays.begin(); first != arrays.end();)
  {
    const auto end = std::find_if(
      first, arrays.end(), [&](const FieldArray& array) { return array.Port != first->Port; });
    this->AddPort(SameName(first, end));
    first = end;
  }
}
}

void ClearFieldData(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->GetFieldData()->Initialize();
  }
}

void ClearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

void CarryFieldData(
  const std::vector<vtkDataObject*>& inputs, vtkPolyData* surface, vtkPolyData* graph)
{
  FieldWriter writer(surface, graph);
  for (const SameName& arrays : ListArrays(inputs))
  {
    writer.Add(arrays);
  }
}
}
