// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/PieceMeetings.h"

#include <gtest/gtest.h>

using namespace orthoslices;

namespace
{
using Meetings = std::vector<std::pair<Index, Index>>;

Meetings Find(std::vector<PieceSide> sides) { return FindMeetings(sides); }
}

TEST(PieceMeetings, CrossingSidesOfOneSliceMeet)
{
  EXPECT_EQ(Find({ { 0, 1.0, { 0, 0 }, { 2, 2 }, 4 }, { 0, 1.0, { 0, 2 }, { 2, 0 }, 3 } }),
    (Meetings{ { 3, 4 } }));
  EXPECT_TRUE(
    Find({ { 0, 1.0, { 0, 0 }, { 2, 2 }, 0 }, { 0, 2.0, { 0, 2 }, { 2, 0 }, 1 } }).empty());
  EXPECT_TRUE(
    Find({ { 0, 1.0, { 0, 0 }, { 2, 2 }, 0 }, { 1, 1.0, { 0, 2 }, { 2, 0 }, 1 } }).empty());
}

TEST(PieceMeetings, ACommonEndIsNone)
{
  EXPECT_TRUE(
    Find({ { 2, 0.0, { 0, 0 }, { 1, 0 }, 0 }, { 2, 0.0, { 1, 0 }, { 2, 0 }, 1 } }).empty());
  // But one that runs back along the other is.
  EXPECT_EQ(Find({ { 2, 0.0, { 0, 0 }, { 2, 0 }, 0 }, { 2, 0.0, { 2, 0 }, { 1, 0 }, 1 } }),
    (Meetings{ { 0, 1 } }));
  EXPECT_EQ(Find({ { 2, 0.0, { 0, 0 }, { 2, 0 }, 0 }, { 2, 0.0, { 2, 0 }, { 0, 0 }, 1 } }),
    (Meetings{ { 0, 1 } }));
}

TEST(PieceMeetings, TouchingAndCollapsedSidesMeet)
{
  EXPECT_EQ(Find({ { 2, 0.0, { 0, 0 }, { 2, 0 }, 0 }, { 2, 0.0, { 1, 0 }, { 1, 1 }, 1 } }),
    (Meetings{ { 0, 1 } }));
  EXPECT_EQ(Find({ { 2, 0.0, { 5, 5 }, { 5, 5 }, 7 } }), (Meetings{ { 7, 7 } }));
}
