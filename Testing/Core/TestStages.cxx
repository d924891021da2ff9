// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what holds after every stage, and what the order of the stages is
 */

#include "Core/CheckInvariants.h"
#include "Core/Reconstruct.h"
#include "Support/CheckSurface.h"
#include "Support/Perturbations.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
void ExpectInvariants(const Input& input)
{
  SCOPED_TRACE(input.Name);
  Reconstruct(PieceSets(input.Sets), input.Settings, Execution(),
    [](Stage stage, const StageTables& tables, const Reconstruction& result)
    { ASSERT_EQ(CheckInvariants(stage, tables, result), ""); });
}
}

//----------------------------------------------------------------------------
TEST(Stages, ComeInTheOrderOfTheirList)
{
  Options options;
  options.ContourTolerance = 0.01;
  int last = -1;
  std::set<std::string> names;
  Reconstruct(ParsePieces(Cube(3) + "z=1: 1.2,1.2 1.5,1.2 1.5,1.5"), options, Execution(),
    [&](Stage stage, const StageTables&, const Reconstruction&)
    {
      EXPECT_GT(static_cast<int>(stage), last);
      last = static_cast<int>(stage);
      names.insert(NameOf(stage));
    });
  EXPECT_EQ(last, static_cast<int>(Stage::ImproveSurface));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(last) + 1);
  EXPECT_EQ(names.count(""), 0u);
}

//----------------------------------------------------------------------------
TEST(Invariants, HoldForConsistentInput)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    ExpectInvariants(RandomConsistentInput(seed));
  }
}

//----------------------------------------------------------------------------
TEST(Invariants, HoldForContradictoryInput)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    ExpectInvariants(RandomContradictoryInput(seed));
  }
}

//----------------------------------------------------------------------------
TEST(Invariants, HoldForSparseInput)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    ExpectInvariants(RandomSparseInput(seed));
  }
}

//----------------------------------------------------------------------------
TEST(Invariants, HoldWhereCellsAreTooNarrowForThePrecision)
{
  // Far from the origin, floats are so far apart that cells have to be patched again.
  int patchedAgain = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    Input input = seed % 2 == 0 ? RandomConsistentInput(seed) : RandomContradictoryInput(seed);
    SCOPED_TRACE(input.Name);
    Translate(input.Sets, { 3e5, 3e5, 3e5 });
    RoundToFloat(input.Sets);
    input.Settings.SinglePrecision = true;
    int embeddings = 0;
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution(),
      [&](Stage stage, const StageTables& tables, const Reconstruction& state)
      {
        embeddings += stage == Stage::EmbedArcs ? 1 : 0;
        ASSERT_EQ(CheckInvariants(stage, tables, state), "");
      });
    patchedAgain += embeddings > 1 ? 1 : 0;
    if (!result.Refused)
    {
      EXPECT_TRUE(CheckSurface(MeshOf(result)).IsClosedManifold());
    }
  }
  EXPECT_GT(patchedAgain, 10);
}

//----------------------------------------------------------------------------
TEST(Invariants, SayWhichStageBrokeThem)
{
  const Stages stages{ Cube() };
  Reconstruction result;
  result.Grid = stages.Grid;
  result.Crossings = stages.Crossings;
  result.Nodes = stages.Nodes;
  std::swap(result.Nodes.First[0], result.Nodes.First[1]);
  const std::string wrong = CheckInvariants(Stage::PairNodePoints, StageTables(), result);
  EXPECT_EQ(wrong.find("After PairNodePoints: "), 0u) << wrong;
}
