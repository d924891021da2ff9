// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a surface of VTK, for the checkers
 */

#ifndef OrthoSlicesPolyDataMesh_h
#define OrthoSlicesPolyDataMesh_h

#include "Support/TriangleMesh.h"

class vtkPolyData;

namespace orthoslices
{
namespace support
{

/// All points and cells. A cell that is no triangle has the corners -1, which no check accepts.
TriangleMesh MeshOf(vtkPolyData* surface);

} // namespace support
} // namespace orthoslices

#endif
