// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCommonNodes_h
#define OrthoSlicesCommonNodes_h

#include "Core/Labels/BorderPieces.h"

#include <functional>
#include <map>

namespace orthoslices
{
/// A node point at one place of one or several structures.
struct CommonNode
{
  std::vector<std::pair<std::size_t, Index>> Members; ///< structures, and their nodes
  std::array<PieceEnd, 4> Ends{};                     ///< of the pieces at it
  /// All members have these pieces at it, none has a corner, and no arc passes through it.
  bool MayMove = true;
};

/// The node points of several structures.
class CommonNodes
{
public:
  CommonNodes(const std::vector<ArcSurface>& structures, const BorderPieces& borders);

  std::vector<CommonNode> Nodes;

  /**
   * How far a node is to move along its edge, so that the surface around it lies as much outside
   * of the sides of its arcs as inside; not beyond a quarter of the way to the next node of any
   * structure, or the end of the edge. `bulges` says how far the end of a piece would have to move,
   * `tolerance` how far one may on slices across an axis.
   */
  double MoveOf(const CommonNode& node, const std::function<Point3(PieceEnd)>& bulges,
    const std::function<double(int)>& tolerance) const;

private:
  struct Line ///< of M
  {
    int Direction;
    double First, Second;

    bool operator<(const Line& other) const
    {
      return this->Direction != other.Direction ? this->Direction < other.Direction
        : this->First != other.First            ? this->First < other.First
                                                : this->Second < other.Second;
    }
  };
  static Line LineAt(int direction, const Point3& place)
  {
    return { direction, place[FirstAxis(direction)], place[SecondAxis(direction)] };
  }
  double RoomBeside(const SpatialGrid& grid, const GridEdge& edge, const Point3& place) const;

  const std::vector<ArcSurface>& Structures;
  std::map<Line, std::vector<double>> OnLines; ///< ascending positions of nodes of all structures
};
}

#endif
