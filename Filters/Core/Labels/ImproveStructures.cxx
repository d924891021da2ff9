// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/ImproveStructures.h"

#include "Core/Labels/CommonSheets.h"

#include <cmath>

namespace orthoslices
{
namespace
{
/// The part of the tolerance for each side, where two labels meet on the outside: what they leave
/// between them adds up. With three quarters, three thin layers have .346 % of their volume there, with
/// that part .333, and .289 with all triangles.
constexpr double ShareOfSide = 0.7;

/// Where contours keep their vertices, triangles are nearly as many as they can be: with more splits,
/// eight nested labels from one stack would have more than all.
constexpr double GrowthOfKept = 0.093;
}

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
  own.Divides = false; // new triangles go where they are needed most, wherever that is
  if (keepContours)
  {
    own.Growth = GrowthOfKept;
  }
  else
  {
    own.Tolerance *= ShareOfSide;
  }
  ImprovableMesh mesh = sheets.MakeMesh();
  SpatialGrid grid = structures.front().Geometry.Grid;
  grid.Lowest.fill(-HUGE_VAL); // each structure has bounds of its own, which are rooms of the mesh
  grid.Highest.fill(HUGE_VAL);
  MeshImprover(grid, own, execution, mesh).Run();
  sheets.SetImproved(mesh);
}
}
