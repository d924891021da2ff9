// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/MeasureComponents.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// A number that stands for an edge, whichever way it is passed (the finalizer of splitmix64).
std::uint64_t HashOfEdge(std::uint64_t a, std::uint64_t b)
{
  std::uint64_t hash = std::min(a, b) * 0x9e3779b97f4a7c15u + std::max(a, b);
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

/// What is summed up over the triangles of one component.
struct Sums
{
  Point3 Origin{ 0.0, 0.0, 0.0 }; ///< the first point
  double Area = 0.0;
  double SixfoldVolume = 0.0;
  Point3 AreaMoment{ 0.0, 0.0, 0.0 };   ///< three times the integral of the position over the area
  Point3 VolumeMoment{ 0.0, 0.0, 0.0 }; ///< 24 times that over the volume
  std::uint64_t Edges = 0; ///< forwards minus backwards; not 0 if an edge has no counterpart
  std::int64_t Triangles = 0;

  void Add(const Point3& a, const Point3& b, const Point3& c)
  {
    const Point3 from = a - this->Origin;
    const Point3 one = b - a;
    const Point3 other = c - a;
    const Point3 normal = Cross(one, other);
    const Point3 sum = 3.0 * from + one + other;
    const double area = 0.5 * Length(normal);
    const double volume = Dot(from, normal);
    this->Area += area;
    this->SixfoldVolume += volume;
    this->AreaMoment = this->AreaMoment + area * sum;
    this->VolumeMoment = this->VolumeMoment + volume * sum;
    ++this->Triangles;
  }

  void AddEdge(std::uint64_t from, std::uint64_t to)
  {
    const std::uint64_t hash = HashOfEdge(from, to);
    this->Edges += from < to ? hash : std::uint64_t(0) - hash;
  }
};

/// The first point that a process has of a component.
struct Start
{
  std::int64_t Component;
  Point3 Point;
};

/// Gives sums the origins that they have if one process has all triangles.
void ShareOrigins(const Ranks& ranks, const std::vector<Start>& own, std::vector<Sums>& sums)
{
  std::vector<std::uint8_t> known(sums.size(), 0);
  for (const std::vector<Start>& starts : GatherValues(ranks, own))
  {
    for (const Start& start : starts)
    {
      const std::size_t component = static_cast<std::size_t>(start.Component);
      sums[component].Origin = known[component] != 0 ? sums[component].Origin : start.Point;
      known[component] = 1;
    }
  }
}

/// Adds the sums of all processes.
void AddUp(const Ranks& ranks, std::vector<Sums>& sums)
{
  if (!ranks.AreSeveral())
  {
    return;
  }
  struct Part
  {
    std::int64_t Component;
    Sums Sum;
  };
  std::vector<Part> own;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    if (sums[i].Triangles > 0)
    {
      own.push_back({ static_cast<std::int64_t>(i), sums[i] });
    }
    const Point3 origin = sums[i].Origin;
    sums[i] = Sums();
    sums[i].Origin = origin;
  }
  for (const std::vector<Part>& parts : GatherValues(ranks, own))
  {
    for (const Part& part : parts)
    {
      Sums& sum = sums[static_cast<std::size_t>(part.Component)];
      sum.Area += part.Sum.Area;
      sum.SixfoldVolume += part.Sum.SixfoldVolume;
      sum.AreaMoment = sum.AreaMoment + part.Sum.AreaMoment;
      sum.VolumeMoment = sum.VolumeMoment + part.Sum.VolumeMoment;
      sum.Triangles += part.Sum.Triangles;
    }
  }
}

ComponentMeasure MeasureOf(const Sums& sums)
{
  ComponentMeasure measure;
  measure.Triangles = sums.Triangles;
  measure.Area = sums.Area;
  measure.Centroid = sums.Origin;
  const bool closed = sums.Edges == 0;
  measure.Volume = closed ? sums.SixfoldVolume / 6.0 : std::numeric_limits<double>::quiet_NaN();
  // What encloses nothing but rounding has no middle of its volume.
  const double rounding = 1e-12 * std::pow(sums.Area, 1.5);
  if (closed && std::abs(sums.SixfoldVolume) > rounding)
  {
    measure.Centroid = sums.Origin + (0.25 / sums.SixfoldVolume) * sums.VolumeMoment;
  }
  else if (sums.Area > 0.0)
  {
    measure.Centroid = sums.Origin + (1.0 / (3.0 * sums.Area)) * sums.AreaMoment;
  }
  return measure;
}
}

template <typename Coordinate, typename Id>
std::vector<ComponentMeasure> MeasureComponents(const Coordinate* points, const Id* triangles,
  std::int64_t triangleCount, const int* components, int count, bool mayBeOpen, const Ranks& ranks)
{
  const auto point = [&](Id id)
  {
    const Coordinate* p = points + 3 * static_cast<std::int64_t>(id);
    return Point3{ static_cast<double>(p[0]), static_cast<double>(p[1]),
      static_cast<double>(p[2]) };
  };
  std::vector<Sums> sums(count);
  const bool hasOrigins = ranks.AreSeveral();
  if (hasOrigins)
  {
    std::vector<Start> starts;
    std::vector<std::uint8_t> seen(count, 0);
    for (std::int64_t i = 0; i < triangleCount; ++i)
    {
      const int component = components[i];
      if (component >= 0 && component < count && seen[component] == 0)
      {
        seen[component] = 1;
        starts.push_back({ component, point(triangles[3 * i]) });
      }
    }
    ShareOrigins(ranks, starts, sums);
  }
  for (std::int64_t i = 0; i < triangleCount;)
  {
    const int component = components[i];
    if (component < 0 || component >= count)
    {
      ++i;
      continue;
    }
    // Triangles of one component lie side by side: their sums are held in registers.
    Sums sum = sums[component];
    sum.Origin = sum.Triangles == 0 && !hasOrigins ? point(triangles[3 * i]) : sum.Origin;
    const std::int64_t first = i;
    for (; i < triangleCount && components[i] == component; ++i)
    {
      const Id* ids = triangles + 3 * i;
      sum.Add(point(ids[0]), point(ids[1]), point(ids[2]));
    }
    for (std::int64_t corner = 3 * first; mayBeOpen && corner < 3 * i; ++corner)
    {
      sum.AddEdge(triangles[corner], triangles[corner % 3 == 2 ? corner - 2 : corner + 1]);
    }
    sums[component] = sum;
  }
  AddUp(ranks, sums);
  std::vector<ComponentMeasure> measures(count);
  std::transform(sums.begin(), sums.end(), measures.begin(), MeasureOf);
  return measures;
}

#define ORTHOSLICES_DEFINE(Coordinate, Id)                  \
  template std::vector<ComponentMeasure> MeasureComponents( \
    const Coordinate*, const Id*, std::int64_t, const int*, int, bool, const Ranks&);
ORTHOSLICES_DEFINE(float, std::int32_t)
ORTHOSLICES_DEFINE(float, long long)
ORTHOSLICES_DEFINE(double, std::int32_t)
ORTHOSLICES_DEFINE(double, long long)
#undef ORTHOSLICES_DEFINE
}
