// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ImproveStructures.h"

#include "Core/Labels/CommonSheets.h"

#include <cmath>

namespace orthoslices
{
void ImproveStructures(const std::vector<StructureSurface>& structures,
  const ImprovementLimits& limits, bool keepContours, const Execution& execution)
{
  const CommonSheets sheets(structures, keepContours, execution);
  if (structures.empty() || !sheets.AreFound())
  {
    return;
  }
  ImprovementLimits own = limits;
  own.Kept = sheets.CountKept();
  ImprovableMesh mesh = sheets.MakeMesh();
  SpatialGrid grid = structures.front().Geometry.Grid;
  grid.Lowest.fill(-HUGE_VAL); // each structure has bounds of its own, which are rooms of the mesh
  grid.Highest.fill(HUGE_VAL);
  MeshImprover(grid, own, execution, mesh).Run();
  sheets.SetImproved(mesh);
}
}
