// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/SharedPatches.h"

#include <algorithm>
#include <cstring>

namespace orthoslices
{
namespace
{
/// Whether a border that starts at its least point runs towards the greater one of its neighbours.
bool IsReversed(const PatchBorder& border) { return border.Places.back() < border.Places[1]; }

/// The points from the least one towards the lesser one of its neighbours.
std::vector<Point3> Canonical(const PatchBorder& border)
{
  std::vector<Point3> places = border.Places;
  if (IsReversed(border))
  {
    std::reverse(places.begin() + 1, places.end());
  }
  return places;
}

/// FNV-1a over the bits of all coordinates; + 0.0 makes one zero of the two.
std::uint64_t HashOf(const std::vector<Point3>& border)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Point3& point : border)
  {
    for (const double x : point)
    {
      const double value = x + 0.0;
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ (bits >> 32)) * 0x100000001b3u;
      hash = (hash ^ (bits & 0xffffffffu)) * 0x100000001b3u;
    }
  }
  return hash;
}

/// The same surface seen from the other side, with its border run the other way from the same
/// point.
void Reverse(Index size, InnerPatch& patch)
{
  for (Point3& normal : patch.Normals)
  {
    normal = -1.0 * normal;
  }
  for (std::array<Index, 3>& triangle : patch.Triangles)
  {
    for (Index& corner : triangle)
    {
      corner = corner > 0 ? size - corner : corner;
    }
    std::swap(triangle[1], triangle[2]);
  }
}

/// Whether the points of a patch are inside the room, and no side but those of the border on a
/// face.
bool FitsIn(const PatchBorder& border, const InnerPatch& patch)
{
  for (const Point3& point : patch.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (point[axis] < border.Room.Low[axis] || point[axis] > border.Room.High[axis])
      {
        return false;
      }
    }
  }
  const Index size = border.Count();
  const auto isChord = [&](Index a, Index b)
  { return a >= 0 && b >= 0 && (a + 1) % size != b && (b + 1) % size != a; };
  for (const std::array<Index, 3>& triangle : patch.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = triangle[i], b = triangle[(i + 1) % 3];
      if (isChord(a, b) && border.AreOnOneFace(a, b))
      {
        return false;
      }
    }
  }
  return true;
}
}

const SharedPatches::Entry* SharedPatches::FindEntry(const std::vector<Point3>& border) const
{
  const auto range = this->ByHash.equal_range(HashOf(border));
  for (auto found = range.first; found != range.second; ++found)
  {
    if (this->Entries[found->second].Border == border)
    {
      return &this->Entries[found->second];
    }
  }
  return nullptr;
}

bool SharedPatches::Find(const PatchBorder& border, InnerPatch& patch) const
{
  const Entry* entry = this->FindEntry(Canonical(border));
  if (entry == nullptr)
  {
    return false;
  }
  patch = entry->Patch;
  if (IsReversed(border))
  {
    Reverse(border.Count(), patch);
  }
  return FitsIn(border, patch);
}

void SharedPatches::Add(const PatchBorder& border, const InnerPatch& patch)
{
  std::vector<Point3> canonical = Canonical(border);
  if (this->FindEntry(canonical) != nullptr)
  {
    return;
  }
  this->ByHash.emplace(HashOf(canonical), this->Entries.size());
  this->Entries.push_back({ std::move(canonical), patch });
  if (IsReversed(border))
  {
    Reverse(border.Count(), this->Entries.back().Patch);
  }
}
}
