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
#include "Support/LabelImages.h"
#include "Support/TurnedSlices.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <vector>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
vtkSmartPointer<vtkImageData> ToVtk(const LabelImage& labels)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(labels.Size, labels.Size, labels.Size);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::copy(labels.Labels.begin(), labels.Labels.end(),
    static_cast<std::uint8_t*>(image->GetScalarPointer()));
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

/// The area of triangles that two labels have in common, each on its own side of it.
double CommonArea(const TriangleMesh& mesh, const std::vector<int>& labels)
{
  using Corners = std::array<Point3, 3>;
  std::map<Corners, std::vector<std::pair<int, bool>>> uses;
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const auto& t = mesh.Triangles[i];
    Corners corners{ mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]] };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const bool isReversed = corners[2] < corners[1];
    std::sort(corners.begin(), corners.end());
    uses[corners].emplace_back(labels[i], isReversed);
  }
  double area = 0.0;
  for (const auto& [c, sides] : uses)
  {
    if (sides.size() == 2 && sides[0].first != sides[1].first && sides[0].second != sides[1].second)
    {
      area += 0.5 * Length(Cross(c[1] - c[0], c[2] - c[0]));
    }
  }
  return area;
}

/// What is wrong between the labels of a surface.
struct Borders
{
  explicit Borders(vtkPolyData* surface)
  {
    this->Mesh = MeshOf(surface);
    const TriangleMesh& mesh = this->Mesh;
    const std::vector<int> labels = LabelsOf(surface);
    this->Check = CheckSurface(mesh);
    this->Crossings = CountLabelCrossings(mesh, labels);
    const LabelVolumes volumes = MeasureLabels(mesh, labels);
    this->Count = volumes.OfLabel.size();
    this->Triangles = static_cast<double>(mesh.Triangles.size());
    this->Volume = std::accumulate(volumes.OfLabel.begin(), volumes.OfLabel.end(), 0.0);
    this->Overlap = volumes.Overlap / this->Volume;
    this->Gap = volumes.Gap / this->Volume;
    this->Common = CommonArea(mesh, labels);
    const auto measure = [&](const char* name)
    { return surface->GetFieldData()->GetArray(name)->GetTuple1(0); };
    this->ShareAbove20Degrees = measure("ShareOfTrianglesAbove20Degrees");
    this->SmallestAngle = measure("SmallestAngle");
  }

  TriangleMesh Mesh;
  SurfaceCheck Check;
  std::int64_t Crossings;
  std::size_t Count;
  double Volume, Overlap, Gap, Triangles, Common, ShareAbove20Degrees, SmallestAngle;
};

/// An image, cut into so many slices on each axis, 0 for none, and reconstructed; with all triangles,
/// unless the change wants few.
Borders Reconstruct(const LabelImage& image, const std::array<int, 3>& slices,
  std::vector<std::string>* warnings = nullptr,
  const std::function<void(vtkOrthogonalSliceReconstruction*)>& change = {})
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(ToVtk(image));
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
  run.Filter->AutomaticAccuracyOff(); // unless the change wants few triangles
  if (change)
  {
    change(run.Filter);
  }
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty());
  if (warnings != nullptr)
  {
    *warnings = run.Warnings;
  }
  return Borders(surface);
}

/// 1 for all labels of an image.
LabelImage WholeOf(LabelImage image)
{
  for (std::uint8_t& label : image.Labels)
  {
    label = label > 0 ? 1 : 0;
  }
  return image;
}
}

TEST(LabelBorders, DoNotCrossInDenseSlices)
{
  for (const std::vector<Point3>* places : { &Three(), &Five() })
  {
    const Borders borders = Reconstruct(DivideBall(*places), { 16, 16, 16 });
    EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
    EXPECT_EQ(borders.Count, places->size());
    EXPECT_EQ(borders.Crossings, 0);
    EXPECT_LT(borders.Overlap, 1e-5);
    EXPECT_LT(borders.Gap, 0.002);
  }
}

TEST(LabelBorders, DoNotCrossInOneStack)
{
  const Borders borders = Reconstruct(DivideBall(Three()), { 0, 0, 16 });
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_EQ(borders.Count, 3u);
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Overlap, 1e-5);
  EXPECT_LT(borders.Gap, 0.002);
}

/// Nor where many labels meet, in few slices, along one axis or two.
TEST(LabelBorders, DoNotCrossInOtherSparseSlices)
{
  const std::pair<std::vector<Point3>, std::array<int, 3>> cases[] = { { Three(), { 16, 0, 16 } },
    { Five(), { 0, 0, 16 } }, { Five(), { 16, 16, 0 } }, { Five(), { 3, 3, 16 } } };
  for (const auto& [places, slices] : cases)
  {
    const Borders borders = Reconstruct(DivideBall(places), slices);
    EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
    EXPECT_EQ(borders.Count, places.size());
    EXPECT_EQ(borders.Crossings, 0);
    EXPECT_LT(borders.Overlap, 1e-4);
    EXPECT_LT(borders.Gap, 0.002);
  }
}

/// A row of the table of few triangles.
void PrintRow(const char* name, bool keepsVertices, const Borders& all, const Borders& few)
{
  std::printf("| %s%s | %.0f | %.0f | %.2f | %.1f → %.1f | %.2g → %.2g | %.3f → %.3f |\n", name,
    keepsVertices ? ", kept" : "", all.Triangles, few.Triangles, few.Triangles / all.Triangles,
    100.0 * all.ShareAbove20Degrees, 100.0 * few.ShareAbove20Degrees, all.SmallestAngle,
    few.SmallestAngle, 100.0 * all.Gap, 100.0 * few.Gap);
}

/// Few triangles are the same on common borders as many are, and leave no more out.
TEST(LabelBorders, DoNotCrossWithFewTriangles)
{
  const struct
  {
    const char* Name;
    LabelImage Image;
    std::array<int, 3> Slices;
  } cases[] = { { "3 in a ball, 16 x 16 x 16", DivideBall(Three()), { 16, 16, 16 } },
    { "5 in a ball, 16 x 16", DivideBall(Five()), { 16, 16, 0 } },
    { "8 with wavy borders, 16 x 16 x 16", MakeLabelImage(LabelKind::Wavy, 8, 1), { 16, 16, 16 } },
    { "8 nested, one stack of 16", MakeLabelImage(LabelKind::Nested, 8, 1), { 0, 0, 16 } },
    { "3 thin layers, 16 x 16 x 16", MakeLabelImage(LabelKind::Layers, 3, 1), { 16, 16, 16 } } };
  for (const auto& [name, image, slices] : cases)
  {
    const Borders all = Reconstruct(image, slices);
    for (const bool keepsVertices : { false, true })
    {
      const Borders few = Reconstruct(image, slices, nullptr,
        [&](vtkOrthogonalSliceReconstruction* filter)
        {
          filter->AutomaticAccuracyOn();
          filter->SetKeepContourVertices(keepsVertices);
        });
      PrintRow(name, keepsVertices, all, few);
      EXPECT_TRUE(few.Check.IsClosedManifold()) << few.Check;
      EXPECT_EQ(few.Count, all.Count);
      EXPECT_EQ(few.Crossings, 0);
      EXPECT_LT(few.Overlap, 1e-4);
      EXPECT_LT(few.Gap, all.Gap + 0.0005);
      EXPECT_GT(few.Common, 0.99 * all.Common);
      EXPECT_GT(few.ShareAbove20Degrees, keepsVertices ? 0.95 : 0.98);
      EXPECT_NEAR(few.Volume, all.Volume, 0.003 * all.Volume);
      EXPECT_LT(few.Triangles, (keepsVertices ? 1.0 : 0.65) * all.Triangles);
    }
  }
}

/// Triangles of all labels are improved together, the same for any number of threads.
TEST(LabelBorders, FewTrianglesDoNotDependOnThreads)
{
  const LabelImage image = DivideBall(Five(), 32);
  const auto few = [](vtkOrthogonalSliceReconstruction* filter) { filter->AutomaticAccuracyOn(); };
  TriangleMesh one;
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        const Borders borders = Reconstruct(image, { 10, 10, 10 }, nullptr, few);
        one = threads == 1 ? borders.Mesh : one;
        EXPECT_EQ(borders.Mesh.Points, one.Points);
        EXPECT_EQ(borders.Mesh.Triangles, one.Triangles);
      });
  }
}

/// All labels together fill what they would fill as one label: nothing is missing where three of
/// them meet on the outside, and nothing between a thin shell and the labels on both sides of it.
TEST(LabelBorders, LeaveNothingOut)
{
  for (const LabelImage& image :
    { MakeLabelImage(LabelKind::Box, 8, 1), MakeLabelImage(LabelKind::Nested, 12, 2) })
  {
    const double whole = Reconstruct(WholeOf(image), { 16, 16, 16 }).Check.TotalVolume();
    const double sum = Reconstruct(image, { 16, 16, 16 }).Check.TotalVolume();
    EXPECT_NEAR(sum, whole, 2e-4 * whole);
  }
}

/// Where a label falls into more parts because of its neighbours, a warning says so.
TEST(LabelBorders, PartsThatAreSeparatedAreCounted)
{
  std::vector<std::string> warnings;
  Reconstruct(MakeLabelImage(LabelKind::Nested, 12, 2), { 16, 16, 16 }, &warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("Label 10: Other labels are so close"), std::string::npos)
    << warnings[0];
}

namespace
{
/// Images of other kinds: eight labels in a box, by wavy borders, in blocks, in one another; thin
/// layers; and stairs.
LabelImage ImageOfKind(int kind)
{
  switch (kind)
  {
    case 0:
      return MakeLabelImage(LabelKind::Box, 8, 1);
    case 1:
      return MakeLabelImage(LabelKind::Wavy, 8, 1);
    case 2:
      return MakeLabelImage(LabelKind::Corners, 8, 1);
    case 3:
      return MakeLabelImage(LabelKind::Nested, 8, 1);
    case 4:
      return MakeLabelImage(LabelKind::Layers, 3, 1);
    default:
      return Coarsen(MakeLabelImage(LabelKind::Ball, 5, 3), 4);
  }
}

class LabelBordersOfKind : public ::testing::TestWithParam<int>
{
};
}

TEST_P(LabelBordersOfKind, DoNotCross)
{
  const LabelImage image = ImageOfKind(GetParam());
  const std::array<int, 3> slices[] = { { 0, 0, 16 }, { 16, 0, 16 }, { 4, 4, 4 }, { 16, 16, 16 } };
  for (const std::array<int, 3>& counts : slices)
  {
    SCOPED_TRACE(std::to_string(counts[0]) + ", " + std::to_string(counts[1]) + ", " +
      std::to_string(counts[2]));
    const Borders borders = Reconstruct(image, counts);
    EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
    EXPECT_EQ(borders.Crossings, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, LabelBordersOfKind, ::testing::Range(0, 6));

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

/// The part of a circle around the origin, of one slice, where x, which is the coordinate `x` (0 or
/// 1) of the slice, is less (`side` -1) or more (1) than a border: an arc and the straight line
/// between its ends.
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

namespace
{
/// Moves slices across an axis by some way in their plane, each by another one, or swaps two labels
/// on every fifth of them.
void Contradict(int axis, bool isSwapped, vtkPolyData* slices)
{
  std::map<double, int> numbers; // of slices, by their coordinates
  for (vtkIdType i = 0; i < slices->GetNumberOfPoints(); ++i)
  {
    numbers[slices->GetPoint(i)[axis]] = 0;
  }
  int next = 0;
  for (auto& number : numbers)
  {
    number.second = next++;
  }
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < slices->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    slices->GetPoint(i, p.data());
    const int number = numbers[p[axis]];
    p[FirstAxis(axis)] += isSwapped ? 0.0 : 1.5 * std::sin(5.0 * number + axis);
    p[SecondAxis(axis)] += isSwapped ? 0.0 : 1.5 * std::cos(3.0 * number + axis);
    moved->InsertNextPoint(p.data());
  }
  vtkDataArray* labels = slices->GetCellData()->GetArray("Label");
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; isSwapped && i < slices->GetNumberOfCells(); ++i)
  {
    slices->GetCellPoints(i, ids);
    const double label = labels->GetTuple1(i);
    if (numbers[slices->GetPoint(ids->GetId(0))[axis]] % 5 == 2 && label < 3.0)
    {
      labels->SetTuple1(i, 3.0 - label);
    }
  }
  slices->SetPoints(moved);
}

/// An image cut into slices that contradict each other, and reconstructed.
Borders ReconstructContradicted(
  const LabelImage& image, const std::array<int, 3>& slices, bool isSwapped)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(ToVtk(image));
  slicer->EveryLabelOn();
  slicer->SetNumberOfSlices(std::max(1, slices[0]), std::max(1, slices[1]), std::max(1, slices[2]));
  slicer->Update();
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (slices[axis] > 0)
    {
      vtkNew<vtkPolyData> data;
      data->DeepCopy(slicer->GetOutput(axis));
      Contradict(axis, isSwapped, data);
      run.Filter->SetInputData(axis, data);
    }
  }
  run.Filter->SetLabelArray("Label");
  vtkPolyData* surface = run.Update();
  EXPECT_TRUE(run.Errors.empty());
  return Borders(surface);
}
}

/// Where slices contradict each other, each place gets one label from all of them together.
TEST(LabelBorders, DoNotCrossWhereSlicesContradictEachOther)
{
  for (const std::vector<Point3>* places : { &Three(), &Five() })
  {
    const std::array<int, 3> counts[] = { { 16, 16, 16 }, { 16, 16, 0 }, { 4, 4, 4 } };
    for (const std::array<int, 3>& slices : counts)
    {
      for (const bool isSwapped : { false, true })
      {
        SCOPED_TRACE(std::to_string(places->size()) + " labels, " + std::to_string(slices[0]) +
          ", " + std::to_string(slices[2]) + (isSwapped ? ", swapped" : ", moved"));
        const Borders borders = ReconstructContradicted(DivideBall(*places), slices, isSwapped);
        EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
        EXPECT_EQ(borders.Count, places->size());
        EXPECT_EQ(borders.Crossings, 0);
        EXPECT_LT(borders.Overlap, 1e-4);
      }
    }
  }
}

/// Arcs that several labels have are not drawn anew for one of them where they are close.
TEST(LabelBorders, ArcsStayCommonWhereTheyAreClose)
{
  const LabelImage image = MakeLabelImage(LabelKind::Corners, 8, 1);
  const Borders borders = ReconstructContradicted(image, { 12, 12, 12 }, false);
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Overlap, 1e-5);
}

/// A few slices leave many labels in one cell; virtual ones divide it.
TEST(LabelBorders, LeaveNoGapsBetweenAFewSlices)
{
  const Borders borders = Reconstruct(MakeLabelImage(LabelKind::Ball, 8, 1), { 4, 4, 4 });
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Overlap, 1e-5);
  EXPECT_LT(borders.Gap, 0.002);
}

/// Contours of one label that seem to be missing are not inserted where another one is drawn.
TEST(LabelBorders, WhatIsDrawnIsNotOverlappedByWhatIsInserted)
{
  const Borders borders = Reconstruct(MakeLabelImage(LabelKind::Corners, 5, 2), { 0, 0, 16 });
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Overlap, 1e-4);
}

/// What is left between labels where each was made to agree is no hole in all of them together: a
/// field through their few slices would be hollow there.
TEST(LabelBorders, SliversAreNoHolesOfAllLabels)
{
  const LabelImage image = MakeLabelImage(LabelKind::Ball, 12, 3);
  const Borders borders = ReconstructContradicted(image, { 5, 5, 5 }, false);
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Gap, 0.006); // most of it is beside the outermost of the shifted slices
}

namespace
{
/// Slices without the contours of a label on every so many of them, of all axes.
vtkSmartPointer<vtkPolyData> WithoutLabel(int axis, double label, int period, vtkPolyData* slices)
{
  std::map<double, int> numbers; // of slices, by their coordinates
  for (vtkIdType i = 0; i < slices->GetNumberOfPoints(); ++i)
  {
    numbers[slices->GetPoint(i)[axis]] = 0;
  }
  int next = 0;
  for (auto& number : numbers)
  {
    number.second = next++;
  }
  auto left = vtkSmartPointer<vtkPolyData>::New();
  left->SetPoints(slices->GetPoints());
  left->SetLines(vtkSmartPointer<vtkCellArray>::New());
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < slices->GetNumberOfCells(); ++i)
  {
    slices->GetCellPoints(i, ids);
    const double of = slices->GetCellData()->GetArray("Label")->GetTuple1(i);
    if (of != label || numbers[slices->GetPoint(ids->GetId(0))[axis]] % period != period / 2)
    {
      left->GetLines()->InsertNextCell(ids);
      labels->InsertNextValue(static_cast<int>(of));
    }
  }
  left->GetCellData()->AddArray(labels);
  return left;
}
}

/// Slices that cross each other may lack the same label: it has no tunnel there, and a warning says
/// so.
TEST(LabelBorders, LabelsThatSlicesLackAreFilledIn)
{
  const LabelImage image = DivideBall(Five());
  const double volume = Reconstruct(image, { 16, 16, 16 }).Volume;
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(ToVtk(image));
  slicer->EveryLabelOn();
  slicer->SetNumberOfSlices(16, 16, 16);
  slicer->Update();
  FilterRun run;
  for (int axis = 0; axis < 3; ++axis)
  {
    run.Filter->SetInputData(axis, WithoutLabel(axis, 1.0, 5, slicer->GetOutput(axis)));
  }
  run.Filter->SetLabelArray("Label");
  run.Filter->AutomaticAccuracyOff();
  const Borders borders(run.Update());
  EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
  EXPECT_EQ(borders.Crossings, 0);
  EXPECT_LT(borders.Gap, 0.002);
  EXPECT_NEAR(borders.Volume, volume, 0.004 * volume);
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_NE(run.Warnings[0].find("contours seem to be missing"), std::string::npos)
    << run.Warnings[0];
}

namespace
{
/// Exchanges two labels on three of five slices across an axis, others on each.
void SwapOften(int axis, int labels, vtkPolyData* slices)
{
  std::map<double, int> numbers; // of slices, by their coordinates
  for (vtkIdType i = 0; i < slices->GetNumberOfPoints(); ++i)
  {
    numbers[slices->GetPoint(i)[axis]] = 0;
  }
  int next = 0;
  for (auto& number : numbers)
  {
    number.second = next++;
  }
  vtkDataArray* array = slices->GetCellData()->GetArray("Label");
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < slices->GetNumberOfCells(); ++i)
  {
    slices->GetCellPoints(i, ids);
    const int number = numbers[slices->GetPoint(ids->GetId(0))[axis]] + axis;
    const int first = 1 + 7 * number % labels, second = 1 + (3 * number + 1) % labels;
    const int label = static_cast<int>(array->GetTuple1(i));
    if (number % 5 < 3 && (label == first || label == second))
    {
      array->SetTuple1(i, first + second - label);
    }
  }
}
}

/// After all labels have voted, a label may touch a plane on which it is not drawn any more. Its
/// cells end there as those of its neighbours do.
TEST(LabelBorders, CellsAreCommonWhereLabelsTouchPlanes)
{
  for (const int seed : { 52, 55, 61 })
  {
    constexpr int labels = 8;
    vtkNew<vtkOrthogonalSlicer> slicer;
    slicer->SetInputData(ToVtk(MakeLabelImage(LabelKind::Ball, labels, seed)));
    slicer->EveryLabelOn();
    slicer->SetNumberOfSlices(16, 16, 16);
    slicer->Update();
    FilterRun run;
    for (int axis = 0; axis < 3; ++axis)
    {
      vtkNew<vtkPolyData> data;
      data->DeepCopy(slicer->GetOutput(axis));
      SwapOften(axis, labels, data);
      run.Filter->SetInputData(axis, data);
    }
    run.Filter->SetLabelArray("Label");
    run.Filter->AutomaticAccuracyOff();
    const Borders borders(run.Update());
    EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
    EXPECT_EQ(borders.Crossings, 0) << seed;
    EXPECT_LT(borders.Overlap, 1e-4);
  }
}

/// Coordinates of an oblique image that are rounded to thousandths: what slices disagree on is about
/// as much as their tolerance, and labels of any size move alike.
TEST(LabelBorders, DoNotCrossInRoundedObliqueSlices)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const Matrix3 turn = RandomRotation(seed);
    vtkNew<vtkOrthogonalSlicer> slicer;
    slicer->SetInputData(ToVtk(MakeLabelImage(LabelKind::Nested, 2, seed)));
    slicer->EveryLabelOn();
    slicer->SetNumberOfSlices(13, 13, 13);
    slicer->Update();
    FilterRun run;
    for (int axis = 0; axis < 3; ++axis)
    {
      vtkNew<vtkPolyData> data;
      data->DeepCopy(slicer->GetOutput(axis));
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        Point3 p;
        data->GetPoint(i, p.data());
        p = Apply(turn, p);
        for (double& x : p)
        {
          x = std::round(1000.0 * x) / 1000.0;
        }
        points->InsertNextPoint(p.data());
      }
      data->SetPoints(points);
      run.Filter->SetInputData(axis, data);
    }
    run.Filter->SetLabelArray("Label");
    run.Filter->AutomaticAccuracyOff();
    run.Filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    const Borders borders(run.Update());
    EXPECT_TRUE(borders.Check.IsClosedManifold()) << borders.Check;
    EXPECT_EQ(borders.Count, 2u);
    EXPECT_EQ(borders.Crossings, 0) << seed;
  }
}
