// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/AppendLabels.h"

#include "Bridge/AppendData.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <string>

namespace orthoslices
{
namespace
{
constexpr int SurfacePort = 0;
constexpr int ContourTablePort = 3;
constexpr int ComponentTablePort = 7;

/// An array with one value of `values` in all tuples.
vtkSmartPointer<vtkAbstractArray> Repeat(vtkAbstractArray* values, vtkIdType index, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(values->NewInstance());
  array->SetName("Label");
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetTuple(i, index, values);
  }
  return array;
}

/// The columns of a table after a first one.
void InsertFirstColumn(vtkAbstractArray* first, vtkTable* table)
{
  vtkNew<vtkTable> wider;
  wider->AddColumn(first);
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    wider->AddColumn(table->GetColumn(i));
  }
  table->ShallowCopy(wider);
}

/// A contour table names the axes of slices only where these are not the numbers of the ports; once
/// it is part of another it has to.
void NameSliceAxis(vtkTable* table)
{
  vtkAbstractArray* port = table->GetColumnByName("Port");
  if (table->GetColumnByName("SliceAxis") == nullptr && port != nullptr)
  {
    auto axis = vtkSmartPointer<vtkAbstractArray>::Take(port->NewInstance());
    axis->DeepCopy(port);
    axis->SetName("SliceAxis");
    table->AddColumn(axis);
  }
}

void ShiftComponents(int shift, vtkIntArray* ids)
{
  for (vtkIdType i = 0; ids != nullptr && i < ids->GetNumberOfValues(); ++i)
  {
    const int id = ids->GetValue(i);
    ids->SetValue(i, id < 0 ? id : id + shift);
  }
}

/// A value of the field data of a part.
double ValueOf(vtkPolyData* part, const char* name)
{
  return part->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

/// The measures of all triangles: the smallest, the greatest, a share.
double MergeMeasure(const std::vector<vtkPolyData*>& parts, const std::string& name)
{
  double merged = 0.0;
  vtkIdType triangles = 0;
  for (vtkPolyData* part : parts)
  {
    const vtkIdType count = part->GetNumberOfPolys();
    if (count == 0)
    {
      continue;
    }
    const double value = ValueOf(part, name.c_str());
    merged = name == "LargestAspectRatio" ? std::max(merged, value)
      : name == "SmallestAngle"           ? (triangles == 0 ? value : std::min(merged, value))
                                : (merged * triangles + value * count) / (triangles + count);
    triangles += count;
  }
  return merged;
}

/// Numbers that count, of all parts together.
vtkIdType SumCounts(const std::vector<vtkPolyData*>& parts, const char* name)
{
  vtkIdType sum = 0;
  for (vtkPolyData* part : parts)
  {
    sum += vtkIdTypeArray::SafeDownCast(part->GetFieldData()->GetArray(name))->GetValue(0);
  }
  return sum;
}

double SumColumn(vtkTable* table, const char* name)
{
  auto* column = vtkDoubleArray::SafeDownCast(table->GetColumnByName(name));
  double sum = 0.0;
  for (vtkIdType i = 0; i < column->GetNumberOfValues(); ++i)
  {
    sum += column->GetValue(i);
  }
  return sum;
}
}

LabelOutputs::LabelOutputs(const ContourLabels& labels, vtkInformationVector* outputs)
  : Labels(labels)
  , Outputs(outputs)
{
}

vtkInformationVector* LabelOutputs::Next(Index label)
{
  auto outputs = vtkSmartPointer<vtkInformationVector>::New();
  for (int port = 0; port < this->Outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkNew<vtkInformation> info;
    const auto data = vtkSmartPointer<vtkDataObject>::Take(
      vtkDataObject::GetData(this->Outputs, port)->NewInstance());
    info->Set(vtkDataObject::DATA_OBJECT(), data);
    outputs->Append(info);
  }
  this->Parts.push_back({ label, outputs });
  return outputs;
}

void LabelOutputs::Finish()
{
  this->NumberComponents();
  for (const Part& part : this->Parts)
  {
    this->AddLabels(part);
  }
  this->AppendFieldData();
  this->AddLabelSums();
  for (int port = 0; port < this->Outputs->GetNumberOfInformationObjects(); ++port)
  {
    this->AppendPort(port);
  }
}

void LabelOutputs::NumberComponents()
{
  int before = 0;
  for (const Part& part : this->Parts)
  {
    for (int port = 0; port < part.Outputs->GetNumberOfInformationObjects(); ++port)
    {
      auto* data = vtkPolyData::GetData(part.Outputs, port);
      auto* table = vtkTable::GetData(part.Outputs, port);
      ShiftComponents(before,
        vtkIntArray::SafeDownCast(data != nullptr
            ? data->GetCellData()->GetAbstractArray("ComponentId")
            : table->GetColumnByName("ComponentId")));
    }
    before += static_cast<int>(
      ValueOf(vtkPolyData::GetData(part.Outputs, SurfacePort), "NumberOfComponents"));
  }
}

void LabelOutputs::AddLabels(const Part& part)
{
  vtkSmartPointer<vtkAbstractArray> values = this->Labels.Values;
  vtkNew<vtkIntArray> numbers;
  if (this->Labels.AreNames())
  {
    for (Index i = 0; i < this->Labels.Count(); ++i)
    {
      numbers->InsertNextValue(i);
    }
    values = numbers;
  }
  NameSliceAxis(vtkTable::GetData(part.Outputs, ContourTablePort));
  for (int port = 0; port < part.Outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (auto* data = vtkPolyData::GetData(part.Outputs, port))
    {
      data->GetCellData()->AddArray(Repeat(values, part.Label, data->GetNumberOfCells()));
    }
    if (auto* table = vtkTable::GetData(part.Outputs, port))
    {
      InsertFirstColumn(Repeat(this->Labels.Values, part.Label, table->GetNumberOfRows()), table);
    }
  }
}

void LabelOutputs::AppendPort(int port)
{
  std::vector<vtkPolyData*> data;
  std::vector<vtkTable*> tables;
  for (const Part& part : this->Parts)
  {
    data.push_back(vtkPolyData::GetData(part.Outputs, port));
    tables.push_back(vtkTable::GetData(part.Outputs, port));
  }
  if (auto* whole = vtkPolyData::GetData(this->Outputs, port))
  {
    AppendPolyData(data, whole);
    whole->GetPointData()->SetActiveNormals("Normals");
    // What ParaView colors by when it shows them first.
    whole->GetCellData()->SetActiveScalars(port == SurfacePort ? "Label" : "SliceRmsDisagreement");
  }
  else
  {
    AppendTables(tables, vtkTable::GetData(this->Outputs, port));
  }
  for (const Part& part : this->Parts)
  {
    vtkDataObject::GetData(part.Outputs, port)->Initialize(); // not twice in memory any longer
  }
}

void LabelOutputs::AppendFieldData()
{
  std::vector<vtkPolyData*> parts;
  for (const Part& part : this->Parts)
  {
    parts.push_back(vtkPolyData::GetData(part.Outputs, SurfacePort));
  }
  if (parts.empty())
  {
    return;
  }
  vtkFieldData* first = parts.front()->GetFieldData();
  vtkFieldData* whole = vtkPolyData::GetData(this->Outputs, SurfacePort)->GetFieldData();
  for (int i = 0; i < first->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = first->GetAbstractArray(i);
    auto merged = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    merged->DeepCopy(array);
    auto* counts = vtkIdTypeArray::SafeDownCast(merged);
    auto* measures = vtkDoubleArray::SafeDownCast(merged);
    if (counts != nullptr && counts->GetNumberOfValues() == 1)
    {
      counts->SetValue(0, SumCounts(parts, array->GetName()));
    }
    else if (measures != nullptr && measures->GetNumberOfValues() == 1)
    {
      measures->SetValue(0, MergeMeasure(parts, array->GetName()));
    }
    whole->AddArray(merged); // what has more values is the same for all labels
  }
}

void LabelOutputs::AddLabelSums()
{
  vtkNew<vtkStringArray> names;
  vtkNew<vtkDoubleArray> area, volume;
  names->SetName("LabelNames");
  area->SetName("LabelArea");
  volume->SetName("LabelVolume");
  area->SetNumberOfValues(this->Labels.Count());
  volume->SetNumberOfValues(this->Labels.Count());
  area->Fill(0.0);
  volume->Fill(0.0);
  for (Index label = 0; label < this->Labels.Count(); ++label)
  {
    names->InsertNextValue(this->Labels.NameOf(label));
  }
  for (const Part& part : this->Parts)
  {
    vtkTable* table = vtkTable::GetData(part.Outputs, ComponentTablePort);
    area->SetValue(part.Label, SumColumn(table, "Area"));
    volume->SetValue(part.Label, SumColumn(table, "Volume"));
  }
  vtkFieldData* whole = vtkPolyData::GetData(this->Outputs, SurfacePort)->GetFieldData();
  whole->AddArray(names);
  whole->AddArray(area);
  whole->AddArray(volume);
}
}
