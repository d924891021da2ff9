// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/ThinWalls.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"
#include "Core/Planar/SegmentTree.h"

#include <algorithm>
#include <limits>
#include <set>

namespace orthoslices
{
namespace
{
Index After(const Contours& contours, Index contour, Index vertex)
{
  return vertex + 1 < contours.Offsets[contour + 1] ? vertex + 1 : contours.Offsets[contour];
}

/// The distance from the segment that begins at a vertex.
double DistanceToSegment(const Contours& contours, Index contour, Index vertex, const Point2& x)
{
  const Point2 p{ contours.U[vertex], contours.V[vertex] };
  const Index next = After(contours, contour, vertex);
  const Point2 q{ contours.U[next], contours.V[next] };
  const double square = SquaredDistance(p, q);
  const double share = square > 0.0 ? Dot(x - p, q - p) / square : 0.0;
  return Distance(x, Between(p, q, std::max(0.0, std::min(1.0, share))));
}

/// Whether two contours of a slice cross. The sides of a wall do not; what was drawn twice does.
bool DoCross(const Contours& contours, const Repetition& repetition)
{
  const auto place = [&](Index vertex) { return Point2{ contours.U[vertex], contours.V[vertex] }; };
  bool found = false;
  const SegmentTree tree(contours, { repetition.First, repetition.Second });
  tree.VisitOverlaps(
    [&](SegmentTree::Segment s, SegmentTree::Segment t)
    {
      if (found || s.Contour == t.Contour)
      {
        return;
      }
      const Point2 a = place(s.Vertex), b = place(After(contours, s.Contour, s.Vertex));
      const Point2 c = place(t.Vertex), d = place(After(contours, t.Contour, t.Vertex));
      found = SideOf(a, b, c) * SideOf(a, b, d) < 0 && SideOf(c, d, a) * SideOf(c, d, b) < 0;
    });
  return found;
}

/// Looks for the sides of walls on the slices across.
class WallFinder
{
public:
  explicit WallFinder(const Contours& contours)
    : Set(contours)
  {
  }

  bool IsWallAcross(const Repetition& repetition) const;
  bool HasSlicesAcross(int axis) const;

private:
  Index CountCuts(Index contour) const;
  Index CountCrossings(const Repetition& repetition) const;

  const Contours& Set;
};

bool WallFinder::HasSlicesAcross(int axis) const
{
  for (Index i = 0; i < this->Set.Count(); ++i)
  {
    if (this->Set.Axis[i] != axis && !this->Set.IsVirtual(i))
    {
      return true;
    }
  }
  return false;
}

/// How often a contour crosses the planes of the slices across.
Index WallFinder::CountCuts(Index contour) const
{
  const int axis = this->Set.Axis[contour];
  std::set<std::pair<int, double>> planes;
  for (Index i = 0; i < this->Set.Count(); ++i)
  {
    if (this->Set.Axis[i] != axis && !this->Set.IsVirtual(i))
    {
      planes.emplace(this->Set.Axis[i], this->Set.Coordinate[i]);
    }
  }
  Index count = 0;
  for (const auto& plane : planes)
  {
    const std::vector<double>& along = plane.first == FirstAxis(axis) ? this->Set.U : this->Set.V;
    for (Index i = this->Set.Offsets[contour]; i < this->Set.Offsets[contour + 1]; ++i)
    {
      count +=
        (along[i] > plane.second) != (along[After(this->Set, contour, i)] > plane.second) ? 1 : 0;
    }
  }
  return count;
}

/// How often slices across cross the plane of two contours beside one of them.
Index WallFinder::CountCrossings(const Repetition& repetition) const
{
  const int axis = this->Set.Axis[repetition.First];
  const double height = this->Set.Coordinate[repetition.First];
  Index count = 0, start = 0;
  for (Index contour = 0; contour < this->Set.Count(); ++contour)
  {
    const int across = this->Set.Axis[contour];
    if (across == axis || this->Set.IsVirtual(contour))
    {
      continue;
    }
    const bool isFirst = FirstAxis(across) == axis;
    const std::vector<double>& up = isFirst ? this->Set.U : this->Set.V;
    const std::vector<double>& along = isFirst ? this->Set.V : this->Set.U;
    for (Index i = this->Set.Offsets[contour]; i < this->Set.Offsets[contour + 1]; ++i)
    {
      const Index j = After(this->Set, contour, i);
      if ((up[i] > height) == (up[j] > height))
      {
        continue;
      }
      const double place = along[i] + (height - up[i]) / (up[j] - up[i]) * (along[j] - along[i]);
      const double coordinate = this->Set.Coordinate[contour];
      const Point2 x =
        across == FirstAxis(axis) ? Point2{ coordinate, place } : Point2{ place, coordinate };
      count += DistanceToContour(this->Set, repetition.First, x, 2.0 * repetition.Limit, start) <=
          2.0 * repetition.Limit
        ? 1
        : 0;
    }
  }
  return count;
}

/// Whether slices across have a wall there.
bool WallFinder::IsWallAcross(const Repetition& repetition) const
{
  const Index ofOne = this->CountCuts(repetition.First);
  const Index ofBoth = ofOne + this->CountCuts(repetition.Second);
  return ofBoth > 0 && 2 * this->CountCrossings(repetition) > ofOne + ofBoth;
}
}

double DistanceToContour(
  const Contours& contours, Index contour, const Point2& x, double limit, Index& start)
{
  constexpr Index around = 8; // segments that are looked at even if one before is near enough
  const Index first = contours.Offsets[contour];
  const Index count = contours.Size(contour);
  double least = std::numeric_limits<double>::infinity();
  Index best = start;
  for (Index i = 0; i < count && (i < around || least > limit); ++i)
  {
    // 0, 1, -1, 2, -2, ...
    const Index step = i % 2 == 0 ? count - i / 2 : (i + 1) / 2;
    const Index vertex = first + (start + step) % count;
    const double distance = DistanceToSegment(contours, contour, vertex, x);
    if (distance < least)
    {
      least = distance;
      best = vertex - first;
    }
  }
  start = best;
  return least;
}

std::vector<std::uint8_t> FindWalls(
  const Contours& contours, const std::vector<Repetition>& repetitions, const Execution& execution)
{
  const WallFinder finder(contours);
  std::array<bool, 3> hasAcross{};
  for (int axis = 0; axis < 3; ++axis)
  {
    hasAcross[axis] = finder.HasSlicesAcross(axis);
  }
  std::set<std::pair<int, Index>> opposite;
  for (const Repetition& repetition : repetitions)
  {
    if (repetition.IsOpposite)
    {
      opposite.emplace(contours.Axis[repetition.First], contours.Plane[repetition.First]);
    }
  }
  std::vector<std::uint8_t> walls(repetitions.size(), 0);
  execution.For(repetitions.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Repetition& repetition = repetitions[i];
        const int axis = contours.Axis[repetition.First];
        const Index plane = contours.Plane[repetition.First];
        const bool isBetweenAlike =
          opposite.count({ axis, plane - 1 }) + opposite.count({ axis, plane + 1 }) > 0;
        walls[i] = repetition.Limit > 0.0 &&
          (hasAcross[axis] ? finder.IsWallAcross(repetition)
                           : repetition.IsOpposite && isBetweenAlike) &&
          !DoCross(contours, repetition);
      }
    });
  return walls;
}
}
