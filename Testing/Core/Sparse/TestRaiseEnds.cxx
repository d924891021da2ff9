// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RaiseEnds.h"

#include "Core/Reconstruct.h"
#include "Core/Sparse/SurfaceMesh.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A stack of three squares with sides of 2, a spacing of 1 apart up to z = 2.
const std::string Squares = "z=0: -1,-1 1,-1 1,1 -1,1; z=1: -1,-1 1,-1 1,1 -1,1; "
                            "z=2: -1,-1 1,-1 1,1 -1,1";

/// The surface of a stack, contours across it, and the mesh that they make of its ends.
struct GuidedStack
{
  /// `across` are the points of a contour on x = 0.
  explicit GuidedStack(const std::string& across, const std::string& stack = Squares)
  {
    Options options;
    options.Virtual = VirtualSlices::Off;
    this->Stack = Reconstruct(ParsePieces(stack), options, Execution());
    Contours contours = ParseContours(stack + (across.empty() ? "" : "; x=0: " + across));
    this->Guides = CutGuides(contours, BuildSpatialGrid(contours, 1e-9), 2);
    this->Ends = FindLoopEnds(this->Stack.Graph, this->Guides);
  }

  /// Of the first loop on a plane.
  const LoopEnd& EndOf(Index plane, Index side) const
  {
    const auto& loops = this->Stack.Graph.Loops;
    const auto at = std::find_if(
      loops.begin(), loops.end(), [&](const Face& loop) { return loop.Plane == plane; });
    return this->Ends[2 * (at - loops.begin()) + side];
  }

  SurfaceMesh MakeMesh()
  {
    return MakeSurfaceMesh(GeometryOf(this->Stack), this->Stack.Surface, this->Guides, Execution());
  }

  Reconstruction Stack;
  GuideCurves Guides;
  std::vector<LoopEnd> Ends;
};

double Highest(const SurfaceMesh& mesh)
{
  double high = -1e9;
  for (Index point = 0; point < mesh.Corners.PointCount(); ++point)
  {
    high = mesh.Corners.IsUsed(point) ? std::max(high, mesh.Points[point][2]) : high;
  }
  return high;
}

double VolumeOf(const SurfaceMesh& mesh)
{
  double volume = 0.0;
  for (const auto& t : mesh.Corners.ListTriangles())
  {
    volume += Dot(mesh.Points[t[0]], Cross(mesh.Points[t[1]], mesh.Points[t[2]])) / 6.0;
  }
  return volume;
}
}

//----------------------------------------------------------------------------
TEST(FindLoopEnds, GuidesShowHowTheObjectEnds)
{
  const GuidedStack rim("-1,0 1,0 1,2.4 -1,2.4");
  EXPECT_EQ(rim.EndOf(0, 0).Kind, EndKind::Flat);
  EXPECT_EQ(rim.EndOf(2, 1).Kind, EndKind::Rim);
  EXPECT_EQ(rim.EndOf(2, 0).Kind, EndKind::Unknown); // goes on to the slice below
  ASSERT_EQ(rim.EndOf(2, 1).Anchors.size(), 2u);
  for (const RimAnchor& anchor : rim.EndOf(2, 1).Anchors)
  {
    EXPECT_NEAR(anchor.Upwards, 0.4, 1e-12);
    EXPECT_NEAR(anchor.Outwards, 0.0, 1e-12);
  }
  const GuidedStack roof("-1,-0.3 1,-0.3 1,2 0,2.4 -1,2");
  EXPECT_EQ(roof.EndOf(0, 0).Kind, EndKind::Rim);
  EXPECT_EQ(roof.EndOf(2, 1).Kind, EndKind::Dome);
  EXPECT_NEAR(roof.EndOf(2, 1).Height, 0.4, 1e-12);
  const GuidedStack none("");
  EXPECT_EQ(none.EndOf(2, 1).Kind, EndKind::Unknown);
}

//----------------------------------------------------------------------------
/// Rounding says nothing: a fiftieth of the spacing before and behind the slice.
TEST(FindLoopEnds, EndsAreFlatButForRounding)
{
  for (const std::string top : { "1.985", "2", "2.015" })
  {
    EXPECT_EQ(GuidedStack("-1,0 1,0 1," + top + " -1," + top).EndOf(2, 1).Kind, EndKind::Flat)
      << top;
  }
  EXPECT_EQ(GuidedStack("-1,0 1,0 1,2.05 -1,2.05").EndOf(2, 1).Kind, EndKind::Rim);
}

//----------------------------------------------------------------------------
/// Walls go on as they do along the guides, around the whole of the loop: here they spread.
TEST(RaiseEnds, PatchesMoveOutToTheirRim)
{
  GuidedStack stack("-1,0 1,0 1,2 1.1,2.4 -1.1,2.4 -1,2");
  const SurfaceMesh mesh = stack.MakeMesh();
  EXPECT_NEAR(Highest(mesh), 2.4, 1e-12);
  // A prism, whose flat base lies CentralPointMargin beyond its slice in the middle, and the
  // frustum of a pyramid on it.
  EXPECT_NEAR(VolumeOf(mesh), 8.0 + 0.4 / 3.0 * (4.0 + 4.84 + std::sqrt(4.0 * 4.84)), 2e-3);
  Index onRim = 0;
  for (Index point = 0; point < mesh.Corners.PointCount(); ++point)
  {
    if (mesh.Fixed[point] && std::abs(mesh.Points[point][2] - 2.4) < 1e-9)
    {
      ++onRim;
      EXPECT_EQ(mesh.Crease[point], 1);
      EXPECT_NEAR(
        std::max(std::abs(mesh.Points[point][0]), std::abs(mesh.Points[point][1])), 1.1, 1e-9);
    }
    else if (std::abs(mesh.Points[point][2] - 2.0) < 1e-9)
    {
      EXPECT_EQ(mesh.Crease[point], 0); // the wall goes on
    }
  }
  EXPECT_GE(onRim, 4);
}

//----------------------------------------------------------------------------
/// An end in which the stack alone would put a dome; CentralPointMargin of the spacing is left.
TEST(RaiseEnds, FlatEndsLieInTheirSlice)
{
  const std::string shrinking = "z=0: -1,-1 1,-1 1,1 -1,1; z=1: -1,-1 1,-1 1,1 -1,1; "
                                "z=2: -0.8,-0.8 0.8,-0.8 0.8,0.8 -0.8,0.8";
  EXPECT_GT(Highest(GuidedStack("", shrinking).MakeMesh()), 2.1);
  EXPECT_NEAR(
    Highest(GuidedStack("-1,0 1,0 1,1 0.8,2 -0.8,2 -1,1", shrinking).MakeMesh()), 2.0, 1.01e-3);
}

//----------------------------------------------------------------------------
/// Of two towers a guide meets one: the other one ends as far beyond its slice.
TEST(RaiseEnds, FlatEndsWithoutGuidesLieAsFarOutAsOthers)
{
  std::string towers;
  for (const std::string z : { "0", "1", "2" })
  {
    towers +=
      "z=" + z + ": -1,-1 1,-1 1,1 -1,1; z=" + z + ": 2,-1 4,-1 4,1 2,1" + (z == "2" ? "" : "; ");
  }
  GuidedStack stack("-1,-0.2 1,-0.2 1,2.4 -1,2.4", towers);
  EXPECT_NEAR(VolumeOf(stack.MakeMesh()), 2.0 * 4.0 * 2.6, 1e-6);
}
