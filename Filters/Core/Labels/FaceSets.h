// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFaceSets_h
#define OrthoSlicesFaceSets_h

#include "Core/Labels/ShareBorders.h"
#include "Core/Loops/LoopWindings.h"

#include <map>
#include <set>
#include <vector>

namespace orthoslices
{
/// Which structures the faces of the plane graph of a slice are in, each as an ascending list.
class FaceSets
{
public:
  /// `structures` has that of each walk. A face is in those that run around it more often
  /// counter-clockwise than clockwise.
  FaceSets(const PlaneWalks& walks, const PlaneFaces& faces, const LoopWindings& windings,
    const std::vector<Index>& structures);

  /// Gives slivers, and faces with sets that are not among those allowed, if these are not empty,
  /// to neighbours, as ShareBorders says. The sets of all other faces.
  StructureSets Reassign(double thickness, const StructureSets& allowed);
  /// Faces of some sets get others; Before has what they had.
  void Replace(const std::map<std::vector<Index>, std::vector<Index>>& replaced);
  /// Gives slivers to neighbours, but for faces that are marked.
  void RemoveSlivers(double thickness, const std::vector<std::uint8_t>& isKept);

  Index Count() const { return static_cast<Index>(this->Sets.size()); }
  const std::vector<Index>& operator[](Index face) const { return this->Sets[face]; }
  /// As it was before Reassign and Replace.
  const std::vector<Index>& Before(Index face) const { return this->SetsBefore[face]; }
  double AreaOf(Index face) const { return this->Areas[face]; }
  /// 1 for the faces that are inside a structure; inside any, if it is -1.
  std::vector<std::uint8_t> InsideOf(Index structure) const;
  bool IsOuter(Index face) const { return this->OuterFaces[face] != 0; }

private:
  void FindSets(const LoopWindings& windings, const std::vector<Index>& structures);
  void MeasureFaces(const PlaneWalks& walks, const PlaneFaces& faces, const LoopWindings& windings,
    const std::vector<Index>& structures);
  bool IsSliver(Index face, double thickness) const;
  Index BestNeighbour(Index face, const std::vector<std::uint8_t>& isOpen) const;
  void FillOpen(std::vector<std::uint8_t>& isOpen);

  std::vector<std::vector<Index>> Sets, SetsBefore;
  std::vector<double> Areas, Lengths;          ///< of each face
  std::vector<std::set<Index>> Beside;         ///< of each face: structures with a side on it
  std::vector<std::map<Index, double>> Common; ///< lengths of borders with other faces
  std::vector<std::uint8_t> OuterFaces;
};
}

#endif
