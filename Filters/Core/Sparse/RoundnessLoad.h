// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRoundnessLoad_h
#define OrthoSlicesRoundnessLoad_h

#include "Core/Sparse/SurfaceMesh.h"

#include <vector>

namespace orthoslices
{
struct BendingOperator;

/// What pushes the surface of least bending outwards, where it is round.
struct RoundnessLoad
{
  std::vector<Point3> Force; ///< of each point, for the right side of the equations of bending
  std::vector<double> Reach; ///< how far it may move each point, in world units

  bool IsEmpty() const { return this->Force.empty(); }
};

/**
 * The load with which balls and cylinders are what bends least. With the areas and the Laplacian of
 * a surface held fast, they are not: between contours a ball gets flatter, as the Laplacian of its
 * curvature vector 2 H n is not zero, but -2 H (k1^2 + k2^2) n, with n outwards, H the mean and k1,
 * k2 the principal curvatures. That is as if it were loaded from outside. A load of the same size
 * from inside leaves what the change of H along the surface bends, so that the surface tends to one
 * with a harmonic mean curvature (as in R. Schneider and L. Kobbelt, "Geometric fairing of
 * irregular meshes for free-form surface design", 2001). The load is taken from the surface as it
 * is, which has to be about right.
 *
 * Curvatures count up to two by the width of the cell between planes: what is rounder than that,
 * contours do not show, and a load on it would grow from one time to the next. And no point moves
 * farther than a quarter of an edge. Stretched points have no load: they are stretched so that
 * tubes keep their radius.
 *
 * REQUIRES: the operator is that of the mesh, with EdgeWeights::RoundCotangents.
 */
RoundnessLoad KeepRound(const BendingOperator& bending, const SurfaceMesh& mesh);
/// The same, with an operator that is made for it.
RoundnessLoad KeepRound(const SurfaceMesh& mesh);
}

#endif
