// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   loops on several threads: each item once, exceptions, loops within loops, and how much is
 *          done between two questions whether to go on
 */

#include "Core/Base/Workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace orthoslices;

namespace
{
using Ids = std::set<std::thread::id>;

/// The threads that run items, each of which waits until so many threads have come, a second at
/// most.
Ids ThreadsOf(const Execution& execution, std::size_t count, std::size_t awaited)
{
  std::mutex lock;
  Ids ids;
  execution.For(count,
    [&](std::size_t, std::size_t)
    {
      const auto size = [&]()
      {
        const std::lock_guard<std::mutex> guard(lock);
        ids.insert(std::this_thread::get_id());
        return ids.size();
      };
      for (int i = 0; i < 1000 && size() < awaited; ++i)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
  return ids;
}
}

//----------------------------------------------------------------------------
TEST(Workers, RunEachItemOnce)
{
  for (const int threads : { -1, 1, 2, 3, 8 })
  {
    const Execution execution = ExecuteOnThreads(threads);
    for (const std::size_t count : { 0, 1, 2, 3, 7, 64, 1000, 100000 })
    {
      std::vector<std::atomic<int>> runs(count);
      execution.For(count,
        [&](std::size_t begin, std::size_t end)
        {
          ASSERT_LT(begin, end);
          for (std::size_t i = begin; i < end; ++i)
          {
            ++runs[i];
          }
        });
      EXPECT_TRUE(std::all_of(runs.begin(), runs.end(), [](int n) { return n == 1; }))
        << threads << " threads, " << count << " items";
    }
  }
}

//----------------------------------------------------------------------------
TEST(Workers, AreAsManyAsAskedForAndStayTheSame)
{
  for (const std::size_t threads : { 1, 2, 3, 8 })
  {
    const Execution execution = ExecuteOnThreads(static_cast<int>(threads));
    const Ids first = ThreadsOf(execution, 100, threads);
    EXPECT_EQ(first.size(), threads);
    EXPECT_EQ(first.count(std::this_thread::get_id()), 1u);
    EXPECT_EQ(ThreadsOf(execution, 100, threads), first);
  }
}

//----------------------------------------------------------------------------
TEST(Workers, PassExceptionsOnAndGoOnWorking)
{
  for (const int threads : { 1, 2, 8 })
  {
    const Execution execution = ExecuteOnThreads(threads);
    for (const std::size_t bad : { 0, 500, 999 })
    {
      std::atomic<std::size_t> done{ 0 };
      const auto run = [&](std::size_t begin, std::size_t end)
      {
        if (begin <= bad && bad < end)
        {
          throw std::runtime_error("bad item");
        }
        done += end - begin;
      };
      EXPECT_THROW(execution.For(1000, run), std::runtime_error);
      EXPECT_LT(done.load(), 1000u);
      std::atomic<std::size_t> sum{ 0 };
      execution.For(1000, [&](std::size_t begin, std::size_t end) { sum += end - begin; });
      EXPECT_EQ(sum.load(), 1000u);
    }
  }
}

//----------------------------------------------------------------------------
/// A loop within a loop has no threads of its own.
TEST(Workers, RunLoopsWithinLoopsInOneThread)
{
  const Execution execution = ExecuteOnThreads(3);
  const Execution other = ExecuteOnThreads(3);
  std::atomic<int> inner{ 0 }, elsewhere{ 0 };
  execution.For(20,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::thread::id outside = std::this_thread::get_id();
        for (const Execution* nested : { &execution, &other })
        {
          nested->For(10,
            [&](std::size_t first, std::size_t last)
            {
              inner += static_cast<int>(last - first);
              elsewhere += std::this_thread::get_id() == outside ? 0 : 1;
            });
        }
      }
    });
  EXPECT_EQ(inner, 400);
  EXPECT_EQ(elsewhere, 0);
}

//----------------------------------------------------------------------------
/// Two threads that share workers do not wait for each other.
TEST(Workers, ServeSeveralThreads)
{
  const Execution execution = ExecuteOnThreads(2);
  std::atomic<std::size_t> sum{ 0 };
  const auto work = [&]()
  {
    for (int i = 0; i < 50; ++i)
    {
      execution.For(100, [&](std::size_t begin, std::size_t end) { sum += end - begin; });
    }
  };
  std::thread other(work);
  work();
  other.join();
  EXPECT_EQ(sum.load(), 10000u);
}

//----------------------------------------------------------------------------
/// However long items take, a thread does not do much at once: with items of a given time, no range
/// takes longer than 10 ms but for one item, once the first ones are known.
TEST(RangeLength, IsShortInTime)
{
  for (const double secondsPerItem : { 1e-9, 1e-7, 1e-5, 1e-3, 0.1 })
  {
    RangeLength length(2);
    std::size_t left = 1000000000;
    for (int i = 0; i < 60; ++i)
    {
      const std::size_t items = length.Next(left);
      ASSERT_GE(items, 1u);
      EXPECT_TRUE(items == 1 || items * secondsPerItem < 0.01) << secondsPerItem;
      left -= items;
      length.Learn(items, items * secondsPerItem);
    }
    const double last = length.Next(left) * secondsPerItem;
    EXPECT_GT(last, 1e-4) << "ranges stay too short to be worth taking: " << secondsPerItem;
  }
}

//----------------------------------------------------------------------------
/// Items that suddenly take long make ranges short again.
TEST(RangeLength, FollowsTheTimeOfItems)
{
  RangeLength length(1);
  const std::size_t left = 1000000000;
  for (int i = 0; i < 20; ++i)
  {
    length.Learn(length.Next(left), 1e-8 * length.Next(left));
  }
  const std::size_t many = length.Next(left);
  EXPECT_GT(many, 1000u);
  int ranges = 0;
  for (; length.Next(left) > 1; ++ranges)
  {
    length.Learn(length.Next(left), 1.0);
  }
  EXPECT_LT(ranges, 32);
}

//----------------------------------------------------------------------------
TEST(RangeLength, LeavesWorkForTheOtherThreads)
{
  RangeLength length(8);
  for (int i = 0; i < 40; ++i)
  {
    length.Learn(length.Next(1000000), 0.0);
  }
  EXPECT_LE(length.Next(3200), 100u);
  EXPECT_EQ(length.Next(5), 1u);
}

//----------------------------------------------------------------------------
TEST(Watch, HearsOfEachLoopInTheThreadThatAsks)
{
  for (const int threads : { 1, 2, 8 })
  {
    std::vector<std::size_t> heard;
    const std::thread::id caller = std::this_thread::get_id();
    bool isElsewhere = false;
    const Execution execution = Watch(ExecuteOnThreads(threads),
      [&](std::size_t done, std::size_t count)
      {
        EXPECT_EQ(count, 300u);
        isElsewhere |= std::this_thread::get_id() != caller;
        heard.push_back(done);
      });
    execution.For(300,
      [&](std::size_t begin, std::size_t end)
      {
        execution.For(end - begin, [](std::size_t, std::size_t) {}); // nobody hears of that
        ForInOrder(execution, 3, [](std::size_t) {});
      });
    EXPECT_FALSE(isElsewhere);
    ASSERT_GE(heard.size(), 1u);
    EXPECT_EQ(std::count(heard.begin(), heard.end(), 0u), 1);
    EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
    EXPECT_EQ(heard.back(), 300u);
    execution.For(0, [](std::size_t, std::size_t) { FAIL(); });
  }
}

//----------------------------------------------------------------------------
/// Who throws from what hears of a loop ends it: the items that are left are not run.
TEST(Watch, MayEndALoop)
{
  for (const int threads : { 1, 2, 8 })
  {
    std::atomic<std::size_t> runs{ 0 };
    const Execution execution = Watch(ExecuteOnThreads(threads),
      [](std::size_t done, std::size_t)
      {
        if (done > 0)
        {
          throw Stopped();
        }
      });
    const auto run = [&](std::size_t begin, std::size_t end)
    {
      runs += end - begin;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    EXPECT_THROW(execution.For(100000, run), Stopped);
    EXPECT_LT(runs.load(), 10000u);
  }
}

//----------------------------------------------------------------------------
TEST(ForInOrder, IsHeardOfOften)
{
  std::vector<std::size_t> items;
  std::size_t calls = 0, since = 0, longest = 0;
  const Execution execution = Watch(Execution(),
    [&](std::size_t done, std::size_t count)
    {
      EXPECT_EQ(count, 10000u);
      EXPECT_EQ(done, items.size());
      ++calls;
      since = 0;
    });
  ForInOrder(execution, 10000,
    [&](std::size_t item)
    {
      items.push_back(item);
      longest = std::max(longest, ++since);
    });
  ASSERT_EQ(items.size(), 10000u);
  EXPECT_TRUE(std::is_sorted(items.begin(), items.end()));
  EXPECT_LE(longest, 256u);
  EXPECT_GE(calls, 10000u / 256u);
}
