// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceLabels.h"

#include <algorithm>
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

void Append(const PlaneContours& from, double label, LabelContours& to)
{
  const Index before = static_cast<Index>(to.Contours.U.size());
  to.Contours.U.insert(to.Contours.U.end(), from.U.begin(), from.U.end());
  to.Contours.V.insert(to.Contours.V.end(), from.V.begin(), from.V.end());
  for (Index i = 0; i < from.Count(); ++i)
  {
    to.Contours.Offsets.push_back(before + from.Offsets[i + 1]);
    to.Labels.push_back(label);
  }
}
}

LabelContours SliceLabels(const SamplePlane& plane, double background,
  const std::vector<double>& us, const std::vector<double>& vs, Precision precision)
{
  LabelContours contours;
  for (const auto& label : FindLabels(plane, background))
  {
    const SampleBox& box = label.second;
    Append(SliceImage(CutOut(plane, label.first, box), 0.5, CutOut(us, box.FirstU, box.LastU),
             CutOut(vs, box.FirstV, box.LastV), precision),
      label.first, contours);
  }
  return contours;
}
}
