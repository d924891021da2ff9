// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesSortByPlanes_h
#define OrthoSlicesSortByPlanes_h

#include "Core/Base/Contours.h"
#include "Core/Base/Polylines.h"
#include "Core/Base/AxisFrame.h"

#include <vector>

namespace orthoslices
{
/// Where the axes come from along which slices are sorted.
enum class FrameChoice
{
  Automatic, ///< the axes of the world if the contours lie on planes across them, else found from these
  World,
  Given ///< the normals of three families
};

struct FrameOptions
{
  FrameChoice Choice = FrameChoice::Automatic;
  std::array<Point3, 3> Given{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  double PlaneTolerance = 1e-5; ///< as a fraction of the diagonal of all polylines
};

/// Polylines by the families of planes that they lie on.
struct SortedSlices
{
  AxisFrame Frame;
  /// Along the axes of the frame. Their cells are the numbers of the polylines.
  std::array<Pieces, 3> Slices;
  /// The polylines on planes at other angles, which are no slices of the grid; in the world.
  Polylines Others;
  PolylineSources From; ///< of all polylines
};

/**
 * Finds the families of planes on which polylines lie, whatever port these came through, and gives
 * their coordinates along the axes of these families (our own addition).
 *
 * If all polylines lie on planes across the axes of the world, to within the tolerance, their
 * coordinates stay as they are; one that lies on several such planes, as it is straight, belongs to
 * the axis of its port if that is among them. Else normals are fitted to the contours by least
 * squares and collected to families (see FindFamilies, ChooseAxes): rotated, or inclined to each
 * other. Contours on planes of no family are left to the caller. What lies on no plane at all is
 * taken for a slice of its port, for the stages that follow to judge.
 *
 * In axes that are not those of the world, contours of one plane have one coordinate: that of the
 * least squares, for all vertices that are off it by no more than noise.
 */
SortedSlices SortByPlanes(const Polylines& lines, const FrameOptions& options);

/// The diagonal of the box around all finite coordinates; 0 if there are none.
double DiagonalOf(const Polylines& lines);

/// The axes for given normals of three families, of any length; the third one is reversed if they
/// are left-handed. False if they are nearly in one plane.
bool MakeGivenFrame(const std::array<Point3, 3>& normals, AxisFrame& frame);
}

#endif
