// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/JunctionStar.h"

#include "Core/Base/Vectors.h"
#include "Core/Labels/JunctionFit.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The most parts of a curve, and the most patches of which surfaces around several are tried.
constexpr double MaxParts = 8.0;
constexpr std::size_t MaxPatches = 6;

using Sides = std::vector<std::pair<Index, Index>>;

/// The border of what some patches of a group, by the bits of `chosen`, surround together; empty if
/// two of them have a side in the same direction, so that one is within the other.
Sides BorderOfSome(const PatchGroup& group, unsigned chosen, const StructurePatches& cell)
{
  std::map<CellEdge, int> count; // how much more often from the lesser end than to it
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    if ((chosen >> i & 1u) != 0)
    {
      cell[group[i]].VisitSides(
        [&](Index a, Index b) { count[CellEdgeOf(a, b)] += a < b ? 1 : -1; });
    }
  }
  Sides sides;
  for (const auto& [edge, times] : count)
  {
    if (std::abs(times) > 1)
    {
      return {};
    }
    if (times != 0)
    {
      sides.push_back(times > 0 ? edge : CellEdge{ edge.second, edge.first });
    }
  }
  return sides;
}

/// Looks for the smoothest surface of a group.
class StarFinder
{
public:
  StarFinder(const PatchGroup& group, StructurePatches& patches)
    : Group(group)
    , Cell(patches)
    , Fit({}, {})
  {
    for (const Index patch : group)
    {
      const std::vector<Index> points = patches.PartingPoints(patch);
      this->Parting.insert(points.begin(), points.end());
    }
  }

  bool Run(JunctionStar& star);

private:
  bool FindSurface();
  JunctionCurve MakeCurve(Index from, Index to);

  const PatchGroup& Group;
  StructurePatches& Cell;
  JunctionFit Fit;
  std::set<Index> Parting;      ///< where borders part
  std::vector<Index> OnSurface; ///< of these, the ones on the surface
  std::set<CellEdge> Border;    ///< of the surface
};

bool StarFinder::FindSurface()
{
  const Point3 first = this->Cell.PlaceOf(*this->Parting.begin());
  const auto last = std::max_element(this->Parting.begin(), this->Parting.end(),
    [&](Index a, Index b)
    { return Length(this->Cell.PlaceOf(a) - first) < Length(this->Cell.PlaceOf(b) - first); });
  this->Fit = JunctionFit(first, this->Cell.PlaceOf(*last));
  for (unsigned chosen = 1; chosen < 1u << this->Group.size(); ++chosen)
  {
    const Sides sides = BorderOfSome(this->Group, chosen, this->Cell);
    std::set<Index> points;
    std::vector<BorderSide> border;
    for (const auto& [a, b] : sides)
    {
      points.insert(a);
      border.push_back({ this->Cell.PlaceOf(a), this->Cell.PlaceOf(b) });
    }
    std::vector<Index> common;
    std::set_intersection(this->Parting.begin(), this->Parting.end(), points.begin(), points.end(),
      std::back_inserter(common));
    // Around a border that is one closed curve, every point begins one side.
    if (common.size() > 2 && points.size() == sides.size() && this->Fit.Try(border))
    {
      this->OnSurface = common;
      this->Border.clear();
      for (const auto& [a, b] : sides)
      {
        this->Border.insert(CellEdgeOf(a, b));
      }
    }
  }
  return !this->OnSurface.empty();
}

/// From a point at which borders part to the point where all curves meet.
JunctionCurve StarFinder::MakeCurve(Index from, Index to)
{
  const Point3 first = this->Cell.PlaceOf(from), last = this->Cell.PlaceOf(to);
  const bool isOn =
    std::find(this->OnSurface.begin(), this->OnSurface.end(), from) != this->OnSurface.end();
  const Index parts = static_cast<Index>(std::max(
    2.0, std::min(MaxParts, std::ceil(Length(last - first) / this->Cell.EdgeLength(this->Group)))));
  PatchBorder inside;
  inside.Room = this->Cell.RoomOf(this->Group);
  JunctionCurve curve{ from, to, {}, {}, {} };
  for (Index i = 1; i < parts; ++i)
  {
    const double share = static_cast<double>(i) / parts;
    Point3 place = Between(first, last, share), normal{ 0.0, 0.0, 0.0 };
    if (isOn)
    {
      this->Fit.EvaluateBetween(first, last, share, place, normal);
    }
    curve.Inside.push_back(
      this->Cell.NumberOf(inside.MoveInside(this->Cell.GridOf(this->Group), place)));
    curve.Normals.push_back(normal);
  }
  if (isOn)
  {
    curve.OnSurface = this->Border;
  }
  return curve;
}

bool StarFinder::Run(JunctionStar& star)
{
  if (this->Parting.size() < 3 || this->Group.size() > MaxPatches || !this->FindSurface())
  {
    return false;
  }
  Point3 middle{ 0.0, 0.0, 0.0 };
  for (const Index point : this->OnSurface)
  {
    middle = middle + (1.0 / this->OnSurface.size()) * this->Cell.PlaceOf(point);
  }
  PatchBorder inside;
  inside.Room = this->Cell.RoomOf(this->Group);
  star.Normal = this->Fit.Project(middle);
  star.Middle = this->Cell.NumberOf(inside.MoveInside(this->Cell.GridOf(this->Group), middle));
  star.OnSurface = this->Border;
  for (const Index point : this->Parting)
  {
    star.CurveFrom.emplace(point, this->MakeCurve(point, star.Middle));
  }
  return true;
}
}

bool FindJunctionStar(const PatchGroup& group, StructurePatches& patches, JunctionStar& star)
{
  return StarFinder(group, patches).Run(star);
}
}
