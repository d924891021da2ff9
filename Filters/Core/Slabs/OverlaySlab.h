// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesOverlaySlab_h
#define OrthoSlicesOverlaySlab_h

#include "Core/Base/Predicates.h"

#include <vector>

namespace orthoslices
{
/**
 * A contour of one of the two slices that bound a slab: a simple polygon with the interior of the
 * solid on its left, so that holes run clockwise. Loops of one slice are disjoint and consistently
 * nested; the outermost ones run counter-clockwise.
 */
struct SlabLoop
{
  std::vector<Point2> Points;
  bool Upper;
};

/// The surface between the contours of two slices. Levels are 0 on the lower, 1 on the upper one.
struct SlabOverlay
{
  /// A new vertex on a loop's segment from After to the next vertex.
  struct Insertion
  {
    Index Loop;
    Index After;
    double Share; ///< of the segment, in (0, 1)
  };

  std::vector<Insertion> Insertions; ///< by loop and segment; those on one segment ascend
  std::vector<Point3> Points;        ///< its own points: u, v and the level, in (0, 1)
  std::vector<std::uint8_t> Above;   ///< of each: whether the solid is inside above only there
  /// Corners are numbered: first the vertices of all loops, loop after loop, then the insertions,
  /// then the own points. Counter-clockwise seen from outside, if u, v and the level are
  /// right-handed.
  std::vector<std::array<Index, 3>> Triangles;
  std::vector<Index> Piece; ///< of each triangle: its connected piece
  bool Valid = false;       ///< unset if loops touch or cross others of their slice, or by rounding
};

/**
 * Joins the contours of two parallel slices by overlay. Seen along the axis, the surface covers
 * what is inside in one slice and outside in the other, once: there it is the graph of a function
 * that is 0 on lower contours and 1 on upper ones. So it cannot touch itself, whatever the contours
 * are: any number of them, nested or not. Where two contours cross in projection both get a new
 * vertex, and an edge joins these two. A contour without partner gets a lid at half height. No
 * triangle lies in one of the slices.
 *
 * Every edge of the contours, as split by the insertions, is an open edge of the surface, and there
 * are no others. Lower loops are passed forward and upper ones backward, as in TraceCycles.
 *
 * The upper loops are overlaid after subtracting `shift`: the slab is sheared, for what runs
 * through it aslant. Own points at level t are to be moved by t * shift; the shear keeps the
 * surface free of contacts.
 */
SlabOverlay OverlaySlab(const std::vector<SlabLoop>& loops, const Point2& shift);

/// The same for holes without the outer contours around them, all of which run clockwise: the solid
/// is outside of them.
SlabOverlay OverlayHoles(const std::vector<SlabLoop>& loops, const Point2& shift);
}

#endif
