// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/GuideSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Free points move onto a plane that cuts an edge of theirs within that share of its length: else
/// there would be slender triangles.
constexpr double SnapShare = 0.25;
/// Fixed ones count as on it only where nothing but rounding tells.
constexpr double RoundShare = 1e-9;
/// A contour turns sharply by 45 degrees.
constexpr double SharpCosine = 0.70710678118654752;

/// A part of the cut from one fixed point to the next.
struct Chain
{
  std::vector<Index> Points;
  Index Slab = 0; ///< see GuideCurves::SlabAt
};

/// Cuts a mesh along one plane, and moves parts of the cut.
class SurfaceCut
{
public:
  SurfaceCut(const GuideCurves& guides, const GuidePlane& plane, SurfaceMesh& mesh)
    : Guides(guides)
    , Plane(plane)
    , Mesh(mesh)
  {
  }

  void Run();
  std::vector<Chain> ListChains() const;
  void Move(const Chain& chain, const std::vector<Point3>& piece, double edgeLength);

private:
  bool IsCut(Index corner) const;
  void Snap();
  Index Follow(Index start, std::vector<Index>& points) const;
  void Refine(Chain& chain, double edgeLength);
  std::vector<double> LengthsOf(const Chain& chain) const;

  const GuideCurves& Guides;
  const GuidePlane& Plane;
  SurfaceMesh& Mesh;
  std::vector<double> Height; ///< of each point over the plane
};

/// Whether the ends of a corner's edge are on different sides of the plane.
bool SurfaceCut::IsCut(Index corner) const
{
  const double start = this->Height[this->Mesh.Corners.StartOf(corner)];
  const double end = this->Height[this->Mesh.Corners.EndOf(corner)];
  return (start < 0.0 && end > 0.0) || (start > 0.0 && end < 0.0);
}

/// Moves points onto the plane that are as good as there.
void SurfaceCut::Snap()
{
  const CornerTable& corners = this->Mesh.Corners;
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (!corners.IsAlive(corner) || !this->IsCut(corner))
    {
      continue;
    }
    const std::array<Index, 2> ends{ corners.StartOf(corner), corners.EndOf(corner) };
    const double length = std::abs(this->Height[ends[0]]) + std::abs(this->Height[ends[1]]);
    for (const Index end : ends)
    {
      const double share = this->Mesh.Fixed[end] ? RoundShare : SnapShare;
      if (std::abs(this->Height[end]) < share * length)
      {
        Point3& point = this->Mesh.Points[end];
        point = this->Mesh.Fixed[end] ? point : point - this->Height[end] * this->Plane.Normal;
        this->Height[end] = 0.0;
        break;
      }
    }
  }
}

void SurfaceCut::Run()
{
  for (const Point3& point : this->Mesh.Points)
  {
    this->Height.push_back(this->Plane.HeightOf(point));
  }
  this->Snap();
  const CornerTable& corners = this->Mesh.Corners;
  for (bool changed = true; changed;)
  {
    changed = false;
    for (Index corner = 0; corner < corners.CornerCount(); ++corner)
    {
      if (corners.IsAlive(corner) && this->IsCut(corner))
      {
        const double start = this->Height[corners.StartOf(corner)];
        const double end = this->Height[corners.EndOf(corner)];
        SplitEdge(corner, start / (start - end), this->Mesh);
        this->Height.push_back(0.0);
        changed = true;
      }
    }
  }
}

/// The next point of the cut, with the interior on the left as seen from where the normal points;
/// -1 if there is none, or if the cut branches.
Index SurfaceCut::Follow(Index start, std::vector<Index>& points) const
{
  const CornerTable& corners = this->Mesh.Corners;
  points.clear();
  corners.ForCornersAt(start,
    [&](Index at)
    {
      // The edge from here to the next vertex, whose triangle is on the positive side.
      const Index edge = CornerTable::Previous(at);
      if (this->Height[corners.EndOf(edge)] == 0.0 && this->Height[corners.VertexOf(edge)] > 0.0 &&
        this->Height[corners.VertexOf(corners.OppositeOf(edge))] < 0.0)
      {
        points.push_back(edge);
      }
    });
  return points.size() == 1 ? points.front() : -1;
}

/// All parts of the cut that run from one fixed point to another.
std::vector<Chain> SurfaceCut::ListChains() const
{
  const CornerTable& corners = this->Mesh.Corners;
  std::vector<Chain> chains;
  std::vector<Index> out, next;
  for (Index point = 0; point < corners.PointCount(); ++point)
  {
    if (!corners.IsUsed(point) || !this->Mesh.Fixed[point] || this->Height[point] != 0.0)
    {
      continue;
    }
    this->Follow(point, out);
    for (const Index first : out)
    {
      const Box3& cell = this->Mesh.Cells[this->Mesh.Cell[first / 3]];
      Chain chain{ { point }, this->Guides.SlabAt(Between(cell.Low, cell.High, 0.5)) };
      Index edge = first;
      while (edge >= 0)
      {
        chain.Points.push_back(corners.EndOf(edge));
        const Index end = chain.Points.back();
        edge = this->Mesh.Fixed[end] ? -1 : this->Follow(end, next);
      }
      if (this->Mesh.Fixed[chain.Points.back()] && chain.Points.back() != point)
      {
        chains.push_back(std::move(chain));
      }
    }
  }
  return chains;
}

std::vector<double> LengthsAlong(const std::vector<Point3>& points)
{
  std::vector<double> lengths{ 0.0 };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    lengths.push_back(lengths.back() + Length(points[i] - points[i - 1]));
  }
  return lengths;
}

/// The point of a polyline at a distance from its start.
Point3 PointAlong(
  const std::vector<Point3>& points, const std::vector<double>& lengths, double distance)
{
  const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, distance);
  const std::size_t i = static_cast<std::size_t>(after - lengths.begin());
  const double length = lengths[i] - lengths[i - 1];
  const double share = length > 0.0 ? (distance - lengths[i - 1]) / length : 0.0;
  return Between(points[i - 1], points[i], std::clamp(share, 0.0, 1.0));
}

std::vector<double> SurfaceCut::LengthsOf(const Chain& chain) const
{
  std::vector<Point3> points;
  for (const Index point : chain.Points)
  {
    points.push_back(this->Mesh.Points[point]);
  }
  return LengthsAlong(points);
}

/// Splits edges of the chain that are longer than `longest`.
void SurfaceCut::Refine(Chain& chain, double longest)
{
  for (std::size_t i = 0; i + 1 < chain.Points.size();)
  {
    const Index from = chain.Points[i], to = chain.Points[i + 1];
    if (Length(this->Mesh.Points[to] - this->Mesh.Points[from]) > longest)
    {
      SplitEdge(this->Mesh.Corners.FindEdge(from, to), 0.5, this->Mesh);
      this->Height.push_back(0.0);
      chain.Points.insert(chain.Points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
        this->Mesh.Corners.PointCount() - 1);
    }
    else
    {
      ++i;
    }
  }
}

void SurfaceCut::Move(const Chain& given, const std::vector<Point3>& piece, double edgeLength)
{
  Chain chain = given;
  const std::vector<double> along = LengthsAlong(piece);
  const double edges = std::max(2.0, std::ceil(along.back() / edgeLength));
  this->Refine(chain, this->LengthsOf(chain).back() / edges);
  const std::vector<double> lengths = this->LengthsOf(chain);
  std::vector<Point3>& points = this->Mesh.Points;
  const Point3 atStart = points[chain.Points.front()] - piece.front();
  const Point3 atEnd = points[chain.Points.back()] - piece.back();
  std::vector<double> places; // along the piece
  for (const double length : lengths)
  {
    places.push_back(along.back() * (length / lengths.back()));
  }
  for (std::size_t i = 1; i + 1 < piece.size(); ++i)
  {
    const Point3 before = Unit(piece[i] - piece[i - 1]), after = Unit(piece[i + 1] - piece[i]);
    if (Dot(before, after) < SharpCosine)
    {
      const auto at = std::lower_bound(places.begin(), places.end(), along[i]);
      const std::size_t high = static_cast<std::size_t>(at - places.begin());
      const std::size_t nearest =
        high > 0 && along[i] - places[high - 1] < places[high] - along[i] ? high - 1 : high;
      if (nearest > 0 && nearest + 1 < places.size())
      {
        places[nearest] = along[i];
      }
    }
  }
  for (std::size_t i = 0; i < chain.Points.size(); ++i)
  {
    const Index point = chain.Points[i];
    if (i > 0)
    {
      this->Mesh.Corners.MarkCurve(this->Mesh.Corners.FindEdge(chain.Points[i - 1], point));
    }
    if (i > 0 && i + 1 < chain.Points.size())
    {
      const double share = places[i] / along.back();
      points[point] = PointAlong(piece, along, places[i]) + Between(atStart, atEnd, share);
      this->Mesh.Fixed[point] = 1;
    }
  }
}

/// The number of the chain for each piece; -1 if it has none.
std::vector<Index> FindPartners(const std::vector<GuidePiece>& pieces,
  const std::vector<Chain>& chains, const std::vector<Point3>& points, double reach)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<Index> ofPiece(pieces.size(), -1), ofChain(chains.size(), -1);
  std::vector<double> leastOfPiece(pieces.size(), none), leastOfChain(chains.size(), none);
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    for (std::size_t j = 0; j < chains.size(); ++j)
    {
      const double distance = Length(pieces[i].Points.front() - points[chains[j].Points.front()]) +
        Length(pieces[i].Points.back() - points[chains[j].Points.back()]);
      if (chains[j].Slab != pieces[i].Slab || !(distance <= reach))
      {
        continue;
      }
      if (distance < leastOfPiece[i])
      {
        leastOfPiece[i] = distance;
        ofPiece[i] = static_cast<Index>(j);
      }
      if (distance < leastOfChain[j])
      {
        leastOfChain[j] = distance;
        ofChain[j] = static_cast<Index>(i);
      }
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    if (ofPiece[i] >= 0 && ofChain[ofPiece[i]] != static_cast<Index>(i))
    {
      ofPiece[i] = -1;
    }
  }
  return ofPiece;
}
}

Index GuideSurface(GuideCurves& guides, double reach, double edgeLength, SurfaceMesh& mesh)
{
  Index count = 0;
  for (GuideSlice& slice : guides.Slices)
  {
    slice.Guiding = 0;
    SurfaceCut cut(guides, slice.Plane, mesh);
    cut.Run();
    const std::vector<Chain> chains = cut.ListChains();
    const std::vector<Index> partners = FindPartners(slice.Pieces, chains, mesh.Points, reach);
    for (std::size_t i = 0; i < partners.size(); ++i)
    {
      if (partners[i] >= 0)
      {
        cut.Move(chains[partners[i]], slice.Pieces[i].Points, edgeLength);
        ++slice.Guiding;
      }
    }
    count += slice.Guiding;
  }
  return count;
}
}
