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

LabelMesh MeshOf(const LabelSurfaces& surfaces)
{
  LabelMesh all;
  for (std::size_t label = 0; label < surfaces.OfLabel.size(); ++label)
  {
    const TriangleMesh mesh = MeshOf(surfaces.OfLabel[label]);
    const Index first = static_cast<Index>(all.Mesh.Points.size());
    all.Mesh.Points.insert(all.Mesh.Points.end(), mesh.Points.begin(), mesh.Points.end());
    for (const auto& t : mesh.Triangles)
    {
      all.Mesh.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
    all.Labels.resize(all.Mesh.Triangles.size(), static_cast<int>(label));
  }
  return all;
}

} // namespace support
} // namespace orthoslices
