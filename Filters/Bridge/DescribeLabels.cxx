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

std::string DescribeLosses(const std::vector<LabelLoss>& losses, const ContourLabels& labels)
{
  std::ostringstream text;
  for (const LabelLoss& loss : losses)
  {
    text << "\nLabel " << labels.NameOf(loss.Label) << ":";
    if (loss.Contours > 0)
    {
      text << " " << loss.Contours
           << " contours are too thin beside those of other labels, and are left out.";
    }
    if (loss.Parts > 0)
    {
      text << " Other labels are so close that its surface has " << loss.Parts
           << " parts more than without them.";
    }
  }
  return text.str();
}
}
