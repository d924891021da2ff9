// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImprovableMesh_h
#define OrthoSlicesImprovableMesh_h

#include "Core/Base/Box.h"
#include "Core/Improve/SheetBorders.h"

#include <vector>

namespace orthoslices
{
/// A triangle surface whose triangles are to be shaped well.
struct ImprovableMesh
{
  CornerTable Corners; ///< links are not needed
  std::vector<Point3> Points;
  std::vector<Point3> Normals; ///< of the surface at the points; zero where it has none
  /// Of each triangle, if it is part of a patch that no smooth surface stands behind: the number of
  /// that patch; else -1. Empty: all are -1.
  std::vector<Index> Plain{};
  /// Points from that one on are inside patches.
  Index FirstInside = 0;
  std::vector<Index> Origins{}; ///< of each triangle that is new: one that was where it is
  SheetBorders Borders{};       ///< if it has sheets that meet
  /// Boxes that parts of the surface may not leave, and of each point which one; empty: none.
  std::vector<Box3> Rooms{};
  std::vector<Index> RoomOf{};
};

/// The box of a triangle; empty if it is gone. What stands for something beyond a border is nowhere.
inline Box3 BoxOfPart(const ImprovableMesh& mesh, Index triangle)
{
  Box3 box;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3 && mesh.Corners.IsAlive(corner);
       ++corner)
  {
    if (mesh.Corners.VertexOf(corner) >= mesh.Borders.Beyond)
    {
      box.Add(mesh.Points[mesh.Corners.VertexOf(corner)]);
    }
  }
  return box;
}

/// What may be done to a surface.
struct ImprovementLimits
{
  /// How far the surface may move, in world units; beside the worst triangles, twice as far.
  double Tolerance = 0.0;
  double SmallAngle = 0.0; ///< triangles with a smaller one are to be improved, in degrees
  Index Kept = 0;          ///< the first so many points stay where they are
  /// New triangles for each that there is, at most: a guard, as splits make something better. 0: none.
  double Growth = 1.0;
  /// Whether it is divided into blocks, which has each grow by itself; else there is one.
  bool Divides = true;
};
}

#endif
