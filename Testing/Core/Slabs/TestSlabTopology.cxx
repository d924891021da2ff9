// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   components and genus of solids of which one stack of slices is known
 *
 * Solids whose slices are circles, 11 of them at distance 1: pipes, hoppers and shells whose walls
 * move by more than their thickness from slice to slice, cavities, channels, branches.
 */

#include "Core/Reconstruct.h"
#include "Support/CheckSurface.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SelfIntersections.h"
#include "Support/TextContours.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Circle
{
  double U, V, Radius;
  bool Hole = false;
};

using Slice = std::vector<Circle>;

struct Solid
{
  const char* Name;
  Slice (*At)(double height);
  Index Components, Genus;
};

/// Half the width of a ball at a height over its centre; 0 off the ball and at its very tips.
double Section(double radius, double height)
{
  const double square = radius * radius - height * height;
  return square > 0.02 * radius * radius ? std::sqrt(square) : 0.0;
}

void AddSection(Slice& slice, Circle circle, double height)
{
  circle.Radius = Section(circle.Radius, height);
  if (circle.Radius > 0.0)
  {
    slice.push_back(circle);
  }
}

Slice Pipe(double z) { return { { 2.0 * z, 0.0, 5.0 }, { 2.0 * z, 0.0, 4.5, true } }; }
Slice SteepPipe(double z) { return { { 8.0 * z, z, 5.0 }, { 8.0 * z, z, 4.0, true } }; }
Slice TwoPipes(double z)
{
  const double u = 1.5 * z;
  return { { u, 0.0, 8.0 }, { u, 0.0, 7.4, true }, { u, 0.0, 5.0 }, { u, 0.0, 4.4, true } };
}
Slice Hopper(double z)
{
  return { { 0.0, 0.0, 30.0 - 2.0 * z }, { 0.0, 0.0, 29.5 - 2.0 * z, true } };
}
Slice Cavities(double z)
{
  Slice slice;
  AddSection(slice, { 0.0, 0.0, 8.2 }, z - 5.0);
  AddSection(slice, { -3.0, 0.0, 2.0, true }, z - 5.2);
  AddSection(slice, { 3.0, 0.0, 2.2, true }, z - 6.3);
  AddSection(slice, { 0.0, 3.5, 1.8, true }, z - 3.8);
  return slice;
}
Slice PipeWithCavity(double z)
{
  Slice slice{ { 0.0, 0.0, 8.0 }, { 0.0, 0.0, 3.0, true } };
  AddSection(slice, { 5.5, 0.0, 2.0, true }, z - 5.0);
  return slice;
}
Slice Shell(double z)
{
  Slice slice;
  AddSection(slice, { 1.1 * z, 0.0, 5.3 }, z - 5.0);
  AddSection(slice, { 1.1 * z, 0.0, 5.0, true }, z - 5.0);
  return slice;
}
Slice BallInCavity(double z)
{
  Slice slice;
  AddSection(slice, { 0.0, 0.0, 6.2 }, z - 5.0);
  AddSection(slice, { 0.0, 0.0, 4.4, true }, z - 5.0);
  AddSection(slice, { 0.0, 0.0, 2.7 }, z - 5.0);
  return slice;
}
Slice Cup(double z)
{
  Slice slice{ { 0.0, 0.0, 5.0 } };
  if (z > 2.5)
  {
    slice.push_back({ 0.5, 0.0, 3.0, true });
  }
  return slice;
}
Slice Rod(double z) { return { { 3.5 * z, z, 1.2 } }; }
Slice Channel(double z) { return { { 10.0, 0.0, 16.0 }, { 2.0 * z, 0.0, 0.7, true } }; }
Slice TwoBalls(double z)
{
  Slice slice;
  AddSection(slice, { 0.0, 0.0, 2.7 }, z - 2.6);
  AddSection(slice, { 9.0, 0.0, 2.2 }, z - 7.5);
  return slice;
}
Slice Branches(double z)
{
  const double u = 1.8 + 1.2 * (z - 4.5);
  return z < 4.5 ? Slice{ { 0.0, 0.0, 3.0 } } : Slice{ { -u, 0.0, 1.6 }, { u, 0.0, 1.6 } };
}

Slice HollowBranches(double z)
{
  const double u = 3.1 + 0.7 * (z - 5.0);
  return z < 4.5
    ? Slice{ { 0.0, 0.0, 6.0 }, { 0.0, 0.0, 5.4, true } }
    : Slice{ { -u, 0.0, 2.5 }, { -u, 0.0, 1.9, true }, { u, 0.0, 2.5 }, { u, 0.0, 1.9, true } };
}

constexpr Solid Solids[] = { { "pipe", Pipe, 1, 1 }, { "steep pipe", SteepPipe, 1, 1 },
  { "two pipes", TwoPipes, 2, 2 }, { "hopper", Hopper, 1, 1 }, { "cavities", Cavities, 4, 0 },
  { "pipe with cavity", PipeWithCavity, 2, 1 }, { "shell", Shell, 2, 0 },
  { "ball in cavity", BallInCavity, 3, 0 }, { "cup", Cup, 1, 0 }, { "rod", Rod, 1, 0 },
  { "channel", Channel, 1, 1 }, { "two balls", TwoBalls, 2, 0 }, { "branches", Branches, 1, 0 },
  { "hollow branches", HollowBranches, 1, 2 } };

/// The circles as polygons of so many vertices, rounded to multiples of a step if it is not 0.
PieceSets StackOf(const Solid& solid, int axis, int vertices, double step)
{
  constexpr double fullTurn = 6.283185307179586;
  PieceSets sets = EmptySets();
  for (int slice = 0; slice <= 10; ++slice)
  {
    for (const Circle& circle : solid.At(slice))
    {
      std::vector<Point2> polygon;
      for (int i = 0; i < vertices; ++i)
      {
        const double angle = (circle.Hole ? -1.0 : 1.0) * fullTurn * (i + 0.3) / vertices;
        Point2 p{ circle.U + circle.Radius * std::cos(angle),
          circle.V + circle.Radius * std::sin(angle) };
        for (double& x : p)
        {
          x = step > 0.0 ? step * std::round(x / step) : x;
        }
        polygon.push_back(p);
      }
      AddPiece(sets[axis], polygon, slice);
    }
  }
  return sets;
}

/// A closed surface that does not cross itself, with the solid's components and genus.
void Check(const Solid& solid, PieceSets&& pieces)
{
  const Reconstruction result = Reconstruct(std::move(pieces), Options(), Execution());
  EXPECT_EQ(result.Topology.Components, solid.Components);
  EXPECT_EQ(result.Topology.Genus, solid.Genus);
  const TriangleMesh mesh = MeshOf(result);
  const SurfaceCheck check = CheckSurface(mesh);
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, solid.Components);
  EXPECT_EQ(check.TotalGenus(), solid.Genus);
  EXPECT_GT(check.TotalVolume(), 0.0);
  EXPECT_LE(CountSelfIntersections(mesh), 0);
}
}

//----------------------------------------------------------------------------
TEST(SlabTopology, IsThatOfTheSolid)
{
  for (const Solid& solid : Solids)
  {
    SCOPED_TRACE(solid.Name);
    Check(solid, StackOf(solid, 2, 24, 0.0));
  }
}

//----------------------------------------------------------------------------
TEST(SlabTopology, IsTheSameOnAllAxesAndForManyVertices)
{
  for (const Solid& solid : Solids)
  {
    SCOPED_TRACE(solid.Name);
    Check(solid, StackOf(solid, 0, 60, 0.0));
    Check(solid, StackOf(solid, 1, 25, 0.0));
  }
}

//----------------------------------------------------------------------------
TEST(SlabTopology, StandsRounding)
{
  for (const Solid& solid : Solids)
  {
    SCOPED_TRACE(solid.Name);
    Check(solid, StackOf(solid, 2, 48, 0.01));
  }
}
