// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/SlabPatch.h"

#include "Core/Base/Vectors.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// A vertex of a contour: its loop among those of the group, and its place on it now.
struct ContourCorner
{
  Index Member, Place;
};

/// One piece of an overlay as a patch.
class PatchMaker
{
public:
  PatchMaker(const SlabSource& source, std::size_t group, Index piece);
  PatchMesh Run();

private:
  void FindMembers();
  Index CornerOf(Index corner);
  Point3 PointOf(Index corner) const;
  Point3 Place(const Point3& point) const;
  bool IsOnContour(Index a, Index b) const;
  void AddSide(Index a, Index b, std::vector<Index>& ring);
  void AddMiddle(const std::vector<Index>& ring, const std::array<Index, 3>& corners);

  const SlabSource& Source;
  const SlabGroup& Group;
  Index Piece;
  std::vector<ContourCorner> Corners;         ///< of the overlay, before its own points
  std::vector<std::pair<Index, Index>> Edges; ///< of its triangles, ascending
  std::vector<Index> FirstPlace;              ///< of each member on the border of the patch
  std::vector<Point3> Border;
  std::vector<Index> Own; ///< corners of the patch for the overlay's own points
  PatchMesh Mesh;
};

PatchMaker::PatchMaker(const SlabSource& source, std::size_t group, Index piece)
  : Source(source)
  , Group(source.Groups[group])
  , Piece(piece)
  , FirstPlace(Group.Loops.size(), -1)
  , Own(Group.Overlay.Points.size(), 0)
{
  for (std::size_t member = 0; member < this->Group.Loops.size(); ++member)
  {
    for (const Index place : source.Stitched.VertexAt[this->Group.Loops[member]])
    {
      this->Corners.push_back({ static_cast<Index>(member), place });
    }
  }
  for (std::size_t i = 0; i < this->Group.Overlay.Insertions.size(); ++i)
  {
    this->Corners.push_back(
      { this->Group.Overlay.Insertions[i].Loop, source.Stitched.InsertionAt[group][i] });
  }
  for (std::size_t t = 0; t < this->Group.Overlay.Triangles.size(); ++t)
  {
    const auto& triangle = this->Group.Overlay.Triangles[t];
    for (int i = 0; i < 3 && this->Group.Overlay.Piece[t] == piece; ++i)
    {
      this->Edges.emplace_back(triangle[i], triangle[(i + 1) % 3]);
    }
  }
  std::sort(this->Edges.begin(), this->Edges.end());
  this->Mesh.Kind = PatchKind::Stitched;
}

/// The loops of the piece, in the order of their cycles.
void PatchMaker::FindMembers()
{
  std::vector<std::pair<Index, Index>> members; // cycle, member
  for (const auto& edge : this->Edges)
  {
    if (edge.first < static_cast<Index>(this->Corners.size()))
    {
      const Index member = this->Corners[edge.first].Member;
      members.emplace_back(CycleOfLoop(this->Source.Geometry, this->Group.Loops[member],
                             !this->Group.Outlines[member].Upper),
        member);
    }
  }
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  for (const auto& member : members)
  {
    this->Mesh.Cycles.push_back(member.first);
    this->FirstPlace[member.second] = static_cast<Index>(this->Border.size());
    const Index loop = this->Group.Loops[member.second];
    const Index count = this->Source.Stitched.Count(loop);
    const std::vector<Point3>& points = this->Source.Stitched.Loops[loop].Points;
    for (Index i = 0; i < count; ++i)
    {
      // Cycles below a slice are passed backwards.
      const bool backwards = this->Group.Outlines[member.second].Upper;
      this->Border.push_back(points[backwards ? count - 1 - i : i]);
    }
  }
}

/// An own point of the overlay in space, strictly inside the slab.
Point3 PatchMaker::Place(const Point3& point) const
{
  const auto& planes = this->Source.Geometry.Grid.Planes[this->Source.Axis];
  const double width = this->Source.Geometry.Grid.Width(this->Source.Axis, this->Group.Slab);
  const double low = this->Group.Slab > 0 ? planes[this->Group.Slab - 1] : planes[0] - width;
  Point3 placed;
  placed[this->Source.Axis] = this->Source.Geometry.Grid.MoveInside(
    this->Source.Axis, this->Group.Slab, low + point[2] * width);
  const std::array<int, 2> axes{ FirstAxis(this->Source.Axis), SecondAxis(this->Source.Axis) };
  for (int i = 0; i < 2; ++i)
  {
    placed[axes[i]] = this->Source.Geometry.Grid.MoveIntoBounds(
      axes[i], point[i] + point[2] * this->Group.Shift[i]);
  }
  return placed;
}

Index PatchMaker::CornerOf(Index corner)
{
  const Index contours = static_cast<Index>(this->Corners.size());
  if (corner < contours)
  {
    const ContourCorner& at = this->Corners[corner];
    const Index count = this->Source.Stitched.Count(this->Group.Loops[at.Member]);
    return this->FirstPlace[at.Member] +
      (this->Group.Outlines[at.Member].Upper ? count - 1 - at.Place : at.Place);
  }
  Index& own = this->Own[corner - contours];
  if (own == 0)
  {
    this->Mesh.Points.push_back(this->Place(this->Group.Overlay.Points[corner - contours]));
    own = -static_cast<Index>(this->Mesh.Points.size());
  }
  return own;
}

Point3 PatchMaker::PointOf(Index corner) const
{
  return corner >= 0 ? this->Border[corner] : this->Mesh.Points[-1 - corner];
}

/// Whether a side of a triangle is a part of a contour: open, and both ends on it.
bool PatchMaker::IsOnContour(Index a, Index b) const
{
  return !std::binary_search(this->Edges.begin(), this->Edges.end(), std::make_pair(b, a));
}

/// A corner, and the vertices after it that the slab on the other side of the slice has inserted.
void PatchMaker::AddSide(Index a, Index b, std::vector<Index>& ring)
{
  const Index from = this->CornerOf(a);
  if (from == this->CornerOf(b))
  {
    return; // rounding has moved a new vertex to an old one
  }
  ring.push_back(from);
  if (this->IsOnContour(a, b))
  {
    const Index member = this->Corners[a].Member;
    const Index first = this->FirstPlace[member];
    const Index count = this->Source.Stitched.Count(this->Group.Loops[member]);
    const Index to = this->CornerOf(b);
    for (Index p = first + (from - first + 1) % count; p != to; p = first + (p - first + 1) % count)
    {
      ring.push_back(p);
    }
  }
}

/// A fan around a new point in the middle of a triangle.
void PatchMaker::AddMiddle(const std::vector<Index>& ring, const std::array<Index, 3>& corners)
{
  Point3 middle = (1.0 / 3.0) *
    ((this->PointOf(corners[0]) + this->PointOf(corners[1])) + this->PointOf(corners[2]));
  for (double& x : middle)
  {
    x = this->Source.Geometry.Grid.Round(x);
  }
  this->Mesh.Points.push_back(middle);
  const Index own = -static_cast<Index>(this->Mesh.Points.size());
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    this->Mesh.Triangles.push_back({ ring[k], ring[(k + 1) % ring.size()], own });
  }
}

PatchMesh PatchMaker::Run()
{
  this->FindMembers();
  for (std::size_t t = 0; t < this->Group.Overlay.Triangles.size(); ++t)
  {
    if (this->Group.Overlay.Piece[t] != this->Piece)
    {
      continue;
    }
    const auto& triangle = this->Group.Overlay.Triangles[t];
    std::vector<Index> ring;
    for (int i = 0; i < 3; ++i)
    {
      this->AddSide(triangle[i], triangle[(i + 1) % 3], ring);
    }
    if (ring.size() < 3)
    {
      continue;
    }
    if (ring.size() == 3)
    {
      this->Mesh.Triangles.push_back({ ring[0], ring[1], ring[2] });
      continue;
    }
    this->AddMiddle(ring,
      { this->CornerOf(triangle[0]), this->CornerOf(triangle[1]), this->CornerOf(triangle[2]) });
  }
  // Every patch needs as many own points as it has cycles.
  while (this->Mesh.Points.size() < this->Mesh.Cycles.size())
  {
    const std::array<Index, 3> triangle = this->Mesh.Triangles.front();
    this->Mesh.Triangles.erase(this->Mesh.Triangles.begin());
    this->AddMiddle({ triangle[0], triangle[1], triangle[2] }, triangle);
  }
  return std::move(this->Mesh);
}
}

PatchMesh BuildSlabPatch(const SlabSource& source, std::size_t group, Index piece)
{
  return PatchMaker(source, group, piece).Run();
}
}
