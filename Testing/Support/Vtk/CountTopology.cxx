// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Vtk/CountTopology.h"

#include "Support/Vtk/SurfaceMetrics.h"

#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace orthoslices
{
namespace support
{
namespace
{
vtkSmartPointer<vtkImageData> SampleValues(const Solid& solid, int cells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(solid.Low.data());
  image->SetSpacing((solid.High[0] - solid.Low[0]) / cells, (solid.High[1] - solid.Low[1]) / cells,
    (solid.High[2] - solid.Low[2]) / cells);
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    image->GetPoint(i, p.data());
    values->SetValue(i, solid.Value(p));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

Topology CountAtValue(vtkImageData* image, double value)
{
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData(image);
  surface->SetValue(0, value);
  surface->ComputeNormalsOff();
  surface->Update();
  return MeasureTopology(surface->GetOutput());
}
}

std::optional<CountedTopology> CountTopology(const Solid& solid, double clearance)
{
  const double size = solid.High[0] - solid.Low[0];
  const auto image = SampleValues(solid, static_cast<int>(size / (0.8 * clearance)));
  const Topology exact = CountAtValue(image, 0.0);
  for (const double value : { -clearance, clearance })
  {
    const Topology other = CountAtValue(image, value);
    if (!exact.Genus || other.Components != exact.Components || other.Genus != exact.Genus)
    {
      return std::nullopt;
    }
  }
  return CountedTopology{ exact.Components, *exact.Genus };
}

} // namespace support
} // namespace orthoslices
