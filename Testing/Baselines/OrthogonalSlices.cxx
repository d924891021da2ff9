// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OrthogonalSlices.h"

#include "vtkNew.h"
#include "vtkOrthogonalSliceReconstruction.h"

namespace orthoslices
{
namespace baselines
{

//------------------------------------------------------------------------------
std::string OrthogonalSlices::Description() const
{
  return "vtkOrthogonalSliceReconstruction, default settings";
}

//------------------------------------------------------------------------------
std::string OneFamily::Description() const
{
  return "vtkOrthogonalSliceReconstruction, default settings, z-slices only";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> OrthogonalSlices::Reconstruct(const SliceSets& slices) const
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  filter->AutomaticAccuracyOff(); // other methods have all triangles, too
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->UsesFamilies()[axis])
    {
      filter->SetInputData(axis, slices.Families[axis]);
    }
  }
  filter->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->ShallowCopy(filter->GetOutput());
  return surface;
}

} // namespace baselines
} // namespace orthoslices
