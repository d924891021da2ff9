// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesBlockGrid_h
#define OrthoSlicesBlockGrid_h

#include "Core/Base/Box.h"
#include "Core/Base/Execution.h"
#include "Core/Base/Ranks.h"
#include "Core/Base/Types.h"

#include <vector>

namespace orthoslices
{
struct ImprovableMesh;

/**
 * Parts of a cube, or of all space, that are of interest: small cubes. The outermost ones have no
 * end. Places are sorted into them by a function that ascends along each axis, so boxes with a point
 * in common have the cube of that point in common, whatever was rounded.
 */
class BlockCells
{
public:
  /// None is, of a cube that begins there.
  BlockCells(const Point3& low, double side)
    : Low(low)
    , Inverse(PerSide / side)
  {
  }

  /// Those that a box meets become so.
  void Add(const Box3& box);
  bool Has(const Point3& point) const { return this->Has(this->PlaceOf(point)); }
  /// Whether a box meets one of them,
  bool Meet(const Box3& box) const;
  /// or lies within them.
  bool Cover(const Box3& box) const;

private:
  static constexpr Index PerSide = 16;
  using Place = std::array<Index, 3>;

  Place PlaceOf(const Point3& point) const
  {
    Place place;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double along = (point[axis] - this->Low[axis]) * this->Inverse;
      place[axis] = static_cast<Index>(std::max(0.0, std::min<double>(along, PerSide - 1)));
    }
    return place;
  }
  bool Has(const Place& place) const
  {
    return (this->Rows[PerSide * place[2] + place[1]] >> place[0] & 1) != 0;
  }
  template <typename Visit>
  void ForRowsAt(const Box3& box, Visit&& visit) const;

  Point3 Low;
  double Inverse; ///< of the side of a small cube
  std::array<std::uint16_t, PerSide * PerSide> Rows{};
};

/// Cubes that divide space; the outermost ones have no end.
class BlockGrid
{
public:
  /// Around a box, which is finite. Cubes begin at the share `shift` of their side beside it.
  /// They are larger where there would be too many otherwise.
  BlockGrid(const Box3& around, double side, double shift);

  Index Count() const { return this->Counts[0] * this->Counts[1] * this->Counts[2]; }
  double Side() const { return this->Length; }
  Box3 BoxOf(Index block) const;
  BlockCells CellsOf(Index block) const;
  /// The cube of a point; one on a face is in the upper one.
  Index BlockOf(const Point3& point) const;
  /// Calls visit(block) for those that a box meets.
  template <typename Visit>
  void ForBlocksAt(const Box3& box, Visit&& visit) const;

private:
  std::array<Index, 3> PlaceOf(Index block) const;
  double FaceAt(int axis, Index i) const { return this->Low[axis] + this->Length * i; }
  Index PlaceOf(int axis, double coordinate) const;

  Point3 Low;
  double Length, Inverse;
  std::array<Index, 3> Counts;
};

template <typename Visit>
void BlockGrid::ForBlocksAt(const Box3& box, Visit&& visit) const
{
  std::array<Index, 3> first, last;
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = this->PlaceOf(axis, box.Low[axis]);
    last[axis] = this->PlaceOf(axis, box.High[axis]);
  }
  for (Index z = first[2]; z <= last[2]; ++z)
  {
    for (Index y = first[1]; y <= last[1]; ++y)
    {
      for (Index x = first[0]; x <= last[0]; ++x)
      {
        visit((z * this->Counts[1] + y) * this->Counts[0] + x);
      }
    }
  }
}

/// The triangles of some blocks. Several processes divide the blocks among themselves.
struct BlockLists
{
  std::vector<Index> Blocks;     ///< ascending
  std::vector<BlockCells> Cells; ///< of each block: where some triangles are, and around these
  std::vector<int> Rank;         ///< of each block: which process takes it, or ByAll
  std::vector<std::size_t> Offsets;
  std::vector<Index> Triangles; ///< those of block i from Offsets[i] on, ascending, if it is taken

  std::size_t Count() const { return this->Blocks.size(); }
  bool IsTakenBy(int rank, std::size_t block) const
  {
    return this->Rank[block] == rank || this->Rank[block] == ByAll;
  }

  static constexpr int ByAll = -1; ///< where to hand on what comes of them would take longer
};

/**
 * Boxes around runs of triangles with neighbouring numbers, most of which are near each other: a run
 * that is far from all that is wanted need not be looked at triangle by triangle.
 */
struct TriangleRuns
{
  static constexpr std::size_t Length = 64;

  /// So many triangles; new ones, and those in their runs, are not known yet.
  void Resize(std::size_t triangles)
  {
    this->Boxes.resize(this->Count / Length); // the last one may not be full
    this->Boxes.resize((triangles + Length - 1) / Length, Everywhere());
    this->Count = triangles;
  }

  /// A triangle has changed.
  void Forget(Index triangle)
  {
    const std::size_t run = static_cast<std::size_t>(triangle) / Length;
    if (run < this->Boxes.size())
    {
      this->Boxes[run] = Everywhere();
    }
  }

  std::size_t Count = 0;   ///< of triangles
  std::vector<Box3> Boxes; ///< of runs; without end where triangles have changed since
};

/// Lists the triangles around some, in the blocks in which these lie strictly and which this process
/// takes. Of each `together` blocks, one behind the other, processes take about the same work, or all
/// of them all.
BlockLists ListBlocks(const BlockGrid& blocks, const ImprovableMesh& mesh,
  const std::vector<Index>& wanted, std::size_t together, const Ranks& ranks,
  const Execution& execution, TriangleRuns& runs);
}

#endif
