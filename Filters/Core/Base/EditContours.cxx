// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/EditContours.h"

#include <utility>

namespace orthoslices
{
void RemoveMarked(const std::vector<std::uint8_t>& marked, Contours& contours)
{
  Contours kept;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    if (marked[i])
    {
      continue;
    }
    const Index begin = contours.Offsets[i];
    const Index end = contours.Offsets[i + 1];
    kept.U.insert(kept.U.end(), contours.U.begin() + begin, contours.U.begin() + end);
    kept.V.insert(kept.V.end(), contours.V.begin() + begin, contours.V.begin() + end);
    kept.Offsets.push_back(static_cast<Index>(kept.U.size()));
    kept.Axis.push_back(contours.Axis[i]);
    kept.Coordinate.push_back(contours.Coordinate[i]);
    kept.Plane.push_back(contours.Plane[i]);
    kept.Cell.push_back(contours.Cell[i]);
    if (!contours.Virtual.empty())
    {
      kept.Virtual.push_back(contours.Virtual[i]);
    }
  }
  contours = std::move(kept);
}

void AppendContours(const Contours& added, Contours& contours)
{
  const Index first = contours.Offsets.back();
  const auto append = [](const auto& from, auto& to)
  { to.insert(to.end(), from.begin(), from.end()); };
  append(added.U, contours.U);
  append(added.V, contours.V);
  append(added.Axis, contours.Axis);
  append(added.Coordinate, contours.Coordinate);
  append(added.Plane, contours.Plane);
  append(added.Cell, contours.Cell);
  for (Index i = 0; i < added.Count(); ++i)
  {
    contours.Offsets.push_back(first + added.Offsets[i + 1]);
  }
  if (!contours.Virtual.empty())
  {
    contours.Virtual.resize(contours.Axis.size(), 0);
  }
}

Box3 BoxOf(const Contours& contours, bool withVirtual)
{
  Box3 box;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    if (!withVirtual && contours.IsVirtual(i))
    {
      continue;
    }
    const int axis = contours.Axis[i];
    box.Add(axis, contours.Coordinate[i]);
    for (Index v = contours.Offsets[i]; v < contours.Offsets[i + 1]; ++v)
    {
      box.Add(FirstAxis(axis), contours.U[v]);
      box.Add(SecondAxis(axis), contours.V[v]);
    }
  }
  return box;
}
}
