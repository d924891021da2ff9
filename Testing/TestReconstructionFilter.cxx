// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   vtkOrthogonalSliceReconstruction as VTK users expect it
 */

#include "Bridge/ExecuteWithVtk.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/RandomInput.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCutter.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExtractVOI.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges2D.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMarchingSquares.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <thread>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A run on text, x-, y- and z-slices together.
struct TextRun : FilterRun
{
  explicit TextRun(const std::string& text)
    : FilterRun(ParsePieces(text))
  {
  }
};

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

vtkTable* TableOf(vtkOrthogonalSliceReconstruction* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

void ExpectEmptyOutputs(vtkOrthogonalSliceReconstruction* filter)
{
  for (vtkPolyData* output : { filter->GetOutput(), filter->GetGraphOutput() })
  {
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetNumberOfCells(), 0);
  }
  for (int port = 2; port < 7; ++port)
  {
    EXPECT_EQ(TableOf(filter, port)->GetNumberOfRows(), 0);
  }
}

/// The input is refused with a message that has all these parts.
void ExpectRefused(const std::string& text, const std::vector<std::string>& parts)
{
  SCOPED_TRACE(text);
  TextRun run(text);
  run.Filter->SetInvalidContoursToRefuse();
  run.Filter->SetCrossingContoursToRefuse();
  run.Update();
  ASSERT_GE(run.Errors.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_TRUE(Contains(run.Errors[0], part)) << run.Errors[0] << "\nhas no \"" << part << "\"";
  }
  ExpectEmptyOutputs(run.Filter);
}

/// A realistic input with contradictions, isolated contours and several components.
PieceSets Stomach() { return ReadPieceSets({ "lbl_stomach", 1, 0, false }, 32); }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, HasFourOptionalInputsAndEightOutputs)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  EXPECT_EQ(filter->GetNumberOfInputPorts(), 4);
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 8);
  for (int port = 0; port < 4; ++port)
  {
    vtkInformation* info = filter->GetInputPortInformation(port);
    EXPECT_STREQ(info->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE()), "vtkPolyData");
    EXPECT_EQ(info->Get(vtkAlgorithm::INPUT_IS_OPTIONAL()), 1);
  }
  TextRun run{ Cube() };
  run.Update();
  EXPECT_NE(run.Filter->GetGraphOutput(), nullptr);
  EXPECT_NE(run.Filter->GetHistogramOutput(), nullptr);
  EXPECT_EQ(run.Filter->GetOutputDataObject(1), run.Filter->GetGraphOutput());
  EXPECT_EQ(run.Filter->GetOutputDataObject(2), run.Filter->GetHistogramOutput());
  for (int port = 2; port < 7; ++port)
  {
    EXPECT_NE(vtkTable::SafeDownCast(run.Filter->GetOutputDataObject(port)), nullptr);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, DefaultsAndRanges)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  EXPECT_EQ(filter->GetPlaneTolerance(), 1e-5);
  EXPECT_EQ(filter->GetOrientation(), vtkOrthogonalSliceReconstruction::ORIENT_BY_NESTING);
  EXPECT_EQ(filter->GetInvalidContours(), vtkOrthogonalSliceReconstruction::MEND);
  EXPECT_EQ(filter->GetBorderContours(), vtkOrthogonalSliceReconstruction::CLOSE_ALONG_BORDER);
  EXPECT_LT(filter->GetBorderBounds()[1], filter->GetBorderBounds()[0]);
  EXPECT_EQ(filter->GetCrossingContours(), vtkOrthogonalSliceReconstruction::REPAIR_CROSSING);
  EXPECT_EQ(filter->GetLoopRule(), vtkOrthogonalSliceReconstruction::UNION);
  EXPECT_EQ(filter->GetRedrawnTolerance(), 0.05);
  EXPECT_EQ(filter->GetCentralPoint(), vtkOrthogonalSliceReconstruction::LEAST_SQUARES);
  EXPECT_TRUE(filter->GetComputeNormals());
  EXPECT_EQ(filter->GetOutputPointsPrecision(), vtkAlgorithm::DEFAULT_PRECISION);
  filter->SetPlaneTolerance(-1.0);
  EXPECT_EQ(filter->GetPlaneTolerance(), 0.0);
  filter->SetPlaneTolerance(7.0);
  EXPECT_EQ(filter->GetPlaneTolerance(), 0.1);
  filter->SetOrientation(9);
  EXPECT_EQ(filter->GetOrientation(), vtkOrthogonalSliceReconstruction::ORIENT_AS_DRAWN);
  filter->SetInvalidContours(9);
  EXPECT_EQ(filter->GetInvalidContours(), vtkOrthogonalSliceReconstruction::MEND);
  filter->SetBorderContours(9);
  EXPECT_EQ(filter->GetBorderContours(), vtkOrthogonalSliceReconstruction::REFUSE_AT_BORDER);
  filter->SetCrossingContours(9);
  EXPECT_EQ(filter->GetCrossingContours(), vtkOrthogonalSliceReconstruction::LEAVE_OUT_CROSSING);
  filter->SetLoopRule(9);
  EXPECT_EQ(filter->GetLoopRule(), vtkOrthogonalSliceReconstruction::NON_ZERO);
  filter->SetRedrawnTolerance(2.0);
  EXPECT_EQ(filter->GetRedrawnTolerance(), 0.5);
  filter->SetCentralPoint(-3);
  EXPECT_EQ(filter->GetCentralPoint(), vtkOrthogonalSliceReconstruction::LEAST_SQUARES);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, EverySetterChangesTheTimeOnlyIfTheValueChanges)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  const std::vector<std::function<void()>> changes{
    [&] { filter->SetPlaneTolerance(0.01); },
    [&] { filter->SetOrientationToAsDrawn(); },
    [&] { filter->SetInvalidContoursToLeaveOut(); },
    [&] { filter->SetInvalidContoursToRefuse(); },
    [&] { filter->SetInvalidContoursToMend(); },
    [&] { filter->SetBorderContoursToLeaveOpen(); },
    [&] { filter->SetBorderContoursToRefuse(); },
    [&] { filter->SetBorderContoursToCloseAlongBorder(); },
    [&] { filter->SetBorderBounds(0.0, 4.0, 0.0, 3.0, 0.0, 2.0); },
    [&] { filter->SetCrossingContoursToRefuse(); },
    [&] { filter->SetCrossingContoursToLeaveOut(); },
    [&] { filter->SetLoopRuleToEvenOdd(); },
    [&] { filter->SetLoopRuleToNonZero(); },
    [&] { filter->SetRedrawnTolerance(0.0); },
    [&] { filter->SetCentralPointToCentroid(); },
    [&] { filter->SetFrameToGiven(); },
    [&] { filter->SetFrameToWorld(); },
    [&] { filter->SetFrameToAutomatic(); },
    [&]
    {
      const double normals[9] = { 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0 };
      filter->SetFrameNormals(normals);
    },
    [&] { filter->SetAxisWeights(1.0, 2.0, 1.0); },
    [&] { filter->SetReportTolerance(0.01); },
    [&] { filter->ComputeNormalsOff(); },
    [&] { filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    SCOPED_TRACE(i);
    const vtkMTimeType before = filter->GetMTime();
    changes[i]();
    const vtkMTimeType after = filter->GetMTime();
    EXPECT_GT(after, before);
    changes[i]();
    EXPECT_EQ(filter->GetMTime(), after);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, PrintsEveryProperty)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  filter->SetInvalidContoursToLeaveOut();
  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "PlaneTolerance: 1e-05", "Orientation: ", "InvalidContours: LeaveOut",
         "BorderContours: CloseAlongBorder", "BorderBounds: 0 -1 0 -1 0 -1",
         "CrossingContours: ", "LoopRule: Union", "RedrawnTolerance: 0.05", "Frame: Automatic",
         "FrameNormals: 1 0 0 0 1 0 0 0 1", "CentralPoint: ", "AxisWeights: 1 1 1",
         "ReportTolerance: 0.001", "WarnOfMissingFamilies: Off",
         "ComputeNormals: ", "OutputPointsPrecision: " })
  {
    EXPECT_TRUE(Contains(text.str(), name)) << name;
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, EmptyPortIsAnAbsentOne)
{
  for (int port = 0; port < 3; ++port)
  {
    SCOPED_TRACE(port);
    TextRun run{ Cube() }, without{ Cube() };
    vtkNew<vtkPolyData> empty;
    run.Filter->SetInputData(port, empty);
    without.Filter->SetInputConnection(port, nullptr);
    const vtkIdType cells = run.Update()->GetNumberOfCells();
    EXPECT_TRUE(run.Errors.empty());
    EXPECT_GT(cells, 0);
    EXPECT_EQ(cells, without.Update()->GetNumberOfCells());
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, PointsWithoutLinesAreNoContours)
{
  FilterRun run;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 1);
  const vtkIdType id = 0;
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(1, &id);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  run.Filter->SetInputData(2, data);
  run.Update();
  ASSERT_GE(run.Errors.size(), 1u);
  EXPECT_TRUE(Contains(run.Errors[0], "no contours")) << run.Errors[0];
  ExpectEmptyOutputs(run.Filter);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, NoInputIsAnError)
{
  TextRun run{ Cube() };
  for (int port = 0; port < 3; ++port)
  {
    run.Filter->SetInputConnection(port, nullptr);
  }
  run.Update();
  ASSERT_GE(run.Errors.size(), 1u); // a second one is VTK's own
  EXPECT_TRUE(Contains(run.Errors[0], "No input")) << run.Errors[0];
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, OneFamilyOrTwoWillDo)
{
  for (int connected = 1; connected < 7; ++connected) // bits 0, 1, 2: ports
  {
    SCOPED_TRACE(connected);
    TextRun run{ Cube() };
    for (int port = 0; port < 3; ++port)
    {
      if (((connected >> port) & 1) == 0)
      {
        run.Filter->SetInputConnection(port, nullptr);
      }
    }
    vtkPolyData* surface = run.Update();
    EXPECT_TRUE(run.Errors.empty());
    const SurfaceCheck check = CheckSurface(MeshOf(surface));
    EXPECT_TRUE(check.IsClosedManifold()) << check;
    EXPECT_EQ(check.Components, 1);
    EXPECT_EQ(check.TotalGenus(), 0);
    // 2 x 2 x 1 between the slices of one family; smooth patches round the edges off a little.
    EXPECT_GT(check.TotalVolume(), 3.95);
    EXPECT_EQ(FieldValue(surface, "TotalGenus"), 0);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, UnusableContoursAreNamedWithPortCellAndCoordinate)
{
  ExpectRefused(
    Cube() + "x=1: 0.6,0.6 nan,1 1,1", { "port 0", "x-slices", "cell 2", "finite", "nan, 1)" });
  ExpectRefused(Cube() + "y=1.5 open: 3,4 8,9; y=1.5 open: 8,9 20,21",
    { "port 1", "y-slices", "open", "1.5, " });
  ExpectRefused(Cube() + "z=1: 5,5 6,5,1.25 6,6",
    { "port 2", "z-slices", "cell 2", "leaves its plane", "(6, 5, 1.25)" });
  ExpectRefused(Cube() + "z=7: 5,5 6,6 6,5 5,6", { "port 2", "cell 2", "crosses itself", ", 7)" });
  ExpectRefused(Cube() + "x=2: 2,2 3,2 3,3 2,3", { "port 0", "cell 2", "crosses another", "(2, " });
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, CellNumbersAreThoseOfThePolyData)
{
  // Vertices come first, then lines, then polygons.
  TextRun run{ Cube() };
  vtkSmartPointer<vtkPolyData> data = MakePolyData(
    ParsePieces("z=1: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5; z=2: 5,5 6,6 6,5 5,6")[2], Form::Polygon);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType id = 0; id < 3; ++id)
  {
    vertices->InsertNextCell(1, &id);
  }
  data->SetVerts(vertices);
  run.Filter->SetInputData(2, data);
  run.Filter->SetCrossingContoursToRefuse();
  run.Update();
  ASSERT_GE(run.Errors.size(), 1u);
  EXPECT_TRUE(Contains(run.Errors[0], "cell 4")) << run.Errors[0];
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, ManyProblemsAreCountedAndTheFirstListed)
{
  std::string text = Cube();
  for (int i = 0; i < 25; ++i)
  {
    text += "z=9: " + std::to_string(4 * i) + ",0 nan,1 1,1\n";
  }
  TextRun run{ text };
  run.Filter->SetInvalidContoursToRefuse();
  run.Update();
  ASSERT_GE(run.Errors.size(), 1u);
  EXPECT_TRUE(Contains(run.Errors[0], "25")) << run.Errors[0];
  EXPECT_TRUE(Contains(run.Errors[0], "15 more")) << run.Errors[0];
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, OutputsAreEmptiedByAnErrorAndFilledAgain)
{
  FilterRun run(ParsePieces(Cube()));
  run.Filter->SetCrossingContoursToRefuse();
  const vtkIdType cells = run.Update()->GetNumberOfCells();
  EXPECT_GT(cells, 0);
  run.SetInputs(ParsePieces(Cube() + "z=7: 5,5 6,6 6,5 5,6"));
  run.Update();
  ExpectEmptyOutputs(run.Filter);
  run.SetInputs(ParsePieces(Cube()));
  EXPECT_EQ(run.Update()->GetNumberOfCells(), cells);
  EXPECT_TRUE(run.Errors.empty());
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, ConnectsFamiliesByNumber)
{
  FilterRun run;
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(vtkNew<vtkPolyData>());
  for (const int family : { 1, 2, 3, 4 })
  {
    run.Filter->SetFamilyConnection(family, producer->GetOutputPort());
    EXPECT_EQ(run.Filter->GetInputConnection(family - 1, 0), producer->GetOutputPort());
    EXPECT_EQ(run.Filter->GetTotalNumberOfInputConnections(), 1);
    run.Filter->SetFamilyConnection(family, nullptr);
    EXPECT_EQ(run.Filter->GetTotalNumberOfInputConnections(), 0);
  }
  run.Filter->SetContoursConnection(producer->GetOutputPort());
  EXPECT_EQ(run.Filter->GetInputConnection(3, 0), producer->GetOutputPort());
  run.Filter->SetContoursConnection(nullptr);
  EXPECT_EQ(run.Filter->GetTotalNumberOfInputConnections(), 0);
  EXPECT_TRUE(run.Errors.empty());
  for (const int family : { -1, 0, 5 })
  {
    run.Filter->SetFamilyConnection(family, producer->GetOutputPort());
    EXPECT_EQ(run.Filter->GetTotalNumberOfInputConnections(), 0);
  }
  ASSERT_EQ(run.Errors.size(), 3u);
  EXPECT_TRUE(Contains(run.Errors[0], "Family -1")) << run.Errors[0];
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, LeavesOutUnusableContoursWithOneWarning)
{
  TextRun run{ Cube() + "z=1: 5,5 6,6 6,5 5,6; x=1: 0.6,0.6 nan,1 1,1; y=7 open: 3,4 8,9" };
  run.Filter->SetInvalidContoursToLeaveOut();
  run.Filter->SetCrossingContoursToLeaveOut();
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty());
  ASSERT_EQ(run.Warnings.size(), 1u);
  for (const char* part : { "port 0", "port 1", "port 2", "cell 2", "open", "finite", "itself" })
  {
    EXPECT_TRUE(Contains(run.Warnings[0], part)) << run.Warnings[0];
  }
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(FieldValue(surface, "NumberOfContours"), 6);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, MendsContoursWithOneWarningAndATable)
{
  // A segment that joins nothing, a flat loop, and one that is not finite.
  TextRun run{ Cube() + "y=1.5 open: 3,4 8,9; z=1: 5,5 6,6 8,8; x=1: 0.6,0.6 nan,1 1,1" };
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty());
  ASSERT_EQ(run.Warnings.size(), 1u);
  for (const char* part : { "mended", "1 contour of one or two points", "1 contour without area",
         "not finite", "port 0 (x-slices), cell 2", "port 1 (y-slices), cell 2", "(5, 5, 1)" })
  {
    EXPECT_TRUE(Contains(run.Warnings[0], part)) << run.Warnings[0];
  }
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(FieldValue(surface, "NumberOfContours"), 6);
  vtkTable* table = run.Filter->GetProblemTable();
  ASSERT_EQ(table, run.Filter->GetOutputDataObject(6));
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  for (vtkIdType row = 0; row < 3; ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, "LeftOut").ToInt(), 1);
    EXPECT_EQ(table->GetValueByName(row, "Cell").ToInt(), 2);
  }
  // What is left of it says the same as the cube alone.
  TextRun alone{ Cube() };
  EXPECT_EQ(alone.Update()->GetNumberOfPoints(), surface->GetNumberOfPoints());
  EXPECT_EQ(alone.Filter->GetProblemTable()->GetNumberOfRows(), 0);
}

//----------------------------------------------------------------------------
namespace
{
/// Edges of one triangle that do not lie on a plane.
int CountOpenEdgesOff(const TriangleMesh& mesh, int axis, double coordinate)
{
  std::map<std::pair<std::int64_t, std::int64_t>, int> edges;
  for (const auto& triangle : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::int64_t a = triangle[i], b = triangle[(i + 1) % 3];
      ++edges[{ std::min(a, b), std::max(a, b) }];
    }
  }
  return static_cast<int>(std::count_if(edges.begin(), edges.end(),
    [&](const auto& edge)
    {
      return edge.second == 1 &&
        (mesh.Points[edge.first.first][axis] != coordinate ||
          mesh.Points[edge.first.second][axis] != coordinate);
    }));
}
}

TEST(ReconstructionFilter, ContoursThatEndAtTheBorderAreClosedOrRefused)
{
  // A square bar that the image cuts off at x = 3. With few points it would be taken for complete.
  const auto wall = [](const std::string& before, const std::string& after, bool forth)
  {
    std::string points;
    for (int i = 0; i <= 10; ++i)
    {
      points += before + std::to_string(0.3 * (forth ? i : 10 - i)) + after + " ";
    }
    return points;
  };
  std::string text = "x=1: 0.5,1 2.5,1 2.5,2 0.5,2; x=2: 0.5,1 2.5,1 2.5,2 0.5,2";
  for (const char* plane : { "1", "2" })
  {
    text += std::string("; y=") + plane + " open: " + wall("1,", "", false) + "1.3,0 1.5,0 1.7,0 " +
      wall("2,", "", true);
  }
  for (const char* plane : { "1.2", "1.8" })
  {
    text += std::string("; z=") + plane + " open: " + wall("", ",0.5", false) + "0,1 0,1.5 0,2 " +
      wall("", ",2.5", true);
  }
  TextRun run{ text };
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty());
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_TRUE(Contains(run.Warnings[0], "4 contours that end at the border of the image"))
    << run.Warnings[0];
  EXPECT_TRUE(CheckSurface(MeshOf(surface)).IsClosedManifold());
  double bounds[6];
  surface->GetBounds(bounds);
  EXPECT_GE(bounds[1], 3.0);
  EXPECT_LE(bounds[1], 3.02) << "nothing beyond the border but two hundredths of a spacing";
  EXPECT_EQ(run.Filter->GetProblemTable()->GetNumberOfRows(), 4);
  TextRun given{ text };
  given.Filter->SetBorderBounds(-1.0, 2.0, 0.0, -1.0, 0.0, -1.0); // no contour ends there
  given.Update();
  for (const std::string& warning : given.Warnings)
  {
    EXPECT_FALSE(Contains(warning, "border of the image")) << warning;
  }
  given.Filter->SetBorderBounds(-1.0, 3.0, 0.0, -1.0, 0.0, -1.0);
  EXPECT_EQ(MeshOf(given.Update()).Points, MeshOf(surface).Points);
  TextRun open{ text };
  open.Filter->SetBorderContoursToLeaveOpen();
  surface = open.Update();
  ASSERT_EQ(open.Warnings.size(), 1u);
  EXPECT_TRUE(Contains(open.Warnings[0], "left open")) << open.Warnings[0];
  surface->GetBounds(bounds);
  EXPECT_EQ(bounds[1], 3.0);
  const TriangleMesh mesh = MeshOf(surface);
  const SurfaceCheck check = CheckSurface(mesh);
  EXPECT_GT(check.OpenEdges, 8);
  EXPECT_EQ(check.CrowdedEdges + check.InconsistentEdges + check.DegenerateTriangles, 0);
  EXPECT_EQ(check.UnusedPoints, 0);
  EXPECT_TRUE(FindMeetings(mesh).empty());
  EXPECT_EQ(CountOpenEdgesOff(mesh, 0, 3.0), 0);
  EXPECT_EQ(
    surface->GetPointData()->GetNormals()->GetNumberOfTuples(), surface->GetNumberOfPoints());
  EXPECT_EQ(
    surface->GetCellData()->GetArray("GridCell")->GetNumberOfTuples(), surface->GetNumberOfCells());
  TextRun refused{ text };
  refused.Filter->SetBorderContoursToRefuse();
  refused.Update();
  ASSERT_GE(refused.Errors.size(), 1u);
  EXPECT_TRUE(Contains(refused.Errors[0], "is open")) << refused.Errors[0];
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, RepairsCrossingContoursWithOneWarning)
{
  // A second square of the same slice crosses the first one; then a contour that crosses itself.
  for (const auto& [more, kind] :
    { std::make_pair("z=1: 2,2 2.8,2 2.8,2.8 2,2.8", "overlap others"),
      std::make_pair("z=1.5: 0.5,0.5 2.5,2.5 2.5,0.5 0.5,2.5", "cross themselves") })
  {
    SCOPED_TRACE(more);
    TextRun run{ Cube() + more };
    vtkPolyData* surface = run.Update();
    EXPECT_TRUE(run.Errors.empty());
    ASSERT_EQ(run.Warnings.size(), 1u);
    EXPECT_TRUE(Contains(run.Warnings[0], "port 2 (z-slices), cell ")) << run.Warnings[0];
    EXPECT_TRUE(Contains(run.Warnings[0], kind)) << run.Warnings[0];
    const SurfaceCheck check = CheckSurface(MeshOf(surface));
    EXPECT_TRUE(check.IsClosedManifold()) << check;
    EXPECT_GT(check.Components, 0);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, SaysNothingAboutSlicesThatAgree)
{
  TextRun run{ Cube() };
  run.Update();
  EXPECT_TRUE(run.Errors.empty());
  EXPECT_TRUE(run.Warnings.empty());
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, WarnsOnceOfContradictionsAndContoursLeftOut)
{
  FilterRun run(Stomach());
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty());
  ASSERT_EQ(run.Warnings.size(), 1u);
  for (const char* name :
    { "NumberOfReconciledVertices", "NumberOfReconciledEdges", "NumberOfContoursLeftOut" })
  {
    EXPECT_GT(FieldValue(surface, name), 0) << name;
    EXPECT_TRUE(Contains(run.Warnings[0], std::to_string(FieldValue(surface, name)))) << name;
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, ProgressRisesToOne)
{
  FilterRun run(Stomach());
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&progress);
  command->SetCallback([](vtkObject*, unsigned long, void* list, void* value)
    { static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(value)); });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, command);
  run.Update();
  ASSERT_GE(progress.size(), 5u);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_GE(progress.front(), 0.0);
  EXPECT_EQ(progress.back(), 1.0);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, AbortsAtAnyProgress)
{
  FilterRun run(ParsePieces(Cube()));
  for (double limit : { 0.02, 0.1, 0.4, 0.6, 0.8, 0.87, 0.95 })
  {
    SCOPED_TRACE(limit);
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&limit);
    command->SetCallback(
      [](vtkObject* filter, unsigned long, void* at, void* value)
      {
        if (*static_cast<double*>(value) >= *static_cast<double*>(at))
        {
          static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
        }
      });
    const unsigned long tag = run.Filter->AddObserver(vtkCommand::ProgressEvent, command);
    run.Filter->Modified();
    run.Update();
    ExpectEmptyOutputs(run.Filter);
    EXPECT_TRUE(run.Errors.empty());
    run.Filter->RemoveObserver(tag);
    run.Filter->SetAbortExecute(0);
    run.Filter->Modified();
    EXPECT_GT(run.Update()->GetNumberOfCells(), 0);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, SaysWhatItIsDoing)
{
  FilterRun run(Stomach());
  std::set<std::string> texts;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&texts);
  command->SetCallback(
    [](vtkObject* filter, unsigned long, void* list, void*)
    {
      const char* text = static_cast<vtkAlgorithm*>(filter)->GetProgressText();
      static_cast<std::set<std::string>*>(list)->insert(text ? text : "");
    });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, command);
  run.Update();
  EXPECT_GT(texts.size(), 5u);
  EXPECT_EQ(texts.count("Filling cycles"), 1u);
}

//----------------------------------------------------------------------------
/// Loops run in as many threads as the user allows, and in one within a loop of VTK.
TEST(ReconstructionFilter, ThreadsKeepToTheLimit)
{
  vtkSMPTools::Initialize(1);
  EXPECT_EQ(NumberOfThreads(), 1);
  vtkSMPTools::Initialize(0);
  const int all = NumberOfThreads();
  EXPECT_GE(all, 1);
  EXPECT_LE(all, static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  if (all > 1)
  {
    vtkSMPTools::Initialize(2);
    EXPECT_EQ(NumberOfThreads(), 2);
    vtkSMPTools::Initialize(0);
    std::atomic<int> most{ 0 };
    vtkSMPTools::For(0, 64, 1,
      [&](vtkIdType, vtkIdType)
      {
        const int threads = vtkSMPTools::IsParallelScope() ? NumberOfThreads() : 1;
        int before = most;
        while (before < threads && !most.compare_exchange_weak(before, threads))
        {
        }
      });
    EXPECT_EQ(most, 1);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, PrecisionOfTheOutputPoints)
{
  const struct
  {
    int Precision, Input, Expected;
  } cases[] = { { vtkAlgorithm::DEFAULT_PRECISION, VTK_FLOAT, VTK_FLOAT },
    { vtkAlgorithm::DEFAULT_PRECISION, VTK_DOUBLE, VTK_DOUBLE },
    { vtkAlgorithm::SINGLE_PRECISION, VTK_DOUBLE, VTK_FLOAT },
    { vtkAlgorithm::DOUBLE_PRECISION, VTK_FLOAT, VTK_DOUBLE } };
  for (const auto& c : cases)
  {
    FilterRun run(ParsePieces(Cube()), Form::ClosedLine, c.Input);
    run.Filter->SetOutputPointsPrecision(c.Precision);
    EXPECT_EQ(run.Update()->GetPoints()->GetDataType(), c.Expected);
    EXPECT_EQ(run.Filter->GetGraphOutput()->GetPoints()->GetDataType(), c.Expected);
  }
  FilterRun run(ParsePieces(Cube()), Form::ClosedLine, VTK_FLOAT);
  run.Filter->SetInputData(1, MakePolyData(ParsePieces(Cube())[1]));
  EXPECT_EQ(run.Update()->GetPoints()->GetDataType(), VTK_DOUBLE);
}

//----------------------------------------------------------------------------
namespace
{
template <typename Array>
Array* GetArray(vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  vtkAbstractArray* found = data->GetAbstractArray(name);
  Array* array = Array::SafeDownCast(found);
  EXPECT_NE(array, nullptr) << name;
  if (array)
  {
    EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
    EXPECT_EQ(array->GetNumberOfTuples(), tuples) << name;
  }
  return array;
}
}

TEST(ReconstructionFilter, ArraysOfTheSurface)
{
  FilterRun run(Stomach());
  vtkPolyData* surface = run.Update();
  const vtkIdType cells = surface->GetNumberOfCells();
  GetArray<vtkIntArray>(surface->GetCellData(), "ComponentId", 1, cells);
  GetArray<vtkUnsignedShortArray>(surface->GetCellData(), "GridCell", 3, cells);
  GetArray<vtkUnsignedShortArray>(surface->GetCellData(), "PolygonSize", 1, cells);
  GetArray<vtkUnsignedCharArray>(surface->GetCellData(), "Repaired", 1, cells);
  GetArray<vtkFloatArray>(surface->GetPointData(), "Disagreement", 1, surface->GetNumberOfPoints());
  auto* normals =
    GetArray<vtkFloatArray>(surface->GetPointData(), "Normals", 3, surface->GetNumberOfPoints());
  EXPECT_EQ(surface->GetPointData()->GetNormals(), normals);
  EXPECT_EQ(surface->GetNumberOfPolys(), cells);
  for (const char* name : { "NumberOfComponents", "NumberOfContours", "NumberOfIsolatedContours",
         "NumberOfNodePoints", "NumberOfCellsWithSeveralCycles", "NumberOfReconciledEdges",
         "NumberOfReconciledVertices", "NumberOfRepairs" })
  {
    GetArray<vtkIdTypeArray>(surface->GetFieldData(), name, 1, 1);
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, FieldDataCountWhatIsThere)
{
  FilterRun run(Stomach());
  run.Filter->SetReportTolerance(0.0);
  vtkPolyData* surface = run.Update();
  EXPECT_EQ(FieldValue(surface, "NumberOfComponents"), CheckSurface(MeshOf(surface)).Components);
  EXPECT_EQ(FieldValue(surface, "NumberOfContours"), 86 + 99 + 42);
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  vtkDataArray* kind = graph->GetCellData()->GetArray("Kind");
  std::map<int, vtkIdType> count;
  for (vtkIdType i = 0; i < graph->GetNumberOfCells(); ++i)
  {
    ++count[static_cast<int>(kind->GetTuple1(i))];
  }
  EXPECT_EQ(FieldValue(surface, "NumberOfNodePoints"), count[0]);
  EXPECT_EQ(FieldValue(surface, "NumberOfIsolatedContours"), count[2]);
  EXPECT_EQ(FieldValue(surface, "NumberOfRepairs"),
    count[3] + count[4] + count[5] + count[6] + count[7] + count[8]);
  EXPECT_GE(count[3], FieldValue(surface, "NumberOfReconciledVertices"));
  EXPECT_GE(count[4], FieldValue(surface, "NumberOfReconciledEdges"));
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, ComponentIdsAreTheComponents)
{
  FilterRun run(ReadPieceSets({ "pelvis", 2, 0, true }, 16));
  vtkPolyData* surface = run.Update();
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  auto* ids = vtkIntArray::SafeDownCast(surface->GetCellData()->GetArray("ComponentId"));
  std::map<std::int64_t, std::set<int>> found;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    found[check.Component[i]].insert(ids->GetValue(i));
  }
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].size(), 1u);
  EXPECT_EQ(found[1].size(), 1u);
  EXPECT_NE(*found[0].begin(), *found[1].begin());
  EXPECT_EQ(*found[0].begin() + *found[1].begin(), 1); // numbered from 0
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, GridCellsHoldTheirTriangles)
{
  const Solid solid = TiltedTorus();
  const PlaneSets planes = EqualPlanes(solid, { 13, 14, 16 });
  FilterRun run(SliceSolid(solid, planes, 3, InPlaneGrid::Free));
  run.Filter->AutomaticAccuracyOff(); // triangles that are shaped well reach into others
  vtkPolyData* surface = run.Update();
  vtkDataArray* cells = surface->GetCellData()->GetArray("GridCell");
  PlaneSets used;
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkDataArray* points =
      vtkPolyData::SafeDownCast(run.Filter->GetInputDataObject(axis, 0))->GetPoints()->GetData();
    std::set<double> distinct;
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
    {
      distinct.insert(points->GetComponent(i, axis));
    }
    used[axis].assign(distinct.begin(), distinct.end());
  }
  const TriangleMesh mesh = MeshOf(surface);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto slab = static_cast<std::size_t>(cells->GetComponent(t, axis));
      for (const std::int64_t id : mesh.Triangles[t])
      {
        const double x = mesh.Points[id][axis];
        EXPECT_TRUE(slab == 0 || x >= used[axis][slab - 1]);
        EXPECT_TRUE(slab == used[axis].size() || x <= used[axis][slab]);
      }
    }
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, NormalsPointOutwards)
{
  const Solid solid = TiltedTorus();
  FilterRun run(SliceSolid(solid, EqualPlanes(solid, { 14, 14, 14 }), 3, InPlaneGrid::Free));
  vtkPolyData* surface = run.Update();
  auto* normals = vtkFloatArray::SafeDownCast(surface->GetPointData()->GetNormals());
  ASSERT_NE(normals, nullptr);
  double mean = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const float* n = normals->GetPointer(3 * i);
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0, 1e-5);
    Point3 p;
    surface->GetPoint(i, p.data());
    const Point3 g = solid.Gradient(p);
    mean += (n[0] * g[0] + n[1] * g[1] + n[2] * g[2]) / surface->GetNumberOfPoints();
  }
  EXPECT_GT(mean, 0.97);
  run.Filter->ComputeNormalsOff();
  EXPECT_EQ(run.Update()->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(run.Filter->GetOutput()->GetPointData()->GetArray("Normals"), nullptr);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, HistogramHasAllSizesAndAllPolygons)
{
  FilterRun run(Stomach());
  run.Filter->SetSeveralCyclesToDiscs();
  run.Filter->SetMinimumIsolatedContourSize(1.0); // they are no polygons
  vtkPolyData* surface = run.Update();
  vtkTable* table = run.Filter->GetHistogramOutput();
  auto* sizes = vtkIdTypeArray::SafeDownCast(table->GetColumnByName("PolygonSize"));
  auto* counts = vtkIdTypeArray::SafeDownCast(table->GetColumnByName("Count"));
  ASSERT_NE(sizes, nullptr);
  ASSERT_NE(counts, nullptr);
  ASSERT_GT(table->GetNumberOfRows(), 2);
  EXPECT_EQ(table->GetNumberOfColumns(), 2);
  vtkDataArray* ofTriangle = surface->GetCellData()->GetArray("PolygonSize");
  std::set<vtkIdType> occurring;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    occurring.insert(static_cast<vtkIdType>(ofTriangle->GetTuple1(i)));
  }
  EXPECT_EQ(sizes->GetValue(0), *occurring.begin());
  EXPECT_EQ(sizes->GetValue(table->GetNumberOfRows() - 1), *occurring.rbegin());
  vtkIdType nodes = 0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    EXPECT_EQ(sizes->GetValue(row), sizes->GetValue(0) + row);
    EXPECT_EQ(counts->GetValue(row) > 0, occurring.count(sizes->GetValue(row)) == 1);
    nodes += sizes->GetValue(row) * counts->GetValue(row);
  }
  // Each of the four cells around a node point has it in one polygon.
  EXPECT_EQ(nodes, 4 * FieldValue(surface, "NumberOfNodePoints"));
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, HistogramOfTheCube)
{
  TextRun run{ Cube() };
  run.Update();
  vtkTable* table = run.Filter->GetHistogramOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(table->GetValueByName(0, "PolygonSize").ToInt(), 3);
  EXPECT_EQ(table->GetValueByName(0, "Count").ToInt(), 8);
  EXPECT_EQ(table->GetValueByName(1, "PolygonSize").ToInt(), 4);
  EXPECT_EQ(table->GetValueByName(1, "Count").ToInt(), 18);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, GraphHasNodePointsRepairsArcsAndIsolatedContours)
{
  FilterRun run(Stomach());
  vtkPolyData* surface = run.Update();
  const vtkIdType isolated = FieldValue(surface, "NumberOfIsolatedContours");
  const vtkIdType repairs = FieldValue(surface, "NumberOfRepairs");
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  const vtkIdType nodes = graph->GetNumberOfVerts() - repairs, cells = graph->GetNumberOfCells();
  ASSERT_GT(nodes, 0);
  EXPECT_EQ(graph->GetNumberOfLines(), 2 * nodes + isolated); // four half-arcs at each node
  vtkFieldData* data = graph->GetCellData();
  auto* kind = GetArray<vtkUnsignedCharArray>(data, "Kind", 1, cells);
  auto* disagreement = GetArray<vtkDoubleArray>(data, "Disagreement", 1, cells);
  auto* axis = GetArray<vtkIntArray>(data, "SliceAxis", 1, cells);
  auto* plane = GetArray<vtkIntArray>(data, "SlicePlane", 1, cells);
  auto* length = GetArray<vtkDoubleArray>(data, "Length", 1, cells);
  auto* component = GetArray<vtkIntArray>(data, "ComponentId", 1, cells);
  auto* size = GetArray<vtkFloatArray>(data, "RepairSize", 1, cells);
  std::map<vtkIdType, int> arcsAtNode;
  double greatest = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    SCOPED_TRACE(cell);
    graph->GetCellPoints(cell, ids);
    const vtkIdType first = ids->GetId(0), last = ids->GetId(ids->GetNumberOfIds() - 1);
    const int expected = cell < nodes ? 0
      : cell < nodes + repairs        ? std::max<int>(3, kind->GetValue(cell))
      : cell < cells - isolated       ? 1
                                      : 2;
    ASSERT_EQ(kind->GetValue(cell), expected);
    const bool isLine = expected == 1 || expected == 2;
    EXPECT_EQ(axis->GetValue(cell) == -1, expected == 0 || expected == 7);
    EXPECT_EQ(plane->GetValue(cell) == -1, axis->GetValue(cell) == -1);
    // An isolated contour may take part in the surface.
    EXPECT_TRUE(expected == 2 || (component->GetValue(cell) == -1) == (expected >= 2));
    EXPECT_EQ(size->GetValue(cell) > 0.0f, expected >= 3);
    EXPECT_EQ(length->GetValue(cell) > 0.0, isLine);
    EXPECT_TRUE(expected == 0 || disagreement->GetValue(cell) == 0.0);
    greatest = std::max(greatest, disagreement->GetValue(cell));
    if (!isLine)
    {
      EXPECT_EQ(ids->GetNumberOfIds(), 1);
      EXPECT_TRUE(expected != 0 || first == cell);
      continue;
    }
    EXPECT_EQ(first == last, expected == 2);
    double sum = 0.0, a[3], b[3];
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      graph->GetPoint(ids->GetId(i - 1), a);
      graph->GetPoint(ids->GetId(i), b);
      EXPECT_EQ(a[axis->GetValue(cell)], b[axis->GetValue(cell)]); // both on the slice
      sum += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }
    EXPECT_NEAR(length->GetValue(cell), sum, 1e-9 * (1.0 + sum));
    if (expected == 1)
    {
      ++arcsAtNode[first];
      ++arcsAtNode[last];
    }
  }
  EXPECT_GT(greatest, 0.0);
  EXPECT_EQ(static_cast<vtkIdType>(arcsAtNode.size()), nodes);
  for (const auto& node : arcsAtNode)
  {
    EXPECT_EQ(node.second, 4);
  }
}

//----------------------------------------------------------------------------
namespace
{
std::vector<double> Column(vtkTable* table, const char* name)
{
  std::vector<double> values;
  auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  EXPECT_NE(column, nullptr) << name;
  for (vtkIdType row = 0; column && row < table->GetNumberOfRows(); ++row)
  {
    values.push_back(column->GetTuple1(row));
  }
  return values;
}
}

TEST(ReconstructionFilter, TableOfContoursHasARowForEach)
{
  FilterRun run(Stomach());
  vtkPolyData* surface = run.Update();
  vtkTable* table = TableOf(run.Filter, 3);
  ASSERT_EQ(table->GetNumberOfRows(), FieldValue(surface, "NumberOfContours"));
  const auto port = Column(table, "Port"), cell = Column(table, "Cell");
  const auto plane = Column(table, "PlaneCoordinate"), nodes = Column(table, "NodePoints");
  const auto rms = Column(table, "RmsDisagreement"), maximum = Column(table, "MaxDisagreement");
  double sum = 0.0;
  for (std::size_t row = 0; row < port.size(); ++row)
  {
    auto* input =
      vtkPolyData::SafeDownCast(run.Filter->GetInputDataObject(static_cast<int>(port[row]), 0));
    vtkNew<vtkIdList> ids;
    input->GetCellPoints(static_cast<vtkIdType>(cell[row]), ids);
    double x[3];
    input->GetPoint(ids->GetId(0), x);
    EXPECT_EQ(x[static_cast<int>(port[row])], plane[row]);
    EXPECT_LE(rms[row], maximum[row] * (1.0 + 1e-12));
    EXPECT_TRUE(nodes[row] > 0 || maximum[row] == 0.0);
    sum += nodes[row];
  }
  // Two contours meet in a node point, unless a slice was overruled there and has none.
  const double nodePoints = static_cast<double>(FieldValue(surface, "NumberOfNodePoints"));
  EXPECT_LE(sum, 2.0 * nodePoints);
  EXPECT_GT(sum, 1.9 * nodePoints);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, TableOfSlicesShowsTheSliceThatWasMoved)
{
  const Solid solid = TiltedTorus();
  const PlaneSets planes = EqualPlanes(solid, { 14, 14, 14 });
  PieceSets sets = SliceSolid(solid, planes, 4, InPlaneGrid::Free);
  const double moved = planes[2][6];
  for (std::size_t i = 0; i < sets[2].U.size(); ++i)
  {
    sets[2].U[i] += sets[2].W[i] == moved ? 0.04 : 0.0;
    sets[2].V[i] -= sets[2].W[i] == moved ? 0.02 : 0.0;
  }
  FilterRun run(sets);
  run.Update();
  vtkTable* table = TableOf(run.Filter, 4);
  const auto axis = Column(table, "SliceAxis"), plane = Column(table, "PlaneCoordinate");
  const auto rms = Column(table, "RmsDisagreement");
  const auto x = Column(table, "ShiftX"), y = Column(table, "ShiftY"), z = Column(table, "ShiftZ");
  const auto worst =
    static_cast<std::size_t>(std::max_element(rms.begin(), rms.end()) - rms.begin());
  ASSERT_LT(worst, axis.size());
  EXPECT_EQ(axis[worst], 2.0);
  EXPECT_EQ(plane[worst], moved);
  EXPECT_NEAR(x[worst], -0.04, 0.01);
  EXPECT_NEAR(y[worst], 0.02, 0.01);
  EXPECT_EQ(z[worst], 0.0);
  for (std::size_t row = 0; row < axis.size(); ++row)
  {
    EXPECT_TRUE(row == worst || std::hypot(x[row], y[row], z[row]) < 0.02) << row;
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, DisagreementIsInWorldUnits)
{
  TextRun run{ "x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1; z=0: -1,-1 1,-1 1,1.5 -1,1.5" };
  run.Update();
  vtkDataArray* array = run.Filter->GetGraphOutput()->GetCellData()->GetArray("Disagreement");
  double range[2];
  array->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 0.5);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, SurfaceBeginsWithThePointsOfTheGraph)
{
  TextRun run{ Cube() };
  vtkPolyData* surface = run.Update();
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  ASSERT_LT(graph->GetNumberOfPoints(), surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < graph->GetNumberOfPoints(); ++i)
  {
    double a[3], b[3];
    graph->GetPoint(i, a);
    surface->GetPoint(i, b);
    EXPECT_TRUE(std::equal(a, a + 3, b)) << i;
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, PassesOverGhostCells)
{
  TextRun run{ Cube() };
  const vtkIdType cells = run.Update()->GetNumberOfCells();
  auto data = MakePolyData(ParsePieces(Cube() + "z=1.5: 0.6,0.6 0.7,0.6 0.7,0.7")[2]);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(3);
  ghosts->FillValue(0);
  ghosts->SetValue(2, vtkDataSetAttributes::DUPLICATECELL);
  data->GetCellData()->AddArray(ghosts);
  run.Filter->SetInputData(2, data);
  EXPECT_EQ(run.Update()->GetNumberOfCells(), cells);
  EXPECT_EQ(FieldValue(run.Filter->GetOutput(), "NumberOfContours"), 6);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, LeavesItsInputsAlone)
{
  FilterRun run(ParsePieces(Cube()), Form::Mixture);
  std::vector<vtkSmartPointer<vtkPolyData>> copies;
  std::vector<vtkMTimeType> times;
  for (int port = 0; port < 3; ++port)
  {
    auto* input = vtkPolyData::SafeDownCast(run.Filter->GetInputDataObject(port, 0));
    copies.push_back(vtkSmartPointer<vtkPolyData>::New());
    copies.back()->DeepCopy(input);
    times.push_back(input->GetMTime());
  }
  run.Update();
  for (int port = 0; port < 3; ++port)
  {
    auto* input = vtkPolyData::SafeDownCast(run.Filter->GetInputDataObject(port, 0));
    EXPECT_EQ(input->GetMTime(), times[port]);
    ASSERT_EQ(input->GetNumberOfPoints(), copies[port]->GetNumberOfPoints());
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      double a[3], b[3];
      input->GetPoint(i, a);
      copies[port]->GetPoint(i, b);
      EXPECT_TRUE(std::equal(a, a + 3, b));
    }
  }
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, OrientationAsDrawnTrustsTheDirections)
{
  // Drawn by nesting, the inner square is a hole; drawn alike, it is inside of the inside.
  std::string text;
  for (const char* plane : { "x=0:", "y=0:", "z=0:" })
  {
    text += std::string(plane) + " -2,-2 2,-2 2,2 -2,2\n";
    text += std::string(plane) + " -1,-1 1,-1 1,1 -1,1\n";
  }
  TextRun run{ text };
  EXPECT_EQ(FieldValue(run.Update(), "NumberOfComponents"), 2);
  run.Filter->SetOrientationToAsDrawn();
  EXPECT_EQ(FieldValue(run.Update(), "NumberOfNodePoints") % 6, 0);
  const SurfaceCheck check = CheckSurface(MeshOf(run.Filter->GetOutput()));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_GT(check.TotalVolume(), 4.0 * 8.0 / 6.0);
}

//----------------------------------------------------------------------------
// What VTK's own filters leave is accepted as it comes.

namespace
{
void ExpectBall(FilterRun& run)
{
  vtkPolyData* surface = run.Update();
  ASSERT_TRUE(run.Errors.empty()) << run.Errors[0];
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, 1);
  EXPECT_EQ(check.TotalGenus(), 0);
  EXPECT_NEAR(check.TotalVolume(), 4.0 / 3.0 * 3.14159265, 0.1);
}

vtkSmartPointer<vtkPolyData> CutBall(int axis, double offset)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(40);
  vtkNew<vtkPlane> plane;
  double normal[3] = { 0, 0, 0 };
  normal[axis] = 1.0;
  plane->SetNormal(normal);
  vtkNew<vtkCutter> cutter;
  cutter->SetInputConnection(sphere->GetOutputPort());
  cutter->SetCutFunction(plane);
  cutter->GenerateTrianglesOff();
  for (int i = -4; i <= 4; ++i)
  {
    cutter->SetValue(i + 4, 0.21 * i + offset);
  }
  cutter->Update();
  return cutter->GetOutput();
}
}

TEST(ReconstructionFilter, AcceptsVtkCutter)
{
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, CutBall(axis, 0.013));
  }
  ExpectBall(run);
}

//----------------------------------------------------------------------------
/// Planes through mesh vertices and along rows of mesh edges, with the cutter's duplicate segments.
TEST(ReconstructionFilter, AcceptsVtkCutterThroughMeshVertices)
{
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, CutBall(axis, 0.0));
  }
  ExpectBall(run);
}

//----------------------------------------------------------------------------
TEST(ReconstructionFilter, AcceptsVtkStripper)
{
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkStripper> stripper;
    stripper->SetInputData(CutBall(axis, 0.013));
    stripper->SetMaximumLength(20); // contours in several pieces
    stripper->Update();
    run.Filter->SetInputData(axis, stripper->GetOutput());
  }
  ExpectBall(run);
}

//----------------------------------------------------------------------------
namespace
{
/// Distance to the unit sphere on a grid whose samples lie nowhere near it.
vtkSmartPointer<vtkImageData> BallImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(33, 33, 33);
  image->SetOrigin(-1.217, -1.223, -1.231);
  image->SetSpacing(0.077, 0.077, 0.077);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    values->SetValue(i, static_cast<float>(std::hypot(p[0], p[1], p[2]) - 1.0));
  }
  values->SetName("Distance");
  image->GetPointData()->SetScalars(values);
  return image;
}

/// The contours of every second image slice across an axis.
template <typename Contour>
vtkSmartPointer<vtkPolyData> ContourSlices(int axis)
{
  const auto image = BallImage();
  vtkNew<vtkAppendPolyData> all;
  for (int slice = 4; slice < 30; slice += 2)
  {
    vtkNew<vtkExtractVOI> extract;
    int box[6] = { 0, 32, 0, 32, 0, 32 };
    box[2 * axis] = box[2 * axis + 1] = slice;
    extract->SetInputData(image);
    extract->SetVOI(box);
    vtkNew<Contour> contour;
    contour->SetInputConnection(extract->GetOutputPort());
    contour->SetValue(0, 0.0);
    contour->Update();
    all->AddInputData(contour->GetOutput());
  }
  all->Update();
  return all->GetOutput();
}
}

TEST(ReconstructionFilter, AcceptsVtkMarchingSquares)
{
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, ContourSlices<vtkMarchingSquares>(axis));
  }
  ExpectBall(run);
}

//----------------------------------------------------------------------------
/// For z-slices; on images across x and y, VTK 9.1's vtkFlyingEdges2D gives points off their plane.
TEST(ReconstructionFilter, AcceptsVtkFlyingEdges2D)
{
  FilterRun run;
  run.Filter->SetInputData(0, ContourSlices<vtkMarchingSquares>(0));
  run.Filter->SetInputData(1, ContourSlices<vtkMarchingSquares>(1));
  run.Filter->SetInputData(2, ContourSlices<vtkFlyingEdges2D>(2));
  ExpectBall(run);
}
