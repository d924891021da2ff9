// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   inputs whose arrays are not laid out as usual: one component after another, or computed
 */

#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"

#include "Support/FilterRun.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkVersion.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkAffineArray.h"
#include "vtkConstantArray.h"
#endif

using namespace orthoslices::support;

namespace
{
vtkSmartPointer<vtkDataArray> AsComponents(vtkDataArray* array)
{
  vtkNew<vtkSOADataArrayTemplate<float>> copy;
  copy->DeepCopy(array);
  return copy;
}

/// Slices of a ball; the points of model and contours laid out one component after another if asked
/// for.
struct Slices
{
  std::array<vtkSmartPointer<vtkPolyData>, 3> Contours;

  Slices(bool components, vtkDataArray* pointData)
  {
    vtkNew<vtkSphereSource> source;
    source->Update();
    vtkNew<vtkPolyData> model;
    model->ShallowCopy(source->GetOutput());
    model->GetPointData()->Initialize();
    if (pointData)
    {
      pointData->SetName("Carried");
      model->GetPointData()->AddArray(pointData);
    }
    Lay(model, components);
    vtkNew<vtkOrthogonalSlicer> slicer;
    slicer->SetInputData(model);
    slicer->SetNumberOfSlices(7, 7, 7);
    slicer->Update();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Contours[axis] = vtkSmartPointer<vtkPolyData>::New();
      this->Contours[axis]->ShallowCopy(slicer->GetOutput(axis));
      Lay(this->Contours[axis], components);
    }
  }

  static void Lay(vtkPolyData* data, bool components)
  {
    if (components)
    {
      vtkNew<vtkPoints> points;
      points->SetData(AsComponents(data->GetPoints()->GetData()));
      data->SetPoints(points);
    }
  }

  vtkPolyData* Reconstruct(FilterRun& run) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      run.Filter->SetInputData(axis, this->Contours[axis]);
    }
    vtkPolyData* surface = run.Update();
    EXPECT_TRUE(run.Errors.empty());
    EXPECT_TRUE(run.Warnings.empty());
    EXPECT_GT(surface->GetNumberOfCells(), 0);
    return surface;
  }
};

void ExpectEqual(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_NE(a, nullptr);
  ASSERT_NE(b, nullptr);
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < a->GetNumberOfComponents(); ++k)
    {
      ASSERT_EQ(a->GetComponent(i, k), b->GetComponent(i, k)) << "tuple " << i;
    }
  }
}
}

//----------------------------------------------------------------------------
TEST(ImplicitArrays, PointsMayBeLaidOutByComponent)
{
  const Slices usual(false, nullptr), components(true, nullptr);
  FilterRun a, b;
  ExpectEqual(usual.Reconstruct(a)->GetPoints()->GetData(),
    components.Reconstruct(b)->GetPoints()->GetData());
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
namespace
{
/// What a computed array says, written down.
vtkSmartPointer<vtkDataArray> AsArray(vtkDataArray* array)
{
  vtkSmartPointer<vtkDataArray> copy =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_FLOAT));
  copy->DeepCopy(array);
  copy->SetName(array->GetName());
  return copy;
}
}

//----------------------------------------------------------------------------
TEST(ImplicitArrays, PointDataOfTheSlicerMayBeComputed)
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  vtkNew<vtkAffineArray<float>> computed;
  computed->SetBackend(std::make_shared<vtkAffineImplicitBackend<float>>(0.5f, 3.0f));
  computed->SetNumberOfTuples(source->GetOutput()->GetNumberOfPoints());
  computed->SetName("Carried");
  const Slices usual(false, AsArray(computed)), implicit(false, computed);
  for (int axis = 0; axis < 3; ++axis)
  {
    ExpectEqual(usual.Contours[axis]->GetPointData()->GetArray("Carried"),
      implicit.Contours[axis]->GetPointData()->GetArray("Carried"));
  }
}

//----------------------------------------------------------------------------
TEST(ImplicitArrays, LabelsAndCarriedArraysMayBeComputed)
{
  const Slices usual(false, nullptr), implicit(false, nullptr);
  FilterRun a, b;
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkIdType cells = usual.Contours[axis]->GetNumberOfCells();
    vtkNew<vtkConstantArray<float>> label;
    label->ConstructBackend(4.0f);
    label->SetNumberOfTuples(cells);
    label->SetName("Organ");
    vtkNew<vtkAffineArray<float>> carried;
    carried->SetBackend(std::make_shared<vtkAffineImplicitBackend<float>>(2.0f, 1.0f));
    carried->SetNumberOfTuples(cells);
    carried->SetName("Carried");
    for (vtkDataArray* array :
      { static_cast<vtkDataArray*>(label), static_cast<vtkDataArray*>(carried) })
    {
      implicit.Contours[axis]->GetCellData()->AddArray(array);
      usual.Contours[axis]->GetCellData()->AddArray(AsArray(array));
    }
  }
  a.Filter->SetLabelArray("Organ");
  b.Filter->SetLabelArray("Organ");
  vtkPolyData* of[2] = { usual.Reconstruct(a), implicit.Reconstruct(b) };
  ExpectEqual(of[0]->GetPoints()->GetData(), of[1]->GetPoints()->GetData());
  for (const char* name : { "Label", "Carried" })
  {
    SCOPED_TRACE(name);
    ExpectEqual(of[0]->GetCellData()->GetArray(name), of[1]->GetCellData()->GetArray(name));
  }
}
#endif
