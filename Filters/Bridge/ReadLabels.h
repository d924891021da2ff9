// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReadLabels_h
#define OrthoSlicesReadLabels_h

#include "Core/Base/Polylines.h"

#include "vtkAbstractArray.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace orthoslices
{
/// Which structure each contour belongs to.
struct ContourLabels
{
  /// The labels that occur, each once, ascending: numbers of the type of the input's arrays (double
  /// if the inputs have several types), or names, if any input has names. Null if no input has the
  /// array.
  vtkSmartPointer<vtkAbstractArray> Values;
  std::vector<Index> OfLine; ///< for each polyline a number of a label, or NoLabel
  Index Unlabelled = 0;      ///< polylines without a label

  Index Count() const
  {
    return this->Values == nullptr ? 0 : static_cast<Index>(this->Values->GetNumberOfTuples());
  }
  bool AreNames() const;
  /// A label as text.
  std::string NameOf(Index label) const;
};

/**
 * The labels of polylines that were read from the inputs of all ports, by the cell array with that
 * name; of several components the first counts. Without a label is a contour of an input that lacks
 * the array, a number that is not finite, and an empty name. 0 is a label like any other.
 */
ContourLabels ReadLabels(const std::vector<vtkDataObject*>& inputs, const std::string& arrayName,
  const PolylineSources& from);
}

#endif
