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
}

/// A block and what comes of it.
struct MeshImprover::Piece
{
  std::unique_ptr<MeshBlock> Block;
  std::optional<SurfaceSamples> Samples;
  std::vector<std::uint8_t> Again; ///< of each triangle: see BlockImprover::ListAgain
  std::vector<Index> Pending;      ///< triangles that are bad and were not tried
};

MeshImprover::MeshImprover(const SpatialGrid& grid, const ImprovementLimits& limits,
  const Execution& execution, ImprovableMesh& mesh)
  : Grid(grid)
  , Limits(limits)
  , Execute(execution)
  , Mesh(mesh)
  , TrianglesAtFirst(mesh.Corners.CornerCount() / 3)
  , Samples(mesh, limits)
  , Tried(static_cast<std::size_t>(this->TrianglesAtFirst), 0)
{
}

bool MeshImprover::IsPending(Index triangle) const
{
  const CornerTable& corners = this->Mesh.Corners;
  if (this->Tried[triangle] != 0 || !corners.IsAlive(3 * triangle) ||
    this->Mesh.Borders.IsBeyond(corners, triangle))
  {
    return false;
  }
  const auto at = [&](Index i) { return this->Mesh.Points[corners.VertexOf(3 * triangle + i)]; };
  return SquaredSine({ at(0), at(1), at(2) }) < this->Wanted ||
    (this->Now == Round::Last && (this->HasFold(triangle) || this->HasPressed(triangle)));
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

/// Whether a triangle is folded onto one with a greater number, if it has been in a block.
bool MeshImprover::HasFold(Index triangle) const
{
  const CornerTable& corners = this->Mesh.Corners;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    if (corners.OppositeOf(corner) > corner && !corners.IsCurve(corner) &&
      IsFolded(corners, this->Mesh.Points, corner))
    {
      return true;
    }
  }
  return false;
}

/// Lists all triangles that are to be improved, as none was tried in this round.
void MeshImprover::ListPending()
{
  this->Execute.For(this->Tried.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Tried[i] = 0;
        this->Tried[i] = this->IsPending(static_cast<Index>(i)) ? 0 : 1;
      }
    });
  this->Pending.clear();
  for (std::size_t i = 0; i < this->Tried.size(); ++i)
  {
    if (this->Tried[i] == 0)
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
    this->RunIn(BlockGrid(around, division.Side * side, division.Shift), round);
  }
  if (!this->Pending.empty())
  {
    this->RunIn(BlockGrid(around, All * whole, 1.0), round);
  }
}

/// Improves what lies within blocks.
void MeshImprover::RunIn(const BlockGrid& blocks, Round round)
{
  const BlockLists lists = ListBlocks(blocks, this->Mesh, this->Pending, this->Execute, this->Runs);
  for (std::size_t first = 0; first < lists.Count(); first += BlocksTogether)
  {
    std::vector<Piece> pieces(std::min(BlocksTogether, lists.Count() - first));
    this->Execute.For(pieces.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Index* triangles = lists.Triangles.data();
          this->Improve(blocks.BoxOf(lists.Blocks[first + i]), lists.Cells[first + i],
            triangles + lists.Offsets[first + i], triangles + lists.Offsets[first + i + 1], round,
            pieces[i]);
        }
      });
    this->MakeRoom(pieces);
    this->Execute.For(pieces.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->PutBack(pieces[i]);
        }
      });
    this->ListPendingOf(pieces);
  }
  std::sort(this->Pending.begin(), this->Pending.end());
  this->Pending.erase(std::unique(this->Pending.begin(), this->Pending.end()), this->Pending.end());
  this->Pending.erase(std::remove_if(this->Pending.begin(), this->Pending.end(),
                        [&](Index triangle) { return !this->IsPending(triangle); }),
    this->Pending.end());
}

/// Lists triangles of blocks that have become bad and have something frozen around them.
void MeshImprover::ListPendingOf(const std::vector<Piece>& pieces)
{
  for (const Piece& piece : pieces)
  {
    this->Pending.insert(this->Pending.end(), piece.Pending.begin(), piece.Pending.end());
  }
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

void MeshImprover::Improve(const Box3& box, const BlockCells& cells, const Index* begin,
  const Index* end, Round round, Piece& piece) const
{
  piece.Block = std::make_unique<MeshBlock>(this->Mesh, box, cells, begin, end, this->Limits.Kept);
  BlockImprover improver(
    this->Grid, this->Limits, this->MostNewIn(*piece.Block), *piece.Block, this->Samples);
  improver.Run(round, this->Tried);
  piece.Samples.emplace(improver.TakeSamples());
  piece.Again = improver.ListAgain();
}

/// Gives the new points and triangles of pieces their numbers.
void MeshImprover::MakeRoom(std::vector<Piece>& pieces)
{
  Index points = static_cast<Index>(this->Mesh.Points.size());
  Index triangles = this->Mesh.Corners.CornerCount() / 3;
  const Index pointsBefore = points, trianglesBefore = triangles;
  for (Piece& piece : pieces)
  {
    MeshBlock& block = *piece.Block;
    while (block.Points.size() < block.Mesh.Points.size())
    {
      block.Points.push_back(points++);
    }
    for (std::size_t i = 0; i < block.Mesh.Origins.size(); ++i)
    {
      block.Triangles.push_back(triangles++);
    }
  }
  this->Mesh.Corners.Grow(points - pointsBefore, triangles - trianglesBefore);
  this->Mesh.Points.resize(points);
  this->Mesh.Normals.resize(points);
  if (!this->Mesh.RoomOf.empty())
  {
    this->Mesh.RoomOf.resize(points);
  }
  this->Mesh.Origins.resize(triangles - this->TrianglesAtFirst);
  this->Samples.Grow(triangles - trianglesBefore);
  this->Tried.resize(triangles, 0);
}

/// Puts the triangles of a piece that may have changed back into the surface.
void MeshImprover::PutBack(Piece& piece)
{
  const MeshBlock& block = *piece.Block;
  const ImprovableMesh& mesh = block.Mesh;
  this->Mesh.Corners.PutBack({ mesh.Corners, block.Triangles, block.Points, block.FirstInner });
  this->Samples.PutBack(*piece.Samples, block);
  // Frozen points are as they were, and other pieces may look at them at the same time.
  for (std::size_t i = static_cast<std::size_t>(block.FirstFree); i < block.Points.size(); ++i)
  {
    const Index point = block.Points[i];
    this->Mesh.Points[point] = mesh.Points[i];
    this->Mesh.Normals[point] = mesh.Normals[i];
    if (!mesh.RoomOf.empty())
    {
      this->Mesh.RoomOf[point] = mesh.RoomOf[i];
    }
  }
  const std::size_t given = block.Triangles.size() - mesh.Origins.size();
  for (std::size_t i = 0; i < mesh.Origins.size(); ++i)
  {
    const Index origin = block.Triangles[mesh.Origins[i]];
    this->Mesh.Origins[block.Triangles[given + i] - this->TrianglesAtFirst] =
      origin < this->TrianglesAtFirst ? origin
                                      : this->Mesh.Origins[origin - this->TrianglesAtFirst];
  }
  for (std::size_t i = 0; i < block.Triangles.size(); ++i)
  {
    const Index triangle = static_cast<Index>(i);
    if (!mesh.Corners.IsAlive(3 * triangle) || !block.IsInner(triangle))
    {
      continue;
    }
    std::uint8_t& tried = this->Tried[block.Triangles[i]];
    tried = piece.Again[i] != 0 ? 0 : block.IsFree(triangle) ? 1 : tried;
    if (this->IsPending(block.Triangles[i]))
    {
      piece.Pending.push_back(block.Triangles[i]);
    }
  }
  piece.Block.reset();
  piece.Samples.reset();
}
}
