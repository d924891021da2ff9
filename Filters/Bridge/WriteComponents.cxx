// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/WriteComponents.h"

#include "Bridge/AddColumn.h"
#include "Bridge/VisitTriangles.h"
#include "Core/Surface/ComponentSeeds.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkTable.h"

namespace orthoslices
{
void WriteComponentTable(vtkPolyData* surface, bool mayBeOpen, const Ranks& ranks,
  const Execution& execution, vtkTable* table)
{
  auto* ids = vtkIntArray::SafeDownCast(surface->GetCellData()->GetArray("ComponentId"));
  auto* number =
    vtkIdTypeArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray("NumberOfComponents"));
  std::vector<ComponentMeasure> measures;
  std::vector<Point3> seeds;
  VisitTriangles(surface,
    [&](const auto* xyz, const auto* triangles, vtkIdType count)
    {
      measures = MeasureComponents(xyz, triangles, count, ids->GetPointer(0),
        static_cast<int>(number->GetValue(0)), mayBeOpen, ranks);
      seeds = FindSeeds(xyz, triangles, count, ids->GetPointer(0), measures, ranks, execution);
    });
  auto* component = AddColumn<vtkIntArray>(table, "ComponentId");
  auto* area = AddColumn<vtkDoubleArray>(table, "Area");
  auto* volume = AddColumn<vtkDoubleArray>(table, "Volume");
  PointColumns centroid(table, { "CentroidX", "CentroidY", "CentroidZ" });
  auto* triangles = AddColumn<vtkIdTypeArray>(table, "Triangles");
  PointColumns seed(table, { "SeedX", "SeedY", "SeedZ" });
  for (std::size_t i = 0; i < measures.size(); ++i)
  {
    component->InsertNextValue(static_cast<int>(i));
    area->InsertNextValue(measures[i].Area);
    volume->InsertNextValue(measures[i].Volume);
    centroid.InsertNext(measures[i].Centroid);
    triangles->InsertNextValue(measures[i].Triangles);
    seed.InsertNext(seeds[i]);
  }
}
}
