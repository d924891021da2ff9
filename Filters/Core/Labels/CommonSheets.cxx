// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CommonSheets.h"

#include "Core/Base/DisjointSets.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace orthoslices
{
CommonSheets::CommonSheets(
  const std::vector<StructureSurface>& structures, bool keepContours, const Execution& execution)
  : Structures(structures)
{
  for (const StructureSurface& structure : structures)
  {
    this->Surfaces.push_back(ListTriangles(structure.Geometry, structure.Surface, execution));
    this->Tables.emplace_back(
      static_cast<Index>(this->Surfaces.back().Points.size()), this->Surfaces.back().Triangles);
  }
  this->FindSites();
  this->Found = this->FindTriangles();
  if (this->Found)
  {
    this->FindSheets();
    this->LinkSheets();
    this->FindCrowdedEdges();
    this->FindPoints();
    this->FindFixed();
    this->FollowBorders();
    this->NumberPoints(keepContours);
    this->Found = this->AreBordersSingle();
  }
}

/// Numbers the places of all points that are used.
void CommonSheets::FindSites()
{
  std::vector<std::tuple<Point3, Index, Index>> places;
  for (std::size_t s = 0; s < this->Surfaces.size(); ++s)
  {
    const std::vector<Point3>& points = this->Surfaces[s].Points;
    this->SiteOf.emplace_back(points.size(), -1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (this->Tables[s].IsUsed(static_cast<Index>(i)))
      {
        places.emplace_back(points[i], static_cast<Index>(s), static_cast<Index>(i));
      }
    }
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto& [place, s, point] = places[i];
    this->Sites += i == 0 || std::get<0>(places[i - 1]) != place ? 1 : 0;
    this->SiteOf[s][point] = this->Sites - 1;
  }
}

Index CommonSheets::SiteAt(const Member& member, int i) const
{
  return this
    ->SiteOf[member.Structure][this->Surfaces[member.Structure].Triangles[member.Triangle][i]];
}

/// Finds the triangles that structures have in common, in the order of the first ones that have
/// them. False if one has the same twice.
bool CommonSheets::FindTriangles()
{
  std::vector<SitesOfTriangle> all;
  for (std::size_t s = 0; s < this->Surfaces.size(); ++s)
  {
    const Index count = static_cast<Index>(this->Surfaces[s].Triangles.size());
    for (Index i = 0; i < count; ++i)
    {
      const Member member{ static_cast<Index>(s), i, false };
      std::array<Index, 3> sites{ this->SiteAt(member, 0), this->SiteAt(member, 1),
        this->SiteAt(member, 2) };
      std::sort(sites.begin(), sites.end());
      all.emplace_back(sites, member.Structure, i);
    }
    this->TriangleOf.emplace_back(count, -1);
  }
  std::sort(all.begin(), all.end());
  std::vector<std::tuple<Index, Index, std::size_t>> firsts;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const auto& [sites, s, triangle] = all[i];
    if (i == 0 || std::get<0>(all[i - 1]) != sites)
    {
      firsts.emplace_back(s, triangle, i);
    }
    else if (std::get<1>(all[i - 1]) == s)
    {
      return false;
    }
  }
  std::sort(firsts.begin(), firsts.end());
  for (const auto& first : firsts)
  {
    this->AddTriangle(all, std::get<2>(first));
  }
  return true;
}

/// Adds a triangle and all that are the same, which follow each other.
void CommonSheets::AddTriangle(const std::vector<SitesOfTriangle>& all, std::size_t begin)
{
  const Index number = this->Count();
  const auto& [sites, structure, triangle] = all[begin];
  const Member first{ structure, triangle, false };
  this->Corners.push_back(
    { this->SiteAt(first, 0), this->SiteAt(first, 1), this->SiteAt(first, 2) });
  for (std::size_t i = begin; i < all.size() && std::get<0>(all[i]) == sites; ++i)
  {
    Member member{ std::get<1>(all[i]), std::get<2>(all[i]), false };
    const Index at = this->CornerAt(number, this->SiteAt(member, 0));
    member.IsReversed = this->SiteAt(member, 1) != this->Corners.back()[(at + 1) % 3];
    this->TriangleOf[member.Structure][member.Triangle] = number;
    this->Members.push_back(member);
  }
  this->MemberOffsets.push_back(static_cast<Index>(this->Members.size()));
}

/// The corner of a triangle at a site.
Index CommonSheets::CornerAt(Index triangle, Index site) const
{
  const std::array<Index, 3>& sites = this->Corners[triangle];
  return 3 * triangle + (sites[0] == site ? 0 : sites[1] == site ? 1 : 2);
}

/// Numbers the sets of structures that triangles belong to.
void CommonSheets::FindSheets()
{
  std::map<std::vector<std::pair<Index, bool>>, Index> numbers;
  std::vector<std::pair<Index, bool>> own;
  for (Index t = 0; t < this->Count(); ++t)
  {
    own.clear();
    for (Index m = this->MemberOffsets[t]; m < this->MemberOffsets[t + 1]; ++m)
    {
      own.emplace_back(this->Members[m].Structure, this->Members[m].IsReversed);
    }
    const auto found = numbers.emplace(own, static_cast<Index>(numbers.size()));
    if (found.second)
    {
      this->FirstOfSheet.push_back(t);
    }
    this->Sheet.push_back(found.first->second);
  }
}

/// The corner across the edge of a corner, if all structures of the triangle go on to that triangle
/// there, and no other one does; else -1.
Index CommonSheets::FindNeighbor(Index corner) const
{
  const Index triangle = corner / 3;
  Index neighbor = -1;
  for (Index m = this->MemberOffsets[triangle]; m < this->MemberOffsets[triangle + 1]; ++m)
  {
    const Member& member = this->Members[m];
    int i = 0;
    while (this->SiteAt(member, i) != this->Corners[triangle][corner % 3])
    {
      ++i;
    }
    const CornerTable& table = this->Tables[member.Structure];
    const Index across = table.OppositeOf(3 * member.Triangle + i);
    const Index next = this->CornerAt(this->TriangleOf[member.Structure][across / 3],
      this->SiteOf[member.Structure][table.VertexOf(across)]);
    if (neighbor >= 0 && next != neighbor)
    {
      return -1;
    }
    neighbor = next;
  }
  return this->Sheet[neighbor / 3] == this->Sheet[triangle] ? neighbor : -1;
}

void CommonSheets::LinkSheets()
{
  this->Opposite.reserve(3 * this->Corners.size());
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    this->Opposite.push_back(this->FindNeighbor(corner));
  }
}

/// Finds the edges at which other sheets meet a triangle.
void CommonSheets::FindCrowdedEdges()
{
  std::vector<std::tuple<Index, Index, Index>> edges;
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    const std::array<Index, 3>& sites = this->Corners[corner / 3];
    const Index a = sites[(corner + 1) % 3], b = sites[(corner + 2) % 3];
    edges.emplace_back(std::min(a, b), std::max(a, b), corner);
  }
  std::sort(edges.begin(), edges.end());
  this->IsCrowded.assign(edges.size(), 0);
  for (std::size_t first = 0, last; first < edges.size(); first = last)
  {
    const auto& [a, b, corner] = edges[first];
    for (last = first;
         last < edges.size() && std::get<0>(edges[last]) == a && std::get<1>(edges[last]) == b;
         ++last)
    {
    }
    for (std::size_t i = first; i < last; ++i)
    {
      this->IsCrowded[std::get<2>(edges[i])] = last - first == 2 ? 0 : 1;
    }
  }
}

/// Triangles at one place have a point there in common if they are linked around it.
void CommonSheets::FindPoints()
{
  DisjointSets sets(3 * this->Count());
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    const Index across = this->Opposite[corner];
    if (across > corner)
    {
      sets.Unite(CornerTable::Next(corner), CornerTable::Previous(across));
      sets.Unite(CornerTable::Previous(corner), CornerTable::Next(across));
    }
  }
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    this->PointOf.push_back(sets.Find(corner));
  }
}

/// Finds the points that may not move: on borders, and where others are.
void CommonSheets::FindFixed()
{
  this->IsFixed.assign(this->PointOf.size(), 0);
  std::vector<Index> firstAt(this->Sites, -1);
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    Index& first = firstAt[this->Corners[corner / 3][corner % 3]];
    const Index point = this->PointOf[corner];
    first = first < 0 ? point : first;
    if (first != point)
    {
      this->IsFixed[point] = this->IsFixed[first] = 1;
    }
    if (this->IsCrowded[corner] != 0 || this->Opposite[corner] < 0)
    {
      this->IsFixed[this->StartOf(corner)] = this->IsFixed[this->EndOf(corner)] = 1;
    }
  }
}

/// Numbers the borders.
void CommonSheets::FollowBorders()
{
  const Index count = 3 * this->Count();
  std::vector<Index> following(count, -1);
  for (Index corner = 0; corner < count; ++corner)
  {
    if (this->Opposite[corner] < 0)
    {
      following[this->StartOf(corner)] = corner;
    }
  }
  this->Beyond.assign(count, -1);
  for (Index corner = 0; corner < count; ++corner)
  {
    if (this->Opposite[corner] < 0 && this->Beyond[corner] < 0)
    {
      for (Index next = corner; this->Beyond[next] < 0; next = following[this->EndOf(next)])
      {
        this->Beyond[next] = this->Numbers.Beyond;
      }
      ++this->Numbers.Beyond;
    }
  }
}

/// Whether no two edges of borders join the same points: they would be one edge of a corner table.
bool CommonSheets::AreBordersSingle() const
{
  std::vector<std::pair<Index, Index>> edges;
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    if (this->Opposite[corner] < 0)
    {
      edges.push_back(std::minmax(this->StartOf(corner), this->EndOf(corner)));
    }
  }
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

/// The point of a structure at a corner.
Index CommonSheets::LocalPoint(Index corner, const Member& member) const
{
  const Index site = this->Corners[corner / 3][corner % 3];
  const int i = this->SiteAt(member, 0) == site ? 0 : this->SiteAt(member, 1) == site ? 1 : 2;
  return this->Surfaces[member.Structure].Triangles[member.Triangle][i];
}

bool CommonSheets::IsOnContour(Index corner, const Member& member) const
{
  return this->LocalPoint(corner, member) <
    this->Structures[member.Structure].Geometry.Graph.Count();
}

namespace
{
/// Points of a mesh, in their order.
enum PointKind : std::uint8_t
{
  Kept,
  OnContour,
  Inside
};
}

/// Of the least corner at each point, its PointKind.
std::vector<std::uint8_t> CommonSheets::ListKinds(bool keepContours) const
{
  std::vector<std::uint8_t> kinds(this->PointOf.size(), Inside);
  for (Index corner = 0; corner < 3 * this->Count(); ++corner)
  {
    const Index point = this->PointOf[corner];
    const auto begin = this->Members.begin();
    const bool isOnContour = std::any_of(begin + this->MemberOffsets[corner / 3],
      begin + this->MemberOffsets[corner / 3 + 1],
      [&](const Member& member) { return this->IsOnContour(corner, member); });
    if (this->IsFixed[point] != 0 || (isOnContour && keepContours))
    {
      kinds[point] = Kept;
    }
    else if (isOnContour)
    {
      kinds[point] = std::min<std::uint8_t>(kinds[point], OnContour);
    }
  }
  return kinds;
}

/// After the points that stand for what is beyond borders.
void CommonSheets::NumberPoints(bool keepContours)
{
  PointNumbers& numbers = this->Numbers;
  const std::vector<std::uint8_t> kinds = this->ListKinds(keepContours);
  numbers.OfCorner.resize(kinds.size());
  numbers.Count = numbers.Beyond;
  for (const PointKind kind : { Kept, OnContour, Inside })
  {
    for (std::size_t corner = 0; corner < kinds.size(); ++corner)
    {
      if (this->PointOf[corner] == static_cast<Index>(corner) && kinds[corner] == kind)
      {
        numbers.OfCorner[corner] = numbers.Count++;
      }
    }
    numbers.Kept = kind == Kept ? numbers.Count : numbers.Kept;
    numbers.FirstInside = kind != Inside ? numbers.Count : numbers.FirstInside;
  }
  for (std::size_t corner = 0; corner < kinds.size(); ++corner)
  {
    numbers.OfCorner[corner] = numbers.OfCorner[this->PointOf[corner]];
  }
}
}
