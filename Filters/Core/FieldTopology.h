// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesFieldTopology_h
#define OrthoSlicesFieldTopology_h

#include "Core/Pass.h"

namespace orthoslices
{
/**
 * How the surface that follows a field may hang together: what the first surface joins stays
 * joined, and tunnels come in only if `mayAdd`. Numbers that the user expects have been decided by
 * the first surface.
 */
class FieldTopology
{
public:
  /// `mayAdd`: tunnels, to those of the first surface.
  FieldTopology(const Pass& first, bool mayAdd)
    : Expected(first.Settings.Known)
    , First(first.Result.Topology)
    , MayAdd(mayAdd)
  {
  }

  /// What the second surface is to come out with where it is undecided.
  PriorKnowledge Known() const
  {
    return { this->First.Components, this->Expected.Genus >= 0 ? this->First.Genus : -1 };
  }

  bool operator()(const SurfaceTopology& found) const
  {
    const bool hasComponents = this->Expected.Components > 0
      ? found.Components == this->First.Components
      : found.Components <= this->First.Components;
    const bool hasGenus = this->Expected.Genus >= 0
      ? found.Genus == this->First.Genus
      : found.Genus <= this->First.Genus || this->MayAdd;
    return hasComponents && hasGenus;
  }

private:
  PriorKnowledge Expected;
  SurfaceTopology First;
  bool MayAdd;
};
}

#endif
