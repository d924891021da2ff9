// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLoopWindings_h
#define OrthoSlicesLoopWindings_h

#include "Core/Planar/PlaneFaces.h"

#include <vector>

namespace orthoslices
{
/// The share of an area, or of a length, that does not count: noise makes contours cross by about
/// that.
constexpr double LittleShare = 0.02;

/**
 * How often the loops of a slice run around each face of the plane graph that they make.
 *
 * The sides that a walk passes as often in one direction as in the other bound nothing: they are
 * bridges. What is left of a walk without them are its *parts*, each connected. A part *surrounds*
 * the faces that its winding number is not zero for.
 */
class LoopWindings
{
public:
  /// Both have to outlive this.
  LoopWindings(const PlaneWalks& walks, const PlaneFaces& faces);

  struct Layer
  {
    Index Part;
    Index Winding; ///< not zero; counter-clockwise
  };
  using Layers = std::vector<Layer>; ///< ascending by part

  const PlaneFaces& GetGraph() const { return this->Graph; }
  Index CountWalks() const { return static_cast<Index>(this->Walks.Walks.size()); }
  Index CountParts() const { return static_cast<Index>(this->TurnsOfPart.size()); }
  Index WalkOf(Index part) const { return this->WalkOfPart[part]; }
  /// The greatest common divisor of a part's winding numbers.
  Index TurnsOf(Index part) const { return this->TurnsOfPart[part]; }
  /// Of the passages that PlaneFaces has; -1 on bridges.
  Index PartOf(Index passage) const { return this->PartOfPassage[passage]; }
  /// The parts that surround a face, those of other components among them.
  const Layers& LayersOf(Index face) const { return this->LayersOfFace[face]; }
  /// Without regard to other components; not positive for outer faces.
  double AreaOfFace(Index face) const { return this->FaceAreas[face]; }
  /// Area of what a part surrounds.
  double AreaOf(Index part) const { return this->PartAreas[part]; }
  double LengthOf(Index edge) const;
  /// Whether a part is of the component that the face is of.
  bool IsAtHome(Index part, Index face) const
  {
    return this->ComponentOfPart[part] == this->Graph.Component(face);
  }

private:
  void FindParts();
  void AddParts(const std::vector<Index>& passages);
  void AddPart(Index start, const std::vector<std::pair<Index, Index>>& at);
  void SpreadWindings();
  Layers Step(const Layers& layers, Index halfEdge) const;
  void AddSurrounding();
  Layers WindingsAt(Index node, Index component) const;
  void MeasureFaces();

  const PlaneWalks& Walks;
  const PlaneFaces& Graph;
  std::vector<Index> TurnsOfPart, WalkOfPart, ComponentOfPart;
  std::vector<Index> PartOfPassage;
  std::vector<Index> Net; ///< of each passage
  std::vector<Index> EdgeOfPassage;
  std::vector<std::vector<Index>> EdgesOf; ///< of each component
  std::vector<Layers> LayersOfFace;
  std::vector<double> FaceAreas, PartAreas;
};
}

#endif
