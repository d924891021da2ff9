// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/PatchAllCells.h"

#include "Core/Reconstruct.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Corners = std::array<Point3, 3>;

/// All triangles, each from its least corner on, in ascending order.
std::vector<Corners> TrianglesOf(const Reconstruction& result)
{
  const TriangleMesh mesh = MeshOf(result);
  std::vector<Corners> triangles;
  for (const auto& ids : mesh.Triangles)
  {
    Corners corners{ mesh.Points[ids[0]], mesh.Points[ids[1]], mesh.Points[ids[2]] };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Circles on z-slices, each shifted a little against the one below, so that they cross in
/// projection.
std::string ShiftedCircles(int slices)
{
  std::string text;
  for (int slice = 0; slice < slices; ++slice)
  {
    text += "z=" + std::to_string(slice) + ":";
    for (int i = 0; i < 24; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * (i + 0.1) / 24;
      text += " " + std::to_string(0.4 * slice + 3.0 * std::cos(angle)) + "," +
        std::to_string(0.15 * slice + 3.0 * std::sin(angle));
    }
    text += "\n";
  }
  return text;
}

void ExpectAsIfNeverThere(const std::string& rest, const std::string& speck)
{
  Options options;
  options.MinComponent = 0.05;
  const Reconstruction with = Reconstruct(ParsePieces(rest + speck), options, Execution());
  const Reconstruction without = Reconstruct(ParsePieces(rest), options, Execution());
  EXPECT_EQ(with.SmallComponents, 1);
  EXPECT_EQ(without.SmallComponents, 0);
  EXPECT_EQ(with.Graph.Points.size(), without.Graph.Points.size());
  EXPECT_EQ(TrianglesOf(with), TrianglesOf(without));
}
}

//----------------------------------------------------------------------------
TEST(PatchAllCells, ASpeckThatIsLeftOutLeavesAStackAsIfItHadNeverBeenThere)
{
  // So far away that no evidence joins it with the rest.
  ExpectAsIfNeverThere(ShiftedCircles(6), "z=3: 20,0 20.1,0 20.1,0.1\n");
}

//----------------------------------------------------------------------------
TEST(PatchAllCells, ASpeckWithNodePointsLeavesTheRestAsIfItHadNeverBeenThere)
{
  // A tiny octahedron at a corner of the grid, outside the large solid but within its slices.
  const std::string rest = "x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1;"
                           "z=0: -1,-1 1,-1 1,1 -1,1; x=3: 2,2 4,2 4,4 2,4;"
                           "y=3: 2,2 4,2 4,4 2,4; z=3: 2,2 4,2 4,4 2,4\n";
  ExpectAsIfNeverThere(rest,
    "x=3: -0.01,-0.01 0.01,-0.01 0.01,0.01 -0.01,0.01\n"
    "y=0: -0.01,2.99 0.01,2.99 0.01,3.01 -0.01,3.01\n"
    "z=0: 2.99,-0.01 3.01,-0.01 3.01,0.01 2.99,0.01\n");
}
