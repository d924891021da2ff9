// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDisjointSets_h
#define OrthoSlicesDisjointSets_h

#include "Core/Base/Types.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace orthoslices
{
/// A partition of the numbers 0 to count - 1 that becomes coarser (union-find).
class DisjointSets
{
public:
  explicit DisjointSets(Index count = 0)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  /// How many numbers there are.
  Index Count() const { return static_cast<Index>(this->Parent.size()); }

  /// One number more, in a set of its own.
  void Add() { this->Parent.push_back(this->Count()); }

  /// The least number of the set of i.
  Index Find(Index i)
  {
    while (this->Parent[i] != i)
    {
      this->Parent[i] = this->Parent[this->Parent[i]];
      i = this->Parent[i];
    }
    return i;
  }

  /// Joins the sets of i and j. False if both were in one set already.
  bool Unite(Index i, Index j)
  {
    const Index a = this->Find(i);
    const Index b = this->Find(j);
    this->Parent[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::vector<Index> Parent;
};
}

#endif
