// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Data objects one after another in one. Arrays that only some of the parts have are kept, and are
 * 0 or empty for the others.
 */

#ifndef OrthoSlicesAppendData_h
#define OrthoSlicesAppendData_h

#include <vector>

class vtkPolyData;
class vtkTable;

namespace orthoslices
{
/// Points, vertices, lines and polygons, with their arrays; no field data. Cells come in the order
/// of VTK: the vertices of all parts, then the lines of all parts, then the polygons.
void AppendPolyData(const std::vector<vtkPolyData*>& parts, vtkPolyData* whole);

/// Rows. Columns come in the order of the first part that has them.
void AppendTables(const std::vector<vtkTable*>& parts, vtkTable* whole);
}

#endif
