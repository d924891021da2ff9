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

/// The squares of samples in which several labels meet in one point.
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

  /// Whether labels meet in the square in which a side of a contour lies, given by its middle; and
  /// where.
  bool Find(const Point2& middle, Point2& meeting) const
  {
    const Index i = SquareOf(this->Us, middle[0]), j = SquareOf(this->Vs, middle[1]);
    meeting = { RoundTo(this->Stored, 0.5 * (this->Us[i] + this->Us[i + 1])),
      RoundTo(this->Stored, 0.5 * (this->Vs[j] + this->Vs[j + 1])) };
    std::array<double, 4> corners{ this->LabelAt(i, j), this->LabelAt(i + 1, j),
      this->LabelAt(i + 1, j + 1), this->LabelAt(i, j + 1) };
    const bool isDiagonal = corners[0] == corners[2] || corners[1] == corners[3];
    std::sort(corners.begin(), corners.end());
    return !isDiagonal && std::unique(corners.begin(), corners.end()) - corners.begin() >= 3;
  }

private:
  /// The number of the sample before a coordinate, the ring's first one being 0.
  static Index SquareOf(const std::vector<double>& coordinates, double x)
  {
    const auto next = std::upper_bound(coordinates.begin() + 1, coordinates.end() - 1, x);
    return static_cast<Index>(next - coordinates.begin()) - 1;
  }

  /// What is not finite is background, as the ring is.
  double LabelAt(Index i, Index j) const
  {
    constexpr double none = -std::numeric_limits<double>::infinity();
    if (i < 1 || j < 1 || i > this->Plane.SizeU || j > this->Plane.SizeV)
    {
      return none;
    }
    const double value =
      this->Plane.Values[i - 1 + static_cast<std::size_t>(j - 1) * this->Plane.SizeU];
    return std::isfinite(value) && value != this->Background ? value : none;
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
      Point2 meeting;
      if (meetings.Find(Between(p, { from.U[next], from.V[next] }, 0.5), meeting))
      {
        to.Contours.U.push_back(meeting[0]);
        to.Contours.V.push_back(meeting[1]);
      }
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
    Append(SliceImage(CutOut(plane, label.first, box), 0.5, CutOut(us, box.FirstU, box.LastU),
             CutOut(vs, box.FirstV, box.LastV), precision),
      label.first, meetings, contours);
  }
  return contours;
}
}
