// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesChooseAxes_h
#define OrthoSlicesChooseAxes_h

#include "Core/Base/AxisFrame.h"
#include "Core/Frames/FindFamilies.h"

#include <vector>

namespace orthoslices
{
/// The axes of up to three families of planes.
struct FamilyAxes
{
  AxisFrame Frame;
  std::array<bool, 3> HasFamily{ false, false, false };
};

/**
 * Which family is x, y and z, and where its axis points.
 *
 * Families take the axes of the world that are nearest to their normals. If a normal is more than
 * 40 degrees from its axis, these say little: then the families are those of the ports that they
 * came through, if each came through one of its own, 0 for x, 1 for y and 2 for z. Each axis points
 * the way of the world's; where it is nearly at right angles to that, the way of its largest
 * coordinate; one of them the other way if they would be left-handed else.
 *
 * A missing axis is at right angles to the others, of a single family as near to those of the world
 * as can be. Axes of families that are orthogonal as far as the noise lets one see are orthogonal.
 */
FamilyAxes ChooseAxes(const std::vector<PlaneFamily>& families, const PlaneNoise& noise);
}

#endif
