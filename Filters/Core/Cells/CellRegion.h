// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCellRegion_h
#define OrthoSlicesCellRegion_h

#include "Core/Base/Predicates.h"
#include "Core/Cells/PatchMesh.h"

#include <vector>

namespace orthoslices
{
/**
 * A part of the boundary of a cell between cycles. The corners of the cell have the bits 0, 1, 2
 * for upper in x, y, z; its faces are 2 * axis + upper; its edges 4 * direction + 2 * upper in
 * SecondAxis + upper in FirstAxis. *Left* is the left of a cycle, seen from outside the cell.
 */
struct CellRegion
{
  /// A node point of a cycle. Next and Previous are places in Nodes.
  struct NodePlace
  {
    Index Node;
    int Edge;    ///< on which it lies
    int Face;    ///< on which the arc after it lies
    Index Place; ///< on the border
    Index Next, Previous;
    bool Left; ///< the region lies on the left of the cycle
  };
  /// A cycle without node points: places [First, Last) of the border, on one face.
  struct LoopPlace
  {
    int Face;
    Index First, Last;
    bool Left;
  };

  std::vector<Index> Cycles;
  std::vector<Index> Border;             ///< points of G around the cycles, one after another
  std::vector<Index> BorderOffsets{ 0 }; ///< of each cycle
  std::vector<NodePlace> Nodes;
  std::vector<LoopPlace> Loops;
  std::array<bool, 8> Corners{}; ///< inside the region

  /// Whether the region lies on the left of its first cycle.
  bool IsLeft() const
  {
    return this->Nodes.empty() ? this->Loops.front().Left : this->Nodes.front().Left;
  }
};

/// The regions of one cell.
class CellRegions
{
public:
  explicit CellRegions(const CycleGeometry& geometry)
    : Geometry(geometry)
    , Code(geometry.Grid)
  {
  }

  /// The region of each cycle: what lies on the other side of it than corner 0 of the cell.
  std::vector<CellRegion> Find(const Index* first, const Index* last);

  /// Whether the cycle of a region, which is not one of the outer region's own, lies within the
  /// latter.
  bool Contains(const CellRegion& outer, const CellRegion& cycle) const;

  /**
   * The borders of the region on a face, with the region on their left seen from outside. Vertices
   * are places on the border of the region, or -1 - corner.
   */
  std::vector<std::vector<Index>> RingsOn(const CellRegion& region, int face) const;

  /// Makes a region the rest of the cell's boundary, on the other side of its cycle.
  static void Flip(CellRegion& region);
  /// The first region without the others, which lie within. The cycles stay in the given order.
  static CellRegion Subtract(const std::vector<const CellRegion*>& regions, std::size_t outermost);

  Point3 Corner(int corner) const;
  /// Ends the cell at the bounds of the surface where it reaches beyond them.
  void ClipToBounds();
  const Point3& LowCorner() const { return this->Low; }
  const Point3& HighCorner() const { return this->High; }

private:
  struct RingVertex;

  CellRegion Describe(Index cycle) const;
  void AddNode(Index cycle, const HalfArc& half, CellRegion& region) const;
  void SetExtent(const std::vector<CellRegion>& regions);
  void FindCorners(CellRegion& region) const;
  bool FindLeft(const CellRegion& region) const;
  std::vector<RingVertex> RingOf(const CellRegion& region, int face) const;
  Point2 OnFace(const CellRegion& region, int face, Index vertex) const;

  const CycleGeometry& Geometry;
  GridEdgeCode Code;
  Point3 Low{}, High{}; ///< the cell, bounded
};

/// The axes of a face of a cell, right-handed seen from outside.
inline std::array<int, 2> AxesOfFace(int face)
{
  const int axis = face / 2;
  return face % 2 == 1 ? std::array<int, 2>{ FirstAxis(axis), SecondAxis(axis) }
                       : std::array<int, 2>{ SecondAxis(axis), FirstAxis(axis) };
}
}

#endif
