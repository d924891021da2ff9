// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/CutEars.h"

#include "Core/Base/Predicates.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/**
 * Cuts ears off a ring. Which points lie within a triangle is found by boxes around consecutive
 * points of the ring, and boxes around these: that takes time of order n log n, where a look at all
 * points would take n^2.
 */
class EarCutter
{
public:
  EarCutter(const std::vector<Point2>& points, const std::vector<Index>& ring);
  void Run(std::vector<std::array<Index, 3>>& triangles);

private:
  static constexpr std::size_t FanOut = 8; ///< points or boxes in a box
  struct Box
  {
    Point2 Low{ HUGE_VAL, HUGE_VAL }, High{ -HUGE_VAL, -HUGE_VAL };
    std::size_t Left = 0; ///< points that are not cut off

    void Add(const Point2& low, const Point2& high, std::size_t points)
    {
      for (int k = 0; k < 2; ++k)
      {
        this->Low[k] = std::min(this->Low[k], low[k]);
        this->High[k] = std::max(this->High[k], high[k]);
      }
      this->Left += points;
    }
    bool Meets(const Box& other) const
    {
      return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
        this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1];
    }
  };

  const Point2& At(std::size_t place) const { return this->Points[this->Ring[place]]; }
  bool IsEmptyEar(std::size_t ear) const;
  bool IsInEar(std::size_t place, const std::array<Index, 3>& ear) const;
  bool IsAnyIn(
    std::size_t level, std::size_t number, const Box& box, const std::array<Index, 3>& ear) const;
  void Cut(std::size_t ear);

  const std::vector<Point2>& Points;
  const std::vector<Index>& Ring;
  std::vector<std::size_t> Next, Previous; ///< of the places in the ring that are left
  std::vector<std::uint8_t> IsCut;
  std::vector<std::vector<Box>> Boxes; ///< of points, of boxes, ...; the last level has one box
};

EarCutter::EarCutter(const std::vector<Point2>& points, const std::vector<Index>& ring)
  : Points(points)
  , Ring(ring)
  , Next(ring.size())
  , Previous(ring.size())
  , IsCut(ring.size(), 0)
{
  const std::size_t n = ring.size();
  std::vector<Box> level((n + FanOut - 1) / FanOut);
  for (std::size_t i = 0; i < n; ++i)
  {
    this->Next[i] = i + 1 < n ? i + 1 : 0;
    this->Previous[i] = i > 0 ? i - 1 : n - 1;
    level[i / FanOut].Add(this->At(i), this->At(i), 1);
  }
  this->Boxes.push_back(level);
  while (this->Boxes.back().size() > 1)
  {
    const std::vector<Box>& below = this->Boxes.back();
    std::vector<Box> above((below.size() + FanOut - 1) / FanOut);
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      above[i / FanOut].Add(below[i].Low, below[i].High, below[i].Left);
    }
    this->Boxes.push_back(std::move(above));
  }
}

bool EarCutter::IsInEar(std::size_t place, const std::array<Index, 3>& ear) const
{
  const Index i = this->Ring[place];
  const Point2 &a = this->Points[ear[0]], &b = this->Points[ear[1]], &c = this->Points[ear[2]];
  return this->IsCut[place] == 0 && i != ear[0] && i != ear[1] && i != ear[2] &&
    SideOf(a, b, this->Points[i]) >= 0 && SideOf(b, c, this->Points[i]) >= 0 &&
    SideOf(c, a, this->Points[i]) >= 0;
}

/// Whether any point that is left in one of the boxes lies in an ear, of which `box` is the box.
bool EarCutter::IsAnyIn(
  std::size_t level, std::size_t number, const Box& box, const std::array<Index, 3>& ear) const
{
  const Box& here = this->Boxes[level][number];
  if (here.Left == 0 || !here.Meets(box))
  {
    return false;
  }
  const std::size_t count = level > 0 ? this->Boxes[level - 1].size() : this->Ring.size();
  const std::size_t end = std::min(count, (number + 1) * FanOut);
  for (std::size_t i = number * FanOut; i < end; ++i)
  {
    if (level > 0 ? this->IsAnyIn(level - 1, i, box, ear) : this->IsInEar(i, ear))
    {
      return true;
    }
  }
  return false;
}

/// Whether the triangle at a vertex turns left and has no other vertex inside or on its border.
bool EarCutter::IsEmptyEar(std::size_t ear) const
{
  const std::array<Index, 3> corners{ this->Ring[this->Previous[ear]], this->Ring[ear],
    this->Ring[this->Next[ear]] };
  Box box;
  for (const Index corner : corners)
  {
    box.Add(this->Points[corner], this->Points[corner], 0);
  }
  return SideOf(this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]]) > 0 &&
    !this->IsAnyIn(this->Boxes.size() - 1, 0, box, corners);
}

void EarCutter::Cut(std::size_t ear)
{
  this->Next[this->Previous[ear]] = this->Next[ear];
  this->Previous[this->Next[ear]] = this->Previous[ear];
  this->IsCut[ear] = 1;
  std::size_t number = ear;
  for (std::vector<Box>& level : this->Boxes)
  {
    number /= FanOut;
    --level[number].Left;
  }
}

void EarCutter::Run(std::vector<std::array<Index, 3>>& triangles)
{
  const auto add = [&](std::size_t ear)
  {
    triangles.push_back(
      { this->Ring[this->Previous[ear]], this->Ring[ear], this->Ring[this->Next[ear]] });
  };
  std::size_t ear = 0;
  for (std::size_t left = this->Ring.size(); left > 3; --left)
  {
    for (std::size_t tried = 0; tried < left && !this->IsEmptyEar(ear); ++tried)
    {
      ear = this->Next[ear];
    }
    add(ear);
    this->Cut(ear);
    // Go on where the last ear was: long thin runs of triangles instead of one fan.
    ear = this->Next[this->Next[ear]];
  }
  add(this->Next[std::find(this->IsCut.begin(), this->IsCut.end(), 0) - this->IsCut.begin()]);
}
}

void CutEars(const std::vector<Point2>& points, const std::vector<Index>& ring,
  std::vector<std::array<Index, 3>>& triangles)
{
  EarCutter(points, ring).Run(triangles);
}
}
