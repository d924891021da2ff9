// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCarryArrays_h
#define OrthoSlicesCarryArrays_h

#include "Bridge/ContourArrays.h"
#include "Core/Base/Execution.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkCellData;
class vtkDataObject;

namespace orthoslices
{
struct Reconstruction;

/**
 * Carries the cell arrays of the contours to the graph and to the surface. An array with the name
 * of one that these have of their own gets "Input" before its name.
 *
 * Arcs and isolated contours have the values of their contours; node points, repairs and what was
 * added have none. A triangle has those of one contour beside its patch, see FindPatchSources;
 * which, is chosen for each array among the contours that have it. The arrays "PlaneIndex" and
 * "PlaneCoordinate", which vtkOrthogonalSlicer writes, say nothing of a surface and stay off it.
 */
class ArrayCarrier
{
public:
  /// `ownName` is the name of one more array of their own; empty if there is none.
  /// REQUIRES: ReconstructSorted made the result, from what ReadPieces reads of the inputs of all
  /// ports.
  ArrayCarrier(const std::vector<vtkDataObject*>& inputs, const Reconstruction& result,
    const std::string& ownName = std::string());

  /// Chooses the contour of each patch. To be called before the result is consumed.
  void ChooseContours(const Reconstruction& result, const Execution& execution);

  /// For the cells as WriteGraph writes them.
  void AddToGraph(const Reconstruction& result, vtkCellData* graph) const;

  /// For the triangles as WriteSurface writes them. REQUIRES: ChooseContours.
  void AddToSurface(vtkCellData* surface) const;

private:
  std::vector<ContourArray> Arrays;
  std::vector<std::vector<std::int64_t>> OfPatch; ///< the polyline of each patch, for each choice
  std::vector<std::size_t> Choice;                ///< of each array, or NotOnSurface
  std::vector<std::int64_t> FirstTriangles;       ///< of each patch, and the end
};
}

#endif
