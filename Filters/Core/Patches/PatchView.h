// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPatchView_h
#define OrthoSlicesPatchView_h

#include "Core/Base/Box.h"
#include "Core/Base/Predicates.h"
#include "Core/Patches/PatchBorder.h"

#include <vector>

namespace orthoslices
{
/**
 * The most by which lines spread, as the border's mean radius by the distance of their centre. The
 * normals of a patch that is bent more point so far apart that a centre says nothing of it. Half
 * the value makes exact cuts worse by 0.4 % at most, twice as much changes nothing
 * (Testing/Benchmarks/PatchErrors).
 */
constexpr double MaxBend = 1.2;

/**
 * The least distance of the border from the centre of the lines, as a part of the distance of the
 * border's middle: nearer, the scale at which lines are seen would more than triple over the patch.
 * Half as much changes nothing, twice as much makes noisy contours worse by 1 %
 * (Testing/Benchmarks/PatchErrors).
 */
constexpr double MinDistanceFromCenter = 0.3;

/**
 * How a patch is looked at. A point (u, v) of the plane stands for a line in space, which meets the
 * patch once: parallel to the mean normal, or, where the patch is bent, through a center of its
 * curvature. Local coordinates have their origin at the centroid of the border, their z-axis along
 * the mean normal, and the border's mean radius as their unit.
 */
class PatchView
{
public:
  /// False if there is none: no normals, or no extent.
  bool Set(const PatchBorder& border);

  const std::vector<Point3>& Places() const { return this->LocalPlaces; }
  const std::vector<Point3>& Normals() const { return this->LocalNormals; }
  /// The border in the plane, counter-clockwise if it can be seen as a whole.
  const std::vector<Point2>& Border() const { return this->Projected; }
  /// The corners of the triangles on the border, seen likewise: those of the border, or of the
  /// outline that was set after it.
  const std::vector<Point2>& Outline() const
  {
    return this->HasOutline ? this->ProjectedOutline : this->Projected;
  }
  void SetOutline(const PatchBorder& outline);
  double Radius() const { return this->Unit; }

  Point3 ToLocal(const Point3& place) const
  {
    return this->Turn((1.0 / this->Unit) * (place - this->Origin));
  }
  Point3 ToWorld(const Point3& local) const;
  Point3 DirectionToWorld(const Point3& local) const;
  Point2 Project(const Point3& local) const
  {
    const double scale = 1.0 / (1.0 + this->Bend * local[2]);
    return { scale * local[0], scale * local[1] };
  }
  /// The direction of a line, whose z is 1.
  Point3 LineAt(const Point2& p) const { return { this->Bend * p[0], this->Bend * p[1], 1.0 }; }
  Point3 OnLine(const Point2& p, double z) const
  {
    const double scale = 1.0 + this->Bend * z;
    return { scale * p[0], scale * p[1], z };
  }
  /// The height on a line that is nearest to z within a box; z if the line misses the box.
  double Clamp(const Point2& p, const Box3& box, double z) const;

  /**
   * Whether every line meets the patch once: all its triangles, seen in this way, turn left by more
   * than rounding can change. REQUIRES: they are a triangulation of a disc; the projected border is
   * simple. Then no two triangles meet but in what they have in common.
   */
  bool SeesAll(const InnerPatch& patch) const;

private:
  Point3 Turn(const Point3& d) const;

  Point3 Origin{};
  std::array<Point3, 3> Axes{};
  double Unit = 1.0;
  double Bend = 0.0; ///< 1 / distance of the center of the lines, behind the origin
  std::vector<Point3> LocalPlaces, LocalNormals;
  std::vector<Point2> Projected, ProjectedOutline;
  bool HasOutline = false; ///< else the border is its own
};
}

#endif
