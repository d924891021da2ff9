// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/AddLoop.h"

#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// The loop that is being added.
struct LoopView
{
  const Contours& Set;
  std::size_t Begin;

  explicit LoopView(const Contours& contours)
    : Set(contours)
    , Begin(contours.Offsets.back())
  {
  }
  std::size_t Size() const { return this->Set.U.size() - this->Begin; }
  Point2 operator[](std::size_t i) const
  {
    return { this->Set.U[this->Begin + i], this->Set.V[this->Begin + i] };
  }
};

/// Whether three points lie on one line, or their triangle is nowhere higher than the tolerance.
bool AreInLine(const Point2& a, const Point2& b, const Point2& c, double tolerance)
{
  const double longest =
    std::max({ SquaredDistance(a, b), SquaredDistance(b, c), SquaredDistance(c, a) });
  const double area = std::abs(Cross(b - a, c - a));
  return area * area <= tolerance * tolerance * longest &&
    (tolerance > 0.0 || SideOf(a, b, c) == 0);
}

/// Whether all vertices lie on one line, or no farther from it than the tolerance. Of most loops a
/// few vertices show that they do not.
bool IsStraight(const LoopView& loop, double tolerance)
{
  const Point2 first = loop[0];
  Point2 farthest = first;
  for (std::size_t i = 1; i < loop.Size(); ++i)
  {
    if (!AreInLine(first, loop[i / 2], loop[i], 2.0 * tolerance))
    {
      return false;
    }
    farthest =
      SquaredDistance(first, loop[i]) > SquaredDistance(first, farthest) ? loop[i] : farthest;
  }
  for (std::size_t i = 1; i < loop.Size(); ++i)
  {
    if (!AreInLine(first, farthest, loop[i], tolerance))
    {
      return false;
    }
  }
  return true;
}

/// Whether the area is zero but for rounding.
bool HasNoSignedArea(const LoopView& loop)
{
  constexpr double rounding = 1e-9;
  double area = 0.0, size = 0.0;
  for (std::size_t i = 1; i + 1 < loop.Size(); ++i)
  {
    const double term = Cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
    area += term;
    size += std::abs(term);
  }
  return std::abs(area) <= rounding * size;
}

/// Whether a loop goes back every way that it comes, so that nothing is left if these cancel out.
bool GoesBack(const LoopView& loop)
{
  std::vector<Point2> way;
  for (std::size_t i = 0; i < loop.Size(); ++i)
  {
    const bool back = way.size() > 1 && way[way.size() - 2] == loop[i];
    back ? way.pop_back() : way.push_back(loop[i]);
  }
  std::size_t first = 0;
  while (way.size() > first + 2 && way[first + 1] == way.back())
  {
    way.pop_back();
    ++first;
  }
  return way.size() <= first + 2;
}

bool IsFlat(const LoopView& loop, double tolerance)
{
  return IsStraight(loop, tolerance) || (HasNoSignedArea(loop) && GoesBack(loop));
}
}

void AddPoint(double u, double v, Contours& contours)
{
  const bool begins = static_cast<Index>(contours.U.size()) == contours.Offsets.back();
  if (begins || u != contours.U.back() || v != contours.V.back())
  {
    contours.U.push_back(u);
    contours.V.push_back(v);
  }
}

LoopState CheckLoop(bool alsoFlat, double tolerance, Contours& contours)
{
  const std::size_t begin = contours.Offsets.back();
  std::vector<double>& u = contours.U;
  std::vector<double>& v = contours.V;
  while (u.size() > begin + 1 && u.back() == u[begin] && v.back() == v[begin])
  {
    u.pop_back();
    v.pop_back();
  }
  if (u.size() < begin + 3)
  {
    return LoopState::TooShort;
  }
  return alsoFlat && IsFlat(LoopView(contours), tolerance) ? LoopState::Flat : LoopState::Good;
}

void DropLoop(Contours& contours)
{
  contours.U.resize(contours.Offsets.back());
  contours.V.resize(contours.Offsets.back());
}
}
