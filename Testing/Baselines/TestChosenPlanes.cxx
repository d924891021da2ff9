// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   planes chosen from dense slices, methods turned to other axes, and the table of both
 */

#include "Baselines/CaseFolder.h"
#include "Baselines/ChosenPlanes.h"
#include "Baselines/MethodSummary.h"
#include "Baselines/ParametricMeshes.h"
#include "Baselines/PlanarContours.h"
#include "Baselines/RuledSurface.h"
#include "Support/Vtk/SurfaceMetrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{

//------------------------------------------------------------------------------
SliceSets SliceCapsule(const std::array<int, 3>& numbers)
{
  return CutSurface(MakeCapsule({ -0.5, 0.0, -0.7 }, { 0.5, 0.2, 0.8 }, 0.6, 64), numbers);
}

//------------------------------------------------------------------------------
std::vector<double> CoordinatesOf(const SliceSets& slices, int axis)
{
  std::vector<double> coordinates;
  for (const Slice& slice : ExtractSlices(slices.Families[axis], axis))
  {
    coordinates.push_back(slice.Coordinate);
  }
  return coordinates;
}

} // anonymous namespace

//------------------------------------------------------------------------------
TEST(ChosenPlanes, AreSpreadEvenlyAndKeepTheirContours)
{
  const SliceSets all = SliceCapsule({ 12, 12, 13 });
  const SliceSets chosen = ChoosePlanes(all, { 0, 4, 1 });
  EXPECT_EQ(chosen.Families[0], nullptr);
  const std::vector<double> ys = CoordinatesOf(all, 1);
  EXPECT_EQ(CoordinatesOf(chosen, 1), (std::vector<double>{ ys[1], ys[4], ys[7], ys[10] }));
  EXPECT_EQ(CoordinatesOf(chosen, 2), (std::vector<double>{ CoordinatesOf(all, 2)[6] }));
  const Slice before = ExtractSlices(all.Families[2], 2)[6];
  const Slice after = ExtractSlices(chosen.Families[2], 2)[0];
  EXPECT_EQ(before.Loops, after.Loops);
}

//------------------------------------------------------------------------------
TEST(ChosenPlanes, AllOfThemWhereThereAreNoMore)
{
  const SliceSets all = SliceCapsule({ 5, 5, 5 });
  EXPECT_EQ(CoordinatesOf(ChoosePlanes(all, { 9, 5, 5 }), 0), CoordinatesOf(all, 0));
}

//------------------------------------------------------------------------------
TEST(ChosenPlanes, AnEmptyPlaneBetweenOthersStaysOne)
{
  const auto balls = CutSurface(MakeCapsule({ 0, 0, 0 }, { 0, 0, 1 }, 0.5, 32), { 0, 0, 9 });
  vtkPolyData* family = balls.Families[2];
  family->BuildCells();
  family->DeleteCell(4);
  family->RemoveDeletedCells();
  const SliceSets chosen = ChoosePlanes(balls, { 0, 0, 3 }); // planes 1, 4 and 7
  const std::vector<Slice> slices = ExtractSlices(chosen.Families[2], 2);
  ASSERT_EQ(slices.size(), 3u);
  EXPECT_EQ(slices[0].Loops.size(), 1u);
  EXPECT_TRUE(slices[1].Loops.empty());
  EXPECT_EQ(slices[2].Loops.size(), 1u);
  EXPECT_EQ(CoordinatesOf(ChoosePlanes(balls, { 0, 0, 1 }), 2),
    (std::vector<double>{ CoordinatesOf(balls, 2)[5] }));
}

//------------------------------------------------------------------------------
TEST(ChosenPlanes, WithoutContoursThereIsNoFamily)
{
  const SliceSets none = ChoosePlanes(SliceSets(), { 1, 2, 3 });
  EXPECT_EQ(none.Families[0], nullptr);
  EXPECT_EQ(none.Families[2], nullptr);
}

//------------------------------------------------------------------------------
// The same surface as that of the method itself, given the stack as z-slices.
TEST(AlongMostPlanes, TurnsTheLargestFamilyToZAndTheSurfaceBack)
{
  const RuledSurface::Mode mode = RuledSurface::Mode::PointWalk;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<int, 3> numbers{ 4, 4, 4 };
    numbers[axis] = 10;
    const SliceSets slices = SliceCapsule(numbers);
    const auto surface = AlongMostPlanes(std::make_unique<RuledSurface>(mode)).Reconstruct(slices);
    const Topology shape = MeasureTopology(surface);
    EXPECT_TRUE(shape.IsClosedManifold());
    EXPECT_EQ(shape.Components, 1);

    SliceSets stack;
    stack.Families[2] = RotateAxes(slices.Families[axis], 2 - axis);
    const auto turned = RuledSurface(mode).Reconstruct(stack);
    ASSERT_EQ(surface->GetNumberOfPoints(), turned->GetNumberOfPoints());
    double ours[6], theirs[6];
    surface->GetBounds(ours);
    turned->GetBounds(theirs);
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_EQ(ours[i], theirs[(i + 2 * (2 - axis)) % 6]);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MethodSummary, ComparisonsAreLinesAndMethodsColumns)
{
  std::vector<Row> rows;
  for (const char* comparison : { "z", "xy" })
  {
    for (const char* method : { "a", "b" })
    {
      Row row;
      row.ComparisonName = comparison;
      row.MethodName = method;
      row.Figures = Deviation();
      row.Figures->RootMeanSquare = 0.25;
      row.Figures->NormalDegrees = 7.0;
      row.IsTopologyRight = row.MethodName == "a";
      rows.push_back(row);
    }
  }
  rows.pop_back(); // "b" on "xy"
  std::ostringstream table;
  PrintComparisonTable(rows, table);
  EXPECT_EQ(table.str(),
    "| planes | a | b |\n|---|---|---|\n| z | 0.250 (7°, 1) | 0.250 (7°, 0) |\n"
    "| xy | 0.250 (7°, 1) | - |\n");
}
