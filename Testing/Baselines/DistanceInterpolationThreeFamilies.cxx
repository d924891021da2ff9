// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceInterpolationThreeFamilies.h"

#include "DistanceVolume.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
vtkBoundingBox BoundsOf(const SliceSets& slices)
{
  vtkBoundingBox bounds;
  for (vtkPolyData* family : slices.Families)
  {
    if (family && family->GetNumberOfPoints() > 0)
    {
      bounds.AddBounds(family->GetBounds());
    }
  }
  return bounds;
}

//------------------------------------------------------------------------------
// The gradient of a family's field has length 1 within the slices and SLOPE along the axis.
double GradientLength(double slope) { return std::sqrt(1.0 + slope * slope); }

//------------------------------------------------------------------------------
// Where slices cross, the mean of their values.
double Blend(const std::array<FamilyField, 3>& fields, const std::array<std::size_t, 3>& at)
{
  constexpr double Smallest = 1e-12;
  double sum = 0.0;
  double weights = 0.0;
  for (const FamilyField& field : fields)
  {
    const FamilyField::Estimate estimate = field.At(at);
    const double gradient = GradientLength(estimate.Slope);
    const double uncertainty = std::max(Smallest, estimate.Distance) * std::pow(gradient, 3);
    const double weight = 1.0 / (uncertainty * uncertainty);
    sum += weight * estimate.Value / gradient;
    weights += weight;
  }
  return sum / weights;
}

} // anonymous namespace

//------------------------------------------------------------------------------
DistanceInterpolationThreeFamilies::DistanceInterpolationThreeFamilies(int parts)
  : Parts(std::max(1, parts))
{
}

//------------------------------------------------------------------------------
std::string DistanceInterpolationThreeFamilies::Description() const
{
  return "the distance fields of x-, y- and z-slices, blended by the distance from the slices";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> DistanceInterpolationThreeFamilies::Reconstruct(
  const SliceSets& slices) const
{
  const vtkBoundingBox bounds = BoundsOf(slices);
  std::array<std::vector<Slice>, 3> families;
  Lattice lattice;
  for (int axis = 0; axis < 3; ++axis)
  {
    families[axis] = ExtractSlices(slices.Families[axis], axis);
    if (families[axis].empty())
    {
      return vtkSmartPointer<vtkPolyData>::New();
    }
    PadWithEmptySlices(families[axis], bounds.GetBound(2 * axis), bounds.GetBound(2 * axis + 1));
    lattice.Coordinates[axis] = RefineByNumber(families[axis], this->Parts);
  }
  const std::array<FamilyField, 3> fields{ FamilyField(families[0], 0, lattice),
    FamilyField(families[1], 1, lattice), FamilyField(families[2], 2, lattice) };
  return ExtractZeroSurface(
    lattice, SampleAll(lattice, [&fields](const auto& at) { return Blend(fields, at); }));
}

} // namespace baselines
} // namespace orthoslices
