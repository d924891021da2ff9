// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours of several structures, one surface each; and the table of components
 */

#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"

#include "Support/AnalyticSolids.h"
#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/SliceSolid.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// The slices of one structure.
struct Structure
{
  double Label;
  PieceSets Slices;
};

Structure BallStructure(double label, const Point3& center, double radius)
{
  Solid solid;
  solid.Tubes = { Ball(center, radius) };
  for (int axis = 0; axis < 3; ++axis)
  {
    solid.Low[axis] = center[axis] - 1.2 * radius;
    solid.High[axis] = center[axis] + 1.2 * radius;
  }
  return { label, SliceSolid(solid, EqualPlanes(solid, { 8, 8, 8 }), 6, InPlaneGrid::Aligned) };
}

/// Three balls beside each other, not in the order of their labels.
const std::vector<Structure>& ThreeBalls()
{
  static const std::vector<Structure> balls = { BallStructure(7, { 0, 0, 0 }, 4.0),
    BallStructure(0, { 11, 0, 1 }, 5.0), BallStructure(12, { 0, 12, -1 }, 3.0) };
  return balls;
}

double VolumeOfBall(double radius) { return 4.0 / 3.0 * Pi * radius * radius * radius; }

/// The slices of all structures across one axis, with their labels by `write(label)`.
template <typename Write>
vtkSmartPointer<vtkPolyData> Merge(
  const std::vector<Structure>& structures, int axis, vtkAbstractArray* labels, Write&& write)
{
  Pieces all = EmptySets()[axis];
  for (const Structure& structure : structures)
  {
    const Pieces& pieces = structure.Slices[axis];
    for (Index piece = 0; piece < pieces.Count(); ++piece)
    {
      std::vector<std::array<double, 2>> vertices;
      for (Index i = pieces.Offsets[piece]; i < pieces.Offsets[piece + 1]; ++i)
      {
        vertices.push_back({ pieces.U[i], pieces.V[i] });
      }
      AddPiece(all, vertices, pieces.W[pieces.Offsets[piece]]);
      write(structure.Label);
    }
  }
  auto data = MakePolyData(all);
  labels->SetName("Structure");
  data->GetCellData()->AddArray(labels);
  return data;
}

template <typename Array = vtkIntArray>
vtkSmartPointer<vtkPolyData> MergeNumbered(const std::vector<Structure>& structures, int axis)
{
  vtkNew<Array> labels;
  return Merge(structures, axis, labels, [&](double label) { labels->InsertNextTuple1(label); });
}

std::string NameOf(double label)
{
  return label == 7 ? "lung" : label == 0 ? "heart" : label == 12 ? "spine" : "";
}

vtkSmartPointer<vtkPolyData> MergeNamed(const std::vector<Structure>& structures, int axis)
{
  vtkNew<vtkStringArray> labels;
  return Merge(
    structures, axis, labels, [&](double label) { labels->InsertNextValue(NameOf(label)); });
}

/// A run with labels in the array of the functions above.
struct LabelRun : FilterRun
{
  LabelRun() { this->Filter->SetLabelArray("Structure"); }
  explicit LabelRun(const std::vector<Structure>& structures)
    : LabelRun()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Filter->SetInputData(axis, MergeNumbered(structures, axis));
    }
  }
};

/// Column of port 7.
double ComponentValue(FilterRun& run, vtkIdType row, const char* column)
{
  return run.Filter->GetComponentTable()->GetValueByName(row, column).ToDouble();
}

void ExpectClosed(vtkPolyData* surface, std::int64_t components)
{
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, components);
}

void ExpectSameTuples(vtkDataArray* a, vtkIdType first, vtkDataArray* b, double tolerance = 0.0)
{
  ASSERT_NE(a, nullptr);
  ASSERT_NE(b, nullptr);
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents());
  std::int64_t different = 0;
  for (vtkIdType i = 0; i < b->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < b->GetNumberOfComponents(); ++k)
    {
      different += !(std::abs(a->GetComponent(first + i, k) - b->GetComponent(i, k)) <= tolerance);
    }
  }
  EXPECT_EQ(different, 0) << b->GetName();
}
}

/// Labels side by side are the surfaces of runs of their own, in ascending order.
TEST(Labels, EachIsTheSurfaceOfARunOfItsOwn)
{
  LabelRun run(ThreeBalls());
  vtkPolyData* surface = run.Update();
  ASSERT_TRUE(run.Errors.empty()) << run.Errors[0];
  EXPECT_TRUE(run.Warnings.empty()) << run.Warnings[0];
  ExpectClosed(surface, 3);
  auto* label = surface->GetCellData()->GetArray("Label");
  auto* component = surface->GetCellData()->GetArray("ComponentId");
  ASSERT_NE(vtkIntArray::SafeDownCast(label), nullptr);
  vtkIdType points = 0, cells = 0, graphCells = 0;
  int number = 0;
  for (const std::size_t ball : { 1, 0, 2 })
  {
    LabelRun alone({ ThreeBalls()[ball] });
    vtkPolyData* own = alone.Update();
    FilterRun plain(ThreeBalls()[ball].Slices);
    ExpectSameTuples(own->GetPoints()->GetData(), 0, plain.Update()->GetPoints()->GetData(), 1e-9);
    ExpectSameTuples(surface->GetPoints()->GetData(), points, own->GetPoints()->GetData());
    ExpectSameTuples(
      surface->GetPointData()->GetNormals(), points, own->GetPointData()->GetNormals());
    ExpectSameTuples(surface->GetCellData()->GetArray("GridCell"), cells,
      own->GetCellData()->GetArray("GridCell"));
    for (vtkIdType i = 0; i < own->GetNumberOfCells(); ++i)
    {
      ASSERT_EQ(label->GetTuple1(cells + i), ThreeBalls()[ball].Label);
      ASSERT_EQ(component->GetTuple1(cells + i), number);
    }
    points += own->GetNumberOfPoints();
    cells += own->GetNumberOfCells();
    graphCells += alone.Filter->GetGraphOutput()->GetNumberOfCells();
    ++number;
  }
  EXPECT_EQ(surface->GetNumberOfPoints(), points);
  EXPECT_EQ(surface->GetNumberOfCells(), cells);
  EXPECT_EQ(run.Filter->GetGraphOutput()->GetNumberOfCells(), graphCells);
}

/// Cell data of the graph follow its cells: vertices of all labels come before lines of all labels.
TEST(Labels, GraphArraysAreThoseOfTheirCells)
{
  LabelRun run(ThreeBalls());
  run.Update();
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  auto* kind = graph->GetCellData()->GetArray("Kind");
  auto* length = graph->GetCellData()->GetArray("Length");
  auto* label = graph->GetCellData()->GetArray("Label");
  ASSERT_EQ(kind->GetNumberOfTuples(), graph->GetNumberOfCells());
  ASSERT_EQ(label->GetNumberOfTuples(), graph->GetNumberOfCells());
  std::set<double> labels;
  for (vtkIdType i = 0; i < graph->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(graph->GetCellType(i) == VTK_VERTEX, kind->GetTuple1(i) == 0.0);
    EXPECT_EQ(kind->GetTuple1(i) == 0.0, length->GetTuple1(i) == 0.0);
    double bounds[6];
    graph->GetCellBounds(i, bounds);
    EXPECT_EQ(label->GetTuple1(i) == 0.0, bounds[1] > 5.5);
    labels.insert(label->GetTuple1(i));
  }
  EXPECT_EQ(labels, (std::set<double>{ 0.0, 7.0, 12.0 }));
}

TEST(Labels, TablesAndFieldData)
{
  LabelRun run(ThreeBalls());
  vtkPolyData* surface = run.Update();
  for (int port = 2; port < 8; ++port)
  {
    auto* table = vtkTable::SafeDownCast(run.Filter->GetOutputDataObject(port));
    ASSERT_GT(table->GetNumberOfColumns(), 1) << port;
    EXPECT_STREQ(table->GetColumnName(0), "Label") << port;
  }
  vtkTable* contours = run.Filter->GetContourTable();
  vtkIdType all = 0;
  for (const Structure& ball : ThreeBalls())
  {
    all += ball.Slices[0].Count() + ball.Slices[1].Count() + ball.Slices[2].Count();
  }
  EXPECT_EQ(contours->GetNumberOfRows(), all);
  EXPECT_EQ(FieldValue(surface, "NumberOfContours"), all);
  EXPECT_EQ(FieldValue(surface, "NumberOfComponents"), 3);
  ASSERT_EQ(run.Filter->GetComponentTable()->GetNumberOfRows(), 3);
  const double radii[] = { 5.0, 4.0, 3.0 };
  auto* volumes = surface->GetFieldData()->GetArray("LabelVolume");
  auto* names =
    vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray("LabelNames"));
  ASSERT_NE(names, nullptr);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(ComponentValue(run, i, "ComponentId"), i);
    EXPECT_NEAR(
      ComponentValue(run, i, "Volume"), VolumeOfBall(radii[i]), 0.02 * VolumeOfBall(radii[i]));
    EXPECT_NEAR(ComponentValue(run, i, "Area"), 4.0 * Pi * radii[i] * radii[i],
      0.02 * 4.0 * Pi * radii[i] * radii[i]);
    EXPECT_EQ(volumes->GetTuple1(i), ComponentValue(run, i, "Volume"));
  }
  EXPECT_NEAR(ComponentValue(run, 0, "CentroidX"), 11.0, 0.05);
  EXPECT_NEAR(ComponentValue(run, 2, "CentroidY"), 12.0, 0.05);
  EXPECT_EQ(names->GetValue(0), "0");
  EXPECT_EQ(names->GetValue(2), "12");
}

TEST(Labels, NamesAreNumberedAndListed)
{
  LabelRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, MergeNamed(ThreeBalls(), axis));
  }
  vtkPolyData* surface = run.Update();
  ASSERT_TRUE(run.Errors.empty()) << run.Errors[0];
  ExpectClosed(surface, 3);
  auto* names =
    vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray("LabelNames"));
  ASSERT_NE(names, nullptr);
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  EXPECT_EQ(names->GetValue(0), "heart");
  EXPECT_EQ(names->GetValue(1), "lung");
  EXPECT_EQ(names->GetValue(2), "spine");
  double range[2];
  surface->GetCellData()->GetArray("Label")->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 2.0);
  vtkTable* table = run.Filter->GetComponentTable();
  EXPECT_EQ(table->GetValueByName(0, "Label").ToString(), "heart");
  EXPECT_NEAR(ComponentValue(run, 0, "CentroidX"), 11.0, 0.05);
}

/// Numbers keep the type that all inputs have; of several types they become double.
TEST(Labels, TypesOfNumbers)
{
  LabelRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, MergeNumbered<vtkUnsignedCharArray>(ThreeBalls(), axis));
  }
  EXPECT_NE(
    vtkUnsignedCharArray::SafeDownCast(run.Update()->GetCellData()->GetArray("Label")), nullptr);
  run.Filter->SetInputData(0, MergeNumbered<vtkIntArray>(ThreeBalls(), 0));
  vtkPolyData* surface = run.Update();
  EXPECT_NE(vtkDoubleArray::SafeDownCast(surface->GetCellData()->GetArray("Label")), nullptr);
  ExpectClosed(surface, 3);
}

TEST(Labels, OneStackAndOneInputForAllFamilies)
{
  LabelRun stack;
  stack.Filter->SetInputData(2, MergeNumbered(ThreeBalls(), 2));
  ExpectClosed(stack.Update(), 3);
  EXPECT_TRUE(stack.Errors.empty()) << stack.Errors[0];
  LabelRun any;
  any.Filter->SetInputData(3, MergeNumbered(ThreeBalls(), 1));
  ExpectClosed(any.Update(), 3);
  EXPECT_TRUE(any.Errors.empty()) << any.Errors[0];
}

TEST(Labels, WithoutLabelArrayThereAreNoArrays)
{
  LabelRun run(ThreeBalls());
  for (const char* none : { "", "None", static_cast<const char*>(nullptr) })
  {
    run.Filter->SetLabelArray(none);
    vtkPolyData* surface = run.Update();
    ExpectClosed(surface, 3);
    EXPECT_EQ(surface->GetCellData()->GetAbstractArray("Label"), nullptr);
    EXPECT_EQ(surface->GetFieldData()->GetAbstractArray("LabelNames"), nullptr);
    EXPECT_STREQ(run.Filter->GetComponentTable()->GetColumnName(0), "ComponentId");
    EXPECT_EQ(run.Filter->GetComponentTable()->GetNumberOfRows(), 3);
  }
}

TEST(Labels, AllInputsSayWhichArraysThereAre)
{
  LabelRun none;
  EXPECT_EQ(none.Filter->GetCellArrayNames()->GetNumberOfValues(), 0);
  LabelRun run;
  run.Filter->SetInputData(1, MergeNamed(ThreeBalls(), 1));
  auto last = MergeNumbered(ThreeBalls(), 2);
  vtkNew<vtkDoubleArray> other;
  other->SetNumberOfTuples(last->GetNumberOfCells());
  other->SetName("Depth");
  last->GetCellData()->AddArray(other);
  vtkNew<vtkDoubleArray> nameless;
  nameless->SetNumberOfTuples(last->GetNumberOfCells());
  last->GetCellData()->AddArray(nameless);
  run.Filter->SetInputData(3, last);
  for (int twice = 0; twice < 2; ++twice)
  {
    vtkStringArray* names = run.Filter->GetCellArrayNames();
    ASSERT_EQ(names->GetNumberOfValues(), 2);
    EXPECT_EQ(names->GetValue(0), "Depth");
    EXPECT_EQ(names->GetValue(1), "Structure");
  }
}

TEST(Labels, AnArrayThatNoInputHasIsAnError)
{
  LabelRun run(ThreeBalls());
  run.Filter->SetLabelArray("Organ");
  EXPECT_EQ(run.Update()->GetNumberOfCells(), 0);
  ASSERT_EQ(run.Errors.size(), 2u); // that of the filter and that of its executive
  EXPECT_NE(run.Errors[0].find("Organ"), std::string::npos) << run.Errors[0];
}

TEST(Labels, ContoursWithoutLabelTakeNoPart)
{
  std::vector<Structure> balls = ThreeBalls();
  balls[0].Label = std::nan("");
  LabelRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, MergeNumbered<vtkDoubleArray>(balls, axis));
  }
  ExpectClosed(run.Update(), 2);
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_NE(run.Warnings[0].find("have no label"), std::string::npos) << run.Warnings[0];
  balls[0].Label = 1.0; // a structure without a name
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, MergeNamed(balls, axis));
  }
  ExpectClosed(run.Update(), 2);
  EXPECT_EQ(run.Warnings.size(), 1u);
}

namespace
{
/// Makes a contour of the z-slices of a ball cross itself.
void Twist(Structure& ball)
{
  Pieces& pieces = ball.Slices[2];
  const Index middle = pieces.Count() / 2;
  const Index first = pieces.Offsets[middle];
  const Index half = (pieces.Offsets[middle + 1] - first) / 2;
  std::swap(pieces.U[first], pieces.U[first + half]);
  std::swap(pieces.V[first], pieces.V[first + half]);
}
}

TEST(Labels, OneThatIsRefusedDoesNotCostTheOthers)
{
  std::vector<Structure> balls = ThreeBalls();
  Twist(balls[0]);
  LabelRun run(balls);
  run.Filter->SetCrossingContoursToRefuse();
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty()) << run.Errors[0];
  ExpectClosed(surface, 2);
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_NE(run.Warnings[0].find("Label 7 has no surface"), std::string::npos) << run.Warnings[0];
  EXPECT_EQ(run.Warnings[0].find("Label 12"), std::string::npos) << run.Warnings[0];
  EXPECT_EQ(surface->GetFieldData()->GetArray("LabelVolume")->GetTuple1(1), 0.0);
  EXPECT_GT(surface->GetFieldData()->GetArray("LabelVolume")->GetTuple1(2), 0.0);

  Twist(balls[1]);
  Twist(balls[2]);
  LabelRun none(balls);
  none.Filter->SetCrossingContoursToRefuse();
  EXPECT_EQ(none.Update()->GetNumberOfCells(), 0);
  ASSERT_FALSE(none.Errors.empty());
  EXPECT_NE(none.Errors[0].find("Label 12"), std::string::npos) << none.Errors[0];
}

/// Progress ascends over all labels; an abort leaves nothing half done.
TEST(Labels, ProgressAndAbort)
{
  LabelRun run(ThreeBalls());
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&progress);
  listen->SetCallback(
    [](vtkObject* filter, unsigned long, void* values, void*)
    {
      static_cast<std::vector<double>*>(values)->push_back(
        static_cast<vtkAlgorithm*>(filter)->GetProgress());
    });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, listen);
  run.Update();
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_GT(progress.size(), 15u);

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* filter, unsigned long, void*, void*)
    {
      auto* algorithm = static_cast<vtkAlgorithm*>(filter);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.6);
    });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  run.Filter->Modified();
  EXPECT_EQ(run.Update()->GetNumberOfCells(), 0);
  EXPECT_EQ(run.Filter->GetProgressScale(), 1.0);
}

namespace
{
/// A ball of three labels: two halves with a bent border, and a small ball inside one of them.
vtkSmartPointer<vtkImageData> LabelImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-20, -20, -20);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int z = -20; z <= 20; ++z)
  {
    for (int y = -20; y <= 20; ++y)
    {
      for (int x = -20; x <= 20; ++x)
      {
        const bool inside = x * x + y * y + z * z < 16 * 16;
        const bool core = (x + 7) * (x + 7) + y * y + z * z < 5 * 5;
        const bool left = x < 0.02 * (y * y - z * z) + 1.5;
        const int label = !inside ? 0 : core ? 9 : left ? 3 : 4;
        image->SetScalarComponentFromDouble(x + 20, y + 20, z + 20, 0, label);
      }
    }
  }
  return image;
}

/// The surfaces of all labels, from so many slices on each axis.
vtkPolyData* ReconstructEveryLabel(vtkOrthogonalSlicer* slicer, int slices, FilterRun& run)
{
  slicer->EveryLabelOn();
  slicer->SetNumberOfSlices(slices, slices, slices);
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputConnection(axis, slicer->GetOutputPort(axis));
  }
  run.Filter->SetLabelArray("Label");
  return run.Update();
}
}

TEST(Labels, FromAnImageOfLabels)
{
  const auto image = LabelImage();
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(image);
  FilterRun run;
  vtkPolyData* surface = ReconstructEveryLabel(slicer, 41, run);
  ASSERT_TRUE(run.Errors.empty()) << run.Errors[0];
  EXPECT_NE(vtkUnsignedCharArray::SafeDownCast(surface->GetCellData()->GetArray("Label")), nullptr);
  // The label around the small ball has an outer surface and a cavity.
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(check.Components, 4);
  auto* names =
    vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray("LabelNames"));
  auto* volumes = surface->GetFieldData()->GetArray("LabelVolume");
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  double total = 0.0;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    vtkIdType samples = 0;
    for (vtkIdType k = 0; k < image->GetNumberOfPoints(); ++k)
    {
      samples += image->GetPointData()->GetScalars()->GetTuple1(k) == std::stod(names->GetValue(i));
    }
    EXPECT_NEAR(volumes->GetTuple1(i), static_cast<double>(samples), 0.03 * samples)
      << names->GetValue(i);
    total += volumes->GetTuple1(i);
  }
  EXPECT_NEAR(total, VolumeOfBall(16.0), 0.02 * VolumeOfBall(16.0));
}

namespace
{
/// The triangles of a label, each as the set of its corners.
std::set<std::set<Point3>> TrianglesOf(vtkPolyData* surface, double label)
{
  const TriangleMesh mesh = MeshOf(surface);
  auto* labels = surface->GetCellData()->GetArray("Label");
  std::set<std::set<Point3>> triangles;
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    if (labels->GetTuple1(static_cast<vtkIdType>(i)) == label)
    {
      const auto& corners = mesh.Triangles[i];
      triangles.insert(
        { mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]] });
    }
  }
  return triangles;
}
}

/// Where contours of two labels are the same, their surfaces are, triangle for triangle.
TEST(Labels, CommonBordersAreTheSameTriangles)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(LabelImage());
  FilterRun run;
  vtkPolyData* surface = ReconstructEveryLabel(slicer, 20, run);
  ASSERT_TRUE(run.Errors.empty()) << run.Errors[0];
  const auto left = TrianglesOf(surface, 3), right = TrianglesOf(surface, 4);
  double area = 0.0;
  for (const auto& triangle : left)
  {
    if (right.count(triangle) > 0)
    {
      const std::vector<Point3> corners(triangle.begin(), triangle.end());
      area += 0.5 * Length(Cross(corners[1] - corners[0], corners[2] - corners[0]));
    }
  }
  // The border is a disc of radius 16, and not quite even; beside its rim cells have three parts.
  EXPECT_GT(area, 0.75 * Pi * 16.0 * 16.0);
}
