// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   columns of tables that are filled row by row
 */

#ifndef OrthoSlicesAddColumn_h
#define OrthoSlicesAddColumn_h

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
}

#endif
