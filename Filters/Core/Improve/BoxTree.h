// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBoxTree_h
#define OrthoSlicesBoxTree_h

#include "Core/Base/Box.h"
#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
/**
 * Boxes around things that are numbered from 0, as a binary tree, to find those near a place. Boxes
 * may change, and others be added beside one that is there; the tree keeps its shape. It is good
 * where things with neighbouring numbers are near each other, and boxes do not go far.
 */
class BoxTree
{
public:
  explicit BoxTree(std::vector<Box3> boxes);

  Index Count() const { return static_cast<Index>(this->Boxes.size()); }
  const Box3& operator[](Index thing) const { return this->Boxes[thing]; }
  /// Replaces a box.
  void Set(Index thing, const Box3& box);
  /// Adds the box with the next number, near that of another thing.
  void Add(const Box3& box, Index beside);

  /// Calls visit(thing) for all whose boxes meet this one.
  template <typename Visit>
  void ForBoxesAt(const Box3& box, Visit&& visit) const;

private:
  /// Things in the smallest boxes. It changes the time only.
  static constexpr Index InLeaf = 4;

  void Grow(Index leaf, const Box3& box);

  std::vector<Box3> Boxes;
  std::vector<Index> Leaf;               ///< of each thing
  std::vector<Index> First, Next;        ///< of each leaf the first thing, of each thing the next
  std::vector<std::vector<Box3>> Levels; ///< leaves first; box i of a level has 2 i and 2 i + 1
};

template <typename Visit>
void BoxTree::ForBoxesAt(const Box3& box, Visit&& visit) const
{
  // Level and number of boxes to be looked into: two of each level at most, of 32.
  std::array<std::array<Index, 2>, 64> open;
  std::size_t count = 0;
  open[count++] = { static_cast<Index>(this->Levels.size()) - 1, 0 };
  while (count > 0)
  {
    const auto [level, number] = open[--count];
    if (!box.Meets(this->Levels[level][number]))
    {
      continue;
    }
    if (level == 0)
    {
      for (Index i = this->First[number]; i >= 0; i = this->Next[i])
      {
        if (box.Meets(this->Boxes[i]))
        {
          visit(i);
        }
      }
      continue;
    }
    const Index last = static_cast<Index>(this->Levels[level - 1].size()) - 1;
    for (Index below = std::min(last, 2 * number + 1); below >= 2 * number; --below)
    {
      open[count++] = { level - 1, below };
    }
  }
}
}

#endif
