// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   one interface for all methods that are compared: from slices to a surface
 */

#ifndef OrthoSlicesBaseline_h
#define OrthoSlicesBaseline_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace orthoslices
{
namespace baselines
{

/**
 * Contours on planes of constant x, y and z: closed polylines, the first point repeated at the end
 * or not. Seen from the positive end of the axis the interior lies on the left, but no method
 * relies on that. Cell arrays are not needed; planes are found from the points.
 */
struct SliceSets
{
  std::array<vtkSmartPointer<vtkPolyData>, 3> Families;
};

/// A way to make a surface from slices.
class Baseline
{
public:
  virtual ~Baseline() = default;

  /// Short and unique, for tables and command lines.
  virtual std::string Name() const = 0;

  /// One sentence for people, with the source of the method.
  virtual std::string Description() const = 0;

  /// Whether the x-, y- and z-slices are used; other families may be null.
  virtual std::array<bool, 3> UsesFamilies() const = 0;

  /**
   * The surface, oriented outwards as far as the method can. Empty if there is nothing to
   * reconstruct; never null. Same input, same output.
   * @throw std::runtime_error with a sentence for the user if the method fails.
   */
  virtual vtkSmartPointer<vtkPolyData> Reconstruct(const SliceSets& slices) const = 0;
};

/**
 * All methods in the order of the tables: the project's own filter first, then the ruled surfaces,
 * then the volume methods.
 */
std::vector<std::unique_ptr<Baseline>> MakeAllMethods();

} // namespace baselines
} // namespace orthoslices

#endif
