// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/FindContacts.h"

#include "Support/CheckEmbedding.h"
#include "Support/Random.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A strip of triangles from one random point to the next, with points of its own.
void AddRandomStrip(
  Random& random, Index patch, Index& nextId, std::vector<PatchTriangle>& triangles)
{
  const Point3 center{ random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0),
    random.Uniform(-1.0, 1.0) };
  std::vector<Point3> points;
  const std::size_t count = 3 + random.Below(6);
  for (std::size_t i = 0; i < count; ++i)
  {
    Point3 p = center;
    for (double& x : p)
    {
      x += random.Uniform(-0.4, 0.4);
    }
    points.push_back(p);
  }
  for (std::size_t i = 2; i < count; ++i)
  {
    const auto first = nextId + static_cast<Index>(i) - 2;
    triangles.push_back(
      { patch, { points[i - 2], points[i - 1], points[i] }, { first, first + 1, first + 2 } });
  }
  nextId += static_cast<Index>(count);
}
}

/// Random strips, some of which cross: every pair that meets is found, and none that is apart.
TEST(FindContacts, RandomStripsAsExactArithmeticHasThem)
{
  Random random(12);
  int meeting = 0, selves = 0, apart = 0;
  for (int run = 0; run < 200; ++run)
  {
    SCOPED_TRACE(run);
    const Index patches = 2 + static_cast<Index>(random.Below(6));
    std::vector<PatchTriangle> triangles;
    Index ids = 0;
    for (Index patch = 0; patch < patches; ++patch)
    {
      AddRandomStrip(random, patch, ids, triangles);
    }
    TriangleMesh mesh;
    mesh.Points.resize(ids);
    std::vector<Index> patchOf;
    for (const PatchTriangle& t : triangles)
    {
      for (int i = 0; i < 3; ++i)
      {
        mesh.Points[t.Ids[i]] = t.Corners[i];
      }
      mesh.Triangles.push_back({ t.Ids[0], t.Ids[1], t.Ids[2] });
      patchOf.push_back(t.Patch);
    }
    std::set<std::pair<Index, Index>> expected;
    for (const Meeting& m : FindMeetings(mesh, 100000))
    {
      expected.insert(std::minmax(patchOf[m.First], patchOf[m.Second]));
    }
    // Joined patches may touch themselves, and nothing may be left out.
    auto copy = triangles;
    const auto all = FindContacts(copy, std::vector<PatchKind>(patches, PatchKind::Joined));
    EXPECT_EQ((std::set<std::pair<Index, Index>>(all.begin(), all.end())), expected);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
    EXPECT_EQ(all.size(), expected.size());
    // Of fans each one that touches another is named at least once, and none touches itself.
    copy = triangles;
    const auto some = FindContacts(copy, std::vector<PatchKind>(patches, PatchKind::Fan));
    std::set<Index> named, touching;
    for (const auto& pair : some)
    {
      EXPECT_EQ(expected.count(pair), 1u);
      EXPECT_NE(pair.first, pair.second);
      named.insert({ pair.first, pair.second });
    }
    for (const auto& pair : expected)
    {
      selves += pair.first == pair.second ? 1 : 0;
      if (pair.first != pair.second)
      {
        touching.insert({ pair.first, pair.second });
      }
    }
    EXPECT_EQ(named, touching);
    meeting += static_cast<int>(expected.size());
    apart += expected.empty() ? 1 : 0;
  }
  EXPECT_GT(meeting, 100);
  EXPECT_GT(selves, 20);
  EXPECT_GT(apart, 5);
}
