// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFaceArcs_h
#define OrthoSlicesFaceArcs_h

#include "Core/Base/Execution.h"
#include "Core/Base/Predicates.h"
#include "Core/Graph/NodeGraph.h"

#include <vector>

namespace orthoslices
{
/// The arcs of one face.
struct FaceArcs
{
  orthoslices::Face Face;
  const Index* First;
  const Index* Last;

  Index Count() const { return static_cast<Index>(this->Last - this->First); }
  const Index* begin() const { return this->First; }
  const Index* end() const { return this->Last; }
};

/// All arcs that are not removed, ordered by face, and where each face begins.
struct ArcsByFace
{
  std::vector<Index> Arcs;
  std::vector<Index> Offsets{ 0 };
  std::vector<orthoslices::Face> Faces;

  Index Count() const { return static_cast<Index>(this->Faces.size()); }
  FaceArcs operator[](Index face) const
  {
    return { this->Faces[face], this->Arcs.data() + this->Offsets[face],
      this->Arcs.data() + this->Offsets[face + 1] };
  }
};

ArcsByFace GroupArcsByFace(
  const SpatialGrid& grid, const GridCrossings& crossings, const Execution& execution);

/// What the arcs look like now.
struct ArcGeometry
{
  const SpatialGrid& Grid;
  const NodePoints& Nodes;
  const GridCrossings& Crossings;
  const NodeGraph& Graph;

  Index StartNode(Index arc) const { return this->Nodes.NodeOf[arc]; }
  Index EndNode(Index arc) const { return this->Nodes.NodeOf[this->Crossings.Next[arc]]; }

  /// A point of G in the axes of the face.
  Point2 InPlane(const Face& face, Index point) const
  {
    const double* p = this->Graph.Points.data() + 3 * static_cast<std::size_t>(point);
    return { p[FirstAxis(face.Axis)], p[SecondAxis(face.Axis)] };
  }
  Point3 InSpace(const Face& face, const Point2& p) const
  {
    Point3 point;
    point[face.Axis] = this->Grid.Planes[face.Axis][face.Plane];
    point[FirstAxis(face.Axis)] = p[0];
    point[SecondAxis(face.Axis)] = p[1];
    return point;
  }

  /// Calls visit(point of G) from the first to the last point of an arc, nodes included.
  template <typename Visit>
  void VisitPoints(Index arc, Visit&& visit) const
  {
    visit(this->StartNode(arc));
    const Index first = this->Graph.FirstPoint(arc);
    const Index count = this->Graph.PointCount(arc);
    for (Index i = 0; i < count; ++i)
    {
      visit(first + i);
    }
    visit(this->EndNode(arc));
  }
};

/**
 * The edge of its face on which the start or the end of an arc lies, counter-clockwise from the
 * lower one: 0 and 2 are those along FirstAxis, 1 and 3 along SecondAxis.
 */
int BorderEdge(const GridCrossings& crossings, Index crossing, bool isStart);
}

#endif
