// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the properties of vtkOrthogonalSliceReconstruction about virtual slices, and what its
 *          outputs say of them
 */

#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/SparseSolids.h"
#include "Support/Vtk/PolyDataMesh.h"
#include "Support/Vtk/PropertyChanges.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Filter = vtkOrthogonalSliceReconstruction;
using Change = std::function<void(Filter*)>;

/// The filter on slices of a torus; families without planes are not connected.
struct TorusRun : FilterRun
{
  explicit TorusRun(
    const std::array<int, 3>& count,
    const Change& change = [](vtkOrthogonalSliceReconstruction*) {})
  {
    const Solid torus = TorusAround(0, 0.3);
    const PieceSets sets = SliceByFewPlanes(torus, EqualPlanes(torus, count));
    for (int axis = 0; axis < 3; ++axis)
    {
      if (count[axis] > 0)
      {
        this->Filter->SetInputData(axis, MakePolyData(sets[axis]));
      }
    }
    this->Filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    change(this->Filter);
    this->Surface = this->Update();
  }

  vtkTable* Table(int port)
  {
    return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(port));
  }

  vtkPolyData* Surface;
};

/// Without what comes before them: the address of the filter.
std::vector<std::string> MessagesOf(std::vector<std::string> texts)
{
  for (std::string& text : texts)
  {
    text.erase(0, text.find("): "));
  }
  return texts;
}

/// How many rows of the table of slices are virtual; -1 if it does not say.
int CountVirtual(TorusRun& run)
{
  for (int port = 0; port < run.Filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkTable* table = run.Table(port);
    if (table == nullptr || table->GetColumnByName("OverruledVertices") == nullptr)
    {
      continue;
    }
    if (table->GetColumnByName("Virtual") == nullptr)
    {
      return -1;
    }
    int count = 0;
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      count += table->GetValueByName(row, "Virtual").ToInt();
    }
    return count;
  }
  ADD_FAILURE() << "There is no table of slices.";
  return -1;
}
}

//----------------------------------------------------------------------------
TEST(VirtualSliceProperties, DefaultsAndRanges)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetVirtualSlices(), Filter::AUTOMATIC_VIRTUAL_SLICES);
  EXPECT_EQ(filter->GetVirtualSliceSpacing(), 0.0);
  filter->SetVirtualSlicesToOff();
  EXPECT_EQ(filter->GetVirtualSlices(), Filter::NO_VIRTUAL_SLICES);
  filter->SetVirtualSlicesToBySpacing();
  EXPECT_EQ(filter->GetVirtualSlices(), Filter::VIRTUAL_SLICES_BY_SPACING);
  filter->SetVirtualSlicesToAutomatic();
  EXPECT_EQ(filter->GetVirtualSlices(), Filter::AUTOMATIC_VIRTUAL_SLICES);
  filter->SetVirtualSlices(9);
  EXPECT_EQ(filter->GetVirtualSlices(), Filter::VIRTUAL_SLICES_BY_SPACING);
  filter->SetVirtualSlices(-9);
  EXPECT_EQ(filter->GetVirtualSlices(), Filter::AUTOMATIC_VIRTUAL_SLICES);
  EXPECT_EQ(filter->GetEndCaps(), Filter::DOME_ENDS);
  filter->SetEndCaps(9);
  EXPECT_EQ(filter->GetEndCaps(), Filter::HALF_SLICE_ENDS);
  filter->SetEndCaps(-9);
  EXPECT_EQ(filter->GetEndCaps(), Filter::DOME_ENDS);
  filter->SetVirtualSliceSpacing(-1.0);
  EXPECT_EQ(filter->GetVirtualSliceSpacing(), 0.0);
}

//----------------------------------------------------------------------------
TEST(VirtualSliceProperties, SettersChangeTheTimeAndAreAllPrinted)
{
  ExpectPropertyChanges({
    { "VirtualSlices: Off", [](Filter* f) { f->SetVirtualSlicesToOff(); } },
    { "VirtualSlices: BySpacing", [](Filter* f) { f->SetVirtualSlicesToBySpacing(); } },
    { "VirtualSlices: Automatic", [](Filter* f) { f->SetVirtualSlicesToAutomatic(); } },
    { "VirtualSliceSpacing: 0.125", [](Filter* f) { f->SetVirtualSliceSpacing(0.125); } },
    { "EndCaps: Flat", [](Filter* f) { f->SetEndCapsToFlat(); } },
    { "EndCaps: HalfSlice", [](Filter* f) { f->SetEndCapsToHalfSlice(); } },
    { "EndCaps: Dome", [](Filter* f) { f->SetEndCapsToDome(); } },
  });
}

//----------------------------------------------------------------------------
TEST(VirtualSliceProperties, SpacingThatIsNoNumberIsAnError)
{
  TorusRun run({ 0, 0, 12 },
    [](Filter* f) { f->SetVirtualSliceSpacing(std::numeric_limits<double>::quiet_NaN()); });
  EXPECT_EQ(run.Surface->GetNumberOfCells(), 0);
  ASSERT_GE(run.Errors.size(), 1u);
  EXPECT_NE(run.Errors[0].find("VirtualSliceSpacing"), std::string::npos) << run.Errors[0];
}

//----------------------------------------------------------------------------
/// One family by default has virtual slices of the others; the outputs tell them apart.
TEST(VirtualSliceProperties, OutputsTellVirtualSlicesFromRealOnes)
{
  TorusRun on({ 0, 0, 12 });
  EXPECT_TRUE(on.Errors.empty()) << on.Errors[0];
  EXPECT_GE(CountVirtual(on), 20);
  TorusRun off({ 0, 0, 12 }, [](Filter* f) { f->SetVirtualSlicesToOff(); });
  EXPECT_EQ(CountVirtual(off), -1);
  TorusRun dense({ 12, 12, 12 });
  EXPECT_EQ(CountVirtual(dense), -1);
}

//----------------------------------------------------------------------------
/// Nothing is done to an input that is dense.
TEST(VirtualSliceProperties, DenseInputIsTheSameWithAndWithout)
{
  TorusRun automatic({ 12, 12, 12 });
  TorusRun off({ 12, 12, 12 }, [](Filter* f) { f->SetVirtualSlicesToOff(); });
  const TriangleMesh a = MeshOf(automatic.Surface), b = MeshOf(off.Surface);
  EXPECT_GT(a.Triangles.size(), 0u);
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.Triangles, b.Triangles);
}

//----------------------------------------------------------------------------
/// The messages and counts are those of the input: no word about slices that nobody has drawn.
TEST(VirtualSliceProperties, ReportIsThatOfTheInput)
{
  for (const auto& count : { std::array<int, 3>{ 0, 0, 12 }, { 10, 11, 0 }, { 1, 1, 16 } })
  {
    TorusRun on(count);
    TorusRun off(count, [](Filter* f) { f->SetVirtualSlicesToOff(); });
    EXPECT_EQ(on.Errors, off.Errors);
    EXPECT_EQ(MessagesOf(on.Warnings), MessagesOf(off.Warnings));
    EXPECT_EQ(FieldValue(on.Surface, "TotalGenus"), FieldValue(off.Surface, "TotalGenus"));
    EXPECT_EQ(CheckSurface(MeshOf(on.Surface)).TotalGenus(), 1);
    EXPECT_TRUE(CheckSurface(MeshOf(on.Surface)).IsClosedManifold());
  }
}

//----------------------------------------------------------------------------
/// Finer spacings give more planes, also between dense families; a spacing of 0 is automatic.
TEST(VirtualSliceProperties, SpacingSetsTheNumberOfPlanes)
{
  const auto count = [](const std::array<int, 3>& planes, double spacing)
  {
    TorusRun run(planes,
      [spacing](Filter* f)
      {
        f->SetVirtualSlicesToBySpacing();
        f->SetVirtualSliceSpacing(spacing);
      });
    EXPECT_TRUE(run.Errors.empty()) << run.Errors[0];
    EXPECT_TRUE(CheckSurface(MeshOf(run.Surface)).IsClosedManifold());
    return CountVirtual(run);
  };
  const int coarse = count({ 0, 0, 12 }, 0.3), fine = count({ 0, 0, 12 }, 0.15);
  EXPECT_GT(coarse, 0);
  EXPECT_GT(fine, 1.5 * coarse);
  EXPECT_GT(count({ 6, 6, 6 }, 0.15), 0);
  TorusRun automatic({ 0, 0, 12 });
  EXPECT_EQ(count({ 0, 0, 12 }, 0.0), CountVirtual(automatic));
}
