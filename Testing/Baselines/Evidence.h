// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the claim of the paper's Figure 1, measured: which method gets which solid right
 */

#ifndef OrthoSlicesEvidence_h
#define OrthoSlicesEvidence_h

#include "Support/CheckSurface.h"
#include "Support/InclinedSolids.h"
#include "Support/SurfacePieces.h"

#include <iosfwd>
#include <map>

namespace orthoslices
{
namespace baselines
{

/// The four criteria for parallel slices.
extern const std::array<CorrespondenceCriterion, 4> AllCriteria;

std::string NameOf(CorrespondenceCriterion criterion);

/// What a criterion makes of the z-slices.
struct Verdict
{
  std::vector<Correspondence> Pairs;
  support::CountedTopology Topology{ 0, 0 };
  support::Mistakes Errors;
  bool Right = false; ///< exactly the true pieces, hence the true topology
};

/// One solid with what all methods make of it.
struct Evidence
{
  support::InclinedSolid Object;
  ContourStack Stack;           ///< z-slices
  support::SurfacePieces Truth; ///< by flooding the solid
  std::array<Verdict, 4> Verdicts;

  support::TriangleMesh Surface;                 ///< ours, from all slices
  support::CountedTopology Orthogonal{ -1, -1 }; ///< of Surface; -1: not closed or not manifold
  bool OrthogonalRight = false;
};

/**
 * The Reeb graph is given the true numbers of components and handles, the others nothing. Throws
 * std::runtime_error if flooding does not give the topology that the solid is known to have.
 */
Evidence Judge(const support::InclinedSolid& object);

/// Number of spatial polygons by their number of node points, over all data sets of the folder Data
/// with `planes` planes on each axis (the paper's Figure 8).
std::map<Index, std::int64_t> CountPolygonSizes(int planes);

/// Markdown: one line for each object, "right" or what is wrong for each method.
void PrintEvidence(const std::vector<Evidence>& all, std::ostream& out);

/// Markdown: for each family of objects and each method, how many it got right.
void PrintFamilies(const std::vector<Evidence>& all, std::ostream& out);

/**
 * Files for pictures, named after the family and the object: "-surface" (ours), "-contours" (the
 * z-slices) and one for each criterion: lines between the centres of contours that correspond, with
 * the cell array Right. Throws std::runtime_error if one cannot be written.
 */
void WriteEvidence(const Evidence& evidence, const std::string& folder);

} // namespace baselines
} // namespace orthoslices

#endif
