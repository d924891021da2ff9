// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellRegion.h"

#include "Core/Base/Vectors.h"

#include "Support/AnalyticSolids.h"
#include "Support/Random.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Even-odd rule.
bool IsWithin(const std::vector<Point2>& ring, const Point2& p)
{
  bool within = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const Point2& a = ring[i];
    const Point2& b = ring[(i + 1) % ring.size()];
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
      p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    {
      within = !within;
    }
  }
  return within;
}

/// Cells of a sliced solid, bounded by planes on all sides, and what the solid says of them.
class CellsOfSolid
{
public:
  CellsOfSolid(const Solid& solid, const Stages& stages)
    : Solid_(solid)
    , Tables(stages)
    , Geometry(stages.Geometry())
  {
  }

  void Check()
  {
    const CellGroups groups = GroupByCell(this->Tables.Grid, this->Tables.Cycles, Execution());
    for (std::size_t i = 0; i < groups.Cycles.size();)
    {
      std::size_t end = i;
      while (end < groups.Cycles.size() && this->CellOf(groups, end) == this->CellOf(groups, i))
      {
        ++end;
      }
      if (this->IsBounded(this->CellOf(groups, i)))
      {
        this->CheckCell(groups.Cycles.data() + i, groups.Cycles.data() + end);
      }
      i = end;
    }
  }

  int Points = 0, Single = 0, Several = 0;

private:
  const std::array<Index, 3>& CellOf(const CellGroups& groups, std::size_t i) const
  {
    return this->Tables.Cycles.Cell[groups.Cycles[i]];
  }
  bool IsBounded(const std::array<Index, 3>& cell) const
  {
    bool bounded = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      bounded = bounded && cell[axis] > 0 && cell[axis] < this->Tables.Grid.Count(axis);
    }
    return bounded;
  }
  bool IsInside(const Point3& p) const { return this->Solid_.Value(p) < 0.0; }

  std::vector<std::vector<Point2>> RingsOn(
    const CellRegions& regions, const CellRegion& region, int face) const
  {
    const std::array<int, 2> axes = AxesOfFace(face);
    std::vector<std::vector<Point2>> rings;
    for (const std::vector<Index>& ring : regions.RingsOn(region, face))
    {
      rings.emplace_back();
      for (const Index vertex : ring)
      {
        const Point3 p = vertex >= 0 ? this->Geometry.Graph.PointAt(region.Border[vertex])
                                     : regions.Corner(-1 - vertex);
        rings.back().push_back({ p[axes[0]], p[axes[1]] });
      }
    }
    return rings;
  }

  /// From corner 0 to anywhere on the boundary of the cell one passes from the solid to the outside
  /// or back as often as from one region to another.
  void CheckCell(const Index* first, const Index* last)
  {
    CellRegions regions(this->Geometry);
    const std::vector<CellRegion> all = regions.Find(first, last);
    (last - first > 1 ? this->Several : this->Single) += 1;
    const bool atStart = this->IsInside(regions.Corner(0));
    for (int corner = 0; corner < 8; ++corner)
    {
      bool odd = false;
      for (const CellRegion& region : all)
      {
        odd ^= region.Corners[corner];
      }
      EXPECT_EQ(odd, this->IsInside(regions.Corner(corner)) != atStart);
    }
    for (int face = 0; face < 6; ++face)
    {
      this->CheckFace(regions, all, face, atStart);
    }
  }

  void CheckFace(
    const CellRegions& regions, const std::vector<CellRegion>& all, int face, bool atStart)
  {
    const std::array<int, 2> axes = AxesOfFace(face);
    const Point3 low = regions.LowCorner(), high = regions.HighCorner();
    std::vector<std::vector<std::vector<Point2>>> rings;
    for (const CellRegion& region : all)
    {
      rings.push_back(this->RingsOn(regions, region, face));
    }
    for (int run = 0; run < 10; ++run)
    {
      Point3 p = face % 2 == 1 ? high : low;
      for (const int axis : axes)
      {
        p[axis] = this->Numbers.Uniform(low[axis], high[axis]);
      }
      if (std::abs(this->Solid_.Value(p)) < 0.02)
      {
        continue; // the contours are polygons
      }
      bool odd = false;
      for (const auto& ofRegion : rings)
      {
        for (const std::vector<Point2>& ring : ofRegion)
        {
          odd ^= IsWithin(ring, { p[axes[0]], p[axes[1]] });
        }
      }
      EXPECT_EQ(odd, this->IsInside(p) != atStart) << "face " << face;
      ++this->Points;
    }
  }

  const Solid& Solid_;
  const Stages& Tables;
  CycleGeometry Geometry;
  Random Numbers{ 31 };
};
}

//----------------------------------------------------------------------------
/// The regions of a cell's cycles together are where the solid is, or is not, on its boundary.
TEST(CellRegion, RegionsTogetherAreWhatTheSolidIs)
{
  int points = 0, single = 0, several = 0;
  for (const Solid& solid : { TiltedTorus(), BranchingTube(), HollowBall(), LinkedTori() })
  {
    SCOPED_TRACE(solid.Name);
    Input input;
    input.Sets = SliceSolid(solid, EqualPlanes(solid, { 6, 7, 8 }), 16, InPlaneGrid::Aligned);
    input.Settings.Orient = Orientation::AsDrawn;
    const Stages stages(input);
    CellsOfSolid cells(solid, stages);
    cells.Check();
    points += cells.Points;
    single += cells.Single;
    several += cells.Several;
  }
  EXPECT_GT(points, 3000);
  EXPECT_GT(single, 50);
  EXPECT_GT(several, 5);
}

//----------------------------------------------------------------------------
/// A face of a cell is seen from outside: its axes and its outward normal are right-handed.
TEST(CellRegion, AxesOfFacesAreRightHanded)
{
  for (int face = 0; face < 6; ++face)
  {
    const std::array<int, 2> axes = AxesOfFace(face);
    Point3 u{}, v{}, normal{};
    u[axes[0]] = v[axes[1]] = 1.0;
    normal[face / 2] = face % 2 == 1 ? 1.0 : -1.0;
    EXPECT_EQ(Cross(u, v), normal);
  }
}

//----------------------------------------------------------------------------
/// Flipping a region twice, or taking a cycle's region from itself twice, changes nothing.
TEST(CellRegion, FlipIsTheOtherSide)
{
  const Stages stages(Cube());
  const CycleGeometry geometry = stages.Geometry();
  CellRegions regions(geometry);
  for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
  {
    const CellRegion region = regions.Find(&cycle, &cycle + 1).front();
    CellRegion flipped = region;
    CellRegions::Flip(flipped);
    EXPECT_NE(flipped.IsLeft(), region.IsLeft());
    for (int corner = 0; corner < 8; ++corner)
    {
      EXPECT_NE(flipped.Corners[corner], region.Corners[corner]);
    }
    CellRegions::Flip(flipped);
    EXPECT_EQ(flipped.IsLeft(), region.IsLeft());
    EXPECT_EQ(flipped.Corners, region.Corners);
  }
}
