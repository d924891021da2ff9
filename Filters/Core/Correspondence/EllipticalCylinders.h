// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesEllipticalCylinders_h
#define OrthoSlicesEllipticalCylinders_h

#include "Core/Correspondence/FindCorrespondences.h"

#include <vector>

namespace orthoslices
{
/**
 * Generalized cylinders with elliptical sections, after B. Soroka, "Generalized cones from serial
 * sections" (1981), and Y. Bresler, J. Fessler, A. Macovski, "A Bayesian approach to reconstruction
 * from incomplete projections of a multiple object 3D domain" (1989).
 *
 *   1. An ellipse is fitted to each contour. Complex contours, with a misfit of more than 12 % of
 *      their area, are left out: nothing corresponds to them.
 *   2. Three ellipses on consecutive slices whose parameters (centre and shape) lie on a line start
 *      a cylinder, the best ones first. It grows upwards and downwards: the parameters of its last
 *      two ellipses are extrapolated, and the ellipse that is closest to them is taken if it is off
 *      by no more than the mean semi-axis.
 *   3. Of what is left, two ellipses of similar shape that are closest to each other form a
 *      cylinder of two slices. Others are cylinders of one.
 *   4. Cylinders are joined, also to branchings and handles: where a cylinder ends and the
 *      extrapolated ellipse overlaps the nearest one of the next slice, or the other way round.
 *
 * The papers were not available to us, only what surveys say of them: limits and the order of steps
 * are ours. Where cylinders that run side by side would explain the contours in several ways
 * without error, the steepest axis is taken.
 * Nothing joins two contours of one slice. Cost is the distance from the prediction, in mean
 * semi-axes.
 *
 * Time grows with the square of the number of contours on two slices.
 */
std::vector<Correspondence> CorrespondencesByCylinders(const ContourStack& stack);
}

#endif
