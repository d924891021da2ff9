// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/EditContours.h"

#include <algorithm>
#include <numeric>
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

std::vector<Contours*> PointersTo(std::vector<Contours>& structures)
{
  std::vector<Contours*> pointers;
  for (Contours& contours : structures)
  {
    pointers.push_back(&contours);
  }
  return pointers;
}

std::vector<std::vector<Index>> GroupBySlice(const Contours& contours)
{
  std::vector<Index> order(contours.Count());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](Index i) { return std::make_pair(contours.Axis[i], contours.Plane[i]); };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  std::vector<std::vector<Index>> slices;
  for (const Index i : order)
  {
    if (slices.empty() || key(slices.back().front()) != key(i))
    {
      slices.emplace_back();
    }
    slices.back().push_back(i);
  }
  return slices;
}

double TwiceSignedArea(const Contours& contours, Index contour)
{
  const Index begin = contours.Offsets[contour];
  const Index end = contours.Offsets[contour + 1];
  const double u0 = contours.U[begin];
  const double v0 = contours.V[begin];
  double area = 0.0;
  for (Index i = begin + 1; i + 1 < end; ++i)
  {
    area += (contours.U[i] - u0) * (contours.V[i + 1] - v0) -
      (contours.U[i + 1] - u0) * (contours.V[i] - v0);
  }
  return area;
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
