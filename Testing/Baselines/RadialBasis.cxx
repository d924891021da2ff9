// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RadialBasis.h"

#include "ContourSamples.h"
#include "DistanceVolume.h"

#include "vtkBoundingBox.h"
#include "vtkNew.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace baselines
{
namespace
{

// Off-surface points lie a quarter of the distance between samples off. Of a twelfth, a quarter and
// the whole of it, a quarter was closest on stacks; on few planes it makes no difference.
constexpr double OffsetShare = 0.25;
constexpr double AccuracyShare = 1e-3;

//------------------------------------------------------------------------------
// The contours' box, enlarged; equal steps on all axes.
Lattice MakeLattice(const SliceSets& slices, const SliceFamilies& families, int resolution)
{
  vtkBoundingBox box;
  for (vtkPolyData* family : slices.Families)
  {
    if (family && family->GetNumberOfPoints() > 0)
    {
      box.AddBounds(family->GetBounds());
    }
  }
  const double step = box.GetMaxLength() / resolution;
  Lattice lattice;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<Slice>& planes = families[axis];
    const double gap = planes.size() > 1
      ? (planes.back().Coordinate - planes.front().Coordinate) / (planes.size() - 1.0)
      : 0.1 * box.GetLength(axis);
    const int margin = static_cast<int>(std::ceil(gap / step)) + 1;
    const int inner = static_cast<int>(std::ceil(box.GetLength(axis) / step));
    for (int i = -margin; i <= inner + margin; ++i)
    {
      lattice.Coordinates[axis].push_back(box.GetBound(2 * axis) + i * step);
    }
  }
  return lattice;
}

//------------------------------------------------------------------------------
// Each EVERY-th coordinate, and the last one.
std::vector<double> Coarsen(const std::vector<double>& coordinates, std::size_t every)
{
  std::vector<double> coarse;
  for (std::size_t i = 0; i < coordinates.size(); i += every)
  {
    coarse.push_back(coordinates[i]);
  }
  if (coarse.back() < coordinates.back())
  {
    coarse.push_back(coordinates.back());
  }
  return coarse;
}

//------------------------------------------------------------------------------
// Evaluates the function near its zeros only. Where its value at the nearest point of a coarse
// lattice is more than twice the distance between these, its slope would have to be above two for a
// zero, and that value is as good: a distance has a slope of one.
std::vector<double> SampleNearZero(const RadialBasisFunction& function, const Lattice& lattice)
{
  constexpr std::size_t every = 4;
  Lattice coarse;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarse.Coordinates[axis] = Coarsen(lattice.Coordinates[axis], every);
  }
  const auto evaluate = [&function](const Lattice& l, const std::array<std::size_t, 3>& at)
  {
    return function.Evaluate(
      { l.Coordinates[0][at[0]], l.Coordinates[1][at[1]], l.Coordinates[2][at[2]] });
  };
  const std::vector<double> far =
    SampleAll(coarse, [&](const auto& at) { return evaluate(coarse, at); });
  const double apart = every * (lattice.Coordinates[0][1] - lattice.Coordinates[0][0]);
  return SampleAll(lattice,
    [&](const std::array<std::size_t, 3>& at)
    {
      const double value = far[coarse.Index(
        { (at[0] + every / 2) / every, (at[1] + every / 2) / every, (at[2] + every / 2) / every })];
      return std::abs(value) > 2.0 * apart ? value : evaluate(lattice, at);
    });
}

//------------------------------------------------------------------------------
// Nothing is inside beyond the border.
void CloseAtBorder(const Lattice& lattice, std::vector<double>& values)
{
  const auto& c = lattice.Coordinates;
  const double outside = c[0].front() - c[0].back();
  for (std::size_t k = 0; k < c[2].size(); ++k)
  {
    for (std::size_t j = 0; j < c[1].size(); ++j)
    {
      const bool isBorder = k == 0 || k + 1 == c[2].size() || j == 0 || j + 1 == c[1].size();
      const std::size_t step = isBorder ? 1 : c[0].size() - 1;
      for (std::size_t i = 0; i < c[0].size(); i += step)
      {
        double& value = values[lattice.Index({ i, j, k })];
        value = value > 0.0 ? outside : value;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The components of the surface to which samples are nearest.
vtkSmartPointer<vtkPolyData> KeepNearSamples(
  vtkPolyData* surface, const std::vector<ContourSample>& samples)
{
  vtkNew<vtkPolyDataConnectivityFilter> filter;
  filter->SetInputData(surface);
  filter->SetExtractionModeToPointSeededRegions();
  for (const ContourSample& sample : samples)
  {
    filter->AddSeed(surface->FindPoint(const_cast<double*>(sample.Position.data())));
  }
  filter->Update();
  return filter->GetOutput();
}

} // anonymous namespace

//------------------------------------------------------------------------------
RadialBasis::RadialBasis(int centres, int resolution, RadialKernel kernel)
  : Centres(std::max(10, centres))
  , Resolution(std::max(8, resolution))
  , Kernel(kernel)
{
}

//------------------------------------------------------------------------------
std::string RadialBasis::Description() const
{
  return "radial basis functions through the contours of all families, with their normals in the "
         "planes (Carr et al. 2001)";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> RadialBasis::Reconstruct(const SliceSets& slices) const
{
  SliceFamilies families;
  for (int axis = 0; axis < 3; ++axis)
  {
    families[axis] = ExtractSlices(slices.Families[axis], axis);
    std::for_each(families[axis].begin(), families[axis].end(), OrientByNesting);
  }
  const double step = TotalLength(families) / this->Centres;
  if (!(step > 0.0))
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  const std::vector<ContourSample> samples = SampleContours(families, step);
  const RadialBasisFunction function = FitGreedily(MakeConstraints(samples, OffsetShare * step),
    this->Kernel, static_cast<std::size_t>(this->Centres), AccuracyShare * step);
  const Lattice lattice = MakeLattice(slices, families, this->Resolution);
  std::vector<double> values = SampleNearZero(function, lattice);
  CloseAtBorder(lattice, values);
  const vtkSmartPointer<vtkPolyData> surface = ExtractZeroSurface(lattice, std::move(values));
  return surface->GetNumberOfCells() > 0 ? KeepNearSamples(surface, samples) : surface;
}

} // namespace baselines
} // namespace orthoslices
