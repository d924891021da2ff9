// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSparseStructure_h
#define OrthoSlicesSparseStructure_h

#include "Core/Pass.h"
#include "Core/Sparse/VirtualPlanes.h"

#include <memory>
#include <vector>

namespace orthoslices
{
/**
 * MakeSparseSurface in two steps, for one of several structures, whose virtual slices are made to
 * agree with those of the others in between. All structures are cut on the same planes, and all
 * keep the second surface, whatever its topology is.
 */
class SparseStructure
{
public:
  /// All have to outlive this.
  SparseStructure(const SliceDensity& density, const VirtualPlanes& planes, Pass& first)
    : Density(density)
    , Planes(planes)
    , First(first)
    , Drawn(first.Tables.Contours)
  {
  }

  /// The first surface, bent and cut on the planes: sets Virtual. False: stopped.
  bool Draw();
  /// All slices, as the second surface is to be made from them.
  Contours ListSlices() const;
  /// Takes the virtual slices as they are once all have been made to agree.
  void TakeVirtual(Contours&& slices);
  /// Draws the virtual slices as they are after all slices of this structure have been made to
  /// agree, so that a second surface changes them no more. False: stopped.
  bool Redraw();
  /// The pass of the second surface, of which the graph is to be drawn. It has the planes of all
  /// structures, even if this one has no virtual slices.
  Pass& StartAgain();
  /// The second surface, up to the inside of its patches, once its graph is drawn. False: stopped.
  bool Connect();
  /// The pass of which patches are to be filled then.
  Pass& ToFill() { return *this->Again; }
  /// Puts the second surface in the place of the first one in its pass.
  void Finish();

  /// Through a few slices of several families, virtual ones are those of a field (SliceField).
  bool FollowsField = false;
  Contours Virtual; ///< of the planes, as MakeVirtualSlices draws them

private:
  bool SketchFirst();
  bool DrawFew();

  const SliceDensity& Density;
  const VirtualPlanes& Planes;
  Pass& First;
  Contours Drawn;              ///< as they are before the first pass
  PriorKnowledge Known;        ///< what the second surface is to come out as
  std::unique_ptr<Pass> Again; ///< of the second surface
  std::vector<Index> LeftOut;  ///< contours that take no part in it
};
}

#endif
