// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReadSamples_h
#define OrthoSlicesReadSamples_h

#include "Bridge/ImageFrame.h"
#include "Core/Base/Execution.h"
#include "Core/Slicing/SliceLabels.h"

#include <cstddef>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkRectilinearGrid;

namespace orthoslices
{
/// The samples of an image along one axis of its frame, in ascending order.
struct SampleAxis
{
  std::vector<double> Coordinates; ///< with one sample of padding on both ends
  std::ptrdiff_t Stride = 0;       ///< from one sample to the next in the scalars

  Index Count() const { return static_cast<Index>(this->Coordinates.size()) - 2; }
  double Coordinate(Index sample) const { return this->Coordinates[sample + 1]; }
  /// The sample nearest to a coordinate; of two that are equally near, the upper one.
  Index Nearest(double coordinate) const;
};

/// An image seen along the axes of its frame, whatever the order and direction of its indices.
struct SampleGrid
{
  SampleAxis Axes[3];
  std::ptrdiff_t First = 0; ///< scalar at the lower end of all three axes
};

/// What makes a sample an inside one.
struct Region
{
  bool IsLabel;
  double Value;

  double Threshold() const { return this->IsLabel ? 0.5 : this->Value; }
  double Sample(double scalar) const
  {
    return this->IsLabel ? (scalar == this->Value ? 1.0 : 0.0) : scalar;
  }
};

/// An image's samples along the axes of its frame.
SampleGrid ReadSampleGrid(vtkImageData* image, const ImageFrame& frame);

/// Those of a rectilinear grid along x, y and z, padded by the distance of the outermost two. False if
/// coordinates along an axis do not ascend, each above the one before, or are not finite.
bool ReadSampleGrid(vtkRectilinearGrid* samples, SampleGrid& grid);

/// Rounds all coordinates to the precision of the output.
void RoundCoordinates(Precision precision, SampleGrid& grid);

/// The samples that planes move to, each once. REQUIRES: ascending planes. With `dropBeyond`,
/// planes more than half a spacing outside the image are left out.
std::vector<Index> NearestSamples(
  const SampleAxis& samples, const std::vector<double>& planes, bool dropBeyond);

/// The contours on the planes of some samples across `axis`, one entry for each of them.
std::vector<PlaneContours> SliceSamples(vtkDataArray* scalars, const SampleGrid& grid, int axis,
  const std::vector<Index>& samples, const Region& region, Precision precision,
  const Execution& execution);

/// The same for each label of the image but the background, with the label of each contour.
std::vector<LabelContours> SliceSampleLabels(vtkDataArray* scalars, const SampleGrid& grid,
  int axis, const std::vector<Index>& samples, double background, Precision precision,
  const Execution& execution);
}

#endif
