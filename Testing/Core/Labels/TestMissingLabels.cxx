// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/MissingLabels.h"

#include "Core/Base/EditContours.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;

namespace
{
/// Adds a rectangle on a slice across z.
void AddRectangle(double z, const Point2& low, const Point2& high, Contours& contours)
{
  const Point2 corners[] = { low, { high[0], low[1] }, high, { low[0], high[1] } };
  for (const Point2& p : corners)
  {
    contours.U.push_back(p[0]);
    contours.V.push_back(p[1]);
  }
  contours.Offsets.push_back(static_cast<Index>(contours.U.size()));
  contours.Axis.push_back(2);
  contours.Coordinate.push_back(z);
  contours.Plane.push_back(static_cast<Index>(z));
  contours.Cell.push_back(contours.Count() - 1);
}

/// Two structures side by side on slices 0 to 6, the second one but for some of them.
std::vector<Contours> MakePair(const std::vector<double>& lacking)
{
  std::vector<Contours> pair(2);
  for (double z = 0.0; z < 7.0; z += 1.0)
  {
    AddRectangle(z, { -2.0, -2.0 }, { 0.0, 2.0 }, pair[0]);
    if (std::find(lacking.begin(), lacking.end(), z) == lacking.end())
    {
      AddRectangle(z, { 0.0, -2.0 }, { 3.0, 2.0 }, pair[1]);
    }
  }
  return pair;
}

std::vector<Contours> Find(const std::vector<Contours>& pair)
{
  return FindMissingLabels({ &pair[0], &pair[1] }, Execution());
}
}

TEST(MissingLabels, AreFoundBetweenSlicesThatHaveThem)
{
  for (const std::vector<double>& lacking : { std::vector<double>{ 3.0 }, { 2.0, 3.0 } })
  {
    const std::vector<Contours> found = Find(MakePair(lacking));
    EXPECT_EQ(found[0].Count(), 0);
    ASSERT_EQ(found[1].Count(), static_cast<Index>(lacking.size()));
    for (Index i = 0; i < found[1].Count(); ++i)
    {
      EXPECT_EQ(found[1].Coordinate[i], lacking[i]);
      EXPECT_EQ(found[1].Cell[i], -1);
      EXPECT_DOUBLE_EQ(TwiceSignedArea(found[1], i), 2.0 * 3.0 * 4.0);
    }
  }
}

/// What others have drawn on the slice is the border, wherever it was before.
TEST(MissingLabels, EndAtWhatIsDrawn)
{
  std::vector<Contours> pair = MakePair({ 3.0 });
  for (Index i = pair[0].Offsets[3]; i < pair[0].Offsets[4]; ++i)
  {
    pair[0].U[i] = std::min(0.5, pair[0].U[i] == 0.0 ? 0.5 : pair[0].U[i]);
  }
  const std::vector<Contours> found = Find(pair);
  ASSERT_EQ(found[1].Count(), 1);
  EXPECT_DOUBLE_EQ(TwiceSignedArea(found[1], 0), 2.0 * 2.5 * 4.0);
}

TEST(MissingLabels, AreNotWhereOthersAreDrawn)
{
  std::vector<Contours> pair = MakePair({ 3.0 });
  for (Index i = pair[0].Offsets[3]; i < pair[0].Offsets[4]; ++i)
  {
    pair[0].U[i] = pair[0].U[i] == 0.0 ? 3.0 : pair[0].U[i];
  }
  EXPECT_EQ(Find(pair)[1].Count(), 0);
}

/// Three slices in a row, or most of them, were not overlooked; nor does a stack say more of what
/// ends before the gap.
TEST(MissingLabels, AreNotWhereTheyEnd)
{
  EXPECT_EQ(Find(MakePair({ 2.0, 3.0, 4.0 }))[1].Count(), 0);
  EXPECT_EQ(Find(MakePair({ 1.0, 2.0, 4.0, 5.0 }))[1].Count(), 0);
  std::vector<Contours> pair = MakePair({ 3.0 });
  for (Index i = pair[1].Offsets[2]; i < pair[1].Offsets[3]; ++i)
  {
    pair[1].U[i] *= 0.5; // shrinks towards the gap
  }
  EXPECT_EQ(Find(pair)[1].Count(), 0);
}

/// What is thin beside drawn contours is no rest, as the whole is known only about.
TEST(MissingLabels, AreInWhatOthersLeave)
{
  Contours whole, drawn;
  AddRectangle(3.0, { -2.01, -2.02 }, { 3.0, 2.01 }, whole);
  AddRectangle(3.0, { -2.0, -2.0 }, { 0.5, 2.0 }, drawn);
  AddRectangle(4.0, { 0.5, -2.0 }, { 3.0, 2.0 }, drawn); // on another slice
  const Contours found = FindRest(whole, 0.1, { &drawn });
  ASSERT_EQ(found.Count(), 1);
  EXPECT_EQ(found.Cell.front(), -1);
  EXPECT_NEAR(TwiceSignedArea(found, 0), 2.0 * 2.5 * 4.0, 0.3);
}
