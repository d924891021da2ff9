// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/RaiseEnds.h"

#include "Core/Graph/CycleGeometry.h"
#include "Core/Patches/CentralPoints.h"
#include "Core/Slices/EndSlices.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// How far from a rim between two slices a virtual one meets its wall, as a share of their
/// distance: what is beyond is as thin as that, and rounded.
constexpr double RoomBelowRim = 0.02;

class EndRaiser
{
public:
  EndRaiser(const CycleGeometry& geometry, const Patches& patches, DraftMesh& draft)
    : Geometry(geometry)
    , Graph(geometry.Graph)
    , TrianglesOf(patches.Offsets)
    , Draft(draft)
    , Axis(FindOnlyFamily(geometry.Grid))
  {
  }

  StackEnds Run(GuideCurves& guides);

private:
  void NumberLoops();
  std::vector<Index> ListLoops(Index patch) const;
  Index SideOf(Index patch, Index loop) const;
  EndKind CombineKinds(Index patch, const std::vector<Index>& loops);
  LoopEnd& EndOf(Index patch, Index loop)
  {
    return this->Ends[2 * loop + this->SideOf(patch, loop)];
  }
  void CombineAnchors(Index patch, const std::vector<Index>& loops);
  void Raise(Index patch, const std::vector<Index>& loops);
  void AddWall(Index patch, Index loop, Index rim);
  void MoveInner(Index patch, double level);
  double LevelOf(Index patch, Index loop) const;
  bool IsFlat(Index patch) const;
  bool EndsWithin(Index patch, const std::vector<Index>& loops) const;
  void EndHalfway(Index patch, const std::vector<Index>& loops, StackEnds& result);
  std::array<double, 2> FindMeanHeights() const;
  void AssumeRim(Index patch, const std::vector<Index>& loops, double height);

  const CycleGeometry& Geometry;
  const NodeGraph& Graph;
  const std::vector<std::int64_t>& TrianglesOf;
  DraftMesh& Draft;
  const int Axis;
  std::vector<Index> LoopOf; ///< of each point of G
  std::vector<LoopEnd> Ends; ///< of each loop, below and above
};

void EndRaiser::NumberLoops()
{
  this->LoopOf.assign(static_cast<std::size_t>(this->Graph.Count()), -1);
  for (Index loop = 0; loop < static_cast<Index>(this->Graph.Loops.size()); ++loop)
  {
    const Index arc = this->Graph.Arcs + loop;
    std::fill_n(
      this->LoopOf.begin() + this->Graph.FirstPoint(arc), this->Graph.PointCount(arc), loop);
  }
}

/// The loops around a patch, each once.
std::vector<Index> EndRaiser::ListLoops(Index patch) const
{
  std::vector<Index> loops;
  for (std::int64_t t = this->TrianglesOf[patch]; t < this->TrianglesOf[patch + 1]; ++t)
  {
    for (const Index point : this->Draft.Triangles[t])
    {
      const Index loop = point < this->Graph.Count() ? this->LoopOf[point] : -1;
      if (loop >= 0 && (loops.empty() || loops.back() != loop))
      {
        loops.push_back(loop);
      }
    }
  }
  std::sort(loops.begin(), loops.end());
  loops.erase(std::unique(loops.begin(), loops.end()), loops.end());
  return loops;
}

/// 1 if the patch is above the slice of its loop, else 0.
Index EndRaiser::SideOf(Index patch, Index loop) const
{
  return this->Geometry.Cycles.Cell[patch][this->Axis] > this->Graph.Loops[loop].Plane ? 1 : 0;
}

/// How the object ends with a patch; Unknown if it has loops on two slices.
EndKind EndRaiser::CombineKinds(Index patch, const std::vector<Index>& loops)
{
  EndKind kind = EndKind::Unknown;
  for (const Index loop : loops)
  {
    kind = CombineEnds(kind, this->EndOf(patch, loop).Kind);
  }
  for (const Index loop : loops)
  {
    const bool isEnd = this->Graph.Loops[loop].Plane == this->Graph.Loops[loops.front()].Plane;
    kind = isEnd ? kind : EndKind::Unknown;
  }
  for (const Index loop : loops)
  {
    this->EndOf(patch, loop).Kind = kind;
  }
  return kind;
}

/// Loops of a patch that no guide meets have a rim as far away as the others in the mean.
void EndRaiser::CombineAnchors(Index patch, const std::vector<Index>& loops)
{
  RimAnchor mean;
  double count = 0.0;
  for (const Index loop : loops)
  {
    for (const RimAnchor& anchor : this->EndOf(patch, loop).Anchors)
    {
      mean.Outwards += anchor.Outwards;
      mean.Upwards += anchor.Upwards;
      count += 1.0;
    }
  }
  mean.Outwards /= count;
  mean.Upwards /= count;
  for (const Index loop : loops)
  {
    if (this->EndOf(patch, loop).Anchors.empty())
    {
      this->EndOf(patch, loop).Anchors.push_back(mean);
    }
  }
}

/// Where a flat end lies: in the slice, but on the patch's side of it, so that sections of the
/// surface do not begin in the slice itself.
double EndRaiser::LevelOf(Index patch, Index loop) const
{
  const SpatialGrid& grid = this->Geometry.Grid;
  return grid.MoveInside(this->Axis, this->Geometry.Cycles.Cell[patch][this->Axis],
    grid.Planes[this->Axis][this->Graph.Loops[loop].Plane], CentralPointMargin);
}

/// Points of a patch that are not on loops move to a level.
void EndRaiser::MoveInner(Index patch, double level)
{
  for (std::int64_t t = this->TrianglesOf[patch]; t < this->TrianglesOf[patch + 1]; ++t)
  {
    for (const Index point : this->Draft.Triangles[t])
    {
      if (point >= this->Graph.Count())
      {
        this->Draft.Points[point][this->Axis] = level;
      }
    }
  }
}

/// The wall between a loop and its rim, whose points are numbered from `rim` on.
void EndRaiser::AddWall(Index patch, Index loop, Index rim)
{
  const Index arc = this->Graph.Arcs + loop, first = this->Graph.FirstPoint(arc);
  const Index count = this->Graph.PointCount(arc);
  for (Index i = 0; i < count; ++i)
  {
    const Index j = (i + 1) % count;
    std::array<Index, 3> one{ first + i, first + j, rim + j }, other{ first + i, rim + j, rim + i };
    if (this->SideOf(patch, loop) == 0) // seen from outside, the loop runs the other way
    {
      std::swap(one[1], one[2]);
      std::swap(other[1], other[2]);
    }
    this->Draft.Triangles.push_back(one);
    this->Draft.Triangles.push_back(other);
    this->Draft.Patch.insert(this->Draft.Patch.end(), 2, this->Geometry.Cycles.Count() + patch);
  }
}

void EndRaiser::Raise(Index patch, const std::vector<Index>& loops)
{
  this->CombineAnchors(patch, loops);
  const Index base = static_cast<Index>(this->Draft.Points.size());
  std::vector<Index> rims;
  double level = 0.0;
  for (const Index loop : loops)
  {
    rims.push_back(static_cast<Index>(this->Draft.Points.size()));
    const std::vector<Point3> rim = PlaceRim(this->Graph, loop,
      this->SideOf(patch, loop) == 0 ? -1.0 : 1.0, this->EndOf(patch, loop).Anchors);
    this->Draft.Points.insert(this->Draft.Points.end(), rim.begin(), rim.end());
    this->AddWall(patch, loop, rims.back());
    for (const Point3& point : rim)
    {
      level += point[this->Axis];
    }
  }
  this->MoveInner(patch, level / static_cast<double>(this->Draft.Points.size() - base));
  for (std::int64_t t = this->TrianglesOf[patch]; t < this->TrianglesOf[patch + 1]; ++t)
  {
    for (Index& point : this->Draft.Triangles[t])
    {
      if (point < this->Graph.Count())
      {
        const Index loop = this->LoopOf[point];
        const auto at = std::lower_bound(loops.begin(), loops.end(), loop) - loops.begin();
        point += rims[at] - this->Graph.FirstPoint(this->Graph.Arcs + loop);
      }
    }
  }
}

/// Whether a patch lies in the slice at the end of which it is, as far as the stack alone tells.
bool EndRaiser::IsFlat(Index patch) const
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::int64_t t = this->TrianglesOf[patch]; t < this->TrianglesOf[patch + 1]; ++t)
  {
    for (const Index point : this->Draft.Triangles[t])
    {
      low = std::min(low, this->Draft.Points[point][this->Axis]);
      high = std::max(high, this->Draft.Points[point][this->Axis]);
    }
  }
  return high - low < FlatShare * this->Geometry.Grid.MeanSpacing(this->Axis);
}

/// How far the object goes beyond the first slice (side 0) and the last one (side 1): the mean of
/// what guides show there, or else of what they show on the other side; 0 if they show nothing.
std::array<double, 2> EndRaiser::FindMeanHeights() const
{
  std::array<double, 2> sum{}, count{};
  for (Index loop = 0; loop < static_cast<Index>(this->Graph.Loops.size()); ++loop)
  {
    for (const Index side : { 0, 1 })
    {
      const Index last = side == 0 ? 0 : this->Geometry.Grid.Count(this->Axis) - 1;
      const LoopEnd& end = this->Ends[2 * loop + side];
      if (this->Graph.Loops[loop].Plane == last && end.Kind != EndKind::Unknown)
      {
        sum[side] += end.Height;
        count[side] += 1.0;
      }
    }
  }
  std::array<double, 2> mean{};
  for (const Index side : { 0, 1 })
  {
    const Index from = count[side] > 0.0 ? side : 1 - side;
    mean[side] = count[from] > 0.0 ? sum[from] / count[from] : 0.0;
  }
  return mean;
}

/// Flat ends that no guide meets lie as far beyond their slice as others do.
void EndRaiser::AssumeRim(Index patch, const std::vector<Index>& loops, double height)
{
  const double spacing = this->Geometry.Grid.MeanSpacing(this->Axis);
  const double upwards = std::min(height, 0.5 * spacing);
  for (const Index loop : loops)
  {
    LoopEnd& end = this->EndOf(patch, loop);
    end.Kind = upwards < FlatShare * spacing ? EndKind::Flat : EndKind::Rim;
    end.Anchors.push_back({ 0.0, 0.0, upwards });
  }
}

/// Whether a patch ends the object between two slices of the stack, on which its loops are not
/// both.
bool EndRaiser::EndsWithin(Index patch, const std::vector<Index>& loops) const
{
  const SpatialGrid& grid = this->Geometry.Grid;
  const Index slab = this->Geometry.Cycles.Cell[patch][this->Axis];
  return slab > 0 && slab < grid.Count(this->Axis) && !IsBesideEndSlice(grid, this->Axis, slab) &&
    !loops.empty() &&
    std::all_of(loops.begin(), loops.end(),
      [&](Index loop)
      { return this->Graph.Loops[loop].Plane == this->Graph.Loops[loops.front()].Plane; });
}

/// Gives a patch that ends between two slices a rim in the middle between them.
void EndRaiser::EndHalfway(Index patch, const std::vector<Index>& loops, StackEnds& result)
{
  const SpatialGrid& grid = this->Geometry.Grid;
  const double width = grid.Width(this->Axis, this->Geometry.Cycles.Cell[patch][this->Axis]);
  for (const Index loop : loops)
  {
    LoopEnd& end = this->EndOf(patch, loop);
    end.Kind = EndKind::Rim;
    end.Anchors.push_back({ 0.0, 0.0, 0.5 * width });
    result.HasWall[loop] = 1;
  }
  const double up = this->SideOf(patch, loops.front()) == 0 ? -1.0 : 1.0;
  result.Levels.push_back(grid.Planes[this->Axis][this->Graph.Loops[loops.front()].Plane] +
    up * (0.5 - RoomBelowRim) * width);
}

StackEnds EndRaiser::Run(GuideCurves& guides)
{
  this->NumberLoops();
  this->Ends = FindLoopEnds(this->Graph, guides);
  const std::array<double, 2> heights = this->FindMeanHeights();
  const Index patches = this->Geometry.Cycles.Count();
  StackEnds result;
  result.OfPatch.assign(patches, EndKind::Unknown);
  result.HasWall.assign(this->Graph.Loops.size(), 0);
  for (Index patch = 0; patch < patches; ++patch)
  {
    const std::vector<Index> loops = this->ListLoops(patch);
    if (!loops.empty() && !guides.Slices.empty() &&
      this->CombineKinds(patch, loops) == EndKind::Unknown && this->IsFlat(patch))
    {
      this->AssumeRim(patch, loops, heights[this->SideOf(patch, loops.front())]);
    }
    if (guides.HalfSliceEnds && this->EndsWithin(patch, loops))
    {
      this->EndHalfway(patch, loops, result);
    }
    const EndKind kind = this->CombineKinds(patch, loops);
    result.OfPatch[patch] = kind;
    if (kind == EndKind::Rim)
    {
      this->Raise(patch, loops);
    }
    else if (kind == EndKind::Flat)
    {
      this->MoveInner(patch, this->LevelOf(patch, loops.front()));
    }
  }
  CutAtRims(this->Graph, this->Ends, guides);
  for (std::size_t i = 0; i < this->Ends.size(); i += 2)
  {
    result.HasRim.push_back(
      this->Ends[i].Kind == EndKind::Rim || this->Ends[i + 1].Kind == EndKind::Rim);
  }
  return result;
}
}

StackEnds RaiseEnds(
  const CycleGeometry& geometry, const Patches& patches, GuideCurves& guides, DraftMesh& draft)
{
  return EndRaiser(geometry, patches, draft).Run(guides);
}
}
