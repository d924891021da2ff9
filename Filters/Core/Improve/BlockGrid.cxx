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

/// Triangles that a thread sorts into blocks at a time.
constexpr std::size_t ChunkSize = 65536;

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

/// Lists the blocks in which some triangles lie, and what is around these. Returns the places of
/// blocks in that list; -1: not there.
std::vector<Index> FindWanted(const BlockGrid& blocks, const ImprovableMesh& mesh,
  const std::vector<Index>& wanted, BlockLists& lists)
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
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    if (blockOf[i] >= 0)
    {
      lists.Cells[places[blockOf[i]]].Add(BoxAround(blocks, mesh, wanted[i]));
    }
  }
  return places;
}
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
  const std::vector<Index>& wanted, const Execution& execution)
{
  BlockLists lists;
  const std::vector<Index> places = FindWanted(blocks, mesh, wanted, lists);
  if (lists.Count() == 0)
  {
    return lists;
  }
  const std::size_t count = static_cast<std::size_t>(mesh.Corners.CornerCount()) / 3;
  using Hit = std::array<Index, 2>; // a place in the list, and a triangle
  std::vector<std::vector<Hit>> hits((count + ChunkSize - 1) / ChunkSize);
  ForChunks(count, execution,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      hits[chunk].reserve(wanted.size() < count / ManyOfAll ? 0 : end - begin);
      for (Index triangle = static_cast<Index>(begin); triangle < static_cast<Index>(end);
           ++triangle)
      {
        const Box3 box = BoxOfPart(mesh, triangle);
        if (box.Low[0] <= box.High[0])
        {
          blocks.ForBlocksAt(box,
            [&](Index block)
            {
              if (places[block] >= 0 && lists.Cells[places[block]].Meet(box))
              {
                hits[chunk].push_back({ places[block], triangle });
              }
            });
        }
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
