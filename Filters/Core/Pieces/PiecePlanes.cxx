// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/PiecePlanes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace orthoslices
{
namespace
{
/// Vertices may be off their plane by this share of the distance between slices.
constexpr double LittleShare = 0.1;

/// How far from the median of a piece with noise its slice may lie, in terms of the greatest noise:
/// other pieces of the slice are off on the other side, and some of them by more than their noise,
/// as pieces that have lost points do not show all of it.
constexpr double NoiseReach = 3.0;

/// The plane of a piece, and how far its vertices are off it at most.
struct PiecePlane
{
  Index Piece;
  double Coordinate;
  double Noise;
};

bool IsPlanar(const Pieces& pieces, Index piece, double tolerance)
{
  const double first = pieces.W[pieces.Offsets[piece]];
  for (Index i = pieces.Offsets[piece]; i < pieces.Offsets[piece + 1]; ++i)
  {
    // Not a number is not planar, but no matter of planes either.
    if (std::abs(pieces.W[i] - first) > tolerance)
    {
      return false;
    }
  }
  return true;
}

/// The planes of the real pieces whose coordinates are finite.
std::vector<PiecePlane> ListPlanes(const Pieces& pieces)
{
  std::vector<PiecePlane> planes;
  std::vector<double> values;
  for (Index piece = 0; piece < pieces.Count(); ++piece)
  {
    values.assign(
      pieces.W.begin() + pieces.Offsets[piece], pieces.W.begin() + pieces.Offsets[piece + 1]);
    const auto isFinite = [](double w) { return std::isfinite(w); };
    if (pieces.IsVirtual(piece) || !std::all_of(values.begin(), values.end(), isFinite))
    {
      continue;
    }
    const auto middle = values.begin() + (values.size() - 1) / 2;
    std::nth_element(values.begin(), middle, values.end());
    const double median = *middle;
    double noise = 0.0;
    for (const double w : values)
    {
      noise = std::max(noise, std::abs(w - median));
    }
    planes.push_back({ piece, median, noise });
  }
  return planes;
}

/// The coordinate of a slice: the median of its pieces without noise, if it has any, else of all.
double CoordinateOf(const std::vector<PiecePlane>& members)
{
  std::vector<double> exact, all;
  for (const PiecePlane& plane : members)
  {
    all.push_back(plane.Coordinate);
    if (plane.Noise == 0.0)
    {
      exact.push_back(plane.Coordinate);
    }
  }
  std::vector<double>& values = exact.empty() ? all : exact;
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) / 2];
}

/// The slices if noise up to `most` is noise, and pieces with more of it say nothing: intervals in
/// which the slices of the pieces lie are taken together where they meet.
std::vector<double> FindSlices(const std::vector<PiecePlane>& planes, double most)
{
  const auto radius = [most](const PiecePlane& plane)
  { return plane.Noise > 0.0 ? NoiseReach * most : 0.0; };
  std::vector<PiecePlane> order;
  std::copy_if(planes.begin(), planes.end(), std::back_inserter(order),
    [most](const PiecePlane& plane) { return plane.Noise <= most; });
  std::stable_sort(order.begin(), order.end(),
    [&](const PiecePlane& a, const PiecePlane& b)
    { return a.Coordinate - radius(a) < b.Coordinate - radius(b); });
  std::vector<double> slices;
  std::vector<PiecePlane> members;
  double reach = -HUGE_VAL; ///< how far up the members say that their slice may lie
  for (const PiecePlane& plane : order)
  {
    if (!members.empty() && plane.Coordinate - radius(plane) > reach)
    {
      slices.push_back(CoordinateOf(members));
      members.clear();
    }
    reach = std::max(reach, plane.Coordinate + radius(plane));
    members.push_back(plane);
  }
  if (!members.empty())
  {
    slices.push_back(CoordinateOf(members));
  }
  return slices;
}

/// How far vertices may be off, with these slices. If the noise of all pieces is more than little,
/// there are none, and nothing is known.
double AllowedDistance(const std::vector<double>& slices, double tolerance, double alone)
{
  if (slices.empty())
  {
    return tolerance;
  }
  if (slices.size() < 2)
  {
    return std::max(alone, tolerance);
  }
  double least = slices.back() - slices.front();
  for (std::size_t i = 1; i < slices.size(); ++i)
  {
    least = std::min(least, slices[i] - slices[i - 1]);
  }
  return std::max(LittleShare * least, tolerance);
}

/// The slices with the greatest noise that is little against their distance. At most 64 levels of
/// noise are tried, each at most half the one before.
std::vector<double> FindSlices(
  const std::vector<PiecePlane>& planes, double tolerance, double alone, double& allowed)
{
  std::vector<double> slices;
  double most = HUGE_VAL;
  for (int level = 0; level < 64; ++level)
  {
    double noise = 0.0;
    for (const PiecePlane& plane : planes)
    {
      noise = plane.Noise <= most ? std::max(noise, plane.Noise) : noise;
    }
    slices = FindSlices(planes, noise);
    allowed = AllowedDistance(slices, tolerance, alone);
    if (noise <= allowed)
    {
      break;
    }
    most = 0.5 * noise;
  }
  return slices;
}

double NearestSlice(const std::vector<double>& slices, double coordinate)
{
  const auto above = std::lower_bound(slices.begin(), slices.end(), coordinate);
  if (above == slices.begin())
  {
    return *above;
  }
  return above == slices.end() || coordinate - above[-1] <= *above - coordinate ? above[-1]
                                                                                : *above;
}
}

std::vector<PlaneShift> MoveOntoPlanes(double tolerance, double alone, Pieces& pieces)
{
  bool planar = true;
  for (Index piece = 0; piece < pieces.Count() && planar; ++piece)
  {
    planar = IsPlanar(pieces, piece, tolerance);
  }
  const std::vector<PiecePlane> planes = planar ? std::vector<PiecePlane>() : ListPlanes(pieces);
  double allowed = 0.0;
  const std::vector<double> slices = FindSlices(planes, tolerance, alone, allowed);
  if (slices.empty())
  {
    return {};
  }
  std::vector<PlaneShift> shifts(pieces.Count());
  for (const PiecePlane& plane : planes)
  {
    const double slice = NearestSlice(slices, plane.Coordinate);
    if (std::abs(plane.Coordinate - slice) + plane.Noise > allowed)
    {
      continue;
    }
    PlaneShift& shift = shifts[plane.Piece];
    for (Index i = pieces.Offsets[plane.Piece]; i < pieces.Offsets[plane.Piece + 1]; ++i)
    {
      const double distance = std::abs(pieces.W[i] - slice);
      if (distance > shift.Distance)
      {
        shift = { i, distance, pieces.W[i] };
      }
      pieces.W[i] = slice;
    }
  }
  return shifts;
}
}
