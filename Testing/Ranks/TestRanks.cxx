// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   several processes make the surface that one process makes, piece by piece
 *
 *   mpirun -np N TestOrthogonalSlicesRanks [options of GoogleTest]
 *
 * All processes run all tests. What each gives the filter is a part of the contours; the first one
 * gathers the pieces and compares them with what it makes from the whole by itself.
 */

#include "Ranks/UnionOfPieces.h"
#include "Support/AnalyticSolids.h"
#include "Support/FilterRun.h"
#include "Support/Random.h"
#include "Support/SliceSolid.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMPIController.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Filter = vtkOrthogonalSliceReconstruction;
using Whole = std::array<vtkSmartPointer<vtkPolyData>, 4>;
using Configure = std::function<void(Filter*)>;

vtkMultiProcessController* Controller() { return vtkMultiProcessController::GetGlobalController(); }
int Rank() { return Controller()->GetLocalProcessId(); }
int Count() { return Controller()->GetNumberOfProcesses(); }

/// How the contours of a port are divided.
enum class Division
{
  Even,
  Uneven, ///< at random; some processes have none
  LastOnly
};

/// The first contour of each process, and the number of all.
std::vector<vtkIdType> FirstContours(vtkIdType count, Division division, std::uint64_t seed)
{
  Random numbers(seed);
  std::vector<vtkIdType> first{ 0 };
  for (int rank = 1; rank < Count(); ++rank)
  {
    first.push_back(division == Division::Even ? count * rank / Count()
        : division == Division::LastOnly       ? 0
        : numbers.Chance(0.3)                  ? first.back()
                                               : static_cast<vtkIdType>(numbers.Below(count + 1)));
  }
  std::sort(first.begin(), first.end());
  first.push_back(count);
  return first;
}

/// The lines of a data set with numbers in a range, and what they carry.
vtkSmartPointer<vtkPolyData> TakeLines(vtkPolyData* whole, vtkIdType first, vtkIdType last)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(whole->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = first; line < last; ++line)
  {
    whole->GetLines()->GetCellAtId(line, ids);
    lines->InsertNextCell(ids->GetNumberOfIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      lines->InsertCellPoint(points->InsertNextPoint(whole->GetPoint(ids->GetId(i))));
    }
  }
  part->SetPoints(points);
  part->SetLines(lines);
  part->GetCellData()->CopyAllocate(whole->GetCellData(), last - first);
  part->GetCellData()->CopyData(whole->GetCellData(), 0, last - first, first);
  part->GetFieldData()->ShallowCopy(whole->GetFieldData());
  return part;
}

void SetParts(const Whole& whole, Division division, Filter* filter)
{
  for (int port = 0; port < 4; ++port)
  {
    if (whole[port] != nullptr)
    {
      const auto first = FirstContours(whole[port]->GetNumberOfLines(), division, 17 + port);
      filter->SetInputData(port, TakeLines(whole[port], first[Rank()], first[Rank() + 1]));
    }
  }
}

/// Updates the piece of this process; the pieces of all, on the first one.
std::vector<vtkSmartPointer<vtkPolyData>> UpdatePieces(Filter* filter)
{
  filter->UpdatePiece(Rank(), Count(), 0);
  vtkPolyData* own = filter->GetOutput();
  EXPECT_EQ(own->GetPointData()->GetGlobalIds() != nullptr, Count() > 1);
  EXPECT_EQ(own->GetCellData()->GetGlobalIds() != nullptr, Count() > 1);
  std::vector<vtkSmartPointer<vtkDataObject>> gathered;
  vtkNew<vtkPolyData> piece;
  piece->ShallowCopy(filter->GetOutput());
  Controller()->Gather(piece, gathered, 0);
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  for (const auto& data : gathered)
  {
    pieces.emplace_back(vtkPolyData::SafeDownCast(data));
  }
  return pieces;
}

std::string TextOf(vtkTable* table)
{
  std::string text;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    {
      text += table->GetValue(row, column).ToString() + " ";
    }
    text += "\n";
  }
  return text;
}

/// The outputs besides the surface are whole on the first process, and empty on the others.
void ExpectOthers(Filter* parallel, Filter* single)
{
  for (int port = 2; port < 8; ++port)
  {
    auto* table = vtkTable::SafeDownCast(parallel->GetOutputDataObject(port));
    EXPECT_EQ(TextOf(table),
      Rank() > 0 ? "" : TextOf(vtkTable::SafeDownCast(single->GetOutputDataObject(port))))
      << "port " << port;
  }
  EXPECT_EQ(parallel->GetGraphOutput()->GetNumberOfCells(),
    Rank() > 0 ? 0 : single->GetGraphOutput()->GetNumberOfCells());
}

/// The union of the pieces is the surface of one process, however contours are divided. With all
/// triangles, unless configured otherwise.
void ExpectSame(
  const Whole& whole, const Configure& configure = [](Filter*) {})
{
  FilterRun single;
  single.Filter->SetController(nullptr);
  single.Filter->AutomaticAccuracyOff();
  configure(single.Filter);
  for (int port = 0; port < 4; ++port)
  {
    single.Filter->SetInputData(port, whole[port]);
  }
  if (Rank() == 0)
  {
    single.Update();
    ASSERT_GT(single.Filter->GetOutput()->GetNumberOfCells(), 0);
  }
  for (const Division division : { Division::Even, Division::Uneven, Division::LastOnly })
  {
    FilterRun run;
    run.Filter->AutomaticAccuracyOff();
    configure(run.Filter);
    SetParts(whole, division, run.Filter);
    const auto pieces = UpdatePieces(run.Filter);
    EXPECT_TRUE(run.Errors.empty()) << run.Errors.front();
    ExpectOthers(run.Filter, single.Filter);
    if (Rank() == 0)
    {
      EXPECT_EQ(run.Warnings.size(), single.Warnings.size());
    }
    else
    {
      EXPECT_TRUE(run.Warnings.empty()) << run.Warnings.front();
    }
    if (Count() > 1 && Rank() == 0)
    {
      EXPECT_EQ(CompareUnion(pieces, single.Filter->GetOutput()), "")
        << "division " << static_cast<int>(division);
    }
    for (const auto& piece : pieces)
    {
      EXPECT_LE(piece->GetNumberOfCells(),
        single.Filter->GetOutput()->GetNumberOfCells() * 3 / (2 * Count()) + 500)
        << "pieces are about equal";
    }
  }
}

Whole Sliced(const Solid& solid, const std::array<int, 3>& planes, int type = VTK_DOUBLE)
{
  const PieceSets sets = SliceSolid(solid, EqualPlanes(solid, planes), 4, InPlaneGrid::Free);
  Whole whole;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (planes[axis] > 0)
    {
      whole[axis] = MakePolyData(sets[axis], Form::ClosedLine, type);
      vtkNew<vtkIntArray> numbers;
      numbers->SetName("Number");
      for (vtkIdType i = 0; i < whole[axis]->GetNumberOfLines(); ++i)
      {
        numbers->InsertNextValue(static_cast<int>(100 * axis + i));
      }
      whole[axis]->GetCellData()->AddArray(numbers);
    }
  }
  return whole;
}

template <typename Move>
vtkSmartPointer<vtkPolyData> MovePoints(vtkPolyData* contours, Move&& move)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(contours);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> point;
    moved->GetPoint(i, point.data());
    move(point);
    moved->GetPoints()->SetPoint(i, point.data());
  }
  return moved;
}

/// Few triangles, as the filter makes them unless it is told otherwise.
void ByDefault(Filter* filter) { filter->AutomaticAccuracyOn(); }

const Whole& Knot()
{
  static const Whole knot = Sliced(KnottedTube(), { 14, 15, 16 });
  return knot;
}
}

TEST(Ranks, SmoothPatches) { ExpectSame(Knot()); }

TEST(Ranks, FansWithNormalsOfTriangles)
{
  ExpectSame(Knot(), [](Filter* filter) { filter->SetPatchType(Filter::FAN); });
}

TEST(Ranks, CoonsPatchesWithoutNormals)
{
  ExpectSame(Knot(),
    [](Filter* filter)
    {
      filter->SetPatchType(Filter::COONS);
      filter->ComputeNormalsOff();
    });
}

TEST(Ranks, Curvatures)
{
  ExpectSame(Knot(), [](Filter* filter) { filter->ComputeCurvaturesOn(); });
}

TEST(Ranks, FloatPoints) { ExpectSame(Sliced(LinkedTori(), { 12, 11, 13 }, VTK_FLOAT)); }

// Far from the origin, float does not tell all points apart: their number is that of all pieces.
TEST(Ranks, PointsEqualInFloat)
{
  Whole far = Knot();
  for (int axis = 0; axis < 3; ++axis)
  {
    far[axis] = MovePoints(far[axis],
      [](std::array<double, 3>& point)
      {
        std::transform(
          point.begin(), point.end(), point.begin(), [](double x) { return x + 1048576.0; });
      });
  }
  FilterRun single;
  single.Filter->SetController(nullptr);
  for (int port = 0; port < 3; ++port)
  {
    single.Filter->SetInputData(port, far[port]);
  }
  single.Update();
  EXPECT_GT(FieldValue(single.Filter->GetOutput(), "NumberOfPointsEqualInFloat"), 0);
  ExpectSame(far);
}

TEST(Ranks, SeveralComponentsAndCellsWithSeveralCycles)
{
  ExpectSame(Sliced(HollowBall(), { 7, 7, 7 }));
  ExpectSame(Sliced(BranchingTube(), { 6, 6, 6 }));
}

TEST(Ranks, FewTriangles)
{
  ExpectSame(Knot(), [](Filter* filter) { filter->SetAccuracy(0.05); });
  ExpectSame(Knot(), ByDefault);
  ExpectSame(Sliced(HollowBall(), { 7, 7, 7 }), ByDefault);
  ExpectSame(Sliced(TiltedTorus(), { 5, 4, 6 }), ByDefault);
}

TEST(Ranks, FewTrianglesAtVerticesOfContours)
{
  ExpectSame(Sliced(LinkedTori(), { 12, 11, 13 }, VTK_FLOAT),
    [](Filter* filter)
    {
      ByDefault(filter);
      filter->KeepContourVerticesOn();
      filter->ComputeNormalsOff();
    });
}

// Fans are not few, whatever the accuracy.
TEST(Ranks, FansByDefault)
{
  ExpectSame(Knot(),
    [](Filter* filter)
    {
      ByDefault(filter);
      filter->SetPatchType(Filter::FAN);
    });
}

// Of families that are not at right angles, triangles are few, but not improved.
TEST(Ranks, FewTrianglesOfObliqueFamilies)
{
  Whole oblique = Knot();
  for (int axis = 0; axis < 3; ++axis)
  {
    oblique[axis] =
      MovePoints(oblique[axis], [](std::array<double, 3>& point) { point[0] += 0.25 * point[1]; });
  }
  ExpectSame(oblique, ByDefault);
}

TEST(Ranks, FewTrianglesAndMoreRanksThanPatches)
{
  ExpectSame(Sliced(TiltedTorus(), { 1, 1, 1 }),
    [](Filter* filter)
    {
      ByDefault(filter);
      filter->SetVirtualSlices(Filter::NO_VIRTUAL_SLICES);
    });
}

TEST(Ranks, SparseSlices)
{
  ExpectSame(Sliced(TiltedTorus(), { 0, 0, 9 }));
  ExpectSame(Sliced(TiltedTorus(), { 5, 4, 6 }));
}

TEST(Ranks, OneFamilyWithoutVirtualSlices)
{
  ExpectSame(Sliced(TiltedTorus(), { 0, 0, 9 }),
    [](Filter* filter) { filter->SetVirtualSlices(Filter::NO_VIRTUAL_SLICES); });
}

TEST(Ranks, Labels)
{
  Whole whole = Knot();
  for (int axis = 0; axis < 3; ++axis)
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->ShallowCopy(whole[axis]);
    vtkNew<vtkIntArray> labels;
    labels->SetName("Structure");
    for (vtkIdType i = 0; i < data->GetNumberOfLines(); ++i)
    {
      labels->InsertNextValue(3);
    }
    data->GetCellData()->AddArray(labels);
    whole[axis] = data;
  }
  ExpectSame(whole, [](Filter* filter) { filter->SetLabelArray("Structure"); });
}

// Fewer cells with triangles than processes must not matter.
TEST(Ranks, MoreRanksThanPlanes) { ExpectSame(Sliced(TiltedTorus(), { 2, 2, 3 })); }

// Each process has all contours: a source that does not divide its output.
TEST(Ranks, CopiesCountOnce)
{
  FilterRun run, single;
  single.Filter->SetController(nullptr);
  for (int port = 0; port < 3; ++port)
  {
    run.Filter->SetInputData(port, Knot()[port]);
    single.Filter->SetInputData(port, Knot()[port]);
  }
  const auto pieces = UpdatePieces(run.Filter);
  single.Update();
  EXPECT_EQ(run.Warnings.size(), Rank() == 0 ? single.Warnings.size() : 0);
  if (Count() > 1 && Rank() == 0)
  {
    EXPECT_EQ(CompareUnion(pieces, single.Filter->GetOutput()), "");
  }
}

TEST(Ranks, BlocksKeepTheirNumbers)
{
  const Whole& whole = Knot();
  const auto blocksOf = [&](bool all)
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto first = FirstContours(whole[axis]->GetNumberOfLines(), Division::Uneven, axis);
      blocks->SetBlock(
        axis, all ? whole[axis] : TakeLines(whole[axis], first[Rank()], first[Rank() + 1]));
    }
    return blocks;
  };
  FilterRun run, single;
  single.Filter->SetController(nullptr);
  run.Filter->SetInputData(3, blocksOf(false));
  single.Filter->SetInputData(3, blocksOf(true));
  const auto pieces = UpdatePieces(run.Filter);
  single.Update();
  if (Count() > 1 && Rank() == 0)
  {
    EXPECT_EQ(CompareUnion(pieces, single.Filter->GetOutput()), "");
  }
  ExpectOthers(run.Filter, single.Filter);
}

// Whatever ends one process ends all, with a message, and the next update is as if nothing had been.
TEST(Ranks, FailureOfOneEndsAll)
{
  if (Count() == 1)
  {
    GTEST_SKIP();
  }
  FilterRun run;
  SetParts(Knot(), Division::Even, run.Filter);
  if (Rank() == Count() - 1)
  {
    run.Filter->SetAxisWeights(-1.0, 1.0, 1.0);
  }
  run.Filter->UpdatePiece(Rank(), Count(), 0);
  EXPECT_FALSE(run.Errors.empty());
  EXPECT_EQ(run.Filter->GetOutput()->GetNumberOfCells(), 0);
  run.Filter->SetAxisWeights(1.0, 1.0, 1.0);
  run.Filter->Modified();
  run.Errors.clear();
  run.Filter->UpdatePiece(Rank(), Count(), 0);
  EXPECT_TRUE(run.Errors.empty());
  EXPECT_GT(run.Filter->GetOutput()->GetNumberOfCells(), 0);
}

void ExpectAbortOfOneEndsAll(bool few, const std::vector<double>& times)
{
  for (const double when : times)
  {
    FilterRun run;
    run.Filter->SetAutomaticAccuracy(few);
    SetParts(Knot(), Division::Even, run.Filter);
    double progress = when;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&progress);
    command->SetCallback(
      [](vtkObject* caller, unsigned long, void* least, void* reached)
      {
        if (*static_cast<double*>(reached) >= *static_cast<double*>(least))
        {
          static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
        }
      });
    if (Rank() == 0)
    {
      run.Filter->AddObserver(vtkCommand::ProgressEvent, command);
    }
    run.Filter->UpdatePiece(Rank(), Count(), 0);
    EXPECT_EQ(run.Errors.empty(), Rank() == 0) << when;
    EXPECT_EQ(run.Filter->GetOutput()->GetNumberOfCells(), 0) << when;
  }
}

TEST(Ranks, AbortOfOneEndsAll)
{
  if (Count() == 1)
  {
    GTEST_SKIP();
  }
  ExpectAbortOfOneEndsAll(false, { 0.3, 0.65, 0.75, 0.9, 1.0 });
  ExpectAbortOfOneEndsAll(true, { 0.4, 0.6, 0.8, 0.9, 1.0 });
}

TEST(Ranks, NoContoursAtAll)
{
  FilterRun run;
  vtkNew<vtkPolyData> nothing;
  run.Filter->SetInputData(2, nothing);
  run.Filter->UpdatePiece(Rank(), Count(), 0);
  EXPECT_FALSE(run.Errors.empty());
  EXPECT_NE(run.Errors.front().find("has no contours"), std::string::npos);
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv, 0);
  vtkMultiProcessController::SetGlobalController(controller);
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return failed;
}
