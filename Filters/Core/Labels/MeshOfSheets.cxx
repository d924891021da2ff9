// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
// The sheets of CommonSheets as a mesh, and a mesh as surfaces of the structures again.
#include "Core/Labels/CommonSheets.h"

#include <algorithm>
#include <utility>

namespace orthoslices
{
/// Those of the sheets, and one beyond each edge of a border.
std::vector<std::array<Index, 3>> CommonSheets::ListWithBeyond() const
{
  std::vector<std::array<Index, 3>> triangles;
  const std::vector<Index>& points = this->Numbers.OfCorner;
  for (Index corner = 0; corner < 3 * this->Count(); corner += 3)
  {
    triangles.push_back({ points[corner], points[corner + 1], points[corner + 2] });
  }
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    if (this->Opposite[corner] < 0)
    {
      triangles.push_back({ this->Beyond[corner], points[CornerTable::Previous(corner)],
        points[CornerTable::Next(corner)] });
    }
  }
  return triangles;
}

void CommonSheets::MarkCurves(CornerTable& corners) const
{
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    if (this->IsCrowded[corner] != 0 || this->Opposite[corner] < 0)
    {
      corners.MarkCurve(corner);
    }
  }
}

/// Sets the places of points, their normals, and which room each may not leave.
void CommonSheets::PlacePoints(ImprovableMesh& mesh) const
{
  const PointNumbers& numbers = this->Numbers;
  std::vector<std::vector<Point3>> normals;
  for (std::size_t s = 0; s < this->Structures.size(); ++s)
  {
    const StructureSurface& structure = this->Structures[s];
    normals.push_back(ListNormals(structure.Normals, structure.Surface,
      structure.Geometry.Graph.Count(), this->Surfaces[s].Points.size()));
  }
  mesh.Points.resize(numbers.Count);
  mesh.Normals.resize(numbers.Count);
  mesh.RoomOf.assign(numbers.Count, 0);
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    const Member& first = this->Members[this->MemberOffsets[corner / 3]];
    const Index point = numbers.OfCorner[corner], local = this->LocalPoint(corner, first);
    mesh.Points[point] = this->Surfaces[first.Structure].Points[local];
    mesh.Normals[point] = normals[first.Structure][local];
    mesh.RoomOf[point] = this->Sheet[corner / 3];
    if (this->Opposite[corner] < 0)
    {
      mesh.Points[this->Beyond[corner]] = mesh.Points[point]; // anywhere
    }
  }
}

/// Notes which points are at the same place.
void CommonSheets::NoteCopies(ImprovableMesh& mesh) const
{
  const PointNumbers& numbers = this->Numbers;
  SheetBorders& borders = mesh.Borders;
  borders.Beyond = numbers.Beyond;
  std::vector<std::pair<Index, Index>> points;
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    if (this->PointOf[corner] == corner)
    {
      points.emplace_back(this->Corners[corner / 3][corner % 3], numbers.OfCorner[corner]);
    }
  }
  std::sort(points.begin(), points.end());
  for (Index point = 0; point < numbers.Count; ++point)
  {
    borders.Site.push_back(point);
    borders.Next.push_back(point);
  }
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    if (points[i].first == points[i - 1].first)
    {
      const Index before = points[i - 1].second, point = points[i].second;
      borders.Site[point] = borders.Site[before];
      borders.Next[point] = borders.Next[before];
      borders.Next[before] = point;
    }
  }
}

/// The room of each set of structures is the part that the bounds of all of them have in common.
std::vector<Box3> CommonSheets::ListRooms() const
{
  std::vector<Box3> rooms;
  for (const Index triangle : this->FirstOfSheet)
  {
    Box3 room = Everywhere();
    for (Index m = this->MemberOffsets[triangle]; m < this->MemberOffsets[triangle + 1]; ++m)
    {
      const SpatialGrid& grid = this->Structures[this->Members[m].Structure].Geometry.Grid;
      for (int axis = 0; axis < 3; ++axis)
      {
        room.Low[axis] = std::max(room.Low[axis], grid.Lowest[axis]);
        room.High[axis] = std::min(room.High[axis], grid.Highest[axis]);
      }
    }
    rooms.push_back(room);
  }
  return rooms;
}

ImprovableMesh CommonSheets::MakeMesh() const
{
  ImprovableMesh mesh{ CornerTable(this->Numbers.Count, this->ListWithBeyond()), {}, {} };
  this->MarkCurves(mesh.Corners);
  this->PlacePoints(mesh);
  this->NoteCopies(mesh);
  mesh.Rooms = this->ListRooms();
  mesh.FirstInside = this->Numbers.FirstInside;
  std::vector<std::vector<Index>> plain;
  for (const StructureSurface& structure : this->Structures)
  {
    plain.push_back(ListPlain(structure.Surface));
  }
  mesh.Plain.assign(mesh.Corners.CornerCount() / 3, -1);
  for (Index triangle = 0; triangle < this->Count(); ++triangle)
  {
    const Member& first = this->Members[this->MemberOffsets[triangle]];
    mesh.Plain[triangle] = plain[first.Structure][first.Triangle];
  }
  return mesh;
}

void CommonSheets::SetImproved(const ImprovableMesh& mesh) const
{
  std::vector<TrianglesLeft> ofStructure(this->Structures.size());
  const TrianglesLeft left = ListLeft(mesh);
  for (std::size_t i = 0; i < left.Triangles.size(); ++i)
  {
    const Index number = left.Numbers[i];
    for (Index m = this->MemberOffsets[number]; m < this->MemberOffsets[number + 1]; ++m)
    {
      const Member& member = this->Members[m];
      std::array<Index, 3> triangle = left.Triangles[i];
      if (member.IsReversed)
      {
        std::swap(triangle[1], triangle[2]);
      }
      ofStructure[member.Structure].Triangles.push_back(triangle);
      ofStructure[member.Structure].Numbers.push_back(member.Triangle);
    }
  }
  for (std::size_t s = 0; s < ofStructure.size(); ++s)
  {
    this->SetImproved(static_cast<Index>(s), mesh, std::move(ofStructure[s]));
  }
}

namespace
{
/// Sorts triangles by their numbers.
TrianglesLeft Sorted(const TrianglesLeft& left)
{
  std::vector<std::pair<Index, std::size_t>> order;
  for (std::size_t i = 0; i < left.Numbers.size(); ++i)
  {
    order.emplace_back(left.Numbers[i], i);
  }
  std::sort(order.begin(), order.end());
  TrianglesLeft sorted;
  for (const auto& [number, i] : order)
  {
    sorted.Numbers.push_back(number);
    sorted.Triangles.push_back(left.Triangles[i]);
  }
  return sorted;
}
}

/// Gives a structure its triangles, whose corners are points of the mesh.
void CommonSheets::SetImproved(
  Index structure, const ImprovableMesh& mesh, TrianglesLeft&& left) const
{
  // Points of a mesh are at the sites where they were, so those of one structure, but for new ones.
  std::vector<Index> local(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < this->TriangleOf[structure].size(); ++i)
  {
    const Index triangle = this->TriangleOf[structure][i];
    const Member member{ structure, static_cast<Index>(i), false };
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
    {
      local[this->Numbers.OfCorner[corner]] = this->LocalPoint(corner, member);
    }
  }
  const std::size_t given = this->Surfaces[structure].Points.size();
  std::vector<Point3> points = this->Surfaces[structure].Points;
  for (std::array<Index, 3>& triangle : left.Triangles)
  {
    for (Index& corner : triangle)
    {
      if (local[corner] < 0)
      {
        local[corner] = static_cast<Index>(points.size());
        points.emplace_back();
      }
      points[local[corner]] = mesh.Points[corner];
      corner = local[corner];
    }
  }
  orthoslices::SetImproved(points, given, Sorted(left), this->Structures[structure].Surface);
}
}
