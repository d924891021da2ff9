// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/DisjointSets.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(DisjointSets, AgreeWithLabels)
{
  Random random(1);
  for (int round = 0; round < 50; ++round)
  {
    const Index count = 1 + static_cast<Index>(random.Below(60));
    DisjointSets sets(count);
    ASSERT_EQ(sets.Count(), count);
    std::vector<Index> label(count); // the least number of the set of each
    for (Index i = 0; i < count; ++i)
    {
      label[i] = i;
    }
    for (Index n = 0; n < count; ++n)
    {
      const Index i = static_cast<Index>(random.Below(count));
      const Index j = static_cast<Index>(random.Below(count));
      const Index a = label[i], b = label[j];
      EXPECT_EQ(sets.Unite(i, j), a != b);
      for (Index& other : label)
      {
        other = other == a || other == b ? std::min(a, b) : other;
      }
      for (Index k = 0; k < count; ++k)
      {
        ASSERT_EQ(sets.Find(k), label[k]);
      }
    }
  }
}
