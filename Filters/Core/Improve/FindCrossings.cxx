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
/// Triangles in the smallest boxes, and queries in a row. They change the time only.
constexpr std::size_t InLeaf = 4;
constexpr std::size_t BlockSize = 512;

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

  /// Calls visit(triangle) for those whose box meets that of a triangle.
  template <typename Visit>
  void VisitNear(Index triangle, Visit&& visit) const;

private:
  void Sort(const std::vector<Point3>& points, const std::vector<Triangle>& triangles);

  std::vector<Index> Order;
  std::vector<Box3> OfTriangle;
  std::vector<std::vector<Box3>> Levels; ///< the leaves first; box i of a level has 2 i and 2 i + 1
};

BoxTree::BoxTree(const std::vector<Point3>& points, const std::vector<Triangle>& triangles)
  : OfTriangle(triangles.size())
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const Index corner : triangles[t])
    {
      this->OfTriangle[t].Add(points[corner]);
    }
  }
  this->Sort(points, triangles);
  this->Levels.emplace_back((triangles.size() + InLeaf - 1) / InLeaf);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    this->Levels[0][i / InLeaf].Add(this->OfTriangle[this->Order[i]]);
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
  for (const Box3& box : this->OfTriangle)
  {
    all.Add(box);
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

template <typename Visit>
void BoxTree::VisitNear(Index triangle, Visit&& visit) const
{
  const Box3& own = this->OfTriangle[triangle];
  std::vector<std::pair<std::size_t, std::size_t>> open{ { this->Levels.size() - 1, 0 } };
  while (!open.empty())
  {
    const auto [level, number] = open.back();
    open.pop_back();
    if (!own.Meets(this->Levels[level][number]))
    {
      continue;
    }
    if (level > 0)
    {
      for (const std::size_t below : { 2 * number + 1, 2 * number })
      {
        if (below < this->Levels[level - 1].size())
        {
          open.emplace_back(level - 1, below);
        }
      }
      continue;
    }
    const std::size_t last = std::min(this->Order.size(), (number + 1) * InLeaf);
    for (std::size_t i = number * InLeaf; i < last; ++i)
    {
      if (own.Meets(this->OfTriangle[this->Order[i]]))
      {
        visit(this->Order[i]);
      }
    }
  }
}

/// Whether two triangles certainly meet in their common corners only. Reuses the memory of its lists.
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
    this->OfFirst.clear();
    this->OfSecond.clear();
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        if (s[i] == t[j])
        {
          this->OfFirst.push_back(i);
          this->OfSecond.push_back(j);
        }
      }
    }
    const std::array<Point3, 3> p{ this->Points[s[0]], this->Points[s[1]], this->Points[s[2]] };
    const std::array<Point3, 3> q{ this->Points[t[0]], this->Points[t[1]], this->Points[t[2]] };
    return this->OfFirst.empty() ? CertainlyApart(p, q)
                                 : CertainlyApartBeyond(this->OfFirst, p, this->OfSecond, q);
  }

private:
  const std::vector<Point3>& Points;
  const std::vector<Triangle>& Triangles;
  std::vector<int> OfFirst, OfSecond;
};
}

std::vector<std::pair<Index, Index>> FindCrossings(const std::vector<Point3>& points,
  const std::vector<std::array<Index, 3>>& triangles, const std::vector<std::uint8_t>& isMarked,
  const Execution& execution)
{
  std::vector<std::pair<Index, Index>> all;
  std::vector<Index> marked;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (isMarked[t] != 0)
    {
      marked.push_back(static_cast<Index>(t));
    }
  }
  if (marked.empty())
  {
    return all;
  }
  const BoxTree tree(points, triangles);
  std::vector<std::vector<std::pair<Index, Index>>> found(
    (marked.size() + BlockSize - 1) / BlockSize);
  execution.For(found.size(),
    [&](std::size_t begin, std::size_t end)
    {
      PairTest test(points, triangles);
      for (std::size_t i = begin * BlockSize; i < std::min(marked.size(), end * BlockSize); ++i)
      {
        const Index t = marked[i];
        tree.VisitNear(t,
          [&](Index other)
          {
            const bool isOther = isMarked[other] != 0 ? other > t : true;
            if (isOther && other != t && !test.AreApart(t, other))
            {
              found[i / BlockSize].push_back(std::minmax(t, other));
            }
          });
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
