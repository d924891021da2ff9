// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/ArcSources.h"

namespace orthoslices
{
namespace
{
/// The contour of which an arc has most vertices, or None if it is of no contour.
Index FindContour(const GridCrossings& crossings, Index arc)
{
  Index contour = GridCrossings::None;
  Index most = -1;
  for (Index run = arc; run != GridCrossings::None; run = crossings.RunNext[run])
  {
    if (crossings.RunContour[run] != GridCrossings::None && crossings.RunCount[run] > most)
    {
      most = crossings.RunCount[run];
      contour = crossings.RunContour[run];
    }
  }
  return contour;
}

/// Gives arcs of no contour that of the next arc along the closed curve that has one.
void FollowCurves(const GridCrossings& crossings, std::vector<Index>& contours)
{
  constexpr Index seen = -2; // on the way now, or on a curve without any contour
  for (Index arc = 0; arc < crossings.Count(); ++arc)
  {
    Index end = arc;
    while (!crossings.IsRemoved(end) && contours[end] == GridCrossings::None)
    {
      contours[end] = seen;
      end = crossings.Next[end];
    }
    for (Index i = arc; i != end && contours[i] == seen && contours[end] >= 0;)
    {
      contours[i] = contours[end];
      i = crossings.Next[i];
    }
  }
}
}

std::int64_t SourceOf(const Contours& contours, Index contour)
{
  return contour < 0 || contours.IsVirtual(contour) ? NoSource : contours.Cell[contour];
}

std::vector<std::int64_t> FindArcSources(const Contours& contours, const GridCrossings& crossings)
{
  std::vector<Index> ofArc(crossings.Count(), GridCrossings::None);
  bool isAny = false;
  for (Index arc = 0; arc < crossings.Count(); ++arc)
  {
    if (!crossings.IsRemoved(arc))
    {
      ofArc[arc] = FindContour(crossings, arc);
      isAny |= ofArc[arc] == GridCrossings::None;
    }
  }
  if (isAny)
  {
    FollowCurves(crossings, ofArc);
  }
  std::vector<std::int64_t> sources(ofArc.size(), NoSource);
  for (std::size_t arc = 0; arc < ofArc.size(); ++arc)
  {
    sources[arc] = SourceOf(contours, ofArc[arc]);
  }
  return sources;
}
}
