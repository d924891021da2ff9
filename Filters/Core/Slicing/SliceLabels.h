// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSliceLabels_h
#define OrthoSlicesSliceLabels_h

#include "Core/Slicing/SliceImage.h"

#include <vector>

namespace orthoslices
{
/// The contours of one plane, and the label of each.
struct LabelContours
{
  PlaneContours Contours;
  std::vector<double> Labels;
};

/**
 * Draws the contours around the samples of each label of a plane, in ascending order of labels;
 * none around those of the background, and of what is not finite. For each label they are what
 * SliceImage draws around the samples that have it, halfway to their neighbours. `us` and `vs` are
 * as there.
 *
 * Where the samples of two labels are neighbours, the contours of both have the same vertex halfway
 * between them, so that common borders coincide. Where three or four labels, the background among
 * them, meet in one square of samples, the contours of all have a vertex more, in its middle, so
 * that nothing is left between them. Where two samples on a diagonal of a square have the same label
 * and the other two have two others, contours of the one cut its corners off, and the others meet
 * between them; where the other two have the same, too, the greater one of both labels is joined
 * through the middle. If one of them is background, the middle is, too. Contours never cross.
 */
LabelContours SliceLabels(const SamplePlane& plane, double background,
  const std::vector<double>& us, const std::vector<double>& vs, Precision precision);
}

#endif
