// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesDistanceVolume_txx
#define OrthoSlicesDistanceVolume_txx

#include "vtkSMPTools.h"

namespace orthoslices
{
namespace baselines
{

//------------------------------------------------------------------------------
template <typename Functor>
std::vector<double> SampleAll(const Lattice& lattice, const Functor& value)
{
  CheckSize(lattice);
  std::vector<double> values(lattice.NumberOfSamples());
  const auto& [xs, ys, zs] = lattice.Coordinates;
  const std::size_t sizeX = xs.size();
  const std::size_t sizeY = ys.size();
  vtkSMPTools::For(0, static_cast<vtkIdType>(zs.size()),
    [&, sizeX, sizeY](vtkIdType begin, vtkIdType end)
    {
      std::array<std::size_t, 3> at;
      for (at[2] = begin; at[2] < static_cast<std::size_t>(end); ++at[2])
      {
        for (at[1] = 0; at[1] < sizeY; ++at[1])
        {
          for (at[0] = 0; at[0] < sizeX; ++at[0])
          {
            values[lattice.Index(at)] = value(at);
          }
        }
      }
    });
  return values;
}

} // namespace baselines
} // namespace orthoslices

#endif
