// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SlabPull.h"

#include "Core/Sparse/RemeshSurface.h"
#include "Support/ClosedMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr Index Segments = 96;

/// A round tower with a ledge: rings 1 apart, of radius `wide` below z = 0 and 1.2 above.
SurfaceMesh LedgeSurface(double wide, double bottom)
{
  const std::vector<double> heights{ -2.5, -1.5, -0.5, 0.5, 1.5, 2.5 };
  const std::vector<double> radii{ wide, wide, wide, 1.2, 1.2, 1.2 };
  SurfaceMesh mesh =
    RingSurface(RingMesh(Segments, radii, heights, bottom, 3.0), Segments, heights, wide + 2.0);
  for (Box3& cell : mesh.Cells)
  {
    cell.Low[2] = std::max(cell.Low[2], -3.0);
    cell.High[2] = std::min(cell.High[2], 3.0);
  }
  mesh.StretchAxis = 2;
  return mesh;
}

/// The greatest distance from the middle of the slab of what lies in the midst of the ledge.
double OffMiddle(const SurfaceMesh& mesh, double from, double to)
{
  double greatest = 0.0;
  int count = 0;
  for (Index i = 0; i < mesh.Corners.PointCount(); ++i)
  {
    const Point3& p = mesh.Points[i];
    const double radius = std::hypot(p[0], p[1]);
    if (mesh.Corners.IsUsed(i) && !mesh.Fixed[i] && radius > from && radius < to &&
      std::abs(p[2]) <= 0.5)
    {
      greatest = std::max(greatest, std::abs(p[2]));
      ++count;
    }
  }
  EXPECT_GT(count, 20);
  return greatest;
}
}

//----------------------------------------------------------------------------
/// Least bending draws a wide ledge in a long slope from one slice to the other, or beyond them.
TEST(SlabPull, TheMidstOfAWideLedgeIsInTheMiddleOfItsSlab)
{
  SurfaceMesh plain = LedgeSurface(9.0, -3.0);
  SurfaceMesh pulled = plain;
  MakeFair(0.6, plain, false);
  MakeFair(0.6, pulled);
  const double before = OffMiddle(plain, 3.5, 7.0);
  const double after = OffMiddle(pulled, 3.5, 7.0);
  EXPECT_GT(before, 0.3);
  EXPECT_LT(after, 0.2);
}

//----------------------------------------------------------------------------
/// Pulled are free points by their area as seen along the axis, upwards and downwards alike.
TEST(SlabPull, ActsOnFlatPartsAlone)
{
  SurfaceMesh mesh = LedgeSurface(9.0, -3.0);
  RefineEdges(0.6, mesh);
  const SlabPull pull = PullIntoSlabs(mesh, 0.3);
  double steep = 0.0, flat = 0.0;
  for (Index i = 0; i < mesh.Corners.PointCount(); ++i)
  {
    if (!mesh.Corners.IsUsed(i))
    {
      continue;
    }
    const Point3& p = mesh.Points[i];
    const double radius = std::hypot(p[0], p[1]);
    EXPECT_TRUE(pull.Strength[i] >= 0.0 && (!mesh.Fixed[i] || pull.Strength[i] == 0.0));
    if (!mesh.Fixed[i] && std::abs(p[2]) < 0.5)
    {
      flat = std::max(flat, pull.Strength[i]);
      EXPECT_NEAR(pull.Aim[i], 0.05, 1e-9); // outside is above
    }
    else if (!mesh.Fixed[i] && radius > 8.5 && std::abs(p[2] + 1.5) < 0.9)
    {
      steep = std::max(steep, pull.Strength[i]);
    }
  }
  EXPECT_GT(flat, 0.1);
  EXPECT_LT(steep, 1e-6);
}

//----------------------------------------------------------------------------
TEST(SlabPull, GrowsWithTheRoughness)
{
  SurfaceMesh mesh = LedgeSurface(5.0, -3.0);
  RefineEdges(0.6, mesh);
  double before = 0.0;
  for (const double roughness : { 0.0, 0.1, 0.3, 0.8 })
  {
    double sum = 0.0;
    for (const double strength : PullIntoSlabs(mesh, roughness).Strength)
    {
      sum += strength;
    }
    EXPECT_TRUE(roughness > 0.0 ? sum > before : sum == 0.0);
    before = sum;
  }
}
