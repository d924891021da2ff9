// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/PlaneContours.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
void Draw(PlaneContours& contours, const std::vector<std::array<double, 2>>& vertices)
{
  for (const auto& vertex : vertices)
  {
    contours.AddVertex(vertex[0], vertex[1]);
  }
  contours.CloseContour();
}
}

//----------------------------------------------------------------------------
TEST(PlaneContours, RepeatedVerticesAreDropped)
{
  PlaneContours contours;
  Draw(contours, { { 0, 0 }, { 0, 0 }, { 1, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 } });
  EXPECT_EQ(contours.Count(), 1);
  EXPECT_EQ(contours.U, (std::vector<double>{ 0, 1, 1 }));
  EXPECT_EQ(contours.V, (std::vector<double>{ 0, 0, 1 }));
}

//----------------------------------------------------------------------------
TEST(PlaneContours, FirstVertexMayRepeatTheLastOneOfTheContourBefore)
{
  PlaneContours contours;
  Draw(contours, { { 0, 0 }, { 1, 0 }, { 1, 1 } });
  Draw(contours, { { 1, 1 }, { 2, 1 }, { 2, 2 } });
  EXPECT_EQ(contours.Offsets, (std::vector<Index>{ 0, 3, 6 }));
}

//----------------------------------------------------------------------------
TEST(PlaneContours, ContoursWithoutThreePlacesAreDropped)
{
  PlaneContours contours;
  Draw(contours, {});
  Draw(contours, { { 1, 1 } });
  Draw(contours, { { 1, 1 }, { 2, 2 }, { 1, 1 } });
  Draw(contours, { { 1, 1 }, { 2, 2 }, { 1, 1 }, { 2, 2 } });
  EXPECT_EQ(contours.Count(), 0);
  EXPECT_TRUE(contours.U.empty());
  Draw(contours, { { 0, 0 }, { 1, 0 }, { 1, 1 } });
  EXPECT_EQ(contours.Count(), 1);
}

//----------------------------------------------------------------------------
TEST(RoundTo, KeepsWhatTheTypeCanHold)
{
  EXPECT_EQ(RoundTo(Precision::Double, 0.1), 0.1);
  EXPECT_EQ(RoundTo(Precision::Single, 0.1), static_cast<double>(0.1f));
  EXPECT_NE(RoundTo(Precision::Single, 0.1), 0.1);
  EXPECT_EQ(RoundTo(Precision::Single, 0.5), 0.5);
}
