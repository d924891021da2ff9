// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesCycleShape_h
#define OrthoSlicesCycleShape_h

#include "Core/Cells/BorderHeading.h"

#include <vector>

namespace orthoslices
{
/**
 * So many planes on each axis, and the normals at the node points speak for the borders between
 * them: the weights of the evidence were fitted to 16 and 32 planes on each axis, and hold with 8.
 * With fewer, or none, contours turn all the way around between two node points.
 */
constexpr Index MinPlanes = 8;

/// A cycle as the disc that it may bound. Lengths are in world units.
struct CycleShape
{
  Index Cycle;
  bool Loop;
  std::vector<Point3> Border; ///< this and all others as SpatialGrid::Metric has it in the world
  Point3 Center; ///< of the border, by length
  double Radius; ///< root mean square distance of the border from the center
  Point3 Apex;   ///< of the fan: the central point, for a loop the center
  Point3 Area;   ///< unit normal of the disc, outwards
  /// Mean cosine between the surface normals and Area; 0 for loops; see CycleJoin. With fewer than
  /// MinPlanes also what the headings say, if that is more.
  double Flatness;
  double Disagreement;           ///< the greatest at its node points
  std::vector<Point3> Normals;   ///< unit normals of the surface at the border
  std::vector<double> Weights;   ///< of the normals: their sum is 1, or 0 without normals
  std::vector<Heading> Headings; ///< with fewer than MinPlanes on an axis; none for loops
  double Turn = 1.0;             ///< across the cycle, if there are headings; see TurnAcross
};

/// Describes cycles, one after another.
class CycleDescriber
{
public:
  /// Keeps the addresses. `nodeNormals` has x, y, z for each node, `centralPoints` for each cycle.
  CycleDescriber(const CycleGeometry& geometry, const std::vector<double>& nodeNormals,
    const std::vector<double>& centralPoints)
    : Geometry(geometry)
    , NodeNormals(nodeNormals)
    , CentralPoints(centralPoints)
  {
  }

  CycleShape Describe(Index cycle);

private:
  void AddNormals(CycleShape& shape) const;
  void AddHeadings(CycleShape& shape) const;
  Point3 InWorld(const Point3& point) const
  {
    const AxisFrame& metric = this->Geometry.Grid.Metric;
    return metric.IsWorld() ? point : metric.ToWorld(point);
  }

  const CycleGeometry& Geometry;
  const std::vector<double>& NodeNormals;
  const std::vector<double>& CentralPoints;
  std::vector<Index> Points, NodePlaces; ///< of the cycle
};
}

#endif
