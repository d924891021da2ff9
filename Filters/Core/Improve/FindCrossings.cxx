// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/FindCrossings.h"

#include "Core/Base/Box.h"
#include "Core/Base/Predicates.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Triangles in the smallest boxes, and how many of these are asked for in a row. They change the
/// time only.
constexpr std::size_t InLeaf = 4;
constexpr std::size_t BlockSize = 64;

/// Spreads the lowest ten bits of a number, two zeros between each and the next.
std::uint32_t Spread(std::uint32_t x)
{
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  return (x | (x << 2)) & 0x09249249u;
}

using Triangle = std::array<Index, 3>;

/// Boxes around triangles that lie near each other, as a binary tree.
class BoxTree
{
public:
  BoxTree(const std::vector<Point3>& points, const std::vector<Triangle>& triangles);

  std::size_t CountLeaves() const { return this->Levels[0].size(); }
  /// Calls visit(triangle, its box) for the triangles of a leaf.
  template <typename Visit>
  void VisitLeaf(std::size_t leaf, Visit&& visit) const
  {
    const std::size_t last = std::min(this->Order.size(), (leaf + 1) * InLeaf);
    for (std::size_t i = leaf * InLeaf; i < last; ++i)
    {
      visit(this->Order[i], this->Boxes[i]);
    }
  }
  /// Lists the leaves that meet a box.
  void ListLeaves(const Box3& box, std::vector<std::size_t>& leaves) const;

private:
  void Sort(const std::vector<Point3>& points, const std::vector<Triangle>& triangles);

  std::vector<Index> Order;
  std::vector<Box3> Boxes;               ///< of the triangles, in that order
  std::vector<std::vector<Box3>> Levels; ///< the leaves first; box i of a level has 2 i and 2 i + 1
};

BoxTree::BoxTree(const std::vector<Point3>& points, const std::vector<Triangle>& triangles)
  : Boxes(triangles.size())
{
  this->Sort(points, triangles);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (const Index corner : triangles[this->Order[i]])
    {
      this->Boxes[i].Add(points[corner]);
    }
  }
  this->Levels.emplace_back((triangles.size() + InLeaf - 1) / InLeaf);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    this->Levels[0][i / InLeaf].Add(this->Boxes[i]);
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

/// Along the curve that visits the eight parts of a cube one after another (G. M. Morton, 1966).
void BoxTree::Sort(const std::vector<Point3>& points, const std::vector<Triangle>& triangles)
{
  constexpr double steps = 1023.0;
  Box3 all;
  for (const Triangle& triangle : triangles)
  {
    all.Add(points[triangle[0]]);
  }
  std::vector<std::pair<std::uint32_t, Index>> codes(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    std::uint32_t code = 0;
    const Point3& place = points[triangles[t][0]];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double size = all.High[axis] - all.Low[axis];
      const double share = size > 0.0 ? (place[axis] - all.Low[axis]) / size : 0.0;
      code |= Spread(static_cast<std::uint32_t>(share * steps)) << axis;
    }
    codes[t] = { code, static_cast<Index>(t) };
  }
  std::sort(codes.begin(), codes.end());
  for (const auto& entry : codes)
  {
    this->Order.push_back(entry.second);
  }
}

void BoxTree::ListLeaves(const Box3& box, std::vector<std::size_t>& leaves) const
{
  leaves.clear();
  std::vector<std::pair<std::size_t, std::size_t>> open{ { this->Levels.size() - 1, 0 } };
  while (!open.empty())
  {
    const auto [level, number] = open.back();
    open.pop_back();
    if (!box.Meets(this->Levels[level][number]))
    {
      continue;
    }
    if (level == 0)
    {
      leaves.push_back(number);
      continue;
    }
    for (const std::size_t below : { 2 * number + 1, 2 * number })
    {
      if (below < this->Levels[level - 1].size())
      {
        open.emplace_back(level - 1, below);
      }
    }
  }
}

/// Whether two triangles certainly meet in their common corners only. Reuses the memory of its
/// lists.
class PairTest
{
public:
  PairTest(const std::vector<Point3>& points, const std::vector<Triangle>& triangles)
    : Points(points)
    , Triangles(triangles)
  {
  }

  bool AreApart(Index a, Index b)
  {
    const Triangle &s = this->Triangles[a], &t = this->Triangles[b];
    const std::array<Point3, 3> p{ this->Points[s[0]], this->Points[s[1]], this->Points[s[2]] };
    const std::array<Point3, 3> q{ this->Points[t[0]], this->Points[t[1]], this->Points[t[2]] };
    this->Common.Find(s, t);
    const std::vector<int>&ofFirst = this->Common.OfFirst, &ofSecond = this->Common.OfSecond;
    return (ofFirst.size() == 1 &&
             (IsOnOneSide(p, q, ofSecond[0]) || IsOnOneSide(q, p, ofFirst[0]))) ||
      CertainlyApartBeyond(this->Common, p, q);
  }

private:
  /// Whether a triangle lies on one side of the plane of another one, but for a corner that both
  /// have.
  static bool IsOnOneSide(
    const std::array<Point3, 3>& other, const std::array<Point3, 3>& triangle, int corner)
  {
    const int side = CertainSide(other[0], other[1], other[2], triangle[(corner + 1) % 3]);
    return side != 0 &&
      side == CertainSide(other[0], other[1], other[2], triangle[(corner + 2) % 3]);
  }

  const std::vector<Point3>& Points;
  const std::vector<Triangle>& Triangles;
  CommonCorners Common;
};

/// The tests of the marked triangles of one leaf of the tree.
class LeafTest
{
public:
  LeafTest(const BoxTree& tree, const std::vector<std::uint8_t>& isMarked, PairTest test)
    : Tree(tree)
    , IsMarked(isMarked)
    , Test(std::move(test))
  {
  }

  /// Adds the pairs that are not certainly apart.
  void Run(std::size_t leaf, std::vector<std::pair<Index, Index>>& pairs)
  {
    Box3 box;
    this->Marked.clear();
    this->Tree.VisitLeaf(leaf,
      [&](Index triangle, const Box3& own)
      {
        if (this->IsMarked[triangle] != 0)
        {
          this->Marked.push_back({ triangle, own });
          box.Add(own);
        }
      });
    if (this->Marked.empty())
    {
      return;
    }
    this->Tree.ListLeaves(box, this->Leaves);
    for (const std::size_t other : this->Leaves)
    {
      this->Tree.VisitLeaf(other,
        [&](Index triangle, const Box3& own)
        {
          if (own.Meets(box))
          {
            this->TestAgainst({ triangle, own }, pairs);
          }
        });
    }
  }

private:
  using BoxedTriangle = std::pair<Index, Box3>;

  void TestAgainst(const BoxedTriangle& other, std::vector<std::pair<Index, Index>>& pairs)
  {
    const bool isMarked = this->IsMarked[other.first] != 0;
    for (const BoxedTriangle& triangle : this->Marked)
    {
      // Of two marked ones, once.
      const bool isFirst = isMarked ? other.first > triangle.first : true;
      if (isFirst && other.second.Meets(triangle.second) &&
        !this->Test.AreApart(triangle.first, other.first))
      {
        pairs.push_back(std::minmax(triangle.first, other.first));
      }
    }
  }

  const BoxTree& Tree;
  const std::vector<std::uint8_t>& IsMarked;
  PairTest Test;
  std::vector<BoxedTriangle> Marked;
  std::vector<std::size_t> Leaves;
};
}

std::vector<std::pair<Index, Index>> FindCrossings(const std::vector<Point3>& points,
  const std::vector<std::array<Index, 3>>& triangles, const std::vector<std::uint8_t>& isMarked,
  const Execution& execution)
{
  std::vector<std::pair<Index, Index>> all;
  if (std::none_of(isMarked.begin(), isMarked.end(), [](std::uint8_t mark) { return mark != 0; }))
  {
    return all;
  }
  const BoxTree tree(points, triangles);
  const std::size_t leaves = tree.CountLeaves();
  std::vector<std::vector<std::pair<Index, Index>>> found((leaves + BlockSize - 1) / BlockSize);
  execution.For(found.size(),
    [&](std::size_t begin, std::size_t end)
    {
      LeafTest test(tree, isMarked, PairTest(points, triangles));
      for (std::size_t leaf = begin * BlockSize; leaf < std::min(leaves, end * BlockSize); ++leaf)
      {
        test.Run(leaf, found[leaf / BlockSize]);
      }
    });
  for (const auto& pairs : found)
  {
    all.insert(all.end(), pairs.begin(), pairs.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}
}
