// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Base/AxisFrame.h"

#include <algorithm>
#include <cmath>

namespace orthoslices
{
AxisFrame::AxisFrame(const std::array<Point3, 3>& normals)
{
  this->World = normals == this->Normals;
  this->Normals = normals;
  const double volume = Dot(normals[0], Cross(normals[1], normals[2]));
  for (int axis = 0; axis < 3 && !this->World; ++axis)
  {
    this->Edges[axis] = (1.0 / volume) * Cross(normals[FirstAxis(axis)], normals[SecondAxis(axis)]);
  }
}

bool AxisFrame::IsRotation() const
{
  double greatest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    greatest =
      std::max(greatest, std::abs(Dot(this->Normals[axis], this->Normals[FirstAxis(axis)])));
  }
  return greatest <= 1e-12; // far above rounding, far below what shows
}
}
