// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesReadSlices_h
#define OrthoSlicesReadSlices_h

#include "Core/Pass.h"

#include <array>

namespace orthoslices
{
/// From pieces of polylines to closed contours on the planes of the spatial grid, with the interior
/// on their left (the paper's sections 3 and 4), without noise if that is asked for. False if the
/// input is refused, or if the run was stopped.
bool ReadSlices(std::array<Pieces, 3>&& pieces, Pass& pass);
}

#endif
