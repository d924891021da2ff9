// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/CutAtBorder.h"

#include "Support/CheckSurface.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

//----------------------------------------------------------------------------
/// A saddle whose middle lies on the border: what remains are two parts, each with a middle of its
/// own.
TEST(CutAtBorder, PartsThatTouchInAPointOfTheBorderHaveNoPointInCommon)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  constexpr int around = 8;
  for (int i = 0; i < around; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * (i + 0.5) / around;
    points->InsertNextPoint(std::cos(angle), std::sin(angle), std::cos(2.0 * angle));
  }
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i < around; ++i)
  {
    const vtkIdType corners[3] = { 0, 1 + i, 1 + (i + 1) % around };
    triangles->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  Box3 border = Everywhere();
  border.High[2] = 0.0;
  CutAtBorder(border, AxisFrame(), surface);
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  EXPECT_EQ(check.Components, 2);
  EXPECT_EQ(check.UnusedPoints, 0);
  EXPECT_EQ(surface->GetNumberOfCells(), 6);
  EXPECT_EQ(surface->GetNumberOfPoints(), 10);
}
