// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   runs vtkOrthogonalSliceReconstruction as a user does and listens to what it says
 */

#ifndef OrthoSlicesFilterRun_h
#define OrthoSlicesFilterRun_h

#include "Support/TextContours.h"

#include "vtkNew.h"
#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace orthoslices
{
namespace support
{

/// The forms in which users have contours.
enum class Form
{
  ClosedLine,    ///< polyline whose last point id is its first
  RepeatedPoint, ///< polyline whose last point lies where its first does
  OpenLine,      ///< polyline without the closing segment
  Polygon,
  Segments,      ///< two-point lines in order, with common points
  LooseSegments, ///< two-point lines in random order and direction, each with points of its own
  Mixture        ///< every contour in another of these forms
};

/// Pieces as polydata with points of VTK_FLOAT or VTK_DOUBLE; open pieces remain open lines.
vtkSmartPointer<vtkPolyData> MakePolyData(
  const Pieces& pieces, Form form = Form::ClosedLine, int type = VTK_DOUBLE);

/// A filter with three inputs, and all errors and warnings of it and its executive.
class FilterRun
{
public:
  FilterRun();
  explicit FilterRun(const PieceSets& sets, Form form = Form::ClosedLine, int type = VTK_DOUBLE);

  void SetInputs(const PieceSets& sets, Form form = Form::ClosedLine, int type = VTK_DOUBLE);

  /// Forgets former messages and updates; the surface.
  vtkPolyData* Update();

  vtkNew<vtkOrthogonalSliceReconstruction> Filter;
  std::vector<std::string> Errors, Warnings;
};

/// One value of the surface's field data; -1 if there is none.
vtkIdType FieldValue(vtkPolyData* surface, const char* name);

} // namespace support
} // namespace orthoslices

#endif
