// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesRanks_h
#define OrthoSlicesRanks_h

#include <cstddef>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

namespace orthoslices
{
/**
 * The processes that make one surface together. All of them have the same input and the same
 * settings, and run the same stages; a stage that is split does its work for the items of its rank,
 * and hands on what the others need of that. Everything that follows from the input alone is
 * computed by each, so that nothing has to be said of it.
 */
struct Ranks
{
  using Bytes = std::vector<char>;

  int Rank = 0;
  int Count = 1;
  /// Gives all ranks the bytes of all, by rank. Each rank has to call it equally often. Throws if
  /// another rank has failed. DEFAULT: there are no others.
  std::function<std::vector<Bytes>(const Bytes&)> Gather = [](const Bytes& own)
  { return std::vector<Bytes>{ own }; };

  bool AreSeveral() const { return this->Count > 1; }
};

/// The same for numbers, or other data without pointers.
template <typename Value>
std::vector<std::vector<Value>> GatherValues(const Ranks& ranks, const std::vector<Value>& own)
{
  Ranks::Bytes bytes(own.size() * sizeof(Value));
  if (!own.empty())
  {
    std::memcpy(bytes.data(), own.data(), bytes.size());
  }
  std::vector<std::vector<Value>> all;
  for (const Ranks::Bytes& received : ranks.Gather(bytes))
  {
    std::vector<Value> values(received.size() / sizeof(Value));
    if (!values.empty())
    {
      std::memcpy(values.data(), received.data(), received.size());
    }
    all.push_back(std::move(values));
  }
  return all;
}

/// The values of all ranks, one behind the other.
template <typename Value>
std::vector<Value> JoinValues(const Ranks& ranks, const std::vector<Value>& own)
{
  std::vector<Value> joined;
  for (const std::vector<Value>& values : GatherValues(ranks, own))
  {
    joined.insert(joined.end(), values.begin(), values.end());
  }
  return joined;
}

/// A part of a list of items, from `First` to `Last` - 1.
struct Portion
{
  std::size_t First = 0;
  std::size_t Last = 0;

  bool Has(std::size_t item) const { return this->First <= item && item < this->Last; }
};

/**
 * Divides a list of items into parts with about the same work, one behind the other. `workOf` says
 * how much each item is. Returns the first item of each part, and the number of items; parts are
 * empty where there are fewer items.
 */
template <typename Work>
std::vector<std::size_t> DivideWork(int parts, std::size_t count, Work&& workOf)
{
  double total = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    total += workOf(i);
  }
  std::vector<std::size_t> first{ 0 };
  double before = 0.0; // the work of all items before this one
  for (std::size_t i = 0; i < count; ++i)
  {
    while (first.size() < static_cast<std::size_t>(parts) &&
      before * parts >= total * static_cast<double>(first.size()))
    {
      first.push_back(i);
    }
    before += workOf(i);
  }
  first.resize(static_cast<std::size_t>(parts) + 1, count);
  return first;
}

/// The items of one rank, such that all ranks have about the same work.
template <typename Work>
Portion PortionOf(const Ranks& ranks, std::size_t count, Work&& workOf)
{
  const std::vector<std::size_t> first = DivideWork(ranks.Count, count, std::forward<Work>(workOf));
  return { first[ranks.Rank], first[ranks.Rank + 1] };
}
}

#endif
