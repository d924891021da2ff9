// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoisyContours.h"

#include "PlanarContours.h"

#include "Support/Random.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>
#include <cstring>

namespace orthoslices
{
namespace baselines
{
namespace
{

//------------------------------------------------------------------------------
// Random numbers that depend on the seed, the axis and the place alone.
support::Random RandomAt(const double point[3], int axis, std::uint64_t seed)
{
  std::uint64_t state = support::Random(seed + static_cast<std::uint64_t>(axis)).Bits();
  for (int i = 0; i < 3; ++i)
  {
    const double coordinate = point[i] + 0.0; // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    state = support::Random(state ^ bits).Bits();
  }
  return support::Random(state);
}

//------------------------------------------------------------------------------
// Two independent numbers of standard deviation 1 (Box and Muller).
Point2 NormalPair(support::Random random)
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.Uniform(0.0, 1.0)));
  const double angle = random.Uniform(0.0, 2.0 * vtkMath::Pi());
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MoveVertices(
  vtkPolyData* contours, int axis, double deviation, std::uint64_t seed)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(contours->GetNumberOfPoints());
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    double point[3];
    contours->GetPoint(id, point);
    const Point2 move = NormalPair(RandomAt(point, axis, seed));
    point[(axis + 1) % 3] += deviation * move[0];
    point[(axis + 2) % 3] += deviation * move[1];
    points->SetPoint(id, point);
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(contours);
  moved->SetPoints(points);
  return moved;
}

} // anonymous namespace

//------------------------------------------------------------------------------
SliceSets AddNoise(const SliceSets& slices, double deviation, std::uint64_t seed)
{
  SliceSets noisy = slices;
  for (int axis = 0; axis < 3 && deviation > 0.0; ++axis)
  {
    if (slices.Families[axis] && slices.Families[axis]->GetNumberOfPoints() > 0)
    {
      noisy.Families[axis] = MoveVertices(slices.Families[axis], axis, deviation, seed);
    }
  }
  return noisy;
}

} // namespace baselines
} // namespace orthoslices
