// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MeshBlock.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace
{
/// Numbers of things as keys, each with the order in which it came: a table with open addresses,
/// as that of a block fits into the cache.
class OrderOfArrival
{
public:
  explicit OrderOfArrival(std::size_t most)
  {
    while (this->Slots.size() < 2 * most)
    {
      this->Slots.resize(2 * this->Slots.size());
    }
    std::fill(this->Slots.begin(), this->Slots.end(), Slot{ -1, -1 });
    this->Keys.reserve(most);
  }

  /// The order of a key, which comes now if it has not come before.
  Index operator()(Index key)
  {
    std::size_t at = static_cast<std::uint32_t>(key) * std::size_t{ 0x9E3779B1 };
    for (at ^= at >> 15;; ++at)
    {
      Slot& slot = this->Slots[at & (this->Slots.size() - 1)];
      if (slot.Key < 0)
      {
        slot = { key, static_cast<Index>(this->Keys.size()) };
        this->Keys.push_back(key);
      }
      if (slot.Key == key)
      {
        return slot.Order;
      }
    }
  }

  std::vector<Index> Keys; ///< as they came

private:
  struct Slot
  {
    Index Key, Order;
  };
  std::vector<Slot> Slots{ 16 };
};

/// What may be done to a point of a block, in the order of their numbers.
enum Group : std::uint8_t
{
  Beyond,
  Outside,
  Frozen,
  KeptInside,
  Movable,
  GroupCount
};

/// The groups of points: a triangle with one outside freezes its other corners.
std::vector<Group> FindGroups(const ImprovableMesh& whole, const MeshBlock& block, Index kept,
  const std::vector<Index>& points, const std::vector<std::array<Index, 3>>& triangles)
{
  std::vector<Group> groups;
  groups.reserve(points.size());
  for (const Index point : points)
  {
    groups.push_back(point < whole.Borders.Beyond ? Beyond
        : !block.HasInside(whole.Points[point])   ? Outside
        : point < kept                            ? KeptInside
                                                  : Movable);
  }
  for (const std::array<Index, 3>& triangle : triangles)
  {
    if (std::any_of(
          triangle.begin(), triangle.end(), [&](Index i) { return groups[i] == Outside; }))
    {
      for (const Index i : triangle)
      {
        groups[i] = std::min(groups[i], Frozen);
      }
    }
  }
  return groups;
}
}

MeshBlock::MeshBlock(const ImprovableMesh& whole, const Box3& box, const BlockCells& cells,
  const Index* begin, const Index* end, Index kept)
  : Mesh{ CornerTable(0, {}), {}, {} }
  , Box(box)
  , Cells(cells)
  , Triangles(begin, end)
{
  this->NumberPoints(whole, kept);
  this->CopyPoints(whole);
  this->MarkCurves(whole);
  this->CopyBorders(whole.Borders);
}

bool MeshBlock::HasCornersFrom(Index triangle, Index first) const
{
  const CornerTable& corners = this->Mesh.Corners;
  return std::min({ corners.VertexOf(3 * triangle), corners.VertexOf(3 * triangle + 1),
           corners.VertexOf(3 * triangle + 2) }) >= first;
}

/// Finds the points and their numbers, and makes the table of corners.
void MeshBlock::NumberPoints(const ImprovableMesh& whole, Index kept)
{
  OrderOfArrival order(this->Triangles.size());
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(this->Triangles.size());
  for (const Index triangle : this->Triangles)
  {
    const Index first = 3 * triangle;
    const Index a = order(whole.Corners.VertexOf(first)),
                b = order(whole.Corners.VertexOf(first + 1));
    triangles.push_back({ a, b, order(whole.Corners.VertexOf(first + 2)) });
  }
  const std::vector<Group> groups = FindGroups(whole, *this, kept, order.Keys, triangles);
  std::array<Index, GroupCount + 1> next{};
  for (const Group group : groups)
  {
    ++next[group + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  this->Mesh.Borders.Beyond = next[Outside];
  this->FirstInner = next[Frozen];
  this->FirstFree = next[KeptInside];
  this->Kept = next[Movable];
  std::vector<Index> numbers;
  numbers.reserve(groups.size());
  this->Points.resize(groups.size());
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    numbers.push_back(next[groups[i]]++);
    this->Points[numbers[i]] = order.Keys[i];
  }
  for (std::array<Index, 3>& triangle : triangles)
  {
    triangle = { numbers[triangle[0]], numbers[triangle[1]], numbers[triangle[2]] };
  }
  this->Mesh.Corners = CornerTable(static_cast<Index>(groups.size()), triangles);
}

void MeshBlock::CopyPoints(const ImprovableMesh& whole)
{
  this->Mesh.Rooms = whole.Rooms;
  this->Mesh.Points.reserve(this->Points.size());
  this->Mesh.Normals.reserve(this->Points.size());
  for (const Index point : this->Points)
  {
    this->Mesh.Points.push_back(whole.Points[point]);
    this->Mesh.Normals.push_back(whole.Normals[point]);
    if (!whole.RoomOf.empty())
    {
      this->Mesh.RoomOf.push_back(whole.RoomOf[point]);
    }
  }
}

/// Marks the curves of the whole, and the edges of triangles that may not change.
void MeshBlock::MarkCurves(const ImprovableMesh& whole)
{
  CornerTable& corners = this->Mesh.Corners;
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (!this->IsInner(corner / 3) ||
      whole.Corners.IsCurve(3 * this->Triangles[corner / 3] + corner % 3))
    {
      corners.MarkCurve(corner);
    }
  }
}

/// Finds points at the same place among those of the block.
void MeshBlock::CopyBorders(const SheetBorders& borders)
{
  if (borders.Site.empty())
  {
    return;
  }
  SheetBorders& own = this->Mesh.Borders;
  own.Site.resize(this->Points.size());
  std::iota(own.Site.begin(), own.Site.end(), 0);
  own.Next = own.Site;
  std::vector<std::array<Index, 2>> copies;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    if (borders.HasCopies(this->Points[i]))
    {
      copies.push_back({ borders.SiteOf(this->Points[i]), static_cast<Index>(i) });
    }
  }
  std::sort(copies.begin(), copies.end());
  for (std::size_t i = 1; i < copies.size(); ++i)
  {
    if (copies[i][0] == copies[i - 1][0])
    {
      const Index before = copies[i - 1][1], point = copies[i][1];
      own.Site[point] = own.Site[before];
      own.Next[point] = own.Next[before];
      own.Next[before] = point;
    }
  }
}
}
