// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLightenStructures_h
#define OrthoSlicesLightenStructures_h

#include "Core/Base/Execution.h"
#include "Core/Patches/LightenArcs.h"

#include <vector>

namespace orthoslices
{
/**
 * LightenArcs for several structures at once: what arcs of structures have in common is drawn once,
 * and stays common to the last bit. Arcs are divided where contours of structures meet or part;
 * these vertices stay, as do node points at which not all structures have the same arcs. Where arcs
 * of any two structures would meet that did not, both keep all vertices. `accuracy` is that of
 * LightenArcs. REQUIRES: structures have the same planes around their cells.
 */
std::vector<LightGraph> LightenStructures(
  const std::vector<ArcSurface>& structures, double accuracy, const Execution& execution);
}

#endif
