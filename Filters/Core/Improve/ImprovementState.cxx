// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImprovementState.h"

namespace orthoslices
{
ImprovementState::ImprovementState(
  const SpatialGrid& grid, const ImprovementLimits& limits, ImprovableMesh& mesh)
  : Grid(grid)
  , Mesh(mesh)
  , Kept(limits.Kept)
  , Boxes(BoxesOf(mesh.Corners, mesh.Points))
  , Samples(mesh, limits)
{
  const Index count = mesh.Corners.CornerCount() / 3;
  this->Qualities.reserve(count);
  for (Index triangle = 0; triangle < count; ++triangle)
  {
    this->Qualities.push_back(SquaredSine(this->PlacesOf(triangle)));
  }
}
}
