// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDescribeLabels_h
#define OrthoSlicesDescribeLabels_h

#include "Bridge/ReadLabels.h"
#include "Core/ReconstructLabels.h"

#include <string>

namespace orthoslices
{
/// One line on labels whose contours overlap, with the greatest overlap; empty if there are none.
std::string DescribeOverlaps(
  const std::vector<LabelOverlap>& overlaps, const ContourLabels& labels);

/// One line for each label that has lost something where others are close; empty if none has.
std::string DescribeLosses(const std::vector<LabelLoss>& losses, const ContourLabels& labels);
}

#endif
