// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

using namespace orthoslices;
using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{
/// Right by overlap, cylinders, spanning tree, Reeb graph, orthogonal slices.
using Pattern = std::array<bool, 5>;

Pattern PatternOf(const Evidence& evidence)
{
  Pattern pattern;
  for (std::size_t i = 0; i < 4; ++i)
  {
    pattern[i] = evidence.Verdicts[i].Right;
  }
  pattern[4] = evidence.OrthogonalRight;
  return pattern;
}

/// Every object of a family shows the pattern of the paper's Figure 1.
void CheckFamily(char family, const Pattern& expected, void (*check)(const Evidence&))
{
  std::size_t count = 0;
  for (const InclinedSolid& object : FigureOneSolids())
  {
    if (object.Family == family)
    {
      ++count;
      const Evidence evidence = Judge(object);
      std::ostringstream message;
      PrintEvidence({ evidence }, message);
      EXPECT_EQ(PatternOf(evidence), expected) << message.str();
      check(evidence);
    }
  }
  EXPECT_GE(count, 6u);
}

/// So inclined that nothing overlaps its neighbours.
void IsInclined(const Evidence& evidence)
{
  EXPECT_TRUE(evidence.Verdicts[0].Pairs.empty()) << evidence.Object.Shape.Name;
}
}

//----------------------------------------------------------------------------
TEST(Evidence, FamilyAFailsOverlapOnly)
{
  CheckFamily('A', { false, true, true, true, true }, IsInclined);
}

//----------------------------------------------------------------------------
TEST(Evidence, FamilyBFailsOverlapAndCylinders)
{
  CheckFamily('B', { false, false, true, true, true }, IsInclined);
}

//----------------------------------------------------------------------------
TEST(Evidence, FamilyCFailsOverlapAndSpanningTree)
{
  CheckFamily('C', { false, true, false, true, true },
    [](const Evidence& evidence)
    {
      IsInclined(evidence);
      EXPECT_GE(evidence.Object.Shape.Genus, 1);
    });
}

//----------------------------------------------------------------------------
TEST(Evidence, FamilyDFailsAllButOrthogonalSlices)
{
  CheckFamily('D', { false, false, false, false, true },
    [](const Evidence& evidence) { EXPECT_GE(CountTurns(evidence.Truth, evidence.Stack), 1); });
}

//----------------------------------------------------------------------------
TEST(Evidence, SpiralsFailAllButOrthogonalSlices)
{
  for (const InclinedSolid& object : FigureTwoSolids())
  {
    const Evidence evidence = Judge(object);
    EXPECT_EQ(PatternOf(evidence), (Pattern{ false, false, false, false, true }))
      << object.Shape.Name;
    EXPECT_GE(CountTurns(evidence.Truth, evidence.Stack), 1) << object.Shape.Name;
  }
}

//----------------------------------------------------------------------------
// What the pattern does not say, so that it is not taken for more than it is.
TEST(Evidence, Exceptions)
{
  const std::map<std::string, Pattern> expected{ { "two close tubes",
                                                   { false, true, false, true, true } },
    { "fork with oval sections", { false, true, true, true, true } },
    { "arch on legs apart", { false, false, false, true, true } },
    { "inclined arch on legs apart", { false, false, false, true, true } } };
  for (const InclinedSolid& object : Exceptions())
  {
    ASSERT_EQ(expected.count(object.Shape.Name), 1u) << object.Shape.Name;
    EXPECT_EQ(PatternOf(Judge(object)), expected.at(object.Shape.Name)) << object.Shape.Name;
  }
}

//----------------------------------------------------------------------------
// Figure 8: sizes from 2 to 10 occurred in the authors' data, too.
TEST(Evidence, NearlyAllPolygonsHaveTwoToTenNodePoints)
{
  for (const int planes : { 16, 32 })
  {
    const std::map<Index, std::int64_t> counts = CountPolygonSizes(planes);
    std::int64_t total = 0, usual = 0;
    for (const auto& [size, count] : counts)
    {
      total += count;
      usual += size >= 2 && size <= 10 ? count : 0;
    }
    EXPECT_GE(counts.begin()->first, 2);
    EXPECT_GT(usual, 0.999 * total);
    const auto maximum = std::max_element(counts.begin(), counts.end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    EXPECT_EQ(maximum->first, 4);
  }
}
