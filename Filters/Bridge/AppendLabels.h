// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesAppendLabels_h
#define OrthoSlicesAppendLabels_h

#include "Bridge/ReadLabels.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkInformationVector;

namespace orthoslices
{
/**
 * The outputs of vtkOrthogonalSliceReconstruction for several labels, one after another in one set
 * of outputs:
 *  - surface and graph have the cell data "Label": numbers of the type of the input's array, or for
 *    names their number (int) in the field data "LabelNames" of the surface;
 *  - tables have "Label" for their first column: the number or the name;
 *  - components are numbered on from label to label;
 *  - field data of the surface that count are summed up, measures of triangles are those of all;
 *    and there are "LabelNames" (of all labels, also as numbers), "LabelArea" and "LabelVolume".
 */
class LabelOutputs
{
public:
  LabelOutputs(const ContourLabels& labels, vtkInformationVector* outputs);

  /// Empty outputs for one label, to be filled before the next call.
  vtkInformationVector* Next(Index label);

  /// Moves everything to the outputs of the filter.
  void Finish();

private:
  struct Part
  {
    Index Label;
    vtkSmartPointer<vtkInformationVector> Outputs;
  };

  void NumberComponents();
  void AddLabels(const Part& part);
  void AppendPort(int port);
  void AppendFieldData();
  void AddLabelSums();

  const ContourLabels& Labels;
  vtkInformationVector* Outputs;
  std::vector<Part> Parts;
};
}

#endif
