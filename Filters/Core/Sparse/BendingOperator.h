// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBendingOperator_h
#define OrthoSlicesBendingOperator_h

#include "Core/Sparse/FairSurface.h"
#include "Core/Sparse/SurfaceMesh.h"

#include <Eigen/SparseCore>

#include <vector>

namespace orthoslices
{
using SparseMatrix = Eigen::SparseMatrix<double>;
/// A vector for each point or each equation.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// The Laplacian of a mesh: applied to the coordinates and divided by the areas it is the vector of
/// twice the mean curvature, which points inwards where the surface is convex.
struct BendingOperator
{
  SparseMatrix Laplacian;   ///< square; rows of unused points are empty
  std::vector<double> Area; ///< of each point
};

BendingOperator MakeBendingOperator(EdgeWeights weights, const SurfaceMesh& mesh);
}

#endif
