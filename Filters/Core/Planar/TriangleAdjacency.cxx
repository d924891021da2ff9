// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/TriangleAdjacency.h"

namespace orthoslices
{
TriangleAdjacency::Diamond TriangleAdjacency::DiamondAround(const TriangleSide& side) const
{
  const TriangleSide back = this->BackOf(side);
  const LinkedTriangle& one = (*this)[side.Triangle];
  const LinkedTriangle& two = (*this)[back.Triangle];
  const int next = (side.Side + 1) % 3, last = (side.Side + 2) % 3;
  const int nextBack = (back.Side + 1) % 3, lastBack = (back.Side + 2) % 3;
  return { side.Triangle, back.Triangle, one.Corners[side.Side], one.Corners[next],
    one.Corners[last], two.Corners[lastBack], one.Neighbors[next], one.Neighbors[last],
    two.Neighbors[nextBack], two.Neighbors[lastBack] };
}

void TriangleAdjacency::Flip(const TriangleSide& side)
{
  const Diamond q = this->DiamondAround(side);
  (*this)[q.One] = { { q.A, q.D, q.C }, { q.AD, q.Two, q.CA } };
  (*this)[q.Two] = { { q.D, q.B, q.C }, { q.DB, q.BC, q.One } };
  this->Relink(q.AD, q.Two, q.One);
  this->Relink(q.BC, q.One, q.Two);
}

void TriangleAdjacency::Divide(Index triangle, Index point)
{
  const auto [a, b, c] = (*this)[triangle].Corners;
  const auto [ab, bc, ca] = (*this)[triangle].Neighbors;
  const Index second = static_cast<Index>(this->size());
  const Index third = second + 1;
  (*this)[triangle] = { { a, b, point }, { ab, second, third } };
  this->push_back({ { b, c, point }, { bc, third, triangle } });
  this->push_back({ { c, a, point }, { ca, triangle, second } });
  this->Relink(bc, triangle, second);
  this->Relink(ca, triangle, third);
}

void TriangleAdjacency::Split(const TriangleSide& side, Index point)
{
  const Diamond q = this->DiamondAround(side);
  const Index third = static_cast<Index>(this->size());
  const Index fourth = third + 1;
  (*this)[q.One] = { { q.C, q.A, point }, { q.CA, q.Two, third } };
  (*this)[q.Two] = { { q.A, q.D, point }, { q.AD, fourth, q.One } };
  this->push_back({ { q.B, q.C, point }, { q.BC, q.One, fourth } });
  this->push_back({ { q.D, q.B, point }, { q.DB, third, q.Two } });
  this->Relink(q.BC, q.One, third);
  this->Relink(q.DB, q.Two, fourth);
}
}
