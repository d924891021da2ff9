// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TurnedSlices.h"

#include "Support/Random.h"

#include <cmath>

namespace orthoslices
{
namespace support
{

Matrix3 UnitMatrix() { return { { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } }; }

Point3 Apply(const Matrix3& matrix, const Point3& point)
{
  return { Dot(matrix[0], point), Dot(matrix[1], point), Dot(matrix[2], point) };
}

Matrix3 Transpose(const Matrix3& matrix)
{
  Matrix3 transposed;
  for (int i = 0; i < 9; ++i)
  {
    transposed[i % 3][i / 3] = matrix[i / 3][i % 3];
  }
  return transposed;
}

Matrix3 RotationAround(const Point3& axis, double angle)
{
  const Point3 unit = Unit(axis);
  const Matrix3 identity = UnitMatrix();
  Matrix3 columns;
  for (int i = 0; i < 3; ++i)
  {
    // Rodrigues.
    columns[i] = std::cos(angle) * identity[i] + std::sin(angle) * Cross(unit, identity[i]) +
      ((1.0 - std::cos(angle)) * unit[i]) * unit;
  }
  return Transpose(columns);
}

Matrix3 RandomRotation(std::uint64_t seed)
{
  Random random(seed);
  // Rows from a random direction and another one at right angles to it.
  const auto direction = [&]
  {
    Point3 p;
    do
    {
      p = { random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) };
    } while (Length(p) > 1.0 || Length(p) < 0.1);
    return Unit(p);
  };
  const Point3 first = direction();
  const Point3 second = Unit(Cross(first, direction()));
  return { first, second, Cross(first, second) };
}

Matrix3 AxisOrder(int number)
{
  constexpr int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 },
    { 1, 0, 2 } };
  Matrix3 matrix{};
  for (int i = 0; i < 3; ++i)
  {
    matrix[i][orders[number / 8][i]] = ((number >> i) & 1) != 0 ? -1.0 : 1.0;
  }
  return matrix;
}

Polylines MapSlices(
  const PieceSets& sets, const Matrix3& matrix, const std::array<int, 3>& ports, double step)
{
  Polylines lines;
  std::array<std::int64_t, 4> cells{};
  for (const Pieces& pieces : sets)
  {
    const int axis = pieces.Axis;
    for (Index piece = 0; piece < pieces.Count(); ++piece)
    {
      for (Index i = pieces.Offsets[piece]; i < pieces.Offsets[piece + 1]; ++i)
      {
        Point3 point;
        point[axis] = pieces.W[i];
        point[FirstAxis(axis)] = pieces.U[i];
        point[SecondAxis(axis)] = pieces.V[i];
        point = Apply(matrix, point);
        for (double& x : point)
        {
          x = step > 0.0 ? step * std::round(x / step) : x;
        }
        lines.X.push_back(point[0]);
        lines.Y.push_back(point[1]);
        lines.Z.push_back(point[2]);
      }
      lines.Offsets.push_back(static_cast<Index>(lines.X.size()));
      lines.Closed.push_back(pieces.Closed[piece]);
      lines.From.Port.push_back(static_cast<std::int8_t>(ports[axis]));
      lines.From.Block.push_back(0);
      lines.From.Cell.push_back(cells[ports[axis]]++);
    }
  }
  return lines;
}

Polylines CutToSegments(const Polylines& lines, std::uint64_t seed)
{
  Random random(seed);
  struct Side
  {
    Index Line, From, To;
  };
  std::vector<Side> sides;
  for (Index line = 0; line < lines.Count(); ++line)
  {
    const Index first = lines.Offsets[line], last = lines.Offsets[line + 1];
    for (Index i = first; i + (lines.Closed[line] != 0 ? 0 : 1) < last; ++i)
    {
      const Index next = i + 1 < last ? i + 1 : first;
      const bool forward = random.Uniform(0.0, 1.0) < 0.5;
      sides.push_back({ line, forward ? i : next, forward ? next : i });
    }
  }
  random.Shuffle(sides);
  Polylines cut;
  for (const Side& side : sides)
  {
    for (const Index i : { side.From, side.To })
    {
      cut.X.push_back(lines.X[i]);
      cut.Y.push_back(lines.Y[i]);
      cut.Z.push_back(lines.Z[i]);
    }
    cut.Offsets.push_back(static_cast<Index>(cut.X.size()));
    cut.Closed.push_back(0);
    cut.From.Port.push_back(lines.From.Port[side.Line]);
    cut.From.Block.push_back(lines.From.Block[side.Line]);
    cut.From.Cell.push_back(cut.Count() - 1);
  }
  return cut;
}

} // namespace support
} // namespace orthoslices
