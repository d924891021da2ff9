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
 * Boxes around things that are numbered from 0, as a tree of eight branches, to find those near a
 * place. Boxes may change, and others be added beside one that is there; the tree keeps its shape.
 * It is good where things with neighbouring numbers are near each other, and boxes do not go far.
 * In the tree boxes are of single precision, rounded outwards: eight are compared at once.
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
  static constexpr Index Width = 8;

  /// A box of single precision.
  struct Rounded
  {
    std::array<float, 3> Low, High;

    explicit Rounded(const Box3& box);
  };

  /// Eight boxes, and all that is around them.
  struct Branches
  {
    std::array<std::array<float, Width>, 3> Low, High;

    Branches();
    void Set(Index branch, const Rounded& box);
    /// False if it has been around that before.
    bool Grow(Index branch, const Rounded& box);
    /// Which of them meet a box: not 0.
    std::array<int, Width> Meet(const Rounded& box) const;
  };

  void Grow(Index leaf, const Rounded& box);
  template <typename Visit>
  void VisitLeaf(Index leaf, const Box3& box, const Rounded& rounded, Visit&& visit) const;

  std::vector<Box3> Boxes;
  Index CountAtFirst = 0;
  /// Leaves first; branch b of node i of a level is node 8 i + b of the level below, or that thing.
  std::vector<std::vector<Branches>> Levels;
  /// Of each leaf the first thing that was added there, of each of these the next one, and its leaf.
  std::vector<Index> FirstAdded, NextAdded, LeafOfAdded;
};

inline std::array<int, BoxTree::Width> BoxTree::Branches::Meet(const Rounded& box) const
{
  std::array<int, Width> meet;
  for (Index i = 0; i < Width; ++i)
  {
    meet[i] = static_cast<int>(this->Low[0][i] <= box.High[0]) &
      static_cast<int>(box.Low[0] <= this->High[0][i]) &
      static_cast<int>(this->Low[1][i] <= box.High[1]) &
      static_cast<int>(box.Low[1] <= this->High[1][i]) &
      static_cast<int>(this->Low[2][i] <= box.High[2]) &
      static_cast<int>(box.Low[2] <= this->High[2][i]);
  }
  return meet;
}

template <typename Visit>
void BoxTree::VisitLeaf(Index leaf, const Box3& box, const Rounded& rounded, Visit&& visit) const
{
  const std::array<int, Width> meet = this->Levels[0][leaf].Meet(rounded);
  for (Index i = 0; i < Width; ++i)
  {
    if (meet[i] != 0 && box.Meets(this->Boxes[Width * leaf + i]))
    {
      visit(Width * leaf + i);
    }
  }
  for (Index added = this->FirstAdded[leaf]; added >= 0; added = this->NextAdded[added])
  {
    if (box.Meets(this->Boxes[this->CountAtFirst + added]))
    {
      visit(this->CountAtFirst + added);
    }
  }
}

template <typename Visit>
void BoxTree::ForBoxesAt(const Box3& box, Visit&& visit) const
{
  const Rounded rounded(box);
  // Level and number of nodes to be looked into: seven of each level and one more at most, of 11.
  std::array<std::array<Index, 2>, 88> open;
  std::size_t count = 0;
  open[count++] = { static_cast<Index>(this->Levels.size()) - 1, 0 };
  while (count > 0)
  {
    const auto [level, number] = open[--count];
    if (level == 0)
    {
      this->VisitLeaf(number, box, rounded, visit);
      continue;
    }
    const std::array<int, Width> meet = this->Levels[level][number].Meet(rounded);
    for (Index i = Width - 1; i >= 0; --i)
    {
      if (meet[i] != 0)
      {
        open[count++] = { level - 1, Width * number + i };
      }
    }
  }
}
}

#endif
