// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceVolume.h"

#include "ContourDistance.h"

#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
std::vector<double> Refine(const std::vector<Slice>& slices, double longest, int fewest)
{
  std::vector<double> coordinates;
  for (std::size_t i = 0; i + 1 < slices.size(); ++i)
  {
    const double low = slices[i].Coordinate;
    const double length = slices[i + 1].Coordinate - low;
    const int parts = std::max(fewest, static_cast<int>(std::ceil(length / longest)));
    for (int part = 0; part < parts; ++part)
    {
      coordinates.push_back(low + part * (length / parts));
    }
  }
  coordinates.push_back(slices.back().Coordinate);
  return coordinates;
}

//------------------------------------------------------------------------------
double SmallestStep(const Lattice& lattice)
{
  double smallest = std::numeric_limits<double>::max();
  for (const std::vector<double>& coordinates : lattice.Coordinates)
  {
    for (std::size_t i = 0; i + 1 < coordinates.size(); ++i)
    {
      smallest = std::min(smallest, coordinates[i + 1] - coordinates[i]);
    }
  }
  return smallest;
}

//------------------------------------------------------------------------------
void MoveAwayFromZero(double distance, std::vector<double>& values)
{
  for (double& value : values)
  {
    if (std::abs(value) < distance)
    {
      value = value > 0.0 ? distance : -distance;
    }
  }
}

//------------------------------------------------------------------------------
// An image whose coordinates are sample numbers.
vtkSmartPointer<vtkImageData> MakeImage(const Lattice& lattice, std::vector<double>& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(lattice.Coordinates[0].size()),
    static_cast<int>(lattice.Coordinates[1].size()),
    static_cast<int>(lattice.Coordinates[2].size()));
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetArray(values.data(), static_cast<vtkIdType>(values.size()), 1);
  image->GetPointData()->SetScalars(scalars);
  return image;
}

//------------------------------------------------------------------------------
// From sample numbers, linearly between samples, to the coordinates of the lattice.
double MapCoordinate(double sample, const std::vector<double>& coordinates)
{
  const auto last = static_cast<double>(coordinates.size() - 2);
  const auto below = static_cast<std::size_t>(std::clamp(std::floor(sample), 0.0, last));
  const double fraction = sample - static_cast<double>(below);
  return coordinates[below] + fraction * (coordinates[below + 1] - coordinates[below]);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> MapPoints(vtkPoints* samples, const Lattice& lattice)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(samples->GetNumberOfPoints());
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    double p[3];
    samples->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = MapCoordinate(p[axis], lattice.Coordinates[axis]);
    }
    points->SetPoint(i, p);
  }
  return points;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void PadWithEmptySlices(std::vector<Slice>& slices, double low, double high)
{
  if (slices.empty())
  {
    return;
  }
  const std::size_t count = slices.size();
  const double first = slices.front().Coordinate;
  const double last = slices.back().Coordinate;
  const double firstGap = count > 1 ? slices[1].Coordinate - first : 0.0;
  const double lastGap = count > 1 ? last - slices[count - 2].Coordinate : 0.0;
  const double below = std::min(first - firstGap, low - 0.1 * firstGap);
  const double above = std::max(last + lastGap, high + 0.1 * lastGap);
  slices.insert(slices.begin(), Slice{ below < first ? below : first - 1.0, {} });
  slices.push_back({ above > last ? above : last + 1.0, {} });
}

//------------------------------------------------------------------------------
std::vector<double> RefineByLength(const std::vector<Slice>& slices, double longest)
{
  return Refine(slices, longest, 2);
}

//------------------------------------------------------------------------------
std::vector<double> RefineByNumber(const std::vector<Slice>& slices, int parts)
{
  return Refine(slices, std::numeric_limits<double>::infinity(), parts);
}

//------------------------------------------------------------------------------
FamilyField::FamilyField(const std::vector<Slice>& slices, int axis, const Lattice& lattice)
  : Axis(axis)
  , RowSize(lattice.Coordinates[(axis + 1) % 3].size())
{
  CheckSize(lattice);
  const std::size_t rasterSize = this->RowSize * lattice.Coordinates[(axis + 2) % 3].size();
  this->Values.resize(rasterSize * slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    double* values = slices[i].Loops.empty() ? nullptr : this->Values.data() + i * rasterSize;
    if (values)
    {
      this->SamplePlane(slices[i], lattice, values);
    }
    this->Planes.push_back(values);
  }
  this->FindPlaces(slices, lattice.Coordinates[axis]);
}

//------------------------------------------------------------------------------
void FamilyField::SamplePlane(const Slice& slice, const Lattice& lattice, double* values) const
{
  const ContourDistance distance(slice.Loops);
  const std::vector<double>& us = lattice.Coordinates[(this->Axis + 1) % 3];
  const std::vector<double>& vs = lattice.Coordinates[(this->Axis + 2) % 3];
  vtkSMPTools::For(0, static_cast<vtkIdType>(vs.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        distance.SampleRow(us, vs[row], values + row * this->RowSize);
      }
    });
}

//------------------------------------------------------------------------------
void FamilyField::FindPlaces(
  const std::vector<Slice>& slices, const std::vector<double>& coordinates)
{
  std::size_t below = 0;
  for (const double coordinate : coordinates)
  {
    while (below + 2 < slices.size() && slices[below + 1].Coordinate <= coordinate)
    {
      ++below;
    }
    const double low = slices[below].Coordinate;
    const double length = slices[below + 1].Coordinate - low;
    const double fraction = std::clamp((coordinate - low) / length, 0.0, 1.0);
    const double fromBelow = below > 0 ? fraction : 1.0;
    const double fromAbove = below + 2 < slices.size() ? 1.0 - fraction : 1.0;
    this->Places.push_back({ below, fraction, length, length * std::min(fromBelow, fromAbove) });
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ExtractZeroSurface(const Lattice& lattice, std::vector<double> values)
{
  MoveAwayFromZero(1e-3 * SmallestStep(lattice), values);
  vtkNew<vtkFlyingEdges3D> isoSurface;
  isoSurface->SetInputData(MakeImage(lattice, values));
  isoSurface->SetValue(0, 0.0);
  isoSurface->ComputeNormalsOff();
  isoSurface->ComputeGradientsOff();
  isoSurface->ComputeScalarsOff();
  isoSurface->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->ShallowCopy(isoSurface->GetOutput());
  if (surface->GetNumberOfPoints() > 0)
  {
    surface->SetPoints(MapPoints(surface->GetPoints(), lattice));
  }
  return surface;
}

//------------------------------------------------------------------------------
void CheckSize(const Lattice& lattice)
{
  if (lattice.NumberOfSamples() > MaximumNumberOfSamples)
  {
    throw std::runtime_error("the volume would have " + std::to_string(lattice.NumberOfSamples()) +
      " samples; choose a lower resolution");
  }
}

} // namespace baselines
} // namespace orthoslices
