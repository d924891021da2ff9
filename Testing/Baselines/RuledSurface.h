// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   vtkRuledSurfaceFilter on the z-slices, prepared with care and without
 */

#ifndef OrthoSlicesRuledSurface_h
#define OrthoSlicesRuledSurface_h

#include "Baseline.h"

namespace orthoslices
{
namespace baselines
{

/**
 * VTK's class for surfaces from slices with the best usual preparation: loops are oriented by
 * nesting; loops of consecutive slices are paired one to one by overlap (PairByOverlap.h); the
 * first vertex of every loop is the one that makes the rules to its partner below shortest; each
 * pair becomes a strip of vtkRuledSurfaceFilter; loops without a partner on one side are closed
 * there by a flat cap, and loops without any partner are left out. Strips and caps share their
 * vertices, so the surface is watertight.
 *
 * OrientLoops of vtkRuledSurfaceFilter stays off: start vertices are aligned already, and in
 * point-walk mode VTK 9.2 can run without end with it.
 */
class RuledSurface : public Baseline
{
public:
  enum class Mode
  {
    Resample, ///< as many equally spaced points on every loop
    PointWalk ///< the vertices of the contours themselves
  };

  /// RESOLUTION: points per loop for Mode::Resample.
  explicit RuledSurface(Mode mode, int resolution = 200);

  std::string Name() const override;
  std::string Description() const override;
  std::array<bool, 3> UsesFamilies() const override { return { false, false, true }; }
  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets& slices) const override;

private:
  Mode StripMode;
  int Resolution;
};

/**
 * The whole stack given to vtkRuledSurfaceFilter as it is, in resample mode: consecutive contours
 * of the list are joined, whether they lie in one slice, belong together, or not.
 */
class NaiveRuledSurface : public Baseline
{
public:
  std::string Name() const override { return "ruled-naive"; }
  std::string Description() const override;
  std::array<bool, 3> UsesFamilies() const override { return { false, false, true }; }
  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets& slices) const override;
};

} // namespace baselines
} // namespace orthoslices

#endif
