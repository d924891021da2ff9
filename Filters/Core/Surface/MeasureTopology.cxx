// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/MeasureTopology.h"

#include "Core/Base/DisjointSets.h"

namespace orthoslices
{
SurfaceComponents MeasureTopology(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& meshes)
{
  DisjointSets parts = ConnectArcs(geometry.Crossings, geometry.Nodes, geometry.Graph);
  // Two arcs leave each node, and the inside of a disc counts one.
  Index euler = geometry.Cycles.Count() - geometry.Graph.Nodes;
  for (const PatchMesh& mesh : meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      parts.Unite(geometry.PartOf(mesh.Cycles.front()), geometry.PartOf(cycle));
    }
    euler += EulerCharacteristic(mesh) - static_cast<Index>(mesh.Cycles.size());
  }
  SurfaceComponents components;
  Index& count = components.Topology.Components;
  components.OfPart.resize(geometry.Graph.Nodes + geometry.Graph.Loops.size());
  for (Index i = 0; i < static_cast<Index>(components.OfPart.size()); ++i)
  {
    const Index root = parts.Find(i);
    components.OfPart[i] = root == i ? count++ : components.OfPart[root];
  }
  components.Topology.Genus = count - euler / 2;
  return components;
}
}
