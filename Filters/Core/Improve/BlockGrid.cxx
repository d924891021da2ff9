// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BlockGrid.h"

#include "Core/Improve/ImprovableMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// Cubes along an axis, at most.
constexpr double MaxCubes = 128.0;

/// How far around a triangle all is taken along, as a share of the side of a block.
constexpr double MarginOfTriangle = 1.0 / 16.0;

/// Where more than one of so many triangles are wanted, most are near them.
constexpr std::size_t ManyOfAll = 50;

/// Triangles that a thread sorts into blocks at a time: whole runs.
constexpr std::size_t ChunkSize = 1024 * TriangleRuns::Length;

/// Calls run(chunk, begin, end) for chunks of so many items, which do not depend on the threads.
template <typename Run>
void ForChunks(std::size_t count, const Execution& execution, Run&& run)
{
  execution.For((count + ChunkSize - 1) / ChunkSize,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
      {
        run(chunk, chunk * ChunkSize, std::min(count, (chunk + 1) * ChunkSize));
      }
    });
}

/// The only block that has all corners of a triangle strictly inside, or -1.
Index BlockOfTriangle(const BlockGrid& blocks, const ImprovableMesh& mesh, Index triangle)
{
  const auto at = [&](Index i) -> const Point3&
  { return mesh.Points[mesh.Corners.VertexOf(3 * triangle + i)]; };
  const Index block = blocks.BlockOf(at(0));
  const Box3 box = blocks.BoxOf(block);
  return box.HasInside(at(0)) && box.HasInside(at(1)) && box.HasInside(at(2)) ? block : -1;
}

/// The box around a triangle and those around it, as far as these are not larger, and more than a
/// small cube of a block.
Box3 BoxAround(const BlockGrid& blocks, const ImprovableMesh& mesh, Index triangle)
{
  Box3 box = BoxOfPart(mesh, triangle);
  const Point3 extent = box.High - box.Low;
  const double margin =
    std::max({ extent[0], extent[1], extent[2], MarginOfTriangle * blocks.Side() });
  const Point3 all{ margin, margin, margin };
  return { box.Low - all, box.High + all };
}

/// Fewer bad triangles are improved sooner than handed on.
constexpr double LeastToDivide = 1000.0;

/// Which process takes which block, by the number of triangles that are wanted in each.
std::vector<int> DivideBlocks(
  const std::vector<Index>& wantedIn, std::size_t together, const Ranks& ranks)
{
  std::vector<int> rank(wantedIn.size(), BlockLists::ByAll);
  for (std::size_t first = 0; first < rank.size(); first += together)
  {
    const auto workOf = [&](std::size_t i) { return static_cast<double>(wantedIn[first + i]); };
    const std::size_t count = std::min(together, rank.size() - first);
    double work = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      work += workOf(i);
    }
    if (!ranks.AreSeveral() || work < LeastToDivide)
    {
      continue;
    }
    const std::vector<std::size_t> ofRanks = DivideWork(ranks.Count, count, workOf);
    for (int r = 0; r < ranks.Count; ++r)
    {
      std::fill(rank.begin() + static_cast<std::ptrdiff_t>(first + ofRanks[r]),
        rank.begin() + static_cast<std::ptrdiff_t>(first + ofRanks[r + 1]), r);
    }
  }
  return rank;
}

/// Lists the blocks in which some triangles lie, and what is around these. Returns the places of
/// blocks in that list; -1: not there, or taken by another process.
std::vector<Index> FindWanted(const BlockGrid& blocks, const ImprovableMesh& mesh,
  const std::vector<Index>& wanted, std::size_t together, const Ranks& ranks, BlockLists& lists)
{
  std::vector<Index> places(static_cast<std::size_t>(blocks.Count()), -1), blockOf;
  for (const Index triangle : wanted)
  {
    blockOf.push_back(BlockOfTriangle(blocks, mesh, triangle));
    if (blockOf.back() >= 0)
    {
      places[blockOf.back()] = 0;
    }
  }
  for (std::size_t block = 0; block < places.size(); ++block)
  {
    if (places[block] >= 0)
    {
      places[block] = static_cast<Index>(lists.Count());
      lists.Blocks.push_back(static_cast<Index>(block));
      lists.Cells.push_back(blocks.CellsOf(lists.Blocks.back()));
    }
  }
  std::vector<Index> wantedIn(lists.Count(), 0);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    if (blockOf[i] >= 0)
    {
      lists.Cells[places[blockOf[i]]].Add(BoxAround(blocks, mesh, wanted[i]));
      ++wantedIn[places[blockOf[i]]];
    }
  }
  lists.Rank = DivideBlocks(wantedIn, together, ranks);
  for (Index& place : places)
  {
    place = place >= 0 && lists.IsTakenBy(ranks.Rank, place) ? place : -1;
  }
  return places;
}

/// A place in a list of blocks, and a triangle.
using Hit = std::array<Index, 2>;

/// Lists which blocks triangles meet, run by run.
class HitFinder
{
public:
  HitFinder(const BlockGrid& blocks, const ImprovableMesh& mesh, const std::vector<Index>& places,
    const std::vector<BlockCells>& cells, TriangleRuns& runs)
    : Blocks(blocks)
    , Mesh(mesh)
    , Places(places)
    , Cells(cells)
    , Runs(runs)
  {
  }

  void AddRun(std::size_t run, std::vector<Hit>& hits) const
  {
    Box3& around = this->Runs.Boxes[run];
    const bool isKnown = !(around.Low[0] < -std::numeric_limits<double>::max());
    bool isNear = !isKnown;
    this->ForHits(around, isKnown, [&](Index) { isNear = true; });
    if (!isNear)
    {
      return;
    }
    const std::size_t first = run * TriangleRuns::Length;
    const std::size_t end = std::min(this->Runs.Count, first + TriangleRuns::Length);
    Box3 all;
    for (std::size_t i = first; i < end; ++i)
    {
      const Index triangle = static_cast<Index>(i);
      const Box3 box = BoxOfPart(this->Mesh, triangle);
      this->ForHits(box, true, [&](Index place) { hits.push_back({ place, triangle }); });
      all.Add(box);
    }
    around = all;
  }

private:
  /// Calls visit(place) for the blocks in the list whose cells a box meets, if that is not empty.
  template <typename Visit>
  void ForHits(const Box3& box, bool isKnown, Visit&& visit) const
  {
    if (isKnown && box.Low[0] <= box.High[0])
    {
      this->Blocks.ForBlocksAt(box,
        [&](Index block)
        {
          const Index place = this->Places[block];
          if (place >= 0 && this->Cells[place].Meet(box))
          {
            visit(place);
          }
        });
    }
  }

  const BlockGrid& Blocks;
  const ImprovableMesh& Mesh;
  const std::vector<Index>& Places; ///< of blocks in the list
  const std::vector<BlockCells>& Cells;
  TriangleRuns& Runs;
};
}

BlockGrid::BlockGrid(const Box3& around, double side, double shift)
{
  const Point3 extent = around.High - around.Low;
  const double longest = std::max({ extent[0], extent[1], extent[2] });
  this->Length = std::max(side, longest / MaxCubes);
  this->Length = this->Length > 0.0 ? this->Length : 1.0;
  this->Inverse = 1.0 / this->Length;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = around.Low[axis] - (1.0 - shift) * this->Length;
    this->Counts[axis] = std::max(
      1, static_cast<int>(std::ceil((around.High[axis] - this->Low[axis]) / this->Length)));
  }
}

Index BlockGrid::PlaceOf(int axis, double coordinate) const
{
  const double place = (coordinate - this->Low[axis]) * this->Inverse;
  const Index last = this->Counts[axis] - 1;
  Index i = place > 0.0 ? static_cast<Index>(std::min<double>(last, place)) : 0;
  // As BoxOf has it, whatever was rounded.
  while (i > 0 && coordinate < this->FaceAt(axis, i))
  {
    --i;
  }
  while (i < last && coordinate >= this->FaceAt(axis, i + 1))
  {
    ++i;
  }
  return i;
}

Index BlockGrid::BlockOf(const Point3& point) const
{
  return (this->PlaceOf(2, point[2]) * this->Counts[1] + this->PlaceOf(1, point[1])) *
    this->Counts[0] +
    this->PlaceOf(0, point[0]);
}

std::array<Index, 3> BlockGrid::PlaceOf(Index block) const
{
  return { block % this->Counts[0], block / this->Counts[0] % this->Counts[1],
    block / this->Counts[0] / this->Counts[1] };
}

Box3 BlockGrid::BoxOf(Index block) const
{
  const std::array<Index, 3> place = this->PlaceOf(block);
  Box3 box = Everywhere();
  for (int axis = 0; axis < 3; ++axis)
  {
    box.Low[axis] = place[axis] > 0 ? this->FaceAt(axis, place[axis]) : box.Low[axis];
    box.High[axis] =
      place[axis] + 1 < this->Counts[axis] ? this->FaceAt(axis, place[axis] + 1) : box.High[axis];
  }
  return box;
}

BlockCells BlockGrid::CellsOf(Index block) const
{
  const std::array<Index, 3> place = this->PlaceOf(block);
  return { { this->FaceAt(0, place[0]), this->FaceAt(1, place[1]), this->FaceAt(2, place[2]) },
    this->Length };
}

/// Calls visit(row, mask) for the rows of small cubes that a box meets.
template <typename Visit>
void BlockCells::ForRowsAt(const Box3& box, Visit&& visit) const
{
  const Place first = this->PlaceOf(box.Low), last = this->PlaceOf(box.High);
  const auto mask = static_cast<std::uint16_t>((2u << last[0]) - (1u << first[0]));
  for (Index z = first[2]; z <= last[2]; ++z)
  {
    for (Index y = first[1]; y <= last[1]; ++y)
    {
      visit(PerSide * z + y, mask);
    }
  }
}

void BlockCells::Add(const Box3& box)
{
  this->ForRowsAt(box, [&](Index row, std::uint16_t mask) { this->Rows[row] |= mask; });
}

bool BlockCells::Meet(const Box3& box) const
{
  std::uint16_t met = 0;
  this->ForRowsAt(box, [&](Index row, std::uint16_t mask) { met |= this->Rows[row] & mask; });
  return met != 0;
}

bool BlockCells::Cover(const Box3& box) const
{
  std::uint16_t missing = 0;
  this->ForRowsAt(box, [&](Index row, std::uint16_t mask) { missing |= ~this->Rows[row] & mask; });
  return missing == 0;
}

BlockLists ListBlocks(const BlockGrid& blocks, const ImprovableMesh& mesh,
  const std::vector<Index>& wanted, std::size_t together, const Ranks& ranks,
  const Execution& execution, TriangleRuns& runs)
{
  BlockLists lists;
  const std::vector<Index> places = FindWanted(blocks, mesh, wanted, together, ranks, lists);
  if (lists.Count() == 0)
  {
    return lists;
  }
  const std::size_t count = static_cast<std::size_t>(mesh.Corners.CornerCount()) / 3;
  runs.Resize(count);
  const HitFinder finder(blocks, mesh, places, lists.Cells, runs);
  std::vector<std::vector<Hit>> hits((count + ChunkSize - 1) / ChunkSize);
  ForChunks(count, execution,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      hits[chunk].reserve(wanted.size() < count / ManyOfAll ? 0 : end - begin);
      for (std::size_t first = begin; first < end; first += TriangleRuns::Length)
      {
        finder.AddRun(first / TriangleRuns::Length, hits[chunk]);
      }
    });
  lists.Offsets.assign(lists.Count() + 1, 0);
  for (const std::vector<Hit>& some : hits)
  {
    for (const Hit& hit : some)
    {
      ++lists.Offsets[hit[0] + 1];
    }
  }
  std::partial_sum(lists.Offsets.begin(), lists.Offsets.end(), lists.Offsets.begin());
  lists.Triangles.resize(lists.Offsets.back());
  std::vector<std::size_t> next(lists.Offsets.begin(), lists.Offsets.end() - 1);
  for (std::vector<Hit>& some : hits)
  {
    for (const Hit& hit : some)
    {
      lists.Triangles[next[hit[0]]++] = hit[1];
    }
    some = {};
  }
  return lists;
}
}
