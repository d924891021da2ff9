// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   surfaces of structures that touch neither cross, nor overlap, nor leave gaps
 */

#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"

#include "Support/CheckLabels.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// A ball in an image, divided among places by which of them is nearest: what lies around each is a label,
/// 1 and up, and all together are convex.
vtkSmartPointer<vtkImageData> DividedBall(int size, const std::vector<Point3>& places)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const double middle = 0.5 * (size - 1), radius = 0.4 * size;
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        const Point3 p{ (i - middle) / radius, (j - middle) / radius, (k - middle) / radius };
        const auto distance = [&](const Point3& q)
        { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); };
        const auto nearest = std::min_element(places.begin(), places.end(),
          [&](const Point3& a, const Point3& b) { return distance(a) < distance(b); });
        const double label = distance({ 0, 0, 0 }) < 1.0 ? 1.0 + (nearest - places.begin()) : 0.0;
        image->SetScalarComponentFromDouble(i, j, k, 0, label);
      }
    }
  }
  return image;
}

/// Places for three labels that meet in a curve, and for five that meet in curves and points.
const std::vector<Point3>& Three()
{
  static const std::vector<Point3> places{ { -0.5, -0.2, 0.1 }, { 0.4, -0.4, -0.1 },
    { 0.1, 0.5, 0.0 } };
  return places;
}
const std::vector<Point3>& Five()
{
  static const std::vector<Point3> places{ { -0.5, -0.3, 0.2 }, { 0.5, -0.4, 0.1 },
    { 0.1, 0.6, 0.2 }, { 0.0, 0.0, -0.6 }, { 0.1, -0.1, 0.6 } };
  return places;
}

/// The labels of all triangles, numbered from 0 on.
std::vector<int> LabelsOf(vtkPolyData* surface)
{
  auto* array = surface->GetCellData()->GetArray("Label");
  std::map<double, int> numbers;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    numbers[array->GetTuple1(i)] = 0;
  }
  int next = 0;
  for (auto& number : numbers)
  {
    number.second = next++;
  }
  std::vector<int> labels;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    labels.push_back(numbers[array->GetTuple1(i)]);
  }
  return labels;
}

/// What is wrong between the labels of a surface.
struct Borders
{
  explicit Borders(vtkPolyData* surface)
  {
    const TriangleMesh mesh = MeshOf(surface);
    const std::vector<int> labels = LabelsOf(surface);
    this->Check = CheckSurface(mesh);
    this->Crossings = CountLabelCrossings(mesh, labels);
    const LabelVolumes volumes = MeasureLabels(mesh, labels);
    this->Count = volumes.OfLabel.size();
    this->Volume = std::accumulate(volumes.OfLabel.begin(), volumes.OfLabel.end(), 0.0);
    this->Overlap = volumes.Overlap / this->Volume;
    this->Gap = volumes.Gap / this->Volume;
  }

  SurfaceCheck Check;
  std::int64_t Crossings;
  std::size_t Count;
  double Volume, Overlap, Gap;
};

/// A ball of an image, cut into so many slices on each axis, 0 for none, and reconstructed.
Borders Reconstruct(const std::vector<Point3>& places, const std::array<int, 3>& slices)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(DividedBall(48, places));
  slicer->EveryLabelOn();
  slicer->SetNumberOfSlices(std::max(1, slices[0]), std::max(1, slices[1]), std::max(1, slices[2]));
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (slices[axis] > 0)
    {
      run.Filter->SetInputConnection(axis, slicer->GetOutputPort(axis));
    }
  }
  run.Filter->SetLabelArray("Label");
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty());
  return Borders(surface);
}
}

TEST(LabelBorders, DoNotCrossInDenseSlices)
{
  for (const std::vector<Point3>* places : { &Three(), &Five() })
  {
    const Borders borders = Reconstruct(*places, { 16, 16, 16 });
    EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
    EXPECT_EQ(borders.Count, places->size());
    EXPECT_EQ(borders.Crossings, 0);
    EXPECT_LT(borders.Overlap, 1e-5);
    EXPECT_LT(borders.Gap, 0.002);
  }
}

TEST(LabelBorders, DoNotCrossInOneStack)
{
  const Borders borders = Reconstruct(Three(), { 0, 0, 16 });
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_EQ(borders.Count, 3u);
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Overlap, 1e-5);
  EXPECT_LT(borders.Gap, 0.002);
}

/// With two families, and where many labels meet in points, a few cells are left in sparse slices.
TEST(LabelBorders, HardlyCrossInOtherSparseSlices)
{
  const std::pair<std::vector<Point3>, std::array<int, 3>> cases[] = { { Three(), { 16, 0, 16 } },
    { Five(), { 0, 0, 16 } }, { Five(), { 16, 16, 0 } } };
  for (const auto& [places, slices] : cases)
  {
    const Borders borders = Reconstruct(places, slices);
    EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
    EXPECT_EQ(borders.Count, places.size());
    EXPECT_LT(borders.Crossings, 50); // thousands, if each label is reconstructed by itself
    EXPECT_LT(borders.Overlap, 1e-4);
    EXPECT_LT(borders.Gap, 0.002);
  }
}

namespace
{
/// A vertex of a contour on the slice across an axis.
void AddVertex(int axis, double u, double v, double w, vtkPoints* points)
{
  Point3 p;
  p[FirstAxis(axis)] = u;
  p[SecondAxis(axis)] = v;
  p[axis] = w;
  points->InsertNextPoint(p.data());
}

/// The part of a circle around the origin, of one slice, where x, which is the coordinate `x` (0 or 1) of
/// the slice, is less (`side` -1) or more (1) than a border: an arc and the straight line between its ends.
void AddPart(int axis, int x, double radius, double border, int side, double w, vtkPolyData* data)
{
  constexpr int parts = 200;
  const vtkIdType first = data->GetNumberOfPoints();
  const double half = std::acos(std::clamp(side * border / radius, -1.0, 1.0));
  const auto add = [&](double along, double across)
  { AddVertex(axis, x == 0 ? along : across, x == 0 ? across : along, w, data->GetPoints()); };
  for (int i = 0; i <= parts; ++i)
  {
    const double angle = half * (2.0 * i / parts - 1.0);
    add(side * radius * std::cos(angle), radius * std::sin(angle));
  }
  const double end = radius * std::sin(half);
  for (int i = 1; i < parts; ++i)
  {
    // Both sides have other vertices on their common line.
    const double share = static_cast<double>(i) / parts;
    add(border, end * (1.0 - 2.0 * (side < 0 ? share : share * share)));
  }
  data->GetLines()->InsertNextCell(data->GetNumberOfPoints() - first + 1);
  for (vtkIdType i = first; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetLines()->InsertCellPoint(i);
  }
  data->GetLines()->InsertCellPoint(first);
}

constexpr double BallRadius = 10.0;

/// Slices of a ball across an axis, cut in two at x = 0.3 but for some overlap.
vtkSmartPointer<vtkPolyData> CutBall(int axis, double overlap)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtkSmartPointer<vtkPoints>::New());
  data->GetPoints()->SetDataTypeToDouble();
  data->SetLines(vtkSmartPointer<vtkCellArray>::New());
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  for (double w = -9.1; w < BallRadius; w += 1.7)
  {
    const double radius = std::sqrt(BallRadius * BallRadius - w * w);
    for (const int side : { -1, 1 })
    {
      const double border = 0.3 - 0.5 * side * overlap;
      const int x = FirstAxis(axis) == 0 ? 0 : 1;
      if (axis == 0 ? side * (w - border) > 0.0 : radius > std::abs(border))
      {
        AddPart(axis, x, radius, axis == 0 ? -side * radius : border, side, w, data);
        labels->InsertNextValue(side);
      }
    }
  }
  data->GetCellData()->AddArray(labels);
  return data;
}

vtkPolyData* ReconstructCutBall(double overlap, FilterRun& run)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, CutBall(axis, overlap));
  }
  run.Filter->SetLabelArray("Label");
  return run.Update();
}
}

/// Two contours along one line need not have the same vertices there.
TEST(LabelBorders, AreSharedBetweenOtherVertices)
{
  FilterRun run;
  const Borders borders(ReconstructCutBall(0.0, run));
  ASSERT_TRUE(run.Errors.empty()) << run.Errors[0];
  EXPECT_TRUE(run.Warnings.empty()) << run.Warnings[0];
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Overlap, 1e-5);
  EXPECT_LT(borders.Gap, 0.001);
  const double volume = 4.0 / 3.0 * 3.14159265358979 * std::pow(BallRadius, 3);
  EXPECT_NEAR(borders.Volume, volume, 0.01 * volume);
}

/// Labels that overlap keep what was drawn, and a warning says so.
TEST(LabelBorders, OverlapsAreKeptAndNamed)
{
  FilterRun run;
  const Borders borders(ReconstructCutBall(2.0, run));
  ASSERT_TRUE(run.Errors.empty()) << run.Errors[0];
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_GT(borders.Overlap, 0.1);
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_NE(run.Warnings[0].find("-1 and 1"), std::string::npos) << run.Warnings[0];
}
