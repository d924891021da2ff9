// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Execution.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace orthoslices
{
namespace
{
/// Items of a loop in one thread between two calls of Advance.
constexpr std::size_t ItemsBetweenCalls = 256;

/// Whether this thread is within a loop that is watched.
thread_local bool IsInLoop = false;

/// Is in a loop for as long as this lives.
class InLoop
{
public:
  InLoop() { IsInLoop = true; }
  ~InLoop() { IsInLoop = false; }
  InLoop(const InLoop&) = delete;
  void operator=(const InLoop&) = delete;
};
}

Execution Watch(const Execution& execution, const Execution::Watcher& advance)
{
  Execution watched = execution;
  watched.Advance = advance;
  watched.For = [loop = execution.For, advance](std::size_t count, const Execution::Range& run)
  {
    if (count == 0)
    {
      return;
    }
    if (IsInLoop)
    {
      run(0, count);
      return;
    }
    advance(0, count);
    std::atomic<std::size_t> done{ 0 };
    std::size_t heard = 0;
    const std::thread::id caller = std::this_thread::get_id();
    loop(count,
      [&](std::size_t begin, std::size_t end)
      {
        {
          const InLoop inLoop;
          run(begin, end);
        }
        const std::size_t sum = done.fetch_add(end - begin) + (end - begin);
        if (std::this_thread::get_id() == caller)
        {
          heard = sum;
          advance(sum, count);
        }
      });
    if (heard < count) // another thread has done the last range
    {
      advance(count, count);
    }
  };
  return watched;
}

void ForInOrder(
  const Execution& execution, std::size_t count, const std::function<void(std::size_t)>& run)
{
  const bool isHeard = !IsInLoop;
  for (std::size_t begin = 0; begin < count; begin += ItemsBetweenCalls)
  {
    if (isHeard)
    {
      execution.Advance(begin, count);
    }
    const std::size_t end = std::min(count, begin + ItemsBetweenCalls);
    for (std::size_t i = begin; i < end; ++i)
    {
      run(i);
    }
  }
  if (isHeard && count > 0)
  {
    execution.Advance(count, count);
  }
}
}
