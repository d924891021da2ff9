// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/CoonsPatch.h"

#include "Core/Base/Vectors.h"
#include "Support/CheckPatch.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Builds the patch of a cycle around the centroid of its border.
struct CoonsPatch
{
  CoonsPatch(const Stages& stages, Index cycle, Index parts)
  {
    const SurfaceNormals normals = EstimateNormals(stages.Geometry(), 1.05, {}, Execution());
    this->Border.Set(stages.Geometry(), normals, cycle);
    this->Built =
      BuildCoonsPatch(stages.Grid, this->Border, this->Border.Center, parts, this->Patch);
  }

  Point3 At(Index corner) const
  {
    return corner >= 0 ? this->Border.Places[corner] : this->Patch.Points[-1 - corner];
  }
  double Area() const
  {
    double area = 0.0;
    for (const auto& t : this->Patch.Triangles)
    {
      area += 0.5 * Length(Cross(this->At(t[1]) - this->At(t[0]), this->At(t[2]) - this->At(t[0])));
    }
    return area;
  }

  PatchBorder Border;
  InnerPatch Patch;
  bool Built = false;
};

Index CycleIn(const Stages& stages, const std::array<Index, 3>& cell)
{
  const auto& cells = stages.Cycles.Cell;
  return static_cast<Index>(std::find(cells.begin(), cells.end(), cell) - cells.begin());
}

/// A triangle as a set of corners that does not depend on where it starts.
std::array<Index, 3> Turned(std::array<Index, 3> t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The cube's contours with vertices where no plane is.
std::string CubeWithVertices()
{
  std::string text;
  for (const char* plane : { "x=1:", "x=2:", "y=1:", "y=2:", "z=1:", "z=2:" })
  {
    text += std::string(plane) +
      " 0.5,0.5 1.3,0.5 1.8,0.5 2.5,0.5 2.5,1.4 2.5,2.5 1.9,2.5 1.2,2.5 0.5,2.5 0.5,1.6\n";
  }
  return text;
}
}

//----------------------------------------------------------------------------
TEST(CoonsPatch, OfOnePartIsTheFan)
{
  const Stages stages{ CubeWithVertices() };
  for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
  {
    const CoonsPatch patch(stages, cycle, 1);
    std::set<std::array<Index, 3>> fan, found;
    for (Index i = 0; i < patch.Border.Count(); ++i)
    {
      fan.insert(Turned({ -1, i, (i + 1) % patch.Border.Count() }));
    }
    for (const auto& t : patch.Patch.Triangles)
    {
      found.insert(Turned(t));
    }
    EXPECT_EQ(found, fan);
    EXPECT_EQ(patch.Patch.Triangles.size(), fan.size());
    ASSERT_EQ(patch.Patch.Points.size(), 1u);
  }
}

//----------------------------------------------------------------------------
TEST(CoonsPatch, FirstPointIsTheCentralOne)
{
  const Stages stages{ CubeWithVertices() };
  for (const Index parts : { 1, 2, 5 })
  {
    const CoonsPatch patch(stages, CycleIn(stages, { 0, 0, 0 }), parts);
    ASSERT_TRUE(patch.Built);
    EXPECT_LT(Length(patch.Patch.Points[0] - patch.Border.Center), 1e-12);
    EXPECT_EQ(patch.Patch.Normals.size(), patch.Patch.Points.size());
    // A point for each spoke and one for each inner corner of the meshes of three quadrilaterals.
    const auto inside = static_cast<std::size_t>(parts - 1);
    EXPECT_EQ(patch.Patch.Points.size(), 1 + 3 * inside + 3 * inside * inside);
  }
}

//----------------------------------------------------------------------------
TEST(CoonsPatch, IsADiscWithPointsInsideTheCell)
{
  Index built = 0, cycles = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Stages stages(
      seed % 2 == 0 ? RandomConsistentInput(seed) : RandomContradictoryInput(seed));
    for (Index cycle = 0; cycle < stages.Cycles.Count(); cycle += 3)
    {
      ++cycles;
      const CoonsPatch coons(stages, cycle, 1 + cycle % 4);
      if (coons.Built)
      {
        ++built;
        const PatchMesh mesh{ PatchKind::Joined, { cycle }, coons.Patch.Points,
          coons.Patch.Triangles };
        ASSERT_EQ(DescribePatchFlaws(stages.Geometry(), mesh), "") << seed << ", " << cycle;
        PatchView view;
        ASSERT_TRUE(view.Set(coons.Border));
        EXPECT_TRUE(view.SeesAll(coons.Patch));
      }
    }
  }
  EXPECT_GT(built, 0.5 * cycles);
}

//----------------------------------------------------------------------------
TEST(CoonsPatch, OfAPlanarPolygonStaysInItsPlaneAndCoversIt)
{
  for (const std::string& text : { Cube(), CubeWithVertices() })
  {
    const Stages stages{ text };
    for (const Index parts : { 1, 2, 3, 8 })
    {
      const CoonsPatch top(stages, CycleIn(stages, { 1, 1, 2 }), parts);
      ASSERT_TRUE(top.Built) << parts;
      for (const Point3& p : top.Patch.Points)
      {
        EXPECT_NEAR(p[2], 2.5, 1e-12);
      }
      EXPECT_NEAR(top.Area(), 1.0, 1e-12);
    }
  }
}

//----------------------------------------------------------------------------
/// Without vertices between the nodes of a square: a regular grid.
TEST(CoonsPatch, BlendsTheSidesBilinearly)
{
  const Stages stages("x=1: 0.5,0.5 1.5,0.5 2.5,0.5 2.5,1.5 2.5,2.5 1.5,2.5 0.5,2.5 0.5,1.5\n"
                      "x=2: 0.5,0.5 1.5,0.5 2.5,0.5 2.5,1.5 2.5,2.5 1.5,2.5 0.5,2.5 0.5,1.5\n"
                      "y=1: 0.5,0.5 1.5,0.5 2.5,0.5 2.5,1.5 2.5,2.5 1.5,2.5 0.5,2.5 0.5,1.5\n"
                      "y=2: 0.5,0.5 1.5,0.5 2.5,0.5 2.5,1.5 2.5,2.5 1.5,2.5 0.5,2.5 0.5,1.5\n"
                      "z=1: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5; z=2: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5");
  const CoonsPatch top(stages, CycleIn(stages, { 1, 1, 2 }), 2);
  ASSERT_TRUE(top.Built);
  std::set<std::pair<int, int>> places;
  for (const Point3& p : top.Patch.Points)
  {
    places.emplace(
      static_cast<int>(std::lround(4.0 * p[0])), static_cast<int>(std::lround(4.0 * p[1])));
    EXPECT_NEAR(4.0 * p[0], std::lround(4.0 * p[0]), 1e-12);
    EXPECT_NEAR(4.0 * p[1], std::lround(4.0 * p[1]), 1e-12);
  }
  std::set<std::pair<int, int>> expected;
  for (int i = 5; i < 8; ++i)
  {
    for (int j = 5; j < 8; ++j)
    {
      expected.emplace(i, j);
    }
  }
  EXPECT_EQ(places, expected);
}

//----------------------------------------------------------------------------
TEST(CoonsPatch, FoldedOnesAreNotBuilt)
{
  const Stages stages{ Cube() };
  const SurfaceNormals normals = EstimateNormals(stages.Geometry(), 1.05, {}, Execution());
  PatchBorder border;
  border.Set(stages.Geometry(), normals, CycleIn(stages, { 1, 1, 2 }));
  InnerPatch patch;
  EXPECT_TRUE(BuildCoonsPatch(stages.Grid, border, { 1.5, 1.5, 2.5 }, 3, patch));
  // The border the wrong way around.
  for (Point3& normal : border.Normals)
  {
    normal = -1.0 * normal;
  }
  EXPECT_FALSE(BuildCoonsPatch(stages.Grid, border, { 1.5, 1.5, 2.5 }, 3, patch));
}
