// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSnapPlanes_h
#define OrthoSlicesSnapPlanes_h

#include "Core/Base/Contours.h"
#include "Core/Frames/FindFamilies.h"

#include <vector>

namespace orthoslices
{
/**
 * Gives the contours of one plane one coordinate, after they were turned. A plane lies at the mean
 * of all points of its contours; contours are on one plane if theirs differ by less than noise.
 * Vertices that are farther off than that stay where they are. The cells of the pieces are the
 * numbers of the polylines in the groups.
 */
void SnapPlanes(const std::vector<PieceGroup>& groups, const Point3& normal,
  const PlaneNoise& noise, Pieces& pieces);
}

#endif
