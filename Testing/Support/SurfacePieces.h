// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a set of correspondences says about the surface, and what is true
 */

#ifndef OrthoSlicesSurfacePieces_h
#define OrthoSlicesSurfacePieces_h

#include "Core/Correspondence/FindCorrespondences.h"
#include "Support/AnalyticSolids.h"

#include <optional>

namespace orthoslices
{
namespace support
{

/**
 * The pieces into which the slices cut a solid or its surface. Every contour bounds one piece above
 * its slice (side 2 i of contour i) and one below (side 2 i + 1). Sides of one piece have
 * the same number, that of its first side: two descriptions of the same pieces are equal.
 */
using SurfacePieces = std::vector<Index>;

/// The pieces for which the correspondences stand: a piece is closed by caps where it has no other.
SurfacePieces PiecesOf(const std::vector<Correspondence>& pairs, Index contourCount);

/**
 * The true pieces: the solid is sampled on a grid between each two slices, also below the first and
 * above the last one, and flooded. Points of the slices belong to the grid; the grid has `layers`
 * layers between two slices and the given distance within a layer. Sections must not have holes.
 * Nothing if a contour has no grid point inside: the distance is too large.
 */
std::optional<SurfacePieces> TruePieces(
  const Solid& solid, const ContourStack& stack, int layers, double distance);

/**
 * Components of the surface, and its genus: the number of independent cycles of the graph in which
 * contours connect pieces. So pieces are taken for spheres with as many holes as they have sides.
 */
CountedTopology TopologyOf(const SurfacePieces& pieces);

/// Correspondences of different pieces, and how many are missing to connect the true ones.
struct Mistakes
{
  std::int64_t Wrong = 0;
  std::int64_t Missing = 0;
};

Mistakes CountMistakes(const std::vector<Correspondence>& pairs, const SurfacePieces& truth);

/// Pieces with several contours that all lie on one slice.
std::int64_t CountTurns(const SurfacePieces& pieces, const ContourStack& stack);

} // namespace support
} // namespace orthoslices

#endif
