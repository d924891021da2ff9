// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruct.h"

#include "Core/BorderCaps.h"
#include "Core/MakeSurface.h"
#include "Core/ReadSlices.h"
#include "Core/SparseSurface.h"

namespace orthoslices
{
namespace
{
void AddEndSlicesIfAsked(Pass& pass)
{
  if (pass.Settings.Ends == EndCaps::HalfSlice && !pass.Result.InsideOut)
  {
    pass.AddEndSlices();
  }
}
}

bool AddOuterSlices(Pass& pass)
{
  AddEndSlicesIfAsked(pass);
  return AddBorderSlices(pass);
}

bool ReconstructContours(Pass& pass)
{
  const SparseSlices sparse(pass); // of the slices of the input
  if (sparse.Any())
  {
    AddEndSlicesIfAsked(pass);
    return MakeSparseSurface(sparse, pass);
  }
  if (!AddOuterSlices(pass) || !ConnectContours(pass))
  {
    return false;
  }
  DivideSurface(pass);
  return FillCycles(pass.Settings.Patching, pass);
}

Reconstruction Reconstruct(std::array<Pieces, 3>&& pieces, const Options& options,
  const Execution& execution, const StageObserver& observer)
{
  Pass pass(options, execution, observer);
  try
  {
    // Each part says whether to go on.
    static_cast<void>(ReadSlices(std::move(pieces), pass) && ReconstructContours(pass));
  }
  catch (const Stopped&)
  {
    pass.Result.Stopped = true;
  }
  return std::move(pass.Result);
}
}
