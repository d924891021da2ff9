// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   threads in the place of processes that make one surface together
 */

#ifndef OrthoSlicesThreadRanks_h
#define OrthoSlicesThreadRanks_h

#include "Core/Base/Ranks.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace orthoslices
{
namespace support
{

/// Exchanges what several threads have.
class ThreadRanks
{
public:
  explicit ThreadRanks(int count)
    : Count(count)
    , Given(count)
  {
  }

  /// Calls run(ranks) in a thread for each rank, and waits for all.
  template <typename Run>
  void ForAll(Run&& run)
  {
    std::vector<std::thread> threads;
    for (int rank = 0; rank < this->Count; ++rank)
    {
      threads.emplace_back(
        [&, rank]
        {
          Ranks ranks;
          ranks.Rank = rank;
          ranks.Count = this->Count;
          ranks.Gather = [&, rank](const Ranks::Bytes& own) { return this->Gather(rank, own); };
          run(ranks);
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }

private:
  std::vector<Ranks::Bytes> Gather(int rank, const Ranks::Bytes& own)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Given[rank] = own;
    const int round = this->Round;
    if (++this->Arrived == this->Count)
    {
      this->Arrived = 0;
      ++this->Round;
      this->Gathered = this->Given;
      this->AllHere.notify_all();
    }
    // The next round ends when this thread has given its part of it, too.
    this->AllHere.wait(lock, [&] { return this->Round != round; });
    return this->Gathered;
  }

  int Count;
  std::mutex Mutex;
  std::condition_variable AllHere;
  std::vector<Ranks::Bytes> Given, Gathered;
  int Arrived = 0, Round = 0;
};

} // namespace support
} // namespace orthoslices

#endif
