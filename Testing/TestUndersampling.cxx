// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   slices too far apart: vtkOrthogonalSliceReconstruction where it has to choose what
 * belongs together, and what it says about that
 */

#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Perturbations.h"
#include "Support/RandomInput.h"
#include "Support/SelfIntersections.h"
#include "Support/SliceSolid.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sstream>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Filter = vtkOrthogonalSliceReconstruction;

bool Contains(const std::vector<std::string>& messages, const std::string& part)
{
  return std::any_of(messages.begin(), messages.end(),
    [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

/// Only the sets with contours are connected.
struct SparseRun : FilterRun
{
  explicit SparseRun(const PieceSets& sets, int type = VTK_DOUBLE)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (sets[axis].Count() > 0)
      {
        this->Filter->SetInputData(axis, MakePolyData(sets[axis], Form::ClosedLine, type));
      }
    }
  }
  explicit SparseRun(const std::string& text)
    : SparseRun(ParsePieces(text))
  {
  }

  vtkPolyData* Update()
  {
    vtkPolyData* surface = this->FilterRun::Update();
    EXPECT_TRUE(this->Errors.empty()) << this->Errors[0];
    return surface;
  }
};

/// Squares of size 1 above each other on z-slices only.
std::string Stack(double x, double y, int count)
{
  std::ostringstream text;
  for (int plane = 0; plane < count; ++plane)
  {
    text << "z=" << plane << ": " << x << "," << y << " " << x + 1 << "," << y << " " << x + 1
         << "," << y + 1 << " " << x << "," << y + 1 << "\n";
  }
  return text.str();
}

std::int64_t ComponentsOf(vtkPolyData* surface) { return CheckSurface(MeshOf(surface)).Components; }

std::int64_t GenusOf(vtkPolyData* surface) { return CheckSurface(MeshOf(surface)).TotalGenus(); }
}

//----------------------------------------------------------------------------
TEST(Undersampling, DefaultsAndRanges)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetSeveralCycles(), Filter::BY_EVIDENCE);
  EXPECT_EQ(filter->GetExpectedComponents(), 0);
  EXPECT_EQ(filter->GetExpectedGenus(), -1);
  EXPECT_EQ(filter->GetMinimumComponentSize(), 0.0);
  EXPECT_EQ(filter->GetMinimumIsolatedContourSize(), 0.0);

  filter->SetSeveralCyclesToDiscs();
  EXPECT_EQ(filter->GetSeveralCycles(), Filter::DISCS);
  filter->SetSeveralCyclesToByEvidence();
  EXPECT_EQ(filter->GetSeveralCycles(), Filter::BY_EVIDENCE);
  filter->SetSeveralCycles(9);
  EXPECT_EQ(filter->GetSeveralCycles(), Filter::DISCS);
  filter->SetSeveralCycles(-9);
  EXPECT_EQ(filter->GetSeveralCycles(), Filter::BY_EVIDENCE);
  filter->SetExpectedComponents(-3);
  EXPECT_EQ(filter->GetExpectedComponents(), 0);
  filter->SetExpectedGenus(-3);
  EXPECT_EQ(filter->GetExpectedGenus(), -1);
  filter->SetMinimumComponentSize(-1.0);
  EXPECT_EQ(filter->GetMinimumComponentSize(), 0.0);
  filter->SetMinimumComponentSize(2.0);
  EXPECT_EQ(filter->GetMinimumComponentSize(), 1.0);
  filter->SetMinimumIsolatedContourSize(-1.0);
  EXPECT_EQ(filter->GetMinimumIsolatedContourSize(), 0.0);
  filter->SetMinimumIsolatedContourSize(2.0);
  EXPECT_EQ(filter->GetMinimumIsolatedContourSize(), 1.0);
}

//----------------------------------------------------------------------------
TEST(Undersampling, EverySetterChangesTheTimeOnlyIfTheValueChanges)
{
  vtkNew<Filter> filter;
  const std::vector<std::function<void()>> changes{
    [&] { filter->SetSeveralCyclesToDiscs(); },
    [&] { filter->SetExpectedComponents(2); },
    [&] { filter->SetExpectedGenus(0); },
    [&] { filter->SetMinimumComponentSize(0.1); },
    [&] { filter->SetMinimumIsolatedContourSize(0.1); },
  };
  for (const auto& change : changes)
  {
    const vtkMTimeType before = filter->GetMTime();
    change();
    const vtkMTimeType after = filter->GetMTime();
    EXPECT_GT(after, before);
    change();
    EXPECT_EQ(filter->GetMTime(), after);
  }
}

//----------------------------------------------------------------------------
TEST(Undersampling, PrintsEveryProperty)
{
  vtkNew<Filter> filter;
  filter->SetExpectedComponents(7);
  filter->SetExpectedGenus(5);
  filter->SetMinimumComponentSize(0.25);
  filter->SetMinimumIsolatedContourSize(0.125);
  std::ostringstream byEvidence, discs;
  filter->Print(byEvidence);
  filter->SetSeveralCyclesToDiscs();
  filter->Print(discs);
  for (const char* name : { "SeveralCycles: ", "ExpectedComponents: 7", "ExpectedGenus: 5",
         "MinimumComponentSize: 0.25", "MinimumIsolatedContourSize: 0.125" })
  {
    EXPECT_TRUE(Contains({ byEvidence.str() }, name)) << name;
  }
  EXPECT_TRUE(Contains({ byEvidence.str() }, "SeveralCycles: ByEvidence"));
  EXPECT_TRUE(Contains({ discs.str() }, "SeveralCycles: Discs"));
}

//----------------------------------------------------------------------------
TEST(Undersampling, SizesThatAreNoNumbersAreErrors)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const char* name : { "MinimumComponentSize", "MinimumIsolatedContourSize" })
  {
    FilterRun run(ParsePieces(Stack(0, 0, 3)));
    if (std::string(name) == "MinimumComponentSize")
    {
      run.Filter->SetMinimumComponentSize(nan);
    }
    else
    {
      run.Filter->SetMinimumIsolatedContourSize(nan);
    }
    run.FilterRun::Update();
    EXPECT_TRUE(Contains(run.Errors, std::string(name) + " is not a number"));
    EXPECT_EQ(run.Filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

//----------------------------------------------------------------------------
TEST(Undersampling, AnyOfThePortsWillDo)
{
  const Solid solid = TiltedTorus();
  const PieceSets all = SliceSolid(solid, EqualPlanes(solid, { 20, 20, 20 }), 2, InPlaneGrid::Free);
  for (int ports = 1; ports < 8; ++ports)
  {
    SCOPED_TRACE(ports);
    PieceSets some = EmptySets();
    for (int axis = 0; axis < 3; ++axis)
    {
      if (ports >> axis & 1)
      {
        some[axis] = all[axis];
      }
    }
    SparseRun run(some);
    if (ports == 1 || ports == 2 || ports == 4)
    {
      // Parallel slices alone do not tell.
      run.Filter->SetExpectedComponents(1);
      run.Filter->SetExpectedGenus(1);
    }
    vtkPolyData* surface = run.Update();
    EXPECT_EQ(DescribeFlaws(MeshOf(surface)), "");
    EXPECT_EQ(ComponentsOf(surface), 1);
    EXPECT_EQ(GenusOf(surface), 1);
  }
}

//----------------------------------------------------------------------------
TEST(Undersampling, PortsWithoutContours)
{
  SparseRun none(EmptySets());
  none.FilterRun::Update();
  EXPECT_FALSE(none.Errors.empty());
  // A port that is connected and has no contours is as good as one that is not connected.
  FilterRun empty(ParsePieces(Stack(0, 0, 3)));
  empty.Update();
  EXPECT_TRUE(empty.Errors.empty());
  SparseRun absent(ParsePieces(Stack(0, 0, 3)));
  EXPECT_GT(absent.Update()->GetNumberOfCells(), 0);
  EXPECT_EQ(empty.Filter->GetOutput()->GetNumberOfCells(),
    absent.Filter->GetOutput()->GetNumberOfCells());
}

//----------------------------------------------------------------------------
TEST(Undersampling, ColumnsOfTheTableOfUndecidedPlaces)
{
  int rows = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Input input = RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    SparseRun run(input.Sets);
    vtkPolyData* surface = run.Update();
    vtkTable* table = run.Filter->GetUndecidedTable();
    ASSERT_EQ(table, run.Filter->GetOutputDataObject(5));
    const struct
    {
      const char* Name;
      int Type;
    } columns[] = { { "X", VTK_DOUBLE }, { "Y", VTK_DOUBLE }, { "Z", VTK_DOUBLE },
      { "Kind", VTK_INT }, { "Choice", VTK_INT }, { "Evidence", VTK_DOUBLE },
      { "PlaneRank", VTK_INT }, { "PlaneAxis", VTK_INT }, { "PlaneCoordinate", VTK_DOUBLE },
      { "PlaneSettles", VTK_ID_TYPE }, { "KindName", VTK_STRING }, { "ChoiceName", VTK_STRING },
      { "PlaneName", VTK_STRING } };
    EXPECT_EQ(table->GetNumberOfColumns(), 13);
    for (const auto& column : columns)
    {
      ASSERT_NE(table->GetColumnByName(column.Name), nullptr) << column.Name;
      EXPECT_EQ(table->GetColumnByName(column.Name)->GetDataType(), column.Type) << column.Name;
    }
    EXPECT_EQ(FieldValue(surface, "NumberOfUndecidedPlaces"), table->GetNumberOfRows());
    // The warning is about some of the rows only; see TestWeightsAndReport.
    EXPECT_TRUE(!Contains(run.Warnings, "would settle") || table->GetNumberOfRows() > 0);
    const auto value = [&](vtkIdType row, const char* name)
    { return table->GetValueByName(row, name).ToDouble(); };
    std::map<int, vtkIdType> settled;
    const double* bounds = surface->GetBounds();
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      EXPECT_TRUE(row == 0 || value(row - 1, "PlaneRank") <= value(row, "PlaneRank"));
      ++settled[static_cast<int>(value(row, "PlaneRank"))];
      EXPECT_TRUE(value(row, "Kind") >= 0 && value(row, "Kind") <= 2);
      EXPECT_TRUE(value(row, "Choice") >= 0 && value(row, "Choice") <= 2);
      EXPECT_TRUE(value(row, "Choice") == 2 || std::abs(value(row, "Evidence")) < 3.0);
      const int axis = static_cast<int>(value(row, "PlaneAxis"));
      ASSERT_TRUE(axis >= 0 && axis <= 2);
      EXPECT_GE(value(row, "PlaneCoordinate"), bounds[2 * axis]);
      EXPECT_LE(value(row, "PlaneCoordinate"), bounds[2 * axis + 1]);
      for (int i = 0; i < 3; ++i)
      {
        const char* names[] = { "X", "Y", "Z" };
        EXPECT_GE(value(row, names[i]), bounds[2 * i]);
        EXPECT_LE(value(row, names[i]), bounds[2 * i + 1]);
      }
      ++rows;
    }
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      EXPECT_EQ(value(row, "PlaneSettles"), settled[static_cast<int>(value(row, "PlaneRank"))]);
    }
  }
  EXPECT_GT(rows, 20);
}

//----------------------------------------------------------------------------
TEST(Undersampling, WarnsIfExpectedNumbersCannotBeMet)
{
  const std::string text = Stack(0, 0, 3) + Stack(3, 0, 3);
  const auto warningsOf = [&](int components, int genus, bool discs, vtkIdType& count)
  {
    SparseRun run(text);
    run.Filter->SetExpectedComponents(components);
    run.Filter->SetExpectedGenus(genus);
    run.Filter->SetSeveralCycles(discs ? Filter::DISCS : Filter::BY_EVIDENCE);
    vtkPolyData* surface = run.Update();
    count = FieldValue(surface, "NumberOfComponents");
    EXPECT_EQ(count, ComponentsOf(surface));
    EXPECT_EQ(FieldValue(surface, "TotalGenus"), GenusOf(surface));
    EXPECT_EQ(DescribeFlaws(MeshOf(surface)), "");
    return run.Warnings;
  };
  vtkIdType count;
  for (int components = 1; components <= 6; ++components)
  {
    const auto warnings = warningsOf(components, 0, false, count);
    EXPECT_EQ(count, components);
    EXPECT_FALSE(Contains(warnings, "as expected"));
  }
  EXPECT_TRUE(Contains(warningsOf(7, -1, false, count), "has 6 components, not 7 as expected"));
  EXPECT_EQ(count, 6);
  EXPECT_TRUE(Contains(warningsOf(0, 1000, false, count), "not 1000 as expected"));
  EXPECT_FALSE(Contains(warningsOf(0, -1, false, count), "as expected"));
  // No effect with discs, so no complaint.
  EXPECT_FALSE(Contains(warningsOf(1, 5, true, count), "as expected"));
  EXPECT_EQ(count, 6);
}

//----------------------------------------------------------------------------
TEST(Undersampling, ComponentIdOfIsolatedContours)
{
  // Two stacks, and a contour that crosses one of the first.
  SparseRun run(Stack(0, 0, 3) + Stack(5, 0, 2) + "z=1: 5.2,0.2 5.4,0.2 5.3,0.3\n");
  run.Filter->SetMinimumIsolatedContourSize(0.05);
  // Virtual slices give contours of a stack node points: they are no longer isolated.
  vtkPolyData* surface = run.Update();
  EXPECT_EQ(FieldValue(surface, "NumberOfContoursLeftOut"), 1);
  EXPECT_EQ(FieldValue(surface, "NumberOfIsolatedContours"), 1);
  EXPECT_TRUE(Contains(run.Warnings, "1 contours"));
  run.Filter->SetVirtualSlicesToOff();
  surface = run.Update();
  EXPECT_EQ(FieldValue(surface, "NumberOfContoursLeftOut"), 1);
  EXPECT_EQ(FieldValue(surface, "NumberOfIsolatedContours"), 6);
  EXPECT_TRUE(Contains(run.Warnings, "1 contours"));
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  ASSERT_EQ(check.Components, 2);
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  vtkDataArray* kind = graph->GetCellData()->GetArray("Kind");
  vtkDataArray* component = graph->GetCellData()->GetArray("ComponentId");
  vtkDataArray* surfaceComponent = surface->GetCellData()->GetArray("ComponentId");
  std::multiset<int> ids;
  for (vtkIdType cell = 0; cell < graph->GetNumberOfCells(); ++cell)
  {
    if (kind->GetTuple1(cell) != 2)
    {
      continue;
    }
    const int id = static_cast<int>(component->GetTuple1(cell));
    ids.insert(id);
    if (id < 0)
    {
      continue;
    }
    // Its vertices are points of triangles with that number and of no others.
    vtkNew<vtkIdList> points;
    graph->GetCellPoints(cell, points);
    const TriangleMesh mesh = MeshOf(surface);
    Point3 p;
    graph->GetPoint(points->GetId(0), p.data());
    int found = 0;
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (const std::int64_t corner : mesh.Triangles[t])
      {
        if (mesh.Points[corner] == p)
        {
          ++found;
          EXPECT_EQ(surfaceComponent->GetTuple1(static_cast<vtkIdType>(t)), id);
        }
      }
    }
    EXPECT_GT(found, 0);
  }
  EXPECT_EQ(ids.count(-1), 1u);
  EXPECT_EQ(ids.count(0) + ids.count(1), 5u);
  EXPECT_GE(ids.count(0), 2u);
  EXPECT_GE(ids.count(1), 2u);
}

//----------------------------------------------------------------------------
TEST(Undersampling, SmallComponentsAreLeftOutAndCounted)
{
  SparseRun run(Stack(0, 0, 3) + "z=1: 9,9 9.1,9 9.1,9.1\n");
  EXPECT_EQ(ComponentsOf(run.Update()), 2);
  EXPECT_EQ(FieldValue(run.Filter->GetOutput(), "NumberOfComponentsLeftOut"), 0);
  run.Filter->SetMinimumComponentSize(0.1);
  EXPECT_EQ(ComponentsOf(run.Update()), 1);
  EXPECT_EQ(FieldValue(run.Filter->GetOutput(), "NumberOfComponentsLeftOut"), 1);
  EXPECT_EQ(FieldValue(run.Filter->GetOutput(), "NumberOfContoursLeftOut"), 1);
  EXPECT_EQ(FieldValue(run.Filter->GetOutput(), "NumberOfComponents"), 1);
}

//----------------------------------------------------------------------------
namespace
{
Solid ThinRing(const Point3& axis, double radius)
{
  Solid solid;
  solid.Name = "ThinRing";
  solid.Low = { -1.011, -1.023, -1.037 };
  solid.High = { 1.017, 1.013, 1.029 };
  solid.Tubes = { Torus({ 0.013, -0.017, 0.011 }, axis, 0.7, radius) };
  return solid;
}
}

/// Tubes of 0.5 to 0.9 spacings around a circle: known to be one ring, it is one.
TEST(Undersampling, ThinRingsWithPriorKnowledge)
{
  int rings = 0;
  for (const Point3& axis : { Point3{ 0.0, 0.0, 1.0 }, Point3{ 0.1, 0.03, 1.0 },
         Point3{ 1.0, 0.2, 0.1 }, Point3{ 0.3, 1.0, -0.4 }, Point3{ 0.6, 0.5, 0.7 },
         Point3{ -0.5, 0.8, 0.2 }, Point3{ 0.0, 1.0, 1.0 } })
  {
    for (const int count : { 16, 20, 24 })
    {
      for (const double thickness : { 0.5, 0.7, 0.9 })
      {
        SCOPED_TRACE(::testing::Message() << "axis " << axis[0] << ", " << axis[1] << ", "
                                          << axis[2] << ", " << count << " planes, " << thickness);
        const Solid solid = ThinRing(axis, 0.5 * thickness * 2.04 / count);
        const PieceSets sets =
          SliceSolid(solid, EqualPlanes(solid, { count, count, count }), 8, InPlaneGrid::Free);
        SparseRun run(sets);
        run.Filter->SetExpectedComponents(1);
        run.Filter->SetExpectedGenus(1);
        vtkPolyData* surface = run.Update();
        const TriangleMesh mesh = MeshOf(surface);
        EXPECT_EQ(DescribeFlaws(mesh), "");
        EXPECT_LE(CountSelfIntersections(mesh), 0);
        EXPECT_FALSE(Contains(run.Warnings, "as expected"));
        const SurfaceCheck check = CheckSurface(mesh);
        EXPECT_EQ(check.Components, 1);
        EXPECT_EQ(check.TotalGenus(), 1);
        const double pi = 3.14159265358979;
        const double radius = solid.Tubes[0].Radius;
        const double volume = 2.0 * pi * 0.7 * pi * radius * radius;
        EXPECT_GT(check.TotalVolume(), 0.3 * volume);
        EXPECT_LT(check.TotalVolume(), 1.5 * volume);
        ++rings;
      }
    }
  }
  EXPECT_EQ(rings, 63);
}

//----------------------------------------------------------------------------
namespace
{
/// G1, G2, G3 and G6; and what the filter says of the topology.
void ExpectGuarantees(vtkPolyData* surface)
{
  const TriangleMesh mesh = MeshOf(surface);
  EXPECT_EQ(DescribeFlaws(mesh), "");
  EXPECT_LE(CountSelfIntersections(mesh), 0);
  const SurfaceCheck check = CheckSurface(mesh);
  EXPECT_TRUE(check.IsClosedManifold()) << check;
  EXPECT_EQ(FieldValue(surface, "NumberOfComponents"), check.Components);
  EXPECT_EQ(FieldValue(surface, "TotalGenus"), check.TotalGenus());
}

std::vector<char> BytesOf(vtkDataArray* array)
{
  const auto* begin = static_cast<const char*>(array->GetVoidPointer(0));
  return { begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize() };
}

std::vector<std::vector<char>> BytesOf(vtkPolyData* surface)
{
  std::vector<std::vector<char>> bytes{ BytesOf(surface->GetPoints()->GetData()),
    BytesOf(surface->GetPolys()->GetConnectivityArray()) };
  for (const char* name : { "ComponentId", "GridCell", "PolygonSize" })
  {
    bytes.push_back(BytesOf(surface->GetCellData()->GetArray(name)));
  }
  bytes.push_back(BytesOf(surface->GetPointData()->GetNormals()));
  return bytes;
}

/// With so few planes, the volume of smooth patches depends much on their triangles.
double VolumeOfFans(const PieceSets& sets)
{
  SparseRun run(sets);
  run.Filter->SetVirtualSlicesToOff(); // of the patches between the slices that there are
  run.Filter->SetPatchTypeToFan();
  return CheckSurface(MeshOf(run.Update())).TotalVolume();
}

/// Thin tubes and balls on one, two and three families.
template <typename Visit>
void VisitThinSolids(std::uint64_t usual, Visit&& visit)
{
  const std::uint64_t runs = RandomRuns(usual);
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + runs; ++seed)
  {
    const Input input = RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    visit(input.Sets);
  }
}
}

//----------------------------------------------------------------------------
TEST(Undersampling, GuaranteesInBothPrecisions)
{
  VisitThinSolids(60,
    [](const PieceSets& sets)
    {
      for (const int type : { VTK_DOUBLE, VTK_FLOAT })
      {
        SparseRun run(sets, type);
        vtkPolyData* surface = run.Update();
        EXPECT_EQ(surface->GetPoints()->GetDataType(), type);
        ExpectGuarantees(surface);
      }
    });
}

//----------------------------------------------------------------------------
TEST(Undersampling, SameTopologyForPermutedAxesMirroredAndShuffled)
{
  using Change = std::function<void(PieceSets&)>;
  const std::vector<std::pair<const char*, Change>> changes{
    { "permuted", [](PieceSets& sets) { PermuteAxes(sets); } },
    { "exchanged", [](PieceSets& sets) { ExchangeXAndY(sets); } },
    { "mirrored", [](PieceSets& sets) { Mirror(sets, 2); } },
    { "shuffled", [](PieceSets& sets) { ShufflePieces(sets, 3); } },
    { "reversed", [](PieceSets& sets) { ReverseContours(sets, 0.5, 4); } },
  };
  VisitThinSolids(30,
    [&](const PieceSets& sets)
    {
      SparseRun run(sets);
      const SurfaceCheck before = CheckSurface(MeshOf(run.Update()));
      for (const auto& change : changes)
      {
        SCOPED_TRACE(change.first);
        PieceSets changed = sets;
        change.second(changed);
        SparseRun other(changed);
        vtkPolyData* surface = other.Update();
        ExpectGuarantees(surface);
        const SurfaceCheck after = CheckSurface(MeshOf(surface));
        EXPECT_EQ(after.Components, before.Components);
        EXPECT_EQ(after.TotalGenus(), before.TotalGenus());
        // Where points of two contours are equally far apart, tubes may begin at others.
        const double volume = VolumeOfFans(sets);
        EXPECT_NEAR(VolumeOfFans(changed), volume, 0.1 * std::abs(volume));
      }
    });
}

//----------------------------------------------------------------------------
TEST(Undersampling, SameBytesForAnyNumberOfThreads)
{
  VisitThinSolids(40,
    [](const PieceSets& sets)
    {
      std::vector<std::vector<char>> bytes[2];
      std::vector<std::string> warnings[2];
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
        [&]()
        {
          for (const int threads : { 1, 4 })
          {
            vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
              [&]()
              {
                EXPECT_STREQ(vtkSMPTools::GetBackend(), "STDThread");
                SparseRun run(sets);
                bytes[threads / 4] = BytesOf(run.Update());
                warnings[threads / 4] = run.Warnings;
              });
          }
        });
      EXPECT_EQ(bytes[0], bytes[1]);
      EXPECT_EQ(warnings[0].size(), warnings[1].size());
      EXPECT_FALSE(bytes[0].empty());
    });
}
