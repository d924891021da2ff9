// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   closed triangle meshes of solids of revolution, for tests
 */

#ifndef OrthoSlicesParametricMeshes_h
#define OrthoSlicesParametricMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>

namespace orthoslices
{
namespace baselines
{

/**
 * Torus around the origin; AXIS is the direction of its axis of revolution. AROUND x ACROSS
 * vertices on the exact surface, oriented outwards.
 */
vtkSmartPointer<vtkPolyData> MakeTorus(const std::array<double, 3>& axis, double majorRadius,
  double minorRadius, int around, int across);

/// All points at most RADIUS from the segment FROM - TO: a tube with round ends, oriented outwards.
vtkSmartPointer<vtkPolyData> MakeCapsule(
  const std::array<double, 3>& from, const std::array<double, 3>& to, double radius, int around);

} // namespace baselines
} // namespace orthoslices

#endif
