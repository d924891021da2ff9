// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/Quadrilaterals.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
std::vector<std::pair<Index, Index>> Split(Index border, const std::vector<Index>& nodes)
{
  std::vector<Quadrilateral> quadrilaterals{ { 99, 99 } };
  SplitIntoQuadrilaterals(border, nodes, quadrilaterals);
  std::vector<std::pair<Index, Index>> result;
  for (const Quadrilateral& q : quadrilaterals)
  {
    result.emplace_back(q.First, q.Last);
  }
  return result;
}

using Ranges = std::vector<std::pair<Index, Index>>;
}

//----------------------------------------------------------------------------
TEST(Quadrilaterals, GoFromMiddleToMiddle)
{
  EXPECT_EQ(Split(6, { 0, 2, 4 }), (Ranges{ { -1, 1 }, { 1, 3 }, { 3, 5 } }));
  EXPECT_EQ(Split(12, { 0, 4, 8 }), (Ranges{ { -2, 2 }, { 2, 6 }, { 6, 10 } }));
}

//----------------------------------------------------------------------------
TEST(Quadrilaterals, ArcWithoutVerticesBelongsToTheNodeAtItsStart)
{
  EXPECT_EQ(Split(3, { 0, 1, 2 }), (Ranges{ { 0, 1 }, { 1, 2 }, { 2, 3 } }));
}

//----------------------------------------------------------------------------
TEST(Quadrilaterals, TwoNodesShareTheBorder)
{
  EXPECT_EQ(Split(4, { 0, 2 }), (Ranges{ { -1, 1 }, { 1, 3 } }));
}

//----------------------------------------------------------------------------
TEST(Quadrilaterals, CoverTheBorderOnceAndEachHasItsNode)
{
  Random random(5);
  for (int run = 0; run < 500; ++run)
  {
    const Index border = static_cast<Index>(3 + random.Below(40));
    std::vector<Index> nodes{ 0 };
    for (Index i = 1; i < border; ++i)
    {
      if (random.Chance(0.3) || (nodes.size() < 2 && i + 1 == border))
      {
        nodes.push_back(i);
      }
    }
    const Ranges ranges = Split(border, nodes);
    ASSERT_EQ(ranges.size(), nodes.size());
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      EXPECT_LE(ranges[i].first, nodes[i]);
      EXPECT_GT(ranges[i].second, nodes[i]);
      const Index next = ranges[(i + 1) % ranges.size()].first;
      EXPECT_EQ(ranges[i].second, i + 1 < ranges.size() ? next : next + border);
    }
  }
}
