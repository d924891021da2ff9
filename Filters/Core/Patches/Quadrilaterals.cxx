// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/Quadrilaterals.h"

namespace orthoslices
{
void SplitIntoQuadrilaterals(Index borderSize, const std::vector<Index>& nodePlaces,
  std::vector<Quadrilateral>& quadrilaterals)
{
  const std::size_t count = nodePlaces.size();
  quadrilaterals.resize(count);
  if (count == 0)
  {
    quadrilaterals.push_back({ 0, borderSize });
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t next = i + 1 < count ? i + 1 : 0;
    const Index end = nodePlaces[next] + (next == 0 ? borderSize : 0);
    const Index middle = nodePlaces[i] + (end - nodePlaces[i] + 1) / 2;
    quadrilaterals[i].Last = middle;
    quadrilaterals[next].First = middle - (next == 0 ? borderSize : 0);
  }
}
}
