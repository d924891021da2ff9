// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ReadSamples.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The samples on the plane of one sample across `axis`.
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
}

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

SampleGrid ReadSampleGrid(vtkImageData* image, const ImageFrame& frame)
{
  const int* extent = image->GetExtent();
  const int* size = image->GetDimensions();
  const std::ptrdiff_t strides[] = { 1, size[0], static_cast<std::ptrdiff_t>(size[0]) * size[1] };
  SampleGrid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int indexAxis = frame.IndexAxis[axis];
    const bool ascends = frame.Step[axis] > 0.0;
    const double step = std::abs(frame.Step[axis]);
    const int lowest = ascends ? extent[2 * indexAxis] : -extent[2 * indexAxis + 1];
    SampleAxis& samples = grid.Axes[axis];
    for (int i = -1; i <= size[indexAxis]; ++i)
    {
      samples.Coordinates.push_back(frame.Origin[axis] + step * (static_cast<double>(lowest) + i));
    }
    samples.Stride = ascends ? strides[indexAxis] : -strides[indexAxis];
    grid.First += ascends ? 0 : strides[indexAxis] * (size[indexAxis] - 1);
  }
  return grid;
}

bool ReadSampleGrid(vtkRectilinearGrid* samples, SampleGrid& grid)
{
  vtkDataArray* coordinates[] = { samples->GetXCoordinates(), samples->GetYCoordinates(),
    samples->GetZCoordinates() };
  std::ptrdiff_t stride = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkIdType count = coordinates[axis]->GetNumberOfTuples();
    std::vector<double>& all = grid.Axes[axis].Coordinates;
    all.assign(1, 0.0);
    for (vtkIdType i = 0; i < count; ++i)
    {
      all.push_back(coordinates[axis]->GetComponent(i, 0));
      if (!std::isfinite(all.back()) || (i > 0 && !(all[i] < all.back())))
      {
        return false;
      }
    }
    // A grid of one sample has no distance.
    all.front() = count > 1 ? 2.0 * all[1] - all[2] : all[1] - 1.0;
    all.push_back(count > 1 ? 2.0 * all[count] - all[count - 1] : all[count] + 1.0);
    grid.Axes[axis].Stride = stride;
    stride *= count;
  }
  return true;
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

std::vector<Index> NearestSamples(
  const SampleAxis& samples, const std::vector<double>& planes, bool dropBeyond)
{
  const Index count = samples.Count();
  const double below = 0.5 * (samples.Coordinate(0) - samples.Coordinate(-1));
  const double above = 0.5 * (samples.Coordinate(count) - samples.Coordinate(count - 1));
  std::vector<Index> nearest;
  for (const double plane : planes)
  {
    const Index sample = samples.Nearest(plane);
    const bool beyond = samples.Coordinate(0) - plane > below * (1.0 + 1e-9) ||
      plane - samples.Coordinate(count - 1) > above * (1.0 + 1e-9);
    if (!(beyond && dropBeyond))
    {
      nearest.push_back(sample);
    }
  }
  nearest.erase(std::unique(nearest.begin(), nearest.end()), nearest.end());
  return nearest;
}

std::vector<PlaneContours> SliceSamples(vtkDataArray* scalars, const SampleGrid& grid, int axis,
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

std::vector<LabelContours> SliceSampleLabels(vtkDataArray* scalars, const SampleGrid& grid,
  int axis, const std::vector<Index>& samples, double background, Precision precision,
  const Execution& execution)
{
  std::vector<LabelContours> contours(samples.size());
  const Region asTheyAre{ false, 0.0 };
  execution.For(contours.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        contours[i] = SliceLabels(ReadPlane(scalars, grid, axis, samples[i], asTheyAre), background,
          grid.Axes[FirstAxis(axis)].Coordinates, grid.Axes[SecondAxis(axis)].Coordinates,
          precision);
      }
    });
  return contours;
}
}
