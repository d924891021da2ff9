// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDescribeInputs_h
#define OrthoSlicesDescribeInputs_h

#include <string>
#include <vector>

class vtkDataObject;

namespace orthoslices
{
struct SortedSlices;

/**
 * Sentences for the user about inputs that can hardly be meant, one line for each, given those of
 * all ports: points without lines and polygons, and surfaces of models where contours should be.
 * Empty if there are none, and for inputs that are empty: these are families without slices.
 */
std::string DescribeInputs(const std::vector<vtkDataObject*>& inputs);

/**
 * A line for the user if nothing but the x-slices (port 0) has contours, and all of these, sorted by
 * their planes, are slices of one family: the others may have been forgotten. Else empty.
 */
std::string DescribeMissingFamilies(
  const std::vector<vtkDataObject*>& inputs, const SortedSlices& sorted);
}

#endif
