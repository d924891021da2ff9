// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceImage.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Contour vertices stay this fraction of the spacing away from samples. Where a sample equals the
/// threshold, contours would touch there otherwise.
constexpr double kDistance = 1e-4;

/**
 * Marching squares that walks each contour from square to square.
 *
 * Sample (i, j) counts the ring; square (i, j) has the corners 0 (i, j), 1 (i + 1, j),
 * 2 (i + 1, j + 1), 3 (i, j + 1), and its side s runs from corner s to s + 1. As the corners run
 * (counter-clockwise), a contour with the interior on its left enters through a side from an
 * inside corner to an outside one and leaves through a side from outside to inside.
 */
class SquareWalker
{
public:
  SquareWalker(const SamplePlane& plane, double threshold, const std::vector<double>& us,
    const std::vector<double>& vs, Precision precision);

  PlaneContours Run();

private:
  struct Place
  {
    Index I, J; ///< the square
    int Side;   ///< through which the contour enters it
  };

  std::size_t Sample(Index i, Index j) const
  {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(j) * this->CountU;
  }
  bool IsInside(const Place& place, int corner) const;
  bool IsJoined(const Place& place) const;
  void Follow(Place place);
  int ExitSide(const Place& place) const;
  void Leave(Place& place, int side);
  void AddCrossingU(Index i, Index j);
  void AddCrossingV(Index i, Index j);
  double Fraction(std::size_t a, std::size_t b) const;

  const double Threshold;
  const std::vector<double>& Us;
  const std::vector<double>& Vs;
  const Precision Stored;
  const Index CountU, CountV; ///< samples including the ring
  std::vector<double> Values; ///< NaN on the ring
  std::vector<std::uint8_t> Inside;
  std::vector<std::size_t> Joined;   ///< squares, by the samples at their lower left corners
  std::vector<std::uint8_t> Visited; ///< line from sample (i, j) to (i + 1, j)
  PlaneContours Contours;
};

SquareWalker::SquareWalker(const SamplePlane& plane, double threshold,
  const std::vector<double>& us, const std::vector<double>& vs, Precision precision)
  : Threshold(threshold)
  , Us(us)
  , Vs(vs)
  , Stored(precision)
  , CountU(plane.SizeU + 2)
  , CountV(plane.SizeV + 2)
{
  const std::size_t count = this->Sample(0, this->CountV);
  this->Values.assign(count, std::nan(""));
  this->Inside.assign(count, 0);
  this->Visited.assign(count, 0);
  const double* value = plane.Values.data();
  for (Index j = 1; j <= plane.SizeV; ++j)
  {
    for (Index i = 1; i <= plane.SizeU; ++i, ++value)
    {
      this->Values[this->Sample(i, j)] = *value;
      this->Inside[this->Sample(i, j)] = *value >= threshold;
    }
  }
  for (const std::size_t sample : plane.Joined)
  {
    this->Joined.push_back(this->Sample(
      static_cast<Index>(sample % plane.SizeU) + 1, static_cast<Index>(sample / plane.SizeU) + 1));
  }
}

/// Every contour crosses some line between samples of one row, so it is found there.
PlaneContours SquareWalker::Run()
{
  for (Index j = 1; j + 1 < this->CountV; ++j)
  {
    for (Index i = 0; i + 1 < this->CountU; ++i)
    {
      const std::size_t sample = this->Sample(i, j);
      if (this->Inside[sample] == this->Inside[sample + 1] || this->Visited[sample])
      {
        continue;
      }
      // The line is side 0 of the square above it and side 2 of the one below it.
      this->Follow(this->Inside[sample] ? Place{ i, j, 0 } : Place{ i, j - 1, 2 });
    }
  }
  return std::move(this->Contours);
}

bool SquareWalker::IsInside(const Place& place, int corner) const
{
  const Index i = place.I + (corner == 1 || corner == 2);
  const Index j = place.J + (corner == 2 || corner == 3);
  return this->Inside[this->Sample(i, j)] != 0;
}

void SquareWalker::Follow(Place place)
{
  const Place first = place;
  do
  {
    this->Leave(place, this->ExitSide(place));
  } while (place.I != first.I || place.J != first.J || place.Side != first.Side);
  this->Contours.CloseContour();
}

bool SquareWalker::IsJoined(const Place& place) const
{
  return std::binary_search(
    this->Joined.begin(), this->Joined.end(), this->Sample(place.I, place.J));
}

/// Going clockwise from the entry keeps an inside corner apart from the one opposite; the other way
/// around joins them.
int SquareWalker::ExitSide(const Place& place) const
{
  const int step = this->IsJoined(place) ? 1 : 3;
  int side = place.Side;
  do
  {
    side = (side + step) & 3;
  } while (this->IsInside(place, side) || !this->IsInside(place, (side + 1) & 3));
  return side;
}

/// Draws the vertex on the side and goes to the square across it.
void SquareWalker::Leave(Place& place, int side)
{
  switch (side)
  {
    case 0:
      this->AddCrossingU(place.I, place.J);
      place = { place.I, place.J - 1, 2 };
      break;
    case 1:
      this->AddCrossingV(place.I + 1, place.J);
      place = { place.I + 1, place.J, 3 };
      break;
    case 2:
      this->AddCrossingU(place.I, place.J + 1);
      place = { place.I, place.J + 1, 0 };
      break;
    default:
      this->AddCrossingV(place.I, place.J);
      place = { place.I - 1, place.J, 1 };
      break;
  }
}

/// On the line from sample (i, j) to (i + 1, j).
void SquareWalker::AddCrossingU(Index i, Index j)
{
  const std::size_t sample = this->Sample(i, j);
  this->Visited[sample] = 1;
  const double t = this->Fraction(sample, sample + 1);
  this->Contours.AddVertex(
    RoundTo(this->Stored, this->Us[i] + t * (this->Us[i + 1] - this->Us[i])), this->Vs[j]);
}

/// On the line from sample (i, j) to (i, j + 1).
void SquareWalker::AddCrossingV(Index i, Index j)
{
  const double t = this->Fraction(this->Sample(i, j), this->Sample(i, j + 1));
  this->Contours.AddVertex(
    this->Us[i], RoundTo(this->Stored, this->Vs[j] + t * (this->Vs[j + 1] - this->Vs[j])));
}

double SquareWalker::Fraction(std::size_t a, std::size_t b) const
{
  const double difference = this->Values[b] - this->Values[a];
  if (!std::isfinite(difference))
  {
    return 0.5;
  }
  const double t = (this->Threshold - this->Values[a]) / difference;
  return std::max(kDistance, std::min(1.0 - kDistance, t));
}
}

PlaneContours SliceImage(const SamplePlane& plane, double threshold, const std::vector<double>& us,
  const std::vector<double>& vs, Precision precision)
{
  return SquareWalker(plane, threshold, us, vs, precision).Run();
}
}
