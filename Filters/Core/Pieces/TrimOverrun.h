// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesTrimOverrun_h
#define OrthoSlicesTrimOverrun_h

#include "Core/Pieces/OpenCurve.h"

namespace orthoslices
{
/**
 * Trims a curve that runs past its start, so that its ends meet: where its last part crosses or
 * touches its first part, or else where it comes closest to its start, if what follows runs along
 * the first part. What is trimmed is at most a quarter of the curve at either end. Returns whether
 * it was trimmed; it is a loop then, and Trimmed is set.
 */
bool TrimOverrun(OpenCurve& curve);

/// The same between two curves, where the last part of one runs past the start of the next. Returns
/// the length of what was trimmed of both.
double TrimOverlap(std::vector<Point2>& curve, std::vector<Point2>& next);
}

#endif
