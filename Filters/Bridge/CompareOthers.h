// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours on planes of no family, which are no slices: how far the surface is from them
 */

#ifndef OrthoSlicesCompareOthers_h
#define OrthoSlicesCompareOthers_h

#include "Core/Base/Polylines.h"
#include "Core/Crossings/MeasureAgreement.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;

namespace orthoslices
{
/// The distances of the points of each polyline from the nearest triangle; of no points if there
/// are no triangles.
std::vector<Agreement> MeasureDistances(const Polylines& lines, vtkPolyData* surface);

/// Appends a row for each polyline to the table of contours.
void WriteOthers(const Polylines& lines, const std::vector<Agreement>& distances, vtkTable* table);

/// What the user should be told of them; empty if there are none. `guiding` says of each whether
/// the surface was bent through contours of its plane (Reconstruction::Guiding).
std::string DescribeOthers(const Polylines& lines, const std::vector<Agreement>& distances,
  const std::vector<std::uint8_t>& guiding);
}

#endif
