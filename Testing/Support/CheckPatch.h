// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   whether a patch with triangles of its own is what the header says of it
 */

#ifndef OrthoSlicesCheckPatch_h
#define OrthoSlicesCheckPatch_h

#include "Core/Cells/PatchMesh.h"
#include "Support/CheckSurface.h"

#include <string>

namespace orthoslices
{
namespace support
{

/**
 * What is wrong with a patch; empty if it is a connected surface of genus 0 whose open sides are
 * the borders of its cycles, each passed once and in the direction of the cycle, with all of its
 * own points in use and strictly inside the cell.
 */
std::string DescribePatchFlaws(const CycleGeometry& geometry, const PatchMesh& patch);

/// The triangles of a patch alone.
TriangleMesh MeshOf(const CycleGeometry& geometry, const PatchMesh& patch);

} // namespace support
} // namespace orthoslices

#endif
