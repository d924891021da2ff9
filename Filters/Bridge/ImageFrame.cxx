// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bridge/ImageFrame.h"

#include "Core/Base/Vectors.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
/// Direction cosines may differ this much from 0, 1 and -1 where axes count as parallel.
constexpr double DirectionTolerance = 1e-6;

/// Three unit vectors span less than this where they count as lying in one plane.
constexpr double SmallestVolume = 1e-6;

/// The columns of a direction matrix as unit vectors; false if one has no length.
bool ReadColumns(vtkMatrix3x3* direction, std::array<Point3, 3>& columns, Point3& lengths)
{
  for (int column = 0; column < 3; ++column)
  {
    const Point3 vector{ direction->GetElement(0, column), direction->GetElement(1, column),
      direction->GetElement(2, column) };
    lengths[column] = Length(vector);
    if (!(lengths[column] > 0.0) || !std::isfinite(lengths[column]))
    {
      return false;
    }
    columns[column] = (1.0 / lengths[column]) * vector;
  }
  return true;
}

double VolumeOf(const std::array<Point3, 3>& axes) { return Dot(axes[0], Cross(axes[1], axes[2])); }

/// Which column of the direction matrix is closest to x, y and z: the cosines' sum is the largest.
std::array<int, 3> ClosestColumns(const std::array<Point3, 3>& columns)
{
  std::array<int, 3> order{ 0, 1, 2 };
  std::array<int, 3> best = order;
  double most = -1.0;
  do
  {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum += std::abs(columns[order[axis]][axis]);
    }
    if (sum > most)
    {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

bool IsParallel(const std::array<Point3, 3>& axes)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (std::abs(axes[axis][i] - (i == axis ? 1.0 : 0.0)) > DirectionTolerance)
      {
        return false;
      }
    }
  }
  return true;
}

/// The axis whose cosine with its coordinate axis is the smallest.
int WeakestAxis(const std::array<Point3, 3>& axes)
{
  int weakest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    weakest = axes[axis][axis] < axes[weakest][weakest] ? axis : weakest;
  }
  return weakest;
}

/// The axis in the opposite direction; coordinates along it change their sign.
void TurnAxis(ImageFrame& frame, int axis)
{
  frame.Axes[axis] = -1.0 * frame.Axes[axis];
  frame.Step[axis] = -frame.Step[axis];
}

/// Coordinates of a point along the axes, by Cramer's rule.
Point3 CoordinatesOf(const Point3& point, const std::array<Point3, 3>& axes)
{
  const double volume = VolumeOf(axes);
  Point3 coordinates;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<Point3, 3> replaced = axes;
    replaced[axis] = point;
    coordinates[axis] = VolumeOf(replaced) / volume;
  }
  return coordinates;
}
}

/// Always the same sum in the same order: contours of two slices that share a point still do.
Point3 ImageFrame::ToWorld(const Point3& coordinates) const
{
  return coordinates[0] * this->Axes[0] + coordinates[1] * this->Axes[1] +
    coordinates[2] * this->Axes[2];
}

bool ReadImageFrame(vtkImageData* image, ImageFrame& frame)
{
  std::array<Point3, 3> columns;
  Point3 lengths;
  if (!ReadColumns(image->GetDirectionMatrix(), columns, lengths))
  {
    return false;
  }
  frame.IndexAxis = ClosestColumns(columns);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int column = frame.IndexAxis[axis];
    frame.Axes[axis] = columns[column];
    frame.Step[axis] = image->GetSpacing()[column] * lengths[column];
    if (frame.Axes[axis][axis] < 0.0)
    {
      TurnAxis(frame, axis);
    }
  }
  if (VolumeOf(frame.Axes) < 0.0)
  {
    TurnAxis(frame, WeakestAxis(frame.Axes));
  }

  frame.Origin = { image->GetOrigin()[0], image->GetOrigin()[1], image->GetOrigin()[2] };
  frame.IsOblique = !IsParallel(frame.Axes);
  if (frame.IsOblique)
  {
    frame.Origin = CoordinatesOf(frame.Origin, frame.Axes);
  }
  return VolumeOf(frame.Axes) >= SmallestVolume;
}

void MoveToWorld(const ImageFrame& frame, Precision precision, vtkPolyData* contours)
{
  vtkPoints* along = contours->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(precision == Precision::Single ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(along->GetNumberOfPoints());
  for (vtkIdType id = 0; id < along->GetNumberOfPoints(); ++id)
  {
    Point3 coordinates;
    along->GetPoint(id, coordinates.data());
    points->SetPoint(id, frame.ToWorld(coordinates).data());
  }
  contours->SetPoints(points);
}
}
