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
/// A vector of a triangle at a point that other parts of the surface have, too.
struct Contribution
{
  std::int64_t Point; ///< its id in the whole surface
  std::array<float, 3> Vector;
  float Unused; ///< no bytes without a value are sent
};

/// Sums vectors of triangles at their points, in the order of the triangles of the whole surface.
class PointSums
{
public:
  PointSums(const SharedPoints* shared, float* sums)
    : Shared(shared)
    , Sums(sums)
  {
  }

  void Add(std::int64_t point, const float* vector)
  {
    if (this->Shared != nullptr && this->Shared->IsShared[point] != 0)
    {
      this->Across.push_back(
        { this->Shared->Ids[point], { vector[0], vector[1], vector[2] }, 0.0f });
      return;
    }
    float* sum = this->Sums + 3 * point;
    sum[0] += vector[0];
    sum[1] += vector[1];
    sum[2] += vector[2];
  }

  /// Adds what all parts have at the points that are shared. The parts are in the order of their
  /// triangles.
  void Finish()
  {
    if (this->Shared == nullptr)
    {
      return;
    }
    const std::vector<std::int64_t>& ids = this->Shared->Ids;
    for (const auto& ofPart : GatherValues(this->Shared->Processes, this->Across))
    {
      for (const Contribution& contribution : ofPart)
      {
        const auto id = std::lower_bound(ids.begin(), ids.end(), contribution.Point);
        if (id != ids.end() && *id == contribution.Point)
        {
          float* sum = this->Sums + 3 * (id - ids.begin());
          for (int k = 0; k < 3; ++k)
          {
            sum[k] += contribution.Vector[k];
          }
        }
      }
    }
  }

private:
  const SharedPoints* Shared;
  float* Sums;
  std::vector<Contribution> Across;
};

/// Sums the area vectors of the triangles at each point; in a fixed order, so always the same.
template <typename Coordinate, typename Id>
void SumAreas(const Coordinate* xyz, const Id* triangle, std::int64_t count, PointSums sums)
{
  for (const Id* end = triangle + 3 * count; triangle != end; triangle += 3)
  {
    const Coordinate* a = xyz + 3 * static_cast<std::int64_t>(triangle[0]);
    const Coordinate* b = xyz + 3 * static_cast<std::int64_t>(triangle[1]);
    const Coordinate* c = xyz + 3 * static_cast<std::int64_t>(triangle[2]);
    const double ab[3] = { double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2] };
    const double ac[3] = { double(c[0]) - a[0], double(c[1]) - a[1], double(c[2]) - a[2] };
    const float area[3] = { static_cast<float>(ab[1] * ac[2] - ab[2] * ac[1]),
      static_cast<float>(ab[2] * ac[0] - ab[0] * ac[2]),
      static_cast<float>(ab[0] * ac[1] - ab[1] * ac[0]) };
    for (int corner = 0; corner < 3; ++corner)
    {
      sums.Add(static_cast<std::int64_t>(triangle[corner]), area);
    }
  }
  sums.Finish();
}

/// At each point, the sum of the area vectors at the corners of the triangles around: where these
/// are slivers, those of the next triangles decide.
template <typename Id>
std::vector<float> SumAround(const Id* triangle, std::int64_t count, std::size_t points,
  const float* areas, const SharedPoints* shared)
{
  std::vector<float> result(3 * points, 0.0f);
  PointSums sums(shared, result.data());
  for (const Id* end = triangle + 3 * count; triangle != end; triangle += 3)
  {
    float sum[3];
    for (int k = 0; k < 3; ++k)
    {
      sum[k] = areas[3 * triangle[0] + k] + areas[3 * triangle[1] + k] + areas[3 * triangle[2] + k];
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      sums.Add(static_cast<std::int64_t>(triangle[corner]), sum);
    }
  }
  sums.Finish();
  return result;
}

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
  const SharedPoints* shared)
{
  std::fill_n(normals, 3 * points, 0.0f);
  SumAreas(xyz, triangles, count, PointSums(shared, normals));
  const bool anySmooth = shared != nullptr ? shared->AnySmooth : !smooth.empty();
  const std::vector<float> around =
    anySmooth ? SumAround(triangles, count, points, normals, shared) : std::vector<float>();
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
    const std::vector<float>&, const Execution&, float*, const SharedPoints*);
ORTHOSLICES_INSTANTIATE(float, std::int32_t)
ORTHOSLICES_INSTANTIATE(float, long long)
ORTHOSLICES_INSTANTIATE(double, std::int32_t)
ORTHOSLICES_INSTANTIATE(double, long long)
#undef ORTHOSLICES_INSTANTIATE
}
