// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   sparse and incomplete slices out of dense ones, and methods for z-slices on any family
 */

#ifndef OrthoSlicesChosenPlanes_h
#define OrthoSlicesChosenPlanes_h

#include "Baseline.h"

#include <array>
#include <memory>
#include <string>

namespace orthoslices
{
namespace baselines
{

/**
 * As many planes of each family as NUMBERS says, evenly among those that are there: plane
 * floor((i + 1/2) N / n) of N for i = 0 ... n - 1. Planes without contours are planes like any
 * other, and known afterwards from the cell array "PlaneIndex"; but a single plane is the middle
 * one of those that have contours. A family without contours is null.
 */
SliceSets ChoosePlanes(const SliceSets& slices, const std::array<int, 3>& numbers);

/**
 * Turns coordinates by STEPS from x to y, y to z and z to x. Arrays stay as they are; null becomes
 * null.
 */
vtkSmartPointer<vtkPolyData> RotateAxes(vtkPolyData* data, int steps);

/**
 * A method for z-slices on the family that has most planes; of equally many, z before y before x.
 * Name and description are those of the method.
 */
class AlongMostPlanes : public Baseline
{
public:
  explicit AlongMostPlanes(std::unique_ptr<Baseline> method);

  std::string Name() const override { return this->Method->Name(); }
  std::string Description() const override { return this->Method->Description(); }
  std::array<bool, 3> UsesFamilies() const override { return { true, true, true }; }

  /// Families may be null.
  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets& slices) const override;

private:
  std::unique_ptr<Baseline> Method;
};

} // namespace baselines
} // namespace orthoslices

#endif
