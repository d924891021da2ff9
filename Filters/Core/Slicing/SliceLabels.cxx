// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceLabels.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace orthoslices
{
namespace
{
/// The samples that a label has at most.
struct SampleBox
{
  Index FirstU = std::numeric_limits<Index>::max(), LastU = -1;
  Index FirstV = std::numeric_limits<Index>::max(), LastV = -1;

  void Add(Index i, Index j)
  {
    this->FirstU = std::min(this->FirstU, i);
    this->LastU = std::max(this->LastU, i);
    this->FirstV = std::min(this->FirstV, j);
    this->LastV = std::max(this->LastV, j);
  }
};

using LabelBoxes = std::map<double, SampleBox>;

LabelBoxes FindLabels(const SamplePlane& plane, double background)
{
  LabelBoxes boxes;
  auto last = boxes.end(); // neighbours mostly have the same label
  for (Index j = 0; j < plane.SizeV; ++j)
  {
    for (Index i = 0; i < plane.SizeU; ++i)
    {
      const double value = plane.Values[i + static_cast<std::size_t>(j) * plane.SizeU];
      if (value == background || !std::isfinite(value))
      {
        continue;
      }
      if (last == boxes.end() || last->first != value)
      {
        last = boxes.emplace(value, SampleBox()).first;
      }
      last->second.Add(i, j);
    }
  }
  return boxes;
}

/// 1 for the samples of a label and 0 for the others of its box.
SamplePlane CutOut(const SamplePlane& plane, double label, const SampleBox& box)
{
  SamplePlane part;
  part.SizeU = box.LastU - box.FirstU + 1;
  part.SizeV = box.LastV - box.FirstV + 1;
  part.Values.reserve(static_cast<std::size_t>(part.SizeU) * part.SizeV);
  for (Index j = box.FirstV; j <= box.LastV; ++j)
  {
    const double* row = plane.Values.data() + static_cast<std::size_t>(j) * plane.SizeU;
    std::transform(row + box.FirstU, row + box.LastU + 1, std::back_inserter(part.Values),
      [label](double value) { return value == label ? 1.0 : 0.0; });
  }
  return part;
}

/// The coordinates of some samples, with one more on both ends.
std::vector<double> CutOut(const std::vector<double>& coordinates, Index first, Index last)
{
  return { coordinates.begin() + first, coordinates.begin() + last + 3 };
}

/// The squares of samples in which several labels meet.
class LabelMeetings
{
public:
  LabelMeetings(const SamplePlane& plane, double background, const std::vector<double>& us,
    const std::vector<double>& vs, Precision precision)
    : Plane(plane)
    , Background(background)
    , Us(us)
    , Vs(vs)
    , Stored(precision)
  {
  }

  /// The squares within the samples of a label in which it is on one diagonal and a lesser one,
  /// not the background, on the other: as SamplePlane::Joined has them.
  std::vector<std::size_t> FindJoined(double label, const SampleBox& box) const
  {
    std::vector<std::size_t> joined;
    const Index size = box.LastU - box.FirstU + 1;
    for (Index j = box.FirstV; j < box.LastV; ++j)
    {
      for (Index i = box.FirstU; i < box.LastU; ++i)
      {
        const Corners corners = this->CornersOf(i + 1, j + 1); // past the ring
        const double other = corners[corners[0] == label ? 1 : 0];
        if (other < label && other != None && corners[0] == corners[2] &&
          corners[1] == corners[3] && (corners[0] == label || corners[1] == label))
        {
          joined.push_back(i - box.FirstU + static_cast<std::size_t>(j - box.FirstV) * size);
        }
      }
    }
    return joined;
  }

  /// Appends the points at which a label meets others between two of its vertices, which follow each
  /// other.
  void AddBetween(double label, const Point2& from, const Point2& to, LabelContours& contours) const
  {
    const Point2 middle = Between(from, to, 0.5);
    const Index i = SquareOf(this->Us, middle[0]), j = SquareOf(this->Vs, middle[1]);
    const Corners corners = this->CornersOf(i, j);
    const auto add = [&](const Point2& p)
    {
      contours.Contours.U.push_back(p[0]);
      contours.Contours.V.push_back(p[1]);
    };
    if (MeetInMiddle(corners))
    {
      add(this->PlaceIn(i, j, 0.5, 0.5));
      return;
    }
    const int apart = CornerApart(corners);
    if (apart < 0)
    {
      return;
    }
    // The middles of the two lines that cut off the corners of the label that stays apart.
    const double left = apart == 0 ? 0.25 : 0.75;
    std::array<Point2, 2> places{ this->PlaceIn(i, j, left, 0.25),
      this->PlaceIn(i, j, 1.0 - left, 0.75) };
    const bool isApart = label == corners[apart];
    const Point2& beside = isApart ? middle : from;
    if (Distance(beside, places[1]) < Distance(beside, places[0]))
    {
      std::swap(places[0], places[1]);
    }
    add(places[0]);
    if (!isApart)
    {
      add(places[1]);
    }
  }

private:
  using Corners = std::array<double, 4>;
  static constexpr double None = -std::numeric_limits<double>::infinity();

  static int CountDifferent(Corners corners)
  {
    std::sort(corners.begin(), corners.end());
    return static_cast<int>(std::unique(corners.begin(), corners.end()) - corners.begin());
  }

  /// Whether all that have a corner of a square meet in its middle: three or four different ones.
  static bool MeetInMiddle(const Corners& corners)
  {
    const bool isDiagonal = corners[0] == corners[2] || corners[1] == corners[3];
    return !isDiagonal && CountDifferent(corners) >= 3;
  }

  /// The first one of two corners on a diagonal whose common label stays apart from itself, while two
  /// others meet between them; -1 if there are none, or if background is between them.
  static int CornerApart(const Corners& corners)
  {
    const bool hasBackground = std::find(corners.begin(), corners.end(), None) != corners.end();
    if (hasBackground || CountDifferent(corners) != 3)
    {
      return -1;
    }
    return corners[0] == corners[2] ? 0 : corners[1] == corners[3] ? 1 : -1;
  }

  Corners CornersOf(Index i, Index j) const
  {
    return { this->LabelAt(i, j), this->LabelAt(i + 1, j), this->LabelAt(i + 1, j + 1),
      this->LabelAt(i, j + 1) };
  }

  /// A place in a square of samples, as shares of its sides.
  Point2 PlaceIn(Index i, Index j, double shareU, double shareV) const
  {
    return { RoundTo(this->Stored, (1.0 - shareU) * this->Us[i] + shareU * this->Us[i + 1]),
      RoundTo(this->Stored, (1.0 - shareV) * this->Vs[j] + shareV * this->Vs[j + 1]) };
  }

  /// The number of the sample before a coordinate, the ring's first one being 0.
  static Index SquareOf(const std::vector<double>& coordinates, double x)
  {
    const auto next = std::upper_bound(coordinates.begin() + 1, coordinates.end() - 1, x);
    return static_cast<Index>(next - coordinates.begin()) - 1;
  }

  /// What is not finite is background, as the ring is.
  double LabelAt(Index i, Index j) const
  {
    if (i < 1 || j < 1 || i > this->Plane.SizeU || j > this->Plane.SizeV)
    {
      return None;
    }
    const double value =
      this->Plane.Values[i - 1 + static_cast<std::size_t>(j - 1) * this->Plane.SizeU];
    return std::isfinite(value) && value != this->Background ? value : None;
  }

  const SamplePlane& Plane;
  const double Background;
  const std::vector<double>& Us;
  const std::vector<double>& Vs;
  const Precision Stored;
};

/// Appends contours of a label, with vertices where it meets others.
void Append(
  const PlaneContours& from, double label, const LabelMeetings& meetings, LabelContours& to)
{
  for (Index contour = 0; contour < from.Count(); ++contour)
  {
    const Index begin = from.Offsets[contour], end = from.Offsets[contour + 1];
    for (Index i = begin; i < end; ++i)
    {
      const Point2 p{ from.U[i], from.V[i] };
      const Index next = i + 1 < end ? i + 1 : begin;
      to.Contours.U.push_back(p[0]);
      to.Contours.V.push_back(p[1]);
      meetings.AddBetween(label, p, { from.U[next], from.V[next] }, to);
    }
    to.Contours.Offsets.push_back(static_cast<Index>(to.Contours.U.size()));
    to.Labels.push_back(label);
  }
}
}

LabelContours SliceLabels(const SamplePlane& plane, double background,
  const std::vector<double>& us, const std::vector<double>& vs, Precision precision)
{
  const LabelMeetings meetings(plane, background, us, vs, precision);
  LabelContours contours;
  for (const auto& label : FindLabels(plane, background))
  {
    const SampleBox& box = label.second;
    SamplePlane part = CutOut(plane, label.first, box);
    part.Joined = meetings.FindJoined(label.first, box);
    Append(SliceImage(part, 0.5, CutOut(us, box.FirstU, box.LastU),
             CutOut(vs, box.FirstV, box.LastV), precision),
      label.first, meetings, contours);
  }
  return contours;
}
}
