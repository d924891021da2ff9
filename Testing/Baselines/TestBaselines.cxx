// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   every method on slices whose surface is known by hand, and the paper's claim
 */

#include "Baselines/CaseFolder.h"
#include "Baselines/Comparison.h"
#include "Baselines/ContourDistance.h"
#include "Baselines/DistanceInterpolation.h"
#include "Baselines/DistanceInterpolationThreeFamilies.h"
#include "Baselines/MethodSummary.h"
#include "Baselines/NoisyContours.h"
#include "Baselines/OrthogonalSlices.h"
#include "Baselines/PairByOverlap.h"
#include "Baselines/ParametricMeshes.h"
#include "Baselines/PlanarContours.h"
#include "Baselines/RuledSurface.h"
#include "Baselines/RunApart.h"
#include "Support/Vtk/SurfaceMetrics.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

//------------------------------------------------------------------------------
// A regular polygon: counter-clockwise if the radius is positive, else clockwise with its absolute
// value.
Loop MakeCircle(double u, double v, double radius, int count, int firstVertex = 0)
{
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * (i + firstVertex) / count;
    loop.push_back({ u + std::abs(radius) * std::cos(angle), v + radius * std::sin(angle) });
  }
  return loop;
}

//------------------------------------------------------------------------------
Loop MakeSquare(double low, double high)
{
  return { { low, low }, { high, low }, { high, high }, { low, high } };
}

//------------------------------------------------------------------------------
// Area of a regular polygon.
double PolygonArea(double radius, int count)
{
  return 0.5 * count * radius * radius * std::sin(2.0 * vtkMath::Pi() / count);
}

//------------------------------------------------------------------------------
Surface MakeContours(const std::vector<Slice>& slices, int axis)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const Slice& slice : slices)
  {
    for (const Loop& loop : slice.Loops)
    {
      const vtkIdType first = points->GetNumberOfPoints();
      lines->InsertNextCell(static_cast<int>(loop.size() + 1));
      for (const Point2& point : loop)
      {
        lines->InsertCellPoint(
          points->InsertNextPoint(PlaceInSpace(axis, slice.Coordinate, point).data()));
      }
      lines->InsertCellPoint(first);
    }
  }
  auto contours = Surface::New();
  contours->SetPoints(points);
  contours->SetLines(lines);
  return contours;
}

//------------------------------------------------------------------------------
SliceSets MakeStack(const std::vector<Slice>& slices)
{
  SliceSets sets;
  sets.Families[2] = MakeContours(slices, 2);
  return sets;
}

//------------------------------------------------------------------------------
Surface MakeSphere(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(120);
  sphere->SetPhiResolution(120);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  return sphere->GetOutput();
}

//------------------------------------------------------------------------------
// Points of SURFACE at height Z: their least and largest distance from the z-axis.
std::pair<double, double> RadiiAt(const Surface& surface, double z)
{
  std::pair<double, double> radii(1e9, 0.0);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    if (std::abs(p[2] - z) < 1e-6)
    {
      radii.first = std::min(radii.first, std::hypot(p[0], p[1]));
      radii.second = std::max(radii.second, std::hypot(p[0], p[1]));
    }
  }
  return radii;
}

//------------------------------------------------------------------------------
bool HasShape(const Surface& surface, int components, int genus)
{
  const Topology topology = MeasureTopology(surface);
  return topology.IsClosedManifold() && topology.Components == components &&
    topology.Genus == genus;
}

const RuledSurface RuledModes[] = { RuledSurface(RuledSurface::Mode::Resample, 64),
  RuledSurface(RuledSurface::Mode::PointWalk) };

} // anonymous namespace

//------------------------------------------------------------------------------
TEST(PlanarContours, SlicesAreSortedAndPointsKeepTheirHandedness)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Surface contours = MakeContours(
      { { 2.0, { MakeSquare(0, 1) } }, { -1.0, { MakeSquare(0, 1), MakeSquare(2, 4) } } }, axis);
    const std::vector<Slice> slices = ExtractSlices(contours, axis);
    ASSERT_EQ(slices.size(), 2u);
    EXPECT_EQ(slices[0].Coordinate, -1.0);
    ASSERT_EQ(slices[0].Loops.size(), 2u);
    EXPECT_EQ(slices[0].Loops[1].size(), 4u);
    EXPECT_EQ(SignedArea(slices[0].Loops[1]), 4.0);
    EXPECT_EQ(Perimeter(slices[0].Loops[1]), 8.0);
  }
}

//------------------------------------------------------------------------------
TEST(PlanarContours, SkippedPlaneIndicesAreEmptySlices)
{
  const Surface sphere = MakeSphere(1.0);
  const SliceSets slices = CutSurface(sphere, { 0, 0, 4 });
  EXPECT_EQ(ExtractSlices(slices.Families[2], 2).size(), 4u);
  EXPECT_NEAR(SpacingOf(slices.Families[2], 2), 0.5, 1e-3);
}

//------------------------------------------------------------------------------
TEST(PlanarContours, HolesAreOrientedAgainstTheirSurroundings)
{
  Slice slice{ 0.0, { MakeSquare(0, 9), MakeSquare(1, 8), MakeSquare(2, 7), MakeSquare(10, 11) } };
  EXPECT_EQ(NestingDepths(slice), (std::vector<int>{ 0, 1, 2, 0 }));
  OrientByNesting(slice);
  EXPECT_GT(SignedArea(slice.Loops[0]), 0.0);
  EXPECT_LT(SignedArea(slice.Loops[1]), 0.0);
  EXPECT_GT(SignedArea(slice.Loops[2]), 0.0);
  EXPECT_GT(SignedArea(slice.Loops[3]), 0.0);
}

//------------------------------------------------------------------------------
TEST(ContourDistance, SquareWithASquareHole)
{
  const std::vector<Loop> loops{ MakeSquare(0, 10), MakeSquare(4, 6) };
  const ContourDistance distance(loops);
  const std::vector<double> us{ -3.0, 1.0, 3.5, 5.0, 6.5, 13.0 };
  double values[6];
  distance.SampleRow(us, 5.0, values);
  const double expected[6] = { -3.0, 1.0, 0.5, -1.0, 0.5, -3.0 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_DOUBLE_EQ(values[i], expected[i]) << "at " << us[i];
  }
  distance.SampleRow({ -3.0, 13.0 }, 14.0, values);
  EXPECT_DOUBLE_EQ(values[0], -5.0) << "distance from the corner";
  EXPECT_DOUBLE_EQ(values[1], -5.0);
}

//------------------------------------------------------------------------------
TEST(ContourDistance, AgreesWithAllSegmentsOfARegularPolygon)
{
  const std::vector<Loop> loops{ MakeCircle(0.3, -0.2, 1.0, 101) };
  const ContourDistance distance(loops);
  std::vector<double> us;
  for (double u = -2.0; u < 2.0; u += 0.01)
  {
    us.push_back(u);
  }
  std::vector<double> values(us.size());
  for (double v = -2.0; v < 2.0; v += 0.37)
  {
    distance.SampleRow(us, v, values.data());
    for (std::size_t i = 0; i < us.size(); ++i)
    {
      EXPECT_NEAR(values[i], 1.0 - std::hypot(us[i] - 0.3, v + 0.2), 1e-3);
    }
  }
}

//------------------------------------------------------------------------------
TEST(PairByOverlap, AreaIsExactForRectangles)
{
  EXPECT_NEAR(OverlapArea(MakeSquare(0, 2), MakeSquare(1, 3)), 1.0, 1e-12);
  EXPECT_NEAR(OverlapArea(MakeSquare(0, 2), MakeSquare(0.5, 1)), 0.25, 1e-12);
  EXPECT_EQ(OverlapArea(MakeSquare(0, 2), MakeSquare(2, 3)), 0.0);
}

//------------------------------------------------------------------------------
TEST(PairByOverlap, LargestOverlapWinsAndKindsDoNotMix)
{
  const Slice below{ 0.0, { MakeSquare(0, 10), MakeSquare(20, 30) } };
  const Slice above{ 1.0, { MakeSquare(22, 32), MakeSquare(8, 21), MakeSquare(9, 20.5) } };
  const std::vector<LoopPair> pairs = PairByOverlap(below, above);
  ASSERT_EQ(pairs.size(), 2u) << "the third is a hole";
  EXPECT_EQ(pairs[0].Below, 1u);
  EXPECT_EQ(pairs[0].Above, 0u);
  EXPECT_EQ(pairs[1].Below, 0u);
  EXPECT_EQ(pairs[1].Above, 1u);
}

//------------------------------------------------------------------------------
// Two parallel regular polygons with aligned vertices: a frustum with plane faces.
TEST(RuledSurfaceMethod, ConcentricCirclesMakeAFrustum)
{
  const int n = 64;
  const double height = 3.0;
  const double small = PolygonArea(1.0, n);
  const double large = PolygonArea(2.0, n);
  const double volume = height / 3.0 * (small + large + std::sqrt(small * large));
  // The upper loop starts elsewhere and runs the other way.
  const SliceSets stack = MakeStack(
    { { 0.0, { MakeCircle(0, 0, 1.0, n) } }, { height, { MakeCircle(0, 0, -2.0, n, 17) } } });
  for (const RuledSurface& method : RuledModes)
  {
    const Surface surface = method.Reconstruct(stack);
    EXPECT_TRUE(HasShape(surface, 1, 0)) << method.Name();
    EXPECT_NEAR(MeasureVolume(surface), volume, 1e-6 * volume) << method.Name();
  }
}

//------------------------------------------------------------------------------
TEST(RuledSurfaceMethod, RingSlicesMakeATube)
{
  const int n = 64;
  const std::vector<Loop> ring{ MakeCircle(0, 0, 0.5, n), MakeCircle(0, 0, 1.0, n) };
  const SliceSets stack = MakeStack({ { 0.0, ring }, { 1.0, ring }, { 2.5, ring } });
  const double volume = 2.5 * (PolygonArea(1.0, n) - PolygonArea(0.5, n));
  for (const RuledSurface& method : RuledModes)
  {
    const Surface surface = method.Reconstruct(stack);
    EXPECT_TRUE(HasShape(surface, 1, 1)) << method.Name();
    EXPECT_NEAR(MeasureVolume(surface), volume, 1e-6 * volume) << method.Name();
  }
}

//------------------------------------------------------------------------------
TEST(RuledSurfaceMethod, SeparateColumnsStaySeparate)
{
  const int n = 64;
  const Loop left = MakeCircle(-2, 0, 1.0, n);
  const Loop right = MakeCircle(2, 0, 1.0, n);
  const SliceSets stack =
    MakeStack({ { 0.0, { left, right } }, { 1.0, { right, left } }, { 2.0, { left } } });
  for (const RuledSurface& method : RuledModes)
  {
    const Surface surface = method.Reconstruct(stack);
    EXPECT_TRUE(HasShape(surface, 2, 0)) << method.Name();
    EXPECT_NEAR(MeasureVolume(surface), 3.0 * PolygonArea(1.0, n), 1e-6) << method.Name();
  }
}

//------------------------------------------------------------------------------
TEST(RuledSurfaceMethod, LoopsOfDifferentVertexCountsLeaveNoGap)
{
  for (const int count : { 3, 7, 50, 333 })
  {
    const SliceSets stack = MakeStack({ { 0.0, { MakeCircle(0, 0, 1.0, 40) } },
      { 1.0, { MakeCircle(0.3, 0.2, 0.8, count) } }, { 2.0, { MakeCircle(0, 0.1, 1.0, 40, 5) } } });
    for (const RuledSurface& method : RuledModes)
    {
      EXPECT_TRUE(HasShape(method.Reconstruct(stack), 1, 0)) << method.Name() << ' ' << count;
    }
  }
}

//------------------------------------------------------------------------------
TEST(RuledSurfaceMethod, WithoutPreparationTheSurfaceIsOpen)
{
  const Loop left = MakeCircle(-2, 0, 1.0, 32);
  const Loop right = MakeCircle(2, 0, 1.0, 32);
  const SliceSets stack = MakeStack({ { 0.0, { left, right } }, { 1.0, { left, right } } });
  const Surface surface = NaiveRuledSurface().Reconstruct(stack);
  EXPECT_GT(surface->GetNumberOfPoints(), 0);
  EXPECT_FALSE(MeasureTopology(surface).IsWatertight());
}

//------------------------------------------------------------------------------
// Signed distances of concentric circles differ by a constant, so radii are linear in between.
TEST(DistanceInterpolationMethod, ConcentricCirclesMakeACone)
{
  const int n = 400;
  const SliceSets stack =
    MakeStack({ { 0.0, { MakeCircle(0, 0, 1.0, n) } }, { 1.0, { MakeCircle(0, 0, 2.0, n, 3) } } });
  const Surface surface = DistanceInterpolation(128).Reconstruct(stack);
  EXPECT_TRUE(HasShape(surface, 1, 0));
  EXPECT_GT(MeasureVolume(surface), 0.0);
  for (const double z : { 0.0, 0.5, 1.0 })
  {
    const auto [minimum, largest] = RadiiAt(surface, z);
    EXPECT_NEAR(minimum, 1.0 + z, 2e-3);
    EXPECT_NEAR(largest, 1.0 + z, 2e-3);
  }
}

//------------------------------------------------------------------------------
// On the axis the value is 1 on the last slice and -1.5 on the empty one behind it.
TEST(DistanceInterpolationMethod, EndsAreRoundAndClosed)
{
  const Loop circle = MakeCircle(0, 0, 1.0, 400);
  const SliceSets stack =
    MakeStack({ { 0.0, { circle } }, { 1.0, { circle } }, { 2.0, { circle } } });
  const Surface surface = DistanceInterpolation(128).Reconstruct(stack);
  EXPECT_TRUE(HasShape(surface, 1, 0));
  double bounds[6];
  surface->GetBounds(bounds);
  EXPECT_NEAR(bounds[5], 2.4, 1e-2);
  EXPECT_NEAR(bounds[4], -0.4, 1e-2);
}

//------------------------------------------------------------------------------
TEST(DistanceInterpolationMethod, EmptySliceBetweenSeparatesTheParts)
{
  const Loop circle = MakeCircle(0, 0, 1.0, 100);
  SliceSets stack = MakeStack(
    { { 0.0, { circle } }, { 1.0, { circle } }, { 3.0, { circle } }, { 4.0, { circle } } });
  vtkNew<vtkIntArray> planes;
  planes->SetName("PlaneIndex");
  for (const int plane : { 0, 1, 3, 4 })
  {
    planes->InsertNextValue(plane);
  }
  EXPECT_TRUE(HasShape(DistanceInterpolation(64).Reconstruct(stack), 1, 0));
  stack.Families[2]->GetCellData()->AddArray(planes);
  EXPECT_TRUE(HasShape(DistanceInterpolation(64).Reconstruct(stack), 2, 0));
  for (const RuledSurface& method : RuledModes)
  {
    EXPECT_TRUE(HasShape(method.Reconstruct(stack), 2, 0)) << method.Name();
  }
}

//------------------------------------------------------------------------------
TEST(DistanceInterpolationMethod, ThreeFamiliesReproduceTheContoursOfAll)
{
  const Surface sphere = MakeSphere(1.0);
  const SliceSets slices = CutSurface(sphere, { 12, 12, 12 });
  const Surface surface = DistanceInterpolationThreeFamilies(8).Reconstruct(slices);
  EXPECT_TRUE(HasShape(surface, 1, 0));
  const double h = MeanSpacing(slices);
  EXPECT_NEAR(h, 1.0 / 6.0, 1e-3);
  const Surface onlyZ = DistanceInterpolation(128).Reconstruct(slices);
  const auto three = MeasureDeviation(surface, sphere, 20000);
  EXPECT_LT(three->RootMeanSquare, 0.03 * h);
  EXPECT_LT(three->RootMeanSquare, 0.5 * MeasureDeviation(onlyZ, sphere, 20000)->RootMeanSquare);
}

//------------------------------------------------------------------------------
TEST(AllMethods, NamesAreUniqueAndNoSlicesMakeNoSurface)
{
  SliceSets none;
  for (Surface& family : none.Families)
  {
    family = Surface::New();
  }
  std::vector<std::string> names;
  for (const std::unique_ptr<Baseline>& method : MakeAllMethods())
  {
    names.push_back(method->Name());
    EXPECT_FALSE(method->Description().empty());
    if (method->Name().compare(0, 10, "orthogonal") != 0) // reports an error
    {
      EXPECT_EQ(method->Reconstruct(none)->GetNumberOfCells(), 0) << method->Name();
    }
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

//------------------------------------------------------------------------------
// The paper's Figure 1, case A: the axis inclines against the slices, so far that the contours of
// consecutive z-slices do not overlap. The y-planes, which hold the axis, connect what the z-slices
// cannot.
TEST(PaperClaim, InclinedTubeStaysWholeWithOrthogonalSlicesOnly)
{
  const Surface tube = MakeCapsule({ -1.0, 0.0, -1.0 }, { 1.0, 0.0, 1.0 }, 0.06, 64);
  const SliceSets slices = CutSurface(tube, { 8, 8, 8 });
  const std::vector<Slice> zSlices = ExtractSlices(slices.Families[2], 2);
  ASSERT_EQ(zSlices.size(), 8u);
  for (std::size_t i = 0; i + 1 < zSlices.size(); ++i)
  {
    ASSERT_TRUE(PairByOverlap(zSlices[i], zSlices[i + 1]).empty()) << "slice " << i;
  }
  EXPECT_TRUE(HasShape(OrthogonalSlices().Reconstruct(slices), 1, 0));
  EXPECT_FALSE(HasShape(DistanceInterpolation().Reconstruct(slices), 1, 0));
  for (const RuledSurface& method : RuledModes)
  {
    EXPECT_FALSE(HasShape(method.Reconstruct(slices), 1, 0)) << method.Name();
  }
}

//------------------------------------------------------------------------------
// The same for a closed tube and thick slices (figure 1, case C: genus above 0).
TEST(PaperClaim, InclinedRingKeepsItsHoleWithOrthogonalSlicesOnly)
{
  const Surface ring = MakeTorus({ 1.0, 0.0, 1.0 }, 0.6, 0.08, 200, 64);
  const SliceSets slices = CutSurface(ring, { 32, 32, 4 });
  EXPECT_TRUE(HasShape(OrthogonalSlices().Reconstruct(slices), 1, 1));
  EXPECT_FALSE(HasShape(DistanceInterpolation().Reconstruct(slices), 1, 1));
  for (const RuledSurface& method : RuledModes)
  {
    EXPECT_FALSE(HasShape(method.Reconstruct(slices), 1, 1)) << method.Name();
  }
}

//------------------------------------------------------------------------------
// A method that fails in the way WHAT says.
class FailingMethod : public NaiveRuledSurface
{
public:
  explicit FailingMethod(bool throws)
    : Throws(throws)
  {
  }

  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets&) const override
  {
    if (this->Throws)
    {
      throw std::runtime_error("no, \"never\"");
    }
    return vtkSmartPointer<vtkPolyData>::New();
  }

private:
  bool Throws;
};

//------------------------------------------------------------------------------
TEST(ComparisonTable, FailuresAreRowsThatSaySo)
{
  Task task;
  task.CaseName = "sphere";
  task.Truth = MakeSphere(1.0);
  task.Spacing = 0.1;
  const Row failed = RunMethod(FailingMethod(true), task, 100).Figures;
  const Row empty = RunMethod(FailingMethod(false), task, 100).Figures;
  EXPECT_EQ(failed.Status, "failed: no, \"never\"");
  EXPECT_EQ(empty.Status, "empty surface");
  std::ostringstream table;
  PrintTable({ failed, empty }, table);
  EXPECT_NE(table.str().find("failed: no"), std::string::npos);
  std::ostringstream csv;
  WriteCsv({ failed, empty }, csv);
  EXPECT_NE(csv.str().find("\"failed: no, \"\"never\"\"\""), std::string::npos);
}

//------------------------------------------------------------------------------
// A method that ends its process in the way that it is told.
class EndingMethod : public NaiveRuledSurface
{
public:
  explicit EndingMethod(void (*end)())
    : End(end)
  {
  }

  vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets&) const override
  {
    this->End();
    return vtkSmartPointer<vtkPolyData>::New();
  }

private:
  void (*End)();
};

//------------------------------------------------------------------------------
TEST(ComparisonTable, CrashesAreRowsThatSaySo)
{
#ifdef _WIN32
  GTEST_SKIP() << "methods run in this process";
#else
  Task task;
  task.CaseName = "sphere";
  task.Truth = MakeSphere(1.0);
  task.Spacing = 0.1;
  const EndingMethod killed([]() { std::raise(SIGKILL); }), exits([]() { std::_Exit(3); }),
    silent([]() { std::_Exit(0); });
  const Row row = RunMethod(killed, task, 100).Figures;
  EXPECT_EQ(row.Status.find("crashed: Killed"), 0u) << row.Status;
  EXPECT_EQ(RunMethod(exits, task, 100).Figures.Status, "crashed: exit status 3");
  EXPECT_EQ(RunMethod(silent, task, 100).Figures.Status, "crashed: ended without a result");
  std::ostringstream table;
  PrintTable({ row }, table);
  EXPECT_NE(table.str().find("crashed"), std::string::npos);
#endif
}

//------------------------------------------------------------------------------
// Points and cells of every kind come back as they were.
TEST(RunApart, SurfaceIsTheSameAsInThisProcess)
{
  const SliceSets slices = CutSurface(MakeSphere(1.0), { 8, 8, 8 });
  for (const std::unique_ptr<Baseline>& method : MakeAllMethods())
  {
    SCOPED_TRACE(method->Name());
    const Surface here = method->Reconstruct(slices);
    const TimedSurface apart = RunApart(*method, slices);
    EXPECT_GT(apart.Seconds, 0.0);
    ASSERT_EQ(apart.Surface->GetNumberOfPoints(), here->GetNumberOfPoints());
    ASSERT_EQ(apart.Surface->GetNumberOfPolys(), here->GetNumberOfPolys());
    ASSERT_EQ(apart.Surface->GetNumberOfStrips(), here->GetNumberOfStrips());
    ASSERT_GT(here->GetNumberOfCells(), 0);
    vtkIdType different = 0;
    for (vtkIdType i = 0; i < here->GetNumberOfPoints(); ++i)
    {
      double a[3], b[3];
      here->GetPoint(i, a);
      apart.Surface->GetPoint(i, b);
      different += std::equal(a, a + 3, b) ? 0 : 1;
    }
    vtkNew<vtkIdList> a, b;
    for (vtkIdType i = 0; i < here->GetNumberOfCells(); ++i)
    {
      here->GetCellPoints(i, a);
      apart.Surface->GetCellPoints(i, b);
      different +=
        a->GetNumberOfIds() == b->GetNumberOfIds() && std::equal(a->begin(), a->end(), b->begin())
        ? 0
        : 1;
    }
    EXPECT_EQ(different, 0);
  }
}

//------------------------------------------------------------------------------
TEST(ComparisonTable, GoodSurfaceHasItsFigures)
{
  Task task;
  task.CaseName = "sphere";
  task.Truth = MakeSphere(1.0);
  task.TruthShape = MeasureTopology(task.Truth);
  task.Orthogonal = CutSurface(task.Truth, { 10, 10, 10 });
  task.Parallel = task.Orthogonal;
  task.Spacing = MeanSpacing(task.Orthogonal);
  const Row row = RunMethod(DistanceInterpolation(128), task, 20000).Figures;
  EXPECT_EQ(row.Status, "ok");
  EXPECT_TRUE(row.IsTopologyRight);
  ASSERT_TRUE(row.Figures);
  EXPECT_GT(row.Figures->RootMeanSquare, 0.0);
  EXPECT_LT(row.Figures->RootMeanSquare, 0.2);
  EXPECT_LE(row.Figures->Mean, row.Figures->RootMeanSquare);
  EXPECT_LE(row.Figures->RootMeanSquare, row.Figures->Hausdorff);
}

//------------------------------------------------------------------------------
TEST(ComparisonTable, NamesOfComparisonsAreReadBack)
{
  for (const Comparison kind :
    { Comparison::SamePlanes, Comparison::SameNumber, Comparison::SparseZ })
  {
    EXPECT_EQ(ComparisonFromName(NameOf(kind)), kind);
  }
  EXPECT_THROW(ComparisonFromName("none"), std::runtime_error);
  EXPECT_THROW(ListCases("/no/such/folder"), std::runtime_error);
}

//------------------------------------------------------------------------------
// Of one circle: points stay in their plane, at the same place they stay together, and the
// deviation is the one asked for.
TEST(NoisyContours, VerticesMoveWithinTheirPlaneByTheDeviation)
{
  SliceSets slices = CutSurface(MakeSphere(1.0), { 8, 8, 8 });
  const SliceSets noisy = AddNoise(slices, 0.1, 7);
  const SliceSets again = AddNoise(slices, 0.1, 7);
  for (int axis = 0; axis < 3; ++axis)
  {
    double sum2 = 0.0;
    const vtkIdType count = slices.Families[axis]->GetNumberOfPoints();
    ASSERT_GT(count, 100);
    for (vtkIdType id = 0; id < count; ++id)
    {
      double from[3], to[3], same[3];
      slices.Families[axis]->GetPoint(id, from);
      noisy.Families[axis]->GetPoint(id, to);
      again.Families[axis]->GetPoint(id, same);
      EXPECT_EQ(from[axis], to[axis]);
      EXPECT_TRUE(std::equal(to, to + 3, same));
      sum2 += vtkMath::Distance2BetweenPoints(from, to);
    }
    EXPECT_NEAR(std::sqrt(sum2 / (2.0 * count)), 0.1, 0.01);
  }
  EXPECT_EQ(AddNoise(slices, 0.0, 7).Families[0], slices.Families[0]);
}

//------------------------------------------------------------------------------
TEST(MethodSummary, MarkdownHasALineForEachMethodAndAColumnForEachNoise)
{
  std::vector<Row> rows;
  for (const double noise : { 0.0, 5.0 })
  {
    for (const char* method : { "a", "b" })
    {
      Row row;
      row.CaseName = "sphere";
      row.ComparisonName = "same-planes";
      row.MethodName = method;
      row.NoisePercent = noise;
      row.Figures = Deviation();
      row.Figures->RootMeanSquare = 0.25 + noise;
      row.IsTopologyRight = true;
      row.Crossings = 0;
      rows.push_back(row);
    }
  }
  rows.back().Figures.reset(); // a failure is no median
  std::ostringstream table;
  PrintNoiseTables(rows, table);
  EXPECT_NE(table.str().find("| 0 % | 5 % |"), std::string::npos);
  EXPECT_NE(table.str().find("| a | 0.250 (1, 0, 1) | 5.250 (1, 0, 1) |"), std::string::npos);
  EXPECT_NE(table.str().find("| b | 0.250 (1, 0, 1) | - (1, 0, 1) |"), std::string::npos);
  std::ostringstream summary;
  PrintMarkdownSummaries({ rows[0], rows[1] }, summary);
  EXPECT_NE(
    summary.str().find("| a | 0.250 | 0.00 | 0.0 | 0 of 1 | 1 of 1 | 0.0 |"), std::string::npos);
}
