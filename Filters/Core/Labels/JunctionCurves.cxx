// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/JunctionCurves.h"

#include "Core/Base/Vectors.h"
#include "Core/Labels/JunctionFit.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The most parts of a curve in which structures meet.
constexpr Index MaxParts = 16;

std::vector<std::pair<Index, Index>> SidesOf(const CellPatch& patch)
{
  std::vector<std::pair<Index, Index>> sides;
  patch.VisitSides([&](Index a, Index b) { sides.emplace_back(a, b); });
  return sides;
}

/// The border of what two patches cover without what both of them do.
std::vector<std::pair<Index, Index>> SidesOfRest(const CellPatch& a, const CellPatch& b)
{
  std::map<CellEdge, bool> sidesOfB; // whether they run from the lesser end
  b.VisitSides([&](Index p, Index q) { sidesOfB[CellEdgeOf(p, q)] = p < q; });
  std::vector<std::pair<Index, Index>> sides;
  Index alike = 0, opposite = 0;
  a.VisitSides(
    [&](Index p, Index q)
    {
      const auto found = sidesOfB.find(CellEdgeOf(p, q));
      if (found == sidesOfB.end())
      {
        sides.emplace_back(p, q);
        return;
      }
      ++(found->second == (p < q) ? alike : opposite);
      sidesOfB.erase(found);
    });
  for (const auto& [edge, ascends] : sidesOfB)
  {
    const bool forward = ascends != (alike > opposite);
    sides.push_back(forward ? edge : CellEdge{ edge.second, edge.first });
  }
  return sides;
}

/// The curve in which some patches of a group end.
JunctionCurve MakeCurve(
  const PatchGroup& group, const CellEdge& ends, const PatchGroup& ending, StructurePatches& cell)
{
  const Point3 first = cell.PlaceOf(ends.first), last = cell.PlaceOf(ends.second);
  JunctionFit fit(first, last);
  JunctionCurve curve{ ends.first, ends.second, {}, {}, {} };
  const auto tryBorder = [&](const std::vector<std::pair<Index, Index>>& sides)
  {
    std::vector<BorderSide> border;
    for (const auto& [a, b] : sides)
    {
      border.push_back({ cell.PlaceOf(a), cell.PlaceOf(b) });
    }
    if (fit.Try(border))
    {
      curve.OnSurface.clear();
      for (const auto& [a, b] : sides)
      {
        curve.OnSurface.insert(CellEdgeOf(a, b));
      }
    }
  };
  for (std::size_t i = 0; i < ending.size(); ++i)
  {
    tryBorder(SidesOf(cell[ending[i]]));
    for (std::size_t j = i + 1; j < ending.size(); ++j)
    {
      tryBorder(SidesOfRest(cell[ending[i]], cell[ending[j]]));
    }
  }
  PatchBorder inside;
  inside.Room = cell.RoomOf(group);
  const double length = Length(last - first);
  const Index parts = static_cast<Index>(
    std::max(2.0, std::min(double(MaxParts), std::ceil(length / cell.EdgeLength(group)))));
  for (Index i = 1; i < parts; ++i)
  {
    Point3 place, normal;
    fit.Evaluate(double(i) / parts, place, normal);
    curve.Inside.push_back(cell.NumberOf(inside.MoveInside(cell.GridOf(group), place)));
    curve.Normals.push_back(normal);
  }
  return curve;
}
}

std::vector<JunctionCurve> FindJunctionCurves(const PatchGroup& group, StructurePatches& patches)
{
  std::map<CellEdge, PatchGroup> ending; // patches by where they part from others
  for (const Index patch : group)
  {
    const std::vector<Index> ends = patches.PartingPoints(patch);
    if (ends.size() == 2)
    {
      ending[CellEdgeOf(ends[0], ends[1])].push_back(patch);
    }
  }
  std::vector<JunctionCurve> curves;
  for (const auto& [ends, members] : ending)
  {
    curves.push_back(MakeCurve(group, ends, members, patches));
  }
  return curves;
}
}
