// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/Workers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace orthoslices
{
namespace
{
/// A range should take about that long, in seconds: some hundred times what it costs to take one
/// and to ask whether to go on, and a small part of what somebody notices who has asked to stop.
constexpr double ShortRange = 0.5e-3;
constexpr double LongRange = 5e-3;

/// Of what is left of a loop no thread takes more than that part of its share at once.
constexpr std::size_t PartsOfShare = 4;

/// Whether this thread runs a range of a loop.
thread_local bool IsWorking = false;

/// A loop whose ranges several threads take.
struct SharedLoop
{
  SharedLoop(std::size_t count, const Execution::Range& run)
    : Count(count)
    , Run(run)
  {
  }

  /// Takes ranges and runs them until there are none left.
  void Work(std::size_t threads);

  const std::size_t Count;
  const Execution::Range& Run;
  std::atomic<std::size_t> Begun{ 0 }; ///< items that somebody has taken
  std::mutex Lock;
  std::exception_ptr Thrown; ///< guarded by Lock
};

void SharedLoop::Work(std::size_t threads)
{
  using Clock = std::chrono::steady_clock;
  RangeLength length(threads);
  IsWorking = true;
  try
  {
    auto start = Clock::now();
    std::size_t begin = this->Begun.load();
    while (begin < this->Count)
    {
      const std::size_t end = begin + length.Next(this->Count - begin);
      if (!this->Begun.compare_exchange_weak(begin, end))
      {
        continue;
      }
      this->Run(begin, end);
      const auto now = Clock::now();
      length.Learn(end - begin, std::chrono::duration<double>(now - start).count());
      start = now;
      begin = this->Begun.load();
    }
  }
  catch (...)
  {
    this->Begun = this->Count;
    const std::lock_guard<std::mutex> guard(this->Lock);
    this->Thrown = this->Thrown ? this->Thrown : std::current_exception();
  }
  IsWorking = false;
}
}

std::size_t RangeLength::Next(std::size_t left) const
{
  const std::size_t most = left / (PartsOfShare * this->Threads);
  return std::max<std::size_t>(1, std::min(this->Wanted, most));
}

void RangeLength::Learn(std::size_t items, double seconds)
{
  if (seconds < ShortRange)
  {
    this->Wanted = std::max(this->Wanted, 2 * items);
  }
  else if (seconds > LongRange)
  {
    this->Wanted = std::max<std::size_t>(1, items / 2);
  }
}

/// The threads besides that of the caller.
class Workers::Pool
{
public:
  explicit Pool(int threads)
    : Most(static_cast<std::size_t>(std::max(1, threads)))
  {
  }
  ~Pool();

  void For(std::size_t count, const Execution::Range& run);

private:
  void Start();
  void Wait(); ///< what a thread does: waits for loops and takes part in them

  const std::size_t Most;
  std::vector<std::thread> Threads;
  std::mutex OneLoop; ///< held while there is a loop
  std::mutex Lock;    ///< guards what follows
  std::condition_variable HasLoop, HasEnded;
  SharedLoop* Loop = nullptr; ///< null: no loop, or nothing is left of it
  std::size_t Wanted = 0;     ///< threads that may still join it
  std::size_t Joined = 0;     ///< threads that work on it, without the caller
  bool IsOver = false;
};

Workers::Pool::~Pool()
{
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    this->IsOver = true;
  }
  this->HasLoop.notify_all();
  for (std::thread& thread : this->Threads)
  {
    thread.join();
  }
}

void Workers::Pool::Start()
{
  try
  {
    while (this->Threads.size() + 1 < this->Most)
    {
      this->Threads.emplace_back([this]() { this->Wait(); });
    }
  }
  catch (const std::system_error&)
  {
    // The system has no more threads: those that there are do the work.
  }
}

void Workers::Pool::Wait()
{
  std::unique_lock<std::mutex> lock(this->Lock);
  while (!this->IsOver)
  {
    if (this->Loop == nullptr || this->Wanted == 0)
    {
      this->HasLoop.wait(lock);
      continue;
    }
    SharedLoop* loop = this->Loop;
    --this->Wanted;
    ++this->Joined;
    lock.unlock();
    loop->Work(this->Most);
    lock.lock();
    if (--this->Joined == 0)
    {
      this->HasEnded.notify_one();
    }
  }
}

void Workers::Pool::For(std::size_t count, const Execution::Range& run)
{
  std::unique_lock<std::mutex> one(this->OneLoop, std::defer_lock);
  if (IsWorking || (this->Most > 1 && !one.try_lock()))
  {
    run(0, count);
    return;
  }
  SharedLoop loop(count, run);
  if (this->Most > 1 && count > 1)
  {
    this->Start();
    const std::size_t others = std::min(this->Threads.size(), count - 1);
    {
      const std::lock_guard<std::mutex> guard(this->Lock);
      this->Loop = &loop;
      this->Wanted = others;
    }
    for (std::size_t i = 0; i < others; ++i)
    {
      this->HasLoop.notify_one();
    }
  }
  loop.Work(this->Most);
  {
    std::unique_lock<std::mutex> lock(this->Lock);
    this->Loop = nullptr;
    this->HasEnded.wait(lock, [this]() { return this->Joined == 0; });
  }
  if (loop.Thrown)
  {
    std::rethrow_exception(loop.Thrown);
  }
}

Workers::Workers(int threads)
  : Threads(std::make_unique<Pool>(threads))
{
}

Workers::~Workers() = default;

void Workers::For(std::size_t count, const Execution::Range& run)
{
  if (count > 0)
  {
    this->Threads->For(count, run);
  }
}

Execution ExecuteOnThreads(int threads)
{
  Execution execution;
  execution.For = [workers = std::make_shared<Workers>(threads)](
                    std::size_t count, const Execution::Range& run) { workers->For(count, run); };
  return execution;
}
}
