// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Reconstruct.h"

#include "Core/Base/EditContours.h"
#include "Core/MakeSurface.h"
#include "Core/ReadSlices.h"
#include "Core/SparseSurface.h"

namespace orthoslices
{
namespace
{
/// How dense the slices are; not sparse where virtual ones are not asked for.
SliceDensity DensityOf(const Pass& pass)
{
  const Options& options = pass.Settings;
  if (options.Virtual == VirtualSlices::Off || pass.Result.InsideOut)
  {
    return {};
  }
  return { pass.Result.Grid, BoxOf(pass.Tables.Contours),
    options.Virtual == VirtualSlices::BySpacing ? options.VirtualSpacing : 0.0 };
}

}

bool ReconstructContours(Pass& pass)
{
  const SliceDensity density = DensityOf(pass); // of the slices of the input
  if (pass.Settings.Ends == EndCaps::HalfSlice && !pass.Result.InsideOut)
  {
    pass.AddEndSlices();
  }
  return density.IsSparse() ? MakeSparseSurface(density, pass)
                            : ConnectContours(pass) && FillCycles(pass.Settings.Patching, pass);
}

Reconstruction Reconstruct(std::array<Pieces, 3>&& pieces, const Options& options,
  const Execution& execution, const StageObserver& observer)
{
  Pass pass(options, execution, observer);
  // Each part says whether to go on.
  static_cast<void>(ReadSlices(std::move(pieces), pass) && ReconstructContours(pass));
  return std::move(pass.Result);
}
}
