// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   real slices with virtual ones that contradict them in every way
 *
 * Whatever the virtual slices say, the surface is closed and embedded, and contours of real slices
 * that meet no other real ones keep all of their vertices.
 */

#include "Core/CheckInvariants.h"
#include "Support/CheckEmbedding.h"
#include "Support/Perturbations.h"
#include "Support/Random.h"
#include "Support/ReconstructionMesh.h"
#include "Support/SliceSolid.h"
#include "Support/SparseSolids.h"
#include "Support/Stages.h"

#include <gtest/gtest.h>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Ways in which virtual slices are wrong.
enum class Fault
{
  None,      ///< cuts of the solid itself, as exact as its real slices
  Shifted,   ///< by half a spacing within their planes
  Missing,   ///< half of their contours are
  Noisy,     ///< every vertex has moved by up to a spacing
  OfAnother, ///< cuts of another solid
  OfBoth,    ///< cuts of another solid besides those of the solid: they cross
  Count
};

constexpr double Spacing = 0.28;

void Append(const PieceSets& from, PieceSets& sets, bool isVirtual)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Pieces& to = sets[axis];
    to.Virtual.resize(to.Cell.size(), 0);
    for (Index piece = 0; piece < from[axis].Count(); ++piece)
    {
      std::vector<std::array<double, 2>> vertices;
      for (Index i = from[axis].Offsets[piece]; i < from[axis].Offsets[piece + 1]; ++i)
      {
        vertices.push_back({ from[axis].U[i], from[axis].V[i] });
      }
      AddPiece(to, vertices, from[axis].W[from[axis].Offsets[piece]]);
      to.Virtual.push_back(isVirtual ? 1 : 0);
    }
  }
}

/// Planes at equal distances, a little askew, so that no real vertex is within a margin of them.
PlaneSets Between(const Solid& solid, const std::array<int, 3>& count, Random& random)
{
  PlaneSets planes = EqualPlanes(solid, count);
  for (std::vector<double>& set : planes)
  {
    for (double& plane : set)
    {
      plane += random.Uniform(-0.1, 0.1) * Spacing;
    }
  }
  return planes;
}

/// About 24 cells of the in-plane grid along each axis, however many planes there are.
PieceSets Cut(const Solid& solid, const PlaneSets& planes, InPlaneGrid grid)
{
  return SliceByFewPlanes(solid, planes, grid, 24);
}

PieceSets VirtualSlices(
  std::uint64_t seed, const Solid& solid, const PlaneSets& planes, Fault fault)
{
  const auto cut = [&](const Solid& of) { return Cut(of, planes, InPlaneGrid::Free); };
  PieceSets sets = cut(solid);
  const Solid other = RandomSolid(seed + 100000);
  switch (fault)
  {
    case Fault::Shifted:
      MoveSlices(sets, 0.5 * Spacing, seed);
      break;
    case Fault::Missing:
      DropContours(sets, 0.5, seed);
      break;
    case Fault::Noisy:
      MoveVertices(sets, Spacing, seed);
      break;
    case Fault::OfAnother:
      return cut(other);
    case Fault::OfBoth:
      Append(cut(other), sets, true);
      break;
    default:
      break;
  }
  return sets;
}

struct Mixed
{
  explicit Mixed(std::uint64_t seed, const std::array<int, 3>& real, Fault fault)
  {
    Random random(seed);
    const Solid solid = RandomSolid(seed);
    std::array<int, 3> added;
    for (int& n : added)
    {
      n = 3 + static_cast<int>(random.Below(8));
    }
    this->Sets = EmptySets();
    const PlaneSets planes = EqualPlanes(solid, real);
    // Aligned: real families agree to the last bit.
    Append(Cut(solid, planes, InPlaneGrid::Aligned), this->Sets, false);
    Append(VirtualSlices(seed, solid, Between(solid, added, random), fault), this->Sets, true);
  }

  /// Reconstructs, and checks what has to hold between the stages.
  void Run(const Options& options = Options())
  {
    this->Result = Reconstruct(PieceSets(this->Sets), options, Execution(),
      [this](Stage stage, const StageTables& tables, const Reconstruction& result)
      {
        ASSERT_EQ(CheckInvariants(stage, tables, result), "");
        if (stage == Stage::SmoothContours)
        {
          this->Take(tables.Contours);
        }
      });
    this->Mesh = MeshOf(this->Result);
  }

  void Take(const Contours& contours)
  {
    this->Real = Contours();
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      if (contours.IsVirtual(contour))
      {
        continue;
      }
      for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
      {
        this->Real.U.push_back(contours.U[i]);
        this->Real.V.push_back(contours.V[i]);
      }
      this->Real.Offsets.push_back(static_cast<Index>(this->Real.U.size()));
      this->Real.Axis.push_back(contours.Axis[contour]);
      this->Real.Coordinate.push_back(contours.Coordinate[contour]);
    }
  }

  PieceSets Sets;
  Reconstruction Result;
  TriangleMesh Mesh;
  Contours Real;
};
}

//----------------------------------------------------------------------------
/// One stack of real slices among virtual ones of all axes.
TEST(VirtualSlices, NeverChangeAContourOfAStack)
{
  std::int64_t vertices = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(60); ++seed)
  {
    const Fault fault = static_cast<Fault>(seed % static_cast<int>(Fault::Count));
    Mixed input(seed, { 0, 0, 4 + static_cast<int>(seed % 7) }, fault);
    SCOPED_TRACE("seed " + std::to_string(seed));
    input.Run();
    EXPECT_EQ(DescribeFlaws(input.Mesh), "");
    const std::vector<Point3> missing = FindMissingVertices(input.Real, input.Mesh, 0.0);
    EXPECT_EQ(missing.size(), 0u) << "of " << input.Real.U.size() << ", fault "
                                  << static_cast<int>(fault);
    vertices += static_cast<std::int64_t>(input.Real.U.size());
    EXPECT_EQ(input.Result.Reconciled.Vertices, 0);
    EXPECT_EQ(input.Result.Reconciled.Edges, 0);
    EXPECT_EQ(CountDisagreements(input.Result, 0.0), 0);
    for (const Repair& repair : input.Result.Repairs)
    {
      EXPECT_TRUE(repair.Axis < 0 || !input.Result.Grid.IsVirtual(repair.Axis, repair.Plane));
    }
  }
  EXPECT_GT(vertices, 1000);
}

//----------------------------------------------------------------------------
/// The same in single precision, and where the real slices have another orientation.
TEST(VirtualSlices, NeverChangeAContourInSinglePrecision)
{
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(40); ++seed)
  {
    const Fault fault = static_cast<Fault>(seed % static_cast<int>(Fault::Count));
    Mixed input(seed, { 4 + static_cast<int>(seed % 7), 0, 0 }, fault);
    RoundToFloat(input.Sets);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Options options;
    options.SinglePrecision = true;
    options.Orient = seed % 2 == 0 ? Orientation::ByNesting : Orientation::AsDrawn;
    options.Invalid = InvalidContours::LeaveOut;
    input.Run(options);
    ASSERT_FALSE(input.Result.Refused);
    EXPECT_EQ(DescribeFlaws(input.Mesh), "");
    EXPECT_EQ(FindMissingVertices(input.Real, input.Mesh, 0.0).size(), 0u);
  }
}

//----------------------------------------------------------------------------
/// Real slices of two or three families that agree: none of them is changed either.
TEST(VirtualSlices, DoNotChangeRealSlicesThatAgree)
{
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(40); ++seed)
  {
    const Fault fault = static_cast<Fault>(seed % static_cast<int>(Fault::Count));
    const int n = 3 + static_cast<int>(seed % 5);
    Mixed input(seed, { n, seed % 2 == 0 ? 1 : n, n }, fault);
    SCOPED_TRACE("seed " + std::to_string(seed));
    input.Run();
    EXPECT_EQ(DescribeFlaws(input.Mesh), "");
    EXPECT_EQ(FindMissingVertices(input.Real, input.Mesh, 0.0).size(), 0u);
    EXPECT_EQ(input.Result.Reconciled.Vertices, 0);
    EXPECT_EQ(input.Result.Reconciled.Edges, 0);
    EXPECT_EQ(CountDisagreements(input.Result, 1e-12), 0);
  }
}
