// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SharedPatches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;

namespace
{
/// A border of five places on the faces of the unit cube, turned to its least place.
PatchBorder Border(bool reversed)
{
  PatchBorder border;
  border.Places = { { 0, 0.5, 0.2 }, { 0.5, 0, 0.3 }, { 1, 0.4, 0.5 }, { 0.6, 1, 0.4 },
    { 0.2, 1, 0.3 } };
  if (reversed)
  {
    std::reverse(border.Places.begin(), border.Places.end());
  }
  border.Points = { 0, 1, 2, 3, 4 };
  border.Normals.resize(5);
  border.Room.Low = { 0.01, 0.01, 0.01 };
  border.Room.High = { 0.99, 0.99, 0.99 };
  border.Turn();
  return border;
}

/// Two points inside: the triangles beside sides 0 to 2 end in the first, the others in the second.
InnerPatch Patch()
{
  InnerPatch patch;
  patch.Points = { { 0.6, 0.4, 0.5 }, { 0.4, 0.7, 0.5 } };
  patch.Normals = { { 0, 0, 1 }, { 0, 0.6, 0.8 } };
  patch.Triangles = { { 0, 1, -1 }, { 1, 2, -1 }, { 2, 3, -1 }, { 3, -2, -1 }, { 3, 4, -2 },
    { 4, 0, -2 }, { 0, -1, -2 } };
  return patch;
}

using Corner = Point3;

/// The triangles by the places of their corners, each from its least corner on.
std::multiset<std::array<Corner, 3>> TrianglesOf(const PatchBorder& border, const InnerPatch& patch)
{
  std::multiset<std::array<Corner, 3>> triangles;
  for (const auto& triangle : patch.Triangles)
  {
    std::array<Corner, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = triangle[i] >= 0 ? border.Places[triangle[i]] : patch.Points[-1 - triangle[i]];
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.insert(corners);
  }
  return triangles;
}

/// The same triangles run the other way.
std::multiset<std::array<Corner, 3>> Reversed(const std::multiset<std::array<Corner, 3>>& triangles)
{
  std::multiset<std::array<Corner, 3>> reversed;
  for (auto corners : triangles)
  {
    std::swap(corners[1], corners[2]);
    reversed.insert(corners);
  }
  return reversed;
}
}

TEST(SharedPatches, TheOtherSideHasTheSameTrianglesReversed)
{
  for (const bool first : { false, true })
  {
    SharedPatches shared;
    const PatchBorder border = Border(first);
    shared.Add(border, Patch());
    const auto triangles = TrianglesOf(border, Patch());

    InnerPatch same;
    ASSERT_TRUE(shared.Find(border, same));
    EXPECT_EQ(TrianglesOf(border, same), triangles);
    EXPECT_EQ(same.Normals, Patch().Normals);

    const PatchBorder opposite = Border(!first);
    InnerPatch other;
    ASSERT_TRUE(shared.Find(opposite, other));
    EXPECT_EQ(TrianglesOf(opposite, other), Reversed(triangles));
    EXPECT_EQ(other.Normals[1], (Point3{ 0, -0.6, -0.8 }));
  }
}

TEST(SharedPatches, OtherBordersHaveNone)
{
  SharedPatches shared;
  shared.Add(Border(false), Patch());
  PatchBorder other = Border(false);
  other.Places[2][1] = std::nextafter(other.Places[2][1], 1.0);
  InnerPatch patch;
  EXPECT_FALSE(shared.Find(other, patch));
  EXPECT_FALSE(SharedPatches().Find(Border(false), patch));
}

/// A cell may be smaller than that in which the patch was made.
TEST(SharedPatches, WhatDoesNotFitIntoTheCellIsNotTaken)
{
  SharedPatches shared;
  shared.Add(Border(false), Patch());
  PatchBorder narrow = Border(true);
  narrow.Room.High[0] = 0.59;
  InnerPatch patch;
  EXPECT_FALSE(shared.Find(narrow, patch));

  // A side between two places of the border, both at the lower face of a smaller cell.
  InnerPatch chord;
  chord.Points = { { 0.4, 0.5, 0.45 } };
  chord.Normals = { { 0, 0, 1 } };
  chord.Triangles = { { 1, 2, 3 }, { 1, 3, -1 }, { 3, 4, -1 }, { 4, 0, -1 }, { 0, 1, -1 } };
  SharedPatches chords;
  chords.Add(Border(false), chord);
  EXPECT_TRUE(chords.Find(Border(true), patch));
  PatchBorder low = Border(true);
  low.Room.Low[2] = 0.41;
  EXPECT_FALSE(chords.Find(low, patch));
}
