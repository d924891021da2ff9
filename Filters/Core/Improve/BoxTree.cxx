// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BoxTree.h"

namespace orthoslices
{
namespace
{
/// Whether a box lies within another one.
bool IsWithin(const Box3& box, const Box3& other)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(other.Low[axis] <= box.Low[axis] && box.High[axis] <= other.High[axis]))
    {
      return false;
    }
  }
  return true;
}
}

BoxTree::BoxTree(std::vector<Box3> boxes)
  : Boxes(std::move(boxes))
{
  const Index count = static_cast<Index>(this->Boxes.size());
  const Index leaves = std::max<Index>(1, (count + InLeaf - 1) / InLeaf);
  this->First.assign(leaves, -1);
  this->Next.assign(count, -1);
  this->Leaf.resize(count);
  this->Levels.emplace_back(leaves);
  for (Index i = count - 1; i >= 0; --i)
  {
    const Index leaf = i / InLeaf;
    this->Leaf[i] = leaf;
    this->Next[i] = this->First[leaf];
    this->First[leaf] = i;
    this->Levels[0][leaf].Add(this->Boxes[i]);
  }
  while (this->Levels.back().size() > 1)
  {
    const std::vector<Box3>& below = this->Levels.back();
    std::vector<Box3> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      level[i / 2].Add(below[i]);
    }
    this->Levels.push_back(std::move(level));
  }
}

void BoxTree::Grow(Index leaf, const Box3& box)
{
  Index number = leaf;
  for (std::vector<Box3>& level : this->Levels)
  {
    if (IsWithin(box, level[number]))
    {
      return; // and so within all above
    }
    level[number].Add(box);
    number /= 2;
  }
}

void BoxTree::Set(Index thing, const Box3& box)
{
  this->Boxes[thing] = box;
  this->Grow(this->Leaf[thing], box);
}

void BoxTree::Add(const Box3& box, Index beside)
{
  const Index leaf = this->Leaf[beside];
  const Index thing = static_cast<Index>(this->Boxes.size());
  this->Boxes.push_back(box);
  this->Leaf.push_back(leaf);
  this->Next.push_back(this->First[leaf]);
  this->First[leaf] = thing;
  this->Grow(leaf, box);
}
}
