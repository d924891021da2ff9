// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/DescribeLabels.h"

#include <iomanip>
#include <sstream>

namespace orthoslices
{
std::string DescribeOverlaps(const std::vector<LabelOverlap>& overlaps, const ContourLabels& labels)
{
  std::ostringstream text;
  if (!overlaps.empty())
  {
    const LabelOverlap& greatest = overlaps.front();
    text << "\nContours of " << overlaps.size() << " pairs of labels overlap, those of "
         << labels.NameOf(greatest.First) << " and " << labels.NameOf(greatest.Second)
         << " most, by " << std::setprecision(2) << 100.0 * greatest.Share
         << " % of the smaller one. Their surfaces cross there.";
  }
  return text.str();
}
}
