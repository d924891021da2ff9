// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesInnerPatches_h
#define OrthoSlicesInnerPatches_h

#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Cells/PatchMesh.h"
#include "Core/Patches/LightenArcs.h"
#include "Core/Patches/SmoothPatch.h"

#include <vector>

namespace orthoslices
{
/**
 * How spatial polygons are filled (the paper's section 5 leaves it open).
 *
 * A new type of patch takes
 *   1. a value here (last: the numbers are those of the filter's property), and the answers of
 *      NeedsNormals and GivesNormals for it;
 *   2. a function in InnerPatches.cxx that builds the patch of one polygon, from its border to an
 *      InnerPatch, and its name in FillerOf there;
 *   3. its name in PatchType of vtkOrthogonalSliceReconstruction.h and of the plugin's XML.
 *
 * The function guarantees, whenever it returns true:
 *   - The triangles are a disc whose border is the polygon's, each side of it passed once in its
 *     direction, so that they run counter-clockwise seen from outside.
 *   - There is a point inside at least, all are in use, rounded by PatchBorder::MoveInside and so
 *     strictly inside the cell; each has a unit normal, or zero where the triangles say more.
 *   - No side of a triangle but those of the border lies on a face of the cell.
 *   - The patch does not touch itself. PatchView::SeesAll proves that.
 *   - The result depends on the border alone, not on the polygons that were filled before.
 * Where it cannot, it returns false: then the polygon is a fan around its central point, which has
 * all of this. Patches of one cell that touch each other are found and taken out afterwards
 * (RemoveTouching).
 */
enum class PatchMethod
{
  Smooth, ///< see SmoothPatchBuilder and BuildCreasePatch
  Fan,    ///< the paper's quadrilaterals, each a fan around the central point
  Coons   ///< the paper's quadrilaterals, bilinearly blended: see BuildCoonsPatch
};

/// Whether patches of a type are made from the surface's normals, so that these must be estimated.
bool NeedsNormals(PatchMethod method);

/// Whether patches of a type are smooth: then the normals of their points, and those of the surface
/// along the contours, say more than those of the triangles.
bool GivesNormals(PatchMethod method);

class SharedPatches;

struct PatchOptions
{
  PatchMethod Method = PatchMethod::Smooth;
  double CornerAngle = 1.0471975511965976; ///< of contours: 60 degrees; see EstimateNormals
  double EdgeLength = 0.25;                ///< of triangles inside patches, in mean plane spacings
  double ChordTolerance = 0.0;             ///< in mean plane spacings; see PatchResolution
  /**
   * With few triangles, how far contours may be from the surface, in mean spacings of the planes
   * across their slices: see LightenArcs, SmoothPatchBuilder and ImproveSurface. Then EdgeLength is
   * measured in quarters of a patch's mean radius. 0: contours keep their vertices. For
   * PatchMethod::Smooth.
   */
  double Accuracy = 0.0;
  /// If Accuracy is 0, it follows from the error of the surface, as FitError estimates it.
  bool OwnAccuracy = false;
  /// Whether triangles are to be few.
  bool IsLight() const { return this->OwnAccuracy || this->Accuracy > 0.0; }
  /// With few triangles, contours keep their vertices all the same.
  bool KeepContours = false;
  /// Patches of structures that were made before: taken over where borders are the same, and added
  /// to.
  SharedPatches* Shared = nullptr;
  /// The cycles that are filled; or null: all. What they become does not depend on it.
  const Portion* Part = nullptr;
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

/// What patches are made from: the polygons of all cells, and what is known of the surface there.
struct PatchTables
{
  const CycleGeometry& Geometry;
  const CellGroups& Cells;
  const SurfaceNormals& Normals;            ///< may be empty for types that do not need them
  const std::vector<double>& CentralPoints; ///< x, y, z of each cycle
  const std::vector<PatchMesh>& Meshes;     ///< the patches of shells and of several cycles
  /// Where the triangles' vertices on contours are, if not at all points of G; or null. Patches are
  /// fitted to the arcs of G, and triangulated with these.
  const LightGraph* Light = nullptr;

  Point3 CentralPoint(Index cycle) const
  {
    const double* p = this->CentralPoints.data() + 3 * static_cast<std::size_t>(cycle);
    return { p[0], p[1], p[2] };
  }
};

/**
 * Fills the cycles that are in no mesh. Of borders with corners, those for which that explains more
 * get a crease, and the others a smooth patch. Cycles that cannot be filled as asked for, and loops
 * with Coons, get none: they stay fans around their central point. So do those whose patch would
 * touch another one of its cell, as their fans do not. Coons patches have 0.5 / EdgeLength parts
 * along each side.
 */
InnerPatches BuildInnerPatches(
  const PatchTables& tables, const PatchOptions& options, const Execution& execution);
}

#endif
