// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BoxTree.h"

#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
float RoundDown(double x)
{
  constexpr float greatest = std::numeric_limits<float>::max();
  if (!(std::abs(x) < static_cast<double>(greatest)))
  {
    return x > 0.0 ? greatest : -HUGE_VALF;
  }
  const float rounded = static_cast<float>(x);
  return static_cast<double>(rounded) > x ? std::nextafterf(rounded, -HUGE_VALF) : rounded;
}

float RoundUp(double x) { return -RoundDown(-x); }
}

BoxTree::Rounded::Rounded(const Box3& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = RoundDown(box.Low[axis]);
    this->High[axis] = RoundUp(box.High[axis]);
  }
}

/// Empty boxes.
BoxTree::Branches::Branches()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis].fill(HUGE_VALF);
    this->High[axis].fill(-HUGE_VALF);
  }
}

void BoxTree::Branches::Set(Index branch, const Rounded& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis][branch] = box.Low[axis];
    this->High[axis][branch] = box.High[axis];
  }
}

bool BoxTree::Branches::Grow(Index branch, const Rounded& box)
{
  bool grows = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    float &low = this->Low[axis][branch], &high = this->High[axis][branch];
    grows = grows || box.Low[axis] < low || box.High[axis] > high;
    low = std::min(low, box.Low[axis]);
    high = std::max(high, box.High[axis]);
  }
  return grows;
}

BoxTree::BoxTree(std::vector<Box3> boxes)
  : Boxes(std::move(boxes))
  , CountAtFirst(static_cast<Index>(this->Boxes.size()))
{
  Index nodes = this->CountAtFirst;
  do
  {
    nodes = std::max<Index>(1, (nodes + Width - 1) / Width);
    this->Levels.emplace_back(nodes);
  } while (nodes > 1);
  this->FirstAdded.assign(this->Levels[0].size(), -1);
  for (Index thing = 0; thing < this->CountAtFirst; ++thing)
  {
    this->Set(thing, this->Boxes[thing]);
  }
}

/// Lets all that is around a leaf be around a box.
void BoxTree::Grow(Index leaf, const Rounded& box)
{
  Index number = leaf;
  for (std::size_t level = 1; level < this->Levels.size(); ++level)
  {
    if (!this->Levels[level][number / Width].Grow(number % Width, box))
    {
      return; // and so all above has been
    }
    number /= Width;
  }
}

void BoxTree::Set(Index thing, const Box3& box)
{
  this->Boxes[thing] = box;
  const Rounded rounded(box);
  if (thing < this->CountAtFirst)
  {
    this->Levels[0][thing / Width].Set(thing % Width, rounded);
    this->Grow(thing / Width, rounded);
  }
  else
  {
    this->Grow(this->LeafOfAdded[thing - this->CountAtFirst], rounded);
  }
}

void BoxTree::Add(const Box3& box, Index beside)
{
  const Index added = this->Count() - this->CountAtFirst;
  const Index leaf =
    beside < this->CountAtFirst ? beside / Width : this->LeafOfAdded[beside - this->CountAtFirst];
  this->Boxes.push_back(box);
  this->LeafOfAdded.push_back(leaf);
  this->NextAdded.push_back(this->FirstAdded[leaf]);
  this->FirstAdded[leaf] = added;
  this->Grow(leaf, Rounded(box));
}
}
