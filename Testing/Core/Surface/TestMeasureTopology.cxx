// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/MeasureTopology.h"

#include "Support/CheckSurface.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
TEST(MeasureTopology, OfFansCountsComponentsByTheirLeastNode)
{
  const Stages stages(Octahedron() +
    "; x=10: 9,9 11,9 11,11 9,11; y=10: 9,9 11,9 11,11 9,11; z=10: 9,9 11,9 11,11 9,11");
  const SurfaceComponents components = MeasureTopology(stages.Geometry(), {});
  EXPECT_EQ(components.Topology.Components, 2);
  EXPECT_EQ(components.Topology.Genus, 0);
  EXPECT_EQ(components.OfPart.size(), 12u);
  EXPECT_EQ(components.OfPart.front(), 0);
}

//----------------------------------------------------------------------------
TEST(MeasureTopology, IsThatOfTheTriangles)
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const Input input = RandomSparseInput(seed);
    const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
    if (result.Refused)
    {
      continue;
    }
    const SurfaceCheck check = CheckSurface(MeshOf(result));
    EXPECT_EQ(result.Topology.Components, check.Components);
    EXPECT_EQ(result.Topology.Genus, check.TotalGenus());
  }
}
