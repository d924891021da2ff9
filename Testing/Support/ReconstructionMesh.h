// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the surface of a reconstruction, for the checkers
 */

#ifndef OrthoSlicesReconstructionMesh_h
#define OrthoSlicesReconstructionMesh_h

#include "Core/Reconstruct.h"
#include "Core/ReconstructLabels.h"
#include "Support/TriangleMesh.h"

#include <vector>

namespace orthoslices
{
namespace support
{

/// Points and triangles with the ids that the filter gives them. A corner that was never written is
/// -1.
TriangleMesh MeshOf(const Reconstruction& result);

/// Surfaces of several structures, in one mesh.
struct LabelMesh
{
  TriangleMesh Mesh;
  std::vector<int> Labels; ///< of the triangles
};

LabelMesh MeshOf(const LabelSurfaces& surfaces);

} // namespace support
} // namespace orthoslices

#endif
