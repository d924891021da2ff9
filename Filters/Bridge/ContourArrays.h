// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesContourArrays_h
#define OrthoSlicesContourArrays_h

#include "Core/Base/Polylines.h"

#include "vtkAbstractArray.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace orthoslices
{
/// A cell array of the contours, with its values for polylines that were read from several inputs.
struct ContourArray
{
  std::string Name;
  /// A tuple for each polyline; then the one that stands for no value: NaN in arrays of floating
  /// point numbers, 0 in those of integers, an empty text.
  vtkSmartPointer<vtkAbstractArray> Values;
  std::vector<std::uint8_t> Has; ///< whether the input of each polyline has the array

  vtkIdType Null() const { return this->Values->GetNumberOfTuples() - 1; }
};

/**
 * The cell arrays of all inputs, each name once, in the order of the inputs. Arrays of one name
 * become one: of their type, of double if they have several types of numbers. Left out are ghost
 * markers, arrays without a name, and those of one name that have different numbers of components,
 * or text in one input and numbers in another.
 */
std::vector<ContourArray> ReadContourArrays(
  const std::vector<vtkDataObject*>& inputs, const PolylineSources& from);
}

#endif
