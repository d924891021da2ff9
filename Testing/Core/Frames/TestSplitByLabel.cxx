// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/SplitByLabel.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
/// A closed triangle on the plane z = `height`, from cell `cell` of the z-slices.
void AddTriangle(double height, std::int64_t cell, Polylines& lines)
{
  const double size = static_cast<double>(cell + 1);
  lines.X.insert(lines.X.end(), { 0.0, size, 0.0 });
  lines.Y.insert(lines.Y.end(), { 0.0, 0.0, size });
  lines.Z.insert(lines.Z.end(), { height, height, height });
  lines.Offsets.push_back(static_cast<Index>(lines.X.size()));
  lines.Closed.push_back(1);
  lines.From.Port.push_back(2);
  lines.From.Block.push_back(0);
  lines.From.Cell.push_back(cell);
}

Polylines FiveTriangles()
{
  Polylines lines;
  for (const int cell : { 0, 1, 2, 3, 4 })
  {
    AddTriangle(cell, 10 + cell, lines);
  }
  return lines;
}
}

TEST(SplitByLabel, EachLabelHasItsPiecesAndSources)
{
  const SortedSlices sorted = SortByPlanes(FiveTriangles(), FrameOptions());
  const auto parts = SplitByLabel(sorted, { 1, 0, NoLabel, 1, 1 }, 3);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].Slices[2].Count(), 1);
  EXPECT_EQ(parts[1].Slices[2].Count(), 3);
  EXPECT_EQ(CountVertices(parts[1]), 9u);
  EXPECT_EQ(CountVertices(parts[2]), 0u);
  for (const SortedSlices& part : parts)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(part.Slices[axis].Axis, axis);
    }
  }
  const Pieces& pieces = parts[1].Slices[2];
  EXPECT_EQ(pieces.W[0], 0.0);
  EXPECT_EQ(pieces.W[3], 3.0);
  EXPECT_EQ(pieces.U[4], 14.0);
  EXPECT_EQ(parts[1].From.Cell, (std::vector<std::int64_t>{ 10, 13, 14 }));
  EXPECT_EQ(pieces.Cell, (std::vector<std::int64_t>{ 0, 1, 2 }));
  EXPECT_EQ(pieces.Closed, (std::vector<std::uint8_t>{ 1, 1, 1 }));
}

TEST(SplitByLabel, OneLabelIsTheWhole)
{
  const SortedSlices sorted = SortByPlanes(FiveTriangles(), FrameOptions());
  const auto parts = SplitByLabel(sorted, { 0, 0, 0, 0, 0 }, 1);
  EXPECT_EQ(parts[0].Slices[2].U, sorted.Slices[2].U);
  EXPECT_EQ(parts[0].Slices[2].Offsets, sorted.Slices[2].Offsets);
  EXPECT_EQ(parts[0].Slices[2].Cell, sorted.Slices[2].Cell);
  EXPECT_EQ(parts[0].From.Cell, sorted.From.Cell);
}

TEST(SplitByLabel, ContoursOnOtherPlanesGoWithTheirLabel)
{
  SortedSlices sorted = SortByPlanes(FiveTriangles(), FrameOptions());
  Polylines lines = FiveTriangles();
  AppendLine(lines, 1, sorted.Others);
  AppendLine(lines, 3, sorted.Others);
  AppendLine(lines, 4, sorted.Others);
  const auto parts = SplitByLabel(sorted, { 0, 1, 0, 0, NoLabel }, 2);
  ASSERT_EQ(parts[0].Others.Count(), 1);
  EXPECT_EQ(parts[0].Others.From.Cell[0], 13);
  ASSERT_EQ(parts[1].Others.Count(), 1);
  EXPECT_EQ(parts[1].Others.From.Cell[0], 11);
}
