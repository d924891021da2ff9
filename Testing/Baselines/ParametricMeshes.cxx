// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParametricMeshes.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace orthoslices
{
namespace baselines
{
namespace
{

using Vector3 = std::array<double, 3>;

//------------------------------------------------------------------------------
// Right-handed and orthonormal; the last vector is the axis.
struct Frame
{
  explicit Frame(Vector3 axis)
    : W(axis)
  {
    vtkMath::Normalize(this->W.data());
    vtkMath::Perpendiculars(this->W.data(), this->U.data(), this->V.data(), 0.0);
    if (vtkMath::Determinant3x3(this->U.data(), this->V.data(), this->W.data()) < 0.0)
    {
      std::swap(this->U, this->V);
    }
  }

  // The point of cylindrical coordinates RADIUS, ANGLE and HEIGHT.
  Vector3 Place(double radius, double angle, double height) const
  {
    Vector3 position;
    for (int k = 0; k < 3; ++k)
    {
      position[k] = radius * (std::cos(angle) * this->U[k] + std::sin(angle) * this->V[k]) +
        height * this->W[k];
    }
    return position;
  }

  Vector3 U{};
  Vector3 V{};
  Vector3 W;
};

//------------------------------------------------------------------------------
void InsertTriangle(vtkCellArray* triangles, vtkIdType a, vtkIdType b, vtkIdType c)
{
  const vtkIdType ids[3] = { a, b, c };
  triangles->InsertNextCell(3, ids);
}

//------------------------------------------------------------------------------
// Two triangles for each square between two closed rings of COUNT points.
void JoinRings(vtkCellArray* triangles, vtkIdType lower, vtkIdType upper, int count)
{
  for (int i = 0; i < count; ++i)
  {
    const int next = (i + 1) % count;
    InsertTriangle(triangles, lower + i, lower + next, upper + next);
    InsertTriangle(triangles, lower + i, upper + next, upper + i);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSurface(vtkPoints* points, vtkCellArray* triangles)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

//------------------------------------------------------------------------------
double Angle(int step, int count) { return 2.0 * vtkMath::Pi() * step / count; }

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTorus(
  const Vector3& axis, double majorRadius, double minorRadius, int around, int across)
{
  const Frame frame(axis);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (int ring = 0; ring < across; ++ring)
  {
    const double turn = Angle(ring, across);
    for (int i = 0; i < around; ++i)
    {
      points->InsertNextPoint(frame
                                .Place(majorRadius + minorRadius * std::cos(turn), Angle(i, around),
                                  minorRadius * std::sin(turn))
                                .data());
    }
    JoinRings(triangles, ring * around, (ring + 1) % across * around, around);
  }
  return MakeSurface(points, triangles);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeCapsule(
  const Vector3& from, const Vector3& to, double radius, int around)
{
  const Frame frame({ to[0] - from[0], to[1] - from[1], to[2] - from[2] });
  const int ringsPerEnd = around / 4;
  const int rings = 2 * ringsPerEnd;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const auto insert = [&](const Vector3& end, double latitude, int step)
  {
    const Vector3 offset =
      frame.Place(radius * std::cos(latitude), Angle(step, around), radius * std::sin(latitude));
    return points->InsertNextPoint(end[0] + offset[0], end[1] + offset[1], end[2] + offset[2]);
  };
  for (int ring = 0; ring < rings; ++ring)
  {
    const bool atFrom = ring < ringsPerEnd;
    const double quarter = 0.5 * vtkMath::Pi() / ringsPerEnd;
    const double latitude =
      atFrom ? (ring + 1 - ringsPerEnd) * quarter : (ring - ringsPerEnd) * quarter;
    for (int i = 0; i < around; ++i)
    {
      insert(atFrom ? from : to, latitude, i);
    }
    if (ring > 0)
    {
      JoinRings(triangles, (ring - 1) * around, ring * around, around);
    }
  }
  const vtkIdType south = insert(from, -0.5 * vtkMath::Pi(), 0);
  const vtkIdType north = insert(to, 0.5 * vtkMath::Pi(), 0);
  for (int i = 0; i < around; ++i)
  {
    const int next = (i + 1) % around;
    InsertTriangle(triangles, south, next, i);
    InsertTriangle(triangles, north, (rings - 1) * around + i, (rings - 1) * around + next);
  }
  return MakeSurface(points, triangles);
}

} // namespace baselines
} // namespace orthoslices
