// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether the pieces of several processes are the surface of one
 */

#ifndef OrthoSlicesUnionOfPieces_h
#define OrthoSlicesUnionOfPieces_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace orthoslices
{
namespace support
{

/**
 * What tells the union of the pieces from a surface, bit by bit: points, triangles, arrays of both
 * by the global ids of the pieces, and field data, which each piece has. Each point has to be that of
 * one piece alone that does not mark it as a duplicate, the first that has it. Empty if nothing does.
 */
std::string CompareUnion(
  const std::vector<vtkSmartPointer<vtkPolyData>>& pieces, vtkPolyData* surface);

} // namespace support
} // namespace orthoslices

#endif
