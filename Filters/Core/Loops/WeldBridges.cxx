// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/WeldBridges.h"

#include "Core/Base/EditContours.h"
#include "Core/Base/Predicates.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// How long a bridge is at least, and how thick the hole behind it, in widths of the bridge.
constexpr double LeastLength = 5.0;
/// So many of the longest sides may be those of bridges; of a contour with more sides, those that
/// are longer than so many mean ones.
constexpr std::size_t MostSides = 64;
constexpr double LongSide = 2.0;

Point2 NearestOn(const Point2& p, const Point2& q, const Point2& x)
{
  const double square = SquaredDistance(p, q);
  const double share = square > 0.0 ? Dot(x - p, q - p) / square : 0.0;
  return share <= 0.0 ? p : share >= 1.0 ? q : Between(p, q, share);
}

class BridgeWelder
{
public:
  BridgeWelder(const Contours& contours, double share)
    : Set(contours)
    , Share(share)
  {
  }

  /// The contour with its bridges made exact; empty if it has none.
  std::vector<Point2> Weld(Index contour);

private:
  void Read(Index contour);
  bool FindBridges();
  std::vector<Index> FindLongSides() const;
  /// The vertex after the last one is the first.
  const Point2& At(Index vertex) const
  {
    const std::size_t i = static_cast<std::size_t>(vertex);
    return this->Polygon[i < this->Polygon.size() ? i : 0];
  }
  bool IsBridge(Index s, Index t, double width) const;
  bool HasHoleBehind(Index s, Index t, double width) const;
  void WeldSides(Index s, Index t);

  const Contours& Set;
  double Share;
  std::vector<Point2> Polygon; ///< counter-clockwise
  double Area = 0.0;
  std::vector<double> Lengths; ///< of the sides
  double Length = 0.0;
  /// Points to be inserted on each side, with the square of their distance from its start.
  std::vector<std::vector<std::pair<double, Point2>>> Inserted;
};

std::vector<Index> BridgeWelder::FindLongSides() const
{
  const std::size_t count = this->Lengths.size();
  const double least = count <= MostSides ? 0.0 : LongSide * this->Length / count;
  std::vector<Index> sides;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (this->Lengths[i] > least)
    {
      sides.push_back(static_cast<Index>(i));
    }
  }
  if (sides.size() > MostSides)
  {
    std::stable_sort(sides.begin(), sides.end(),
      [this](Index a, Index b) { return this->Lengths[a] > this->Lengths[b]; });
    sides.resize(MostSides);
  }
  return sides;
}

/// Whether side t, the shorter one, leads back along side s.
bool BridgeWelder::IsBridge(Index s, Index t, double width) const
{
  const Point2 &a = this->At(s), &b = this->At(s + 1), &c = this->At(t), &d = this->At(t + 1);
  // Most pairs run the same way or are far apart.
  if (Dot(b - a, d - c) >= 0.0 || c[1] < std::min(a[1], b[1]) - 2.0 * width ||
    c[1] > std::max(a[1], b[1]) + 2.0 * width)
  {
    return false;
  }
  const double distance =
    std::max(Distance(c, NearestOn(a, b, c)), Distance(d, NearestOn(a, b, d)));
  return distance > 0.0 && distance <= width && this->Lengths[t] >= LeastLength * distance &&
    SideOf(a, b, Between(c, d, 0.5)) < 0 && this->HasHoleBehind(s, t, distance);
}

/// Whether what is between the ends of two sides on one way around is a hole, and on the other way
/// the outline.
bool BridgeWelder::HasHoleBehind(Index s, Index t, double width) const
{
  // From the end of the first side to the start of the second, in the order along the contour.
  const Index count = static_cast<Index>(this->Polygon.size());
  const auto measure = [&](Index from, Index to)
  {
    std::vector<Point2> part;
    double length = 0.0;
    for (Index i = from; i != to; i = (i + 1) % count)
    {
      part.push_back(this->At(i));
      length += this->Lengths[i];
    }
    part.push_back(this->At(to));
    length += Distance(this->At(from), this->At(to));
    return std::make_pair(SignedArea(part), length);
  };
  const auto one = measure((s + 1) % count, t);
  const auto other = measure((t + 1) % count, s);
  const auto isHole = [&](const std::pair<double, double>& part)
  { return part.first < 0.0 && -2.0 * part.first >= LeastLength * width * part.second; };
  return (isHole(one) && other.first > 0.0) || (isHole(other) && one.first > 0.0);
}

/// Leads side t along side s.
void BridgeWelder::WeldSides(Index s, Index t)
{
  const Point2 &a = this->At(s), &b = this->At(s + 1), &c = this->At(t), &d = this->At(t + 1);
  const Point2 from = NearestOn(a, b, c);
  const Point2 to = NearestOn(a, b, d);
  this->Inserted[t].emplace_back(SquaredDistance(c, from), from);
  this->Inserted[t].emplace_back(SquaredDistance(c, to), to);
  this->Inserted[s].emplace_back(SquaredDistance(a, to), to);
  this->Inserted[s].emplace_back(SquaredDistance(a, from), from);
}

/// The corners, counter-clockwise, and the lengths of the sides.
void BridgeWelder::Read(Index contour)
{
  this->Polygon.clear();
  this->Lengths.clear();
  for (Index i = this->Set.Offsets[contour]; i < this->Set.Offsets[contour + 1]; ++i)
  {
    this->Polygon.push_back({ this->Set.U[i], this->Set.V[i] });
  }
  if (this->Area < 0.0)
  {
    std::reverse(this->Polygon.begin(), this->Polygon.end());
  }
  for (std::size_t i = 0; i < this->Polygon.size(); ++i)
  {
    const Point2 side = this->At(static_cast<Index>(i) + 1) - this->Polygon[i];
    this->Lengths.push_back(std::sqrt(Dot(side, side)));
  }
  this->Length = std::accumulate(this->Lengths.begin(), this->Lengths.end(), 0.0);
  this->Inserted.clear();
}

/// Whether there are bridges; notes what has to be inserted.
bool BridgeWelder::FindBridges()
{
  const double width = this->Share * 2.0 * std::abs(this->Area) / this->Length;
  std::vector<Index> sides = this->FindLongSides();
  const auto low = [this](Index side)
  { return std::min(this->At(side)[0], this->At(side + 1)[0]); };
  const auto high = [this](Index side)
  { return std::max(this->At(side)[0], this->At(side + 1)[0]); };
  std::sort(sides.begin(), sides.end(),
    [&](Index a, Index b) { return std::make_pair(low(a), a) < std::make_pair(low(b), b); });
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    // What begins farther along u is too far away.
    const double end = high(sides[i]) + 2.0 * width;
    for (std::size_t j = i + 1; j < sides.size() && low(sides[j]) <= end; ++j)
    {
      const Index later = std::max(sides[i], sides[j]), earlier = std::min(sides[i], sides[j]);
      const bool isLonger = this->Lengths[later] >= this->Lengths[earlier];
      const Index s = isLonger ? later : earlier;
      const Index t = isLonger ? earlier : later;
      if (this->IsBridge(s, t, width))
      {
        this->Inserted.resize(this->Polygon.size());
        this->WeldSides(s, t);
      }
    }
  }
  return !this->Inserted.empty();
}

std::vector<Point2> BridgeWelder::Weld(Index contour)
{
  this->Area = 0.5 * TwiceSignedArea(this->Set, contour);
  this->Read(contour);
  if (!this->FindBridges())
  {
    return {};
  }
  std::vector<Point2> welded;
  for (std::size_t i = 0; i < this->Polygon.size(); ++i)
  {
    welded.push_back(this->Polygon[i]);
    std::sort(this->Inserted[i].begin(), this->Inserted[i].end());
    for (const auto& insertion : this->Inserted[i])
    {
      if (insertion.second != welded.back())
      {
        welded.push_back(insertion.second);
      }
    }
  }
  if (this->Area < 0.0)
  {
    std::reverse(welded.begin(), welded.end());
  }
  return welded;
}

/// The contours with other vertices where there are some.
Contours Replace(const Contours& contours, const std::vector<std::vector<Point2>>& polygons)
{
  Contours result = contours;
  result.U.clear();
  result.V.clear();
  result.Offsets.resize(1);
  for (Index i = 0; i < contours.Count(); ++i)
  {
    const Index begin = contours.Offsets[i];
    const Index end = contours.Offsets[i + 1];
    if (polygons[i].empty())
    {
      result.U.insert(result.U.end(), contours.U.begin() + begin, contours.U.begin() + end);
      result.V.insert(result.V.end(), contours.V.begin() + begin, contours.V.begin() + end);
    }
    for (const Point2& point : polygons[i])
    {
      result.U.push_back(point[0]);
      result.V.push_back(point[1]);
    }
    result.Offsets.push_back(static_cast<Index>(result.U.size()));
  }
  return result;
}
}

void WeldBridges(double share, const Execution& execution, Contours& contours)
{
  std::vector<std::vector<Point2>> welded(contours.Count());
  execution.For(welded.size(),
    [&](std::size_t begin, std::size_t end)
    {
      BridgeWelder welder(contours, share);
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index contour = static_cast<Index>(i);
        if (share > 0.0 && !contours.IsVirtual(contour))
        {
          welded[i] = welder.Weld(contour);
        }
      }
    });
  const auto isNone = [](const std::vector<Point2>& polygon) { return polygon.empty(); };
  if (!std::all_of(welded.begin(), welded.end(), isNone))
  {
    contours = Replace(contours, welded);
  }
}
}
