// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesPlaneFaces_h
#define OrthoSlicesPlaneFaces_h

#include "Core/Planar/SplitPolygons.h"

#include <vector>

namespace orthoslices
{
/**
 * The plane graph of walks: nodes, edges and the faces between them. Each edge is two half-edges, 2
 * e and 2 e + 1, which run in opposite directions and each have a face on their left. All is
 * decided exactly. REQUIRES: walks as SplitPolygons leaves them.
 */
class PlaneFaces
{
public:
  explicit PlaneFaces(const PlaneWalks& walks);

  /// How often a walk passes an edge in the direction of its even half-edge, less how often in the
  /// other one.
  struct Passage
  {
    Index Walk;
    Index Net;
  };

  Index CountHalfEdges() const { return static_cast<Index>(this->Heads.size()); }
  Index CountFaces() const { return static_cast<Index>(this->ComponentOfFace.size()); }
  Index CountComponents() const { return static_cast<Index>(this->OuterFaces.size()); }

  static Index Twin(Index halfEdge) { return halfEdge ^ 1; }
  Index Head(Index halfEdge) const { return this->Heads[halfEdge]; }
  Index Tail(Index halfEdge) const { return this->Heads[Twin(halfEdge)]; }
  /// Half-edges that leave a node, counter-clockwise.
  const std::vector<Index>& Leaving(Index node) const { return this->Around[node]; }
  /// Of those that leave its tail, the next one clockwise.
  Index Clockwise(Index halfEdge) const { return this->Clockwises[halfEdge]; }

  /// The face on the left.
  Index Face(Index halfEdge) const { return this->Faces[halfEdge]; }
  /// Of the connected parts of the graph, the one around which, or within which, the face lies.
  /// Faces do not know of other components: each has one unbounded face.
  Index Component(Index face) const { return this->ComponentOfFace[face]; }
  Index OuterFace(Index component) const { return this->OuterFaces[component]; }
  Index ComponentOfNode(Index node) const { return this->ComponentAt[node]; }

  /// The passages of all edges are numbered, edge after edge; those with a Net of 0 are among them.
  Index CountPassages() const { return static_cast<Index>(this->Passages.size()); }
  Index FirstPassage(Index edge) const { return this->PassageOffsets[edge]; }
  Index EndOfPassages(Index edge) const { return this->PassageOffsets[edge + 1]; }
  const Passage& PassageAt(Index passage) const { return this->Passages[passage]; }

private:
  void AddEdges(const PlaneWalks& walks);
  void SortAround(const std::vector<Point2>& places);
  void FindComponents(const std::vector<Point2>& places);
  void FindFaces();
  Index OutermostAt(Index node, const std::vector<Point2>& places) const;

  std::vector<Index> Heads; ///< of each half-edge
  std::vector<Index> Clockwises;
  std::vector<Index> Faces;
  std::vector<std::vector<Index>> Around;
  std::vector<Index> ComponentAt; ///< of each node; -1 for those without edges
  std::vector<Index> ComponentOfFace;
  std::vector<Index> OuterFaces; ///< of each component; first one of its half-edges on that face
  std::vector<Passage> Passages;
  std::vector<Index> PassageOffsets{ 0 };
};
}

#endif
