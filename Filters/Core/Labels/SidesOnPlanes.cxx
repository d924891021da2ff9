// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/SidesOnPlanes.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Base/Vectors.h"
#include "Core/Labels/SliceMembers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace orthoslices
{
namespace
{
using Slice = std::pair<int, double>; ///< axis and coordinate
using Members = std::vector<SliceMember>;

/// Sides that rise more than that in their length pass a plane, and do not lie on it.
constexpr double MostSlope = 0.1;

/// How often a contour runs around a place, counter-clockwise.
int TurnsAround(const Contours& contours, Index contour, const Point2& place)
{
  int turns = 0;
  const Index first = contours.Offsets[contour], end = contours.Offsets[contour + 1];
  for (Index i = first, before = end - 1; i < end; before = i++)
  {
    const Point2 p{ contours.U[before], contours.V[before] }, q{ contours.U[i], contours.V[i] };
    if ((p[1] <= place[1]) != (q[1] <= place[1]))
    {
      const double side = (q[0] - p[0]) * (place[1] - p[1]) - (q[1] - p[1]) * (place[0] - p[0]);
      turns += q[1] > p[1] ? (side > 0.0 ? 1 : 0) : (side < 0.0 ? -1 : 0);
    }
  }
  return turns;
}

/// The sides of one slice that lie on the planes of one of the axes in it.
class SideSettler
{
public:
  SideSettler(const SpatialGrid& grid, double thickness, const std::map<Slice, Members>& slices,
    const std::vector<Contours*>& structures, const Slice& slice)
    : Grid(grid)
    , Thickness(thickness)
    , Slices(slices)
    , Structures(structures)
    , Own(slice)
  {
  }

  /// Where vertices go, along the first or second coordinate of the slice.
  std::map<Point2, double> Run(int across);

private:
  /// Sides that hang together on a plane.
  struct Chain
  {
    double Plane;
    double Below = 0.0, Above = 0.0; ///< lengths that agree with the slice on the plane if there
  };

  int AxisAcross() const
  {
    return this->Across == 0 ? FirstAxis(this->Own.first) : SecondAxis(this->Own.first);
  }
  double PlaneAt(double coordinate) const;
  void AddSides(const Contours& contours, Index structure, Index contour);
  void AddSide(Index structure, const Point2& from, const Point2& to, double plane);
  bool IsDrawn(Index structure, double plane, double along) const;
  Index ChainOf(const Point2& vertex, double plane);

  const SpatialGrid& Grid;
  const double Thickness;
  const std::map<Slice, Members>& Slices;
  const std::vector<Contours*>& Structures;
  const Slice Own;
  int Across = 0; ///< the coordinate in the slice
  std::vector<Chain> Chains;
  DisjointSets Joined;              ///< chains that have become one; the first one has the lengths
  std::map<Point2, Index> Vertices; ///< their chains
};

/// The plane that a coordinate is on; NaN if there is none.
double SideSettler::PlaneAt(double coordinate) const
{
  const std::vector<double>& planes = this->Grid.Planes[this->AxisAcross()];
  const auto next = std::lower_bound(planes.begin(), planes.end(), coordinate - this->Thickness);
  return next != planes.end() && *next <= coordinate + this->Thickness ? *next : std::nan("");
}

bool SideSettler::IsDrawn(Index structure, double plane, double along) const
{
  const int axis = this->AxisAcross();
  const auto slice = this->Slices.find({ axis, plane });
  if (slice == this->Slices.end())
  {
    return false;
  }
  const Point2 place = FirstAxis(axis) == this->Own.first ? Point2{ this->Own.second, along }
                                                          : Point2{ along, this->Own.second };
  int turns = 0;
  for (const SliceMember& member : slice->second)
  {
    turns += member.Structure == structure
      ? TurnsAround(*this->Structures[structure], member.Contour, place)
      : 0;
  }
  return turns > 0;
}

Index SideSettler::ChainOf(const Point2& vertex, double plane)
{
  const auto [at, isNew] = this->Vertices.emplace(vertex, static_cast<Index>(this->Chains.size()));
  if (isNew)
  {
    this->Joined.Add();
    this->Chains.push_back({ plane });
  }
  return this->Joined.Find(at->second);
}

void SideSettler::AddSide(Index structure, const Point2& from, const Point2& to, double plane)
{
  const int along = 1 - this->Across;
  const double length = to[along] - from[along];
  const bool isAbove = (length > 0.0) == (this->Across == 1); // the interior, on the left
  const bool isDrawn = this->IsDrawn(structure, plane, 0.5 * (from[along] + to[along]));
  const Index one = this->ChainOf(from, plane), two = this->ChainOf(to, plane);
  const Index chain = std::min(one, two), other = std::max(one, two);
  if (this->Joined.Unite(chain, other))
  {
    this->Chains[chain].Below += this->Chains[other].Below;
    this->Chains[chain].Above += this->Chains[other].Above;
  }
  (isAbove == isDrawn ? this->Chains[chain].Below : this->Chains[chain].Above) += std::abs(length);
}

void SideSettler::AddSides(const Contours& contours, Index structure, Index contour)
{
  const Index first = contours.Offsets[contour], end = contours.Offsets[contour + 1];
  for (Index i = first, before = end - 1; i < end; before = i++)
  {
    const Point2 from{ contours.U[before], contours.V[before] };
    const Point2 to{ contours.U[i], contours.V[i] };
    const double rise = std::abs(to[this->Across] - from[this->Across]);
    const double plane = this->PlaneAt(from[this->Across]);
    if (plane == this->PlaneAt(to[this->Across]) && // not if there is none
      rise <= MostSlope * std::abs(to[1 - this->Across] - from[1 - this->Across]))
    {
      this->AddSide(structure, from, to, plane);
    }
  }
}

std::map<Point2, double> SideSettler::Run(int across)
{
  this->Across = across;
  for (const SliceMember& member : this->Slices.at(this->Own))
  {
    this->AddSides(*this->Structures[member.Structure], member.Structure, member.Contour);
  }
  const int axis = this->AxisAcross();
  std::map<Point2, double> moved;
  for (const auto& [vertex, number] : this->Vertices)
  {
    const Chain& chain = this->Chains[this->Joined.Find(number)];
    const bool isBelow = vertex[across] < chain.Plane;
    if (chain.Below > chain.Above && !isBelow)
    {
      const Index slab = this->Grid.Slab(axis, chain.Plane) - 1;
      moved.emplace(vertex, this->Grid.MoveInside(axis, slab, chain.Plane));
    }
    else if (chain.Above > chain.Below && isBelow)
    {
      moved.emplace(vertex, chain.Plane);
    }
  }
  return moved;
}

/// Moves the vertices of a contour.
bool MoveVertices(
  const std::array<std::map<Point2, double>, 2>& moved, Index contour, Contours& contours)
{
  bool hasChanged = false;
  for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
  {
    const Point2 vertex{ contours.U[i], contours.V[i] };
    for (int across = 0; across < 2; ++across)
    {
      const auto found = moved[across].find(vertex);
      if (found != moved[across].end())
      {
        (across == 0 ? contours.U : contours.V)[i] = found->second;
        hasChanged = true;
      }
    }
  }
  return hasChanged;
}
}

bool SettleSidesOnPlanes(const SpatialGrid& grid, double thickness, const Execution& execution,
  const std::vector<Contours*>& structures)
{
  std::map<Slice, Members> slices;
  std::vector<Slice> list;
  for (Members& members : ListSlices({ structures.begin(), structures.end() }))
  {
    const Contours& any = *structures[members.front().Structure];
    const Index contour = members.front().Contour;
    list.emplace_back(any.Axis[contour], any.Coordinate[contour]);
    slices.emplace(list.back(), std::move(members));
  }
  std::vector<std::array<std::map<Point2, double>, 2>> moved(list.size());
  execution.For(list.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        for (int across = 0; across < 2; ++across)
        {
          SideSettler settler(grid, thickness, slices, structures, list[i]);
          moved[i][across] = settler.Run(across);
        }
      }
    });
  bool hasChanged = false;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    for (const SliceMember& member : slices.at(list[i]))
    {
      hasChanged |= MoveVertices(moved[i], member.Contour, *structures[member.Structure]);
    }
  }
  return hasChanged;
}
}
