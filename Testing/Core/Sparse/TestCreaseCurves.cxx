// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/CreaseCurves.h"

#include "Core/Reconstruct.h"
#include "Core/Sparse/ContourCorners.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SparseSolids.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A square pyramid without its top, from z = 0 to 8: `HalfWidth` is half its width,
/// and `Middle` the place of its axis along x.
struct Frustum
{
  double Slope, Shift;

  double HalfWidth(double z) const { return 5.0 - this->Slope * z; }
  double Middle(double z) const { return this->Shift * z; }

  /// Squares on planes of constant z, `step` apart.
  std::string Slices(double step) const
  {
    std::ostringstream text;
    for (double z = 0.0; z <= 8.0; z += step)
    {
      const double w = this->HalfWidth(z), m = this->Middle(z);
      text << "z=" << z << ": " << m - w << "," << -w << " " << m + w << "," << -w << " " << m + w
           << "," << w << " " << m - w << "," << w << "\n";
    }
    return text.str();
  }

  /// Distance from the walls, within their slice.
  double DistanceOf(const Point3& p) const
  {
    return std::abs(
      std::max(std::abs(p[0] - this->Middle(p[2])), std::abs(p[1])) - this->HalfWidth(p[2]));
  }
};

/// The root mean square distance of the surface's vertices from the walls, below the slab from which
/// the top bulges.
double ErrorOf(const Frustum& frustum, const Reconstruction& result)
{
  double sum = 0.0, count = 0.0;
  const TriangleMesh mesh = MeshOf(result);
  for (const Point3& p : mesh.Points)
  {
    if (p[2] > 0.01 && p[2] < 6.0)
    {
      sum += frustum.DistanceOf(p) * frustum.DistanceOf(p);
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}
}

//----------------------------------------------------------------------------
TEST(FindContourCorners, AreThoseOfASquare)
{
  const Frustum prism{ 0.0, 0.0 };
  const Reconstruction result = Reconstruct(ParsePieces(prism.Slices(2.0)), Options(), Execution());
  Index corners = 0;
  for (const ContourCorner& corner :
    FindContourCorners(GeometryOf(result), Options().Patching.CornerAngle))
  {
    if (corner.Axis == 2)
    {
      ++corners;
      const Point3 p = result.Graph.PointAt(corner.Point);
      EXPECT_NEAR(std::abs(p[0]), 5.0, 1e-9);
      EXPECT_NEAR(std::abs(p[1]), 5.0, 1e-9);
      EXPECT_NEAR(corner.Turn, std::acos(0.0), 1e-9);
      EXPECT_NEAR(corner.Tip[0], std::copysign(std::sqrt(0.5), p[0]), 1e-9);
      EXPECT_NEAR(corner.Tip[1], std::copysign(std::sqrt(0.5), p[1]), 1e-9);
    }
  }
  EXPECT_GE(corners, 4 * 5);
}

//----------------------------------------------------------------------------
TEST(FindContourCorners, RoundThingsHaveNone)
{
  const Solid ball = PlainBall();
  const Reconstruction result =
    Reconstruct(SliceByFewPlanes(ball, EqualPlanes(ball, { 3, 0, 9 })), Options(), Execution());
  EXPECT_TRUE(FindContourCorners(GeometryOf(result), Options().Patching.CornerAngle).empty());
}

//----------------------------------------------------------------------------
/// Bent least without them, edges are round between slices: the error is then 0.06 and 0.09.
TEST(DrawCreases, EdgesOfPrismsAndPyramidsAreStraight)
{
  Options options;
  options.Virtual = VirtualSlices::Automatic;
  for (const auto& [frustum, most] : { std::pair(Frustum{ 0.0, 0.0 }, 1e-3),
         std::pair(Frustum{ 0.3, 0.0 }, 0.03), std::pair(Frustum{ 0.2, 0.5 }, 0.045) })
  {
    const Reconstruction result =
      Reconstruct(ParsePieces(frustum.Slices(2.0)), options, Execution());
    EXPECT_TRUE(result.Grid.HasVirtual());
    EXPECT_EQ(result.Topology.Components, 1);
    EXPECT_EQ(result.Topology.Genus, 0);
    EXPECT_LT(ErrorOf(frustum, result), most) << frustum.Slope << ", " << frustum.Shift;
  }
}
