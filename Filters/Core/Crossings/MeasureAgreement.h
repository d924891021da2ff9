// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesMeasureAgreement_h
#define OrthoSlicesMeasureAgreement_h

#include "Core/Base/Contours.h"
#include "Core/Crossings/PairNodePoints.h"

#include <vector>

namespace orthoslices
{
/// How far contours lie from the orthogonal contours that they meet in node points, along the
/// grid edges.
struct Agreement
{
  Index NodePoints = 0;
  double SumOfSquares = 0.0;
  double Greatest = 0.0;

  void Add(double disagreement);
  double RootMeanSquare() const;
};

/**
 * Agreement of every contour and of every slice with the orthogonal families, real slices with real
 * ones alone: virtual ones have no node points here.
 *
 * Shift is the translation of a whole slice within its plane that would bring it closest to the
 * others, by least squares over its node points: the disagreement along the edge is explained by
 * a movement along the contour's normal. It shows a slice that was moved as a whole (a patient
 * who moved), while noise averages out.
 */
struct SliceAgreement
{
  std::vector<Agreement> OfContour;
  std::array<std::vector<Agreement>, 3> OfPlane;
  std::array<std::vector<Point3>, 3> Shift;
};

/// `nodeNormals` as from ComputeNodeNormals.
SliceAgreement MeasureAgreement(const Contours& contours, const SpatialGrid& grid,
  const GridCrossings& crossings, const NodePoints& nodes, const std::vector<double>& nodeNormals);
}

#endif
