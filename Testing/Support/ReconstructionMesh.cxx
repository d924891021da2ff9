// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/ReconstructionMesh.h"

namespace orthoslices
{
namespace support
{

TriangleMesh MeshOf(const Reconstruction& result)
{
  TriangleMesh mesh;
  const std::vector<double> others = ListOtherPoints(result.Surface);
  const std::vector<double> none;
  const ImprovedTriangles& improved = result.Surface.Improved;
  for (const auto* xyz : { improved.Any() ? &improved.Points : &result.Graph.Points,
         improved.Any() ? &none : &result.Surface.CentralPoints, improved.Any() ? &none : &others })
  {
    for (std::size_t i = 0; i < xyz->size(); i += 3)
    {
      mesh.Points.push_back({ (*xyz)[i], (*xyz)[i + 1], (*xyz)[i + 2] });
    }
  }
  if (result.Cycles.Count() == 0)
  {
    return mesh;
  }
  std::vector<std::int32_t> ids(3 * static_cast<std::size_t>(result.Surface.TriangleCount()), -1);
  WriteTriangles(result.Surface, GeometryOf(result), Execution(), ids.data());
  for (std::size_t i = 0; i < ids.size(); i += 3)
  {
    mesh.Triangles.push_back({ ids[i], ids[i + 1], ids[i + 2] });
  }
  return mesh;
}

} // namespace support
} // namespace orthoslices
