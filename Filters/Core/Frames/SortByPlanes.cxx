// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/SortByPlanes.h"

#include "Core/Frames/AlignToBorders.h"
#include "Core/Frames/ChooseAxes.h"
#include "Core/Frames/SnapPlanes.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Given families are that far from lying in one plane, by the volume of the box of their normals.
constexpr double LeastGivenVolume = 0.05;

/// Stands for no axis: the polyline is no slice.
constexpr std::int8_t NoAxis = -1;

/// Whether a polyline stays within the tolerance along an axis.
bool IsFlat(const Polylines& lines, Index line, int axis, double tolerance)
{
  const double* x = lines.Along(axis).data();
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (Index i = lines.Offsets[line]; i < lines.Offsets[line + 1]; ++i)
  {
    low = std::min(low, x[i]);
    high = std::max(high, x[i]);
  }
  return high - low <= tolerance;
}

/// Whether all polylines are slices across the axis of their port: then there is nothing to sort.
bool AreSorted(const Polylines& lines, double tolerance)
{
  for (Index line = 0; line < lines.Count(); ++line)
  {
    const int port = lines.From.Port[line];
    if (port > 2 || !IsFlat(lines, line, port, tolerance))
    {
      return false;
    }
  }
  return true;
}

/// Gives each polyline its axis.
class Sorter
{
public:
  Sorter(const Polylines& lines, double tolerance)
    : Lines(lines)
    , Groups(GroupPieces(lines))
    , Noise(MeasureNoise(this->Groups, tolerance))
  {
  }

  /// By the axes of the world, if all polylines are slices across these; else false.
  bool SortExact()
  {
    this->Axes.HasFamily = { true, true, true };
    std::vector<std::int8_t> axes;
    for (const PieceGroup& group : this->Groups)
    {
      axes.push_back(static_cast<std::int8_t>(this->FindExactAxis(group)));
    }
    this->SetAxes(axes);
    return std::find(axes.begin(), axes.end(), NoAxis) == axes.end();
  }

  void FindFrame()
  {
    this->Axes = ChooseAxes(FindFamilies(this->Groups, this->Noise), this->Noise);
    AlignToBorders(this->Lines, this->Axes);
    if (this->Axes.Frame.IsWorld())
    {
      // There may be small contours on planes across the others.
      this->Axes.HasFamily = { true, true, true };
    }
  }

  void SetFrame(const AxisFrame& frame) { this->Axes = { frame, { true, true, true } }; }

  /// What is no slice across an axis of the world is one of its port: the caller knows better.
  void TrustPorts() { this->PortsDecide = true; }

  /// By the axes of the frame.
  void Sort()
  {
    std::vector<std::int8_t> axes;
    for (const PieceGroup& group : this->Groups)
    {
      const int exact = this->Axes.Frame.IsWorld() ? this->FindExactAxis(group) : NoAxis;
      axes.push_back(
        static_cast<std::int8_t>(exact != NoAxis ? exact : this->FindNearestAxis(group)));
    }
    this->PreferAxisOfPort(axes);
    this->SetAxes(axes);
  }

  const AxisFrame& Frame() const { return this->Axes.Frame; }
  const std::vector<PieceGroup>& AllGroups() const { return this->Groups; }
  const PlaneNoise& NoiseOfPlanes() const { return this->Noise; }
  const std::vector<std::int8_t>& AxisOfLine() const { return this->AxisOf; }

private:
  void SetAxes(const std::vector<std::int8_t>& axes)
  {
    this->AxisOf.resize(this->Lines.Count());
    for (std::size_t i = 0; i < axes.size(); ++i)
    {
      for (const Index line : this->Groups[i].Members)
      {
        this->AxisOf[line] = axes[i];
      }
    }
  }

  /// A contour that is no larger than the noise would lie on planes of any family: it belongs to
  /// that of nearly all others of its port, if there is one.
  void PreferAxisOfPort(std::vector<std::int8_t>& axes) const
  {
    constexpr double nearlyAll = 0.9;
    std::array<std::array<double, 3>, 4> weights{};
    std::array<double, 4> sums{};
    for (std::size_t i = 0; i < axes.size(); ++i)
    {
      const PieceGroup& group = this->Groups[i];
      sums[group.Port] += group.Weight();
      if (axes[i] != NoAxis)
      {
        weights[group.Port][axes[i]] += group.Weight();
      }
    }
    for (std::size_t i = 0; i < axes.size(); ++i)
    {
      const PieceGroup& group = this->Groups[i];
      const auto& ofPort = weights[group.Port];
      const auto axis = std::max_element(ofPort.begin(), ofPort.end()) - ofPort.begin();
      const Point3& normal = this->Axes.Frame.Normal(static_cast<int>(axis));
      if (ofPort[axis] >= nearlyAll * sums[group.Port] && group.IsFinite() &&
        this->Noise.IsExplained(group, normal))
      {
        axes[i] = static_cast<std::int8_t>(axis);
      }
    }
  }

  /// The axis of the world across which the group is a slice: that of its port if it is one.
  int FindExactAxis(const PieceGroup& group) const
  {
    const auto isFlat = [&](int axis)
    { return this->Axes.HasFamily[axis] && group.Extent(axis) <= this->Noise.Tolerance; };
    int best = group.Port < 3 && isFlat(group.Port) ? group.Port : NoAxis;
    for (int axis = 0; axis < 3 && best == NoAxis; ++axis)
    {
      best = isFlat(axis) ? axis : NoAxis;
    }
    return best;
  }

  /// The family that the group belongs to as far as noise lets one see; what is on no plane of its
  /// own either, belongs to that of its port, or the nearest one.
  int FindNearestAxis(const PieceGroup& group) const
  {
    int nearest = NoAxis;
    double least = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double distance = group.Points.Along(this->Axes.Frame.Normal(axis));
      if (this->Axes.HasFamily[axis] && distance < least)
      {
        least = distance;
        nearest = axis;
      }
    }
    if (this->PortsDecide && group.Port < 3)
    {
      return group.Port;
    }
    if (nearest != NoAxis && group.IsFinite() &&
      this->Noise.IsExplained(group, this->Axes.Frame.Normal(nearest)))
    {
      return nearest;
    }
    // Any three points lie on a plane: it says nothing that they do.
    if (group.IsPlanar() && group.Points.Points > 3 && nearest != NoAxis)
    {
      return NoAxis;
    }
    const bool isOfPort = group.Port < 3 && (nearest == NoAxis || this->Axes.HasFamily[group.Port]);
    return isOfPort ? group.Port : std::max(nearest, 0);
  }

  const Polylines& Lines;
  std::vector<PieceGroup> Groups;
  PlaneNoise Noise;
  FamilyAxes Axes;
  bool PortsDecide = false;
  std::vector<std::int8_t> AxisOf;
};

/// Appends a polyline to the slices of an axis.
void AddPiece(const Polylines& lines, Index line, const AxisFrame& frame, Pieces& pieces)
{
  const int u = FirstAxis(pieces.Axis), v = SecondAxis(pieces.Axis), w = pieces.Axis;
  const Index first = lines.Offsets[line], last = lines.Offsets[line + 1];
  if (frame.IsWorld())
  {
    const auto append = [&](int axis, std::vector<double>& values)
    {
      const double* from = lines.Along(axis).data();
      values.insert(values.end(), from + first, from + last);
    };
    append(u, pieces.U);
    append(v, pieces.V);
    append(w, pieces.W);
  }
  for (Index i = first; i < last && !frame.IsWorld(); ++i)
  {
    const Point3 p = frame.ToAxes(lines.PointAt(i));
    pieces.U.push_back(p[u]);
    pieces.V.push_back(p[v]);
    pieces.W.push_back(p[w]);
  }
  pieces.Offsets.push_back(static_cast<Index>(pieces.U.size()));
  pieces.Cell.push_back(line);
  pieces.Closed.push_back(lines.Closed[line]);
}

/// Distributes the polylines, each to the axis that `axisOf` says.
template <typename AxisOf>
void Distribute(const Polylines& lines, AxisOf&& axisOf, SortedSlices& sorted)
{
  std::array<std::size_t, 3> counts{ 0, 0, 0 };
  for (Index line = 0; line < lines.Count(); ++line)
  {
    const int axis = axisOf(line);
    if (axis != NoAxis)
    {
      counts[axis] += lines.Offsets[line + 1] - lines.Offsets[line];
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Pieces& pieces = sorted.Slices[axis];
    pieces.Axis = axis;
    for (std::vector<double>* values : { &pieces.U, &pieces.V, &pieces.W })
    {
      values->reserve(counts[axis]);
    }
  }
  for (Index line = 0; line < lines.Count(); ++line)
  {
    const int axis = axisOf(line);
    if (axis == NoAxis)
    {
      AppendLine(lines, line, sorted.Others);
    }
    else
    {
      AddPiece(lines, line, sorted.Frame, sorted.Slices[axis]);
    }
  }
}
}

double DiagonalOf(const Polylines& lines)
{
  Box3 box;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double x : lines.Along(axis))
    {
      if (std::isfinite(x))
      {
        box.Add(axis, x);
      }
    }
  }
  const double diagonal = box.Diagonal();
  return std::isfinite(diagonal) ? diagonal : 0.0;
}

SortedSlices SortByPlanes(const Polylines& lines, const FrameOptions& options)
{
  SortedSlices sorted;
  sorted.From = lines.From;
  const double tolerance = options.PlaneTolerance * DiagonalOf(lines);
  if (options.Choice != FrameChoice::Given && AreSorted(lines, tolerance))
  {
    if (options.Choice == FrameChoice::Automatic)
    {
      sorted.Frame = TurnWorld(lines, lines.From.Port);
    }
    Distribute(
      lines, [&](Index line) { return int(lines.From.Port[line]); }, sorted);
    return sorted;
  }
  Sorter sorter(lines, tolerance);
  AxisFrame given;
  if (options.Choice == FrameChoice::Given && MakeGivenFrame(options.Given, given))
  {
    sorter.SetFrame(given);
    sorter.Sort();
  }
  else if (!sorter.SortExact())
  {
    if (options.Choice == FrameChoice::Automatic)
    {
      sorter.FindFrame();
    }
    else
    {
      sorter.TrustPorts();
    }
    sorter.Sort();
  }
  sorted.Frame = sorter.Frame();
  if (options.Choice == FrameChoice::Automatic && sorted.Frame.IsWorld())
  {
    sorted.Frame = TurnWorld(lines, sorter.AxisOfLine());
  }
  Distribute(
    lines, [&](Index line) { return int(sorter.AxisOfLine()[line]); }, sorted);
  if (!sorted.Frame.IsWorld())
  {
    for (Pieces& pieces : sorted.Slices)
    {
      SnapPlanes(
        sorter.AllGroups(), sorted.Frame.Normal(pieces.Axis), sorter.NoiseOfPlanes(), pieces);
    }
  }
  return sorted;
}

bool MakeGivenFrame(const std::array<Point3, 3>& normals, AxisFrame& frame)
{
  std::array<Point3, 3> axes{ Unit(normals[0]), Unit(normals[1]), Unit(normals[2]) };
  const double volume = Dot(axes[0], Cross(axes[1], axes[2]));
  if (volume < 0.0)
  {
    axes[2] = -1.0 * axes[2];
  }
  if (!(std::abs(volume) >= LeastGivenVolume))
  {
    return false;
  }
  frame = AxisFrame(axes);
  return true;
}
}
