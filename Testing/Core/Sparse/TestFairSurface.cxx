// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/FairSurface.h"

#include "Core/Sparse/RemeshSurface.h"
#include "Support/ClosedMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// So many that no edge of the contours is shorter than four fifths of those asked for: all of
/// their points stay, and an error of the radius is one of the surface between them.
constexpr Index Segments = 48;

/// Contours of a solid of revolution around the z axis, on planes 1 apart around 0.
struct Rings
{
  Rings(const std::function<double(double)>& radius, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Heights.push_back(i - 0.5 * (count - 1));
      this->Radii.push_back(radius(this->Heights.back()));
    }
  }

  SurfaceMesh Surface(double beyond, double room) const
  {
    return RingSurface(RingMesh(Segments, this->Radii, this->Heights,
                         this->Heights.front() - beyond, this->Heights.back() + beyond),
      Segments, this->Heights, room);
  }

  std::vector<double> Heights, Radii;
};

void Stretch(double stretch, SurfaceMesh& mesh)
{
  mesh.StretchAxis = 2;
  std::fill(mesh.Stretch.begin(), mesh.Stretch.end(), Point3{ stretch, stretch, 1.0 });
}

template <typename Visit>
void ForPoints(const SurfaceMesh& mesh, Visit&& visit)
{
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (mesh.Corners.IsUsed(static_cast<Index>(i)))
    {
      visit(mesh.Points[i], mesh.Fixed[i] != 0, static_cast<Index>(i));
    }
  }
}

/// The greatest relative error of the radius, off the contours and within |z| <= `height`.
double RadiusError(
  const SurfaceMesh& mesh, double height, const std::function<double(double)>& radius)
{
  double greatest = 0.0;
  std::size_t count = 0;
  ForPoints(mesh,
    [&](const Point3& p, bool isFixed, Index)
    {
      if (!isFixed && std::abs(p[2]) <= height)
      {
        greatest = std::max(greatest, std::abs(std::hypot(p[0], p[1]) / radius(p[2]) - 1.0));
        ++count;
      }
    });
  EXPECT_GT(count, 20u);
  return greatest;
}

void ExpectInCells(const SurfaceMesh& mesh)
{
  ForPoints(mesh,
    [&](const Point3& p, bool isFixed, Index i)
    {
      const Box3& cell = mesh.Cells[isFixed ? 0 : mesh.CellOf(i)];
      for (int axis = 0; axis < 3 && !isFixed; ++axis)
      {
        EXPECT_GE(p[axis], cell.Low[axis]);
        EXPECT_LE(p[axis], cell.High[axis]);
      }
    });
}
}

//----------------------------------------------------------------------------
TEST(FairSurface, BetweenTheRingsOfACylinderItsRadiusIsRight)
{
  const auto radius = [](double) { return 1.2; };
  SurfaceMesh mesh = Rings(radius, 7).Surface(0.4, 4.0);
  MakeFair(0.19, mesh);
  EXPECT_LT(RadiusError(mesh, 2.0, radius), 0.015);
}

//----------------------------------------------------------------------------
TEST(FairSurface, BetweenTheRingsOfABallItsRadiusIsRight)
{
  const auto radius = [](double z) { return std::sqrt(16.0 - z * z); };
  SurfaceMesh mesh = Rings(radius, 8).Surface(0.1, 6.0);
  MakeFair(0.7, mesh);
  EXPECT_LT(RadiusError(mesh, 2.5, radius), 0.01);
  // Nobody has told it how high the ends are: they come out round all the same.
  Point3 top{ 0.0, 0.0, 0.0 };
  ForPoints(mesh, [&](const Point3& p, bool, Index) { top = p[2] > top[2] ? p : top; });
  EXPECT_NEAR(top[2], 4.0, 0.1);
  ExpectInCells(mesh);
}

//----------------------------------------------------------------------------
/// A tube that is thin against the distance of its slices is drawn in between them by least
/// bending; stretched, it is not.
TEST(FairSurface, ThinTubesKeepTheirRadiusIfStretched)
{
  const auto radius = [](double) { return 0.15; };
  SurfaceMesh plain = Rings(radius, 6).Surface(0.1, 3.0);
  SurfaceMesh stretched = plain;
  Stretch(0.85 / 0.15, stretched);
  MakeFair(0.1, plain);
  MakeFair(0.135, stretched);
  EXPECT_GT(RadiusError(plain, 1.4, radius), 0.1);
  EXPECT_LT(RadiusError(stretched, 1.4, radius), 0.03);
}

//----------------------------------------------------------------------------
/// Least bending flattens what is round between its contours, the more the rounder; against the
/// load on it a tube and a ball keep their radius.
TEST(FairSurface, WhatIsRoundKeepsItsRadius)
{
  const auto tube = [](double) { return 0.9; };
  const auto ball = [](double z) { return std::sqrt(1.44 - z * z); };
  const std::vector<std::pair<std::function<double(double)>, Index>> shapes{ { tube, 10 },
    { ball, 3 } };
  for (const auto& [radius, rings] : shapes)
  {
    std::array<double, 2> errors{};
    for (const EdgeWeights weights : { EdgeWeights::Cotangents, EdgeWeights::RoundCotangents })
    {
      SurfaceMesh mesh = Rings(radius, rings).Surface(0.1, 1.05 * radius(0.0));
      MakeFair(0.1, mesh);
      for (int round = 0; round < 3; ++round)
      {
        FairSurface(weights, mesh);
      }
      errors[weights == EdgeWeights::RoundCotangents ? 1 : 0] =
        RadiusError(mesh, 0.45, radius); // far from the ends
      ExpectInCells(mesh);
    }
    EXPECT_GT(errors[0], 0.003);
    EXPECT_LT(errors[1], 0.5 * errors[0]);
  }
}

//----------------------------------------------------------------------------
TEST(FairSurface, PointsOfContoursDoNotMove)
{
  const Rings rings([](double z) { return 1.5 + 0.5 * std::sin(2.0 * z); }, 5);
  SurfaceMesh mesh = rings.Surface(0.3, 4.0);
  RefineEdges(0.5, mesh);
  const SurfaceMesh before = mesh;
  for (const EdgeWeights weights :
    { EdgeWeights::Uniform, EdgeWeights::Cotangents, EdgeWeights::RoundCotangents })
  {
    FairSurface(weights, mesh);
  }
  std::size_t moved = 0;
  ForPoints(mesh,
    [&](const Point3& p, bool isFixed, Index i)
    {
      EXPECT_TRUE(!isFixed || p == before.Points[i]);
      moved += p != before.Points[i] ? 1 : 0;
    });
  EXPECT_GT(moved, 100u);
}

//----------------------------------------------------------------------------
/// Contours that change wildly from slice to slice, and flat cells at the ends.
TEST(FairSurface, PointsStayInTheirCells)
{
  const Rings rings([](double z) { return std::lround(z + 0.5) % 2 == 0 ? 0.4 : 2.0; }, 6);
  SurfaceMesh mesh = rings.Surface(0.05, 2.01);
  mesh.Cells.front().Low[2] = rings.Heights.front() - 0.1;
  mesh.Cells.back().High[2] = rings.Heights.back() + 0.1;
  MakeFair(0.4, mesh);
  ExpectInCells(mesh);
  std::size_t stopped = 0;
  ForPoints(mesh,
    [&](const Point3& p, bool isFixed, Index i)
    {
      const Box3& cell = mesh.Cells[isFixed ? 0 : mesh.CellOf(i)];
      for (int axis = 0; axis < 3 && !isFixed; ++axis)
      {
        stopped += p[axis] == cell.Low[axis] || p[axis] == cell.High[axis] ? 1 : 0;
      }
    });
  EXPECT_GT(stopped, 0u); // else this says nothing
}

//----------------------------------------------------------------------------
/// With an edge around it a flat end stays flat and the side next to it straight; without, it
/// bulges.
TEST(FairSurface, FlatEndsStayFlatWithinTheirCrease)
{
  const auto radius = [](double) { return 1.2; };
  for (const bool hasCrease : { true, false })
  {
    const Rings rings(radius, 5);
    SurfaceMesh mesh = rings.Surface(0.0, 4.0);
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      const double z = std::abs(mesh.Points[i][2]);
      mesh.Crease[i] = hasCrease && mesh.Fixed[i] && z == rings.Heights.back() ? 1 : 0;
    }
    MakeFair(0.19, mesh);
    double highest = 0.0;
    ForPoints(mesh, [&](const Point3& p, bool, Index) { highest = std::max(highest, p[2]); });
    const double bulge = highest - rings.Heights.back();
    if (hasCrease)
    {
      EXPECT_NEAR(bulge, 0.0, 1e-9);
      EXPECT_LT(RadiusError(mesh, rings.Heights.back() - 1e-6, radius), 0.04);
    }
    else
    {
      EXPECT_GT(bulge, 0.2);
    }
  }
}

//----------------------------------------------------------------------------
/// Two contours with a crease each, as of a short rod with flat ends: its side stays straight.
/// Least bending alone would draw it in as a film of soap.
TEST(FairSurface, SideBetweenTwoCreasesStaysStraight)
{
  const auto radius = [](double) { return 1.0; };
  SurfaceMesh mesh = Rings(radius, 2).Surface(0.0, 4.0);
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    mesh.Crease[i] = mesh.Fixed[i];
  }
  MakeFair(0.1, mesh);
  EXPECT_LT(RadiusError(mesh, 0.49, radius), 0.005);
}

//----------------------------------------------------------------------------
/// A surface without any fixed point has nothing to hold it, and stays as it is or finite.
TEST(FairSurface, NothingFixedIsNoReasonToFail)
{
  SurfaceMesh mesh = FreeSurface(TorusMesh(12, 8), 3.0);
  for (const EdgeWeights weights :
    { EdgeWeights::Uniform, EdgeWeights::Cotangents, EdgeWeights::RoundCotangents })
  {
    FairSurface(weights, mesh);
    ForPoints(mesh,
      [](const Point3& p, bool, Index)
      {
        for (const double x : p)
        {
          EXPECT_TRUE(std::abs(x) <= 3.0);
        }
      });
  }
}
