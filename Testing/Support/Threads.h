// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   loops on several threads in small ranges, to find out whether the result depends on them
 */

#ifndef OrthoSlicesThreads_h
#define OrthoSlicesThreads_h

#include "Core/Base/Execution.h"
#include "Core/Base/Types.h"
#include "Support/Random.h"

#include <algorithm>
#include <thread>

namespace orthoslices
{
namespace support
{

/// Four threads and many small ranges of random order.
inline Execution ManyThreads()
{
  Execution execution;
  execution.For = [](std::size_t count, const Execution::Range& run)
  {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < count; i += 1 + count / 13)
    {
      starts.push_back(i);
    }
    Random(count).Shuffle(starts);
    const auto work = [&](std::size_t thread)
    {
      for (std::size_t i = thread; i < starts.size(); i += 4)
      {
        run(starts[i], std::min(count, starts[i] + 1 + count / 13));
      }
    };
    std::vector<std::thread> threads;
    for (std::size_t thread = 0; thread < 4; ++thread)
    {
      threads.emplace_back(work, thread);
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  };
  return execution;
}

} // namespace support
} // namespace orthoslices

#endif
