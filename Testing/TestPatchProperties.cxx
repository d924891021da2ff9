// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how vtkOrthogonalSliceReconstruction fills polygons: types, resolution, noise, curvature
 */

#include "Core/Base/Vectors.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Perturbations.h"
#include "Support/SelfIntersections.h"
#include "Support/SliceSolid.h"
#include "Support/SmoothSolids.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"
#include "Support/Vtk/PropertyChanges.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Filter = vtkOrthogonalSliceReconstruction;
using Change = std::function<void(Filter*)>;

PieceSets SlicesOf(const SmoothSolid& solid, int planes, int subdivisions = 6)
{
  return SliceSolid(
    solid, EqualPlanes(solid, { planes, planes, planes }), subdivisions, InPlaneGrid::Aligned);
}

/// With all triangles, unless the change wants few.
vtkSmartPointer<vtkPolyData> Surface(const PieceSets& sets, const Change& change)
{
  FilterRun run(sets);
  run.Filter->AutomaticAccuracyOff();
  run.Filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  change(run.Filter);
  vtkSmartPointer<vtkPolyData> surface = run.Update();
  EXPECT_TRUE(run.Errors.empty()) << run.Errors[0];
  EXPECT_TRUE(CheckSurface(MeshOf(surface)).IsClosedManifold());
  return surface;
}

struct Accuracy
{
  double Distance = 0.0; ///< root mean square over the points
  double Angle = 0.0;    ///< mean, of the normals
};

Accuracy AccuracyOf(vtkPolyData* surface, const SmoothSolid& solid)
{
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  Accuracy accuracy;
  const vtkIdType n = surface->GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i)
  {
    Point3 p, normal, expected;
    surface->GetPoint(i, p.data());
    normals->GetTuple(i, normal.data());
    const Point3 d = p - solid.Project(p, expected);
    accuracy.Distance += Dot(d, d) / static_cast<double>(n);
    accuracy.Angle +=
      2.0 * std::asin(std::min(1.0, 0.5 * Length(normal - expected))) / static_cast<double>(n);
  }
  accuracy.Distance = std::sqrt(accuracy.Distance);
  return accuracy;
}

double QualityOf(vtkPolyData* surface, const char* name)
{
  return surface->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

/// Squares of a cube, with vertices along their sides.
PieceSets CubeSlices()
{
  SmoothSolid cube;
  cube.Low = { -1.1, -1.13, -1.17 };
  cube.High = { 1.2, 1.15, 1.11 };
  cube.Function = [](const Point3& p) {
    return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) - 0.9;
  };
  return SliceSolid(cube, EqualPlanes(cube, { 9, 9, 9 }), 16, InPlaneGrid::Aligned);
}
}

//----------------------------------------------------------------------------
TEST(PatchProperties, DefaultsAndRanges)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetPatchType(), Filter::SMOOTH);
  EXPECT_EQ(filter->GetEdgeLength(), 0.25);
  EXPECT_EQ(filter->GetChordTolerance(), 0.0);
  EXPECT_EQ(filter->GetAccuracy(), 0.0);
  EXPECT_TRUE(filter->GetAutomaticAccuracy());
  EXPECT_FALSE(filter->GetKeepContourVertices());
  EXPECT_EQ(filter->GetCornerAngle(), 60.0);
  EXPECT_EQ(filter->GetSmoothing(), 0.0);
  EXPECT_EQ(filter->GetContourTolerance(), 0.0);
  EXPECT_FALSE(filter->GetComputeCurvatures());
  EXPECT_TRUE(filter->GetPassCellArrays());
  filter->SetPatchType(17);
  EXPECT_EQ(filter->GetPatchType(), Filter::COONS);
  filter->SetEdgeLength(0.0);
  EXPECT_EQ(filter->GetEdgeLength(), 0.02);
  filter->SetChordTolerance(-1.0);
  EXPECT_EQ(filter->GetChordTolerance(), 0.0);
  filter->SetAccuracy(-1.0);
  EXPECT_EQ(filter->GetAccuracy(), 0.0);
  filter->SetCornerAngle(1000.0);
  EXPECT_EQ(filter->GetCornerAngle(), 180.0);
  filter->SetSmoothing(-2.0);
  EXPECT_EQ(filter->GetSmoothing(), 0.0);
  filter->SetContourTolerance(-0.1);
  EXPECT_EQ(filter->GetContourTolerance(), 0.0);
}

//----------------------------------------------------------------------------
TEST(PatchProperties, SettersChangeTheTimeAndAreAllPrinted)
{
  ExpectPropertyChanges({
    { "PatchType: Coons", [](Filter* f) { f->SetPatchTypeToCoons(); } },
    { "EdgeLength: 0.5", [](Filter* f) { f->SetEdgeLength(0.5); } },
    { "ChordTolerance: 0.125", [](Filter* f) { f->SetChordTolerance(0.125); } },
    { "Accuracy: 0.0625", [](Filter* f) { f->SetAccuracy(0.0625); } },
    { "AutomaticAccuracy: Off", [](Filter* f) { f->AutomaticAccuracyOff(); } },
    { "KeepContourVertices: On", [](Filter* f) { f->KeepContourVerticesOn(); } },
    { "CornerAngle: 45", [](Filter* f) { f->SetCornerAngle(45.0); } },
    { "Smoothing: 0.75", [](Filter* f) { f->SetSmoothing(0.75); } },
    { "ContourTolerance: 0.0625", [](Filter* f) { f->SetContourTolerance(0.0625); } },
    { "ComputeCurvatures: On", [](Filter* f) { f->ComputeCurvaturesOn(); } },
    { "PassCellArrays: Off", [](Filter* f) { f->PassCellArraysOff(); } },
  });
}

//----------------------------------------------------------------------------
TEST(PatchProperties, NumbersThatAreNoneAreErrors)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<const char*, Change>> changes{
    { "EdgeLength", [none](Filter* f) { f->SetEdgeLength(none); } },
    { "ChordTolerance", [none](Filter* f) { f->SetChordTolerance(none); } },
    { "Accuracy", [none](Filter* f) { f->SetAccuracy(none); } },
    { "CornerAngle", [none](Filter* f) { f->SetCornerAngle(none); } },
    { "Smoothing", [none](Filter* f) { f->SetSmoothing(none); } },
    { "ContourTolerance", [none](Filter* f) { f->SetContourTolerance(none); } },
    { "RedrawnTolerance", [none](Filter* f) { f->SetRedrawnTolerance(none); } },
  };
  const PieceSets sets = SlicesOf(SmoothEllipsoid(), 6);
  for (const auto& change : changes)
  {
    SCOPED_TRACE(change.first);
    FilterRun run(sets);
    change.second(run.Filter);
    EXPECT_EQ(run.Update()->GetNumberOfCells(), 0);
    ASSERT_GE(run.Errors.size(), 1u);
    EXPECT_NE(run.Errors[0].find(change.first), std::string::npos) << run.Errors[0];
  }
}

//----------------------------------------------------------------------------
TEST(PatchProperties, SmoothPatchesAreMuchCloserThanThePapers)
{
  for (const SmoothSolid& solid : { SmoothTorus(), SmoothEllipsoid() })
  {
    SCOPED_TRACE(solid.Name);
    const PieceSets sets = SlicesOf(solid, 24);
    const auto accuracy = [&](const Change& change)
    { return AccuracyOf(Surface(sets, change), solid); };
    const Accuracy smooth = accuracy([](Filter* f) { f->SetPatchTypeToSmooth(); });
    const Accuracy fan = accuracy(
      [](Filter* f)
      {
        f->SetPatchTypeToFan();
        f->SetCentralPointToCentroid();
      });
    const Accuracy coons = accuracy(
      [](Filter* f)
      {
        f->SetPatchTypeToCoons();
        f->SetCentralPointToCentroid();
      });
    for (const Accuracy& papers : { fan, coons })
    {
      EXPECT_LT(smooth.Distance, 0.1 * papers.Distance);
      EXPECT_LT(smooth.Angle, 0.2 * papers.Angle);
    }
  }
}

//----------------------------------------------------------------------------
/// Orders of convergence as a guarantee: see CompareConvergence for the table.
TEST(PatchProperties, ErrorsFallWithTheFourthPowerOfTheSpacing)
{
  for (const SmoothSolid& solid : { SmoothTorus(), SmoothEllipsoid() })
  {
    SCOPED_TRACE(solid.Name);
    const auto accuracy = [&](int planes)
    { return AccuracyOf(Surface(SlicesOf(solid, planes, 8), [](Filter*) {}), solid); };
    const Accuracy coarse = accuracy(16), fine = accuracy(32);
    EXPECT_GT(coarse.Distance, std::pow(2.0, 3.6) * fine.Distance);
    EXPECT_GT(coarse.Angle, std::pow(2.0, 2.7) * fine.Angle);
  }
}

//----------------------------------------------------------------------------
TEST(PatchProperties, EdgeLengthAndChordToleranceSetTheNumberOfTriangles)
{
  const SmoothSolid solid = SmoothEllipsoid();
  const PieceSets sets = SlicesOf(solid, 8);
  vtkIdType before = 0;
  for (const double length : { 1.0, 0.25, 0.15 })
  {
    const vtkIdType cells =
      Surface(sets, [&](Filter* f) { f->SetEdgeLength(length); })->GetNumberOfCells();
    EXPECT_GT(cells, before);
    before = cells;
  }
  const auto withChords = [&](double tolerance)
  {
    return Surface(sets,
      [&](Filter* f)
      {
        f->SetEdgeLength(1.0);
        f->SetChordTolerance(tolerance);
      });
  };
  EXPECT_GT(withChords(1e-3)->GetNumberOfCells(), withChords(1e-2)->GetNumberOfCells());
}

//----------------------------------------------------------------------------
/// Vertices every sixth of a slab, at equal distances: only borders that cross the contours' planes
/// at sharp angles leave triangles with small angles.
TEST(PatchProperties, TrianglesAreWellShapedWhereContoursAre)
{
  const auto surface = Surface(SlicesOf(SmoothTorus(), 24, 5), [](Filter*) {});
  EXPECT_GT(QualityOf(surface, "ShareOfTrianglesAbove20Degrees"), 0.85);
  EXPECT_GT(QualityOf(surface, "SmallestAngle"), 0.0);
  EXPECT_GE(QualityOf(surface, "LargestAspectRatio"), 1.0);
}

//----------------------------------------------------------------------------
/// Points on the edges of a cube do not pull its faces out of their planes.
TEST(PatchProperties, CornersOfContoursMakeCreases)
{
  const PieceSets sets = CubeSlices();
  const auto volume = [&](double angle)
  {
    return CheckSurface(MeshOf(Surface(sets, [&](Filter* f) { f->SetCornerAngle(angle); })))
      .TotalVolume();
  };
  const double whole = std::pow(1.8, 3.0);
  EXPECT_NEAR(volume(60.0), whole, 2e-3 * whole);
  EXPECT_LT(std::abs(volume(60.0) - whole), 0.5 * std::abs(volume(180.0) - whole));
}

//----------------------------------------------------------------------------
TEST(PatchProperties, SmoothingTakesOutNoise)
{
  const SmoothSolid solid = SmoothTorus();
  PieceSets noisy = SlicesOf(solid, 16, 10);
  MoveVertices(noisy, 0.01, 5);
  const Accuracy with = AccuracyOf(Surface(noisy, [](Filter* f) { f->SetSmoothing(2.0); }), solid);
  const Accuracy without = AccuracyOf(Surface(noisy, [](Filter*) {}), solid);
  EXPECT_LT(with.Distance, 0.9 * without.Distance);
  EXPECT_LT(with.Angle, 0.9 * without.Angle);
}

//----------------------------------------------------------------------------
TEST(PatchProperties, ThinnedContoursStayWithinTheTolerance)
{
  const SmoothSolid solid = SmoothTorus();
  const PieceSets sets = SlicesOf(solid, 12, 30);
  const auto all = Surface(sets, [](Filter*) {});
  const auto thinned = Surface(sets, [](Filter* f) { f->SetContourTolerance(0.01); });
  EXPECT_LT(thinned->GetNumberOfPoints(), 0.5 * all->GetNumberOfPoints());
  EXPECT_LT(AccuracyOf(thinned, solid).Distance, 0.01 * 2.2 / 12);
}

//----------------------------------------------------------------------------
/// Few triangles of good shape, as accurate as was asked for.
TEST(PatchProperties, AccuracyMakesFewTrianglesOfGoodShape)
{
  const SmoothSolid solid = SmoothTorus();
  const PieceSets sets = SlicesOf(solid, 20, 10);
  const double spacing = 2.2 / 20; // at least
  const auto all = Surface(sets, [](Filter*) {});
  const auto fewer = Surface(sets, [](Filter* f) { f->SetAccuracy(0.05); });
  const auto few = Surface(sets, [](Filter* f) { f->SetAccuracy(0.2); });
  EXPECT_LT(fewer->GetNumberOfCells(), all->GetNumberOfCells() / 6);
  EXPECT_LT(few->GetNumberOfCells(), 0.7 * fewer->GetNumberOfCells());
  EXPECT_LT(AccuracyOf(fewer, solid).Distance, 0.1 * 0.05 * spacing);
  EXPECT_LT(AccuracyOf(few, solid).Distance, 0.1 * 0.2 * spacing);
  for (const auto& surface : { fewer, few })
  {
    EXPECT_GT(QualityOf(surface, "ShareOfTrianglesAbove20Degrees"), 0.99);
    EXPECT_GT(QualityOf(surface, "SmallestAngle"), 1.0);
    EXPECT_LT(QualityOf(surface, "LargestAspectRatio"), 100.0);
    const SurfaceCheck check = CheckSurface(MeshOf(surface));
    EXPECT_TRUE(check.IsClosedManifold());
  }
}

//----------------------------------------------------------------------------
/// Smooth solids are met far better than real shapes; where nothing is to be gained any more, what
/// is added is a small part of the spacing.
TEST(PatchProperties, AutomaticAccuracyFollowsTheError)
{
  for (const SmoothSolid& solid : { SmoothTorus(), SmoothEllipsoid() })
  {
    SCOPED_TRACE(solid.Name);
    double before = HUGE_VAL;
    for (const int planes : { 8, 16 })
    {
      const PieceSets sets = SlicesOf(solid, planes, 10);
      const auto all = Surface(sets, [](Filter*) {});
      const auto few = Surface(sets, [](Filter* f) { f->AutomaticAccuracyOn(); });
      EXPECT_LT(few->GetNumberOfCells(), all->GetNumberOfCells());
      const double error = AccuracyOf(few, solid).Distance;
      EXPECT_LT(error, 2.5 * AccuracyOf(all, solid).Distance + 0.0005 * 2.2 / planes);
      EXPECT_LT(error, 0.25 * before);
      before = error;
    }
  }
}

//----------------------------------------------------------------------------
TEST(PatchProperties, AutomaticAccuracyTakesASixthOfTheTriangles)
{
  const PieceSets sets = ReadPieceSets({ "heart", 1, 0, false }, 16);
  const auto all = Surface(sets, [](Filter*) {});
  const auto few = Surface(sets, [](Filter* f) { f->AutomaticAccuracyOn(); });
  EXPECT_LT(few->GetNumberOfCells(), all->GetNumberOfCells() / 6);
  EXPECT_GT(QualityOf(few, "ShareOfTrianglesAbove20Degrees"), 0.98);
  const double volume = CheckSurface(MeshOf(all)).TotalVolume();
  EXPECT_NEAR(CheckSurface(MeshOf(few)).TotalVolume(), volume, 1e-3 * volume);
}

//----------------------------------------------------------------------------
/// Contours keep their vertices, in the surface if asked for, in the graph in any case.
TEST(PatchProperties, KeepContourVertices)
{
  const PieceSets sets = ReadPieceSets({ "aorta", 1, 0, true }, 16);
  FilterRun all(sets), few(sets), kept(sets);
  all.Filter->AutomaticAccuracyOff();
  few.Filter->AutomaticAccuracyOn();
  kept.Filter->AutomaticAccuracyOn();
  kept.Filter->KeepContourVerticesOn();
  for (FilterRun* run : { &all, &few, &kept })
  {
    run->Update();
  }
  const TriangleMesh graph = MeshOf(all.Filter->GetGraphOutput());
  EXPECT_EQ(MeshOf(few.Filter->GetGraphOutput()).Points, graph.Points);
  EXPECT_EQ(MeshOf(kept.Filter->GetGraphOutput()).Points, graph.Points);
  const vtkIdType triangles = kept.Filter->GetOutput()->GetNumberOfCells();
  EXPECT_LT(few.Filter->GetOutput()->GetNumberOfCells(), 0.5 * triangles);
  EXPECT_LT(triangles, 0.8 * all.Filter->GetOutput()->GetNumberOfCells());
  EXPECT_GT(QualityOf(few.Filter->GetOutput(), "Accuracy"), 0.0);
  EXPECT_EQ(QualityOf(kept.Filter->GetOutput(), "Accuracy"), 0.0);
}

//----------------------------------------------------------------------------
TEST(PatchProperties, CurvaturesOfATorusAreKnown)
{
  const SmoothSolid solid = SmoothTorus(); // radii 0.62 and 0.27
  const auto surface = Surface(SlicesOf(solid, 32), [](Filter* f) { f->ComputeCurvaturesOn(); });
  auto* mean = vtkFloatArray::SafeDownCast(surface->GetPointData()->GetArray("MeanCurvature"));
  auto* gauss = vtkFloatArray::SafeDownCast(surface->GetPointData()->GetArray("GaussianCurvature"));
  ASSERT_TRUE(mean && gauss);
  std::vector<float> sorted(
    gauss->GetPointer(0), gauss->GetPointer(0) + gauss->GetNumberOfTuples());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  // 1 / (r (R + r)) outside, -1 / (r (R - r)) inside; points where it is estimated worst left out.
  EXPECT_NEAR(sorted[n - 1 - n / 100], 1.0 / (0.27 * 0.89), 0.3);
  EXPECT_NEAR(sorted[n / 100], -1.0 / (0.27 * 0.35), 0.8);
  double sum = 0.0;
  for (vtkIdType i = 0; i < mean->GetNumberOfTuples(); ++i)
  {
    sum += mean->GetValue(i);
  }
  EXPECT_GT(sum, 0.0); // outward normals: round parts are positive
  EXPECT_FALSE(
    Surface(SlicesOf(solid, 8), [](Filter*) {})->GetPointData()->HasArray("MeanCurvature"));
}

//----------------------------------------------------------------------------
/// Whatever the properties: closed, without self-intersections.
TEST(PatchProperties, GuaranteesHoldForAllSettings)
{
  const std::vector<Change> changes{
    [](Filter* f) { f->SetPatchTypeToCoons(); },
    [](Filter* f) { f->SetEdgeLength(0.1); },
    [](Filter* f) { f->SetEdgeLength(2.0); },
    [](Filter* f) { f->SetChordTolerance(0.01); },
    [](Filter* f) { f->SetCornerAngle(20.0); },
    [](Filter* f) { f->SetSmoothing(3.0); },
    [](Filter* f) { f->SetContourTolerance(0.05); },
    [](Filter* f) { f->SetAccuracy(0.05); },
    [](Filter* f) { f->SetAccuracy(0.4); },
    [](Filter* f) { f->AutomaticAccuracyOn(); },
    [](Filter* f)
    {
      f->AutomaticAccuracyOn();
      f->KeepContourVerticesOn();
    },
    [](Filter* f)
    {
      f->SetSmoothing(1.0);
      f->SetContourTolerance(0.02);
      f->SetEdgeLength(0.3);
    },
  };
  for (const Change& change : changes)
  {
    SCOPED_TRACE(&change - changes.data());
    for (const DataSet& data :
      { DataSet{ "lbl_stomach", 1, 0, false }, DataSet{ "heart", 1, 1, true } })
    {
      SCOPED_TRACE(data.Name);
      PieceSets sets = ReadPieceSets(data, 16);
      for (const double noise : { 0.0, 0.002 })
      {
        MoveVertices(sets, noise, 3);
        const auto surface = Surface(sets, change);
        EXPECT_EQ(CountSelfIntersections(MeshOf(surface)), 0);
      }
    }
  }
}
