// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/CrossingGuard.h"

#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/ClosedMeshes.h"
#include "Support/Random.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A surface, and a guard that looks at it.
struct Guarded
{
  explicit Guarded(const PlainMesh& mesh)
    : Corners(static_cast<Index>(mesh.Points.size()), mesh.Triangles)
    , Points(mesh.Points)
    , Boxes(BoxesOf(Corners, Points))
    , Guard(Corners, Points, Boxes)
  {
  }

  SurfaceChange Move(Index point, const Point3& place) const
  {
    SurfaceChange change;
    change.Point = point;
    change.Place = place;
    this->Corners.ForCornersAt(point,
      [&](Index corner)
      {
        change.Removed.push_back(corner / 3);
        change.Added.push_back(
          { point, this->Corners.StartOf(corner), this->Corners.EndOf(corner) });
      });
    return change;
  }

  /// Whether the surface is embedded with a point at another place, by a checker that shares no
  /// code with the guard.
  bool IsEmbedded(Index point, const Point3& place) const
  {
    std::vector<Point3> points = this->Points;
    points[point] = place;
    return FindMeetings(CopyUsed(this->Corners, points), 1).empty();
  }

  CornerTable Corners;
  std::vector<Point3> Points;
  BoxTree Boxes;
  CrossingGuard Guard;
};

Point3 Near(const Point3& place, double distance, Random& random)
{
  return place +
    Point3{ random.Uniform(-distance, distance), random.Uniform(-distance, distance),
      random.Uniform(-distance, distance) };
}
}

//----------------------------------------------------------------------------
/// Points of a torus moved by little and by much: nothing is allowed that lets triangles meet, and
/// of the rest nearly all.
TEST(CrossingGuard, MovesAreAllowedThatKeepTheSurfaceEmbedded)
{
  Guarded surface(TorusMesh(16, 8));
  Random random(5);
  int right = 0, refused = 0, crossing = 0;
  for (int i = 0; i < 600; ++i)
  {
    const Index point = static_cast<Index>(random.Uniform(0, 128));
    const Point3 place = Near(surface.Points[point],
      i % 3 == 0     ? 0.1
        : i % 3 == 1 ? 0.6
                     : 2.0,
      random);
    const bool allowed = surface.Guard.Allows(surface.Move(point, place));
    const bool embedded = surface.IsEmbedded(point, place);
    EXPECT_TRUE(embedded || !allowed) << i;
    right += embedded && allowed ? 1 : 0;
    refused += embedded && !allowed ? 1 : 0;
    crossing += embedded ? 0 : 1;
  }
  EXPECT_GT(right, 100);
  EXPECT_GT(crossing, 100);
  EXPECT_LT(refused, 3);
}

//----------------------------------------------------------------------------
/// Two sides of a thin plate: a corner of one may not be pushed through the other, though it has no
/// triangle in common with what is there.
TEST(CrossingGuard, ThinWallsStayApart)
{
  // Two squares of 3 x 3 points above each other, joined along their borders.
  PlainMesh plate;
  for (const double z : { 0.0, 0.1 })
  {
    for (int i = 0; i < 9; ++i)
    {
      plate.Points.push_back({ double(i % 3), double(i / 3), z });
    }
  }
  const auto square = [&](Index a, Index b, Index c, Index d)
  {
    plate.Triangles.push_back({ a, b, c });
    plate.Triangles.push_back({ a, c, d });
  };
  for (const Index i : { 0, 1, 3, 4 })
  {
    square(i, i + 3, i + 4, i + 1);
    square(9 + i, 9 + i + 1, 9 + i + 4, 9 + i + 3);
  }
  const Index border[8] = { 0, 1, 2, 5, 8, 7, 6, 3 };
  for (int i = 0; i < 8; ++i)
  {
    const Index from = border[i], to = border[(i + 1) % 8];
    square(from, to, 9 + to, 9 + from);
  }
  Guarded surface(plate);
  ASSERT_TRUE(surface.IsEmbedded(13, { 1.0, 1.0, 0.1 }));
  EXPECT_TRUE(surface.Guard.Allows(surface.Move(13, { 1.0, 1.0, 0.02 })));
  EXPECT_FALSE(surface.Guard.Allows(surface.Move(13, { 1.0, 1.0, 0.0 })));
  EXPECT_FALSE(surface.Guard.Allows(surface.Move(13, { 1.1, 1.2, -0.05 })));
  EXPECT_TRUE(surface.Guard.Allows(surface.Move(13, { 1.1, 1.2, 0.3 })));
}

//----------------------------------------------------------------------------
/// A new point in the middle of a side, and the same off the surface.
TEST(CrossingGuard, PointsMayBeAdded)
{
  Guarded surface(TetrahedronMesh());
  const Index corner = 0, across = surface.Corners.OppositeOf(0);
  const Index a = surface.Corners.StartOf(corner), b = surface.Corners.EndOf(corner);
  const Index c = surface.Corners.VertexOf(corner), d = surface.Corners.VertexOf(across);
  SurfaceChange change;
  change.Removed = { corner / 3, across / 3 };
  change.Point = 4;
  change.Added = { { 4, b, c }, { 4, c, a }, { 4, a, d }, { 4, d, b } };
  change.Place = 0.5 * surface.Points[a] + 0.5 * surface.Points[b];
  EXPECT_TRUE(surface.Guard.Allows(change));
  // Beyond one of the two triangles that stay.
  const Point3 other = (1.0 / 3.0) * (surface.Points[a] + surface.Points[c] + surface.Points[d]);
  change.Place = change.Place + 1.5 * (other - change.Place);
  EXPECT_FALSE(surface.Guard.Allows(change));
}
