// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours as people have them: in one data set or several, in any port, on planes of any
 * frame
 */

#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"

#include "Support/CheckSurface.h"
#include "Support/Damage.h"
#include "Support/FilterRun.h"
#include "Support/SliceSolid.h"
#include "Support/Stages.h"
#include "Support/TurnedSlices.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
vtkSmartPointer<vtkPolyData> ToPolyData(const Polylines& lines, int type = VTK_DOUBLE)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  vtkNew<vtkCellArray> cells;
  for (Index line = 0; line < lines.Count(); ++line)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (Index i = lines.Offsets[line]; i < lines.Offsets[line + 1]; ++i)
    {
      points->InsertNextPoint(lines.PointAt(i).data());
    }
    const int size = static_cast<int>(points->GetNumberOfPoints() - first);
    cells->InsertNextCell(size + lines.Closed[line]);
    for (int i = 0; i < size + lines.Closed[line]; ++i)
    {
      cells->InsertCellPoint(first + i % size);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> MappedAxis(int axis, const Matrix3& matrix, int type = VTK_DOUBLE)
{
  PieceSets one = EmptySets();
  one[axis] = TorusSlices()[axis];
  return ToPolyData(MapSlices(one, matrix), type);
}

/// Expects the surface of the slices as they are, and no message.
void ExpectTorus(FilterRun& run, vtkIdType contours)
{
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty()) << run.Errors[0];
  EXPECT_TRUE(run.Warnings.empty()) << run.Warnings[0];
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, 1);
  EXPECT_EQ(check.TotalGenus(), 1);
  EXPECT_GT(check.TotalVolume(), 0.0);
  EXPECT_EQ(FieldValue(surface, "NumberOfContours"), contours);
}

vtkIdType CountContours()
{
  const PieceSets& sets = TorusSlices();
  return vtkIdType(sets[0].Count()) + sets[1].Count() + sets[2].Count();
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

double ValueOf(vtkTable* table, vtkIdType row, const char* column)
{
  auto* values = vtkDataArray::SafeDownCast(table->GetColumnByName(column));
  EXPECT_NE(values, nullptr) << column;
  return values != nullptr ? values->GetTuple1(row) : 0.0;
}
}

//----------------------------------------------------------------------------
TEST(Inputs, OneMergedDataSetOnAnyPort)
{
  const auto merged = ToPolyData(MapSlices(TorusSlices(), UnitMatrix()));
  for (int port = 0; port < 4; ++port)
  {
    SCOPED_TRACE(port);
    FilterRun run;
    run.Filter->SetInputData(port, merged);
    ExpectTorus(run, CountContours());
    vtkTable* table = run.Filter->GetContourTable();
    ASSERT_EQ(table->GetNumberOfRows(), CountContours());
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      EXPECT_EQ(ValueOf(table, row, "Port"), port);
      EXPECT_EQ(ValueOf(table, row, "Cell"), row);
    }
    EXPECT_EQ(ValueOf(table, 0, "SliceAxis"), 0);
    EXPECT_EQ(ValueOf(table, table->GetNumberOfRows() - 1, "SliceAxis"), 2);
    EXPECT_EQ(table->GetColumnByName("Block"), nullptr);
  }
}

//----------------------------------------------------------------------------
TEST(Inputs, WrongPortsGiveTheSameSurface)
{
  FilterRun right, wrong;
  for (int axis = 0; axis < 3; ++axis)
  {
    right.Filter->SetInputData(axis, MappedAxis(axis, UnitMatrix()));
    wrong.Filter->SetInputData((axis + 2) % 3, MappedAxis(axis, UnitMatrix()));
  }
  ExpectTorus(right, CountContours());
  ExpectTorus(wrong, CountContours());
  vtkPolyData* a = right.Filter->GetOutput();
  vtkPolyData* b = wrong.Filter->GetOutput();
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(a->GetPoint(i)[k], b->GetPoint(i)[k]);
    }
  }
  EXPECT_EQ(right.Filter->GetContourTable()->GetColumnByName("SliceAxis"), nullptr);
  EXPECT_NE(wrong.Filter->GetContourTable()->GetColumnByName("SliceAxis"), nullptr);
}

//----------------------------------------------------------------------------
TEST(Inputs, WhatIsNoContoursIsNamedOnce)
{
  vtkNew<vtkSphereSource> model;
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(model->GetOutputPort());
  slicer->SetNumberOfSlices(7, 7, 7);
  vtkNew<vtkPolyData> points, empty;
  model->Update();
  points->SetPoints(model->GetOutput()->GetPoints());
  const struct
  {
    vtkDataObject* Input; ///< of the y-slices; null leaves it to the slicer
    const char* Warning;
  } cases[] = { { nullptr, nullptr }, { empty, nullptr },
    { points, "The y-slices (port 1) are 50 points without lines or polygons" },
    { model->GetOutput(), "The y-slices (port 1) look like the surface of a model" } };
  for (const auto& input : cases)
  {
    SCOPED_TRACE(input.Warning ? input.Warning : "none");
    FilterRun run;
    for (int port = 0; port < 3; ++port)
    {
      run.Filter->SetInputConnection(port, slicer->GetOutputPort(port));
    }
    if (input.Input)
    {
      run.Filter->SetInputData(1, input.Input);
    }
    EXPECT_GT(run.Update()->GetNumberOfCells(), 0);
    EXPECT_TRUE(run.Errors.empty());
    ASSERT_EQ(run.Warnings.size(), input.Warning ? 1u : 0u);
    EXPECT_TRUE(!input.Warning || run.Warnings[0].find(input.Warning) != std::string::npos);
  }
}

//----------------------------------------------------------------------------
TEST(Inputs, MissingFamiliesAreNamedIfAskedFor)
{
  vtkNew<vtkSphereSource> model;
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(model->GetOutputPort());
  slicer->SetNumberOfSlices(7, 7, 7);
  vtkNew<vtkAppendPolyData> all;
  for (int axis = 0; axis < 3; ++axis)
  {
    all->AddInputConnection(slicer->GetOutputPort(axis));
  }
  const struct
  {
    vtkAlgorithmOutput* Contours;
    int Port;
    bool Asked, Warns;
  } cases[] = { { slicer->GetOutputPort(0), 0, true, true },
    { slicer->GetOutputPort(2), 0, true, true }, { slicer->GetOutputPort(0), 0, false, false },
    { slicer->GetOutputPort(2), 2, true, false }, { slicer->GetOutputPort(0), 3, true, false },
    { all->GetOutputPort(), 0, true, false } };
  for (const auto& input : cases)
  {
    FilterRun run;
    run.Filter->SetInputConnection(input.Port, input.Contours);
    run.Filter->SetWarnOfMissingFamilies(input.Asked);
    EXPECT_GT(run.Update()->GetNumberOfCells(), 0);
    EXPECT_TRUE(run.Errors.empty());
    ASSERT_EQ(run.Warnings.size(), input.Warns ? 1u : 0u);
    EXPECT_TRUE(!input.Warns || run.Warnings[0].find("Only the x-slices") != std::string::npos);
  }
}

//----------------------------------------------------------------------------
TEST(Inputs, CompositeInputsAreTheSumOfTheirBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks, nested;
  vtkNew<vtkPartitionedDataSet> partitions;
  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto data = MappedAxis(static_cast<int>(axis), UnitMatrix());
    blocks->SetBlock(axis + 1, data); // block 0 stays empty
    partitions->SetPartition(axis, data);
    collection->SetPartition(axis, 0, data);
  }
  nested->SetBlock(0, blocks);
  vtkDataObject* inputs[] = { blocks, nested, partitions, collection };
  for (vtkDataObject* input : inputs)
  {
    for (const int port : { 0, 3 })
    {
      SCOPED_TRACE(std::string(input->GetClassName()) + " " + std::to_string(port));
      FilterRun run;
      run.Filter->SetInputDataObject(port, input);
      ExpectTorus(run, CountContours());
      EXPECT_TRUE(run.Filter->GetOutputDataObject(0)->IsA("vtkPolyData"));
      vtkTable* table = run.Filter->GetContourTable();
      ASSERT_EQ(table->GetNumberOfRows(), CountContours());
      // The first contour of the y-slices is cell 0 of a block of its own.
      const vtkIdType row = TorusSlices()[0].Count();
      EXPECT_EQ(ValueOf(table, row, "Cell"), 0);
      EXPECT_GT(ValueOf(table, row, "Block"), ValueOf(table, 0, "Block"));
    }
  }
}

//----------------------------------------------------------------------------
TEST(Inputs, TheSlicersBlocksGoStraightIn)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(3.0 * i, 0.0, 0.0);
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(24);
    sphere->Update();
    blocks->SetBlock(i, sphere->GetOutput());
  }
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputDataObject(blocks);
  slicer->SetNumberOfSlices(9, 9, 9);
  FilterRun run;
  for (int port = 0; port < 3; ++port)
  {
    run.Filter->SetInputConnection(port, slicer->GetOutputPort(port));
  }
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty()) << run.Errors[0];
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, 2);
}

//----------------------------------------------------------------------------
TEST(Inputs, TurnedSlicesSayHowTheyAreTurned)
{
  const Matrix3 rotation = RotationAround({ 1.0, -1.0, 2.0 }, 0.3);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    FilterRun run;
    for (int axis = 0; axis < 3; ++axis)
    {
      run.Filter->SetInputData(axis, MappedAxis(axis, rotation, type));
    }
    ExpectTorus(run, CountContours());
    vtkPolyData* surface = run.Filter->GetOutput();
    EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_DOUBLE);
    vtkDataArray* normals = surface->GetFieldData()->GetArray("FamilyNormals");
    ASSERT_NE(normals, nullptr);
    ASSERT_EQ(normals->GetNumberOfTuples(), 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(normals->GetTuple3(axis)[i], rotation[i][axis], 1e-5);
      }
    }
    run.Filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    ExpectTorus(run, CountContours());
    EXPECT_EQ(run.Filter->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  }
}

//----------------------------------------------------------------------------
/// Where float has few steps between planes, the surface of float contours is made in double.
TEST(Inputs, SlicesInFloatFarFromTheOriginStayApart)
{
  for (const double away : { 0.0, 1e5 })
  {
    FilterRun run;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto data = MappedAxis(axis, UnitMatrix(), VTK_DOUBLE);
      vtkNew<vtkPoints> points;
      points->SetDataTypeToFloat();
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        const double* p = data->GetPoint(i);
        points->InsertNextPoint(10.0 * p[0] + away, 10.0 * p[1] + away, 10.0 * p[2] + away);
      }
      data->SetPoints(points);
      run.Filter->SetInputData(axis, data);
    }
    vtkPolyData* surface = run.Update();
    EXPECT_EQ(surface->GetPoints()->GetDataType(), away > 0.0 ? VTK_DOUBLE : VTK_FLOAT);
    const SurfaceCheck check = CheckSurface(MeshOf(surface));
    EXPECT_TRUE(check.IsClosedManifold()) << check;
    EXPECT_EQ(check.Components, 1);
    EXPECT_EQ(check.TotalGenus(), 1);
  }
}

//----------------------------------------------------------------------------
/// Where the surface is left open at the border of a turned image, the border is turned, too.
TEST(Inputs, BordersAreThoseOfTheFrame)
{
  PieceSets sets = TorusSlices();
  const double border = 0.31;
  CutOff(sets, 0, border, true);
  for (const Matrix3& rotation : { UnitMatrix(), RotationAround({ 1.0, -1.0, 2.0 }, 0.3) })
  {
    FilterRun run;
    run.Filter->SetInputData(3, ToPolyData(MapSlices(sets, rotation)));
    run.Filter->SetBorderContoursToLeaveOpen();
    const TriangleMesh mesh = MeshOf(run.Update());
    EXPECT_TRUE(run.Errors.empty()) << run.Errors[0];
    EXPECT_GT(CheckSurface(mesh).OpenEdges, 20);
    double farthest = -HUGE_VAL;
    for (const Point3& p : mesh.Points)
    {
      farthest = std::max(farthest, Apply(Transpose(rotation), p)[0]);
    }
    EXPECT_NEAR(farthest, border, 1e-9);
  }
}

//----------------------------------------------------------------------------
TEST(Inputs, FramesCanBeGivenOrRefused)
{
  const Matrix3 rotation = RotationAround({ 1.0, -1.0, 2.0 }, 0.3);
  FilterRun run;
  run.Filter->SetInputData(3, ToPolyData(MapSlices(TorusSlices(), rotation)));
  double normals[9];
  for (int i = 0; i < 9; ++i)
  {
    normals[i] = rotation[i % 3][i / 3];
  }
  run.Filter->SetFrameNormals(normals);
  run.Filter->SetFrameToGiven();
  ExpectTorus(run, CountContours());
  std::copy_n(normals, 3, normals + 3);
  run.Filter->SetFrameNormals(normals);
  run.Update();
  ASSERT_GE(run.Errors.size(), 1u);
  EXPECT_TRUE(Contains(run.Errors[0], "FrameNormals")) << run.Errors[0];
  FilterRun world;
  for (int axis = 0; axis < 3; ++axis)
  {
    world.Filter->SetInputData(axis, MappedAxis(axis, rotation));
  }
  world.Filter->SetFrameToWorld();
  world.Update();
  ASSERT_GE(world.Errors.size(), 1u);
  EXPECT_TRUE(Contains(world.Errors[0], "leaves its plane")) << world.Errors[0];
}

//----------------------------------------------------------------------------
TEST(Inputs, OtherPlanesAreComparedWithTheSurface)
{
  // A square around the cube on a slanted plane, which passes it at a distance.
  FilterRun run(ParsePieces(Cube()));
  Polylines slanted;
  for (const Point3& p :
    { Point3{ 0.0, 0.0, 1.5 }, { 3.0, 3.0, 1.5 }, { 3.0, 3.0, 4.5 }, { 0.0, 0.0, 4.5 } })
  {
    slanted.X.push_back(p[0]);
    slanted.Y.push_back(p[1]);
    slanted.Z.push_back(p[2]);
  }
  slanted.Offsets.push_back(4);
  slanted.Closed.push_back(1);
  slanted.From = { { 3 }, { 0 }, { 0 } };
  const vtkIdType cells = run.Update()->GetNumberOfCells();
  const vtkIdType rows = run.Filter->GetContourTable()->GetNumberOfRows();
  run.Filter->SetInputData(3, ToPolyData(slanted));
  EXPECT_EQ(run.Update()->GetNumberOfCells(), cells);
  EXPECT_TRUE(run.Errors.empty());
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_TRUE(Contains(run.Warnings[0], "port 3, cell 0: RMS ")) << run.Warnings[0];
  vtkTable* table = run.Filter->GetContourTable();
  ASSERT_EQ(table->GetNumberOfRows(), rows + 1);
  EXPECT_EQ(ValueOf(table, rows, "Port"), 3.0);
  EXPECT_EQ(ValueOf(table, rows, "SlicePlane"), -1.0);
  // The farthest corners are at (0, 0, 4.5): 2 above the cube, and half of 1 beside it on both
  // sides.
  EXPECT_NEAR(ValueOf(table, rows, "MaxDisagreement"), std::sqrt(4.5), 0.3);
  EXPECT_LT(ValueOf(table, rows, "RmsDisagreement"), ValueOf(table, rows, "MaxDisagreement"));
}
