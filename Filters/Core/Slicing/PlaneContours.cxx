// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/PlaneContours.h"

#include <cstddef>

namespace orthoslices
{
bool PlaneContours::HasThreePlaces() const
{
  const std::size_t a = this->FirstOpen();
  const std::size_t b = a + 1; // differs from a, as consecutive vertices do
  const auto same = [this](std::size_t i, std::size_t j)
  { return this->U[i] == this->U[j] && this->V[i] == this->V[j]; };
  for (std::size_t i = b + 1; i < this->U.size(); ++i)
  {
    if (!same(i, a) && !same(i, b))
    {
      return true;
    }
  }
  return false;
}

/// Leaves so many vertices.
void PlaneContours::Shorten(std::size_t size)
{
  this->U.resize(size);
  this->V.resize(size);
  if (this->Edges.size() > size)
  {
    this->Edges.erase(this->Edges.begin() + static_cast<std::ptrdiff_t>(size), this->Edges.end());
  }
}

void PlaneContours::CloseContour()
{
  const std::size_t first = this->FirstOpen();
  while (this->U.size() > first + 1 && this->U.back() == this->U[first] &&
    this->V.back() == this->V[first])
  {
    this->Shorten(this->U.size() - 1);
  }
  if (this->HasThreePlaces())
  {
    this->Offsets.push_back(static_cast<Index>(this->U.size()));
    return;
  }
  this->Shorten(first);
}
}
