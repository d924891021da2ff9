// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the whole method on several threads, its progress, and how soon it stops
 */

#include "Core/Base/Workers.h"
#include "Core/Reconstruct.h"
#include "Core/StageShares.h"

#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
void ExpectSame(const Reconstruction& a, const Reconstruction& b)
{
  EXPECT_EQ(a.Graph.Points, b.Graph.Points);
  EXPECT_EQ(a.Surface.CentralPoints, b.Surface.CentralPoints);
  EXPECT_EQ(a.Surface.Inner.Points, b.Surface.Inner.Points);
  EXPECT_EQ(a.Surface.Inner.Corners, b.Surface.Inner.Corners);
  EXPECT_EQ(a.Surface.Improved.Points, b.Surface.Improved.Points);
  EXPECT_EQ(a.Normals.Normals, b.Normals.Normals);
  EXPECT_EQ(a.Repairs.size(), b.Repairs.size());
  EXPECT_EQ(MeshOf(a).Triangles, MeshOf(b).Triangles);
}

/// Circles around the origin on planes of each axis that is asked for, as text for ParsePieces.
std::string Ball(const std::string& axes, int planes, int vertices)
{
  constexpr double pi = 3.14159265358979323846;
  std::string text;
  for (const char axis : axes)
  {
    for (int i = 0; i < planes; ++i)
    {
      const double height = -0.97 + 1.94 * (i + 0.5) / planes;
      const double radius = std::sqrt(1.0 - height * height);
      text += std::string(1, axis) + "=" + std::to_string(height) + ":";
      for (int k = 0; k < vertices; ++k)
      {
        const double angle = 2.0 * pi * (k + 0.3) / vertices;
        text += " " + std::to_string(radius * std::cos(angle)) + "," +
          std::to_string(radius * std::sin(angle));
      }
      text += "; ";
    }
  }
  return text;
}

/// Progress as it is told, of a run that does not stop.
std::vector<double> ProgressOf(const std::string& text, const Options& options)
{
  std::vector<double> progress;
  Execution execution;
  execution.Continue = [&](double now)
  {
    progress.push_back(now);
    return true;
  };
  Reconstruct(ParsePieces(text), options, execution);
  return progress;
}
}

//----------------------------------------------------------------------------
TEST(Execution, ResultIsTheSameForAnyNumberOfThreads)
{
  const auto check = [](const Input& input)
  {
    SCOPED_TRACE(input.Name);
    const Reconstruction one =
      Reconstruct(PieceSets(input.Sets), input.Settings, ExecuteOnThreads(1));
    for (const int threads : { 2, 3, 8 })
    {
      ExpectSame(
        one, Reconstruct(PieceSets(input.Sets), input.Settings, ExecuteOnThreads(threads)));
    }
  };
  for (std::uint64_t seed = 0; seed < 12; ++seed)
  {
    check(RandomConsistentInput(seed));
    check(RandomContradictoryInput(seed));
    check(RandomSparseInput(seed));
  }
}

//----------------------------------------------------------------------------
TEST(Execution, FewTrianglesAreTheSameForAnyNumberOfThreads)
{
  Options options;
  options.Patching.OwnAccuracy = true;
  for (const std::string& text : { Ball("xyz", 9, 60), Ball("z", 9, 60), Ball("xz", 5, 40) })
  {
    const Reconstruction one = Reconstruct(ParsePieces(text), options, ExecuteOnThreads(1));
    for (const int threads : { 2, 3, 8 })
    {
      ExpectSame(one, Reconstruct(ParsePieces(text), options, ExecuteOnThreads(threads)));
    }
  }
}

//----------------------------------------------------------------------------
TEST(Execution, ProgressRisesToOneWhateverTheSlices)
{
  Options light;
  light.Patching.OwnAccuracy = true;
  for (const Options& options : { Options(), light })
  {
    for (const std::string& text :
      { Ball("xyz", 12, 60), Ball("xy", 12, 60), Ball("z", 12, 60), Ball("xyz", 3, 30) })
    {
      const std::vector<double> progress = ProgressOf(text, options);
      EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
      EXPECT_GE(progress.front(), 0.0);
      EXPECT_NEAR(progress.back(), 1.0, 1e-9);
    }
  }
}

//----------------------------------------------------------------------------
/// How often the caller is asked grows with the work.
TEST(Execution, AsksWhetherToGoOnInProportionToTheWork)
{
  const auto questions = [](int vertices)
  {
    std::size_t count = 0;
    Execution execution;
    execution.For = [](std::size_t items, const Execution::Range& run)
    {
      for (std::size_t i = 0; i < items; ++i)
      {
        run(i, i + 1);
      }
    };
    execution.Continue = [&](double)
    {
      ++count;
      return true;
    };
    Reconstruct(ParsePieces(Ball("xyz", 16, vertices)), Options(), execution);
    return static_cast<double>(count);
  };
  const double few = questions(100), many = questions(400);
  EXPECT_GT(few, 1000.0);
  EXPECT_GT(many, 1.5 * few);
}

//----------------------------------------------------------------------------
/// Progress goes on in small steps, and stops where the caller says so.
TEST(Execution, StopsAtAnyProgress)
{
  const std::string text = Ball("xyz", 24, 60);
  for (const double until : { 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9 })
  {
    Execution execution;
    execution.For = [](std::size_t items, const Execution::Range& run)
    {
      for (std::size_t i = 0; i < items; ++i)
      {
        run(i, i + 1);
      }
    };
    double progress = 0.0;
    execution.Continue = [&](double now)
    {
      progress = now;
      return now < until;
    };
    EXPECT_TRUE(Reconstruct(ParsePieces(text), Options(), execution).Stopped);
    EXPECT_GE(progress, until);
    EXPECT_LT(progress, until + 0.1);
  }
}

//----------------------------------------------------------------------------
TEST(Execution, StopsWithinLoops)
{
  const std::string text = Ball("xyz", 12, 60);
  const std::size_t all = ProgressOf(text, Options()).size();
  for (const int threads : { 1, 3 })
  {
    for (std::size_t stop = 1; stop < all; stop += 7)
    {
      std::size_t calls = 0;
      Execution execution = ExecuteOnThreads(threads);
      execution.Continue = [&](double) { return ++calls < stop; };
      EXPECT_TRUE(Reconstruct(ParsePieces(text), Options(), execution).Stopped);
      EXPECT_EQ(calls, stop) << "went on after it was asked to stop";
    }
  }
}

//----------------------------------------------------------------------------
TEST(Execution, StagesHaveWordsForTheUser)
{
  std::set<std::string> texts;
  for (int stage = 0; stage <= static_cast<int>(Stage::ImproveSurface); ++stage)
  {
    texts.insert(TextOf(static_cast<Stage>(stage)));
  }
  EXPECT_EQ(texts.size(), static_cast<std::size_t>(Stage::ImproveSurface) + 1);
  EXPECT_EQ(texts.count(""), 0u);
  std::vector<std::string> announced;
  Execution execution;
  execution.Announce = [&](const char* text) { announced.push_back(text); };
  Reconstruct(ParsePieces(Cube(3)), Options(), execution);
  EXPECT_GT(announced.size(), 10u);
  EXPECT_EQ(announced.back(), TextOf(Stage::ImproveSurface));
}

//----------------------------------------------------------------------------
TEST(StageShares, RiseToOne)
{
  Options light;
  light.Patching.Accuracy = 0.01;
  for (const Options& options : { Options(), light })
  {
    const StageShares shares(options, SpatialGrid());
    double last = 0.0;
    for (int stage = 0; stage <= static_cast<int>(Stage::ImproveSurface); ++stage)
    {
      EXPECT_GT(shares.EndOf(static_cast<Stage>(stage)), last);
      last = shares.EndOf(static_cast<Stage>(stage));
      EXPECT_NEAR(StageShares::LoopsOf(static_cast<Stage>(stage)).StartOf(8), 1.0, 1e-6);
    }
    EXPECT_DOUBLE_EQ(last, 1.0);
  }
}
