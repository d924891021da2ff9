// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/ComponentSeeds.h"

#include "Core/Base/Box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace orthoslices
{
namespace
{
using Triangle = std::array<Point3, 3>;

/// Where the line of a component's seed begins, and along which axis it runs.
struct SeedLine
{
  static constexpr std::int64_t Elsewhere = -1;
  std::int64_t Triangle = Elsewhere; ///< none yet, or one of another process
  int Axis = 0;
  double Extent =
    0.0; ///< of the triangle, twice, as seen along the axis; negative seen from behind
  Point3 Start{ 0.0, 0.0, 0.0 };
  int Sign = 1;              ///< the direction along the axis
  double Nearest = HUGE_VAL; ///< how far it is to the surface
};

/// Parts of the triangles that are looked at by themselves: few, as each has a value for each
/// component.
constexpr std::int64_t Parts = 16;

/// Values of all components, as parts of so many triangles change them by visit(triangle, values).
template <typename Value, typename Visit>
std::vector<std::vector<Value>> FindInParts(
  std::int64_t count, const std::vector<Value>& values, const Execution& execution, Visit&& visit)
{
  std::vector<std::vector<Value>> parts(Parts, values);
  execution.For(Parts,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t part = begin; part < end; ++part)
      {
        const std::int64_t next = static_cast<std::int64_t>(part) + 1;
        for (std::int64_t i = count * (next - 1) / Parts; i < count * next / Parts; ++i)
        {
          visit(i, parts[part]);
        }
      }
    });
  return parts;
}

/// Takes a triangle for the line if it is wider than the one before.
void Consider(const Triangle& triangle, std::int64_t number, SeedLine& line)
{
  const Point3 normal = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(normal[axis]) > std::abs(line.Extent))
    {
      line.Triangle = number;
      line.Axis = axis;
      line.Extent = normal[axis];
      line.Start = (1.0 / 3.0) * (triangle[0] + triangle[1] + triangle[2]);
    }
  }
}

/// Twice the area of a triangle as seen along an axis; positive if it runs counter-clockwise.
double AreaAlong(int axis, const Point3& a, const Point3& b, const Point3& c)
{
  const int u = FirstAxis(axis), v = SecondAxis(axis);
  return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

/// How far it is along a line, which passes through its box, to where it meets a triangle, whose
/// border counts; infinite if it does not.
double DistanceTo(const Triangle& triangle, const SeedLine& line)
{
  Point3 shares;
  for (int i = 0; i < 3; ++i)
  {
    shares[i] = AreaAlong(line.Axis, triangle[(i + 1) % 3], triangle[(i + 2) % 3], line.Start);
  }
  const double sum = shares[0] + shares[1] + shares[2];
  const auto [least, greatest] = std::minmax({ shares[0], shares[1], shares[2] });
  if ((least < 0.0 && greatest > 0.0) || sum == 0.0)
  {
    return HUGE_VAL;
  }
  double height = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    height += shares[i] / sum * triangle[i][line.Axis];
  }
  const double distance = line.Sign * (height - line.Start[line.Axis]);
  return distance > 0.0 ? distance : HUGE_VAL;
}

/// The lines along one axis in squares of a grid across it, about as many as there are lines: a
/// triangle is compared with the lines beside it alone, however many components there are.
class LineGrid
{
public:
  LineGrid(const std::vector<SeedLine>& lines, int axis)
    : Axes{ FirstAxis(axis), SecondAxis(axis) }
  {
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      if (lines[i].Axis == axis && lines[i].Extent != 0.0)
      {
        own.push_back(i);
        for (int side = 0; side < 2; ++side)
        {
          const double value = lines[i].Start[this->Axes[side]];
          this->Low[side] = std::min(this->Low[side], value);
          this->High[side] = std::max(this->High[side], value);
        }
      }
    }
    this->Count = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(own.size()))));
    this->Sort(own, lines);
  }

  /// Calls visit(line) for each line that passes through a box.
  template <typename Visit>
  void VisitThrough(const Box3& box, Visit&& visit) const
  {
    const auto& [low, high] = box;
    std::array<std::array<std::size_t, 2>, 2> range; // of squares, on both sides
    for (int side = 0; side < 2; ++side)
    {
      const int axis = this->Axes[side];
      if (this->Count == 0 || high[axis] < this->Low[side] || low[axis] > this->High[side])
      {
        return;
      }
      range[side] = { this->SquareOf(side, low[axis]), this->SquareOf(side, high[axis]) };
    }
    for (std::size_t row = range[1][0]; row <= range[1][1]; ++row)
    {
      const std::size_t first = row * this->Count;
      for (std::size_t i = this->Offsets[first + range[0][0]];
           i < this->Offsets[first + range[0][1] + 1]; ++i)
      {
        const GridLine& line = this->Lines[i];
        if (low[this->Axes[0]] <= line.Position[0] && line.Position[0] <= high[this->Axes[0]] &&
          low[this->Axes[1]] <= line.Position[1] && line.Position[1] <= high[this->Axes[1]])
        {
          visit(line.Line);
        }
      }
    }
  }

private:
  struct GridLine
  {
    std::array<double, 2> Position;
    std::size_t Line;
  };

  /// The same for equal values and ascending with them, so that no line is missed.
  std::size_t SquareOf(int side, double value) const
  {
    const double width = this->High[side] - this->Low[side];
    const double share = width > 0.0 ? (value - this->Low[side]) / width : 0.0;
    const double last = static_cast<double>(this->Count - 1);
    return static_cast<std::size_t>(
      std::clamp(share * static_cast<double>(this->Count), 0.0, last));
  }

  /// Counting sort of lines by their squares.
  void Sort(const std::vector<std::size_t>& own, const std::vector<SeedLine>& lines)
  {
    const auto squareOf = [&](std::size_t line)
    {
      const Point3& start = lines[line].Start;
      return this->SquareOf(1, start[this->Axes[1]]) * this->Count +
        this->SquareOf(0, start[this->Axes[0]]);
    };
    this->Offsets.assign(this->Count * this->Count + 1, 0);
    for (const std::size_t line : own)
    {
      ++this->Offsets[squareOf(line) + 1];
    }
    std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
    std::vector<std::size_t> next(this->Offsets.begin(), this->Offsets.end() - 1);
    this->Lines.resize(own.size());
    for (const std::size_t line : own)
    {
      const Point3& start = lines[line].Start;
      this->Lines[next[squareOf(line)]++] = { { start[this->Axes[0]], start[this->Axes[1]] },
        line };
    }
  }

  std::array<int, 2> Axes;
  std::array<double, 2> Low{ HUGE_VAL, HUGE_VAL };
  std::array<double, 2> High{ -HUGE_VAL, -HUGE_VAL };
  std::size_t Count = 0; ///< of squares on each side
  std::vector<std::size_t> Offsets;
  std::vector<GridLine> Lines;
};

/// Of each component the line of the process whose triangle is the widest, the first of these if
/// several are as wide: the one that a single process takes.
void ChooseWidest(const Ranks& ranks, std::vector<SeedLine>& lines)
{
  if (!ranks.AreSeveral())
  {
    return;
  }
  using Values = std::array<double, 5>; // extent, axis, x, y, z of the start
  std::vector<Values> own;
  for (const SeedLine& line : lines)
  {
    own.push_back(
      { line.Extent, static_cast<double>(line.Axis), line.Start[0], line.Start[1], line.Start[2] });
  }
  const auto all = GatherValues(ranks, own);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    int widest = 0;
    for (int rank = 1; rank < ranks.Count; ++rank)
    {
      widest = std::abs(all[rank][i][0]) > std::abs(all[widest][i][0]) ? rank : widest;
    }
    if (widest != ranks.Rank)
    {
      const Values& values = all[widest][i];
      lines[i].Triangle = SeedLine::Elsewhere;
      lines[i].Extent = values[0];
      lines[i].Axis = static_cast<int>(values[1]);
      lines[i].Start = { values[2], values[3], values[4] };
    }
  }
}

/// How far it is to the surface of which each process has a part.
void ChooseNearest(const Ranks& ranks, std::vector<SeedLine>& lines)
{
  if (!ranks.AreSeveral())
  {
    return;
  }
  std::vector<double> own;
  for (const SeedLine& line : lines)
  {
    own.push_back(line.Nearest);
  }
  for (const std::vector<double>& nearest : GatherValues(ranks, own))
  {
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      lines[i].Nearest = std::min(lines[i].Nearest, nearest[i]);
    }
  }
}

Point3 SeedOn(const SeedLine& line)
{
  if (line.Extent == 0.0 || !(line.Nearest < HUGE_VAL))
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return { none, none, none };
  }
  Point3 seed = line.Start;
  seed[line.Axis] += 0.5 * line.Sign * line.Nearest;
  return seed;
}

/// Finds on each line how far it is to the surface.
template <typename TriangleAt>
void FindNearest(std::int64_t triangleCount, const TriangleAt& triangleAt,
  const Execution& execution, std::vector<SeedLine>& lines)
{
  const std::array<LineGrid, 3> grids{ LineGrid(lines, 0), LineGrid(lines, 1), LineGrid(lines, 2) };
  const auto meet = [&](std::int64_t i, std::vector<double>& nearest)
  {
    const Triangle triangle = triangleAt(i);
    Box3 box;
    for (const Point3& corner : triangle)
    {
      box.Add(corner);
    }
    for (const LineGrid& grid : grids)
    {
      grid.VisitThrough(box,
        [&](std::size_t line)
        {
          if (lines[line].Triangle != i)
          {
            nearest[line] = std::min(nearest[line], DistanceTo(triangle, lines[line]));
          }
        });
    }
  };
  const std::vector<double> none(lines.size(), HUGE_VAL);
  for (const auto& part : FindInParts(triangleCount, none, execution, meet))
  {
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      lines[i].Nearest = std::min(lines[i].Nearest, part[i]);
    }
  }
}
}

template <typename Coordinate, typename Id>
std::vector<Point3> FindSeeds(const Coordinate* points, const Id* triangles,
  std::int64_t triangleCount, const int* components, const std::vector<ComponentMeasure>& measures,
  const Ranks& ranks, const Execution& execution)
{
  const auto triangleAt = [&](std::int64_t number)
  {
    Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      const Coordinate* p = points + 3 * static_cast<std::int64_t>(triangles[3 * number + i]);
      triangle[i] = { static_cast<double>(p[0]), static_cast<double>(p[1]),
        static_cast<double>(p[2]) };
    }
    return triangle;
  };
  std::vector<SeedLine> lines(measures.size());
  const auto consider = [&](std::int64_t i, std::vector<SeedLine>& ofPart)
  {
    if (components[i] >= 0 && components[i] < static_cast<int>(ofPart.size()))
    {
      Consider(triangleAt(i), i, ofPart[components[i]]);
    }
  };
  for (const auto& part : FindInParts(triangleCount, lines, execution, consider))
  {
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      lines[i] = std::abs(part[i].Extent) > std::abs(lines[i].Extent) ? part[i] : lines[i];
    }
  }
  ChooseWidest(ranks, lines);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    // Normals point away from the region that is enclosed, but into a cavity.
    const bool isCavity = measures[i].Volume < 0.0;
    lines[i].Sign = (lines[i].Extent > 0.0) == isCavity ? 1 : -1;
  }
  FindNearest(triangleCount, triangleAt, execution, lines);
  ChooseNearest(ranks, lines);
  std::vector<Point3> seeds;
  for (const SeedLine& line : lines)
  {
    seeds.push_back(SeedOn(line));
  }
  return seeds;
}

#define ORTHOSLICES_INSTANTIATE(Coordinate, Id)                                                  \
  template std::vector<Point3> FindSeeds(const Coordinate*, const Id*, std::int64_t, const int*, \
    const std::vector<ComponentMeasure>&, const Ranks&, const Execution&);
ORTHOSLICES_INSTANTIATE(float, std::int32_t)
ORTHOSLICES_INSTANTIATE(float, long long)
ORTHOSLICES_INSTANTIATE(double, std::int32_t)
ORTHOSLICES_INSTANTIATE(double, long long)
#undef ORTHOSLICES_INSTANTIATE
}
