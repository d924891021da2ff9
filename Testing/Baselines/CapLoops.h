// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   flat triangulated caps on loops of one plane
 */

#ifndef OrthoSlicesCapLoops_h
#define OrthoSlicesCapLoops_h

#include "vtkType.h"

#include <vector>

class vtkCellArray;
class vtkPoints;

namespace orthoslices
{
namespace baselines
{

/**
 * Appends triangles that fill the loops, given by ids of POINTS.
 * Boundaries of holes run against those of the interior. Every edge of every loop gets exactly one
 * triangle, which passes it in the loop's direction. Where vtkContourTriangulator cannot do
 * that (loops that cross each other, holes without a loop around them), loops are filled one by
 * one, the last resort being a fan around the mean of the vertices.
 */
void CapLoops(
  const std::vector<std::vector<vtkIdType>>& loops, vtkPoints* points, vtkCellArray* triangles);

} // namespace baselines
} // namespace orthoslices

#endif
