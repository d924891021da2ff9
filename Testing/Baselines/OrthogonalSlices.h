// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the project's own filter behind the interface of the methods it is compared with
 */

#ifndef OrthoSlicesOrthogonalSlices_h
#define OrthoSlicesOrthogonalSlices_h

#include "Baseline.h"

namespace orthoslices
{
namespace baselines
{

/// vtkOrthogonalSliceReconstruction with its default settings, given all families.
class OrthogonalSlices : public Baseline
{
public:
  std::string Name() const override { return "orthogonal"; }
  std::string Description() const override;
  std::array<bool, 3> UsesFamilies() const override { return { true, true, true }; }
  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets& slices) const override;
};

/// The same, given z-slices only: parallel slices are joined.
class OneFamily : public OrthogonalSlices
{
public:
  std::string Name() const override { return "orthogonal-z"; }
  std::string Description() const override;
  std::array<bool, 3> UsesFamilies() const override { return { false, false, true }; }
};

} // namespace baselines
} // namespace orthoslices

#endif
