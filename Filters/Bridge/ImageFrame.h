// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OrthoSlicesImageFrame_h
#define OrthoSlicesImageFrame_h

#include "Core/Base/Types.h"
#include "Core/Slicing/PlaneContours.h"

#include <array>

class vtkImageData;
class vtkPolyData;

namespace orthoslices
{
/**
 * The axes along which an image is sliced, from its direction matrix: x, y and z where the image's
 * axes are parallel to the coordinate axes, in any order and direction; else axes of its own.
 *
 * A point of the world is the sum of the three axes, each times the coordinate along it. The axes
 * are unit vectors and right-handed, so that what lies on the left of a contour stays there.
 */
struct ImageFrame
{
  std::array<Point3, 3> Axes{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  Point3 Origin{};                         ///< of the image, in coordinates along the axes
  std::array<int, 3> IndexAxis{ 0, 1, 2 }; ///< of the image that runs along each axis
  std::array<double, 3> Step{ 1, 1, 1 };   ///< along each axis for one more in its index
  bool IsOblique = false;                  ///< whether the axes are others than x, y and z

  Point3 ToWorld(const Point3& coordinates) const;
};

/**
 * The frame of an image. Each axis of an oblique image stands for the coordinate axis that it is
 * closest to, all three together; it runs the same way as that, but for the axis that agrees least
 * if the axes would be left-handed otherwise. Returns false if the columns of the direction matrix
 * lie in one plane.
 */
bool ReadImageFrame(vtkImageData* image, ImageFrame& frame);

/// Moves points whose coordinates are along the frame's axes to where they are in the world.
void MoveToWorld(const ImageFrame& frame, Precision precision, vtkPolyData* contours);
}

#endif
