// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesWriteComponents_h
#define OrthoSlicesWriteComponents_h

class vtkPolyData;
class vtkTable;

namespace orthoslices
{
/// Port 7: area, volume, centroid and seed of each component of the finished surface, which is closed
/// unless it `mayBeOpen`.
/// REQUIRES: cell data "ComponentId" and field data "NumberOfComponents".
void WriteComponentTable(vtkPolyData* surface, bool mayBeOpen, vtkTable* table);
}

#endif
