// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/BorderHeading.h"

#include "Core/Base/Vectors.h"
#include "Core/Reconstruct.h"
#include "Support/CheckSurface.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SparseSolids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Two half circles of this radius at x > 0 on the planes z = 0 and z = 1, left towards each other:
/// the long sides of half a cylinder.
std::vector<Heading> HalfCylinder(double radius)
{
  constexpr int count = 16;
  std::vector<Heading> headings;
  for (const double z : { 0.0, 1.0 })
  {
    for (int i = 0; i < count; ++i)
    {
      const double angle = 3.14159265358979323846 * ((i + 0.5) / count - 0.5);
      const Point3 out{ std::cos(angle), std::sin(angle), 0.0 };
      headings.push_back(
        { { radius * out[0], radius * out[1], z }, { 0.0, 0.0, 1.0 - 2.0 * z }, out, 0.5 / count });
    }
  }
  return headings;
}

/// A circle of radius 1 at height z, left upwards or downwards: an end of a tube.
std::vector<Heading> EndOfTube(double z, double up)
{
  constexpr int count = 32;
  std::vector<Heading> headings;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    const Point3 out{ std::cos(angle), std::sin(angle), 0.0 };
    headings.push_back({ { out[0], out[1], z }, { 0.0, 0.0, up }, out, 1.0 / count });
  }
  return headings;
}

struct Case
{
  Solid Shape;
  std::array<int, 3> Count;
  std::array<double, 3> Offset;
};
}

//----------------------------------------------------------------------------
TEST(BorderHeading, SheetsGoStraightAcrossThemselves)
{
  const std::vector<Heading> outer = HalfCylinder(10.0), inner = HalfCylinder(9.8);
  EXPECT_NEAR(TurnAcross(outer), 0.0, 1e-7);
  EXPECT_NEAR(TurnAcross(inner), 0.0, 1e-7);
  EXPECT_NEAR(TurnBetween(outer, inner), 1.0, 1e-7);
}

TEST(BorderHeading, EndsOfATubeGoStraightToEachOther)
{
  const std::vector<Heading> low = EndOfTube(0.0, 1.0), high = EndOfTube(3.0, -1.0);
  EXPECT_NEAR(TurnAcross(low), 1.0, 1e-7);
  EXPECT_NEAR(TurnBetween(low, high), 0.0, 1e-7);
}

/// Directions are unit vectors at right angles to the normals, and lead into the cell.
TEST(BorderHeading, LeadIntoTheCellAlongTheSurface)
{
  const Solid solid = Pipe(0.5);
  const PlaneSets planes = FewPlanes(solid, { 1, 0, 5 }, {});
  std::size_t checked = 0;
  Reconstruct(SliceSolid(solid, planes, { 24, 24, 12 }, InPlaneGrid::Aligned), Options(),
    Execution(),
    [&](Stage stage, const StageTables& tables, const Reconstruction& result)
    {
      if (stage != Stage::FindJoins)
      {
        return;
      }
      const CycleGeometry geometry = GeometryOf(result);
      for (Index cycle = 0; cycle < result.Cycles.Count(); ++cycle)
      {
        double total = 0.0;
        for (const Heading& heading : FindHeadings(geometry, tables.NodeNormals, cycle))
        {
          EXPECT_NEAR(Length(heading.Direction), 1.0, 1e-9);
          EXPECT_NEAR(Dot(heading.Direction, heading.Normal), 0.0, 1e-9);
          const auto& cell = result.Cycles.Cell[cycle];
          for (int axis = 0; axis < 3; ++axis)
          {
            const double place = heading.Place[axis] + 1e-3 * heading.Direction[axis];
            double low, high;
            result.Grid.GetExtent(axis, cell[axis], -2.0, 2.0, low, high);
            EXPECT_GE(place, low - 1e-9);
            EXPECT_LE(place, high + 1e-9);
          }
          total += heading.Weight;
          ++checked;
        }
        EXPECT_NEAR(total, 1.0, 1e-9);
      }
    });
  EXPECT_GT(checked, 100u);
}

//----------------------------------------------------------------------------
/// Walls, cavities and rings with the topology that they have, from a stack with one or two slices
/// across it, two families, and few planes.
TEST(FewPlanesTopology, OfSolidsWithWalls)
{
  const std::array<double, 3> none{};
  std::vector<Case> cases;
  for (const double wall : { 0.5, 0.2, 0.08 })
  {
    for (const int stack : { 5, 12, 24 })
    {
      for (const auto make : { Pipe, BallWithCavity, OpenShell, Beaker })
      {
        cases.push_back({ make(wall), { 1, 0, stack }, none });
        cases.push_back({ make(wall), { 1, 1, stack }, none });
      }
      cases.push_back({ Pipe(wall), { 1, 0, stack }, { 0.13, 0.0, 0.01 } });
      cases.push_back({ Beaker(wall), { 1, 1, stack }, { 0.13, -0.09, 0.01 } });
    }
    cases.push_back({ Pipe(wall), { 6, 0, 6 }, none });
    cases.push_back({ Beaker(wall), { 6, 0, 6 }, none });
    cases.push_back({ OpenShell(wall), { 3, 2, 2 }, none });
    cases.push_back({ Pipe(wall), { 1, 1, 1 }, none });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    cases.push_back({ TorusAround(axis, 0.3), { 1, 0, 12 }, none });
    cases.push_back({ TwoBalls(axis, 0.3), { 1, 1, 12 }, none });
  }
  for (const Case& each : cases)
  {
    std::array<int, 3> parts{};
    for (int axis = 0; axis < 3; ++axis)
    {
      parts[axis] = std::max(6, 48 / std::max(1, each.Count[axis]));
    }
    const Reconstruction result =
      Reconstruct(SliceSolid(each.Shape, FewPlanes(each.Shape, each.Count, each.Offset), parts,
                    InPlaneGrid::Aligned),
        Options(), Execution());
    const SurfaceCheck check = CheckSurface(MeshOf(result));
    const std::string name = each.Shape.Name + " " + std::to_string(each.Count[0]) + "," +
      std::to_string(each.Count[1]) + "," + std::to_string(each.Count[2]);
    ASSERT_TRUE(check.IsClosedManifold()) << name;
    EXPECT_EQ(check.Components, each.Shape.Components) << name;
    EXPECT_EQ(check.TotalGenus(), each.Shape.Genus) << name;
  }
}
