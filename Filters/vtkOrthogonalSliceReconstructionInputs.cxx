// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
// What vtkOrthogonalSliceReconstruction reads from the inputs of its ports.
#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/ReadLabels.h"
#include "Bridge/ReadPieces.h"
#include "Core/Frames/SortByPlanes.h"
#include "Core/ReconstructSorted.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

#include <limits>
#include <set>

namespace
{
/// More contour vertices than that do not fit into the core's numbers.
constexpr vtkIdType MaxVertices = std::numeric_limits<orthoslices::Index>::max() / 8;
}

/// The inputs of all ports, those of all processes while these make a surface together; null where
/// there is none.
std::vector<vtkDataObject*> vtkOrthogonalSliceReconstruction::ListInputs()
{
  std::vector<vtkDataObject*> inputs;
  if (!this->GatheredInputs.empty())
  {
    inputs.assign(this->GatheredInputs.begin(), this->GatheredInputs.end());
    return inputs;
  }
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    const bool isConnected = this->GetNumberOfInputConnections(port) > 0;
    inputs.push_back(isConnected ? this->GetInputDataObject(port, 0) : nullptr);
  }
  return inputs;
}

vtkStringArray* vtkOrthogonalSliceReconstruction::GetCellArrayNames()
{
  std::set<std::string> names;
  for (vtkDataObject* input : this->ListInputs())
  {
    orthoslices::VisitPolyData(input,
      [&](vtkPolyData* data, orthoslices::Index)
      {
        for (int i = 0; i < data->GetCellData()->GetNumberOfArrays(); ++i)
        {
          const char* name = data->GetCellData()->GetArrayName(i);
          names.insert(name != nullptr ? name : "");
        }
      });
  }
  names.erase("");
  this->CellArrayNames->Reset();
  for (const std::string& name : names)
  {
    this->CellArrayNames->InsertNextValue(name);
  }
  return this->CellArrayNames;
}

/// There are contours on some port, and not too many. Empty ports are as good as unconnected ones.
bool vtkOrthogonalSliceReconstruction::CheckInputs(const std::vector<vtkDataObject*>& inputs)
{
  if (this->GetTotalNumberOfInputConnections() == 0)
  {
    vtkErrorMacro(
      "No input: connect contours to port 0 (x-slices), 1 (y-slices), 2 (z-slices) or 3 "
      "(slices of any families).");
    return false;
  }
  vtkIdType cells = 0, vertices = 0;
  for (vtkDataObject* input : inputs)
  {
    orthoslices::VisitPolyData(input,
      [&](vtkPolyData* data, orthoslices::Index)
      {
        cells += data->GetNumberOfLines() + data->GetNumberOfPolys();
        vertices += data->GetLines()->GetNumberOfConnectivityIds() +
          data->GetPolys()->GetNumberOfConnectivityIds();
      });
  }
  if (cells == 0)
  {
    vtkErrorMacro("The input has no contours: no lines and no polygons on any port.");
    return false;
  }
  if (vertices > MaxVertices)
  {
    vtkErrorMacro(
      "The input has " << vertices << " contour vertices, more than " << MaxVertices << ".");
    return false;
  }
  return true;
}

/// The contours of all ports by the planes that they lie on.
orthoslices::SortedSlices vtkOrthogonalSliceReconstruction::SortInputs(
  const std::vector<vtkDataObject*>& inputs) const
{
  orthoslices::Polylines lines;
  const bool round = this->OutputPointsPrecision == SINGLE_PRECISION;
  for (int port = 0; port < static_cast<int>(inputs.size()); ++port)
  {
    orthoslices::ReadPieces(inputs[port], port, !round, lines);
  }
  return orthoslices::SortByPlanes(lines, this->GetFrameOptions());
}

bool vtkOrthogonalSliceReconstruction::NeedsDoublePrecision(
  const std::vector<vtkDataObject*>& inputs, const orthoslices::SortedSlices& sorted)
{
  if (this->OutputPointsPrecision != DEFAULT_PRECISION)
  {
    return this->OutputPointsPrecision == DOUBLE_PRECISION;
  }
  // Turned back, coordinates are no values of float any more.
  bool anyDouble = !sorted.Frame.IsWorld();
  for (vtkDataObject* input : inputs)
  {
    orthoslices::VisitPolyData(input,
      [&](vtkPolyData* data, orthoslices::Index) {
        anyDouble |= data->GetPoints() != nullptr && data->GetPoints()->GetDataType() == VTK_DOUBLE;
      });
  }
  return anyDouble || !orthoslices::HasRoomInSinglePrecision(sorted, this->PlaneTolerance);
}

/// The labels of all contours; an error and no labels if there are none.
orthoslices::ContourLabels vtkOrthogonalSliceReconstruction::ReadLabels(
  const std::vector<vtkDataObject*>& inputs, const orthoslices::SortedSlices& sorted)
{
  const orthoslices::ContourLabels labels =
    orthoslices::ReadLabels(inputs, this->LabelArray, sorted.From);
  if (labels.Count() == 0)
  {
    vtkErrorMacro("No contour has a label in a cell array \"" << this->LabelArray << "\".");
  }
  else if (labels.Unlabelled > 0)
  {
    this->Warn(std::to_string(labels.Unlabelled) + " contours have no label in the cell array \"" +
      this->LabelArray + "\" and take no part in any surface.");
  }
  return labels;
}
