// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Crossings/NodeNormals.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/**
 * Half the length of contour over which a tangent is measured, as a part of the mean plane spacing.
 * Over less, noise of the contours would turn it: 1 % of the spacing by 0.1 radians. Over more, the
 * contour bends: the parabola's error is a sixth of the window's square by that of the radius, 1 % at
 * a radius of 0.4 spacings, less than slices can resolve.
 */
constexpr double TangentWindow = 0.1;

/**
 * Tangent of a contour at a crossing in its slice (u, v), of unit length: derivative of the
 * parabola through the crossing and one vertex on each side of it, at least TangentWindow away where
 * the contour goes so far.
 */
class TangentAtCrossing
{
public:
  TangentAtCrossing(const Contours& contours, const SpatialGrid& grid, const GridEdgeCode& code,
    const GridCrossings& crossings)
    : Set(contours)
    , Grid(grid)
    , Code(code)
    , Crossings(crossings)
  {
  }

  /// World direction of the contour at a crossing; zero for a crossing without a contour.
  Point3 operator()(Index crossing) const;

private:
  using Vector2 = std::array<double, 2>;
  Vector2 Farther(Index contour, Index vertex, int step, const Vector2& from, double window) const;

  const Contours& Set;
  const SpatialGrid& Grid;
  const GridEdgeCode& Code;
  const GridCrossings& Crossings;
};

/// The difference to the first vertex, from the given one on, that is at least `window` away.
TangentAtCrossing::Vector2 TangentAtCrossing::Farther(
  Index contour, Index vertex, int step, const Vector2& from, double window) const
{
  const Index begin = this->Set.Offsets[contour];
  const Index size = this->Set.Size(contour);
  Index i = vertex - begin;
  Vector2 difference{ 0.0, 0.0 };
  double length = 0.0;
  double previous = -1.0;
  // Stop where the contour turns back, too, and after a third of it: both sides stay apart.
  for (Index n = 0; n < size / 3 + 1 && length < window && length > previous; ++n)
  {
    previous = n == 0 ? -1.0 : length;
    difference = { this->Set.U[begin + i] - from[0], this->Set.V[begin + i] - from[1] };
    length = std::sqrt(difference[0] * difference[0] + difference[1] * difference[1]);
    i = (i + step + size) % size;
  }
  return difference;
}

Point3 TangentAtCrossing::operator()(Index crossing) const
{
  const Index contour = this->Crossings.RunContour[crossing];
  if (contour == GridCrossings::None)
  {
    return { 0.0, 0.0, 0.0 };
  }
  const int u = FirstAxis(this->Set.Axis[contour]);
  const int v = SecondAxis(this->Set.Axis[contour]);
  const Point3 at = CrossingPoint(
    this->Grid, this->Code, this->Crossings.Edge[crossing], this->Crossings.Position[crossing]);
  const Vector2 from{ at[u], at[v] };
  const double window =
    TangentWindow * std::min(this->Grid.MeanSpacing(u), this->Grid.MeanSpacing(v));
  const Index after = this->Crossings.RunFirst[crossing];
  const Index begin = this->Set.Offsets[contour];
  const Index before = after == begin ? this->Set.Offsets[contour + 1] - 1 : after - 1;
  const Vector2 f = this->Farther(contour, after, 1, from, window);
  const Vector2 b = this->Farther(contour, before, -1, from, window);
  const double df = std::hypot(f[0], f[1]);
  const double db = std::hypot(b[0], b[1]);
  const double wf = df > 0.0 ? db / df : 0.0;
  const double wb = db > 0.0 ? df / db : 0.0;
  Point3 tangent{ 0.0, 0.0, 0.0 };
  tangent[u] = f[0] * wf - b[0] * wb;
  tangent[v] = f[1] * wf - b[1] * wb;
  if (df == 0.0 || db == 0.0)
  {
    tangent[u] = f[0] - b[0];
    tangent[v] = f[1] - b[1];
  }
  const double length = Length(tangent);
  return length > 0.0 ? (1.0 / length) * tangent : Point3{ 0.0, 0.0, 0.0 };
}
}

Point3 RightOf(const Point3& along, int axis)
{
  Point3 up{ 0.0, 0.0, 0.0 };
  up[axis] = 1.0;
  return Cross(along, up);
}

Point3 OutwardNormal(const Point3& first, int firstAxis, const Point3& second, int secondAxis)
{
  const Point3 normal = Cross(first, second);
  const double outwards = Dot(normal, RightOf(first, firstAxis));
  if (!(outwards * Dot(normal, RightOf(second, secondAxis)) > 0.0))
  {
    return { 0.0, 0.0, 0.0 };
  }
  return outwards > 0.0 ? normal : -1.0 * normal;
}

std::vector<double> ComputeNodeNormals(const Contours& contours, const SpatialGrid& grid,
  const GridCrossings& crossings, const NodePoints& nodes, const Execution& execution)
{
  const GridEdgeCode code(grid);
  const TangentAtCrossing tangent(contours, grid, code, crossings);
  std::vector<double> normals(3 * static_cast<std::size_t>(nodes.Count()), 0.0);
  execution.For(nodes.Count(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t node = begin; node < end; ++node)
      {
        const Index first = nodes.First[node];
        const int t = code.Decode(crossings.Edge[first]).Direction;
        const Point3 normal =
          OutwardNormal(tangent(first), FirstAxis(t), tangent(nodes.Second[node]), SecondAxis(t));
        std::copy(normal.begin(), normal.end(), normals.begin() + 3 * node);
      }
    });
  return normals;
}
}
