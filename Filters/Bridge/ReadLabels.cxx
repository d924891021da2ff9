// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ReadLabels.h"

#include "Bridge/ReadPieces.h"
#include "Core/Frames/SplitByLabel.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace orthoslices
{
namespace
{
/// The label arrays by port and block.
using LabelArrays = std::map<std::pair<int, Index>, vtkAbstractArray*>;

LabelArrays FindArrays(const std::vector<vtkDataObject*>& inputs, const std::string& name)
{
  LabelArrays arrays;
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    VisitPolyData(inputs[port],
      [&](vtkPolyData* data, Index block)
      {
        if (auto* array = data->GetCellData()->GetAbstractArray(name.c_str()))
        {
          arrays[{ static_cast<int>(port), block }] = array;
        }
      });
  }
  return arrays;
}

/// A value as text; small integer types are numbers here, not characters.
std::string TextOf(const vtkVariant& value)
{
  if (!value.IsNumeric())
  {
    return value.ToString();
  }
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::digits10) << value.ToDouble();
  return text.str();
}

/// The value of each polyline, by `valueOf(array, index)`; `none` where there is no array.
template <typename Value, typename ValueOf>
std::vector<Value> ReadValues(
  const LabelArrays& arrays, const PolylineSources& from, const Value& none, ValueOf&& valueOf)
{
  std::vector<Value> values(from.Cell.size(), none);
  for (std::size_t line = 0; line < values.size(); ++line)
  {
    const auto found = arrays.find({ from.Port[line], from.Block[line] });
    if (found != arrays.end())
    {
      const vtkIdType components = found->second->GetNumberOfComponents();
      values[line] = valueOf(found->second, components * from.Cell[line]);
    }
  }
  return values;
}

/// Numbers the values that are labels in ascending order, and returns each of them once.
template <typename Value, typename IsLabel>
std::vector<Value> NumberLabels(
  const std::vector<Value>& values, IsLabel&& isLabel, ContourLabels& labels)
{
  std::vector<Value> distinct;
  std::copy_if(values.begin(), values.end(), std::back_inserter(distinct), isLabel);
  labels.Unlabelled = static_cast<Index>(values.size() - distinct.size());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  for (const Value& value : values)
  {
    labels.OfLine.push_back(isLabel(value)
        ? static_cast<Index>(
            std::lower_bound(distinct.begin(), distinct.end(), value) - distinct.begin())
        : NoLabel);
  }
  return distinct;
}

void ReadNames(const LabelArrays& arrays, const PolylineSources& from, ContourLabels& labels)
{
  const auto values = ReadValues(arrays, from, std::string(),
    [](vtkAbstractArray* array, vtkIdType i) { return TextOf(array->GetVariantValue(i)); });
  auto names = vtkSmartPointer<vtkStringArray>::New();
  for (const std::string& name : NumberLabels(
         values, [](const std::string& name) { return !name.empty(); }, labels))
  {
    names->InsertNextValue(name);
  }
  labels.Values = names;
}

void ReadNumbers(const LabelArrays& arrays, const PolylineSources& from, ContourLabels& labels)
{
  const auto values = ReadValues(arrays, from, std::nan(""),
    [](vtkAbstractArray* array, vtkIdType i)
    {
      const vtkIdType components = array->GetNumberOfComponents();
      return static_cast<vtkDataArray*>(array)->GetComponent(i / components, 0) + 0.0;
    });
  int type = arrays.begin()->second->GetDataType();
  for (const auto& array : arrays)
  {
    type = array.second->GetDataType() == type ? type : VTK_DOUBLE;
  }
  auto numbers = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  for (const double number : NumberLabels(
         values, [](double value) { return std::isfinite(value); }, labels))
  {
    numbers->InsertNextTuple1(number);
  }
  labels.Values = numbers;
}
}

bool ContourLabels::AreNames() const
{
  return vtkStringArray::SafeDownCast(this->Values) != nullptr;
}

std::string ContourLabels::NameOf(Index label) const
{
  return TextOf(this->Values->GetVariantValue(label));
}

ContourLabels ReadLabels(const std::vector<vtkDataObject*>& inputs, const std::string& arrayName,
  const PolylineSources& from)
{
  ContourLabels labels;
  const LabelArrays arrays = FindArrays(inputs, arrayName);
  if (arrays.empty())
  {
    return labels;
  }
  const bool anyNames = std::any_of(arrays.begin(), arrays.end(),
    [](const auto& array) { return vtkDataArray::SafeDownCast(array.second) == nullptr; });
  if (anyNames)
  {
    ReadNames(arrays, from, labels);
  }
  else
  {
    ReadNumbers(arrays, from, labels);
  }
  return labels;
}
}
