// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   shapes with known surface and their contours on disk, and contours cut from a surface
 *
 * A data folder has one folder per case with truth.vtp, the known closed surface, and
 * n16_x.vtp, n16_y.vtp, n16_z.vtp, n32_x.vtp ...: contours on 16 or 32 planes per axis. Folders
 * without these files are no cases.
 */

#ifndef OrthoSlicesCaseFolder_h
#define OrthoSlicesCaseFolder_h

#include "Baseline.h"

#include <array>
#include <string>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/**
 * Names of all cases in a folder, in alphabetical order.
 * @throw std::runtime_error if the folder does not exist or holds none.
 */
std::vector<std::string> ListCases(const std::string& folder);

/// @throw std::runtime_error if the file is missing, is no polydata or holds no polygons.
vtkSmartPointer<vtkPolyData> ReadTruth(const std::string& folder, const std::string& name);

/// The contours on NUMBER planes per axis. @throw std::runtime_error as ReadTruth() does.
SliceSets ReadSlices(const std::string& folder, const std::string& name, int number);

/**
 * Contours of SURFACE on NUMBERS planes per axis, cut by vtkOrthogonalSlicer. Families of no planes
 * are empty.
 */
SliceSets CutSurface(vtkPolyData* surface, const std::array<int, 3>& numbers);

/// Mean distance of consecutive planes of one family; 0 if there are fewer than two planes.
double SpacingOf(vtkPolyData* contours, int axis);

/// The unit h of all figures: the geometric mean of the spacings of the families that have one.
double MeanSpacing(const SliceSets& slices);

} // namespace baselines
} // namespace orthoslices

#endif
