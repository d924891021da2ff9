// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/VirtualPlanes.h"

#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A box of this size from the origin on, cut by so many planes on each axis, half a spacing from
/// its sides and a spacing apart.
struct SlicedBox
{
  SlicedBox(const Point3& size, const std::array<int, 3>& count)
  {
    PieceSets sets = EmptySets();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double u = size[FirstAxis(axis)], v = size[SecondAxis(axis)];
      for (int i = 0; i < count[axis]; ++i)
      {
        AddPiece(sets[axis], { { 0, 0 }, { u, 0 }, { u, v }, { 0, v } },
          size[axis] * (i + 0.5) / count[axis]);
      }
    }
    Contours contours = ParseContours(ToText(sets));
    this->Grid = BuildSpatialGrid(contours, 1e-9);
    this->Box.Low = { 0.0, 0.0, 0.0 };
    this->Box.High = size;
  }

  bool IsSparse() const { return SliceDensity(this->Grid, this->Box).IsSparse(); }
  VirtualPlanes Choose(double spacing = 0.0) const
  {
    return ChooseVirtualPlanes(this->Grid, this->Box, SliceDensity(this->Grid, this->Box, spacing));
  }

  SpatialGrid Grid;
  Box3 Box;
};

const Point3 Cube{ 1.0, 1.0, 1.0 };

/// Planes of an axis, real and virtual ones together, ascending.
std::vector<double> Together(const SlicedBox& box, const VirtualPlanes& added, int axis)
{
  std::vector<double> all = added[axis];
  all.insert(all.end(), box.Grid.Planes[axis].begin(), box.Grid.Planes[axis].end());
  std::sort(all.begin(), all.end());
  return all;
}

/// Ascending, within the box, no virtual plane on a real one; between two real ones evenly spaced.
void ExpectEvenlyBetween(const SlicedBox& box, const VirtualPlanes& added)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_TRUE(std::is_sorted(added[axis].begin(), added[axis].end()));
    const std::vector<double>& real = box.Grid.Planes[axis];
    const std::vector<double> all = Together(box, added, axis);
    EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
    EXPECT_TRUE(all.empty() || all.front() > box.Box.Low[axis]);
    EXPECT_TRUE(all.empty() || all.back() < box.Box.High[axis]);
    for (std::size_t i = 1; i < real.size(); ++i)
    {
      const auto low = std::upper_bound(added[axis].begin(), added[axis].end(), real[i - 1]);
      const auto high = std::lower_bound(added[axis].begin(), added[axis].end(), real[i]);
      const double parts = static_cast<double>(high - low) + 1.0;
      for (auto plane = low; plane != high; ++plane)
      {
        const double share = static_cast<double>(plane - low + 1) / parts;
        EXPECT_NEAR(*plane, real[i - 1] + share * (real[i] - real[i - 1]), 1e-12);
      }
    }
  }
}

std::array<std::size_t, 3> CountsOf(const VirtualPlanes& planes)
{
  return { planes[0].size(), planes[1].size(), planes[2].size() };
}
using Counts = std::array<std::size_t, 3>;
}

//----------------------------------------------------------------------------
TEST(VirtualPlanes, DenseFamiliesNeedNone)
{
  for (const int count : { 1, 2, 3, 5, 8, 16, 32, 64 })
  {
    const SlicedBox box(Cube, { count, count, count });
    EXPECT_FALSE(box.IsSparse()) << count;
    EXPECT_EQ(CountsOf(box.Choose()), (Counts{ 0, 0, 0 }));
  }
}

//----------------------------------------------------------------------------
/// Families that differ by less than three times, or of which the smallest sees the shape.
TEST(VirtualPlanes, ComparableFamiliesNeedNone)
{
  for (const auto& count :
    { std::array<int, 3>{ 20, 8, 8 }, { 8, 20, 8 }, { 5, 10, 14 }, { 64, 16, 64 }, { 16, 64, 16 } })
  {
    EXPECT_FALSE(SlicedBox(Cube, count).IsSparse()) << count[0] << " " << count[1];
  }
}

//----------------------------------------------------------------------------
/// Through a flat or a long object pass few slices of some families, as close as all others.
TEST(VirtualPlanes, FlatAndLongObjectsNeedNoneIfAllSlicesAreAsClose)
{
  for (const auto& count :
    { std::array<int, 3>{ 2, 32, 32 }, { 1, 32, 32 }, { 3, 3, 40 }, { 4, 16, 64 } })
  {
    const Point3 size{ count[0] * 0.1, count[1] * 0.1, count[2] * 0.1 };
    EXPECT_FALSE(SlicedBox(size, count).IsSparse()) << count[0] << " " << count[1];
  }
  // As flat, but with slices across that are farther apart than the others.
  EXPECT_TRUE(SlicedBox({ 0.4, 3.2, 3.2 }, { 1, 32, 32 }).IsSparse());
}

//----------------------------------------------------------------------------
TEST(VirtualPlanes, MissingAxesGetPlanesAsDenseAsTheOthers)
{
  // As far apart as those of the densest axis.
  const SlicedBox stack(Cube, { 0, 0, 32 });
  EXPECT_TRUE(stack.IsSparse());
  EXPECT_EQ(CountsOf(stack.Choose()), (Counts{ 32, 32, 0 }));
  ExpectEvenlyBetween(stack, stack.Choose());
  const SlicedBox two(Cube, { 20, 0, 24 });
  EXPECT_EQ(CountsOf(two.Choose()), (Counts{ 0, 24, 0 }));
  ExpectEvenlyBetween(two, two.Choose());
  // At most a twelfth of the extent, at least a 64th.
  EXPECT_EQ(CountsOf(SlicedBox(Cube, { 5, 0, 5 }).Choose()), (Counts{ 0, 12, 0 }));
  EXPECT_EQ(CountsOf(SlicedBox(Cube, { 0, 0, 4 }).Choose()), (Counts{ 12, 12, 0 }));
  EXPECT_EQ(CountsOf(SlicedBox(Cube, { 0, 200, 200 }).Choose()), (Counts{ 64, 0, 0 }));
}

//----------------------------------------------------------------------------
/// Planes of an axis without real ones: evenly, and half a spacing from the ends of the surface.
TEST(VirtualPlanes, PlanesOfAMissingAxisFillTheBox)
{
  const SlicedBox stack({ 2.0, 3.0, 1.0 }, { 0, 0, 10 });
  const VirtualPlanes planes = stack.Choose();
  ASSERT_EQ(CountsOf(planes), (Counts{ 20, 30, 0 }));
  for (int axis = 0; axis < 2; ++axis)
  {
    for (std::size_t i = 0; i < planes[axis].size(); ++i)
    {
      EXPECT_NEAR(planes[axis][i], (static_cast<double>(i) + 0.5) * 0.1, 1e-12);
    }
  }
}

//----------------------------------------------------------------------------
TEST(VirtualPlanes, StackWithFewSlicesAcrossGetsMoreOfThese)
{
  const SlicedBox box(Cube, { 1, 1, 24 });
  EXPECT_TRUE(box.IsSparse());
  const VirtualPlanes planes = box.Choose();
  EXPECT_EQ(CountsOf(planes), (Counts{ 22, 22, 0 })); // 11 in each half of 12 twenty-fourths
  ExpectEvenlyBetween(box, planes);
  const SlicedBox eighths(Cube, { 32, 32, 8 });
  EXPECT_TRUE(eighths.IsSparse());
  EXPECT_EQ(eighths.Choose()[2].size() % 7, eighths.Choose()[2].size() - 21); // three in each slab
  ExpectEvenlyBetween(eighths, eighths.Choose());
  // A third of the planes and more, but slabs of a sixteenth: narrow enough.
  EXPECT_FALSE(SlicedBox(Cube, { 48, 48, 16 }).IsSparse());
}

//----------------------------------------------------------------------------
/// Between fewer than five slices the few across know better.
TEST(VirtualPlanes, FewSlicesWithFewAcrossGetNone)
{
  for (int count = 3; count < 5; ++count)
  {
    EXPECT_FALSE(SlicedBox(Cube, { 1, 1, count }).IsSparse()) << count;
    EXPECT_FALSE(SlicedBox(Cube, { 1, 0, count }).IsSparse()) << count;
    EXPECT_TRUE(SlicedBox(Cube, { 0, 0, count }).IsSparse()) << count;
  }
  EXPECT_FALSE(
    SlicedBox(Cube, { 1, 1, 5 }).IsSparse()); // across in two directions, they know enough
  EXPECT_TRUE(SlicedBox(Cube, { 1, 1, 8 }).IsSparse());
  EXPECT_TRUE(SlicedBox(Cube, { 0, 1, 5 }).IsSparse());
  EXPECT_FALSE(SlicedBox(Cube, { 1, 1, 1 }).IsSparse());
  EXPECT_FALSE(SlicedBox(Cube, { 1, 1, 2 }).IsSparse()); // not a stack
  EXPECT_FALSE(SlicedBox(Cube, { 6, 6, 1 }).IsSparse()); // two of these across each other
  EXPECT_TRUE(SlicedBox(Cube, { 3, 0, 4 }).IsSparse());  // two families and nothing across
}

//----------------------------------------------------------------------------
/// One or two slices across guide a stack of five and more; of three and more, up to a third of it.
TEST(VirtualPlanes, StacksHaveFewSlicesAcross)
{
  const auto stackOf = [](const std::array<int, 3>& count)
  {
    const SlicedBox box(Cube, count);
    return SliceDensity(box.Grid, box.Box).StackAxis();
  };
  EXPECT_EQ(stackOf({ 0, 1, 5 }), 2);
  EXPECT_EQ(stackOf({ 1, 1, 7 }), -1);
  EXPECT_EQ(stackOf({ 1, 1, 8 }), 2);
  EXPECT_EQ(stackOf({ 5, 1, 0 }), 0);
  EXPECT_EQ(stackOf({ 2, 8, 0 }), 1);
  EXPECT_EQ(stackOf({ 2, 2, 12 }), 2);
  EXPECT_EQ(stackOf({ 2, 2, 11 }), -1);
  EXPECT_EQ(stackOf({ 1, 1, 4 }), -1);
  EXPECT_EQ(stackOf({ 0, 0, 12 }), -1); // nothing across
}

//----------------------------------------------------------------------------
/// Where a family is missing, the contours of two are close enough together for a finer mesh.
TEST(VirtualPlanes, MeshesOfTwoFamiliesAreFiner)
{
  const auto densityOf = [](const std::array<int, 3>& count)
  {
    const SlicedBox box(Cube, count);
    return SliceDensity(box.Grid, box.Box);
  };
  for (const auto& count :
    { std::array<int, 3>{ 0, 0, 32 }, { 0, 1, 32 }, { 2, 2, 32 }, { 32, 32, 8 } })
  {
    EXPECT_NEAR(densityOf(count).EdgeLength(), 0.5 / 32.0, 1e-9);
    EXPECT_EQ(densityOf(count).Rounds(), 1);
  }
  for (const auto& count : { std::array<int, 3>{ 32, 0, 32 }, { 32, 32, 0 } })
  {
    EXPECT_NEAR(densityOf(count).EdgeLength(), 0.35 / 32.0, 1e-9);
    EXPECT_EQ(densityOf(count).Rounds(), 2);
  }
}

//----------------------------------------------------------------------------
/// The rules do not know which axis is which.
TEST(VirtualPlanes, AxesAreEqual)
{
  for (const auto& count :
    { std::array<int, 3>{ 1, 0, 12 }, { 1, 1, 24 }, { 0, 0, 5 }, { 32, 32, 8 }, { 16, 16, 16 } })
  {
    const Counts expected = CountsOf(SlicedBox(Cube, count).Choose());
    const Counts turned = CountsOf(SlicedBox(Cube, { count[2], count[0], count[1] }).Choose());
    EXPECT_EQ(turned, (Counts{ expected[2], expected[0], expected[1] }));
  }
}

//----------------------------------------------------------------------------
/// With a spacing of one's own no other rule counts.
TEST(VirtualPlanes, BySpacingTheyAreAsFarApartAsItSays)
{
  const SlicedBox box(Cube, { 8, 4, 0 });
  const double spacing = 1.0 / 16.0;
  EXPECT_TRUE(SliceDensity(box.Grid, box.Box, spacing).IsSparse());
  const VirtualPlanes planes = box.Choose(spacing);
  ExpectEvenlyBetween(box, planes);
  EXPECT_EQ(planes[0].size(), 7u);      // one in each slab between planes
  EXPECT_EQ(planes[1].size(), 9u + 2u); // three, and one beyond each of the outermost
  EXPECT_EQ(planes[2].size(), 16u);
  EXPECT_FALSE(SliceDensity(SlicedBox(Cube, { 8, 8, 8 }).Grid, box.Box, 0.125).IsSparse());
}

//----------------------------------------------------------------------------
/// They are rounded to the precision of the grid.
TEST(VirtualPlanes, AreNumbersOfThePrecision)
{
  SlicedBox box({ 0.7, 0.9, 1.1 }, { 0, 0, 13 });
  box.Grid.SinglePrecision = true;
  for (const std::vector<double>& planes : box.Choose())
  {
    for (const double plane : planes)
    {
      EXPECT_EQ(plane, static_cast<double>(static_cast<float>(plane)));
    }
  }
}
