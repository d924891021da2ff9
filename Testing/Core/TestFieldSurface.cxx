// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a few slices of several families: whether a field shows the shape between them, or
 * patches
 */

#include "Support/CheckEmbedding.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SparseSolids.h"

#include "Core/Reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Reconstruction MakeSurfaceOf(const PieceSets& sets, VirtualSlices use = VirtualSlices::Automatic)
{
  Options options;
  options.Virtual = use;
  options.FollowField = true;
  return Reconstruct(PieceSets(sets), options, Execution());
}

/// The root of the mean square of the distances of the surface's points from the solid.
double ErrorOf(const Reconstruction& result, const Solid& solid)
{
  const TriangleMesh mesh = MeshOf(result);
  double sum = 0.0, area = 0.0;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const Point3 p = mesh.Points[a], q = mesh.Points[b], r = mesh.Points[c];
    const double value = solid.Value((1.0 / 3.0) * (p + q + r));
    const double weight = Length(Cross(q - p, r - p));
    sum += weight * value * value;
    area += weight;
  }
  return std::sqrt(sum / area);
}

/// Slanted, so that no plane is one of its symmetry.
Solid Egg()
{
  Solid egg;
  egg.Name = "egg";
  egg.Low = { -1.3, -1.3, -1.3 };
  egg.High = { 1.3, 1.3, 1.3 };
  egg.Components = 1;
  egg.Genus = 0;
  egg.Function = [](const Point3& p)
  {
    const Point3 q{ 0.8 * p[0] + 0.6 * p[1], 0.8 * p[1] - 0.6 * p[0], p[2] + 0.3 * p[0] };
    const double r = std::sqrt(q[0] * q[0] / 1.2 + q[1] * q[1] / 0.5 + q[2] * q[2] / 0.8);
    return r - 1.0;
  };
  return egg;
}
}

//----------------------------------------------------------------------------
/// Of an egg, a field makes less of an error than the patches of the cells.
TEST(FieldSurface, RoundThingsFollowAField)
{
  const Solid egg = Egg();
  for (const auto& count : { std::array<int, 3>{ 3, 2, 2 }, { 4, 4, 4 }, { 2, 0, 3 } })
  {
    const PieceSets sets = SliceByFewPlanes(egg, EqualPlanes(egg, count));
    const Reconstruction result = MakeSurfaceOf(sets);
    EXPECT_EQ(result.Topology.Components, 1);
    EXPECT_EQ(result.Topology.Genus, 0);
    EXPECT_LT(ErrorOf(result, egg), 0.7 * ErrorOf(MakeSurfaceOf(sets, VirtualSlices::Off), egg));
    EXPECT_LT(ErrorOf(result, egg), 0.05);
    EXPECT_EQ(DescribeFlaws(MeshOf(result)), "");
  }
}

//----------------------------------------------------------------------------
/// Of a box, patches foretell slices exactly, and no field rounds it.
TEST(FieldSurface, BoxesStayBoxes)
{
  for (const int planes : { 2, 3, 5 })
  {
    PieceSets sets = EmptySets();
    const Point3 size{ 4.0, 3.0, 2.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double u = size[FirstAxis(axis)], v = size[SecondAxis(axis)];
      for (int i = 0; i < planes; ++i)
      {
        AddPiece(
          sets[axis], { { 0, 0 }, { u, 0 }, { u, v }, { 0, v } }, size[axis] * (i + 0.5) / planes);
      }
    }
    const Reconstruction automatic = MakeSurfaceOf(sets),
                         off = MakeSurfaceOf(sets, VirtualSlices::Off);
    EXPECT_EQ(MeshOf(automatic).Points, MeshOf(off).Points);
  }
}

//----------------------------------------------------------------------------
/// Where families have a dozen slices, no virtual ones are added.
TEST(FieldSurface, DenseSlicesAreLeftAlone)
{
  const Solid egg = Egg();
  const PieceSets sets = SliceByFewPlanes(egg, EqualPlanes(egg, { 12, 12, 12 }));
  EXPECT_EQ(
    MeshOf(MakeSurfaceOf(sets)).Points, MeshOf(MakeSurfaceOf(sets, VirtualSlices::Off)).Points);
}

//----------------------------------------------------------------------------
/// What the slices join stays joined, whatever a field would say of it.
TEST(FieldSurface, SolidsKeepTheirComponents)
{
  for (const Solid& solid : AllSparseSolids())
  {
    for (const auto& count : { std::array<int, 3>{ 3, 3, 3 }, { 5, 4, 3 } })
    {
      SCOPED_TRACE(solid.Name);
      const PieceSets sets = SliceByFewPlanes(solid, EqualPlanes(solid, count));
      const Reconstruction automatic = MakeSurfaceOf(sets),
                           off = MakeSurfaceOf(sets, VirtualSlices::Off);
      EXPECT_LE(automatic.Topology.Components, off.Topology.Components + off.SmallComponents);
      EXPECT_EQ(DescribeFlaws(MeshOf(automatic)), "");
    }
  }
}
