// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchMesh.h"

#include "Predicates.h"

#include <algorithm>

namespace orthoslices
{
std::vector<Index> CycleGeometry::GetBorders(const std::vector<Index>& cycles) const
{
  std::vector<Index> borders, border, places;
  for (const Index cycle : cycles)
  {
    this->GetBoundary(cycle, border, places);
    borders.insert(borders.end(), border.begin(), border.end());
  }
  return borders;
}

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

PatchTriangle::PatchTriangle(
  Index patch, const std::array<Point3, 3>& corners, const std::array<Index, 3>& ids)
  : Patch(patch)
  , Corners(corners)
  , Ids(ids)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto range = std::minmax({ corners[0][i], corners[1][i], corners[2][i] });
    this->Low[i] = range.first;
    this->High[i] = range.second;
  }
}

namespace
{
/// Whether two triangles certainly meet in their common corners only.
bool AreCompatible(const PatchTriangle& a, const PatchTriangle& b)
{
  if (!a.BoxMeets(b, 1) || !a.BoxMeets(b, 2))
  {
    return true;
  }
  std::vector<int> commonOfA, commonOfB;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (a.Ids[i] == b.Ids[j])
      {
        commonOfA.push_back(i);
        commonOfB.push_back(j);
      }
    }
  }
  return commonOfA.empty() ? CertainlyApart(a.Corners, b.Corners)
                           : CertainlyApartBeyond(commonOfA, a.Corners, commonOfB, b.Corners);
}

}

std::vector<std::pair<Index, Index>> FindContacts(
  std::vector<PatchTriangle>& triangles, const std::vector<PatchShape>& shapes)
{
  std::vector<std::uint8_t> touches(shapes.size(), 0); // fans and shells
  const auto isKnown = [&](Index a, Index b)
  { return a == b ? shapes[a] == PatchShape::Fan : touches[a] != 0 && touches[b] != 0; };
  std::sort(triangles.begin(), triangles.end(),
    [](const PatchTriangle& a, const PatchTriangle& b) { return a.Low[0] < b.Low[0]; });
  std::vector<std::pair<Index, Index>> contacts;
  for (auto a = triangles.begin(); a != triangles.end(); ++a)
  {
    for (auto b = a + 1; b != triangles.end() && b->Low[0] <= a->High[0]; ++b)
    {
      const std::pair<Index, Index> pair = std::minmax(a->Patch, b->Patch);
      const bool known =
        isKnown(pair.first, pair.second) || (!contacts.empty() && contacts.back() == pair);
      if (!known && !AreCompatible(*a, *b))
      {
        contacts.push_back(pair);
        touches[pair.first] = shapes[pair.first] != PatchShape::Joined;
        touches[pair.second] = shapes[pair.second] != PatchShape::Joined;
      }
    }
  }
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  return contacts;
}
}
