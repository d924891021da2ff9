// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Pieces/CloseGaps.h"

#include "Core/Pieces/TrimOverrun.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Longest gap that is closed, as a share of the length of a curve at it.
constexpr double GreatestShare = 0.2;
/// A gap between the two ends of one curve counts as so much shorter.
constexpr double OwnShare = 0.5;

struct LooseEnd
{
  std::size_t Curve;
  int Which;
  Point2 At;
};

struct Gap
{
  double Rank;      ///< the least is closed first
  double Length;    ///< longer than its rank where it is of one curve
  std::size_t A, B; ///< places in the list of loose ends
};

class GapCloser
{
public:
  GapCloser(
    const JointFilter& mayJoin, std::vector<OpenCurve>& curves, std::vector<OpenCurve>& closed)
    : MayJoin(mayJoin)
    , Curves(curves)
    , Closed(closed)
  {
  }

  /// Closes the gaps between ends that are nearest to each other. Returns whether there were any.
  bool CloseNearest();

private:
  void ListEnds();
  Gap NearestOf(std::size_t end) const;
  void Consider(std::size_t a, std::size_t b, Gap& nearest) const;
  void Close(const Gap& gap);

  const JointFilter& MayJoin;
  std::vector<OpenCurve>& Curves;
  std::vector<OpenCurve>& Closed;
  std::vector<double> Lengths; ///< of the curves
  std::vector<LooseEnd> Ends;  ///< ascending by u
};

void GapCloser::ListEnds()
{
  this->Lengths.clear();
  this->Ends.clear();
  for (std::size_t curve = 0; curve < this->Curves.size(); ++curve)
  {
    this->Lengths.push_back(this->Curves[curve].Length());
    for (const int which : { 0, 1 })
    {
      this->Ends.push_back({ curve, which, this->Curves[curve].End(which) });
    }
  }
  std::stable_sort(this->Ends.begin(), this->Ends.end(),
    [](const LooseEnd& a, const LooseEnd& b) { return a.At[0] < b.At[0]; });
}

void GapCloser::Consider(std::size_t a, std::size_t b, Gap& nearest) const
{
  const LooseEnd &p = this->Ends[a], &q = this->Ends[b];
  const bool own = p.Curve == q.Curve;
  if (own && this->Curves[p.Curve].Points.size() < 3)
  {
    return;
  }
  const double length = Distance(p.At, q.At);
  const double rank = (own ? OwnShare : 1.0) * length;
  if (rank < nearest.Rank &&
    length <= GreatestShare * std::min(this->Lengths[p.Curve], this->Lengths[q.Curve]) &&
    this->MayJoin(this->Curves[p.Curve], p.Which, this->Curves[q.Curve], q.Which))
  {
    nearest = { rank, length, a, b };
  }
}

Gap GapCloser::NearestOf(std::size_t end) const
{
  Gap nearest{ HUGE_VAL, 0.0, end, end };
  const LooseEnd& from = this->Ends[end];
  const double reach = GreatestShare * this->Lengths[from.Curve];
  const auto isTooFar = [&](const LooseEnd& other)
  {
    const double distance = std::abs(other.At[0] - from.At[0]);
    return distance > reach || OwnShare * distance > nearest.Rank;
  };
  for (std::size_t i = end; i-- > 0 && !isTooFar(this->Ends[i]);)
  {
    this->Consider(end, i, nearest);
  }
  for (std::size_t i = end + 1; i < this->Ends.size() && !isTooFar(this->Ends[i]); ++i)
  {
    this->Consider(end, i, nearest);
  }
  return nearest;
}

/// Joins the curve of the second end to that of the first, or a curve to itself.
void GapCloser::Close(const Gap& gap)
{
  const LooseEnd &a = this->Ends[gap.A], &b = this->Ends[gap.B];
  OpenCurve& curve = this->Curves[a.Curve];
  OpenCurve& other = this->Curves[b.Curve];
  double trimmed = 0.0;
  if (a.Curve == b.Curve)
  {
    const double before = curve.Trimmed;
    trimmed = TrimOverrun(curve) ? curve.Trimmed : 0.0;
    curve.Trimmed = before + trimmed;
  }
  else
  {
    if (a.Which == 0)
    {
      std::reverse(curve.Points.begin(), curve.Points.end());
    }
    if (b.Which == 1)
    {
      std::reverse(other.Points.begin(), other.Points.end());
    }
    trimmed = TrimOverlap(curve.Points, other.Points);
    curve.Trimmed += other.Trimmed + trimmed;
    curve.Cell = this->Lengths[a.Curve] >= this->Lengths[b.Curve] ? curve.Cell : other.Cell;
    if (other.Gap > curve.Gap)
    {
      curve.Gap = other.Gap;
      curve.GapAt = other.GapAt;
    }
    curve.Points.insert(curve.Points.end(), other.Points.begin(), other.Points.end());
    other.Points.clear();
  }
  if (trimmed == 0.0 && gap.Length > curve.Gap)
  {
    curve.Gap = gap.Length;
    curve.GapAt = a.At;
  }
  if (a.Curve == b.Curve)
  {
    this->Closed.push_back(std::move(curve));
    curve.Points.clear();
  }
}

bool GapCloser::CloseNearest()
{
  this->ListEnds();
  std::vector<Gap> gaps;
  for (std::size_t end = 0; end < this->Ends.size(); ++end)
  {
    const Gap gap = this->NearestOf(end);
    if (gap.Rank < HUGE_VAL)
    {
      gaps.push_back(gap);
    }
  }
  std::stable_sort(
    gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.Rank < b.Rank; });
  std::vector<std::uint8_t> changed(this->Curves.size(), 0);
  for (const Gap& gap : gaps)
  {
    const std::size_t a = this->Ends[gap.A].Curve, b = this->Ends[gap.B].Curve;
    if (!changed[a] && !changed[b])
    {
      changed[a] = changed[b] = 1;
      this->Close(gap);
    }
  }
  this->Curves.erase(std::remove_if(this->Curves.begin(), this->Curves.end(),
                       [](const OpenCurve& curve) { return curve.Points.empty(); }),
    this->Curves.end());
  return !gaps.empty();
}
}

void CloseGaps(
  const JointFilter& mayJoin, std::vector<OpenCurve>& curves, std::vector<OpenCurve>& closed)
{
  GapCloser closer(mayJoin, curves, closed);
  while (closer.CloseNearest())
  {
  }
}
}
