// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SmoothPatch.h"
#include "Core/Planar/SimplePolygon.h"

#include "Core/Base/Vectors.h"
#include "Support/CheckPatch.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Stages SphereSlices(int count, int subdivisions)
{
  Solid solid;
  solid.Low = { -1.23, -1.21, -1.19 };
  solid.High = { 1.17, 1.22, 1.24 };
  solid.Tubes = { Ball({ 0, 0, 0 }, 1.0) };
  Input input;
  input.Sets =
    SliceSolid(solid, EqualPlanes(solid, { count, count, count }), subdivisions, InPlaneGrid::Free);
  return Stages(input);
}

/// Those of the sphere, so that the patch alone is tested.
SurfaceNormals ExactNormals(const Stages& stages)
{
  SurfaceNormals normals;
  for (Index i = 0; i < stages.Graph.Count(); ++i)
  {
    for (const double x : Unit(stages.Graph.PointAt(i)))
    {
      normals.Normals.push_back(static_cast<float>(x));
    }
  }
  return normals;
}

/// Calls visit(cycle, border, patch) for all cycles; the number of those without a patch.
template <typename Visit>
Index VisitPatches(const Stages& stages, const SurfaceNormals& normals,
  const PatchResolution& resolution, Visit&& visit)
{
  SmoothPatchBuilder builder(stages.Grid, resolution);
  PatchBorder border;
  InnerPatch patch;
  Index failed = 0;
  for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
  {
    border.Set(stages.Geometry(), normals, cycle);
    if (builder.Build(border, patch))
    {
      visit(cycle, border, patch);
    }
    else
    {
      ++failed;
    }
  }
  return failed;
}

Point3 PlaceOf(const PatchBorder& border, const InnerPatch& patch, Index corner)
{
  return corner >= 0 ? border.Places[corner] : patch.Points[-1 - corner];
}

/// Calls visit(p, q) for the sides with an end inside.
template <typename Visit>
void VisitSides(const PatchBorder& border, const InnerPatch& patch, Visit&& visit)
{
  for (const auto& t : patch.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index a = t[k], b = t[(k + 1) % 3];
      if (a < 0 || b < 0)
      {
        visit(PlaceOf(border, patch, a), PlaceOf(border, patch, b));
      }
    }
  }
}

constexpr double MeanSpacing = 2.4 / 9.0; // about that of nine planes
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, IsADiscWithPointsInsideTheCell)
{
  Index built = 0, cycles = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Stages stages(
      seed % 2 == 0 ? RandomConsistentInput(seed) : RandomContradictoryInput(seed));
    const SurfaceNormals normals = EstimateNormals(stages.Geometry(), 1.05, {}, Execution());
    cycles += stages.Cycles.Count();
    VisitPatches(stages, normals, { 0.06, 0.0 },
      [&](Index cycle, const PatchBorder& border, const InnerPatch& patch)
      {
        ++built;
        const PatchMesh mesh{ PatchKind::Joined, { cycle }, patch.Points, patch.Triangles };
        ASSERT_EQ(DescribePatchFlaws(stages.Geometry(), mesh), "") << seed;
        PatchView view;
        ASSERT_TRUE(view.Set(border));
        EXPECT_TRUE(IsSimple(view.Border()));
        EXPECT_TRUE(view.SeesAll(patch));
        ASSERT_EQ(patch.Normals.size(), patch.Points.size());
        for (const Point3& normal : patch.Normals)
        {
          // None where the surface was not found.
          ASSERT_TRUE(Length(normal) == 0.0 || std::abs(Length(normal) - 1.0) < 1e-9);
        }
        for (const auto& t : patch.Triangles)
        {
          // No side inside the patch lies on a face of the cell.
          for (int k = 0; k < 3; ++k)
          {
            const Index a = t[k], b = t[(k + 1) % 3];
            ASSERT_TRUE(
              a < 0 || b < 0 || b == (a + 1) % border.Count() || !border.AreOnOneFace(a, b));
          }
        }
      });
  }
  EXPECT_GT(built, 0.8 * cycles);
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, PatchesOfASphereLieOnIt)
{
  const Stages stages = SphereSlices(9, 12);
  double worst = 0.0, sum = 0.0, worstTurn = 0.0;
  Index count = 0;
  const Index failed = VisitPatches(stages, ExactNormals(stages), { 0.25 * MeanSpacing, 0.0 },
    [&](Index, const PatchBorder&, const InnerPatch& patch)
    {
      for (std::size_t i = 0; i < patch.Points.size(); ++i)
      {
        const double off = std::abs(Length(patch.Points[i]) - 1.0);
        worst = std::max(worst, off);
        sum += off * off;
        worstTurn = std::max(worstTurn, Length(patch.Normals[i] - Unit(patch.Points[i])));
        ++count;
      }
    });
  EXPECT_EQ(failed, 0);
  EXPECT_LT(worst, 2e-3);
  EXPECT_LT(std::sqrt(sum / count), 2e-4);
  EXPECT_LT(worstTurn, 0.1);
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, ErrorFallsWithTheFourthPowerOfTheSpacing)
{
  const auto errorOf = [](int planes)
  {
    const Stages stages = SphereSlices(planes, 256 / planes);
    double sum = 0.0;
    Index count = 0;
    VisitPatches(stages, ExactNormals(stages), { 0.6 / planes, 0.0 },
      [&](Index, const PatchBorder&, const InnerPatch& patch)
      {
        for (const Point3& p : patch.Points)
        {
          sum += (Length(p) - 1.0) * (Length(p) - 1.0);
          ++count;
        }
      });
    return std::sqrt(sum / count);
  };
  EXPECT_GT(errorOf(6), 10.0 * errorOf(12));
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, SidesAreAsLongAsAskedFor)
{
  const Stages stages = SphereSlices(5, 12);
  std::size_t before = 0;
  for (const double length : { 0.3, 0.12, 0.06 })
  {
    double longest = 0.0;
    std::size_t points = 0;
    const Index failed = VisitPatches(stages, ExactNormals(stages), { length, 0.0 },
      [&](Index, const PatchBorder& border, const InnerPatch& patch)
      {
        points += patch.Points.size();
        VisitSides(border, patch,
          [&](const Point3& p, const Point3& q) { longest = std::max(longest, Length(q - p)); });
      });
    EXPECT_EQ(failed, 0);
    EXPECT_LT(longest, 2.0 * length);
    EXPECT_GT(points, before);
    before = points;
  }
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, ChordsAreWithinTheTolerance)
{
  const Stages stages = SphereSlices(5, 60);
  for (const double tolerance : { 0.01, 0.003, 0.001 })
  {
    double worst = 0.0;
    Index chords = 0, above = 0;
    VisitPatches(stages, ExactNormals(stages), { 10.0, tolerance },
      [&](Index, const PatchBorder& border, const InnerPatch& patch)
      {
        VisitSides(border, patch,
          [&](const Point3& p, const Point3& q)
          {
            const double off = 0.5 * (Length(p) + Length(q)) - Length(Between(p, q, 0.5));
            worst = std::max(worst, off);
            above += off > tolerance ? 1 : 0;
            ++chords;
          });
      });
    EXPECT_LT(worst, 2.5 * tolerance);
    EXPECT_LT(above, 0.05 * chords);
    EXPECT_GT(worst, 0.2 * tolerance); // no more triangles than that takes
  }
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, EdgeLengthIsTheMostWithATolerance)
{
  const Stages stages = SphereSlices(5, 40);
  const auto pointsOf = [&](const PatchResolution& resolution)
  {
    std::size_t points = 0;
    VisitPatches(stages, ExactNormals(stages), resolution,
      [&](Index, const PatchBorder&, const InnerPatch& patch) { points += patch.Points.size(); });
    return points;
  };
  EXPECT_EQ(pointsOf({ 0.1, 1.0 }), pointsOf({ 0.1, 0.0 }));
  EXPECT_GT(pointsOf({ 0.1, 0.0005 }), pointsOf({ 0.1, 0.0 }));
}

//----------------------------------------------------------------------------
/// The normals of triangles at the border come to those that are given there: both patches beside
/// an arc have one tangent plane.
TEST(SmoothPatch, TrianglesAtTheBorderHaveTheGivenNormals)
{
  const auto errorOf = [](int subdivisions)
  {
    const Stages stages = SphereSlices(6, subdivisions);
    const SurfaceNormals normals = EstimateNormals(stages.Geometry(), 1.05, {}, Execution());
    double sum = 0.0;
    Index count = 0;
    VisitPatches(stages, normals, { 0.1, 0.0 },
      [&](Index, const PatchBorder& border, const InnerPatch& patch)
      {
        for (const auto& t : patch.Triangles)
        {
          for (int k = 0; k < 3; ++k)
          {
            const Index a = t[k], b = t[(k + 1) % 3];
            if (a >= 0 && b >= 0)
            {
              const Point3 p = border.Places[a], q = border.Places[b];
              const Point3 r = PlaceOf(border, patch, t[(k + 2) % 3]);
              const Point3 given = Unit(border.Normals[a] + border.Normals[b]);
              const double turn = Length(Unit(Cross(q - p, r - p)) - given);
              sum += turn * turn;
              ++count;
            }
          }
        }
      });
    return std::sqrt(sum / count);
  };
  const double coarse = errorOf(4), fine = errorOf(40);
  EXPECT_LT(fine, 0.3 * coarse);
  EXPECT_LT(fine, 0.015);
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, OfAFlatBorderIsFlat)
{
  const Stages stages{ Cube() };
  const SurfaceNormals normals = EstimateNormals(stages.Geometry(), 1.05, {}, Execution());
  Index flat = 0;
  VisitPatches(stages, normals, { 0.2, 0.0 },
    [&](Index cycle, const PatchBorder&, const InnerPatch& patch)
    {
      const auto& cell = stages.Cycles.Cell[cycle];
      if (std::count(cell.begin(), cell.end(), 1) != 2)
      {
        return;
      }
      ++flat;
      const int axis = cell[0] != 1 ? 0 : cell[1] != 1 ? 1 : 2;
      for (std::size_t i = 0; i < patch.Points.size(); ++i)
      {
        EXPECT_NEAR(patch.Points[i][axis], cell[axis] == 0 ? 0.5 : 2.5, 1e-7);
        EXPECT_NEAR(patch.Normals[i][axis], cell[axis] == 0 ? -1.0 : 1.0, 1e-6);
      }
    });
  EXPECT_EQ(flat, 6);
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, DeviationTellsCreasesFromSmoothBorders)
{
  const Stages cube{ Cube() }, sphere = SphereSlices(5, 20);
  const auto maxOf = [](const Stages& stages)
  {
    const SurfaceNormals normals = EstimateNormals(stages.Geometry(), 1.05, {}, Execution());
    SmoothPatchBuilder builder(stages.Grid, { 0.1, 0.0 });
    PatchBorder border;
    InnerPatch patch;
    double maximum = 0.0;
    for (Index cycle = 0; cycle < stages.Cycles.Count(); ++cycle)
    {
      border.Set(stages.Geometry(), normals, cycle);
      maximum = builder.Build(border, patch) ? std::max(maximum, builder.Deviation()) : maximum;
    }
    return maximum;
  };
  EXPECT_GT(maxOf(cube), 0.01);
  EXPECT_LT(maxOf(sphere), 0.01);
}

//----------------------------------------------------------------------------
TEST(SmoothPatch, NoneWithoutNormals)
{
  const Stages stages{ Cube() };
  SurfaceNormals normals;
  normals.Normals.assign(3 * static_cast<std::size_t>(stages.Graph.Count()), 0.0f);
  EXPECT_EQ(VisitPatches(stages, normals, { 0.1, 0.0 },
              [](Index, const PatchBorder&, const InnerPatch&) { ADD_FAILURE(); }),
    stages.Cycles.Count());
}
