// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTakePiece_h
#define OrthoSlicesTakePiece_h

#include "Core/Base/Ranks.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace orthoslices
{
/**
 * Marks a surface as the piece of one process: the global ids of its points and cells, which are
 * their ids in the surface that one process makes, and the points that a process before it has,
 * too. The arrays are those of vtkGenerateGlobalIds: "GlobalPointIds", "GlobalCellIds", and
 * "vtkGhostType" of the points.
 */
void MarkPiece(const std::vector<vtkIdType>& pointIds, vtkIdType firstTriangle,
  const std::vector<unsigned char>& isDuplicate, vtkPolyData* piece);

/// Leaves the points that triangles have, and returns their former ids, ascending.
std::vector<vtkIdType> KeepUsedPoints(vtkPolyData* surface);

/// Leaves of a whole surface of triangles the piece of one process: as many triangles for each, in
/// their order, with their points. Field data stay those of the whole.
void TakePiece(const Ranks& ranks, vtkPolyData* surface);
}

#endif
