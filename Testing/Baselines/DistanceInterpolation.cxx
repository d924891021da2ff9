// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceInterpolation.h"

#include "DistanceVolume.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
// Equal steps of at most STEP over [LOW, HIGH] with two more at each end.
std::vector<double> UniformCoordinates(double low, double high, double step)
{
  const int steps = std::max(1, static_cast<int>(std::ceil((high - low) / step)));
  std::vector<double> coordinates;
  for (int i = -2; i <= steps + 2; ++i)
  {
    coordinates.push_back(low + i * ((high - low) / steps));
  }
  return coordinates;
}

} // anonymous namespace

//------------------------------------------------------------------------------
DistanceInterpolation::DistanceInterpolation(int resolution)
  : Resolution(std::max(2, resolution))
{
}

//------------------------------------------------------------------------------
std::string DistanceInterpolation::Description() const
{
  return "signed distances on the z-slices, linear in between, iso-surface (Klein, Schilling 1999)";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> DistanceInterpolation::Reconstruct(const SliceSets& slices) const
{
  std::vector<Slice> family = ExtractSlices(slices.Families[2], 2);
  if (family.empty())
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  double b[6];
  slices.Families[2]->GetBounds(b);
  const double step =
    std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] }) / static_cast<double>(this->Resolution);
  PadWithEmptySlices(family, b[4], b[5]);
  Lattice lattice;
  lattice.Coordinates[0] = UniformCoordinates(b[0], b[1], step);
  lattice.Coordinates[1] = UniformCoordinates(b[2], b[3], step);
  lattice.Coordinates[2] = RefineByLength(family, step);
  const FamilyField field(family, 2, lattice);
  return ExtractZeroSurface(
    lattice, SampleAll(lattice, [&field](const auto& at) { return field.At(at).Value; }));
}

} // namespace baselines
} // namespace orthoslices
