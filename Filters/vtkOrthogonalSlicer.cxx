// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrthogonalSlicer.h"

#include "Bridge/CarryFieldData.h"
#include "Bridge/DescribeReport.h"
#include "Bridge/ExecuteWithVtk.h"
#include "Bridge/ImageFrame.h"
#include "Bridge/PassPointData.h"
#include "Bridge/ReadSamples.h"
#include "Bridge/ReadTriangles.h"
#include "Bridge/WriteContours.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkOrthogonalSlicer);

using namespace orthoslices;

namespace
{
/// More planes than this on one axis are taken for a mistake.
constexpr double MaximumPlanes = 100000;

//----------------------------------------------------------------------------
/// Planes that fall together when they are rounded become one.
void RoundPlanes(Precision precision, std::vector<double>& planes)
{
  for (double& plane : planes)
  {
    plane = RoundTo(precision, plane) + 0.0; // + 0.0 turns -0.0 into 0.0
  }
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
}

}

//----------------------------------------------------------------------------
vtkOrthogonalSlicer::vtkOrthogonalSlicer()
{
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------
void vtkOrthogonalSlicer::SetNumberOfCoordinates(int axis, int number)
{
  if (axis < 0 || axis > 2 || number < 0)
  {
    vtkErrorMacro("Axis " << axis << " must be 0, 1 or 2, and the number of coordinates " << number
                          << " not negative.");
    return;
  }
  if (this->Coordinates[axis].size() != static_cast<std::size_t>(number))
  {
    this->Coordinates[axis].resize(static_cast<std::size_t>(number), 0.0);
    this->Modified();
  }
}

//----------------------------------------------------------------------------
int vtkOrthogonalSlicer::GetNumberOfCoordinates(int axis)
{
  return axis < 0 || axis > 2 ? 0 : static_cast<int>(this->Coordinates[axis].size());
}

//----------------------------------------------------------------------------
void vtkOrthogonalSlicer::SetCoordinate(int axis, int index, double coordinate)
{
  if (axis < 0 || axis > 2 || index < 0)
  {
    vtkErrorMacro(
      "Axis " << axis << " must be 0, 1 or 2, and the index " << index << " not negative.");
    return;
  }
  if (index >= this->GetNumberOfCoordinates(axis))
  {
    this->SetNumberOfCoordinates(axis, index + 1);
  }
  if (this->Coordinates[axis][index] != coordinate)
  {
    this->Coordinates[axis][index] = coordinate;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
double vtkOrthogonalSlicer::GetCoordinate(int axis, int index)
{
  if (index < 0 || index >= this->GetNumberOfCoordinates(axis))
  {
    vtkErrorMacro("There is no coordinate " << index << " on axis " << axis << ".");
    return 0.0;
  }
  return this->Coordinates[axis][index];
}

//----------------------------------------------------------------------------
int vtkOrthogonalSlicer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkStructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkRectilinearGrid");
  return 1;
}

//----------------------------------------------------------------------------
int vtkOrthogonalSlicer::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  // Contours pass from piece to piece: every request needs the whole input.
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    int whole[6];
    input->Get(Pipeline::WHOLE_EXTENT(), whole);
    input->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkOrthogonalSlicer::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int from = std::max(0, request->Get(Pipeline::FROM_OUTPUT_PORT()));
  if (outputs->GetInformationObject(from)->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the first process has all contours
  }
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  const bool hasSamples = input && (input->IsA("vtkImageData") || input->IsA("vtkRectilinearGrid"));
  bool done = true;
  try
  {
    done = hasSamples ? this->SliceSamples(input, inputs, outputs)
                      : input && this->SliceSurface(SurfaceOf(input), outputs);
  }
  catch (const orthoslices::Stopped&)
  {
    // The request to abort is still there.
  }
  if (!done || this->GetAbortExecute())
  {
    orthoslices::ClearOutputs(outputs);
  }
  return done ? 1 : 0;
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::SliceSurface(vtkPolyData* input, vtkInformationVector* outputs)
{
  if (std::max(input->GetNumberOfPoints(), input->GetNumberOfCells()) >
    std::numeric_limits<Index>::max() / 2)
  {
    vtkErrorMacro("The surface has too many points or cells: "
      << input->GetNumberOfPoints() << " and " << input->GetNumberOfCells() << ".");
    return false;
  }
  TriangleSurface surface = ReadTriangles(input);
  if (surface.Triangles.empty())
  {
    vtkErrorMacro("The input has no triangles, polygons or strips.");
    return false;
  }
  this->UpdateProgress(0.1);
  const SurfaceProblem problem = CloseSurface(surface);
  if (problem.Kind != SurfaceProblemKind::None)
  {
    vtkErrorMacro(<< DescribeProblem(problem));
    return false;
  }
  this->UpdateProgress(0.3);

  surface.NamesEdges = true;
  const bool isDouble = this->OutputPointsPrecision == DEFAULT_PRECISION
    ? input->GetPoints()->GetDataType() == VTK_DOUBLE
    : this->OutputPointsPrecision == DOUBLE_PRECISION;
  const Precision precision = isDouble ? Precision::Double : Precision::Single;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto bounds = BoundsOf(surface, axis);
    std::vector<double> planes;
    if (!this->PlacePlanes(axis, bounds[0], bounds[1], planes))
    {
      return false;
    }
    RoundPlanes(precision, planes);
    const auto contours = orthoslices::SliceSurface(surface, axis, planes, precision,
      ExecuteLoop(this, 0.3 + 0.7 * axis / 3, 0.3 + 0.7 * (axis + 1) / 3));
    vtkPolyData* output = vtkPolyData::GetData(outputs, axis);
    WriteContours(axis, precision, planes, contours, output);
    PassPointData(input->GetPointData(), contours, output);
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::ReadGrid(
  vtkDataSet* input, orthoslices::ImageFrame& frame, orthoslices::SampleGrid& grid)
{
  if (auto* samples = vtkRectilinearGrid::SafeDownCast(input))
  {
    if (!ReadSampleGrid(samples, grid))
    {
      vtkErrorMacro("The coordinates of the rectilinear grid do not ascend along each axis.");
      return false;
    }
    return true;
  }
  auto* image = vtkImageData::SafeDownCast(input);
  if (!ReadImageFrame(image, frame))
  {
    vtkErrorMacro("The image's direction matrix is singular: its axes lie in one plane.");
    return false;
  }
  grid = ReadSampleGrid(image, frame);
  return true;
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::SliceSamples(
  vtkDataSet* input, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataArray* scalars = this->FindScalars(input, inputs);
  ImageFrame frame;
  SampleGrid grid;
  if (!scalars || !this->ReadGrid(input, frame, grid))
  {
    return false;
  }
  const Precision stored =
    this->OutputPointsPrecision == SINGLE_PRECISION ? Precision::Single : Precision::Double;
  // Oblique contours are rounded once, where they are in the world.
  const Precision precision = frame.IsOblique ? Precision::Double : stored;
  const Region region{ this->UseLabel,
    this->UseLabel ? static_cast<double>(this->LabelValue) : this->IsoValue };
  std::vector<Index> samples[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const SampleAxis& all = grid.Axes[axis];
    std::vector<double> planes;
    if (!this->PlacePlanes(axis, all.Coordinate(0), all.Coordinate(all.Count() - 1), planes))
    {
      return false;
    }
    samples[axis] = NearestSamples(all, planes, this->PlaneMode == BY_COORDINATES);
  }
  RoundCoordinates(precision, grid);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> planes;
    for (const Index sample : samples[axis])
    {
      planes.push_back(grid.Axes[axis].Coordinate(sample));
    }
    const Execution execution = ExecuteLoop(this, axis / 3.0, (axis + 1) / 3.0);
    vtkPolyData* output = vtkPolyData::GetData(outputs, axis);
    if (this->EveryLabel)
    {
      WriteContours(axis, precision, planes,
        SliceSampleLabels(
          scalars, grid, axis, samples[axis], this->BackgroundLabel, precision, execution),
        scalars->GetDataType(), output);
    }
    else
    {
      WriteContours(axis, precision, planes,
        orthoslices::SliceSamples(scalars, grid, axis, samples[axis], region, precision, execution),
        output);
    }
    PassSampleData(input->GetPointData(), grid, axis, samples[axis], output);
    if (frame.IsOblique)
    {
      MoveToWorld(frame, stored, output);
    }
  }
  return true;
}

//----------------------------------------------------------------------------
vtkDataArray* vtkOrthogonalSlicer::FindScalars(vtkDataSet* input, vtkInformationVector** inputs)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputs, association);
  if (!scalars)
  {
    vtkErrorMacro("The image has no such point scalars to slice."
      << (input->GetCellData()->GetNumberOfArrays() > 0
             ? " It has cell data; convert them first (vtkCellDataToPointData)."
             : ""));
    return nullptr;
  }
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    scalars->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    vtkErrorMacro("The array \""
      << (scalars->GetName() ? scalars->GetName() : "")
      << "\" is not on the image's points; convert cell data first (vtkCellDataToPointData).");
    return nullptr;
  }
  if (scalars->GetNumberOfTuples() == 0)
  {
    vtkErrorMacro("The image has no samples.");
    return nullptr;
  }
  return scalars;
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::PlacePlanes(int axis, double lo, double hi, std::vector<double>& planes)
{
  switch (this->PlaneMode)
  {
    case BY_NUMBER:
      return this->PlaceByNumber(axis, lo, hi, planes);
    case BY_SPACING:
      return this->PlaceBySpacing(axis, lo, hi, planes);
    default:
      return this->PlaceByCoordinates(axis, planes);
  }
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::PlaceByNumber(int axis, double lo, double hi, std::vector<double>& planes)
{
  const int* numbers = this->NumberOfSlices;
  const int count = numbers[axis];
  if (count > MaximumPlanes || *std::max_element(numbers, numbers + 3) <= 0)
  {
    vtkErrorMacro("NumberOfSlices (" << numbers[0] << ", " << numbers[1] << ", " << numbers[2]
                                     << ") must be from 0 to " << MaximumPlanes
                                     << " on each axis, and not 0 on all.");
    return false;
  }
  for (int i = 0; i < count; ++i)
  {
    planes.push_back(lo + (i + 0.5) * (hi - lo) / count);
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::PlaceBySpacing(
  int axis, double lo, double hi, std::vector<double>& planes)
{
  const double spacing = this->Spacing[axis];
  if (!(spacing > 0.0) || (hi - lo) / spacing > MaximumPlanes)
  {
    vtkErrorMacro("Spacing " << spacing << " on axis " << axis
                             << " must be positive and make at most " << MaximumPlanes
                             << " planes between " << lo << " and " << hi << ".");
    return false;
  }
  for (int i = 0; lo + (i + 0.5) * spacing < hi; ++i)
  {
    planes.push_back(lo + (i + 0.5) * spacing);
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::PlaceByCoordinates(int axis, std::vector<double>& planes)
{
  planes = this->Coordinates[axis];
  if (this->Coordinates[0].empty() && this->Coordinates[1].empty() && this->Coordinates[2].empty())
  {
    vtkErrorMacro("Planes are given by coordinates, but there are none on any axis.");
    return false;
  }
  const auto bad = std::find_if_not(
    planes.begin(), planes.end(), [](double plane) { return std::isfinite(plane); });
  if (bad != planes.end())
  {
    vtkErrorMacro("Plane coordinate " << *bad << " on axis " << axis << " is not finite.");
    return false;
  }
  std::sort(planes.begin(), planes.end());
  return true;
}

//----------------------------------------------------------------------------
void vtkOrthogonalSlicer::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const modes[] = { "Number", "Spacing", "Coordinates" };
  const auto triple = [](const auto* values)
  {
    std::ostringstream text;
    text << values[0] << " " << values[1] << " " << values[2];
    return text.str();
  };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PlaneMode: " << modes[this->PlaneMode] << "\n";
  os << indent << "NumberOfSlices: " << triple(this->NumberOfSlices) << "\n";
  os << indent << "Spacing: " << triple(this->Spacing) << "\n";
  for (int axis = 0; axis < 3; ++axis)
  {
    os << indent << "XYZ"[axis] << "Coordinates:";
    for (const double coordinate : this->Coordinates[axis])
    {
      os << " " << coordinate;
    }
    os << "\n";
  }
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "UseLabel: " << (this->UseLabel ? "On" : "Off") << "\n";
  os << indent << "LabelValue: " << this->LabelValue << "\n";
  os << indent << "EveryLabel: " << (this->EveryLabel ? "On" : "Off") << "\n";
  os << indent << "BackgroundLabel: " << this->BackgroundLabel << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
