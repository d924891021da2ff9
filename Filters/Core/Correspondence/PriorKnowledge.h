// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPriorKnowledge_h
#define OrthoSlicesPriorKnowledge_h

#include "Core/Base/Types.h"

namespace orthoslices
{
/// What is known of the surface before any contour is looked at.
struct PriorKnowledge
{
  Index Components = 0; ///< 0: not known
  Index Genus = -1;     ///< sum over all components; -1: not known
};
}

#endif
