// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/FindCrossings.h"

#include "Support/CheckEmbedding.h"
#include "Support/ClosedMeshes.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Pairs = std::vector<std::pair<Index, Index>>;

Pairs FindAll(const PlainMesh& mesh)
{
  return FindCrossings(
    mesh.Points, mesh.Triangles, std::vector<std::uint8_t>(mesh.Triangles.size(), 1), Execution());
}

/// Triangles all over a box, most of which cross others.
PlainMesh Clutter(int count)
{
  Random random(7);
  PlainMesh mesh;
  for (int i = 0; i < count; ++i)
  {
    const Point3 center{ random.Uniform(0, 4), random.Uniform(0, 4), random.Uniform(0, 4) };
    const Index first = static_cast<Index>(mesh.Points.size());
    for (int k = 0; k < 3; ++k)
    {
      mesh.Points.push_back({ center[0] + random.Uniform(-0.3, 0.3),
        center[1] + random.Uniform(-0.3, 0.3), center[2] + random.Uniform(-0.3, 0.3) });
    }
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return mesh;
}
}

//----------------------------------------------------------------------------
TEST(FindCrossings, EmbeddedMeshesHaveNone)
{
  EXPECT_TRUE(FindAll(TetrahedronMesh()).empty());
  EXPECT_TRUE(FindAll(TorusMesh(40, 16)).empty());
  EXPECT_TRUE(FindAll(PlainMesh()).empty());
}

//----------------------------------------------------------------------------
/// The same pairs as a checker that shares no code with this.
TEST(FindCrossings, AreAllThatThereAre)
{
  const PlainMesh mesh = Clutter(600);
  TriangleMesh plain;
  plain.Points = mesh.Points;
  for (const auto& triangle : mesh.Triangles)
  {
    plain.Triangles.push_back({ triangle[0], triangle[1], triangle[2] });
  }
  std::set<std::pair<std::int64_t, std::int64_t>> expected;
  for (const Meeting& meeting : FindMeetings(plain, 100000))
  {
    expected.insert(std::minmax(meeting.First, meeting.Second));
  }
  std::set<std::pair<std::int64_t, std::int64_t>> found;
  for (const auto& pair : FindAll(mesh))
  {
    found.insert(pair);
  }
  ASSERT_GT(expected.size(), 50u);
  EXPECT_TRUE(found == expected);
}

//----------------------------------------------------------------------------
TEST(FindCrossings, AreLookedForAtMarkedTrianglesOnly)
{
  const PlainMesh mesh = Clutter(300);
  const Pairs all = FindAll(mesh);
  std::vector<std::uint8_t> isMarked(mesh.Triangles.size(), 0);
  for (std::size_t i = 0; i < isMarked.size(); i += 3)
  {
    isMarked[i] = 1;
  }
  Pairs expected;
  for (const auto& pair : all)
  {
    if (isMarked[pair.first] != 0 || isMarked[pair.second] != 0)
    {
      expected.push_back(pair);
    }
  }
  ASSERT_LT(expected.size(), all.size());
  EXPECT_EQ(FindCrossings(mesh.Points, mesh.Triangles, isMarked, Execution()), expected);
}
