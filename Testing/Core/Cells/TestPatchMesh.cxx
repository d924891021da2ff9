// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/PatchMesh.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
PatchMesh WithTriangles(std::vector<std::array<Index, 3>> triangles)
{
  return { PatchKind::Joined, { 0 }, {}, std::move(triangles) };
}

/// A grid of `rows` by `columns` squares, each of two triangles, that closes up along a direction
/// if it is said to.
PatchMesh Grid(Index rows, Index columns, bool closeRows, bool closeColumns)
{
  const Index inRow = columns + (closeColumns ? 0 : 1);
  const Index inColumn = rows + (closeRows ? 0 : 1);
  const auto at = [&](Index r, Index c) { return (r % inColumn) * inRow + c % inRow; };
  std::vector<std::array<Index, 3>> triangles;
  for (Index r = 0; r < rows; ++r)
  {
    for (Index c = 0; c < columns; ++c)
    {
      triangles.push_back({ at(r, c), at(r, c + 1), at(r + 1, c + 1) });
      triangles.push_back({ at(r, c), at(r + 1, c + 1), at(r + 1, c) });
    }
  }
  return WithTriangles(std::move(triangles));
}
}

//----------------------------------------------------------------------------
TEST(PatchMesh, EulerCharacteristicOfKnownSurfaces)
{
  EXPECT_EQ(EulerCharacteristic(WithTriangles({})), 0);
  EXPECT_EQ(EulerCharacteristic(WithTriangles({ { 0, 1, 2 } })), 1);
  // Corners are places on borders, or points of the patch below zero.
  EXPECT_EQ(EulerCharacteristic(WithTriangles({ { 0, 1, -1 }, { 1, 2, -1 }, { 2, 0, -1 } })), 1);
  EXPECT_EQ(EulerCharacteristic(WithTriangles({ { 0, 1, 2 }, { 3, 4, 5 } })), 2);
  EXPECT_EQ(
    EulerCharacteristic(WithTriangles({ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } })), 2);
  EXPECT_EQ(EulerCharacteristic(Grid(4, 5, false, false)), 1);
  EXPECT_EQ(EulerCharacteristic(Grid(4, 5, true, false)), 0); // a tube
  EXPECT_EQ(EulerCharacteristic(Grid(4, 5, true, true)), 0);  // a torus
  PatchMesh pierced = Grid(4, 5, true, true);
  pierced.Triangles.erase(pierced.Triangles.begin());
  EXPECT_EQ(EulerCharacteristic(pierced), -1); // a disc with a handle
}

//----------------------------------------------------------------------------
TEST(PatchMesh, PlaceInAscendingCycles)
{
  const std::vector<Index> cycles{ 2, 5, 7 };
  EXPECT_EQ(PlaceIn(cycles, 2), 0u);
  EXPECT_EQ(PlaceIn(cycles, 5), 1u);
  EXPECT_EQ(PlaceIn(cycles, 7), 2u);
}

//----------------------------------------------------------------------------
/// What counts as a repair is a shell of one cycle, not that of a joined patch.
TEST(PatchMesh, SeparatedDiscIsTheShellOfOneCycle)
{
  EXPECT_TRUE((PatchMesh{ PatchKind::Shell, { 4 }, {}, {} }.IsSeparatedDisc()));
  EXPECT_FALSE((PatchMesh{ PatchKind::Shell, { 4, 6 }, {}, {} }.IsSeparatedDisc()));
  EXPECT_FALSE((PatchMesh{ PatchKind::Stitched, { 4 }, {}, {} }.IsSeparatedDisc()));
}
