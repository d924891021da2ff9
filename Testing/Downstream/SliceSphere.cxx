// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
// What another project does with the library: slices a sphere and makes a surface of the slices.
#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);

  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputConnection(sphere->GetOutputPort());
  slicer->SetNumberOfSlices(8, 8, 8);

  vtkNew<vtkOrthogonalSliceReconstruction> reconstruction;
  for (int axis = 0; axis < 3; ++axis)
  {
    reconstruction->SetInputConnection(axis, slicer->GetOutputPort(axis));
  }
  reconstruction->Update();

  const vtkIdType triangles = reconstruction->GetOutput()->GetNumberOfPolys();
  std::cout << triangles << " triangles\n";
  return triangles > 0 ? 0 : 1;
}
