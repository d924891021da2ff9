// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BoxTree.h"

#include "Support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Box3 RandomBox(Random& random)
{
  const Point3 low{ random.Uniform(0, 4), random.Uniform(0, 4), random.Uniform(0, 4) };
  Box3 box;
  box.Add(low);
  box.Add(low + Point3{ random.Uniform(0, 1), random.Uniform(0, 1), random.Uniform(0, 1) });
  return box;
}

std::vector<Index> FindIn(const BoxTree& tree, const Box3& box)
{
  std::vector<Index> found;
  tree.ForBoxesAt(box, [&](Index i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> FindOneByOne(const std::vector<Box3>& boxes, const Box3& box)
{
  std::vector<Index> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (boxes[i].Meets(box))
    {
      found.push_back(static_cast<Index>(i));
    }
  }
  return found;
}
}

//----------------------------------------------------------------------------
TEST(BoxTree, FindsAllThatMeetABox)
{
  Random random(3);
  for (const int count : { 0, 1, 8, 9, 200, 1000 })
  {
    std::vector<Box3> boxes;
    for (int i = 0; i < count; ++i)
    {
      boxes.push_back(RandomBox(random));
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 20; ++i)
    {
      const Box3 box = RandomBox(random);
      EXPECT_EQ(FindIn(tree, box), FindOneByOne(boxes, box));
    }
  }
}

//----------------------------------------------------------------------------
/// Boxes that are replaced, emptied and added.
TEST(BoxTree, FindsWhatHasChanged)
{
  Random random(4);
  std::vector<Box3> boxes;
  for (int i = 0; i < 50; ++i)
  {
    boxes.push_back(RandomBox(random));
  }
  BoxTree tree(boxes);
  for (int i = 0; i < 200; ++i)
  {
    const Index changed = static_cast<Index>(random.Uniform(0, static_cast<double>(boxes.size())));
    boxes[changed] = i % 5 == 0 ? Box3() : RandomBox(random);
    tree.Set(changed, boxes[changed]);
    boxes.push_back(RandomBox(random));
    tree.Add(boxes.back(), changed);
    const Box3 box = RandomBox(random);
    EXPECT_EQ(FindIn(tree, box), FindOneByOne(boxes, box));
  }
  EXPECT_EQ(tree.Count(), static_cast<Index>(boxes.size()));
}
