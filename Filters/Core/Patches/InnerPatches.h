// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesInnerPatches_h
#define OrthoSlicesInnerPatches_h

#include "Core/Base/Execution.h"
#include "Core/Cells/PatchMesh.h"
#include "Core/Patches/SmoothPatch.h"

#include <vector>

namespace orthoslices
{
/// How spatial polygons are filled (the paper's section 5 leaves it open).
enum class PatchMethod
{
  Smooth, ///< see SmoothPatchBuilder and BuildCreasePatch
  Fan,    ///< the paper's quadrilaterals, each a fan around the central point
  Coons   ///< the paper's quadrilaterals, bilinearly blended: see BuildCoonsPatch
};

struct PatchOptions
{
  PatchMethod Method = PatchMethod::Smooth;
  double CornerAngle = 1.0471975511965976; ///< of contours: 60 degrees; see EstimateNormals
  double EdgeLength = 0.25;                ///< of triangles inside patches, in mean plane spacings
  double ChordTolerance = 0.0;             ///< in mean plane spacings; see PatchResolution
};

/**
 * Patches of one cycle each that have points inside, one after another, ascending by their cycles.
 * Patch i has the points PointOffsets[i] to PointOffsets[i + 1] - 1, one at least, and likewise its
 * triangles. Corners of triangles are as in PatchMesh.
 */
struct InnerPatches
{
  std::vector<Index> Cycle;
  std::vector<std::int64_t> PointOffsets{ 0 }, TriangleOffsets{ 0 };
  std::vector<double> Points; ///< x, y, z of each
  std::vector<float> Normals; ///< unit vectors; zero where the triangles say more
  std::vector<Index> Corners; ///< three of each triangle

  Index Count() const { return static_cast<Index>(this->Cycle.size()); }
  void Add(Index cycle, const InnerPatch& patch);
  void Add(const InnerPatches& others, Index patch);
  Point3 PointAt(std::int64_t point) const
  {
    const double* p = this->Points.data() + 3 * point;
    return { p[0], p[1], p[2] };
  }
};

/**
 * Fills the cycles that `meshes` has no patch for. Of borders with corners, those for which that
 * explains more get a crease, and the others a smooth patch. Cycles that cannot be filled as asked
 * for, and loops with Coons, get none: they stay fans around their central point. So do those whose
 * patch would touch another one of its cell, as their fans do not. Coons patches have
 * 0.5 / EdgeLength parts along each side.
 */
InnerPatches BuildInnerPatches(const CycleGeometry& geometry, const CellGroups& cells,
  const SurfaceNormals& normals, const std::vector<double>& centralPoints,
  const std::vector<PatchMesh>& meshes, const PatchOptions& options, const Execution& execution);
}

#endif
