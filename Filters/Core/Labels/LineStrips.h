// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesLineStrips_h
#define OrthoSlicesLineStrips_h

#include "Core/Slices/SpatialGrid.h"

#include <map>
#include <tuple>
#include <vector>

/**
 * @file
 * @brief   the strips beside the lines in which planes meet, and what becomes of places on these
 *          lines, for ClearLines
 */
namespace orthoslices
{
/// A line in which planes meet: its direction, and where it is along the next two axes.
using GridLine = std::tuple<int, double, double>;

/// The line in which a slice meets a plane across another axis.
inline GridLine LineOf(int axis, double coordinate, int axisOfPlane, double plane)
{
  const int direction = 3 - axis - axisOfPlane;
  return FirstAxis(direction) == axis ? GridLine{ direction, coordinate, plane }
                                      : GridLine{ direction, plane, coordinate };
}

/**
 * The strips beside the planes of one axis, and the slabs between these, as bands, ascending: slab s
 * has the bands 3 s, beside its lower plane, 3 s + 1, and 3 s + 2, beside its upper one. A place on
 * a plane is in the band above.
 */
class StripBands
{
public:
  StripBands(const SpatialGrid& grid, int axis);

  /// The band of a place; the rim of a strip is no part of it.
  Index Find(double x) const;
  static bool IsStrip(Index band) { return band % 3 != 1; }
  /// Where a band ends, and the next one begins: on a plane, or on a rim.
  double EndOf(Index band) const { return this->Ends[band]; }
  static bool EndsOnPlane(Index band) { return band % 3 == 2; }
  /// The rim of a strip.
  double RimOf(Index strip) const { return this->Ends[strip % 3 == 0 ? strip : strip - 1]; }
  /// Whether there is a place of a strip in a range.
  bool IsStripIn(double low, double high) const;

private:
  std::vector<double> Ends; ///< of all bands but the last one
};

/// What becomes of the places at which contours pass a line. `bands` are those of its axis.
class LineNodes
{
public:
  void Add(double place) { this->Places.push_back(place); }
  /// Once all places are known: those that are closer than the Margin to one before become one with
  /// it, and those in a strip, or that close to it, go to its rim.
  void Settle(const SpatialGrid& grid, int axis, const StripBands& bands);
  double NewPlace(double place, const StripBands& bands) const;

private:
  std::vector<double> Places, New;
};

using NodesOfLines = std::map<GridLine, LineNodes>;
}

#endif
