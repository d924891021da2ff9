// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One line with a number for every run of the filters on files: all that they write, bit by bit.
 *
 *   HashOutputs [--quick] [--all-triangles] FOLDER ...
 *
 * Shows that a change of the code changes no result: print the lines before and after, and compare
 * them with diff. The number depends on compiler, processor and VTK, so it is no golden value.
 *
 * A folder has contours in files that end in x.vtp, y.vtp or z.vtp; what stands before that names a
 * set. Each set is tried with one, two and three of its families, with noise, rounded to float, and
 * with every value of every enumeration; --quick leaves the latter out for sets named n32_.
 * --all-triangles switches Automatic Accuracy off in all runs. A surface, truth.vtp, is sliced, and
 * so is a distance volume of its box.
 */

#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace
{
using Filter = vtkOrthogonalSliceReconstruction;
using Contours = std::array<vtkSmartPointer<vtkPolyData>, 3>;

/// FNV-1a, 64 bits.
class Hash
{
public:
  void Add(const void* data, std::size_t size)
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Value = (this->Value ^ bytes[i]) * 1099511628211ull;
    }
  }
  void Add(const char* text) { this->Add(text ? text : "", text ? std::strlen(text) : 0); }

  void Add(vtkAbstractArray* array)
  {
    this->Add(array->GetName());
    const int shape[] = { array->GetDataType(), array->GetNumberOfComponents() };
    this->Add(shape, sizeof shape);
    if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(array))
    {
      this->Add(numbers->GetVoidPointer(0),
        static_cast<std::size_t>(numbers->GetNumberOfValues()) * numbers->GetDataTypeSize());
      return;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      this->Add(array->GetVariantValue(i).ToString().c_str());
    }
  }

  void Add(vtkFieldData* arrays)
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      this->Add(arrays->GetAbstractArray(i));
    }
  }

  void Add(vtkCellArray* cells)
  {
    this->Add(cells->GetOffsetsArray());
    this->Add(cells->GetConnectivityArray());
  }

  void Add(vtkDataObject* object)
  {
    this->Add(object->GetFieldData());
    if (vtkTable* table = vtkTable::SafeDownCast(object))
    {
      this->Add(table->GetRowData());
    }
    if (vtkPolyData* data = vtkPolyData::SafeDownCast(object))
    {
      this->Add(data->GetPointData());
      this->Add(data->GetCellData());
      this->Add(data->GetLines());
      this->Add(data->GetPolys());
      if (data->GetPoints())
      {
        this->Add(data->GetPoints()->GetData());
      }
    }
  }

  unsigned long long Get() const { return this->Value; }

private:
  std::uint64_t Value = 14695981039346656037ull;
};

void Print(const std::string& name, vtkAlgorithm* algorithm)
{
  algorithm->Update();
  std::printf("%-48s", name.c_str());
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    Hash hash;
    hash.Add(algorithm->GetOutputDataObject(port));
    std::printf(" %016llx", hash.Get());
  }
  std::printf("\n");
  std::fflush(stdout);
}

struct Setting
{
  const char* Name;
  std::function<void(Filter*)> Apply;
};

const std::vector<Setting>& ListSettings()
{
  static const std::vector<Setting> settings{
    { "AsDrawn", [](Filter* f) { f->SetOrientationToAsDrawn(); } },
    { "InvalidLeaveOut", [](Filter* f) { f->SetInvalidContoursToLeaveOut(); } },
    { "CrossingRefuse", [](Filter* f) { f->SetCrossingContoursToRefuse(); } },
    { "CrossingLeaveOut", [](Filter* f) { f->SetCrossingContoursToLeaveOut(); } },
    { "Discs", [](Filter* f) { f->SetSeveralCyclesToDiscs(); } },
    { "Overlap", [](Filter* f) { f->SetCorrespondenceToOverlap(); } },
    { "Cylinders", [](Filter* f) { f->SetCorrespondenceToEllipticalCylinders(); } },
    { "SpanningTree", [](Filter* f) { f->SetCorrespondenceToSpanningTree(); } },
    { "ReebGraph", [](Filter* f) { f->SetCorrespondenceToReebGraph(); } },
    { "Fan", [](Filter* f) { f->SetPatchTypeToFan(); } },
    { "Coons", [](Filter* f) { f->SetPatchTypeToCoons(); } },
    { "FanCentroid",
      [](Filter* f)
      {
        f->SetPatchTypeToFan();
        f->SetCentralPointToCentroid();
      } },
    { "Expected",
      [](Filter* f)
      {
        f->SetExpectedComponents(1);
        f->SetExpectedGenus(1);
      } },
    { "Minimum",
      [](Filter* f)
      {
        f->SetMinimumComponentSize(0.2);
        f->SetMinimumIsolatedContourSize(0.01);
      } },
    { "Smoothing", [](Filter* f) { f->SetSmoothing(1.0); } },
    { "ContourTolerance",
      [](Filter* f)
      {
        f->SetContourTolerance(0.02);
        f->SetEdgeLength(0.5);
      } },
    { "ChordTolerance",
      [](Filter* f)
      {
        f->SetChordTolerance(0.02);
        f->SetCornerAngle(30.0);
      } },
    { "Accuracy", [](Filter* f) { f->SetAccuracy(0.05); } },
    { "AllTriangles", [](Filter* f) { f->AutomaticAccuracyOff(); } },
    { "Weights", [](Filter* f) { f->SetAxisWeights(1.0, 2.0, 0.0); } },
    { "Curvatures", [](Filter* f) { f->ComputeCurvaturesOn(); } },
    { "NoNormals", [](Filter* f) { f->ComputeNormalsOff(); } },
    { "Single", [](Filter* f) { f->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION); } },
    { "PlaneTolerance",
      [](Filter* f)
      {
        f->SetPlaneTolerance(1e-3);
        f->SetReportTolerance(0.0);
      } },
  };
  return settings;
}

/// Whether Automatic Accuracy is off, for all runs.
bool allTriangles = false;

void Reconstruct(
  const std::string& name, const Contours& contours, int families,
  const std::function<void(Filter*)>& apply = [](Filter*) {})
{
  vtkNew<Filter> filter;
  filter->SetAutomaticAccuracy(!allTriangles);
  apply(filter);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (contours[axis] && (families & (1 << axis)) != 0)
    {
      filter->SetInputData(axis, contours[axis]);
    }
  }
  Print(name, filter);
}

double SpacingOf(const Contours& contours)
{
  double longest = 0.0;
  for (const auto& set : contours)
  {
    longest = set ? std::max(longest, set->GetLength()) : longest;
  }
  return longest / 50.0;
}

/// Every vertex is moved within its plane by up to a part of a spacing.
Contours AddNoise(const Contours& contours, double maximum)
{
  Contours noisy;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!contours[axis])
    {
      continue;
    }
    noisy[axis] = vtkSmartPointer<vtkPolyData>::New();
    noisy[axis]->DeepCopy(contours[axis]);
    vtkPoints* points = noisy[axis]->GetPoints();
    std::mt19937 random(axis + 1);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double x[3];
      points->GetPoint(i, x);
      for (const int a : { (axis + 1) % 3, (axis + 2) % 3 })
      {
        x[a] += maximum * (random() * 0x1p-31 - 1.0);
      }
      points->SetPoint(i, x);
    }
  }
  return noisy;
}

vtkSmartPointer<vtkPolyData> Read(const std::string& file)
{
  if (!std::filesystem::exists(file))
  {
    return nullptr;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

void TrySet(const std::string& name, const Contours& contours, bool all)
{
  const int present = (contours[0] ? 1 : 0) + (contours[1] ? 2 : 0) + (contours[2] ? 4 : 0);
  for (int families = 1; families < 8; ++families)
  {
    if ((families & present) == families)
    {
      std::string label = name + " ";
      for (int axis = 0; axis < 3; ++axis)
      {
        label += (families & (1 << axis)) != 0 ? std::string(1, "xyz"[axis]) : "";
      }
      Reconstruct(label, contours, families);
    }
  }
  if (!all)
  {
    return;
  }
  const Contours noisy = AddNoise(contours, 0.05 * SpacingOf(contours));
  Reconstruct(name + " noise", noisy, 7);
  Reconstruct(name + " more noise", AddNoise(contours, 0.4 * SpacingOf(contours)), 7);
  for (const Setting& setting : ListSettings())
  {
    Reconstruct(name + " " + setting.Name, contours, 7, setting.Apply);
    Reconstruct(name + " noise " + setting.Name, noisy, 7, setting.Apply);
    for (int axis = 0; axis < 3; ++axis)
    {
      // One family takes other ways through the code; of the axes only one each.
      if (contours[axis] && (axis == 2 || present == 1 << axis))
      {
        Reconstruct(name + " one " + setting.Name, contours, 1 << axis, setting.Apply);
      }
    }
  }
}

void TrySlicer(const std::string& name, vtkPolyData* surface)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(surface);
  Print(name + " sliced", slicer);

  double bounds[6];
  surface->GetBounds(bounds);
  vtkNew<vtkImageData> image;
  image->SetDimensions(24, 20, 16);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  image->SetSpacing(
    (bounds[1] - bounds[0]) / 23.0, (bounds[3] - bounds[2]) / 19.0, (bounds[5] - bounds[4]) / 15.0);
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double scale = 25.0 / surface->GetLength();
    values->InsertNextValue(
      std::sin(scale * x[0]) + std::cos(scale * x[1]) + std::sin(scale * x[2]));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkOrthogonalSlicer> ofImage;
  ofImage->SetInputData(image);
  Print(name + " image sliced", ofImage);
}
}

int main(int argc, char* argv[])
{
  vtkObject::GlobalWarningDisplayOff();
  bool quick = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string folder = argv[i];
    if (folder == "--quick")
    {
      quick = true;
      continue;
    }
    if (folder == "--all-triangles")
    {
      allTriangles = true;
      continue;
    }
    const std::string label = std::filesystem::path(folder).filename().string();
    std::set<std::string> sets;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
      const std::string file = entry.path().filename().string();
      if (file.size() >= 5 && file.substr(file.size() - 4) == ".vtp" &&
        std::strchr("xyz", file[file.size() - 5]) != nullptr)
      {
        sets.insert(file.substr(0, file.size() - 5));
      }
    }
    for (const std::string& set : sets)
    {
      Contours contours;
      for (int axis = 0; axis < 3; ++axis)
      {
        contours[axis] = Read(folder + "/" + set + "xyz"[axis] + ".vtp");
      }
      TrySet(label + " " + set, contours, !quick || set.find("32") == std::string::npos);
    }
    if (const auto truth = Read(folder + "/truth.vtp"))
    {
      TrySlicer(label, truth);
    }
  }
  return 0;
}
