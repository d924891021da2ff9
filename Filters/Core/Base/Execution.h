// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesExecution_h
#define OrthoSlicesExecution_h

#include <cstddef>
#include <functional>

namespace orthoslices
{
/**
 * How the caller runs loops, hears of progress and stops. Work items are independent and write to
 * places of their own, so that the result does not depend on how the range is split.
 */
struct Execution
{
  using Range = std::function<void(std::size_t begin, std::size_t end)>;

  /// Calls the function for ranges that cover [0, count). DEFAULT: one range, this thread.
  std::function<void(std::size_t count, const Range&)> For = [](std::size_t count, const Range& run)
  {
    if (count > 0)
    {
      run(0, count);
    }
  };

  /// Takes the progress in [0, 1]; false stops at the next stage. DEFAULT: never stops.
  std::function<bool(double progress)> Continue = [](double) { return true; };
};
}

#endif
