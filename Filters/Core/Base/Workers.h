// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWorkers_h
#define OrthoSlicesWorkers_h

#include "Core/Base/Execution.h"

#include <memory>

namespace orthoslices
{
/**
 * How many items a thread takes next from what is left of a loop: so many that taking them costs
 * little, and so few that a request to stop is heard soon and that all threads end together.
 */
class RangeLength
{
public:
  explicit RangeLength(std::size_t threads)
    : Threads(threads)
  {
  }

  /// At least 1, at most a share of what is left.
  std::size_t Next(std::size_t left) const;

  /// Takes how long a range of that many items took, in seconds.
  void Learn(std::size_t items, double seconds);

private:
  std::size_t Threads;
  std::size_t Wanted = 1;
};

/**
 * Threads that run loops together with the thread that asks for them. They come with the first loop
 * of more than one item, sleep between loops and end with this object. Nothing of it is common to
 * several objects.
 */
class Workers
{
public:
  /// So many threads at most, that of the caller among them.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  void operator=(const Workers&) = delete;

  /// Runs ranges that cover [0, count), each once, and returns when all have ended. If one throws,
  /// ranges that nobody has begun are left out, and the first exception comes out of this. A loop
  /// that is asked for within another one runs in the thread that asks, and so does one that is
  /// asked for while another thread has a loop here.
  void For(std::size_t count, const Execution::Range& run);

private:
  class Pool;
  std::unique_ptr<Pool> Threads;
};

/// Loops run on so many threads.
Execution ExecuteOnThreads(int threads);
}

#endif
