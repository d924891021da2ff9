// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CaseFolder.h"

#include "PlanarContours.h"

#include "vtkNew.h"
#include "vtkOrthogonalSlicer.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace orthoslices
{
namespace baselines
{
namespace
{

namespace fs = std::filesystem;

//------------------------------------------------------------------------------
bool IsCase(const fs::path& folder)
{
  return fs::exists(folder / "truth.vtp") &&
    (fs::exists(folder / "n16_z.vtp") || fs::exists(folder / "n32_z.vtp"));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadFile(const fs::path& file)
{
  if (!fs::exists(file))
  {
    throw std::runtime_error("there is no file " + file.string());
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.string().c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || !data || data->GetNumberOfCells() == 0)
  {
    throw std::runtime_error("cannot read any cells from " + file.string());
  }
  return data;
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::vector<std::string> ListCases(const std::string& folder)
{
  if (!fs::is_directory(folder))
  {
    throw std::runtime_error("there is no folder " + folder);
  }
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    if (entry.is_directory() && IsCase(entry.path()))
    {
      names.push_back(entry.path().filename().string());
    }
  }
  if (names.empty())
  {
    throw std::runtime_error("no folder in " + folder + " holds truth.vtp and contours");
  }
  std::sort(names.begin(), names.end());
  return names;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadTruth(const std::string& folder, const std::string& name)
{
  return ReadFile(fs::path(folder) / name / "truth.vtp");
}

//------------------------------------------------------------------------------
SliceSets ReadSlices(const std::string& folder, const std::string& name, int number)
{
  SliceSets slices;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string file = "n" + std::to_string(number) + "_" + "xyz"[axis] + ".vtp";
    slices.Families[axis] = ReadFile(fs::path(folder) / name / file);
  }
  return slices;
}

//------------------------------------------------------------------------------
SliceSets CutSurface(vtkPolyData* surface, const std::array<int, 3>& numbers)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(surface);
  slicer->SetPlaneModeToNumber();
  slicer->SetNumberOfSlices(numbers[0], numbers[1], numbers[2]);
  slicer->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  slicer->Update();
  SliceSets slices;
  for (int axis = 0; axis < 3; ++axis)
  {
    slices.Families[axis] = vtkSmartPointer<vtkPolyData>::New();
    slices.Families[axis]->ShallowCopy(slicer->GetOutput(axis));
  }
  return slices;
}

//------------------------------------------------------------------------------
double SpacingOf(vtkPolyData* contours, int axis)
{
  const std::vector<Slice> slices = ExtractSlices(contours, axis);
  if (slices.size() < 2)
  {
    return 0.0;
  }
  return (slices.back().Coordinate - slices.front().Coordinate) /
    static_cast<double>(slices.size() - 1);
}

//------------------------------------------------------------------------------
double MeanSpacing(const SliceSets& slices)
{
  double product = 1.0;
  int count = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = SpacingOf(slices.Families[axis], axis);
    product *= spacing > 0.0 ? spacing : 1.0;
    count += spacing > 0.0;
  }
  return count > 0 ? std::pow(product, 1.0 / count) : 0.0;
}

} // namespace baselines
} // namespace orthoslices
