// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   a method in a process of its own, whose crash is the failure of one run only
 */

#ifndef OrthoSlicesRunApart_h
#define OrthoSlicesRunApart_h

#include "Baseline.h"

#include <stdexcept>

namespace orthoslices
{
namespace baselines
{

/// The process of a method ended before the method did.
class Crash : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A surface and the wall time that it took, without that of handing it over.
struct TimedSurface
{
  vtkSmartPointer<vtkPolyData> Surface;
  double Seconds = 0.0;
};

/**
 * Reconstructs in a child process, with one thread: a child has none of its parent's, and methods
 * are compared alike. Where there are no child processes (Windows) it happens in this one.
 * @throw std::runtime_error with the method's own sentence if the method throws.
 * @throw Crash if the child ends in any other way.
 */
TimedSurface RunApart(const Baseline& method, const SliceSets& slices);

} // namespace baselines
} // namespace orthoslices

#endif
