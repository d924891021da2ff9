// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   random numbers that are the same on every platform (splitmix64)
 */

#ifndef OrthoSlicesRandom_h
#define OrthoSlicesRandom_h

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace support
{

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }

  std::uint64_t Bits()
  {
    std::uint64_t z = (this->State += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }

  /// In [low, high).
  double Uniform(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Bits() >> 11) * 0x1p-53;
  }

  /// In [0, count).
  std::size_t Below(std::size_t count) { return static_cast<std::size_t>(this->Bits() % count); }

  bool Chance(double probability) { return this->Uniform(0.0, 1.0) < probability; }

  template <typename T>
  void Shuffle(std::vector<T>& items)
  {
    for (std::size_t i = items.size(); i > 1; --i)
    {
      std::swap(items[i - 1], items[this->Below(i)]);
    }
  }

private:
  std::uint64_t State;
};

} // namespace support
} // namespace orthoslices

#endif
