// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/PatchBorder.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The part of a cell in which the points inside a patch may be.
Box3 RoomInside(const SpatialGrid& grid, const std::array<Index, 3>& cell)
{
  Box3 room;
  for (int axis = 0; axis < 3; ++axis)
  {
    room.Low[axis] = grid.MoveInside(axis, cell[axis], -HUGE_VAL, InnerMargin);
    room.High[axis] = grid.MoveInside(axis, cell[axis], HUGE_VAL, InnerMargin);
  }
  return room;
}
}

void PatchBorder::Set(const CycleGeometry& geometry, const SurfaceNormals& normals, Index cycle)
{
  geometry.GetBoundary(cycle, this->Points, this->NodePlaces);
  const std::size_t n = this->Points.size();
  this->Places.resize(n);
  this->Normals.resize(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const float* normal = normals.Normals.data() + 3 * static_cast<std::size_t>(this->Points[i]);
    this->Places[i] = geometry.Graph.PointAt(this->Points[i]);
    this->Normals[i] = { normal[0], normal[1], normal[2] };
  }
  this->Center = WeighByLength(this->Places, this->Weights);
  this->Room = RoomInside(geometry.Grid, geometry.Cycles.Cell[cycle]);
}

Index PatchBorder::Turn()
{
  const auto minimum = std::min_element(this->Places.begin(), this->Places.end());
  const Index first = static_cast<Index>(minimum - this->Places.begin());
  const auto turn = [first](auto& values)
  { std::rotate(values.begin(), values.begin() + first, values.end()); };
  turn(this->Points);
  turn(this->Places);
  turn(this->Normals);
  for (Index& place : this->NodePlaces)
  {
    place = place >= first ? place - first : place - first + this->Count();
  }
  std::sort(this->NodePlaces.begin(), this->NodePlaces.end());
  this->Center =
    WeighByLength(this->Places, this->Weights); // to the last bit, sums depend on their order
  return first;
}

bool PatchBorder::AreOnOneFace(Index a, Index b) const
{
  const Point3 &p = this->Places[a], &q = this->Places[b];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::max(p[axis], q[axis]) < this->Room.Low[axis] ||
      std::min(p[axis], q[axis]) > this->Room.High[axis])
    {
      return true;
    }
  }
  return false;
}

Point3 PatchBorder::MoveInside(const SpatialGrid& grid, const Point3& place) const
{
  Point3 inside;
  for (int axis = 0; axis < 3; ++axis)
  {
    inside[axis] =
      grid.Round(std::max(this->Room.Low[axis], std::min(this->Room.High[axis], place[axis])));
  }
  return inside;
}

void InnerPatch::Clear()
{
  this->Points.clear();
  this->Normals.clear();
  this->Triangles.clear();
}
}
