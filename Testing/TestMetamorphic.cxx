// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   changes of the input or the machine that must not change the surface, or only in a
 * known way
 */

#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Perturbations.h"
#include "Support/SliceSolid.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct NamedSets
{
  std::string Name;
  PieceSets Sets;
};

/// Exact cuts of smooth solids with different numbers of planes, and two shapes of the data folder.
std::vector<NamedSets> Cases()
{
  std::vector<NamedSets> cases;
  for (const Solid& solid : { TiltedTorus(), LinkedTori(), HollowBall(), BranchingTube() })
  {
    cases.push_back(
      { solid.Name, SliceSolid(solid, EqualPlanes(solid, { 13, 14, 16 }), 3, InPlaneGrid::Free) });
  }
  cases.push_back({ "heart", ReadPieceSets({ "heart", 1, 1, true }, 16) });
  cases.push_back({ "lbl_lumbar3", ReadPieceSets({ "lbl_lumbar3", 1, 1, false }, 16) });
  return cases;
}

template <typename Visit>
void VisitCases(Visit&& visit)
{
  for (const NamedSets& item : Cases())
  {
    SCOPED_TRACE(item.Name);
    visit(item.Sets);
  }
}

vtkSmartPointer<vtkPolyData> UpdateInDouble(FilterRun& run)
{
  run.Filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkSmartPointer<vtkPolyData> surface = run.Update();
  EXPECT_TRUE(run.Errors.empty()) << run.Errors[0];
  EXPECT_GT(surface->GetNumberOfCells(), 0);
  return surface;
}

/// Surface in double precision, with all triangles: which few there are depends on their order.
vtkSmartPointer<vtkPolyData> Surface(
  const PieceSets& sets, Form form = Form::ClosedLine, int type = VTK_DOUBLE)
{
  FilterRun run(sets, form, type);
  run.Filter->AutomaticAccuracyOff();
  return UpdateInDouble(run);
}

/// Fans between the slices that there are depend on nothing but the contours: not on which axis is
/// the first one, nor on left and right.
vtkSmartPointer<vtkPolyData> SurfaceOfFans(const PieceSets& sets)
{
  FilterRun run(sets, Form::ClosedLine, VTK_DOUBLE);
  run.Filter->SetPatchTypeToFan();
  run.Filter->SetVirtualSlicesToOff();
  return UpdateInDouble(run);
}

/// Smooth patches have the same shape with other triangles.
void ExpectAlike(vtkPolyData* a, vtkPolyData* b)
{
  const SurfaceCheck first = CheckSurface(MeshOf(a)), second = CheckSurface(MeshOf(b));
  EXPECT_EQ(first.Components, second.Components);
  EXPECT_EQ(first.TotalGenus(), second.TotalGenus());
  const double volume = first.TotalVolume();
  EXPECT_NEAR(second.TotalVolume(), volume, 2e-3 * volume);
}

bool SameBytes(vtkDataArray* a, vtkDataArray* b)
{
  const std::size_t size = a->GetNumberOfValues() * a->GetDataTypeSize();
  return a->GetDataType() == b->GetDataType() && a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::equal(static_cast<const char*>(a->GetVoidPointer(0)),
      static_cast<const char*>(a->GetVoidPointer(0)) + size,
      static_cast<const char*>(b->GetVoidPointer(0)));
}

void ExpectSameBytes(vtkPolyData* a, vtkPolyData* b)
{
  EXPECT_TRUE(SameBytes(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  EXPECT_TRUE(
    SameBytes(a->GetPolys()->GetConnectivityArray(), b->GetPolys()->GetConnectivityArray()));
  EXPECT_TRUE(SameBytes(a->GetPointData()->GetNormals(), b->GetPointData()->GetNormals()));
  for (const char* name : { "ComponentId", "GridCell", "PolygonSize" })
  {
    EXPECT_TRUE(SameBytes(a->GetCellData()->GetArray(name), b->GetCellData()->GetArray(name)));
  }
}

/// Triangles by their rounded corners, whatever the numbers and the order of points and triangles.
using Rounded = std::array<std::array<std::int64_t, 3>, 3>;

std::vector<Rounded> Canonical(const TriangleMesh& mesh)
{
  std::vector<Rounded> triangles;
  for (const auto& ids : mesh.Triangles)
  {
    Rounded corners;
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corners[corner][axis] = std::llround(mesh.Points[ids[corner]][axis] * 1e7);
      }
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void ExpectSameTriangles(const std::vector<Rounded>& a, const std::vector<Rounded>& b)
{
  std::vector<Rounded> different;
  std::set_symmetric_difference(
    a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(different));
  EXPECT_EQ(different.size(), 0u) << "of " << a.size() << " and " << b.size();
}

void ExpectSameSurface(vtkPolyData* a, vtkPolyData* b)
{
  ExpectSameTriangles(Canonical(MeshOf(a)), Canonical(MeshOf(b)));
}

/// The surface with coordinates mapped; reversed triangles if the map turns left into right.
template <typename Map>
std::vector<Rounded> Mapped(vtkPolyData* surface, bool mirrors, Map&& map)
{
  TriangleMesh mesh = MeshOf(surface);
  for (Point3& p : mesh.Points)
  {
    p = map(p);
  }
  for (auto& ids : mesh.Triangles)
  {
    if (mirrors)
    {
      std::swap(ids[1], ids[2]);
    }
  }
  return Canonical(mesh);
}
}

//----------------------------------------------------------------------------
TEST(Metamorphic, PolygonsAndClosedLinesGiveTheSameBytes)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      const auto surface = Surface(sets);
      ExpectSameBytes(surface, Surface(sets, Form::Polygon));
      ExpectSameBytes(surface, Surface(sets, Form::RepeatedPoint));
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, EveryFormOfContoursGivesTheSameSurface)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      const auto surface = Surface(sets);
      for (const Form form : { Form::OpenLine, Form::Segments, Form::LooseSegments, Form::Mixture })
      {
        SCOPED_TRACE(static_cast<int>(form));
        ExpectSameSurface(surface, Surface(sets, form));
      }
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, FloatAndDoublePointsGiveTheSameSurface)
{
  // The contours of the data folder are floats, so nothing is lost.
  for (const char* name : { "heart", "lbl_lumbar3" })
  {
    const PieceSets sets = ReadPieceSets({ name, 1, 1, true }, 16);
    ExpectSameBytes(
      Surface(sets, Form::Polygon, VTK_FLOAT), Surface(sets, Form::Polygon, VTK_DOUBLE));
  }
}

//----------------------------------------------------------------------------
TEST(Metamorphic, SegmentsGivenTwiceGiveTheSameSurface)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      PieceSets twice = sets;
      SplitIntoSegments(twice, 5);
      DuplicatePieces(twice);
      ShufflePieces(twice, 6);
      ExpectSameSurface(Surface(sets), Surface(twice));
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, OrderOfContoursAndFirstVerticesDoNotMatter)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      PieceSets shuffled = sets;
      ShufflePieces(shuffled, 3);
      ExpectSameSurface(Surface(sets), Surface(shuffled));
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, DirectionsDoNotMatterByNesting)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      PieceSets reversed = sets;
      ReverseContours(reversed, 0.5, 4);
      ExpectSameSurface(Surface(sets), Surface(reversed));
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, PermutedAxesGiveThePermutedSurface)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      const auto surface = SurfaceOfFans(sets), smooth = Surface(sets);
      PieceSets permuted = sets;
      for (int turns = 0; turns < 3; ++turns)
      {
        SCOPED_TRACE(turns);
        const auto turned = [turns](const Point3& p) -> Point3 {
          return { p[(3 - turns) % 3], p[(4 - turns) % 3], p[(5 - turns) % 3] };
        };
        ExpectSameTriangles(
          Canonical(MeshOf(SurfaceOfFans(permuted))), Mapped(surface, false, turned));
        PieceSets exchanged = permuted;
        ExchangeXAndY(exchanged);
        ExpectSameTriangles(Canonical(MeshOf(SurfaceOfFans(exchanged))),
          Mapped(surface, true,
            [&](const Point3& p) -> Point3
            {
              const Point3 q = turned(p);
              return { q[1], q[0], q[2] };
            }));
        ExpectAlike(smooth, Surface(permuted));
        ExpectAlike(smooth, Surface(exchanged));
        PermuteAxes(permuted);
      }
    });
}

//----------------------------------------------------------------------------
namespace
{
/// Whether contours have vertices on planes of the other axes, as those from voxels have.
bool HasVerticesOnPlanes(const PieceSets& sets)
{
  std::array<std::set<double>, 3> planes;
  for (const Pieces& pieces : sets)
  {
    planes[pieces.Axis].insert(pieces.W.begin(), pieces.W.end());
  }
  const auto any = [&](int axis, const std::vector<double>& values)
  {
    return std::any_of(
      values.begin(), values.end(), [&](double x) { return planes[axis].count(x) > 0; });
  };
  return std::any_of(sets.begin(), sets.end(),
    [&](const Pieces& p) { return any(FirstAxis(p.Axis), p.U) || any(SecondAxis(p.Axis), p.V); });
}
}

TEST(Metamorphic, MirroredContoursGiveTheMirroredSurface)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      if (HasVerticesOnPlanes(sets))
      {
        return; // a vertex on a plane lies above it, and its mirror image does not lie below
      }
      const auto surface = SurfaceOfFans(sets), smooth = Surface(sets);
      for (int axes = 1; axes < 8; ++axes) // bits 0, 1, 2: across x, y, z
      {
        SCOPED_TRACE(axes);
        PieceSets mirrored = sets;
        Point3 sign{ 1.0, 1.0, 1.0 };
        for (int axis = 0; axis < 3; ++axis)
        {
          if ((axes >> axis) & 1)
          {
            Mirror(mirrored, axis);
            sign[axis] = -1.0;
          }
        }
        const auto expected = Mapped(surface, sign[0] * sign[1] * sign[2] < 0.0,
          [&sign](const Point3& p) -> Point3 {
            return { sign[0] * p[0], sign[1] * p[1], sign[2] * p[2] };
          });
        ExpectSameTriangles(Canonical(MeshOf(SurfaceOfFans(mirrored))), expected);
        ExpectAlike(smooth, Surface(mirrored));
      }
    });
}

//----------------------------------------------------------------------------
namespace
{
/// In the precision of the input.
vtkSmartPointer<vtkPolyData> SurfaceOfType(const PieceSets& sets, int type)
{
  FilterRun run(sets, Form::ClosedLine, type);
  vtkSmartPointer<vtkPolyData> surface = run.Update();
  EXPECT_EQ(surface->GetPoints()->GetDataType(), type);
  return surface;
}

void ExpectScaled(vtkPolyData* surface, int exponent, vtkPolyData* result)
{
  ASSERT_EQ(result->GetNumberOfPoints(), surface->GetNumberOfPoints());
  EXPECT_TRUE(SameBytes(
    result->GetPolys()->GetConnectivityArray(), surface->GetPolys()->GetConnectivityArray()));
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double a[3], b[3];
    surface->GetPoint(i, a);
    result->GetPoint(i, b);
    for (int axis = 0; axis < 3; ++axis)
    {
      different += std::ldexp(a[axis], exponent) != b[axis] ? 1 : 0;
    }
  }
  EXPECT_EQ(different, 0);
}
}

TEST(Metamorphic, PowersOfTwoScaleEveryBit)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      for (const int type : { VTK_DOUBLE, VTK_FLOAT })
      {
        const auto surface = SurfaceOfType(sets, type);
        EXPECT_GT(surface->GetNumberOfCells(), 0);
        for (const int exponent : { -30, -3, 1, 10, 40 })
        {
          SCOPED_TRACE(std::to_string(exponent) + (type == VTK_FLOAT ? ", float" : ", double"));
          PieceSets scaled = sets;
          Scale(scaled, std::ldexp(1.0, exponent));
          ExpectScaled(surface, exponent, SurfaceOfType(scaled, type));
        }
      }
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, TranslatedContoursGiveTheTranslatedSurface)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      PieceSets moved = sets;
      Translate(moved, { 8.0, -16.0, 4.0 });
      ExpectAlike(Surface(sets), Surface(moved));
      const auto a = SurfaceOfFans(sets), b = SurfaceOfFans(moved);
      ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
      ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
      double greatest = 0.0;
      for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
      {
        double p[3], q[3];
        a->GetPoint(i, p);
        b->GetPoint(i, q);
        greatest = std::max({ greatest, std::abs(p[0] + 8.0 - q[0]), std::abs(p[1] - 16.0 - q[1]),
          std::abs(p[2] + 4.0 - q[2]) });
      }
      EXPECT_LT(greatest, 1e-9);
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, NumberOfThreadsDoesNotMatter)
{
  VisitCases(
    [](const PieceSets& sets)
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
        [&]()
        {
          const auto sequential = Surface(sets);
          for (const int threads : { 1, 2, 4 })
          {
            SCOPED_TRACE(threads);
            vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
              [&]()
              {
                EXPECT_STREQ(vtkSMPTools::GetBackend(), "STDThread");
                ExpectSameBytes(sequential, Surface(sets));
              });
          }
        });
    });
}

//----------------------------------------------------------------------------
TEST(Metamorphic, ExecutingAgainGivesTheSameBytes)
{
  const std::vector<NamedSets> cases = Cases();
  FilterRun run(cases[0].Sets);
  vtkNew<vtkPolyData> first;
  first->DeepCopy(run.Update());
  run.Filter->Modified();
  ExpectSameBytes(first, run.Update());
  // Nothing of another input is left behind.
  run.SetInputs(cases[4].Sets);
  run.Update();
  run.SetInputs(cases[0].Sets);
  ExpectSameBytes(first, run.Update());
  FilterRun fresh(cases[0].Sets);
  ExpectSameBytes(first, fresh.Update());
}
