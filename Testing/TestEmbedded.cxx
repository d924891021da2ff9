// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   guarantee G6: no two triangles meet but in a common edge or vertex
 *
 * Over all shapes in Data, as they are and spoilt in every way that contours are spoilt in
 * practice, in both precisions. Two checkers decide: our own exact one (which also checks G1 to G3)
 * and, where it was found, CGAL; and vertices of the grid have to lie on the side where most slices
 * have them (G3).
 * ORTHOGONAL_SLICES_RUNS is the number of seeds for each; from two on, every shape is taken in both
 * precisions and with 32 planes too.
 */

#include "Support/CheckEmbedding.h"
#include "Support/FilterRun.h"
#include "Support/Perturbations.h"
#include "Support/Random.h"
#include "Support/ReconstructionMesh.h"
#include "Support/ReduceInput.h"
#include "Support/SelfIntersections.h"
#include "Support/Stages.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Change
{
  const char* Name;
  void (*Apply)(Input& input, double spacing, std::uint64_t seed);
};

void PrintTo(const Change& change, std::ostream* os) { *os << change.Name; }

const Change Changes[] = {
  { "AsTheyAre", [](Input&, double, std::uint64_t) {} },
  { "VerticesMovedByUpToATenthSpacing",
    [](Input& input, double h, std::uint64_t seed) { MoveVertices(input.Sets, 0.1 * h, seed); } },
  { "VerticesMovedByUpToASpacing",
    [](Input& input, double h, std::uint64_t seed) { MoveVertices(input.Sets, h, seed); } },
  { "PlanesShiftedByUpToHalfASpacing",
    [](Input& input, double h, std::uint64_t seed) { ShiftPlanes(input.Sets, 0.5 * h, seed); } },
  { "SlicesMovedByUpToASpacing",
    [](Input& input, double h, std::uint64_t seed) { MoveSlices(input.Sets, h, seed); } },
  { "SlicesBentByUpToASpacing",
    [](Input& input, double h, std::uint64_t seed) { BendSlices(input.Sets, h, 5.0 * h, seed); } },
  { "SetsRotatedByOneDegree",
    [](Input& input, double, std::uint64_t) { RotateSets(input.Sets, 1.0); } },
  { "OnePercentDeleted",
    [](Input& input, double, std::uint64_t seed) { DropContours(input.Sets, 0.01, seed); } },
  { "FivePercentDeleted",
    [](Input& input, double, std::uint64_t seed) { DropContours(input.Sets, 0.05, seed); } },
  { "TwentyPercentDeleted",
    [](Input& input, double, std::uint64_t seed) { DropContours(input.Sets, 0.2, seed); } },
  { "HalfDeleted",
    [](Input& input, double, std::uint64_t seed) { DropContours(input.Sets, 0.5, seed); } },
  { "LoopsReversed",
    [](Input& input, double, std::uint64_t seed) { ReverseContours(input.Sets, 0.5, seed); } },
  { "LoopsReversedAsDrawn",
    [](Input& input, double, std::uint64_t seed)
    {
      ReverseContours(input.Sets, 0.2, seed);
      input.Settings.Orient = Orientation::AsDrawn;
    } },
  { "OneFamilyResampledToATenth",
    [](Input& input, double, std::uint64_t seed) { ThinOut(input.Sets[seed % 3], 10); } },
  { "AxesPermuted", [](Input& input, double, std::uint64_t) { PermuteAxes(input.Sets); } },
  { "AxesExchanged", [](Input& input, double, std::uint64_t) { ExchangeXAndY(input.Sets); } },
  { "Mirrored",
    [](Input& input, double, std::uint64_t seed)
    { Mirror(input.Sets, static_cast<int>(seed % 3)); } },
  { "ScaledUp", [](Input& input, double, std::uint64_t) { Scale(input.Sets, 0x1p+40); } },
  { "ScaledDown", [](Input& input, double, std::uint64_t) { Scale(input.Sets, 0x1p-40); } },
  { "AllAtOnce",
    [](Input& input, double h, std::uint64_t seed)
    {
      BendSlices(input.Sets, 0.5 * h, 4.0 * h, seed);
      MoveSlices(input.Sets, h, seed + 1);
      ShiftPlanes(input.Sets, 0.5 * h, seed + 2);
      DropContours(input.Sets, 0.1, seed + 3);
      RotateSets(input.Sets, 3.0);
      MoveVertices(input.Sets, 0.3 * h, seed + 4);
    } },
};

/// Mean distance of the planes of all axes.
double SpacingOf(const PieceSets& sets)
{
  double spacing = 0.0;
  for (const Pieces& pieces : sets)
  {
    const std::set<double> planes(pieces.W.begin(), pieces.W.end());
    spacing += (*planes.rbegin() - *planes.begin()) / (3.0 * (planes.size() - 1.0));
  }
  return spacing;
}

/// The surface encloses what most slices have inside.
void ExpectSides(const Input& input, const TriangleMesh& mesh)
{
  SpatialGrid grid;
  const Contours contours = UsableContours(input.Sets, input.Settings, grid);
  const SideCheck sides = CheckGridVertices(mesh, contours, grid, input.Settings.Orient, 20, 1);
  EXPECT_EQ(sides.Wrong.size(), 0u) << "of " << sides.Compared << " grid vertices";
  EXPECT_GT(sides.Compared, sides.Skipped);
}

/// No surface at all is as wrong as one that crosses itself.
void ExpectEmbedded(const Input& input)
{
  const Reconstruction result = Reconstruct(PieceSets(input.Sets), input.Settings, Execution());
  ASSERT_FALSE(result.Refused);
  const TriangleMesh mesh = MeshOf(result);
  EXPECT_GT(mesh.Triangles.size(), 100u);
  EXPECT_EQ(DescribeFlaws(mesh), "");
  EXPECT_LE(CountSelfIntersections(mesh), 0);
  ExpectSides(input, mesh);
}

Input MakeInput(
  const DataSet& data, int count, bool single, const Change& change, std::uint64_t seed)
{
  Input input;
  input.Name = data.Name + " n" + std::to_string(count) + (single ? ", float" : ", double") +
    ", seed " + std::to_string(seed);
  input.Sets = ReadPieceSets(data, count);
  change.Apply(input, SpacingOf(input.Sets), seed);
  input.Settings.SinglePrecision = single;
  if (single)
  {
    RoundToFloat(input.Sets);
  }
  return input;
}
}

//----------------------------------------------------------------------------
class Embedded : public testing::TestWithParam<Change>
{
};

TEST_P(Embedded, ShapesOfTheDataFolder)
{
  const std::uint64_t runs = RandomRuns(1);
  const std::uint64_t change = static_cast<std::uint64_t>(GetParam().Name[0] + GetParam().Name[8]);
  std::uint64_t number = change;
  for (const DataSet& data : AllDataSets())
  {
    // Another seed for every shape, as some changes choose an axis by it.
    const std::uint64_t first = FirstSeed() + (number - change) * runs;
    for (std::uint64_t seed = first; seed < first + runs; ++seed)
    {
      for (const int count : { 16, 32 })
      {
        for (const bool single : { false, true })
        {
          const bool usual = count == 16 && single == (number % 2 == 0);
          if (usual || runs > 1)
          {
            const Input input = MakeInput(data, count, single, GetParam(), seed + 1);
            SCOPED_TRACE(input.Name);
            ExpectEmbedded(input);
          }
        }
      }
    }
    ++number;
  }
}

INSTANTIATE_TEST_SUITE_P(Data, Embedded, testing::ValuesIn(Changes),
  [](const testing::TestParamInfo<Change>& change) { return std::string(change.param.Name); });

//----------------------------------------------------------------------------
namespace
{
/// One of the six orders of the axes.
void OrderAxes(PieceSets& sets, int order)
{
  for (int i = 0; i < order % 3; ++i)
  {
    PermuteAxes(sets);
  }
  if (order >= 3)
  {
    ExchangeXAndY(sets);
  }
}

/// Mirrors across x, y and z where bits 0, 1 and 2 are set.
void MirrorAxes(PieceSets& sets, int bits)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if ((bits >> axis) & 1)
    {
      Mirror(sets, axis);
    }
  }
}
}

/// Contours of voxels have vertices on planes, and what lies on a plane counts as above it: no two
/// orientations are the same to the reconstruction. Each is taken for one of the label volumes, or
/// for all if there are several runs.
TEST(EmbeddedOrientations, LabelVolumesInAllFortyEight)
{
  int number = 0;
  for (const DataSet& data : AllDataSets())
  {
    for (int orientation = 0; orientation < 48 && !data.Consistent; ++orientation)
    {
      const int order = orientation / 8, mirrors = orientation % 8;
      if (RandomRuns(1) == 1 && (orientation + number) % 2 == 1)
      {
        continue;
      }
      Input input = MakeInput(data, 16, (order + mirrors / 2) % 2 == 1, Changes[0], 0);
      OrderAxes(input.Sets, order);
      MirrorAxes(input.Sets, mirrors);
      SCOPED_TRACE(input.Name + ", orientation " + std::to_string(orientation));
      ExpectEmbedded(input);
    }
    number += data.Consistent ? 0 : 1;
  }
  EXPECT_EQ(number, 2);
}

//----------------------------------------------------------------------------
TEST(EmbeddedFiner, ThirtyTwoPlanesOfLabelsInBothPrecisions)
{
  for (const DataSet& data : AllDataSets())
  {
    if (!data.Consistent)
    {
      for (const bool single : { false, true })
      {
        const Input input = MakeInput(data, 32, single, Changes[0], 0);
        SCOPED_TRACE(input.Name);
        ExpectEmbedded(input);
      }
    }
  }
}

//----------------------------------------------------------------------------
/// Through the filter, with what it writes: points of float or double.
TEST(EmbeddedOutput, OfTheFilterInBothPrecisions)
{
  const DataSet data = AllDataSets()[5];
  PieceSets sets = ReadPieceSets(data, 16);
  MoveVertices(sets, 0.3 * SpacingOf(sets), 1);
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    FilterRun run(sets, Form::ClosedLine, type);
    vtkPolyData* surface = run.Update();
    EXPECT_TRUE(run.Errors.empty());
    EXPECT_EQ(surface->GetPoints()->GetDataType(), type);
    EXPECT_EQ(DescribeFlaws(MeshOf(surface)), "");
  }
}

//----------------------------------------------------------------------------
// The checker itself.

namespace
{
TriangleMesh Soup(const std::vector<Point3>& points)
{
  TriangleMesh mesh;
  mesh.Points = points;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3)
  {
    const auto first = static_cast<std::int64_t>(i);
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return mesh;
}

std::size_t CountMeetings(const TriangleMesh& mesh) { return FindMeetings(mesh, 1000000).size(); }
}

TEST(CheckEmbedding, FindsWhatMeets)
{
  // Through the middle; in one point; in one plane; one in the other; apart in one plane.
  EXPECT_EQ(CountMeetings(Soup(
              { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, -1 }, { 1, 1, 1 }, { 9, 9, 1 } })),
    1u);
  EXPECT_EQ(CountMeetings(Soup(
              { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0 }, { 1, 1, 1 }, { 9, 9, 1 } })),
    1u);
  EXPECT_EQ(CountMeetings(Soup(
              { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 3, 3, 0 }, { 1, 1, 0 }, { 9, 0, 0 } })),
    1u);
  EXPECT_EQ(CountMeetings(Soup(
              { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 } })),
    1u);
  EXPECT_EQ(CountMeetings(Soup(
              { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 4, 4, 0 }, { 1, 4, 0 }, { 4, 1, 0 } })),
    0u);
}

//----------------------------------------------------------------------------
TEST(CheckEmbedding, KnowsCommonEdgesAndVertices)
{
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { 1, 1, 1 } };
  mesh.Triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 5 } };
  EXPECT_EQ(CountMeetings(mesh), 0u);
  mesh.Triangles = { { 0, 1, 2 }, { 1, 0, 4 } }; // folded back
  EXPECT_EQ(CountMeetings(mesh), 1u);
  mesh.Triangles = { { 0, 1, 2 }, { 0, 5, 4 } }; // along a segment from the common vertex
  EXPECT_EQ(CountMeetings(mesh), 1u);
  mesh.Triangles = { { 0, 1, 2 }, { 0, 5, 3 } };
  EXPECT_EQ(CountMeetings(mesh), 0u);
  mesh.Points.push_back(mesh.Points[0]); // the same place is not the same vertex
  mesh.Triangles = { { 0, 1, 2 }, { 6, 5, 3 } };
  EXPECT_EQ(CountMeetings(mesh), 1u);
  mesh.Points.push_back({ 2, 0, 0 });
  mesh.Triangles = { { 0, 7, 1 } };
  EXPECT_EQ(CountMeetings(mesh), 1u);
}

//----------------------------------------------------------------------------
TEST(CheckEmbedding, IsExact)
{
  // 2^-52 beside a plane, at coordinates whose determinant rounds to multiples of 2^-2.
  const Point3 a{ 0x1p+17, 0, 1 }, b{ 0, 0x1p+17, 1 }, c{ 0x1p+17 - 1, 1, 1 };
  const double e = 0x1p-52;
  EXPECT_EQ(ExactOrientation(a, b, { 1, 1, 1 }, { 0x1p+17 - 1, 1, 1 + e }), -1);
  EXPECT_EQ(ExactOrientation(a, b, { 1, 1, 1 }, { 0x1p+17 - 1, 1, 1 - 0.5 * e }), 1);
  EXPECT_EQ(ExactOrientation(a, b, { 1, 1, 1 }, { 0x1p+17 - 1, 1, 1 }), 0);
  EXPECT_EQ(ExactTurn(a, b, c, 2), 0);
  EXPECT_EQ(ExactTurn(a, b, { 0x1p+17 - 1, 1 + e, 1 }, 2), -1);
  EXPECT_EQ(ExactTurn(a, b, { 0x1p+17 - 1, 1 - e, 1 }, 2), 1);
  EXPECT_EQ(ExactOrientation(a, b, { 1, 1, 5 }, a), 0);
  EXPECT_EQ(ExactOrientation({ 0, 0, 0 }, { 1e-60, 0, 0 }, { 0, 1e-60, 0 }, { 0, 0, -1e-60 }),
    ExactOrientation({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 }));
}

//----------------------------------------------------------------------------
TEST(CheckEmbedding, AgreesWithCgal)
{
  if (CountSelfIntersections(TriangleMesh()) < 0)
  {
    GTEST_SKIP() << "CGAL was not found";
  }
  Random random(1);
  for (int run = 0; run < 200; ++run)
  {
    std::vector<Point3> points(3 * 12);
    for (Point3& p : points)
    {
      for (double& x : p)
      {
        x = static_cast<double>(random.Below(run % 2 == 0 ? 5 : 50)) * 0.1;
      }
    }
    const TriangleMesh mesh = Soup(points);
    bool flat = false;
    for (const Meeting& meeting : FindMeetings(mesh, 1000000))
    {
      flat |= meeting.First == meeting.Second;
    }
    if (!flat)
    {
      EXPECT_EQ(static_cast<std::int64_t>(CountMeetings(mesh)), CountSelfIntersections(mesh));
    }
  }
}
