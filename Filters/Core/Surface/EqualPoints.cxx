// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surface/EqualPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <vector>

namespace orthoslices
{
namespace
{
using Place = std::array<float, 3>;

/// The bounds of the places of one process. Of no places, they have none inside.
struct PlaceBox
{
  Place Least{ HUGE_VALF, HUGE_VALF, HUGE_VALF };
  Place Greatest{ -HUGE_VALF, -HUGE_VALF, -HUGE_VALF };

  void Add(const Place& place)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Least[axis] = std::min(this->Least[axis], place[axis]);
      this->Greatest[axis] = std::max(this->Greatest[axis], place[axis]);
    }
  }

  bool Has(const Place& place) const
  {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      inside = inside && this->Least[axis] <= place[axis] && place[axis] <= this->Greatest[axis];
    }
    return inside;
  }
};

/// Where a point is after it was rounded. Of the two zeros it is the positive one, so that equal
/// places have equal bytes.
template <typename Coordinate>
Place RoundToFloat(const Coordinate* point)
{
  Place place;
  std::transform(
    point, point + 3, place.begin(), [](Coordinate x) { return static_cast<float>(x) + 0.0f; });
  return place;
}

/// Groups into which places are divided, by all of their bits: enough for the threads of a large
/// machine, and few enough that each has many.
constexpr std::size_t Groups = 256;

std::size_t GroupOf(const Place& place)
{
  std::uint32_t mixed = 0;
  for (const float x : place)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    // 2^32 by the golden ratio: neighbouring numbers come far apart.
    mixed = (mixed ^ bits) * 0x9E3779B9u;
    mixed ^= mixed >> 15;
  }
  return mixed % Groups;
}

/// Places, group behind group; equal ones are in one group.
struct GroupedPlaces
{
  std::vector<Place> All;
  std::array<std::size_t, Groups + 1> First{}; ///< of each group
  std::array<std::size_t, Groups> Last{};      ///< of those of a group that are left

  /// Leaves one of equal places. Returns how many it takes away.
  std::int64_t RemoveEqual(const Execution& execution)
  {
    execution.For(Groups,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t group = begin; group < end; ++group)
        {
          const auto from = this->All.begin() + static_cast<std::ptrdiff_t>(this->First[group]);
          const auto to = this->All.begin() + static_cast<std::ptrdiff_t>(this->First[group + 1]);
          std::sort(from, to);
          const auto left = std::unique(from, to);
          this->Last[group] = static_cast<std::size_t>(left - this->All.begin());
        }
      });
    std::int64_t removed = 0;
    for (std::size_t group = 0; group < Groups; ++group)
    {
      removed += static_cast<std::int64_t>(this->First[group + 1] - this->Last[group]);
    }
    return removed;
  }

  template <typename Visit>
  void VisitLeft(Visit&& visit) const
  {
    for (std::size_t group = 0; group < Groups; ++group)
    {
      std::for_each(this->All.begin() + static_cast<std::ptrdiff_t>(this->First[group]),
        this->All.begin() + static_cast<std::ptrdiff_t>(this->Last[group]), visit);
    }
  }
};

/// The places of all points that are no duplicates.
template <typename Coordinate>
GroupedPlaces GroupPlaces(
  const Coordinate* points, std::int64_t count, const std::uint8_t* isDuplicate)
{
  const auto forPlaces = [&](auto&& visit)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      if (isDuplicate == nullptr || isDuplicate[i] == 0)
      {
        const Place place = RoundToFloat(points + 3 * i);
        visit(place, GroupOf(place));
      }
    }
  };
  GroupedPlaces places;
  forPlaces([&](const Place&, std::size_t group) { ++places.First[group + 1]; });
  std::partial_sum(places.First.begin(), places.First.end(), places.First.begin());
  places.All.resize(places.First.back());
  std::copy_n(places.First.begin(), Groups, places.Last.begin());
  forPlaces(
    [&](const Place& place, std::size_t group) { places.All[places.Last[group]++] = place; });
  return places;
}

/// How many of the different places of each process one before it has, too, in all. Only those
/// within the bounds of another one can be.
std::int64_t CountAcross(const GroupedPlaces& own, const Ranks& ranks)
{
  PlaceBox box;
  own.VisitLeft([&](const Place& place) { box.Add(place); });
  const auto boxes = GatherValues(ranks, std::vector<PlaceBox>{ box });
  std::vector<Place> near;
  own.VisitLeft(
    [&](const Place& place)
    {
      bool isNear = false;
      for (int rank = 0; rank < ranks.Count; ++rank)
      {
        isNear = isNear || (rank != ranks.Rank && boxes[rank].front().Has(place));
      }
      if (isNear)
      {
        near.push_back(place);
      }
    });
  std::vector<Place> all;
  for (const std::vector<Place>& places : GatherValues(ranks, near))
  {
    all.insert(all.end(), places.begin(), places.end());
  }
  std::sort(all.begin(), all.end());
  return all.end() - std::unique(all.begin(), all.end());
}
}

template <typename Coordinate>
std::int64_t CountEqualInFloat(const Coordinate* points, std::int64_t count,
  const Execution& execution, const Ranks& ranks, const std::uint8_t* isDuplicate)
{
  GroupedPlaces places = GroupPlaces(points, count, isDuplicate);
  const std::int64_t equal = places.RemoveEqual(execution);
  if (!ranks.AreSeveral())
  {
    return equal;
  }
  std::int64_t ofAll = CountAcross(places, ranks);
  for (const std::vector<std::int64_t>& of :
    GatherValues(ranks, std::vector<std::int64_t>{ equal }))
  {
    ofAll += of.front();
  }
  return ofAll;
}

template std::int64_t CountEqualInFloat(
  const float*, std::int64_t, const Execution&, const Ranks&, const std::uint8_t*);
template std::int64_t CountEqualInFloat(
  const double*, std::int64_t, const Execution&, const Ranks&, const std::uint8_t*);
}
