// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Baseline.h"

#include "DistanceInterpolation.h"
#include "DistanceInterpolationThreeFamilies.h"
#include "OrthogonalSlices.h"
#include "RuledSurface.h"

namespace orthoslices
{
namespace baselines
{

//------------------------------------------------------------------------------
std::vector<std::unique_ptr<Baseline>> MakeAllMethods()
{
  std::vector<std::unique_ptr<Baseline>> methods;
  methods.push_back(std::make_unique<OrthogonalSlices>());
  methods.push_back(std::make_unique<OneFamily>());
  methods.push_back(std::make_unique<NaiveRuledSurface>());
  methods.push_back(std::make_unique<RuledSurface>(RuledSurface::Mode::Resample));
  methods.push_back(std::make_unique<RuledSurface>(RuledSurface::Mode::PointWalk));
  methods.push_back(std::make_unique<DistanceInterpolation>());
  methods.push_back(std::make_unique<DistanceInterpolationThreeFamilies>());
  return methods;
}

} // namespace baselines
} // namespace orthoslices
