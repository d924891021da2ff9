// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/DescribeReport.h"

#include "Bridge/DescribeProblems.h"
#include "Bridge/WriteGraph.h"
#include "Bridge/WriteTables.h"
#include "Core/Cells/DoubtfulJoins.h"
#include "Core/Reconstruct.h"
#include "Support/TextContours.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// The surface of a cube that has nothing to report; tests add what is worth a warning.
class Report : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Result = Reconstruct(ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                                           "z=0: -1,-1 1,-1 1,1 -1,1"),
      Options(), Execution());
    this->Settings.Tolerance = 0.1;
    ASSERT_EQ(this->Text(), "");
  }

  std::string Text() const { return DescribeReport(this->Result, this->Settings); }

  void AddRepair(RepairKind kind) { this->Result.Repairs.push_back({ kind, 2, 0, {}, 1.0 }); }

  Reconstruction Result;
  ReportSettings Settings;
};

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Every message is a paragraph of its own.
std::ptrdiff_t CountMessages(const std::string& text)
{
  return std::count(text.begin(), text.end(), '\n');
}
}

//----------------------------------------------------------------------------
TEST(DescribeProblems, NamesPortCellAndPlaceOfTheFirstTen)
{
  EXPECT_EQ(DescribeProblems({}), "");
  const struct
  {
    ProblemKind Kind;
    const char* Text;
  } kinds[] = { { ProblemKind::NotFinite, "has a coordinate that is not finite" },
    { ProblemKind::OffPlane, "leaves its plane" }, { ProblemKind::Open, "is open" },
    { ProblemKind::CrossesItself, "crosses itself" },
    { ProblemKind::CrossesOther, "crosses another contour of its slice" } };
  for (const auto& kind : kinds)
  {
    const Problem problem{ kind.Kind, 1, 17, Point3{ 1.0, 2.5, -3.0 } };
    EXPECT_EQ(DescribeProblems({ problem }),
      std::string("\n  port 1 (y-slices), cell 17: the contour ") + kind.Text + " at (1, 2.5, -3)");
    const std::string many = DescribeProblems(std::vector<Problem>(12, problem));
    EXPECT_EQ(CountMessages(many), 11);
    EXPECT_TRUE(Contains(many, "\n  and 2 more"));
    EXPECT_FALSE(Contains(DescribeProblems(std::vector<Problem>(10, problem)), "more"));
  }
}

//----------------------------------------------------------------------------
TEST(DescribeMended, CountsEveryKindAndNamesTheFirst)
{
  EXPECT_EQ(DescribeMended({}), "");
  const std::vector<Problem> problems{
    { ProblemKind::GapClosed, 2, 4, Point3{ 1.0, 2.0, 3.0 }, 0.5 },
    { ProblemKind::TooShort, 0, 7, Point3{ 1.0, 0.0, 0.0 }, 0.25, true },
    { ProblemKind::GapClosed, 2, 9, Point3{ 1.0, 2.0, 5.0 }, 0.75 },
  };
  EXPECT_EQ(DescribeMended(problems),
    "\n  1 contour of one or two points that join nothing: left out, of a length of up to 0.25; "
    "port 0 "
    "(x-slices), cell 7, at (1, 0, 0)"
    "\n  2 contours with a gap: closed, the longest gap 0.75; the first: port 2 (z-slices), cell "
    "4, at "
    "(1, 2, 3)");
}

//----------------------------------------------------------------------------
TEST(DescribeMended, HasANameAndWordsOfItsOwnForEveryKind)
{
  std::set<std::string> names, lines;
  for (int kind = 0; kind < ProblemKindCount; ++kind)
  {
    const Problem problem{ static_cast<ProblemKind>(kind), 1, 3, Point3{ 0.0, 1.0, 2.0 } };
    names.insert(NameOf(problem.Kind));
    lines.insert(DescribeMended({ problem }));
    EXPECT_TRUE(Contains(*lines.rbegin(), "port 1 (y-slices), cell 3, at (0, 1, 2)"));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(ProblemKindCount));
  EXPECT_EQ(lines.size(), static_cast<std::size_t>(ProblemKindCount));
  EXPECT_STREQ(NameOf(ProblemKind::NotFinite), "NotFinite");
  EXPECT_STREQ(NameOf(ProblemKind::LeftOpen), "LeftOpen");
  EXPECT_STREQ(NameOf(ProblemKind::DrawnTwice), "DrawnTwice");
}

//----------------------------------------------------------------------------
TEST_F(Report, TellsWhatWasMendedAndListsIt)
{
  this->Result.Mended.push_back(
    { ProblemKind::DrawnTwice, 0, 7, Point3{ 1.0, 0.5, 0.0 }, 0.25, true, 2 });
  EXPECT_TRUE(Contains(this->Text(), "The input was mended"));
  EXPECT_TRUE(Contains(this->Text(), "port 0 (z-slices), cell 7"));
  EXPECT_EQ(CountMessages(this->Text()), 2);
  this->Result.Invalid.push_back({ ProblemKind::Open, 1, 8, Point3{} });
  vtkNew<vtkTable> table;
  WriteProblemTable(this->Result, table);
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  const std::pair<const char*, vtkVariant> expected[] = { { "Port", 0 }, { "Cell", 7 },
    { "SliceAxis", 2 }, { "Kind", 15 }, { "KindName", "DrawnTwice" }, { "LeftOut", 1 },
    { "X", 1.0 }, { "Y", 0.5 }, { "Z", 0.0 }, { "Size", 0.25 } };
  for (const auto& value : expected)
  {
    EXPECT_EQ(table->GetValueByName(0, value.first), value.second) << value.first;
  }
  EXPECT_EQ(table->GetValueByName(1, "KindName").ToString(), "Open");
}

//----------------------------------------------------------------------------
TEST_F(Report, NamesContoursThatWereLeftOut)
{
  this->Result.Invalid.resize(1);
  this->Result.Invalid[0].Kind = ProblemKind::Open;
  EXPECT_TRUE(Contains(this->Text(), "1 contours were left out:\n  port 0"));
  EXPECT_EQ(CountMessages(this->Text()), 2);
}

//----------------------------------------------------------------------------
TEST_F(Report, SaysWhatBecameOfContoursThatCross)
{
  this->Result.CrossingProblems.resize(1);
  this->Result.CrossingProblems[0].Kind = ProblemKind::CrossesItself;
  EXPECT_TRUE(Contains(this->Text(), "1 contours cross and were repaired:"));
  this->Settings.RepairsCrossing = false;
  EXPECT_TRUE(Contains(this->Text(), "1 contours cross and were left out:"));
}

//----------------------------------------------------------------------------
TEST_F(Report, CountsPlacesWhereContoursWereTakenApart)
{
  this->AddRepair(RepairKind::ArcsRedrawn);
  this->AddRepair(RepairKind::ArcsReconnected);
  this->AddRepair(RepairKind::ArcsUncrossed);
  EXPECT_TRUE(Contains(this->Text(), "taken apart, at 3 places"));
  EXPECT_EQ(CountMessages(this->Text()), 1);
}

//----------------------------------------------------------------------------
TEST_F(Report, PatchesThatWereSeparatedAreNotWorthAWarning)
{
  this->AddRepair(RepairKind::PatchesSeparated);
  EXPECT_EQ(this->Text(), "");
}

//----------------------------------------------------------------------------
TEST_F(Report, NamesTheSliceThatWasOverruledMost)
{
  this->Result.Reconciled.Vertices = 3;
  this->Result.Reconciled.Edges = 5;
  EXPECT_EQ(this->Text(), "") << "none of them above the tolerance";
  this->AddRepair(RepairKind::VertexRelabelled);
  this->AddRepair(RepairKind::VertexRelabelled);
  this->AddRepair(RepairKind::CrossingsSnipped);
  const std::string text = this->Text();
  EXPECT_TRUE(Contains(text,
    "contradict each other at 3 grid vertices and on 5 grid edges, where they were reconciled."));
  EXPECT_TRUE(Contains(text, "overruled: the slice z = 0, at 2 grid vertices"));
  EXPECT_EQ(CountMessages(text), 1);
}

//----------------------------------------------------------------------------
TEST_F(Report, WhatThereIsNoneOfIsNotCounted)
{
  this->AddRepair(RepairKind::VertexRelabelled);
  this->Result.Reconciled.Vertices = 3;
  EXPECT_TRUE(Contains(
    this->Text(), "contradict each other at 3 grid vertices, where they were reconciled."));
  this->Result.Reconciled.Vertices = 0;
  this->Result.Reconciled.Edges = 5;
  EXPECT_TRUE(
    Contains(this->Text(), "contradict each other on 5 grid edges, where they were reconciled."));
}

//----------------------------------------------------------------------------
TEST_F(Report, DisagreementsCountAboveTheTolerance)
{
  // The z-slice reaches 0.5 farther along +y than the x-slice.
  this->Result = Reconstruct(ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                                         "z=0: -1,-1 1,-1 1,1.5 -1,1.5"),
    Options(), Execution());
  this->Settings.Tolerance = 0.49;
  EXPECT_TRUE(
    Contains(this->Text(), "contradict each other by more than 0.49 at 1 of 6 node points."));
  EXPECT_TRUE(Contains(this->Text(), "Least agreement: the slice x = 0"));
  this->Settings.Tolerance = 0.51;
  EXPECT_EQ(this->Text(), "");
}

//----------------------------------------------------------------------------
TEST_F(Report, SaysThatTheSurfaceIsInsideOut)
{
  this->Result.InsideOut = true;
  EXPECT_TRUE(Contains(this->Text(), "inside out"));
}

//----------------------------------------------------------------------------
TEST_F(Report, CountsPatchesBetweenPlanesTooClose)
{
  this->Result.DoubtfulCycles = 7;
  EXPECT_TRUE(Contains(this->Text(), "that 7 patches between them may touch"));
}

//----------------------------------------------------------------------------
TEST_F(Report, CountsContoursThatTakeNoPart)
{
  Options options;
  options.MinIsolatedContour = 0.2;
  this->Result =
    Reconstruct(ParsePieces("z=0: 0,0 9,0 9,9 0,9; z=1: 0,0 9,0 9,9 0,9; z=2: 4,4 5,4 5,5 4,5"),
      options, Execution());
  EXPECT_TRUE(Contains(this->Text(), "1 contours without node points"));
}

//----------------------------------------------------------------------------
TEST_F(Report, NamesADoubtAndTheSliceThatSettlesIt)
{
  // Two stacks of squares side by side.
  this->Result = Reconstruct(ParsePieces("z=0: 0,0 2,0 2,2 0,2; z=0: 5,0 7,0 7,2 5,2\n"
                                         "z=1: 0,0 2,0 2,2 0,2; z=1: 5,0 7,0 7,2 5,2"),
    Options(), Execution());
  ASSERT_FALSE(this->Result.Joins.empty());
  for (CycleJoin& join : this->Result.Joins)
  {
    join.Evidence = 5.0;
  }
  const CycleGeometry geometry = GeometryOf(this->Result);
  const auto findDoubts = [&]
  {
    this->Result.Doubtful =
      FindUndecidedPlaces(geometry, FindDoubtfulJoins(geometry, this->Result.Joins), 1);
  };
  findDoubts();
  EXPECT_EQ(this->Text(), "");
  this->Result.Joins.front().Evidence = 0.1;
  this->Result.Joins.front().Chosen = true;
  findDoubts();
  const std::string text = this->Text();
  EXPECT_TRUE(Contains(text, "At 1 place the slices hardly say")) << text;
  EXPECT_TRUE(Contains(text, "would settle 1 of them")) << text;
  EXPECT_EQ(CountMessages(text), 1);
}

//----------------------------------------------------------------------------
TEST_F(Report, ComparesTheTopologyWithWhatIsExpected)
{
  this->Settings.Expected = { 1, 0 };
  EXPECT_EQ(this->Text(), "");
  this->Settings.Expected = { 2, 3 };
  EXPECT_TRUE(Contains(this->Text(), "has 1 components, not 2 as expected"));
  EXPECT_TRUE(Contains(this->Text(), "has genus 0, not 3 as expected"));
  EXPECT_EQ(CountMessages(this->Text()), 2);
}

//----------------------------------------------------------------------------
namespace
{
/// A square on z = 0 and virtual slices through it that contradict each other and the square.
Reconstruction WithVirtualSlices(bool areVirtual)
{
  PieceSets sets = ParsePieces("x=0: -1,-1 3,-1 3,1 -1,1; y=0: -1,-1 1,-1 1,2 -1,2\n"
                               "z=0: -1,-1 1,-1 1,1 -1,1; x=0.5: 5,5 6,5 6,6 5,6");
  if (areVirtual)
  {
    sets[0].Virtual.assign(2, 1);
    sets[1].Virtual.assign(1, 1);
  }
  return Reconstruct(std::move(sets), Options(), Execution());
}
}

/// The report is about the input: what virtual slices contradict is none of its business.
TEST(DescribeReport, SaysNothingOfVirtualSlices)
{
  ReportSettings settings;
  settings.Tolerance = 0.1;
  EXPECT_NE(DescribeReport(WithVirtualSlices(false), settings), "");
  EXPECT_EQ(DescribeReport(WithVirtualSlices(true), settings), "");
}

/// The flag is there for every cell and every row, but only if there are virtual slices.
TEST(WriteGraph, TellsRealSlicesFromVirtualOnes)
{
  for (const bool areVirtual : { false, true })
  {
    const Reconstruction result = WithVirtualSlices(areVirtual);
    vtkNew<vtkPolyData> graph;
    WriteGraph(result, Execution(), true, graph);
    vtkNew<vtkTable> slices, contours;
    WriteSliceTable(result, slices);
    WriteContourTable(result, contours);
    EXPECT_EQ(contours->GetNumberOfRows(), areVirtual ? 1 : 4);
    vtkDataArray* flag = graph->GetCellData()->GetArray("Virtual");
    ASSERT_EQ(flag != nullptr, areVirtual);
    ASSERT_EQ(slices->GetColumnByName("Virtual") != nullptr, areVirtual);
    if (!areVirtual)
    {
      continue;
    }
    ASSERT_EQ(flag->GetNumberOfTuples(), graph->GetNumberOfCells());
    vtkDataArray* axis = graph->GetCellData()->GetArray("SliceAxis");
    for (vtkIdType cell = graph->GetNumberOfVerts(); cell < graph->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(flag->GetTuple1(cell), axis->GetTuple1(cell) == 2 ? 0.0 : 1.0);
    }
    ASSERT_EQ(slices->GetNumberOfRows(), 4);
    for (vtkIdType row = 0; row < 4; ++row)
    {
      EXPECT_EQ(slices->GetValueByName(row, "Virtual").ToInt(), row == 3 ? 0 : 1);
    }
  }
}
