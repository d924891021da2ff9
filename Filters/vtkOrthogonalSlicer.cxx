// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOrthogonalSlicer.h"

#include "Core/Slicing/SliceImage.h"
#include "Core/Slicing/SliceSurface.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTriangleFilter.h"

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

/// Direction cosines may differ this much from 0, 1 and -1.
constexpr double DirectionTolerance = 1e-6;

//----------------------------------------------------------------------------
/// Planes are cut in a few batches; between them progress is reported and abort requests are
/// heard.
Execution MakeExecution(vtkAlgorithm* filter, double firstProgress, double lastProgress)
{
  Execution execution;
  execution.For = [=](std::size_t count, const Execution::Range& run)
  {
    const vtkIdType total = static_cast<vtkIdType>(count);
    const vtkIdType batch = std::max<vtkIdType>(1, (total + 3) / 4);
    const vtkIdType threads = vtkSMPTools::GetEstimatedNumberOfThreads();
    const vtkIdType grain = std::max<vtkIdType>(1, batch / std::max<vtkIdType>(1, threads));
    for (vtkIdType begin = 0; begin < total && !filter->GetAbortExecute(); begin += batch)
    {
      const vtkIdType end = std::min(total, begin + batch);
      vtkSMPTools::For(begin, end, grain,
        [&run](vtkIdType first, vtkIdType last)
        { run(static_cast<std::size_t>(first), static_cast<std::size_t>(last)); });
      filter->UpdateProgress(firstProgress + (lastProgress - firstProgress) * end / total);
    }
  };
  return execution;
}

void RoundPlanes(Precision precision, std::vector<double>& planes)
{
  for (double& plane : planes)
  {
    plane = RoundTo(precision, plane) + 0.0; // + 0.0 turns -0.0 into 0.0
  }
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
}

std::string PointText(const Point3& point)
{
  std::ostringstream text;
  text << "(" << point[0] << ", " << point[1] << ", " << point[2] << ")";
  return text.str();
}

std::string ProblemText(const SurfaceProblem& problem)
{
  const std::string edge =
    "the edge from " + PointText(problem.From) + " to " + PointText(problem.To);
  switch (problem.Kind)
  {
    case SurfaceProblemKind::NotFinite:
      return "The surface has the point " + PointText(problem.From) + ", which is not finite.";
    case SurfaceProblemKind::OpenEdge:
      return "The surface is open: " + edge +
        " belongs to one triangle only. Close it first; if points there are only nearly the same, "
        "merge them (vtkCleanPolyData, ParaView's Clean).";
    case SurfaceProblemKind::OverusedEdge:
      return "The surface is not a manifold: " + edge + " belongs to more than two triangles.";
    case SurfaceProblemKind::InconsistentEdge:
      return "The triangles are not oriented consistently: both triangles at " + edge +
        " pass it in the same direction. Orient them first (vtkPolyDataNormals with "
        "ConsistencyOn, ParaView's Surface Normals).";
    case SurfaceProblemKind::None:
      break;
  }
  return std::string();
}

//----------------------------------------------------------------------------
bool HasTrianglesOnly(vtkPolyData* input)
{
  return input->GetNumberOfStrips() == 0 && input->GetPolys()->GetMaxCellSize() <= 3;
}

/// Points and triangles of the input; polygons and strips are triangulated.
TriangleSurface ReadSurface(vtkPolyData* input)
{
  TriangleSurface surface;
  if (!input->GetPoints())
  {
    return surface;
  }
  vtkNew<vtkTriangleFilter> triangulate;
  if (!HasTrianglesOnly(input))
  {
    vtkNew<vtkPolyData> copy; // without the caller's pipeline
    copy->ShallowCopy(input);
    triangulate->SetInputData(copy);
    triangulate->PassVertsOff();
    triangulate->PassLinesOff();
    triangulate->Update();
    input = triangulate->GetOutput();
  }
  surface.Points.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), surface.Points[i].data());
  }
  surface.Triangles.reserve(static_cast<std::size_t>(input->GetNumberOfPolys()));
  vtkIdType size;
  const vtkIdType* ids;
  auto cell = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    cell->GetCurrentCell(size, ids);
    if (size == 3)
    {
      surface.Triangles.push_back(
        { static_cast<Index>(ids[0]), static_cast<Index>(ids[1]), static_cast<Index>(ids[2]) });
    }
  }
  return surface;
}

std::array<double, 2> BoundsOf(const TriangleSurface& surface, int axis)
{
  std::array<double, 2> bounds{ std::numeric_limits<double>::max(),
    std::numeric_limits<double>::lowest() };
  for (const auto& triangle : surface.Triangles)
  {
    for (const Index vertex : triangle)
    {
      bounds[0] = std::min(bounds[0], surface.Points[vertex][axis]);
      bounds[1] = std::max(bounds[1], surface.Points[vertex][axis]);
    }
  }
  return bounds;
}

//----------------------------------------------------------------------------
/// The samples of an image along one coordinate axis, in ascending order.
struct SampleAxis
{
  std::vector<double> Coordinates; ///< with one sample of padding on both ends
  std::ptrdiff_t Stride = 0;       ///< from one sample to the next in the scalars

  Index Count() const { return static_cast<Index>(this->Coordinates.size()) - 2; }
  double Coordinate(Index sample) const { return this->Coordinates[sample + 1]; }
  Index Nearest(double coordinate) const;
};

/// Of two samples that are equally near, the upper one.
Index SampleAxis::Nearest(double coordinate) const
{
  const auto begin = this->Coordinates.begin() + 1;
  const auto end = this->Coordinates.end() - 1;
  const auto upper = std::upper_bound(begin, end, coordinate);
  if (upper == begin || upper == end)
  {
    return upper == begin ? 0 : this->Count() - 1;
  }
  const bool lower = coordinate - *(upper - 1) < *upper - coordinate;
  return static_cast<Index>(upper - begin) - (lower ? 1 : 0);
}

/// An image seen along the coordinate axes, whatever its direction matrix.
struct SampleGrid
{
  SampleAxis Axes[3];
  std::ptrdiff_t First = 0; ///< scalar at the lower end of all three axes
};

/// The coordinate axis that an index axis of the image is parallel to, or -1.
int ParallelAxis(vtkMatrix3x3* direction, int indexAxis)
{
  int parallel = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cosine = std::abs(direction->GetElement(axis, indexAxis));
    if (std::abs(cosine - 1.0) <= DirectionTolerance)
    {
      parallel = axis;
    }
    else if (!(cosine <= DirectionTolerance))
    {
      return -1;
    }
  }
  return parallel;
}

/// False if the image's axes are oblique.
bool ReadGrid(vtkImageData* image, SampleGrid& grid)
{
  const int* extent = image->GetExtent();
  const int* size = image->GetDimensions();
  const std::ptrdiff_t strides[] = { 1, size[0], static_cast<std::ptrdiff_t>(size[0]) * size[1] };
  for (int indexAxis = 0; indexAxis < 3; ++indexAxis)
  {
    const int axis = ParallelAxis(image->GetDirectionMatrix(), indexAxis);
    if (axis < 0 || !grid.Axes[axis].Coordinates.empty())
    {
      return false;
    }
    const bool ascends =
      image->GetDirectionMatrix()->GetElement(axis, indexAxis) * image->GetSpacing()[indexAxis] >
      0.0;
    const double step = std::abs(image->GetSpacing()[indexAxis]);
    const double origin = image->GetOrigin()[axis];
    const int lowest = ascends ? extent[2 * indexAxis] : -extent[2 * indexAxis + 1];
    SampleAxis& samples = grid.Axes[axis];
    for (int i = -1; i <= size[indexAxis]; ++i)
    {
      samples.Coordinates.push_back(origin + step * (static_cast<double>(lowest) + i));
    }
    samples.Stride = ascends ? strides[indexAxis] : -strides[indexAxis];
    grid.First += ascends ? 0 : strides[indexAxis] * (size[indexAxis] - 1);
  }
  return true;
}

/// What makes a sample an inside one.
struct Region
{
  bool IsLabel;
  double Value;

  double Threshold() const { return this->IsLabel ? 0.5 : this->Value; }
  double Sample(double scalar) const
  {
    return this->IsLabel ? (scalar == this->Value ? 1.0 : 0.0) : scalar;
  }
};

SamplePlane ReadPlane(
  vtkDataArray* scalars, const SampleGrid& grid, int axis, Index sample, const Region& region)
{
  const SampleAxis& u = grid.Axes[FirstAxis(axis)];
  const SampleAxis& v = grid.Axes[SecondAxis(axis)];
  SamplePlane plane;
  plane.SizeU = u.Count();
  plane.SizeV = v.Count();
  plane.Values.reserve(static_cast<std::size_t>(plane.SizeU) * plane.SizeV);
  for (Index j = 0; j < plane.SizeV; ++j)
  {
    vtkIdType id = grid.First + sample * grid.Axes[axis].Stride + j * v.Stride;
    for (Index i = 0; i < plane.SizeU; ++i, id += u.Stride)
    {
      plane.Values.push_back(region.Sample(scalars->GetComponent(id, 0)));
    }
  }
  return plane;
}

/// The samples that the planes move to, each once.
std::vector<Index> NearestSamples(
  const SampleAxis& samples, const std::vector<double>& planes, bool dropBeyond)
{
  const double half = 0.5 * (samples.Coordinate(0) - samples.Coordinate(-1));
  std::vector<Index> nearest;
  for (const double plane : planes)
  {
    const Index sample = samples.Nearest(plane);
    const bool beyond = std::abs(plane - samples.Coordinate(sample)) > half * (1.0 + 1e-9);
    if (!(beyond && dropBeyond))
    {
      nearest.push_back(sample);
    }
  }
  nearest.erase(std::unique(nearest.begin(), nearest.end()), nearest.end());
  return nearest;
}

void RoundCoordinates(Precision precision, SampleGrid& grid)
{
  for (SampleAxis& axis : grid.Axes)
  {
    for (double& coordinate : axis.Coordinates)
    {
      coordinate = RoundTo(precision, coordinate) + 0.0;
    }
  }
}

/// Contours on the given sample planes of one axis.
std::vector<PlaneContours> SlicePlanes(vtkDataArray* scalars, const SampleGrid& grid, int axis,
  const std::vector<Index>& samples, const Region& region, Precision precision,
  const Execution& execution)
{
  std::vector<PlaneContours> contours(samples.size());
  execution.For(contours.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        contours[i] = SliceImage(ReadPlane(scalars, grid, axis, samples[i], region),
          region.Threshold(), grid.Axes[FirstAxis(axis)].Coordinates,
          grid.Axes[SecondAxis(axis)].Coordinates, precision);
      }
    });
  return contours;
}

//----------------------------------------------------------------------------
/// Points of all contours of one axis, plane by plane.
template <typename ArrayType>
void WritePoints(int axis, const std::vector<double>& planes,
  const std::vector<PlaneContours>& contours, vtkIdType count, vtkPoints* points)
{
  using ValueType = typename ArrayType::ValueType;
  vtkNew<ArrayType> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  ValueType* point = coordinates->GetPointer(0);
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
  {
    for (std::size_t i = 0; i < contours[plane].U.size(); ++i, point += 3)
    {
      point[axis] = static_cast<ValueType>(planes[plane]);
      point[FirstAxis(axis)] = static_cast<ValueType>(contours[plane].U[i]);
      point[SecondAxis(axis)] = static_cast<ValueType>(contours[plane].V[i]);
    }
  }
  points->SetData(coordinates);
}

/// Polylines that end where they start, with the cell arrays.
void WriteLines(const std::vector<double>& planes, const std::vector<PlaneContours>& contours,
  vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  vtkNew<vtkIntArray> index;
  index->SetName("PlaneIndex");
  vtkNew<vtkDoubleArray> coordinate;
  coordinate->SetName("PlaneCoordinate");
  vtkIdType first = 0;
  offsets->InsertNextValue(0);
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
  {
    for (Index i = 0; i < contours[plane].Count(); ++i)
    {
      const vtkIdType end = first + contours[plane].Offsets[i + 1] - contours[plane].Offsets[i];
      for (vtkIdType id = first; id < end; ++id)
      {
        connectivity->InsertNextValue(id);
      }
      connectivity->InsertNextValue(first);
      offsets->InsertNextValue(connectivity->GetNumberOfValues());
      index->InsertNextValue(static_cast<int>(plane));
      coordinate->InsertNextValue(planes[plane]);
      first = end;
    }
  }
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, connectivity);
  output->SetLines(lines);
  output->GetCellData()->AddArray(index);
  output->GetCellData()->AddArray(coordinate);
}

void WriteContours(int axis, Precision precision, const std::vector<double>& planes,
  const std::vector<PlaneContours>& contours, vtkPolyData* output)
{
  vtkIdType count = 0;
  for (const PlaneContours& plane : contours)
  {
    count += static_cast<vtkIdType>(plane.U.size());
  }
  vtkNew<vtkPoints> points;
  if (precision == Precision::Double)
  {
    WritePoints<vtkDoubleArray>(axis, planes, contours, count, points);
  }
  else
  {
    WritePoints<vtkFloatArray>(axis, planes, contours, count, points);
  }
  output->SetPoints(points);
  WriteLines(planes, contours, output);
  vtkNew<vtkDoubleArray> all;
  all->SetName("PlaneCoordinates");
  all->SetNumberOfValues(static_cast<vtkIdType>(planes.size()));
  std::copy(planes.begin(), planes.end(), all->GetPointer(0));
  output->GetFieldData()->AddArray(all);
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
  vtkImageData* image = vtkImageData::GetData(inputs[0]);
  vtkPolyData* surface = vtkPolyData::GetData(inputs[0]);
  const bool done = image ? this->SliceImage(image, inputs, outputs)
                          : surface && this->SliceSurface(surface, outputs);
  if (!done || this->GetAbortExecute())
  {
    for (int port = 0; port < 3; ++port)
    {
      vtkPolyData::GetData(outputs, port)->Initialize();
    }
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
  TriangleSurface surface = ReadSurface(input);
  if (surface.Triangles.empty())
  {
    vtkErrorMacro("The input has no triangles, polygons or strips.");
    return false;
  }
  this->UpdateProgress(0.1);
  const SurfaceProblem problem = CloseSurface(surface);
  if (problem.Kind != SurfaceProblemKind::None)
  {
    vtkErrorMacro(<< ProblemText(problem));
    return false;
  }
  this->UpdateProgress(0.3);

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
      MakeExecution(this, 0.3 + 0.7 * axis / 3, 0.3 + 0.7 * (axis + 1) / 3));
    WriteContours(axis, precision, planes, contours, vtkPolyData::GetData(outputs, axis));
  }
  return true;
}

//----------------------------------------------------------------------------
bool vtkOrthogonalSlicer::SliceImage(
  vtkImageData* input, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataArray* scalars = this->FindScalars(input, inputs);
  SampleGrid grid;
  if (!scalars)
  {
    return false;
  }
  if (!ReadGrid(input, grid))
  {
    vtkErrorMacro("The image's axes are not parallel to the coordinate axes; its direction matrix "
                  "may only permute and flip them. Resample it (vtkImageReslice) or slice it in "
                  "its own coordinates, with the identity for direction matrix.");
    return false;
  }
  const Precision precision =
    this->OutputPointsPrecision == SINGLE_PRECISION ? Precision::Single : Precision::Double;
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
    const auto contours = SlicePlanes(scalars, grid, axis, samples[axis], region, precision,
      MakeExecution(this, axis / 3.0, (axis + 1) / 3.0));
    std::vector<double> planes;
    for (const Index sample : samples[axis])
    {
      planes.push_back(grid.Axes[axis].Coordinate(sample));
    }
    WriteContours(axis, precision, planes, contours, vtkPolyData::GetData(outputs, axis));
  }
  return true;
}

//----------------------------------------------------------------------------
vtkDataArray* vtkOrthogonalSlicer::FindScalars(vtkImageData* input, vtkInformationVector** inputs)
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
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
