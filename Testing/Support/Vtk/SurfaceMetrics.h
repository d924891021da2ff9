// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how far a triangle surface is from a known one, and what its topology is
 *
 * Distances are symmetric: samples are taken on both surfaces, one in each of many parts of equal
 * area (stratified sampling), and measured exactly to the nearest triangle of the other one. Mean
 * and normal deviation are averages of the two directions, the RMS distance is the root of the
 * averaged squares, and the Hausdorff distance is the larger of the two maxima over samples and
 * vertices, of which every one counts up to ten times the number of samples (a lower bound of the
 * true one, as for every sampled measurement). The same idea is
 * described in P. Cignoni, C. Rocchini, R. Scopigno, "Metro: measuring error on simplified
 * surfaces", Computer Graphics Forum 17(2), 1998.
 *
 * The samples depend on the surface only: two measurements of the same pair are identical.
 *
 * Topology is counted after points of exactly equal coordinates were united and triangles with
 * two equal corners were left out. Components are sets of triangles connected through edges. The
 * genus is the sum over all components, each with a disc in every boundary loop; it does not exist
 * where an edge has more than two triangles or neighbours are oriented against each other.
 */

#ifndef OrthoSlicesSurfaceMetrics_h
#define OrthoSlicesSurfaceMetrics_h

#include <cstdint>
#include <optional>

class vtkPolyData;

namespace orthoslices
{
namespace support
{

/// Numbers that do not change when the surface is bent.
struct Topology
{
  std::int64_t Points = 0;
  std::int64_t Triangles = 0;
  std::int64_t Components = 0;
  std::int64_t OpenEdges = 0;           ///< edges of one triangle
  std::int64_t NonManifoldEdges = 0;    ///< edges of more than two triangles
  std::int64_t NonManifoldVertices = 0; ///< vertices whose triangles form several fans
  std::int64_t InconsistentEdges = 0;   ///< edges with two triangles of opposite orientation
  std::int64_t EulerCharacteristic = 0; ///< with vertices counted once in every fan
  std::optional<std::int64_t> Genus;    ///< sum over the components

  /// Not empty and without open edges.
  bool IsWatertight() const { return this->Triangles > 0 && this->OpenEdges == 0; }

  /// Watertight, 2-manifold and consistently oriented.
  bool IsClosedManifold() const
  {
    return this->IsWatertight() && this->NonManifoldEdges == 0 && this->NonManifoldVertices == 0 &&
      this->InconsistentEdges == 0;
  }
};

/// Lengths in world units; divide by the slice spacing with ScaledBy(1 / h).
struct Deviation
{
  double RootMeanSquare = 0.0;
  double Mean = 0.0;
  double Hausdorff = 0.0;
  double NormalDegrees = 0.0; ///< mean angle between the normals of a sample and of its foot

  Deviation ScaledBy(double factor) const;
};

/// Counts of SURFACE, polygons and strips taken as triangles.
Topology MeasureTopology(vtkPolyData* surface);

/// Enclosed volume (divergence theorem); positive if the triangles are oriented outwards.
double MeasureVolume(vtkPolyData* surface);

/// Area of all triangles.
double MeasureArea(vtkPolyData* surface);

/**
 * Distances between SURFACE and TRUTH from SAMPLES samples on each of them. Nothing is returned
 * if one of the surfaces has no area.
 */
std::optional<Deviation> MeasureDeviation(
  vtkPolyData* surface, vtkPolyData* truth, std::int64_t samples = 100000);

} // namespace support
} // namespace orthoslices

#endif
