// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/ImprovementState.h"

#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Sides are short below that share of the tolerance.
constexpr double ShortSide = 0.05;

/// The boxes of all triangles that are part of the surface; others are empty.
std::vector<Box3> BoxesOfParts(const ImprovableMesh& mesh)
{
  std::vector<Box3> boxes = BoxesOf(mesh.Corners, mesh.Points);
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    boxes[i] = mesh.Borders.IsBeyond(mesh.Corners, static_cast<Index>(i)) ? Box3() : boxes[i];
  }
  return boxes;
}
}

ImprovementState::ImprovementState(
  const SpatialGrid& grid, MeshBlock& block, const SurfaceSamples& samples)
  : Grid(grid)
  , Block(block)
  , Mesh(block.Mesh)
  , Boxes(BoxesOfParts(block.Mesh))
  , Samples(samples, block)
{
  const Index count = this->Mesh.Corners.CornerCount() / 3;
  this->Qualities.resize(count);
  for (Index triangle = 0; triangle < count; ++triangle)
  {
    this->Qualities[triangle] =
      this->IsPart(triangle) ? SquaredSine(this->PlacesOf(triangle)) : 1.0;
  }
}

bool ImprovementState::IsShort(Index corner) const
{
  const CornerTable& corners = this->Mesh.Corners;
  const double bound =
    ShortSide * this->Samples.ToleranceOfSide(corner / 3, corners.OppositeOf(corner) / 3);
  return SquaredDistance(this->At(corners.StartOf(corner)), this->At(corners.EndOf(corner))) <
    bound * bound;
}

bool ImprovementState::Update(Index triangle)
{
  const bool isPart = this->IsPart(triangle);
  this->Boxes.Set(
    triangle, isPart ? BoxOf(this->Mesh.Corners, this->Mesh.Points, triangle) : Box3());
  this->Qualities[triangle] = isPart ? SquaredSine(this->PlacesOf(triangle)) : 1.0;
  return isPart;
}

Point3 ImprovementState::MoveIntoBounds(Index point, const Point3& place) const
{
  Point3 moved;
  for (int axis = 0; axis < 3; ++axis)
  {
    moved[axis] = this->Grid.MoveIntoBounds(axis, place[axis]);
    if (!this->Mesh.Rooms.empty())
    {
      const Box3& room = this->Mesh.Rooms[this->Mesh.RoomOf[point]];
      moved[axis] = std::max(room.Low[axis], std::min(room.High[axis], moved[axis]));
    }
  }
  return moved;
}
}
