// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MakesFold.h"

#include "Core/Base/Vectors.h"
#include "Core/Improve/PointStar.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// The cosine of the angle between the normals of triangles that enclose ten degrees.
constexpr double FoldCosine = -0.9848;

/// A side of a triangle, by the places of its ends, the one with the smaller number first.
struct Side
{
  std::array<Index, 2> Ends;
  Point3 Normal; ///< of the triangle, of any length, as it is seen where the side runs that way
};

/// The sides of the triangles around a place that changes.
class SidesAround
{
public:
  SidesAround(const CornerTable& corners, const std::vector<Point3>& points,
    const SurfaceChange& change, const SheetBorders& borders)
    : Corners(corners)
    , Points(points)
    , Change(change)
    , Borders(borders)
  {
  }

  double SharpestBefore()
  {
    this->AddBeside();
    for (const Index triangle : this->Change.Removed)
    {
      this->AddAll(this->CornersOf(triangle),
        [&](Index point) -> const Point3& { return this->Points[point]; });
    }
    return this->Sharpest();
  }

  double SharpestAfter()
  {
    this->AddBeside();
    for (const std::array<Index, 3>& triangle : this->Change.Added)
    {
      this->AddAll(triangle,
        [&](Index point) -> const Point3&
        { return point == this->Change.Point ? this->Change.Place : this->Points[point]; });
    }
    return this->Sharpest();
  }

private:
  std::array<Index, 3> CornersOf(Index triangle) const
  {
    return { this->Corners.VertexOf(3 * triangle), this->Corners.VertexOf(3 * triangle + 1),
      this->Corners.VertexOf(3 * triangle + 2) };
  }

  bool IsRemoved(Index triangle) const
  {
    const std::vector<Index>& removed = this->Change.Removed;
    return std::find(removed.begin(), removed.end(), triangle) != removed.end();
  }

  /// Adds the side from a to b of a triangle.
  void Add(Index a, Index b, const Point3& normal)
  {
    const Index from = this->Borders.SiteOf(a), to = this->Borders.SiteOf(b);
    this->Sides.push_back(
      { { std::min(from, to), std::max(from, to) }, from < to ? normal : -1.0 * normal });
  }

  template <typename Place>
  void AddAll(const std::array<Index, 3>& t, Place&& placeOf)
  {
    const Point3 normal = AreaOf({ placeOf(t[0]), placeOf(t[1]), placeOf(t[2]) });
    for (int i = 0; i < 3; ++i)
    {
      this->Add(t[i], t[(i + 1) % 3], normal);
    }
  }

  /// Adds the edge of a corner.
  void AddEdge(Index corner)
  {
    const auto [p, q, r] = this->CornersOf(corner / 3);
    this->Add(this->Corners.StartOf(corner), this->Corners.EndOf(corner),
      AreaOf({ this->Points[p], this->Points[q], this->Points[r] }));
  }

  /// Adds a curve between two points, as a side of all triangles that stay.
  void AddCurve(Index a, Index b)
  {
    const Index from = this->Borders.SiteOf(a), to = this->Borders.SiteOf(b);
    const std::array<Index, 2> ends{ std::min(from, to), std::max(from, to) };
    if (std::any_of(this->Sides.begin(), this->Sides.end(),
          [&](const Side& side) { return side.Ends == ends; }))
    {
      return; // it was added from its other side
    }
    this->Borders.ForCopiesOf(a,
      [&](Index p) { this->Borders.ForCopiesOf(b, [&](Index q) { this->AddBothSides(p, q); }); });
  }

  /// Adds an edge of the table as a side of its triangles that stay, if there is one.
  void AddBothSides(Index p, Index q)
  {
    const Index edge = this->Corners.FindEdge(p, q);
    if (edge < 0)
    {
      return;
    }
    for (const Index corner : { edge, this->Corners.OppositeOf(edge) })
    {
      if (!this->IsRemoved(corner / 3) && !this->Borders.IsBeyond(this->Corners, corner / 3))
      {
        this->AddEdge(corner);
      }
    }
  }

  /// Adds one side of each triangle around those that are removed: the one at which they meet.
  void AddBeside()
  {
    this->Sides.clear();
    for (const Index triangle : this->Change.Removed)
    {
      for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
      {
        const Index across = this->Corners.OppositeOf(corner);
        if (this->Corners.IsCurve(corner))
        {
          this->AddCurve(this->Corners.StartOf(corner), this->Corners.EndOf(corner));
        }
        else if (!this->IsRemoved(across / 3))
        {
          this->AddEdge(across);
        }
      }
    }
  }

  /// The least cosine of the angle between normals at a side.
  double Sharpest()
  {
    std::stable_sort(this->Sides.begin(), this->Sides.end(),
      [](const Side& a, const Side& b) { return a.Ends < b.Ends; });
    double sharpest = 1.0;
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      for (std::size_t k = i + 1;
           k < this->Sides.size() && this->Sides[k].Ends == this->Sides[i].Ends; ++k)
      {
        // One of two neighbours runs through the side the other way.
        sharpest = std::min(sharpest, -CosineBetween(this->Sides[i].Normal, this->Sides[k].Normal));
      }
    }
    return sharpest;
  }

  const CornerTable& Corners;
  const std::vector<Point3>& Points;
  const SurfaceChange& Change;
  const SheetBorders& Borders;
  std::vector<Side> Sides;
};
}

FoldChange MeasureFolds(const CornerTable& corners, const std::vector<Point3>& points,
  const SurfaceChange& change, const SheetBorders& borders)
{
  SidesAround sides(corners, points, change, borders);
  return { sides.SharpestBefore(), sides.SharpestAfter() };
}

bool IsFolded(const CornerTable& corners, const std::vector<Point3>& points, Index corner)
{
  const auto areaAt = [&](Index at)
  {
    return AreaOf(
      { points[corners.VertexOf(at)], points[corners.StartOf(at)], points[corners.EndOf(at)] });
  };
  const Point3 own = areaAt(corner), across = areaAt(corners.OppositeOf(corner));
  const double product = Dot(own, across);
  return product < 0.0 &&
    product * product > FoldCosine * FoldCosine * Dot(own, own) * Dot(across, across);
}

bool MakesFold(const CornerTable& corners, const std::vector<Point3>& points,
  const SurfaceChange& change, const SheetBorders& borders)
{
  SidesAround sides(corners, points, change, borders);
  const double after = sides.SharpestAfter();
  return after < FoldCosine && after < sides.SharpestBefore();
}
}
