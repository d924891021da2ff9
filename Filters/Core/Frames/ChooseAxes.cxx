// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Frames/ChooseAxes.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace orthoslices
{
namespace
{
using Axes = std::array<Point3, 3>;
/// The family of each axis, or -1.
using Assignment = std::array<int, 3>;

/// A normal within 40 degrees of an axis is nearest to that, and to no other.
const double CosineNear = std::cos(40.0 * 3.14159265358979323846 / 180.0);

Point3 UnitVector(int axis)
{
  Point3 unit{ 0.0, 0.0, 0.0 };
  unit[axis] = 1.0;
  return unit;
}

/// Calls visit with each way of giving axes to the families.
template <typename Visit>
void VisitAssignments(int families, Visit&& visit)
{
  Assignment order{ 0, 1, 2 };
  do
  {
    Assignment assignment = order;
    for (int& family : assignment)
    {
      family = family < families ? family : -1;
    }
    visit(assignment);
  } while (std::next_permutation(order.begin(), order.end()));
}

Assignment NearestToWorld(const std::vector<PlaneFamily>& families)
{
  Assignment best{ -1, -1, -1 };
  double most = -1.0;
  VisitAssignments(static_cast<int>(families.size()),
    [&](const Assignment& assignment)
    {
      double sum = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        sum += assignment[axis] < 0 ? 0.0 : std::abs(families[assignment[axis]].Normal[axis]);
      }
      if (sum > most)
      {
        most = sum;
        best = assignment;
      }
    });
  return best;
}

bool IsNear(const Assignment& assignment, const std::vector<PlaneFamily>& families)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (assignment[axis] >= 0 && std::abs(families[assignment[axis]].Normal[axis]) < CosineNear)
    {
      return false;
    }
  }
  return true;
}

/// The port of each family, if more than half of each came through one of its own.
bool FindPorts(const std::vector<PlaneFamily>& families, Assignment& assignment)
{
  assignment = { -1, -1, -1 };
  for (std::size_t i = 0; i < families.size(); ++i)
  {
    const auto& weights = families[i].WeightOfPort;
    const auto port = std::max_element(weights.begin(), weights.end()) - weights.begin();
    if (weights[port] <= 0.5 * families[i].Weight || assignment[port] >= 0)
    {
      return false;
    }
    assignment[port] = static_cast<int>(i);
  }
  return true;
}

/// A normal, the way an axis should point.
Point3 Pointing(const Point3& normal, int axis)
{
  int decisive = axis;
  for (int i = 0; std::abs(normal[axis]) < 0.1 && i < 3; ++i)
  {
    decisive = std::abs(normal[i]) > std::abs(normal[decisive]) ? i : decisive;
  }
  return normal[decisive] < 0.0 ? -1.0 * normal : normal;
}

/// The axes of a single family: those of the world, turned by as little as brings one to the
/// normal.
Axes CompleteOne(const Point3& normal, int axis)
{
  Axes axes;
  axes[axis] = normal;
  for (const int other : { FirstAxis(axis), SecondAxis(axis) })
  {
    const double share = normal[other] / (1.0 + normal[axis]);
    axes[other] = UnitVector(other) - share * (UnitVector(axis) + normal);
  }
  return axes;
}

/// Sets the axes without a family, and makes all of them right-handed.
void Complete(const Assignment& assignment, Axes& axes)
{
  const auto lacks = [&](int axis) { return assignment[axis] < 0; };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = FirstAxis(axis), second = SecondAxis(axis);
    if (lacks(first) && lacks(second))
    {
      axes = CompleteOne(axes[axis], axis);
      return;
    }
    if (lacks(axis) && !lacks(first) && !lacks(second))
    {
      axes[axis] = Unit(Cross(axes[first], axes[second]));
      return;
    }
  }
  if (Dot(axes[0], Cross(axes[1], axes[2])) < 0.0)
  {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      least = std::abs(axes[axis][axis]) < std::abs(axes[least][least]) ? axis : least;
    }
    axes[least] = -1.0 * axes[least];
  }
}

/// The orthogonal axes that are nearest to some, by least squares.
Axes NearestRotation(const Axes& axes)
{
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix.row(i) << axes[i][0], axes[i][1], axes[i][2];
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
  Axes nearest;
  for (int i = 0; i < 3; ++i)
  {
    nearest[i] = Unit({ rotation(i, 0), rotation(i, 1), rotation(i, 2) });
  }
  return nearest;
}
}

FamilyAxes ChooseAxes(const std::vector<PlaneFamily>& families, const PlaneNoise& noise)
{
  FamilyAxes result;
  if (families.empty())
  {
    return result;
  }
  Assignment assignment = NearestToWorld(families);
  Assignment ofPorts;
  if (!IsNear(assignment, families) && FindPorts(families, ofPorts))
  {
    assignment = ofPorts;
  }
  Axes axes{};
  for (int axis = 0; axis < 3; ++axis)
  {
    result.HasFamily[axis] = assignment[axis] >= 0;
    if (result.HasFamily[axis])
    {
      axes[axis] = Pointing(families[assignment[axis]].Normal, axis);
    }
  }
  Complete(assignment, axes);
  if (!(axes == Axes{ UnitVector(0), UnitVector(1), UnitVector(2) }))
  {
    const Axes rotation = NearestRotation(axes);
    bool allowed = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      allowed = allowed &&
        (assignment[axis] < 0 || families[assignment[axis]].Allows(rotation[axis], noise));
    }
    axes = allowed ? rotation : axes;
  }
  result.Frame = AxisFrame(axes);
  return result;
}
}
