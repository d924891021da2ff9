// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Vtk/DataSets.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <stdexcept>

namespace orthoslices
{
namespace support
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadFile(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfCells() == 0)
  {
    throw std::runtime_error("Cannot read " + path);
  }
  return reader->GetOutput();
}

std::string FolderOf(const DataSet& data)
{
  return std::string(ORTHOGONAL_SLICES_DATA_DIR) + "/" + data.Name + "/";
}

/// Polylines that repeat their first point, without the repetition.
void AddLines(vtkPolyData* lines, Pieces& pieces)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    lines->GetCellPoints(cell, ids);
    std::vector<std::array<double, 2>> vertices;
    double x[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      lines->GetPoint(ids->GetId(i), x);
      vertices.push_back({ x[FirstAxis(pieces.Axis)], x[SecondAxis(pieces.Axis)] });
    }
    AddPiece(pieces, vertices, x[pieces.Axis]);
  }
}
}

std::vector<DataSet> AllDataSets()
{
  return { { "aorta", 1, 0, true }, { "boot", 1, 12, true }, { "heart", 1, 1, true },
    { "knot", 1, 1, true }, { "lbl_lumbar3", 1, 1, false }, { "lbl_stomach", 1, 0, false },
    { "neuron", 1, 12, true }, { "pelvis", 2, 0, true }, { "skull", 1, 2, true } };
}

vtkSmartPointer<vtkPolyData> ReadContours(const DataSet& data, int count, int axis)
{
  return ReadFile(FolderOf(data) + "n" + std::to_string(count) + "_" + "xyz"[axis] + ".vtp");
}

PieceSets ReadPieceSets(const DataSet& data, int count)
{
  PieceSets sets = EmptySets();
  for (int axis = 0; axis < 3; ++axis)
  {
    AddLines(ReadContours(data, count, axis), sets[axis]);
  }
  return sets;
}

vtkSmartPointer<vtkPolyData> ReadTruth(const DataSet& data)
{
  return ReadFile(FolderOf(data) + "truth.vtp");
}

} // namespace support
} // namespace orthoslices
