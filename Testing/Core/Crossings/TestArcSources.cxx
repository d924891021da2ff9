// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which contour of the input each arc is a part of
 */

#include "Core/Crossings/ArcSources.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
/// Four contours with the cells 10 to 13, the last one on a virtual plane.
Contours FourContours()
{
  Contours contours;
  contours.Axis = { 0, 0, 0, 0 };
  contours.Cell = { 10, 11, 12, 13 };
  contours.Virtual = { 0, 0, 0, 1 };
  return contours;
}

/// Adds a closed curve; each arc has one run with that many vertices of its contour.
void AddCurve(
  const std::vector<Index>& contours, const std::vector<Index>& counts, GridCrossings& crossings)
{
  const Index first = crossings.Count();
  const Index size = static_cast<Index>(contours.size());
  for (Index i = 0; i < size; ++i)
  {
    const Index c = crossings.Insert(0, 0.0, 1, 0);
    crossings.RunContour[c] = contours[i];
    crossings.RunCount[c] = counts[i];
    crossings.Next[c] = first + (i + 1) % size;
    crossings.Previous[c] = first + (i + size - 1) % size;
  }
}

constexpr Index None = GridCrossings::None;
}

//----------------------------------------------------------------------------
TEST(ArcSources, ArcsWithoutVerticesHaveAContourToo)
{
  GridCrossings crossings;
  AddCurve({ 1, 1, 2 }, { 5, 0, 3 }, crossings);
  const std::vector<std::int64_t> expected{ 11, 11, 12 };
  EXPECT_EQ(FindArcSources(FourContours(), crossings), expected);
}

//----------------------------------------------------------------------------
TEST(ArcSources, AddedArcsHaveThatOfTheNextOneAlongTheCurve)
{
  GridCrossings crossings;
  AddCurve({ None, 1, None, None, 2, None }, { 0, 4, 0, 0, 4, 0 }, crossings);
  const std::vector<std::int64_t> expected{ 11, 11, 12, 12, 12, 11 };
  EXPECT_EQ(FindArcSources(FourContours(), crossings), expected);
}

//----------------------------------------------------------------------------
TEST(ArcSources, CurvesOfNoContourRemovedAndVirtualOnesHaveNone)
{
  GridCrossings crossings;
  AddCurve({ None, None, None }, { 0, 0, 0 }, crossings);
  AddCurve({ 3, None }, { 4, 0 }, crossings);
  AddCurve({ 0 }, { 4 }, crossings);
  crossings.Next.back() = GridCrossings::Removed;
  const std::vector<std::int64_t> expected(6, NoSource);
  EXPECT_EQ(FindArcSources(FourContours(), crossings), expected);
}

//----------------------------------------------------------------------------
TEST(ArcSources, OfSeveralPartsTheOneWithMostVerticesCounts)
{
  GridCrossings crossings;
  AddCurve({ 0, 1 }, { 2, 3 }, crossings);
  const Index run = crossings.Insert(0, 0.0, 1, 0);
  crossings.Next[run] = GridCrossings::Removed;
  crossings.RunContour[run] = 2;
  crossings.RunCount[run] = 9;
  crossings.RunNext[0] = run; // its arc went on to that of the first one
  crossings.ArcLastRun[0] = run;
  const std::vector<std::int64_t> expected{ 12, 11, NoSource };
  EXPECT_EQ(FindArcSources(FourContours(), crossings), expected);
}
