// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slabs/OverlaySlab.h"

#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/Random.h"
#include "Support/SelfIntersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <string>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
using Polygon = std::vector<Point2>;
using Edges = std::set<std::array<Index, 2>>;

/// What came out, and where its corners are. The slices are `Height` apart.
struct Slab
{
  Slab(std::vector<SlabLoop> loops, Point2 shift = { 0, 0 }, double height = 1.0);

  std::vector<SlabLoop> Loops;
  SlabOverlay Overlay;
  std::vector<Point3> Corners;
  std::vector<double> Levels;
  Edges Contours; ///< of the surface's open edges, in its direction

  TriangleMesh Mesh() const;
  Edges OpenEdges() const;
  std::vector<Index> CountFans() const;
  std::size_t CountFlat() const;
  std::size_t CountFlatEdges() const;
  /// Of each piece: vertices - edges + triangles, ascending.
  std::vector<Index> Euler() const;
  /// Area of the triangles seen along the axis, if nothing is sheared.
  double CoveredArea() const;
  double CoveredAreaUpwards() const;
};

Slab::Slab(std::vector<SlabLoop> loops, Point2 shift, double height)
  : Loops(std::move(loops))
  , Overlay(OverlaySlab(this->Loops, shift))
{
  std::vector<std::vector<std::vector<Index>>> inserted;
  std::vector<Index> first;
  for (const SlabLoop& loop : this->Loops)
  {
    first.push_back(static_cast<Index>(this->Corners.size()));
    inserted.emplace_back(loop.Points.size());
    for (const Point2& p : loop.Points)
    {
      this->Corners.push_back({ p[0], p[1], loop.Upper ? height : 0.0 });
      this->Levels.push_back(loop.Upper ? 1.0 : 0.0);
    }
  }
  double last = 0.0;
  for (const SlabOverlay::Insertion& insertion : this->Overlay.Insertions)
  {
    const SlabLoop& loop = this->Loops[insertion.Loop];
    std::vector<Index>& here = inserted[insertion.Loop][insertion.After];
    EXPECT_GT(insertion.Share, here.empty() ? 0.0 : last);
    EXPECT_LT(insertion.Share, 1.0);
    last = insertion.Share;
    here.push_back(static_cast<Index>(this->Corners.size()));
    const Point2& p = loop.Points[insertion.After];
    const Point2& q = loop.Points[(insertion.After + 1) % loop.Points.size()];
    this->Corners.push_back(
      { p[0] + last * (q[0] - p[0]), p[1] + last * (q[1] - p[1]), loop.Upper ? height : 0.0 });
    this->Levels.push_back(loop.Upper ? 1.0 : 0.0);
  }
  for (const Point3& p : this->Overlay.Points)
  {
    EXPECT_GT(p[2], 0.0);
    EXPECT_LT(p[2], 1.0);
    this->Corners.push_back({ p[0] + p[2] * shift[0], p[1] + p[2] * shift[1], p[2] * height });
    this->Levels.push_back(p[2]);
  }
  for (std::size_t i = 0; i < this->Loops.size(); ++i)
  {
    std::vector<Index> chain;
    for (std::size_t j = 0; j < inserted[i].size(); ++j)
    {
      chain.push_back(first[i] + static_cast<Index>(j));
      chain.insert(chain.end(), inserted[i][j].begin(), inserted[i][j].end());
    }
    for (std::size_t j = 0; j < chain.size(); ++j)
    {
      const Index a = chain[j];
      const Index b = chain[(j + 1) % chain.size()];
      this->Contours.insert(
        this->Loops[i].Upper ? std::array<Index, 2>{ b, a } : std::array<Index, 2>{ a, b });
    }
  }
}

TriangleMesh Slab::Mesh() const
{
  TriangleMesh mesh;
  mesh.Points = this->Corners;
  for (const auto& t : this->Overlay.Triangles)
  {
    mesh.Triangles.push_back({ t[0], t[1], t[2] });
  }
  return mesh;
}

/// Edges that no triangle passes the other way; adds (-1, -1) if two pass one alike.
Edges Slab::OpenEdges() const
{
  Edges all, open;
  for (const auto& t : this->Overlay.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (!all.insert({ t[i], t[(i + 1) % 3] }).second)
      {
        open.insert({ -1, -1 });
      }
    }
  }
  for (const auto& edge : all)
  {
    if (all.count({ edge[1], edge[0] }) == 0)
    {
      open.insert(edge);
    }
  }
  return open;
}

/// Of each corner: how many fans its triangles make up. The edges have to be matched.
std::vector<Index> Slab::CountFans() const
{
  std::vector<std::map<Index, Index>> next(this->Corners.size());
  for (const auto& t : this->Overlay.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      next[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
    }
  }
  std::vector<Index> fans;
  for (std::map<Index, Index>& links : next)
  {
    Index count = 0;
    while (!links.empty())
    {
      std::set<Index> ends;
      for (const auto& link : links)
      {
        ends.insert(link.second);
      }
      const auto start = std::find_if(links.begin(), links.end(),
        [&](const std::pair<const Index, Index>& link) { return ends.count(link.first) == 0; });
      Index at = start == links.end() ? links.begin()->first : start->first;
      for (auto link = links.find(at); link != links.end(); link = links.find(at))
      {
        at = link->second;
        links.erase(link);
      }
      ++count;
    }
    fans.push_back(count);
  }
  return fans;
}

std::size_t Slab::CountFlat() const
{
  const auto& triangles = this->Overlay.Triangles;
  return std::count_if(triangles.begin(), triangles.end(),
    [&](const std::array<Index, 3>& t)
    {
      const double level = this->Levels[t[0]];
      return level != 0.5 && level == this->Levels[t[1]] && level == this->Levels[t[2]];
    });
}

/// Edges in a slice that are none of the contours'.
std::size_t Slab::CountFlatEdges() const
{
  std::size_t count = 0;
  for (const auto& t : this->Overlay.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Index a = t[i];
      const Index b = t[(i + 1) % 3];
      count += this->Levels[a] == this->Levels[b] && this->Levels[a] != 0.5 &&
        this->Contours.count({ a, b }) == 0;
    }
  }
  return count;
}

std::vector<Index> Slab::Euler() const
{
  std::map<Index, std::set<Index>> vertices;
  std::map<Index, Edges> edges;
  std::map<Index, Index> result;
  for (std::size_t i = 0; i < this->Overlay.Triangles.size(); ++i)
  {
    const auto& t = this->Overlay.Triangles[i];
    const Index piece = this->Overlay.Piece[i];
    ++result[piece];
    for (int j = 0; j < 3; ++j)
    {
      vertices[piece].insert(t[j]);
      edges[piece].insert({ std::min(t[j], t[(j + 1) % 3]), std::max(t[j], t[(j + 1) % 3]) });
    }
  }
  std::vector<Index> euler;
  for (const auto& entry : result)
  {
    euler.push_back(entry.second + static_cast<Index>(vertices[entry.first].size()) -
      static_cast<Index>(edges[entry.first].size()));
  }
  std::sort(euler.begin(), euler.end());
  return euler;
}

double Slab::CoveredArea() const
{
  double area = 0.0;
  for (const auto& t : this->Overlay.Triangles)
  {
    Polygon p;
    for (const Index corner : t)
    {
      p.push_back({ this->Corners[corner][0], this->Corners[corner][1] });
    }
    area += std::abs(SignedArea(p));
  }
  return area;
}

double Slab::CoveredAreaUpwards() const
{
  double area = 0.0;
  for (const auto& t : this->Overlay.Triangles)
  {
    Polygon p;
    for (const Index corner : t)
    {
      p.push_back({ this->Corners[corner][0], this->Corners[corner][1] });
    }
    area += std::max(0.0, SignedArea(p));
  }
  return area;
}

/// Everything that holds for all contours.
void ExpectSound(const Slab& slab, const std::string& what = {})
{
  SCOPED_TRACE(what);
  ASSERT_TRUE(slab.Overlay.Valid);
  ASSERT_EQ(slab.Overlay.Piece.size(), slab.Overlay.Triangles.size());
  EXPECT_TRUE(slab.OpenEdges() == slab.Contours);
  for (const Index fans : slab.CountFans())
  {
    ASSERT_EQ(fans, 1);
  }
  EXPECT_EQ(slab.CountFlat(), 0u);
  EXPECT_EQ(slab.CountFlatEdges(), 0u);
  const TriangleMesh mesh = slab.Mesh();
  EXPECT_TRUE(FindMeetings(mesh).empty());
  EXPECT_LE(CountSelfIntersections(mesh), 0);
}

Polygon Square(double u, double v, double half)
{
  return { { u - half, v - half }, { u + half, v - half }, { u + half, v + half },
    { u - half, v + half } };
}

Polygon Reversed(Polygon polygon)
{
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// A star-shaped polygon around (u, v) between two radii.
Polygon Star(Random& random, double u, double v, double inner, double outer, int count)
{
  Polygon polygon;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * (i + random.Uniform(0.1, 0.9)) / count;
    const double radius = random.Uniform(inner, outer);
    polygon.push_back({ u + radius * std::cos(angle), v + radius * std::sin(angle) });
  }
  return polygon;
}

Polygon Circle(double u, double v, double radius, int count, double phase = 0.0)
{
  Polygon polygon;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * (i + phase) / count;
    polygon.push_back({ u + radius * std::cos(angle), v + radius * std::sin(angle) });
  }
  return polygon;
}

using Image = std::vector<std::vector<bool>>; ///< its border is empty

/// Fills pixels until none touch in a corner only.
void FillCorners(Image& image)
{
  const std::size_t n = image.size();
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i + 1 < n; ++i)
    {
      for (std::size_t j = 0; j + 1 < n; ++j)
      {
        if (image[i][j] == image[i + 1][j + 1] && image[i + 1][j] == image[i][j + 1] &&
          image[i][j] != image[i + 1][j])
        {
          image[i][j] = image[i][j + 1] = true;
          changed = true;
        }
      }
    }
  }
}

/// Outlines of the pixels; with `all` vertices or only where they turn.
void AddOutlines(const Image& image, bool upper, bool all, std::vector<SlabLoop>& loops)
{
  std::map<std::array<int, 2>, std::array<int, 2>> next;
  const int n = static_cast<int>(image.size());
  for (int i = 1; i + 1 < n; ++i)
  {
    for (int j = 1; j + 1 < n; ++j)
    {
      if (image[i][j])
      {
        const auto add = [&](bool neighbor, std::array<int, 2> from, std::array<int, 2> to)
        {
          if (!neighbor)
          {
            next[from] = to;
          }
        };
        add(image[i][j - 1], { i, j }, { i + 1, j });
        add(image[i + 1][j], { i + 1, j }, { i + 1, j + 1 });
        add(image[i][j + 1], { i + 1, j + 1 }, { i, j + 1 });
        add(image[i - 1][j], { i, j + 1 }, { i, j });
      }
    }
  }
  while (!next.empty())
  {
    std::vector<std::array<int, 2>> chain;
    std::array<int, 2> at = next.begin()->first;
    for (auto link = next.find(at); link != next.end(); link = next.find(at))
    {
      chain.push_back(at);
      at = link->second;
      next.erase(link);
    }
    SlabLoop loop{ {}, upper };
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      const auto& before = chain[(i + chain.size() - 1) % chain.size()];
      const auto& after = chain[(i + 1) % chain.size()];
      if (all || (before[0] != after[0] && before[1] != after[1]))
      {
        loop.Points.push_back({ 0.7 * chain[i][0], 0.7 * chain[i][1] });
      }
    }
    loops.push_back(loop);
  }
}
}

TEST(OverlaySlab, JoinsSquareWithSmallerOne)
{
  const Slab slab({ { Square(0, 0, 2), false }, { Square(0.1, 0, 1), true } });
  ExpectSound(slab);
  EXPECT_EQ(slab.Euler(), std::vector<Index>{ 0 });
  EXPECT_TRUE(slab.Overlay.Insertions.empty());
  EXPECT_TRUE(slab.Overlay.Points.empty());
  EXPECT_EQ(slab.Overlay.Triangles.size(), 8u);
  EXPECT_NEAR(slab.CoveredAreaUpwards(), 12.0, 1e-6);
}

TEST(OverlaySlab, JoinsSquareWithLargerOne)
{
  const Slab slab({ { Square(0.1, 0, 1), false }, { Square(0, 0, 2), true } });
  ExpectSound(slab);
  EXPECT_EQ(slab.Euler(), std::vector<Index>{ 0 });
  EXPECT_EQ(slab.Overlay.Triangles.size(), 8u);
  EXPECT_NEAR(slab.CoveredArea(), 12.0, 1e-6);
  EXPECT_EQ(slab.CoveredAreaUpwards(), 0.0); // the outside is below
}

TEST(OverlaySlab, JoinsCrossingSquares)
{
  const double r = 1.2;
  const Polygon turned{ { r, 0 }, { 0, r }, { -r, 0 }, { 0, -r } };
  const Slab slab({ { Square(0, 0, 1), false }, { turned, true } });
  ExpectSound(slab);
  EXPECT_EQ(slab.Euler(), std::vector<Index>{ 0 });
  EXPECT_EQ(slab.Overlay.Insertions.size(), 16u);
  // Four corners of the square, with legs of 0.8, and four of the other, 0.2 high.
  EXPECT_NEAR(slab.CoveredAreaUpwards(), 4 * 0.32, 1e-6);
  EXPECT_NEAR(slab.CoveredArea(), 4 * 0.32 + 4 * 0.04, 1e-6);
}

TEST(OverlaySlab, JoinsEqualSquaresByWalls)
{
  const Slab slab({ { Square(3, 5, 1), false }, { Square(3, 5, 1), true } });
  ExpectSound(slab);
  EXPECT_EQ(slab.Euler(), std::vector<Index>{ 0 });
  EXPECT_NEAR(slab.CoveredArea(), 0.0, 1e-6);
  EXPECT_EQ(slab.Overlay.Insertions.size(), 4u);
}

TEST(OverlaySlab, JoinsSquaresWithCommonSides)
{
  for (const bool upper : { false, true })
  {
    const Polygon wide{ { 0, 0 }, { 3, 0 }, { 3, 1 }, { 0, 1 } };
    const Polygon narrow{ { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 } };
    const Slab slab({ { wide, upper }, { narrow, !upper } });
    ExpectSound(slab);
    EXPECT_EQ(slab.Euler(), std::vector<Index>{ 0 });
    EXPECT_NEAR(slab.CoveredArea(), 2.0, 1e-6);
  }
}

TEST(OverlaySlab, JoinsSquaresThatTouchFromOutside)
{
  const Slab slab({ { Square(0, 0, 1), false }, { Square(2, 0, 1), true } });
  ExpectSound(slab);
  EXPECT_NEAR(slab.CoveredArea(), 8.0, 1e-5);
}

TEST(OverlaySlab, BranchesBetweenOneAndTwo)
{
  const Polygon wide{ { -3, -1.5 }, { 3, -1.5 }, { 3, 1.5 }, { -3, 1.5 } };
  for (const bool upper : { false, true })
  {
    const Slab slab(
      { { wide, upper }, { Square(-1.5, 0, 1), !upper }, { Square(1.5, 0, 1), !upper } });
    ExpectSound(slab);
    EXPECT_EQ(slab.Euler(), std::vector<Index>{ -1 });
    EXPECT_NEAR(slab.CoveredArea(), 10.0, 1e-6);
  }
}

TEST(OverlaySlab, ClosesHoleWithoutPartner)
{
  const Slab slab({ { Square(0, 0, 3), false }, { Reversed(Square(0, 0, 1)), false },
    { Square(0.1, 0.1, 2.9), true } });
  ExpectSound(slab);
  EXPECT_EQ(slab.Euler(), (std::vector<Index>{ 0, 1 }));
  double top = 0.0;
  for (const Point3& p : slab.Overlay.Points)
  {
    EXPECT_EQ(p[2], 0.5);
    top = std::max(top, std::max(std::abs(p[0]), std::abs(p[1])));
  }
  EXPECT_LE(top, 1.0);
}

TEST(OverlaySlab, PutsLidsOnDisjointSquares)
{
  const std::vector<SlabLoop> loops{ { Square(0, 0, 1), false }, { Square(4, 1, 1), true } };
  const Slab apart(loops);
  ExpectSound(apart);
  EXPECT_EQ(apart.Euler(), (std::vector<Index>{ 1, 1 }));
  EXPECT_EQ(apart.Overlay.Points.size(), 2u);
  EXPECT_NEAR(apart.CoveredAreaUpwards(), 4.0, 1e-6); // that of the lower one faces up

  for (const Point2 shift : { Point2{ 4, 1 }, Point2{ 3.7, 1.2 }, Point2{ 2.5, 0.5 } })
  {
    const Slab joined(loops, shift);
    ExpectSound(joined);
    EXPECT_EQ(joined.Euler(), std::vector<Index>{ 0 });
  }
}

TEST(OverlaySlab, PutsLidOnTriangle)
{
  const Polygon triangle{ { 0, 0 }, { 1, 0 }, { 0, 1 } };
  for (const bool upper : { false, true })
  {
    const Slab slab({ { triangle, upper } });
    ExpectSound(slab);
    EXPECT_EQ(slab.Euler(), std::vector<Index>{ 1 });
    ASSERT_EQ(slab.Overlay.Points.size(), 1u);
    EXPECT_EQ(slab.Overlay.Points[0][2], 0.5);
    EXPECT_NEAR(slab.CoveredAreaUpwards(), upper ? 0.0 : 0.5, 1e-6);
  }
}

TEST(OverlaySlab, JoinsNestedRings)
{
  std::vector<SlabLoop> loops;
  for (int i = 0; i < 6; ++i)
  {
    const Polygon lower = Square(0, 0, 6.0 - i);
    const Polygon upper = Circle(0.05, 0.02, 6.2 - i, 40);
    loops.push_back({ i % 2 == 0 ? lower : Reversed(lower), false });
    loops.push_back({ i % 2 == 0 ? upper : Reversed(upper), true });
  }
  ExpectSound(Slab(loops));
  std::reverse(loops.begin(), loops.end());
  ExpectSound(Slab(loops, { 0.3, 0.4 }));

  loops.clear();
  for (int i = 0; i < 8; ++i)
  {
    const Polygon square = Square(0, 0, 8.0 - i);
    loops.push_back({ i % 4 < 2 ? square : Reversed(square), i % 2 == 1 });
  }
  const Slab slab(loops);
  ExpectSound(slab);
  EXPECT_EQ(slab.Euler(), (std::vector<Index>{ 0, 0, 0, 0 }));
}

TEST(OverlaySlab, TakesNothing)
{
  const SlabOverlay overlay = OverlaySlab({}, { 0, 0 });
  EXPECT_TRUE(overlay.Valid);
  EXPECT_TRUE(overlay.Triangles.empty());
}

TEST(OverlaySlab, RejectsWhatIsNotSimple)
{
  const Polygon bow{ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } };
  EXPECT_FALSE(OverlaySlab({ { bow, false } }, { 0, 0 }).Valid);
  EXPECT_FALSE(
    OverlaySlab({ { Square(0, 0, 1), true }, { Square(1, 0, 1), true } }, { 0, 0 }).Valid);
  EXPECT_FALSE(OverlaySlab({ { Reversed(Square(0, 0, 1)), true } }, { 0, 0 }).Valid);
  EXPECT_FALSE(OverlaySlab({ { { { 0, 0 }, { 1, 0 } }, true } }, { 0, 0 }).Valid);
  EXPECT_FALSE(OverlaySlab({ { { { 0, 0 }, { 1, 0 }, { 2, 0 } }, true } }, { 0, 0 }).Valid);
  EXPECT_FALSE(OverlaySlab({ { { { 0, 0 }, { 1, 0 }, { 0, NAN } }, true } }, { 0, 0 }).Valid);
}

TEST(OverlaySlab, JoinsEqualContoursOfAnyShape)
{
  Random random(2);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Polygon star = Star(random, 100, -50, 5, 20, 3 + trial * 20);
    const Slab slab({ { star, false }, { star, true } });
    ExpectSound(slab, "trial " + std::to_string(trial));
    // Vertical but for the corners, where the walls lean by a tiny part of the extent.
    double length = 0.0;
    for (std::size_t i = 0; i < star.size(); ++i)
    {
      const Point2& p = star[i];
      const Point2& q = star[(i + 1) % star.size()];
      length += std::hypot(q[0] - p[0], q[1] - p[1]);
    }
    EXPECT_NEAR(slab.CoveredArea() / length, 0.0, 40 * 1e-7);
  }
}

TEST(OverlaySlab, JoinsAlmostEqualContours)
{
  // Turned by less and less, up to rounding errors; some of them far from the origin.
  Random random(3);
  for (int trial = 0; trial < 60; ++trial)
  {
    Polygon lower = Star(random, 0, 0, 5, 20, 5 + static_cast<int>(random.Below(60)));
    Polygon upper = lower;
    const double turn = std::pow(10.0, -0.25 * trial);
    const double offset = trial % 3 == 0 ? 1e4 : 0.0;
    for (std::size_t i = 0; i < lower.size(); ++i)
    {
      const Point2 p = lower[i];
      upper[i] = { offset + p[0] - turn * p[1], offset + p[1] + turn * p[0] };
      lower[i] = { offset + p[0], offset + p[1] };
    }
    ExpectSound(Slab({ { lower, false }, { upper, true } }), "trial " + std::to_string(trial));
  }
}

TEST(OverlaySlab, JoinsContoursWithMoreAndFewerVertices)
{
  // Vertices on the segments of the other contour, or almost.
  Random random(8);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Polygon coarse = Circle(0, 0, 3, 3 + trial);
    Polygon fine;
    for (std::size_t i = 0; i < coarse.size(); ++i)
    {
      const Point2& p = coarse[i];
      const Point2& q = coarse[(i + 1) % coarse.size()];
      for (int j = 0; j < 7; ++j)
      {
        const double share = j == 3 ? j / 7.0 + random.Uniform(-1e-7, 1e-7) : j / 7.0;
        fine.push_back({ p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]) });
      }
    }
    ExpectSound(Slab({ { coarse, trial % 2 == 0 }, { fine, trial % 2 != 0 } }),
      "trial " + std::to_string(trial));
  }
}

TEST(OverlaySlab, JoinsRandomStars)
{
  Random random(1);
  for (int trial = 0; trial < 30; ++trial)
  {
    std::vector<SlabLoop> loops;
    const int vertices = trial < 28 ? 3 + static_cast<int>(random.Below(40)) : 400;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        for (const bool upper : { false, true })
        {
          if (random.Chance(0.7))
          {
            const double u = 2.1 * i, v = 2.1 * j;
            loops.push_back({ Star(random, u, v, 0.8, 1.0, vertices + 5), upper });
            if (random.Chance(0.5))
            {
              loops.push_back({ Reversed(Star(random, u, v, 0.2, 0.5, vertices)), upper });
            }
          }
        }
      }
    }
    const Point2 shift{ random.Uniform(-1, 1), random.Uniform(-1, 1) };
    ExpectSound(
      Slab(loops, trial % 2 == 0 ? Point2{ 0, 0 } : shift, 0.3), "trial " + std::to_string(trial));
  }
}

TEST(OverlaySlab, JoinsRandomVoxelOutlines)
{
  Random random(4);
  for (int trial = 0; trial < 30; ++trial)
  {
    const std::size_t size = trial < 27 ? 6 + random.Below(10) : 40;
    Image lower(size, std::vector<bool>(size, false));
    for (std::size_t i = 2; i + 2 < size; ++i)
    {
      for (std::size_t j = 2; j + 2 < size; ++j)
      {
        lower[i][j] = random.Chance(0.5);
      }
    }
    Image upper = lower;
    for (std::size_t i = 2; i + 2 < size; ++i)
    {
      for (std::size_t j = 2; j + 2 < size; ++j)
      {
        upper[i][j] = upper[i][j] != random.Chance(0.2);
      }
    }
    FillCorners(lower);
    FillCorners(upper);
    std::vector<SlabLoop> loops;
    AddOutlines(lower, false, trial % 2 == 0, loops);
    AddOutlines(upper, true, trial % 2 == 0, loops);
    ExpectSound(Slab(loops), "trial " + std::to_string(trial));
    ExpectSound(Slab(loops, { 0.7, -0.7 }), "shifted, trial " + std::to_string(trial));
  }
}

TEST(OverlaySlab, IsFast)
{
  Random random(7);
  const auto circle = [](double radius, double phase) { return Circle(0, 0, radius, 2000, phase); };
  const std::vector<std::pair<std::string, std::vector<SlabLoop>>> cases{
    { "annulus", { { circle(2, 0), false }, { circle(1, 0.3), true } } },
    { "lids", { { circle(2, 0), false }, { Circle(5, 0, 2, 2000), true } } },
    { "equal", { { circle(2, 0), false }, { circle(2, 0), true } } },
    { "crossing", { { circle(2, 0), false }, { Circle(0.5, 0, 2, 2000), true } } },
    { "stars",
      { { Star(random, 0, 0, 1.8, 2, 2000), false }, { Star(random, 0, 0, 1.8, 2, 2000), true } } },
    { "rings",
      { { Star(random, 0, 0, 1.8, 2, 2000), false }, { Star(random, 0, 0, 1, 1.2, 2000), true } } },
    { "spiky",
      { { Star(random, 0, 0, 0.5, 2, 2000), false }, { Star(random, 0, 0, 0.5, 2, 2000), true } } }
  };
  for (const auto& test : cases)
  {
    const auto start = std::chrono::steady_clock::now();
    const SlabOverlay overlay = OverlaySlab(test.second, { 0, 0 });
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    RecordProperty(test.first, std::to_string(time.count()));
    EXPECT_TRUE(overlay.Valid) << test.first;
    EXPECT_LT(time.count(), 2000.0) << test.first; // in a debug build, on a busy machine
  }
}
