// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/MeshImprover.h"

#include "Core/Improve/MakesFold.h"
#include "Core/Improve/PressedPoints.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace orthoslices
{
namespace
{
/// Triangles of a block, if that is a plane sheet: so few that what is known of them fits into the
/// cache, and so many that few lie at its faces; of small surfaces, so few that there are blocks for
/// all threads.
constexpr double MostOfBlock = 8000.0;
constexpr double LeastOfBlock = 1500.0;
constexpr double WantedBlocks = 48.0;

/// Triangles that are looked at to know their size.
constexpr Index SampledTriangles = 4096;

/// Blocks are so many times as large as triangles, at least, so that most have room around them.
constexpr double LeastRoom = 16.0;

/// Blocks that are improved before any is put back.
constexpr std::size_t BlocksTogether = 64;

/// Blocks by their sides, as multiples of the first ones, and by where their faces are. What lies at
/// faces of the first two, along two axes, does not in the next two. Larger ones are for larger
/// triangles, until all is in one.
struct Division
{
  double Side, Shift;
};
constexpr std::array<Division, 12> Divisions{ { { 1.0, 0.5 }, { 1.0, 0.0 }, { 0.5, 0.5 },
  { 0.5, 0.25 }, { 1.0, 0.75 }, { 1.0, 0.25 }, { 2.0, 0.5 }, { 2.0, 0.25 }, { 4.0, 0.5 },
  { 4.0, 0.25 }, { 16.0, 0.5 }, { 64.0, 0.5 } } };
constexpr double All = 1.01; ///< of what is in one

/// Which triangles are folded onto one with a greater number, if the mesh knows what is across edges.
std::vector<std::uint8_t> ListFolded(const ImprovableMesh& mesh)
{
  const CornerTable& corners = mesh.Corners;
  std::vector<std::uint8_t> folded(static_cast<std::size_t>(corners.CornerCount()) / 3, 0);
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (corners.IsAlive(corner) && corners.OppositeOf(corner) > corner &&
      !corners.IsCurve(corner) && IsFolded(corners, mesh.Points, corner))
    {
      folded[corner / 3] = 1;
    }
  }
  return folded;
}
}

MeshImprover::MeshImprover(const SpatialGrid& grid, const ImprovementLimits& limits,
  const Execution& execution, ImprovableMesh& mesh, const Ranks& ranks)
  : Grid(grid)
  , Limits(limits)
  , Execute(execution)
  , Mesh(mesh)
  , Processes(ranks)
  , TrianglesAtFirst(mesh.Corners.CornerCount() / 3)
  , Samples(mesh, limits)
{
  this->Marks.Tried.resize(static_cast<std::size_t>(this->TrianglesAtFirst), 0);
  this->Marks.IsFolded = ListFolded(mesh);
}

bool MeshImprover::IsPending(Index triangle) const
{
  const CornerTable& corners = this->Mesh.Corners;
  if (this->Marks.Tried[triangle] != 0 || !corners.IsAlive(3 * triangle) ||
    this->Mesh.Borders.IsBeyond(corners, triangle))
  {
    return false;
  }
  const auto at = [&](Index i) { return this->Mesh.Points[corners.VertexOf(3 * triangle + i)]; };
  return SquaredSine({ at(0), at(1), at(2) }) < this->Wanted ||
    (this->Now == Round::Last &&
      (this->Marks.IsFolded[triangle] != 0 || this->HasPressed(triangle)));
}

/// Whether a triangle lies next to a plane, and a corner of it is inside a patch.
bool MeshImprover::HasPressed(Index triangle) const
{
  const double distance = PressedShare * this->Samples.ToleranceInside();
  const Box3 box = BoxOfPart(this->Mesh, triangle);
  const Point3 extent = box.High - box.Low;
  if (!(std::min({ extent[0], extent[1], extent[2] }) < 2.0 * distance))
  {
    return false;
  }
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    const Index point = this->Mesh.Corners.VertexOf(corner);
    if (point >= this->Mesh.FirstInside &&
      FindPressing(this->Grid, this->Mesh.Points[point], distance).Axis >= 0)
    {
      return true;
    }
  }
  return false;
}

/// Lists all triangles that are to be improved, as none was tried in this round.
void MeshImprover::ListPending()
{
  this->Execute.For(this->Marks.Tried.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Marks.Tried[i] = 0;
        this->Marks.Tried[i] = this->IsPending(static_cast<Index>(i)) ? 0 : 1;
      }
    });
  this->Pending.clear();
  for (std::size_t i = 0; i < this->Marks.Tried.size(); ++i)
  {
    if (this->Marks.Tried[i] == 0)
    {
      this->Pending.push_back(static_cast<Index>(i));
    }
  }
}

/// So that blocks have as many triangles as they should, and few triangles are in several.
double MeshImprover::SideOfBlocks() const
{
  const Index step = this->TrianglesAtFirst / SampledTriangles + 1;
  double area = 0.0, extent = 0.0, count = 0.0;
  for (Index triangle = 0; triangle < this->TrianglesAtFirst; triangle += step)
  {
    const Box3 box = BoxOfPart(this->Mesh, triangle);
    if (this->Mesh.Corners.IsAlive(3 * triangle) &&
      !this->Mesh.Borders.IsBeyond(this->Mesh.Corners, triangle))
    {
      const auto at = [&](Index i) -> const Point3&
      { return this->Mesh.Points[this->Mesh.Corners.VertexOf(3 * triangle + i)]; };
      area += 0.5 * Length(AreaOf({ at(0), at(1), at(2) }));
      extent += Length(box.High - box.Low);
      count += 1.0;
    }
  }
  const double wanted =
    std::max(LeastOfBlock, std::min(MostOfBlock, this->TrianglesAtFirst / WantedBlocks));
  return count > 0.0 ? std::max(std::sqrt(wanted * area / count), LeastRoom * extent / count) : 0.0;
}

void MeshImprover::Run()
{
  const double side = this->SideOfBlocks();
  Box3 around;
  for (std::size_t i = static_cast<std::size_t>(this->Mesh.Borders.Beyond);
       i < this->Mesh.Points.size(); ++i)
  {
    around.Add(this->Mesh.Points[i]);
  }
  this->Run(Round::First, around, side);
  this->Run(Round::Last, around, side);
}

void MeshImprover::Run(Round round, const Box3& around, double side)
{
  this->Now = round;
  this->Wanted = BlockImprover::WantedQuality(this->Limits, round);
  this->ListPending();
  const Point3 extent = this->Pending.empty() ? Point3{} : around.High - around.Low;
  const double whole = std::max({ extent[0], extent[1], extent[2] });
  for (const Division& division : Divisions)
  {
    if (!this->Limits.Divides || this->Pending.empty() || division.Side * side >= whole ||
      this->TrianglesAtFirst < LeastOfBlock)
    {
      break;
    }
    this->RunIn(BlockGrid(around, division.Side * side, division.Shift));
  }
  if (!this->Pending.empty())
  {
    this->RunIn(BlockGrid(around, All * whole, 1.0));
  }
}

/// Improves what lies within blocks.
void MeshImprover::RunIn(const BlockGrid& blocks)
{
  const BlockLists lists = ListBlocks(
    blocks, this->Mesh, this->Pending, BlocksTogether, this->Processes, this->Execute, this->Runs);
  for (std::size_t first = 0; first < lists.Count(); first += BlocksTogether)
  {
    this->RunIn(blocks, lists, { first, std::min(first + BlocksTogether, lists.Count()) });
  }
  std::sort(this->Pending.begin(), this->Pending.end());
  this->Pending.erase(std::unique(this->Pending.begin(), this->Pending.end()), this->Pending.end());
  this->Pending.erase(std::remove_if(this->Pending.begin(), this->Pending.end(),
                        [&](Index triangle) { return !this->IsPending(triangle); }),
    this->Pending.end());
}

/// Improves what lies within some of the blocks, and puts it back.
void MeshImprover::RunIn(const BlockGrid& blocks, const BlockLists& lists, const Portion& portion)
{
  std::vector<BlockChange> changes(portion.Last - portion.First);
  const int* ranks = lists.Rank.data() + portion.First;
  this->Execute.For(changes.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::size_t block = portion.First + i;
        const Index* triangles = lists.Triangles.data();
        if (lists.IsTakenBy(this->Processes.Rank, block))
        {
          changes[i] = this->Improve(blocks.BoxOf(lists.Blocks[block]), lists.Cells[block],
            triangles + lists.Offsets[block], triangles + lists.Offsets[block + 1]);
        }
      }
    });
  if (ranks[0] != BlockLists::ByAll)
  {
    ExchangeChanges(this->Processes, ranks, changes);
  }
  this->MakeRoom(changes);
  this->PutBack(changes);
}

/// How many new triangles a block may get: what is inside keeps to the limit.
std::size_t MeshImprover::MostNewIn(const MeshBlock& block) const
{
  double most = 0.0;
  for (std::size_t i = 0; i < block.Triangles.size(); ++i)
  {
    if (block.IsInner(static_cast<Index>(i)))
    {
      most += block.Triangles[i] < this->TrianglesAtFirst ? this->Limits.Growth : -1.0;
    }
  }
  return static_cast<std::size_t>(std::max(0.0, most));
}

BlockChange::Counts MeshImprover::CountAll() const
{
  return { this->Mesh.Corners.CornerCount() / 3, static_cast<Index>(this->Mesh.Points.size()) };
}

BlockChange MeshImprover::Improve(
  const Box3& box, const BlockCells& cells, const Index* begin, const Index* end) const
{
  MeshBlock block(this->Mesh, box, cells, begin, end, this->Limits.Kept);
  BlockImprover improver(this->Grid, this->Limits, this->MostNewIn(block), block, this->Samples);
  improver.Run(this->Now, this->Marks.Tried);
  return ListChange(block, improver, this->Mesh, this->Marks);
}

/// Gives the new points and triangles of blocks their numbers, and forgets what was known of others.
void MeshImprover::MakeRoom(std::vector<BlockChange>& changes)
{
  const BlockChange::Counts there = this->CountAll();
  BlockChange::Counts added;
  for (BlockChange& change : changes)
  {
    change.Renumber(there, added);
    for (const ChangedTriangle& changed : change.Triangles)
    {
      this->Runs.Forget(changed.Number);
    }
    added.Triangles += change.New.Triangles;
    added.Points += change.New.Points;
  }
  const std::size_t points = static_cast<std::size_t>(there.Points + added.Points);
  const std::size_t triangles = static_cast<std::size_t>(there.Triangles + added.Triangles);
  this->Mesh.Corners.Grow(added.Points, added.Triangles);
  this->Mesh.Points.resize(points);
  this->Mesh.Normals.resize(points);
  if (!this->Mesh.RoomOf.empty())
  {
    this->Mesh.RoomOf.resize(points);
  }
  this->Mesh.Origins.resize(triangles - static_cast<std::size_t>(this->TrianglesAtFirst));
  this->Samples.Grow(added.Triangles);
  this->Marks.Tried.resize(triangles, 0);
  this->Marks.IsFolded.resize(triangles, 0);
}

/// Puts all that may have changed in blocks back into the surface, and lists what is to be improved
/// elsewhere.
void MeshImprover::PutBack(std::vector<BlockChange>& changes)
{
  std::vector<std::vector<Index>> pending(changes.size());
  this->Execute.For(changes.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->PutBack(changes[i]);
        this->ListPendingOf(changes[i], pending[i]);
        changes[i] = {};
      }
    });
  for (const std::vector<Index>& some : pending)
  {
    this->Pending.insert(this->Pending.end(), some.begin(), some.end());
  }
}

void MeshImprover::PutBack(const BlockChange& change)
{
  const Index* samples = change.Samples.data();
  for (const ChangedTriangle& changed : change.Triangles)
  {
    const Index triangle = changed.Number;
    if (changed.IsGone())
    {
      this->Mesh.Corners.TakeOut(triangle);
    }
    else
    {
      this->Mesh.Corners.Put(triangle, changed.Vertices, changed.Curves);
    }
    this->Samples.Put(triangle, changed.Plain, samples, samples + changed.SampleCount);
    samples += changed.SampleCount;
    if (changed.Origin >= 0)
    {
      std::vector<Index>& origins = this->Mesh.Origins;
      const Index given = this->TrianglesAtFirst;
      origins[triangle - given] =
        changed.Origin < given ? changed.Origin : origins[changed.Origin - given];
    }
  }
  for (const ChangedPoint& changed : change.Points)
  {
    this->Mesh.Points[changed.Number] = changed.Place;
    this->Mesh.Normals[changed.Number] = changed.Normal;
    if (!this->Mesh.RoomOf.empty())
    {
      this->Mesh.RoomOf[changed.Number] = changed.Room;
    }
  }
  for (const ChangedMarks& changed : change.Marks)
  {
    this->Marks.Tried[changed.Number] = changed.Tried;
    this->Marks.IsFolded[changed.Number] = changed.IsFolded;
  }
}

/// Lists triangles of a block that have become bad and have something frozen around them.
void MeshImprover::ListPendingOf(const BlockChange& change, std::vector<Index>& pending) const
{
  const auto add = [&](Index triangle)
  {
    if (this->IsPending(triangle))
    {
      pending.push_back(triangle);
    }
  };
  for (const ChangedTriangle& changed : change.Triangles)
  {
    add(changed.Number);
  }
  for (const ChangedMarks& changed : change.Marks)
  {
    add(changed.Number);
  }
}
}
