// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Graph/FaceArcs.h"

#include "Support/RandomInput.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(FaceArcs, EveryArcIsOnOneFaceThatContainsIt)
{
  for (std::uint64_t seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    const Stages stages(RandomContradictoryInput(seed));
    const ArcsByFace faces = GroupArcsByFace(stages.Grid, stages.Crossings, Execution());
    std::set<Index> seen;
    for (Index i = 0; i < faces.Count(); ++i)
    {
      const FaceArcs face = faces[i];
      EXPECT_GT(face.Count(), 0);
      for (const Index arc : face)
      {
        EXPECT_TRUE(seen.insert(arc).second);
        for (Index k = 0; k < stages.Graph.PointCount(arc); ++k)
        {
          const Point3 p = stages.Graph.PointAt(stages.Graph.FirstPoint(arc) + k);
          EXPECT_EQ(p[face.Face.Axis], stages.Grid.Planes[face.Face.Axis][face.Face.Plane]);
          EXPECT_TRUE(stages.Grid.IsInside(
            FirstAxis(face.Face.Axis), face.Face.Slab[0], p[FirstAxis(face.Face.Axis)]));
          EXPECT_TRUE(stages.Grid.IsInside(
            SecondAxis(face.Face.Axis), face.Face.Slab[1], p[SecondAxis(face.Face.Axis)]));
        }
      }
    }
    Index arcs = 0;
    for (Index arc = 0; arc < stages.Crossings.Count(); ++arc)
    {
      arcs += stages.Crossings.IsRemoved(arc) ? 0 : 1;
    }
    EXPECT_EQ(static_cast<Index>(seen.size()), arcs);
  }
}
