// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/ThinContours.h"

#include "Core/Graph/SimplifyArcs.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
Index SlabOf(const std::vector<double>& planes, double coordinate)
{
  return static_cast<Index>(
    std::upper_bound(planes.begin(), planes.end(), coordinate) - planes.begin());
}
}

ContourThinner::ContourThinner(
  double tolerance, const std::vector<double>& planesU, const std::vector<double>& planesV)
  : Tolerance(tolerance)
  , PlanesU(planesU)
  , PlanesV(planesV)
{
}

PlaneContours ContourThinner::Run(const PlaneContours& contours)
{
  PlaneContours thin;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const Index first = contours.Offsets[i];
    const Index last = contours.Offsets[i + 1];
    this->MarkCrossing(contours, first, last);
    std::size_t start = 0;
    for (std::size_t end = 1; end <= this->Stays.size(); ++end)
    {
      if (this->Stays[end % this->Stays.size()])
      {
        this->MarkBetween(contours, first, start, end);
        start = end;
      }
    }
    const bool isSmall = std::count(this->Stays.begin(), this->Stays.end(), 1) < 3;
    for (Index v = first; v < last; ++v)
    {
      if (isSmall || this->Stays[v - first])
      {
        thin.AddVertex(contours.U[v], contours.V[v]);
      }
    }
    thin.CloseContour();
  }
  return thin;
}

std::pair<Index, Index> ContourThinner::SlabsAt(const PlaneContours& contours, Index vertex) const
{
  return { SlabOf(this->PlanesU, contours.U[vertex]), SlabOf(this->PlanesV, contours.V[vertex]) };
}

/// Marks the first vertex of a contour, and both ends of all sides that cross a plane.
void ContourThinner::MarkCrossing(const PlaneContours& contours, Index first, Index last)
{
  this->Stays.assign(static_cast<std::size_t>(last - first), 0);
  this->Stays[0] = 1;
  Index previous = last - 1;
  auto before = this->SlabsAt(contours, previous);
  for (Index v = first; v < last; ++v)
  {
    const auto slabs = this->SlabsAt(contours, v);
    if (slabs != before)
    {
      this->Stays[v - first] = this->Stays[previous - first] = 1;
    }
    previous = v;
    before = slabs;
  }
}

/// Marks what stays between two vertices that do; the contour begins at `first`.
void ContourThinner::MarkBetween(
  const PlaneContours& contours, Index first, std::size_t start, std::size_t end)
{
  this->Line.clear();
  for (std::size_t i = start; i <= end; ++i)
  {
    const Index v = first + static_cast<Index>(i % this->Stays.size());
    this->Line.push_back({ contours.U[v], contours.V[v], 0.0 });
  }
  MarkKept(this->Line, this->Tolerance, this->Kept);
  std::copy(this->Kept.begin() + 1, this->Kept.end() - 1, this->Stays.begin() + start + 1);
}
}
