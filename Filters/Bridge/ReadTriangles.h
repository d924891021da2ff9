// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReadTriangles_h
#define OrthoSlicesReadTriangles_h

#include "Core/Slicing/SliceSurface.h"

#include "vtkSmartPointer.h"

#include <array>

class vtkDataSet;
class vtkPolyData;

namespace orthoslices
{
/// A surface as it is; of a mesh of solid cells the faces that only one cell has.
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataSet* input);

/// Points and triangles of a surface; polygons and strips are triangulated, vertices and lines left
/// out. Points keep their numbers, used or not. REQUIRES: numbers of points that fit into Index.
TriangleSurface ReadTriangles(vtkPolyData* input);

/// The range of the triangles along an axis; empty (greatest, lowest) without triangles.
std::array<double, 2> BoundsOf(const TriangleSurface& surface, int axis);
}

#endif
