// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/PatchMesh.h"

#include <algorithm>

namespace orthoslices
{
Index EulerCharacteristic(const PatchMesh& mesh)
{
  std::vector<Index> corners;
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& triangle : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      corners.push_back(triangle[i]);
      edges.push_back(std::minmax(triangle[i], triangle[(i + 1) % 3]));
    }
  }
  const auto countDistinct = [](auto& list)
  {
    std::sort(list.begin(), list.end());
    return static_cast<Index>(std::unique(list.begin(), list.end()) - list.begin());
  };
  return countDistinct(corners) - countDistinct(edges) + static_cast<Index>(mesh.Triangles.size());
}
}
