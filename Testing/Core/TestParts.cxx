// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   parts of a surface that several processes make, one behind the other, are the surface
 */

#include "Core/Patches/DivideCycles.h"
#include "Core/Reconstruct.h"
#include "Core/Surface/PointNormals.h"
#include "Core/Surface/TriangleMeasures.h"
#include "Support/SliceSolid.h"
#include "Support/ThreadRanks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Reconstruction Make(const PieceSets& sets, const Ranks* ranks, PatchMethod method)
{
  Options options;
  options.Processes = ranks;
  options.Patching.Method = method;
  PieceSets input = sets;
  return Reconstruct(std::move(input), options, Execution());
}

template <typename Value>
void Append(const std::vector<Value>& from, std::vector<Value>& to)
{
  to.insert(to.end(), from.begin(), from.end());
}

/// The triangles of a part, by ids of points in the whole surface.
std::vector<long long> IdsOf(const Reconstruction& part, std::int64_t innerBefore)
{
  std::vector<long long> ids(3 * static_cast<std::size_t>(part.Surface.TriangleCount()));
  WriteTriangles(part.Surface, GeometryOf(part), Execution(), ids.data());
  for (long long& id : ids)
  {
    id += id < part.Surface.MeshOffsets.back() ? 0 : innerBefore;
  }
  return ids;
}

void ExpectParts(const PieceSets& sets, PatchMethod method = PatchMethod::Smooth)
{
  const Reconstruction whole = Make(sets, nullptr, method);
  ASSERT_FALSE(whole.Part);
  ASSERT_GT(whole.Surface.TriangleCount(), 0);
  for (const int count : { 1, 2, 3, 7, 200 })
  {
    std::vector<Reconstruction> parts(count);
    ThreadRanks(count).ForAll(
      [&](const Ranks& ranks) { parts[ranks.Rank] = Make(sets, &ranks, method); });
    InnerPatches inner;
    std::vector<long long> ids;
    std::size_t next = 0;
    for (const Reconstruction& part : parts)
    {
      EXPECT_EQ(part.Part.has_value(), count > 1);
      EXPECT_EQ(part.Graph.Points, whole.Graph.Points);
      EXPECT_EQ(part.Normals.Normals, whole.Normals.Normals);
      EXPECT_EQ(part.Normals.Corners, whole.Normals.Corners);
      const std::int64_t innerBefore =
        static_cast<std::int64_t>(inner.Points.size() / 3) - inner.Count();
      Append(IdsOf(part, innerBefore), ids);
      if (part.Part)
      {
        EXPECT_EQ(part.Part->First, next);
        next = part.Part->Last;
      }
      Append(part.Surface.Inner.Cycle, inner.Cycle);
      Append(part.Surface.Inner.Points, inner.Points);
      Append(part.Surface.Inner.Normals, inner.Normals);
      Append(part.Surface.Inner.Corners, inner.Corners);
    }
    EXPECT_EQ(count > 1 ? next : whole.Cycles.Cell.size(), whole.Cycles.Cell.size());
    EXPECT_EQ(ids, IdsOf(whole, 0));
    EXPECT_EQ(inner.Cycle, whole.Surface.Inner.Cycle);
    EXPECT_EQ(inner.Points, whole.Surface.Inner.Points);
    EXPECT_EQ(inner.Normals, whole.Surface.Inner.Normals);
    EXPECT_EQ(inner.Corners, whole.Surface.Inner.Corners);
  }
}

Reconstruction MakeLight(const PieceSets& sets, const Ranks* ranks)
{
  Options options;
  options.Processes = ranks;
  options.Patching.OwnAccuracy = true;
  PieceSets input = sets;
  return Reconstruct(std::move(input), options, Execution());
}

/// What parts of improved triangles have together: the points of the whole, of each part in its
/// order, and the triangles.
void ExpectImproved(const std::vector<Reconstruction>& parts, const ImprovedTriangles& whole)
{
  std::vector<Index> corners;
  std::vector<int> before(whole.Origin.size(), 0), after(whole.Origin.size(), 0);
  for (const Reconstruction& part : parts)
  {
    const ImprovedTriangles& own = part.Surface.Improved;
    ASSERT_TRUE(own.IsPart);
    EXPECT_EQ(own.TrianglesBefore, static_cast<std::int64_t>(corners.size() / 3));
    EXPECT_EQ(part.Surface.TriangleCount(), static_cast<std::int64_t>(own.Corners.size() / 3));
    for (const Index corner : own.Corners)
    {
      corners.push_back(static_cast<Index>(own.Ids[corner]));
    }
    for (std::size_t i = 0; i < own.Ids.size(); ++i)
    {
      const std::size_t id = static_cast<std::size_t>(own.Ids[i]);
      EXPECT_EQ(own.Origin[i], whole.Origin[id]);
      EXPECT_TRUE(std::equal(whole.Points.begin() + 3 * id, whole.Points.begin() + 3 * (id + 1),
        own.Points.begin() + 3 * i));
      EXPECT_EQ((own.OtherParts[i] & BeforePart) != 0, before[id] > 0);
      after[id] += (own.OtherParts[i] & AfterPart) != 0 ? 0 : 1; // of one part it is the last
      ++before[id];
    }
  }
  EXPECT_EQ(corners, whole.Corners);
  EXPECT_EQ(after, std::vector<int>(after.size(), 1));
}

/// Few triangles, which all make together.
void ExpectLightParts(const PieceSets& sets, const std::vector<int>& counts)
{
  const Reconstruction whole = MakeLight(sets, nullptr);
  ASSERT_TRUE(whole.Surface.Improved.Any());
  for (const int count : counts)
  {
    std::vector<Reconstruction> parts(count);
    ThreadRanks(count).ForAll(
      [&](const Ranks& ranks) { parts[ranks.Rank] = MakeLight(sets, &ranks); });
    ExpectImproved(parts, whole.Surface.Improved);
    std::size_t next = 0;
    for (const Reconstruction& part : parts)
    {
      ASSERT_TRUE(part.Part);
      EXPECT_EQ(part.Part->First, next);
      next = part.Part->Last;
      EXPECT_EQ(part.Accuracy, whole.Accuracy);
      EXPECT_EQ(part.Graph.Points, whole.Graph.Points);
      EXPECT_EQ(part.Surface.Inner.Points, whole.Surface.Inner.Points);
      const std::vector<std::int64_t>& offsets = whole.Surface.Offsets;
      EXPECT_EQ(part.Surface.TriangleCount(), offsets[part.Part->Last] - offsets[part.Part->First]);
    }
    EXPECT_EQ(next, whole.Cycles.Cell.size());
  }
}

PieceSets Sliced(const Solid& solid, const std::array<int, 3>& planes)
{
  return SliceSolid(solid, EqualPlanes(solid, planes), 4, InPlaneGrid::Free);
}
}

TEST(Parts, OfTheSurfaceOfOneProcess)
{
  ExpectParts(Sliced(KnottedTube(), { 14, 15, 16 }));
  ExpectParts(Sliced(HollowBall(), { 7, 7, 7 }));
}

TEST(Parts, OfOtherPatches)
{
  ExpectParts(Sliced(KnottedTube(), { 14, 15, 16 }), PatchMethod::Coons);
  ExpectParts(Sliced(KnottedTube(), { 14, 15, 16 }), PatchMethod::Fan);
}

// Cells with several cycles, of which processes have some each.
TEST(Parts, GiveWayToPatchesOfOthers)
{
  ExpectParts(Sliced(LinkedTori(), { 5, 6, 5 }));
  ExpectParts(Sliced(BranchingTube(), { 4, 5, 4 }));
}

TEST(Parts, OfFewTriangles)
{
  ExpectLightParts(Sliced(KnottedTube(), { 14, 15, 16 }), { 2, 3, 7 });
  // More processes than cells: some have nothing.
  ExpectLightParts(Sliced(BranchingTube(), { 4, 5, 4 }), { 2, 50 });
}

TEST(Parts, WorkIsDividedEvenly)
{
  const auto size = [](std::size_t i) { return i == 3 ? 10.0 : 1.0; };
  EXPECT_EQ(DivideWork(1, 5, size), (std::vector<std::size_t>{ 0, 5 }));
  EXPECT_EQ(
    DivideWork(2, 20, [](std::size_t) { return 2.0; }), (std::vector<std::size_t>{ 0, 10, 20 }));
  // The great one is not divided.
  EXPECT_EQ(DivideWork(3, 10, size), (std::vector<std::size_t>{ 0, 4, 4, 10 }));
  EXPECT_EQ(DivideWork(3, 0, size), (std::vector<std::size_t>{ 0, 0, 0, 0 }));
  EXPECT_EQ(DivideWork(3, 1, size), (std::vector<std::size_t>{ 0, 1, 1, 1 }));
}

TEST(Parts, QualityIsThatOfAll)
{
  const std::vector<TriangleQuality> own{ { 20.0, 2.0 / 3.0, 4.0 }, {}, { 10.0, 0.75, 3.0 } };
  const std::vector<std::int64_t> counts{ 3, 0, 4 };
  ThreadRanks(3).ForAll(
    [&](const Ranks& ranks)
    {
      const TriangleQuality all = JoinQualities(own[ranks.Rank], counts[ranks.Rank], ranks);
      EXPECT_EQ(all.SmallestAngle, 10.0);
      EXPECT_EQ(all.ShareAbove20Degrees, 5.0 / 7.0);
      EXPECT_EQ(all.LargestAspectRatio, 4.0);
    });
}
