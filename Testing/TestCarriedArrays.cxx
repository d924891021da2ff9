// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what contours carry is kept: cell arrays on graph and surface, field data of all inputs
 */

#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"

#include "Support/AnalyticSolids.h"
#include "Support/EvenSlices.h"
#include "Support/FilterRun.h"
#include "Support/SliceSolid.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr const char* FamilyNames[] = { "x", "y", "z" };

template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, vtkIdType tuples, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Contours with their coordinate along the axis ("Height"), a number that is never 0 ("Number"),
/// and the name of their family ("Family").
vtkSmartPointer<vtkPolyData> CarryingSlices(const Pieces& pieces)
{
  auto data = MakePolyData(pieces);
  const auto height = NewArray<vtkDoubleArray>("Height", pieces.Count());
  const auto number = NewArray<vtkIntArray>("Number", pieces.Count());
  const auto family = NewArray<vtkStringArray>("Family", pieces.Count());
  for (Index i = 0; i < pieces.Count(); ++i)
  {
    height->SetValue(i, pieces.W[pieces.Offsets[i]]);
    number->SetValue(i, 100 * (pieces.Axis + 1) + i);
    family->SetValue(i, FamilyNames[pieces.Axis]);
  }
  data->GetCellData()->AddArray(height);
  data->GetCellData()->AddArray(number);
  data->GetCellData()->AddArray(family);
  return data;
}

double ValueAt(vtkPolyData* data, const char* name, vtkIdType cell)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array != nullptr && cell < array->GetNumberOfTuples() ? array->GetComponent(cell, 0)
                                                               : -1e30;
}

std::string TextAt(vtkPolyData* data, const char* name, vtkIdType cell)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray(name));
  EXPECT_NE(array, nullptr) << name;
  return array != nullptr ? array->GetValue(cell) : "none";
}

/// Expects of each cell of the graph the values of the slice on which it lies.
void ExpectValuesOfSlices(vtkPolyData* graph)
{
  vtkIdType arcs = 0;
  for (vtkIdType cell = 0; cell < graph->GetNumberOfCells(); ++cell)
  {
    const int kind = static_cast<int>(ValueAt(graph, "Kind", cell));
    const bool isVirtual =
      graph->GetCellData()->HasArray("Virtual") && ValueAt(graph, "Virtual", cell) != 0.0;
    if ((kind != 1 && kind != 2) || isVirtual)
    {
      EXPECT_TRUE(std::isnan(ValueAt(graph, "Height", cell)));
      EXPECT_EQ(ValueAt(graph, "Number", cell), 0.0);
      EXPECT_EQ(TextAt(graph, "Family", cell), "");
      continue;
    }
    const int axis = static_cast<int>(ValueAt(graph, "SliceAxis", cell));
    double bounds[6];
    graph->GetCellBounds(cell, bounds);
    ASSERT_EQ(ValueAt(graph, "Height", cell), bounds[2 * axis]) << cell;
    EXPECT_EQ(std::floor(ValueAt(graph, "Number", cell) / 100), axis + 1);
    EXPECT_EQ(TextAt(graph, "Family", cell), FamilyNames[axis]);
    ++arcs;
  }
  EXPECT_GT(arcs, 0);
}

/// The coordinates of the slices across an axis.
std::vector<double> PlanesOf(vtkTable* slices, int axis)
{
  std::vector<double> planes;
  for (vtkIdType row = 0; row < slices->GetNumberOfRows(); ++row)
  {
    if (slices->GetValueByName(row, "SliceAxis").ToInt() == axis)
    {
      planes.push_back(slices->GetValueByName(row, "PlaneCoordinate").ToDouble());
    }
  }
  return planes;
}

/// How far a triangle's centroid is from a slice across z.
double DistanceFrom(double height, vtkPolyData* surface, vtkIdType triangle)
{
  double bounds[6];
  surface->GetCellBounds(triangle, bounds);
  return std::abs(height - 0.5 * (bounds[4] + bounds[5]));
}

void AddField(vtkDataObject* data, const char* name, double value)
{
  const auto array = NewArray<vtkDoubleArray>(name, 1);
  array->SetValue(0, value);
  data->GetFieldData()->AddArray(array);
}

double FieldOf(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array != nullptr ? array->GetComponent(0, 0) : -1.0;
}

/// A ball as one stack of `count` slices, which carry their heights.
vtkSmartPointer<vtkPolyData> BallStack(int count)
{
  const Solid ball = UnitBall();
  return CarryingSlices(
    SliceSolid(ball, EqualPlanes(ball, { 0, 0, count }), 6, InPlaneGrid::Free)[2]);
}

/// Slices of a ball that grow with time, and carry the time.
class GrowingBall : public vtkPolyDataAlgorithm
{
public:
  static GrowingBall* New();
  vtkTypeMacro(GrowingBall, vtkPolyDataAlgorithm);

protected:
  GrowingBall() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[] = { 1.0, 2.0, 3.0 };
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
    const double range[] = { times[0], times[2] };
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    Solid ball = UnitBall();
    ball.Tubes = { Ball({ 0, 0, 0 }, 0.5 + 0.125 * time) };
    auto data =
      MakePolyData(SliceSolid(ball, EqualPlanes(ball, { 0, 0, 8 }), 6, InPlaneGrid::Free)[2]);
    const auto phase = NewArray<vtkDoubleArray>("Phase", data->GetNumberOfCells());
    phase->Fill(time);
    data->GetCellData()->AddArray(phase);
    AddField(data, "Time", time);
    data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    vtkPolyData::GetData(outputs)->ShallowCopy(data);
    return 1;
  }
};
vtkStandardNewMacro(GrowingBall);
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, ArcsHaveTheValuesOfTheirContours)
{
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, CarryingSlices(TorusSlices()[axis]));
  }
  run.Update();
  ExpectValuesOfSlices(run.Filter->GetGraphOutput());
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, ArcsOfContoursThatWereRepairedToo)
{
  PieceSets sets = TorusSlices();
  Pieces& moved = sets[1];
  for (Index piece = moved.Count() / 2; piece < moved.Count() / 2 + 2; ++piece)
  {
    for (Index i = moved.Offsets[piece]; i < moved.Offsets[piece + 1]; ++i)
    {
      moved.U[i] += 0.15;
    }
  }
  FilterRun run;
  run.Filter->SetVirtualSlicesToOff(); // of contours and of what lies between them
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, CarryingSlices(sets[axis]));
  }
  vtkPolyData* surface = run.Update();
  EXPECT_GT(FieldValue(surface, "NumberOfReconciledVertices"), 0);
  ExpectValuesOfSlices(run.Filter->GetGraphOutput());
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, TrianglesHaveThoseOfAContourBesideThem)
{
  FilterRun run;
  run.Filter->SetVirtualSlicesToOff(); // of contours and of what lies between them
  for (int axis = 0; axis < 2; ++axis)
  {
    run.Filter->SetInputData(axis, MakePolyData(TorusSlices()[axis]));
  }
  run.Filter->SetInputData(2, CarryingSlices(TorusSlices()[2]));
  vtkPolyData* surface = run.Update();
  const std::vector<double> planes = PlanesOf(run.Filter->GetSliceTable(), 2);
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    // Only z-slices carry anything: each triangle has the values of that below or above it.
    const double height = ValueAt(surface, "Height", i);
    const auto slab =
      static_cast<std::size_t>(surface->GetCellData()->GetArray("GridCell")->GetComponent(i, 2));
    ASSERT_TRUE(
      (slab > 0 && height == planes[slab - 1]) || (slab < planes.size() && height == planes[slab]))
      << i;
    EXPECT_EQ(TextAt(surface, "Family", i), "z");
    EXPECT_GE(ValueAt(surface, "Number", i), 300.0);
  }
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  for (vtkIdType i = 0; i < graph->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(std::isnan(ValueAt(graph, "Height", i)), ValueAt(graph, "SliceAxis", i) != 2);
  }
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, VirtualSlicesHaveNoneButTheSurfaceAllOver)
{
  FilterRun run;
  run.Filter->AutomaticAccuracyOff(); // few triangles reach into neighbouring cells
  run.Filter->SetInputData(2, BallStack(6));
  vtkPolyData* surface = run.Update();
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  ASSERT_TRUE(graph->GetCellData()->HasArray("Virtual"));
  ExpectValuesOfSlices(graph);
  double worst = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    const double height = ValueAt(surface, "Height", i);
    ASSERT_FALSE(std::isnan(height));
    worst = std::max(worst, DistanceFrom(height, surface, i));
  }
  EXPECT_LT(worst, (1.24 + 1.19) / 6);
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, NothingOfOursIsReplacedAndNothingMixedUp)
{
  FilterRun run;
  run.Filter->SetVirtualSlicesToOff(); // of contours and of what lies between them
  for (int axis = 0; axis < 3; ++axis)
  {
    auto data = MakePolyData(TorusSlices()[axis]);
    const vtkIdType cells = data->GetNumberOfCells();
    const auto kind = NewArray<vtkIntArray>("Kind", cells);
    vtkSmartPointer<vtkDataArray> mixed = NewArray<vtkDoubleArray>("Mixed", cells);
    if (axis == 0)
    {
      mixed = NewArray<vtkIntArray>("Mixed", cells);
    }
    const auto wide = NewArray<vtkIntArray>("Wide", cells, axis + 1);
    const auto ghosts = NewArray<vtkUnsignedCharArray>("vtkGhostType", cells);
    kind->Fill(77);
    mixed->Fill(0.5 + axis);
    wide->Fill(1);
    ghosts->Fill(0);
    for (vtkDataArray* array : std::vector<vtkDataArray*>{ kind, mixed, wide, ghosts })
    {
      data->GetCellData()->AddArray(array);
    }
    run.Filter->SetInputData(axis, data);
  }
  vtkPolyData* surface = run.Update();
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  for (vtkPolyData* data : { surface, graph })
  {
    EXPECT_FALSE(data->GetCellData()->HasArray("Wide"));
    EXPECT_FALSE(data->GetCellData()->HasArray("vtkGhostType"));
    EXPECT_EQ(ValueAt(data, "InputKind", data->GetNumberOfCells() - 1), 77.0);
    EXPECT_EQ(data->GetCellData()->GetArray("Mixed")->GetDataType(), VTK_DOUBLE);
  }
  EXPECT_FALSE(surface->GetCellData()->HasArray("Kind"));
  for (vtkIdType i = 0; i < graph->GetNumberOfCells(); ++i)
  {
    EXPECT_LE(ValueAt(graph, "Kind", i), 9.0);
    const double axis = ValueAt(graph, "SliceAxis", i);
    EXPECT_TRUE(axis < 0.0 || ValueAt(graph, "Mixed", i) == (axis == 0.0 ? 0.0 : 0.5 + axis));
  }
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, EachStructureHasThoseOfItsContours)
{
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    auto slices = CarryingSlices(TorusSlices()[axis]);
    const auto structure = NewArray<vtkIntArray>("Structure", slices->GetNumberOfCells());
    const auto label = NewArray<vtkIntArray>("Label", slices->GetNumberOfCells());
    structure->Fill(4);
    label->Fill(9);
    slices->GetCellData()->AddArray(structure);
    slices->GetCellData()->AddArray(label);
    AddField(slices, "Patient", 5.0);
    run.Filter->SetInputData(axis, slices);
  }
  run.Filter->SetLabelArray("Structure");
  vtkPolyData* surface = run.Update();
  ExpectValuesOfSlices(run.Filter->GetGraphOutput());
  ASSERT_GT(surface->GetNumberOfCells(), 0);
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(ValueAt(surface, "Label", i), 4.0);
    EXPECT_EQ(ValueAt(surface, "Structure", i), 4.0);
    EXPECT_EQ(ValueAt(surface, "InputLabel", i), 9.0);
  }
  EXPECT_EQ(FieldOf(surface, "Patient"), 5.0);
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, BlocksOfAGroupHaveTheirOwn)
{
  vtkNew<vtkMultiBlockDataSet> group;
  for (int axis = 0; axis < 3; ++axis)
  {
    auto slices = CarryingSlices(TorusSlices()[axis]);
    AddField(slices, "Thickness", 1.0 + axis);
    AddField(slices, "Patient", 5.0);
    group->SetBlock(2 - axis, slices);
  }
  FilterRun run;
  run.Filter->SetInputData(3, group);
  vtkPolyData* surface = run.Update();
  ExpectValuesOfSlices(run.Filter->GetGraphOutput());
  EXPECT_EQ(FieldOf(surface, "Patient"), 5.0);
  EXPECT_EQ(FieldOf(surface, "ContoursBlock1Thickness"), 3.0);
  EXPECT_EQ(FieldOf(surface, "ContoursBlock3Thickness"), 1.0);
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, OffOrNoneLeavesTheOutputsAsTheyAre)
{
  FilterRun plain(TorusSlices());
  plain.Update();
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, CarryingSlices(TorusSlices()[axis]));
  }
  run.Filter->PassCellArraysOff();
  run.Update();
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* expected = plain.Filter->GetOutput(port);
    vtkPolyData* found = run.Filter->GetOutput(port);
    EXPECT_EQ(
      found->GetCellData()->GetNumberOfArrays(), expected->GetCellData()->GetNumberOfArrays());
    EXPECT_EQ(found->GetNumberOfCells(), expected->GetNumberOfCells());
  }
  EXPECT_EQ(plain.Filter->GetGraphOutput()->GetFieldData()->GetNumberOfArrays(), 0);
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, FieldDataOfAllInputsAreKeptApart)
{
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    auto slices = MakePolyData(TorusSlices()[axis]);
    AddField(slices, "Thickness", 1.0 + axis);
    AddField(slices, "Scale", std::numeric_limits<double>::quiet_NaN());
    AddField(slices, "NumberOfContours", 0.25);
    if (axis == 1)
    {
      AddField(slices, "OfY", 7.0);
    }
    run.Filter->SetInputData(axis, slices);
  }
  vtkPolyData* surface = run.Update();
  for (vtkPolyData* data : { surface, run.Filter->GetGraphOutput() })
  {
    EXPECT_EQ(FieldOf(data, "XThickness"), 1.0);
    EXPECT_EQ(FieldOf(data, "YThickness"), 2.0);
    EXPECT_EQ(FieldOf(data, "ZThickness"), 3.0);
    EXPECT_FALSE(data->GetFieldData()->HasArray("Thickness"));
    EXPECT_TRUE(data->GetFieldData()->HasArray("Scale"));
    EXPECT_FALSE(data->GetFieldData()->HasArray("XScale"));
    EXPECT_EQ(FieldOf(data, "OfY"), 7.0);
    EXPECT_EQ(FieldOf(data, "InputNumberOfContours"), 0.25);
  }
  EXPECT_GT(FieldOf(surface, "NumberOfContours"), 1.0);
  EXPECT_EQ(run.Filter->GetContourTable()->GetFieldData()->GetNumberOfArrays(), 0);
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, PlanesOfTheSlicerStayOffTheSurface)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(sphere->GetOutputPort());
  slicer->SetNumberOfSlices(8, 9, 10);
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputConnection(axis, slicer->GetOutputPort(axis));
  }
  vtkPolyData* surface = run.Update();
  for (const char* name : { "PlaneIndex", "PlaneCoordinate" })
  {
    EXPECT_FALSE(surface->GetCellData()->HasArray(name));
  }
  for (const char* name : { "PlaneCoordinates", "XPlaneCoordinates", "ZPlaneCoordinates" })
  {
    EXPECT_FALSE(surface->GetFieldData()->HasArray(name));
  }
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  EXPECT_FALSE(graph->GetFieldData()->HasArray("PlaneCoordinates"));
  vtkDataArray* ofY = graph->GetFieldData()->GetArray("YPlaneCoordinates");
  ASSERT_NE(ofY, nullptr);
  EXPECT_EQ(ofY->GetNumberOfTuples(), 9);
  for (vtkIdType i = 0; i < graph->GetNumberOfCells(); ++i)
  {
    if (ValueAt(graph, "SliceAxis", i) == 1.0)
    {
      const double plane = ValueAt(graph, "PlaneIndex", i);
      EXPECT_EQ(plane, ValueAt(graph, "SlicePlane", i));
      EXPECT_EQ(
        ValueAt(graph, "PlaneCoordinate", i), ofY->GetComponent(static_cast<vtkIdType>(plane), 0));
    }
  }
}

//----------------------------------------------------------------------------
TEST(CarriedArrays, EachTimeStepHasItsOwn)
{
  vtkNew<GrowingBall> source;
  FilterRun run;
  run.Filter->SetInputConnection(2, source->GetOutputPort());
  for (const double time : { 1.0, 3.0, 2.0 })
  {
    run.Filter->UpdateTimeStep(time);
    for (int port = 0; port < 2; ++port)
    {
      vtkPolyData* output = run.Filter->GetOutput(port);
      EXPECT_EQ(output->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
      EXPECT_EQ(FieldOf(output, "Time"), time);
      EXPECT_EQ(output->GetFieldData()->HasArray("InputTime"), 0);
    }
    vtkPolyData* surface = run.Filter->GetOutput();
    ASSERT_GT(surface->GetNumberOfCells(), 0);
    EXPECT_EQ(ValueAt(surface, "Phase", 0), time);
    double bounds[6];
    surface->GetBounds(bounds);
    EXPECT_NEAR(bounds[1] - bounds[0], 1.0 + 0.25 * time, 0.1);
  }
}
