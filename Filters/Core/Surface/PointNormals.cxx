// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/PointNormals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Triangles that are looked at or passed over together.
constexpr std::int64_t BlockSize = 2048;

/// The area vector of a triangle, twice as long as the area.
template <typename Coordinate, typename Id>
std::array<float, 3> AreaOf(const Coordinate* xyz, const Id* triangle)
{
  const Coordinate* a = xyz + 3 * static_cast<std::int64_t>(triangle[0]);
  const Coordinate* b = xyz + 3 * static_cast<std::int64_t>(triangle[1]);
  const Coordinate* c = xyz + 3 * static_cast<std::int64_t>(triangle[2]);
  const double ab[3] = { double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2] };
  const double ac[3] = { double(c[0]) - a[0], double(c[1]) - a[1], double(c[2]) - a[2] };
  return { static_cast<float>(ab[1] * ac[2] - ab[2] * ac[1]),
    static_cast<float>(ab[2] * ac[0] - ab[0] * ac[2]),
    static_cast<float>(ab[0] * ac[1] - ab[1] * ac[0]) };
}

/// A vector of a triangle at a point that other parts of the surface have, too.
struct Contribution
{
  std::int64_t Point; ///< its id in the whole surface
  std::array<float, 3> Vector;
  float Unused; ///< no bytes without a value are sent
};

/// Hands the other parts what this one has at common points, and sets `sums` there to that of all.
/// The parts are in the order of their triangles.
void AddAcross(const SharedPoints& shared, const std::vector<Contribution>& own, float* sums)
{
  for (std::size_t point = 0; point < shared.Ids.size(); ++point)
  {
    if (shared.IsShared[point] != 0)
    {
      std::fill_n(sums + 3 * point, 3, 0.0f);
    }
  }
  for (const auto& ofPart : GatherValues(shared.Processes, own))
  {
    for (const Contribution& contribution : ofPart)
    {
      const auto id = std::lower_bound(shared.Ids.begin(), shared.Ids.end(), contribution.Point);
      if (id != shared.Ids.end() && *id == contribution.Point)
      {
        float* sum = sums + 3 * (id - shared.Ids.begin());
        for (int k = 0; k < 3; ++k)
        {
          sum[k] += contribution.Vector[k];
        }
      }
    }
  }
}

/**
 * Adds up vectors of triangles at their corners, always in the order of the triangles, so that sums
 * are the same for any number of threads: each thread has a part of the points, and passes over
 * blocks of triangles that have none of them. Sums at points that are shared with other processes
 * are those of all.
 */
template <typename Id>
class CornerSums
{
public:
  CornerSums(const Id* triangles, std::int64_t count, std::size_t points, std::size_t parts,
    const Execution& execution, const SharedPoints* shared)
    : Triangles(triangles)
    , Count(count)
    , Points(points)
    , Parts(parts)
    , Execute(execution)
    , Shared(shared)
    , Lowest(static_cast<std::size_t>((count + BlockSize - 1) / BlockSize))
    , Highest(this->Lowest.size())
  {
    execution.For(this->Lowest.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t block = begin; block < end; ++block)
        {
          const auto ends = std::minmax_element(
            triangles + 3 * this->FirstOf(block), triangles + 3 * this->FirstOf(block + 1));
          this->Lowest[block] = *ends.first;
          this->Highest[block] = *ends.second;
        }
      });
  }

  /// Adds vectorOf(triangle) to `sums`, x, y, z of each point.
  template <typename VectorOf>
  void Add(VectorOf&& vectorOf, float* sums) const
  {
    this->Execute.For(this->Parts,
      [&](std::size_t begin, std::size_t end)
      {
        const std::size_t first = this->Points * begin / this->Parts;
        const std::size_t last = this->Points * end / this->Parts;
        this->AddTo(static_cast<Id>(first), static_cast<Id>(last), vectorOf, sums);
      });
    if (this->Shared != nullptr)
    {
      AddAcross(*this->Shared, this->ListShared(vectorOf), sums);
    }
  }

private:
  std::int64_t FirstOf(std::size_t block) const
  {
    return std::min(this->Count, static_cast<std::int64_t>(block) * BlockSize);
  }

  template <typename VectorOf>
  void AddTo(Id first, Id last, VectorOf&& vectorOf, float* sums) const
  {
    for (std::size_t block = 0; block < this->Lowest.size(); ++block)
    {
      if (this->Highest[block] < first || this->Lowest[block] >= last)
      {
        continue;
      }
      const Id* end = this->Triangles + 3 * this->FirstOf(block + 1);
      for (const Id* t = this->Triangles + 3 * this->FirstOf(block); t != end; t += 3)
      {
        const auto isHere = [&](Id point) { return point >= first && point < last; };
        if (!isHere(t[0]) && !isHere(t[1]) && !isHere(t[2]))
        {
          continue;
        }
        const std::array<float, 3> vector = vectorOf(t);
        for (int corner = 0; corner < 3; ++corner)
        {
          float* sum = sums + 3 * static_cast<std::int64_t>(t[corner]);
          for (int k = 0; k < 3 && isHere(t[corner]); ++k)
          {
            sum[k] += vector[k];
          }
        }
      }
    }
  }

  /// What the triangles have at points that are shared.
  template <typename VectorOf>
  std::vector<Contribution> ListShared(VectorOf&& vectorOf) const
  {
    std::vector<Contribution> own;
    const auto isShared = [&](Id point) { return this->Shared->IsShared[point] != 0; };
    for (const Id* t = this->Triangles; t != this->Triangles + 3 * this->Count; t += 3)
    {
      if (!isShared(t[0]) && !isShared(t[1]) && !isShared(t[2]))
      {
        continue;
      }
      const std::array<float, 3> vector = vectorOf(t);
      for (int corner = 0; corner < 3; ++corner)
      {
        if (isShared(t[corner]))
        {
          own.push_back({ this->Shared->Ids[t[corner]], vector, 0.0f });
        }
      }
    }
    return own;
  }

  const Id* Triangles;
  std::int64_t Count;
  std::size_t Points, Parts;
  const Execution& Execute;
  const SharedPoints* Shared;
  std::vector<Id> Lowest, Highest; ///< points of each block
};

/// The squared cosine of 30 degrees.
constexpr double SimilarCosine2 = 0.75;

/// Whether a normal is within 30 degrees of an area vector.
bool IsSimilar(const float* normal, const float* area)
{
  double product = 0.0, squared = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    product += double(normal[k]) * area[k];
    squared += double(area[k]) * area[k];
  }
  return product > 0.0 && product * product > SimilarCosine2 * squared;
}

/// Divides by the length; zero remains zero.
void Normalize(float* n)
{
  const double length = std::hypot(double(n[0]), double(n[1]), double(n[2]));
  const double scale = length > 0.0 ? 1.0 / length : 0.0;
  std::transform(n, n + 3, n, [&](float x) { return static_cast<float>(scale * x); });
}
}

template <typename Coordinate, typename Id>
void ComputePointNormals(const Coordinate* xyz, std::size_t points, const Id* triangles,
  std::int64_t count, const std::vector<float>& smooth, const Execution& execution, float* normals,
  std::size_t parts, const SharedPoints* shared)
{
  std::fill_n(normals, 3 * points, 0.0f);
  const CornerSums<Id> corners(triangles, count, points, parts, execution, shared);
  corners.Add([&](const Id* triangle) { return AreaOf(xyz, triangle); }, normals);
  // The sum of the area vectors at the corners of the triangles around: where these are slivers,
  // those of the next triangles decide.
  const bool anySmooth = shared != nullptr ? shared->AnySmooth : !smooth.empty();
  std::vector<float> around(anySmooth ? 3 * points : 0, 0.0f);
  if (anySmooth)
  {
    const auto at = [&](Id point, int k)
    { return normals[3 * static_cast<std::int64_t>(point) + k]; };
    const auto sumAt = [&](const Id* t, int k) { return at(t[0], k) + at(t[1], k) + at(t[2], k); };
    corners.Add(
      [&](const Id* t) {
        return std::array<float, 3>{ sumAt(t, 0), sumAt(t, 1), sumAt(t, 2) };
      },
      around.data());
  }
  execution.For(points,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        float* n = normals + 3 * i;
        const float* s = smooth.empty() ? n : smooth.data() + 3 * i;
        if (!smooth.empty() && (IsSimilar(s, n) || IsSimilar(s, around.data() + 3 * i)))
        {
          std::copy_n(s, 3, n);
        }
        else
        {
          Normalize(n);
        }
      }
    });
}

#define ORTHOSLICES_INSTANTIATE(Coordinate, Id)                                              \
  template void ComputePointNormals(const Coordinate*, std::size_t, const Id*, std::int64_t, \
    const std::vector<float>&, const Execution&, float*, std::size_t, const SharedPoints*);
ORTHOSLICES_INSTANTIATE(float, std::int32_t)
ORTHOSLICES_INSTANTIATE(float, long long)
ORTHOSLICES_INSTANTIATE(double, std::int32_t)
ORTHOSLICES_INSTANTIATE(double, long long)
#undef ORTHOSLICES_INSTANTIATE
}
