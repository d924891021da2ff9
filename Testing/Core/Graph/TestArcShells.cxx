// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/ArcShells.h"

#include "Core/Graph/CheckGraph.h"
#include "Support/RandomInput.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Draws the arcs of all faces anew.
void DrawAll(Stages& stages)
{
  const ArcGeometry geometry{ stages.Grid, stages.Nodes, stages.Crossings, stages.Graph };
  const ArcsByFace faces = GroupArcsByFace(stages.Grid, stages.Crossings, Execution());
  std::vector<FaceDrawing> drawings;
  for (Index i = 0; i < faces.Count(); ++i)
  {
    drawings.push_back(DrawArcShells(geometry, faces[i]));
  }
  ReplaceArcs(drawings, stages.Crossings, stages.Graph);
}
}

//----------------------------------------------------------------------------
TEST(ArcShells, LookAtTheGraphOnly)
{
  const Stages stages{ Cube(3) };
  const ArcGeometry geometry{ stages.Grid, stages.Nodes, stages.Crossings, stages.Graph };
  const ArcsByFace faces = GroupArcsByFace(stages.Grid, stages.Crossings, Execution());
  const FaceDrawing drawing = DrawArcShells(geometry, faces[0]);
  EXPECT_EQ(static_cast<Index>(drawing.Arcs.size()), faces[0].Count());
  EXPECT_TRUE(drawing.Joins.empty()); // arcs that do not interlock end where they did
}

//----------------------------------------------------------------------------
TEST(ArcShells, AreEmbeddedWhateverTheArcsLookedLike)
{
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE(seed);
    Stages stages(RandomContradictoryInput(seed));
    DrawAll(stages);
    EXPECT_EQ(CheckFourArcs(stages.Crossings, stages.Nodes, stages.Graph), "");
    EXPECT_EQ(CheckEmbedding(stages.Grid, stages.Crossings, stages.Nodes, stages.Graph), "");
  }
}
