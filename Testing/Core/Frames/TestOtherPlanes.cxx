// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/OtherPlanes.h"

#include "Support/Random.h"
#include "Support/TurnedSlices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Ellipses on two parallel planes and on one across, in a random frame; two of them on the first
/// one.
Polylines Ellipses(std::uint64_t seed, double noise)
{
  const PieceSets sets =
    ParsePieces("z=0: -2,-1 0,-2 2,-1 3,1 0,2 -3,1; z=0: 5,0 6,-1 7,0 7,1 6,2 5,1; "
                "z=0.5: -2,-1 0,-2 2,-1 3,1 0,2 -3,1; x=0: -2,-1 0,-2 2,-1 3,1 0,2 -3,1");
  Polylines lines = MapSlices(sets, RandomRotation(seed));
  Random random(seed);
  for (std::vector<double>* values : { &lines.X, &lines.Y, &lines.Z })
  {
    for (double& x : *values)
    {
      x += 10.0 + random.Uniform(-noise, noise);
    }
  }
  return lines;
}
}

//----------------------------------------------------------------------------
TEST(FindOtherPlanes, ContoursOfOnePlaneAreTogether)
{
  for (std::uint64_t seed = 0; seed < 8; ++seed)
  {
    const double noise = seed % 2 == 0 ? 0.0 : 1e-3;
    const Polylines lines = Ellipses(seed, noise);
    const std::vector<OtherPlane> planes = FindOtherPlanes(lines, 1e-6);
    ASSERT_EQ(planes.size(), 3u);
    EXPECT_EQ(planes[0].Lines, std::vector<Index>{ 0 }); // x comes first
    EXPECT_EQ(planes[1].Lines, (std::vector<Index>{ 1, 2 }));
    EXPECT_EQ(planes[2].Lines, std::vector<Index>{ 3 });
    for (const OtherPlane& plane : planes)
    {
      EXPECT_NEAR(Length(plane.Normal), 1.0, 1e-12);
      for (const Index line : plane.Lines)
      {
        for (Index i = lines.Offsets[line]; i < lines.Offsets[line + 1]; ++i)
        {
          EXPECT_NEAR(Dot(plane.Normal, lines.PointAt(i)), plane.Offset, 2.0 * noise + 1e-9);
        }
      }
    }
  }
}

//----------------------------------------------------------------------------
/// What is laid on the plane is found again, runs the same way around its normal, and is flat.
TEST(LayOnPlane, PointsAreFoundAgain)
{
  const Polylines lines = Ellipses(3, 1e-3);
  for (const OtherPlane& plane : FindOtherPlanes(lines, 1e-6))
  {
    const Pieces pieces = LayOnPlane(lines, plane);
    ASSERT_EQ(pieces.Count(), static_cast<Index>(plane.Lines.size()));
    for (Index piece = 0; piece < pieces.Count(); ++piece)
    {
      EXPECT_EQ(pieces.Cell[piece], plane.Lines[piece]);
      double area = 0.0, along = 0.0;
      const Index first = lines.Offsets[plane.Lines[piece]];
      const Index begin = pieces.Offsets[piece], end = pieces.Offsets[piece + 1];
      for (Index i = begin; i < end; ++i)
      {
        const Index next = i + 1 < end ? i + 1 : begin;
        const Point3 here = lines.PointAt(first + i - begin);
        EXPECT_EQ(pieces.W[i], plane.Offset);
        EXPECT_LT(Length(PointOn(plane, pieces.U[i], pieces.V[i]) - here), 3e-3);
        area += pieces.U[i] * pieces.V[next] - pieces.U[next] * pieces.V[i];
        along += Dot(plane.Normal, Cross(here, lines.PointAt(first + next - begin)));
      }
      EXPECT_GT(area * along, 0.0);
      EXPECT_NEAR(area, along, 0.01 * std::abs(area));
    }
  }
}
