// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesExecution_h
#define OrthoSlicesExecution_h

#include <cstddef>
#include <functional>

namespace orthoslices
{
/// Leaves a loop when the caller has asked to stop. Reconstruct and ReconstructLabels catch it.
struct Stopped
{
};

/**
 * How the caller runs loops, hears of progress and stops. Work items are independent and write to
 * places of their own, so that the result does not depend on how the range is split.
 */
struct Execution
{
  using Range = std::function<void(std::size_t begin, std::size_t end)>;
  /// Takes how many items of a loop are done: 0 once when it begins. May throw to end the loop.
  using Watcher = std::function<void(std::size_t done, std::size_t count)>;

  /// Calls the function for ranges that cover [0, count). What the function throws comes out of it.
  /// DEFAULT: one range, this thread.
  std::function<void(std::size_t count, const Range&)> For = [](std::size_t count, const Range& run)
  {
    if (count > 0)
    {
      run(0, count);
    }
  };

  /// Takes the progress in [0, 1]; false stops at the next stage. DEFAULT: never stops.
  std::function<bool(double progress)> Continue = [](double) { return true; };

  /// Takes what is going to be done next, in words for the user. DEFAULT: tells nobody.
  std::function<void(const char* text)> Announce = [](const char*) {};

  /// Hears of loops, see ForInOrder and Watch. DEFAULT: nobody hears.
  Watcher Advance = [](std::size_t, std::size_t) {};
};

/// As the execution, but that `advance` hears of all loops: how many items are done, after each
/// range that the thread has run that called For, and only from that thread. Loops within loops run
/// in the thread that they are in, and nobody hears of them.
Execution Watch(const Execution& execution, const Execution::Watcher& advance);

/// A loop whose items come one after another, all in this thread, of which Advance hears at least
/// once in every 256 items, if this is not within another loop.
void ForInOrder(
  const Execution& execution, std::size_t count, const std::function<void(std::size_t)>& run);
}

#endif
