// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Patches/Domes.h"

#include "Core/Base/QuadraticFit.h"
#include "Core/Base/Vectors.h"
#include "Core/Patches/CentralPoints.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Component along the axis of the unit normals from which a surface is a height function over the
/// slice. Less, and it is upright within the error of normals, about 0.1 radians at worst.
constexpr double MinUpward = 0.1;

/// Weight of the loop in the fit, where that of the polygon's border and that of its normals are 1:
/// the loop is nearest to the top of the dome, and the quadratic must pass through it.
constexpr double WeightOfLoop = 10.0;

/**
 * What the last section encloses, as a part of the section before, from which the object ends flat.
 * A ball of radius R cut at distance h has at most (n - 1) / (2 n - 4) there, n = 2 R / h: 0.75 for
 * four slices, less for more; a cone has a quarter. A vessel that was cut off, or a bone that
 * tapers, has 0.93 to 0.96: a dome is closer to those. The rest is left for noise.
 */
constexpr double MinShareOfFlatEnd = 0.98;

/// A loop as its dome has it.
struct DomeBase
{
  int Axis = 2;
  double Up = 1.0; ///< or -1: where the dome is
  Point3 Center{};
  double Radius = 0.0;
  double Area = 0.0; ///< positive if the loop runs anticlockwise around its inside
  std::vector<Point3> Points;

  void Set(const CycleGeometry& geometry, Index cycle);
  /// Along the axes of the slice and upwards.
  Point3 ToLocal(const Point3& d) const
  {
    return { d[FirstAxis(this->Axis)], d[SecondAxis(this->Axis)], this->Up * d[this->Axis] };
  }
  double HeightOf(const double* centralPoint) const
  {
    return this->Up * (centralPoint[this->Axis] - this->Center[this->Axis]);
  }
};

void DomeBase::Set(const CycleGeometry& geometry, Index cycle)
{
  const NodeGraph& graph = geometry.Graph;
  const Index arc = geometry.FirstArc(cycle).Arc, first = graph.FirstPoint(arc);
  this->Axis = graph.Loops[geometry.LoopOf(cycle)].Axis;
  this->Up = geometry.FirstArc(cycle).Above ? 1.0 : -1.0;
  this->Points.clear();
  for (Index i = 0; i < graph.PointCount(arc); ++i)
  {
    this->Points.push_back(graph.PointAt(first + i));
  }
  const std::size_t n = this->Points.size();
  CurveCenter center(this->Points[0]);
  for (std::size_t i = 0; i < n; ++i)
  {
    center.Add(this->Points[i], this->Points[(i + 1) % n]);
  }
  this->Center = center.Get();
  double radius2 = 0.0;
  this->Area = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point3 d = this->Points[i] - this->Center, e = this->Points[(i + 1) % n] - this->Center;
    radius2 += Dot(d, d) / static_cast<double>(n);
    this->Area += 0.5 * Cross(d, e)[this->Axis];
  }
  this->Radius = std::sqrt(radius2);
}

/// Fits the height of the dome over a loop to the polygon on the loop's other side.
class DomeFit
{
public:
  DomeFit(const CycleGeometry& geometry, const std::vector<double>& nodeNormals)
    : Geometry(geometry)
    , NodeNormals(nodeNormals)
  {
  }

  double HeightOver(const DomeBase& base, Index polygon);

private:
  Point3 NormalAt(Index node) const
  {
    const double* n = this->NodeNormals.data() + 3 * static_cast<std::size_t>(node);
    return { n[0], n[1], n[2] };
  }
  bool IsHeightFunction(const DomeBase& base) const;

  const CycleGeometry& Geometry;
  const std::vector<double>& NodeNormals;
  std::vector<Index> Border, NodePlaces;
};

/// Whether the surface at all node points faces up or all down.
bool DomeFit::IsHeightFunction(const DomeBase& base) const
{
  double side = 0.0;
  for (const Index place : this->NodePlaces)
  {
    const Point3 normal = this->NormalAt(this->Border[place]);
    const double up = normal[base.Axis];
    if (!(std::abs(up) > MinUpward * Length(normal)) || up * side < 0.0)
    {
      return false;
    }
    side = up;
  }
  return !this->NodePlaces.empty();
}

/// The height of the dome over the middle of the loop; 0 if the polygon tells none.
double DomeFit::HeightOver(const DomeBase& base, Index polygon)
{
  this->Geometry.GetBoundary(polygon, this->Border, this->NodePlaces);
  if (!this->IsHeightFunction(base))
  {
    return 0.0;
  }
  const std::size_t n = this->Border.size();
  std::vector<Point3> places(n);
  double unit = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    places[i] = base.ToLocal(this->Geometry.Graph.PointAt(this->Border[i]) - base.Center);
    unit = std::max(unit, Length(places[i]));
  }
  QuadraticFit fit;
  std::vector<double> weights;
  WeighByLength(places, weights);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point3 p = (1.0 / unit) * places[i];
    fit.AddPoint(p[0], p[1], p[2], weights[i]);
  }
  for (const Index place : this->NodePlaces)
  {
    const Point3 p = (1.0 / unit) * places[place];
    const Point3 normal = base.ToLocal(this->NormalAt(this->Border[place]));
    fit.AddNormal(p[0], p[1], normal, 1.0 / static_cast<double>(this->NodePlaces.size()));
  }
  for (const Point3& point : base.Points)
  {
    const Point3 p = (1.0 / unit) * base.ToLocal(point - base.Center);
    fit.AddPoint(p[0], p[1], p[2], WeightOfLoop / static_cast<double>(base.Points.size()));
  }
  return unit * fit.HeightAtOrigin();
}

/// The cycles of each loop, below its slice and above.
std::vector<std::array<Index, 2>> SidesOfLoops(const CycleGeometry& geometry)
{
  std::vector<std::array<Index, 2>> sides(geometry.Graph.Loops.size(), { -1, -1 });
  for (Index cycle = 0; cycle < geometry.Cycles.Count() && !sides.empty(); ++cycle)
  {
    if (geometry.IsLoop(cycle))
    {
      sides[geometry.LoopOf(cycle)][geometry.FirstArc(cycle).Above ? 1 : 0] = cycle;
    }
  }
  return sides;
}

/// The areas that the loops of a patch enclose on the slice below it and on the one above.
std::array<double, 2> AreasAtEnds(const CycleGeometry& geometry, const PatchMesh& patch)
{
  std::array<double, 2> areas{ 0.0, 0.0 };
  DomeBase base;
  for (const Index cycle : patch.Cycles)
  {
    base.Set(geometry, cycle);
    areas[geometry.FirstArc(cycle).Above ? 0 : 1] += base.Area;
  }
  return { std::abs(areas[0]), std::abs(areas[1]) };
}

/// For each cycle, 1 if it is that of a loop on the last slice beyond which the object ends flat.
std::vector<std::uint8_t> FindFlatEnds(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& stitched)
{
  const std::vector<std::array<Index, 2>> sides = SidesOfLoops(geometry);
  std::vector<std::uint8_t> isFlat(static_cast<std::size_t>(geometry.Cycles.Count()), 0);
  for (const PatchMesh& patch : stitched)
  {
    const std::array<double, 2> areas = AreasAtEnds(geometry, patch);
    for (const Index cycle : patch.Cycles)
    {
      const bool above = geometry.FirstArc(cycle).Above;
      const double last = areas[above ? 0 : 1], before = areas[above ? 1 : 0];
      const Face& loop = geometry.Graph.Loops[geometry.LoopOf(cycle)];
      const bool isLast = loop.Plane == (above ? 0 : geometry.Grid.Count(loop.Axis) - 1);
      if (isLast && before > 0.0 && last >= MinShareOfFlatEnd * before)
      {
        isFlat[sides[geometry.LoopOf(cycle)][above ? 0 : 1]] = 1;
      }
    }
  }
  return isFlat;
}

/// Whether a patch has loops on both slices of its slab.
bool GoesOn(const CycleGeometry& geometry, const PatchMesh& patch)
{
  const auto isAbove = [&](Index cycle) { return geometry.FirstArc(cycle).Above; };
  return std::any_of(patch.Cycles.begin(), patch.Cycles.end(), isAbove) &&
    !std::all_of(patch.Cycles.begin(), patch.Cycles.end(), isAbove);
}

/// For each cycle, 1 if it is one of a lid: of a patch that ends the object on one side of a slice,
/// while it goes on beyond the other side of one of the patch's loops.
std::vector<std::uint8_t> FindLids(
  const CycleGeometry& geometry, const std::vector<PatchMesh>& stitched)
{
  std::vector<std::uint8_t> goesOn(static_cast<std::size_t>(geometry.Cycles.Count()), 0);
  std::vector<std::uint8_t> isLid(goesOn.size(), 0), isMember(goesOn.size(), 0);
  for (const PatchMesh& patch : stitched)
  {
    for (const Index cycle : patch.Cycles)
    {
      goesOn[cycle] = GoesOn(geometry, patch) ? 1 : 0;
      isMember[cycle] = 1;
    }
  }
  const std::vector<std::array<Index, 2>> sides = SidesOfLoops(geometry);
  const auto endsHere = [&](Index cycle)
  {
    const Index across = sides[geometry.LoopOf(cycle)][geometry.FirstArc(cycle).Above ? 0 : 1];
    return goesOn[cycle] == 0 && goesOn[across] != 0;
  };
  for (const PatchMesh& patch : stitched)
  {
    const bool ends = std::any_of(patch.Cycles.begin(), patch.Cycles.end(), endsHere);
    for (const Index cycle : patch.Cycles)
    {
      isLid[cycle] = ends ? 1 : 0;
    }
  }
  for (Index cycle = 0; cycle < geometry.Cycles.Count(); ++cycle)
  {
    isLid[cycle] |= isMember[cycle] == 0 && endsHere(cycle) ? 1 : 0;
  }
  return isLid;
}

/// Moves what is marked, central points and whole patches, next to the slice.
void Flatten(const CycleGeometry& geometry, const std::vector<std::uint8_t>& isFlat,
  std::vector<PatchMesh>& stitched, std::vector<double>& centralPoints)
{
  const CellCycles& cycles = geometry.Cycles;
  const auto heightOf = [&](Index cycle)
  {
    const Face& loop = geometry.Graph.Loops[geometry.LoopOf(cycle)];
    return geometry.Grid.MoveInside(loop.Axis, cycles.Cell[cycle][loop.Axis],
      geometry.Grid.Planes[loop.Axis][loop.Plane], CentralPointMargin);
  };
  for (Index cycle = 0; cycle < cycles.Count(); ++cycle)
  {
    if (isFlat[cycle] != 0)
    {
      const int axis = geometry.Graph.Loops[geometry.LoopOf(cycle)].Axis;
      centralPoints[3 * static_cast<std::size_t>(cycle) + axis] = heightOf(cycle);
    }
  }
  for (PatchMesh& patch : stitched)
  {
    if (std::all_of(patch.Cycles.begin(), patch.Cycles.end(),
          [&](Index cycle) { return isFlat[cycle] != 0; }))
    {
      const Index cycle = patch.Cycles.front();
      for (Point3& point : patch.Points)
      {
        point[geometry.Graph.Loops[geometry.LoopOf(cycle)].Axis] = heightOf(cycle);
      }
    }
  }
}
}

void LowerDomes(const CycleGeometry& geometry, const CellGroups& cells,
  const std::vector<double>& nodeNormals, std::vector<double>& centralPoints)
{
  const CellCycles& cycles = geometry.Cycles;
  const std::vector<std::array<Index, 2>> sides = SidesOfLoops(geometry);
  DomeFit fit(geometry, nodeNormals);
  DomeBase base;
  for (const auto& range : cells.Several)
  {
    const auto begin = cells.Cycles.begin() + range.first,
               end = cells.Cycles.begin() + range.second;
    const auto isPolygon = [&](Index cycle) { return !geometry.IsLoop(cycle); };
    if (sides.empty() || std::count_if(begin, end, isPolygon) != 1)
    {
      continue;
    }
    const Index polygon = *std::find_if(begin, end, isPolygon);
    for (auto cycle = begin; cycle != end; ++cycle)
    {
      const Index dome = *cycle == polygon
        ? -1
        : sides[geometry.LoopOf(*cycle)][geometry.FirstArc(*cycle).Above ? 0 : 1];
      if (dome < 0)
      {
        continue;
      }
      base.Set(geometry, dome);
      double* apex = centralPoints.data() + 3 * static_cast<std::size_t>(dome);
      const double height = fit.HeightOver(base, polygon);
      if (height > 0.0 && height < base.HeightOf(apex))
      {
        const double place = base.Center[base.Axis] + base.Up * height;
        apex[base.Axis] = geometry.Grid.MoveInside(
          base.Axis, cycles.Cell[dome][base.Axis], place, CentralPointMargin);
      }
    }
  }
}

void FlattenEnds(const CycleGeometry& geometry, std::vector<PatchMesh>& stitched,
  std::vector<double>& centralPoints)
{
  Flatten(geometry, FindFlatEnds(geometry, stitched), stitched, centralPoints);
}

void FlattenLids(const CycleGeometry& geometry, std::vector<PatchMesh>& stitched,
  std::vector<double>& centralPoints)
{
  if (FindOnlyFamily(geometry.Grid) >= 0)
  {
    Flatten(geometry, FindLids(geometry, stitched), stitched, centralPoints);
  }
}

std::vector<double> TiltOfDomes(const CycleGeometry& geometry,
  const std::vector<double>& centralPoints, const std::vector<PatchMesh>& meshes)
{
  std::vector<double> tilts(geometry.Graph.Loops.size(), 0.0);
  if (tilts.empty())
  {
    return tilts;
  }
  std::vector<std::uint8_t> isJoined(static_cast<std::size_t>(geometry.Cycles.Count()), 0);
  for (const PatchMesh& mesh : meshes)
  {
    for (const Index cycle : mesh.Cycles)
    {
      isJoined[cycle] = 1;
    }
  }
  std::vector<int> domes(tilts.size(), 0);
  DomeBase base;
  for (Index cycle = 0; cycle < geometry.Cycles.Count(); ++cycle)
  {
    if (!geometry.IsLoop(cycle) || isJoined[cycle] != 0)
    {
      continue;
    }
    base.Set(geometry, cycle);
    const double height = base.HeightOf(centralPoints.data() + 3 * static_cast<std::size_t>(cycle));
    const double a = base.Radius * base.Radius, b = height * height;
    // Contours run anticlockwise around what is inside.
    const double outwards = base.Area > 0.0 ? base.Up : -base.Up;
    const Index loop = geometry.LoopOf(cycle);
    tilts[loop] = a + b > 0.0 && domes[loop] == 0 ? outwards * (a - b) / (a + b) : 0.0;
    ++domes[loop];
  }
  return tilts;
}
}
