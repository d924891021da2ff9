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
   * Union: a part surrounds what its winding number is not zero for. One that is surrounded by no
   * other part, but for those that surround the same, is an outline; one within outlines is a hole,
   * one within holes an outline again, and so on. Inside is what an outline surrounds, but for its holes.
   * A part is no hole of another one that it shares more than two thirds of its length with, the
   * interior on the same side: there is no wall in between, so that it is the same once more.
   *
   * EvenOdd, NonZero: by the sum of all winding numbers.
   */
  std::vector<std::uint8_t> FindInside(LoopRule rule) const;

  /// The same with the interior on the left of loops as they are drawn: inside is what the sum of all
  /// winding numbers is positive for; if that is nothing, all for which it is not negative.
  std::vector<std::uint8_t> FindInsideAsDrawn(LoopRule rule) const;

  Index CountParts() const { return static_cast<Index>(this->WalkOfPart.size()); }
  /// Which walk each part is from, ascending.
  const std::vector<Index>& GetWalks() const { return this->WalkOfPart; }
  /// Of each part: the one that it repeats, as above, or the first part that surrounds the same;
  /// mostly itself.
  const std::vector<Index>& GetSame() const { return this->SameAs; }
  /// Of each walk: whether it surrounds something together with another one, neither all of it.
  std::vector<std::uint8_t> FindOverlapping() const;

private:
  struct Layer
  {
    Index Part;
    Index Winding; ///< not zero
  };
  using Layers = std::vector<Layer>; ///< ascending by part

  void FindParts();
  void AddParts(Index walk, const std::vector<Index>& passages);
  void SpreadWindings();
  Layers Step(const Layers& layers, Index halfEdge) const;
  void AddSurrounding();
  Layers WindingsAt(Index node, Index component) const;
  void FindContainers();
  void FindRepeated();
  void RemoveRepeated();
  double LengthOf(Index edge) const;
  bool Contains(Index outer, Index inner) const;
  std::vector<Index> FindLevels() const;
  std::vector<Index> SumWindings(LoopRule rule) const;

  const PlaneWalks& Walks;
  const PlaneFaces& Graph;
  std::vector<Index> WalkOfPart;
  std::vector<Index> TurnsOfPart;   ///< greatest common divisor of its winding numbers
  std::vector<Index> PartOfPassage; ///< -1 on bridges
  std::vector<Index> Net;           ///< of each passage
  std::vector<Index> EdgeOfPassage;
  std::vector<std::vector<Index>> EdgesOf;    ///< of each component
  std::vector<Layers> LayersOf;               ///< of each face
  std::vector<std::vector<Index>> Containers; ///< of each part: the others that surround all of it
  std::vector<Index> SameAs;
};
}

#endif
