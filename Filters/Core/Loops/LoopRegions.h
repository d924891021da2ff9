// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLoopRegions_h
#define OrthoSlicesLoopRegions_h

#include "Core/Planar/PlaneFaces.h"

#include <vector>

namespace orthoslices
{
/// What of a slice is inside, where its contours meet.
enum class LoopRule
{
  Union,   ///< loops that cross count together, loops within others are holes, and so on inwards
  EvenOdd, ///< what an odd number of loops runs around
  NonZero  ///< what loops run around more often in one direction than in the other one
};

/**
 * What the loops of a slice run around, face by face of the plane graph that they make.
 *
 * The sides that a walk passes as often in one direction as in the other bound nothing: they are
 * bridges. What is left of a walk without them are its *parts*, each connected. With EvenOdd, a part
 * that runs around everything several times counts once.
 */
class LoopRegions
{
public:
  /// Both have to outlive this.
  LoopRegions(const PlaneWalks& walks, const PlaneFaces& faces);

  /**
   * Which faces are inside, 1 or 0.
   *
   * Union: a part surrounds what its winding number is not zero for. One that no other part surrounds
   * is an outline; one within outlines is a hole, one within holes an outline again, and so on. Inside
   * is what an outline surrounds, but for its holes. A part is within another one if that surrounds
   * 98 % of its area, so that noise on a thin wall does not fill holes; two parts of which each
   * surrounds that much of the other one are alike. A part is no hole of another one that it shares more than two thirds of its length with, the
   * interior on the same side: there is no wall in between, so that it is the same once more.
   *
   * EvenOdd, NonZero: by the sum of all winding numbers.
   */
  std::vector<std::uint8_t> FindInside(LoopRule rule) const;

  /// The same with the interior on the left of loops as they are drawn: inside is what the sum of all
  /// winding numbers is positive for. Where loops bound the outside, as `insideOut` says of all slices
  /// together, it is what the sum is not negative for. EvenOdd: as above, or all the rest.
  std::vector<std::uint8_t> FindInsideAsDrawn(LoopRule rule, bool insideOut) const;

  /**
   * Whether loops meet as noise makes them meet. What a loop surrounds several times or in the other
   * direction than most is in faces of at most 2 % of the rest, and less than a quarter of it in all;
   * no loop has several parts. Of two loops at most 2 % of the smaller one is common to both, or in
   * only one of them, and no more of a loop's length is on another one.
   */
  bool AreMeetingsSlight() const;

private:
  struct Layer
  {
    Index Part;
    Index Winding; ///< not zero
  };
  using Layers = std::vector<Layer>; ///< ascending by part

  Index CountParts() const { return static_cast<Index>(this->TurnsOfPart.size()); }
  void FindParts();
  void AddParts(const std::vector<Index>& passages);
  void AddPart(Index start, const std::vector<std::pair<Index, Index>>& at);
  void SpreadWindings();
  Layers Step(const Layers& layers, Index halfEdge) const;
  void AddSurrounding();
  Layers WindingsAt(Index node, Index component) const;
  void MeasureFaces();
  bool AreWalksPlain() const;
  bool AreWalksApart() const;
  void FindContainers();
  void FindRepeated();
  void RemoveRepeated();
  double LengthOf(Index edge) const;
  bool Contains(Index outer, Index inner) const;
  /// Whether a part is of the component that the face is of.
  bool IsAtHome(Index part, Index face) const
  {
    return this->ComponentOfPart[part] == this->Graph.Component(face);
  }
  std::vector<Index> FindLevels() const;
  std::vector<Index> SumWindings(LoopRule rule) const;

  const PlaneWalks& Walks;
  const PlaneFaces& Graph;
  std::vector<Index> TurnsOfPart;   ///< greatest common divisor of its winding numbers
  std::vector<Index> PartOfPassage; ///< -1 on bridges
  std::vector<Index> Net;           ///< of each passage
  std::vector<Index> EdgeOfPassage;
  std::vector<std::vector<Index>> EdgesOf;    ///< of each component
  std::vector<Layers> LayersOf;               ///< of each face
  std::vector<std::vector<Index>> Containers; ///< of each part: the others that surround all of it
  std::vector<std::uint8_t> IsRepeated;       ///< of each part: it is part of another one's border
  std::vector<Index> WalkOfPart, ComponentOfPart;
  std::vector<double> AreaOfFace; ///< without regard to other components; of outer faces negative
  std::vector<double> AreaOfPart; ///< of what it surrounds
};
}

#endif
