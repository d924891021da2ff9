// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   columns of tables that are filled row by row
 */

#ifndef OrthoSlicesAddColumn_h
#define OrthoSlicesAddColumn_h

#include "Core/Base/Types.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

namespace orthoslices
{
/// An empty column of this type at the end of the table, which owns it.
template <typename Array>
Array* AddColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}

/// Three columns with the coordinates of points.
class PointColumns
{
public:
  PointColumns(vtkTable* table, const std::array<const char*, 3>& names)
    : Columns{ AddColumn<vtkDoubleArray>(table, names[0]),
      AddColumn<vtkDoubleArray>(table, names[1]), AddColumn<vtkDoubleArray>(table, names[2]) }
  {
  }

  void InsertNext(const Point3& point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Columns[axis]->InsertNextValue(point[axis]);
    }
  }

private:
  std::array<vtkDoubleArray*, 3> Columns;
};
}

#endif
