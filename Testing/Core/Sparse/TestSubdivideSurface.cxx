// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/SubdivideSurface.h"

#include "Support/ClosedMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr Index Segments = 24;

struct BallOfRings
{
  BallOfRings()
  {
    std::vector<double> radii;
    for (int i = 1; i < 12; ++i)
    {
      const double angle = i * std::acos(-1.0) / 12.0;
      this->Heights.push_back(-std::cos(angle));
      radii.push_back(std::sin(angle));
    }
    this->Mesh = RingMesh(Segments, radii, this->Heights, -1, 1);
  }

  std::vector<double> Heights;
  PlainMesh Mesh;
};

/// How far the middles of the triangles lie below a ball of radius 1 around the origin, at most.
double Sag(const std::vector<Point3>& points, const std::vector<std::array<Index, 3>>& triangles)
{
  double sag = 0.0;
  for (const auto& [a, b, c] : triangles)
  {
    sag = std::max(sag, 1.0 - Length((1.0 / 3.0) * (points[a] + points[b] + points[c])));
  }
  return sag;
}
}

//----------------------------------------------------------------------------
/// New points lie on the ball, far closer than the middles of the edges did.
TEST(SubdivideSurface, WhatTrianglesCutOffABallBecomesAQuarter)
{
  const BallOfRings ball;
  const SurfaceMesh mesh = FreeSurface(ball.Mesh, 2.0);
  TriangleSurface surface = SubdivideSurface(mesh);
  EXPECT_EQ(CloseSurface(surface).Kind, SurfaceProblemKind::None);
  EXPECT_EQ(surface.Triangles.size(), 4 * ball.Mesh.Triangles.size());
  EXPECT_EQ(surface.Points.size(), ball.Mesh.Points.size() + ball.Mesh.Triangles.size() * 3 / 2);
  const double before = Sag(ball.Mesh.Points, ball.Mesh.Triangles);
  EXPECT_LT(Sag(surface.Points, surface.Triangles), 0.3 * before);
  for (const Point3& p : surface.Points)
  {
    EXPECT_NEAR(Length(p), 1.0, 0.1 * before);
  }
  EXPECT_TRUE(std::equal(ball.Mesh.Points.begin(), ball.Mesh.Points.end(), surface.Points.begin()));
}

//----------------------------------------------------------------------------
TEST(SubdivideSurface, MiddlesOfContoursStayOnTheirSlice)
{
  const BallOfRings ball;
  const SurfaceMesh mesh = RingSurface(ball.Mesh, Segments, ball.Heights, 2.0);
  const TriangleSurface surface = SubdivideSurface(mesh);
  for (const double height : ball.Heights)
  {
    const auto onSlice = [&](const Point3& p) { return p[2] == height; };
    EXPECT_EQ(std::count_if(surface.Points.begin(), surface.Points.end(), onSlice), 2 * Segments);
  }
}

//----------------------------------------------------------------------------
/// Edges between two creases stay straight.
TEST(SubdivideSurface, CreasesStayStraight)
{
  const BallOfRings ball;
  SurfaceMesh mesh = FreeSurface(ball.Mesh, 2.0);
  std::fill(mesh.Crease.begin(), mesh.Crease.end(), std::uint8_t(1));
  const TriangleSurface surface = SubdivideSurface(mesh);
  double volume = 0.0;
  for (const auto& [a, b, c] : ball.Mesh.Triangles)
  {
    volume += Dot(ball.Mesh.Points[a], Cross(ball.Mesh.Points[b], ball.Mesh.Points[c]));
  }
  EXPECT_NEAR(SixfoldVolume(surface), volume, 1e-9);
}
