// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/FairSurface.h"

#include "Core/Base/DisjointSets.h"
#include "Core/Sparse/BendingOperator.h"
#include "Core/Sparse/RoundnessLoad.h"
#include "Core/Sparse/SlabPull.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthoslices
{
namespace
{
using Matrix = SparseMatrix;

/// The equations of least bending, for the points that are free. They are made and put in order
/// once; points that are held later keep a row of their own.
class BendingEquations
{
public:
  /// Points with `place` >= 0 are free, numbered by their place.
  BendingEquations(const BendingOperator& bending, const std::vector<std::uint8_t>& crease,
    std::vector<Index>&& place, Index freePoints, const std::vector<Point3>& points);

  bool IsFree(Index point) const { return this->Place[point] >= 0; }
  /// From now on a free point is where it is now.
  void Hold(Index point, const Point3& position);

  /// Moves the free points to where the surface bends least, and farther as a load pushes them.
  /// False if that cannot be solved.
  bool Solve(const RoundnessLoad& load, std::vector<Point3>& points);
  /// Moves them along one axis alone, with a pull that joins the bending.
  bool SolveWith(const SlabPull& pull, int axis, std::vector<Point3>& points);

private:
  Columns FollowLoad(const RoundnessLoad& load) const;

  std::vector<Index> Place; ///< of each point: its row; -1 if it is held
  Matrix Normal;
  Columns Right;
  Eigen::SimplicialLDLT<Matrix> Solver;
};

BendingEquations::BendingEquations(const BendingOperator& bending,
  const std::vector<std::uint8_t>& crease, std::vector<Index>&& place, Index freePoints,
  const std::vector<Point3>& points)
  : Place(std::move(place))
{
  // Columns of free points, and what the others add to each row.
  const Index count = static_cast<Index>(points.size());
  Matrix free(count, freePoints);
  Columns given = Columns::Zero(count, 3);
  std::vector<Eigen::Triplet<double>> entries;
  double total = 0.0;
  for (const double area : bending.Area)
  {
    total += area;
  }
  const double leastArea = 1e-3 * total / std::max<Index>(count, 1);
  for (Index column = 0; column < count; ++column)
  {
    for (Matrix::InnerIterator entry(bending.Laplacian, column); entry; ++entry)
    {
      const Index row = static_cast<Index>(entry.row());
      if (crease[row])
      {
        continue; // an edge of the surface bends as it likes
      }
      const double value = entry.value() / std::sqrt(std::max(bending.Area[row], leastArea));
      if (this->IsFree(column))
      {
        entries.emplace_back(row, this->Place[column], value);
      }
      else
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          given(row, axis) += value * points[column][axis];
        }
      }
    }
  }
  free.setFromTriplets(entries.begin(), entries.end());
  Matrix transposed = free.transpose();
  this->Normal = transposed * free;
  this->Right = -(transposed * given);
  this->Solver.analyzePattern(this->Normal);
}

void BendingEquations::Hold(Index point, const Point3& position)
{
  const Index held = this->Place[point];
  const Eigen::RowVector3d known(position[0], position[1], position[2]);
  for (Matrix::InnerIterator entry(this->Normal, held); entry; ++entry)
  {
    const Index row = static_cast<Index>(entry.row());
    if (row != held)
    {
      this->Right.row(row) -= entry.value() * known;
      this->Normal.coeffRef(held, row) = 0.0;
      entry.valueRef() = 0.0;
    }
  }
  this->Right.row(held) = this->Normal.coeff(held, held) * known;
  this->Place[point] = -1;
}

/// How far the load moves the free points, at most as far as it says.
Columns BendingEquations::FollowLoad(const RoundnessLoad& load) const
{
  Columns right = Columns::Zero(this->Right.rows(), 3);
  for (std::size_t point = 0; point < load.Force.size(); ++point)
  {
    if (this->Place[point] >= 0)
    {
      const Point3& force = load.Force[point];
      right.row(this->Place[point]) << force[0], force[1], force[2];
    }
  }
  Columns moved = this->Solver.solve(right);
  for (std::size_t point = 0; point < load.Force.size(); ++point)
  {
    if (this->Place[point] >= 0)
    {
      auto way = moved.row(this->Place[point]);
      const double length = way.norm();
      way *= length > load.Reach[point] ? load.Reach[point] / length : 1.0;
    }
  }
  return moved;
}

bool BendingEquations::Solve(const RoundnessLoad& load, std::vector<Point3>& points)
{
  this->Solver.factorize(this->Normal);
  if (this->Solver.info() != Eigen::Success)
  {
    return false;
  }
  Columns moved = this->Solver.solve(this->Right);
  if (!load.IsEmpty())
  {
    moved += this->FollowLoad(load);
  }
  if (!moved.allFinite())
  {
    return false;
  }
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    if (this->Place[point] >= 0)
    {
      const Index row = this->Place[point];
      points[point] = { moved(row, 0), moved(row, 1), moved(row, 2) };
    }
  }
  return true;
}

bool BendingEquations::SolveWith(const SlabPull& pull, int axis, std::vector<Point3>& points)
{
  Eigen::VectorXd right = this->Right.col(axis);
  Matrix normal = this->Normal;
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    const Index row = this->Place[point];
    if (row >= 0 && pull.Strength[point] > 0.0)
    {
      normal.coeffRef(row, row) += pull.Strength[point];
      right[row] += pull.Strength[point] * pull.Aim[point];
    }
  }
  this->Solver.factorize(normal);
  if (this->Solver.info() != Eigen::Success)
  {
    return false;
  }
  const Eigen::VectorXd moved = this->Solver.solve(right);
  if (!moved.allFinite())
  {
    return false;
  }
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    if (this->Place[point] >= 0)
    {
      points[point][axis] = moved[this->Place[point]];
    }
  }
  return true;
}

/// The mean over the surface of the square of the bending in widths of the slabs; see SlabPull.
/// What is sharper than a ball as wide as its slab counts as such.
double MeasureRoughness(
  const BendingOperator& bending, const SurfaceMesh& mesh, const std::vector<Point3>& points)
{
  constexpr double sharpest = 4.0;
  Columns places(points.size(), 3);
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    places.row(point) << points[point][0], points[point][1], points[point][2];
  }
  const Columns laplacian = bending.Laplacian * places;
  double sum = 0.0, total = 0.0;
  for (Index point = 0; point < mesh.Corners.PointCount(); ++point)
  {
    const double area = bending.Area[point];
    if (mesh.Corners.IsUsed(point) && area > 0.0)
    {
      const Box3& cell = mesh.Cells[mesh.CellOf(point)];
      const double width = cell.High[mesh.StretchAxis] - cell.Low[mesh.StretchAxis];
      const double bend = width / area * laplacian.row(point).norm();
      sum += area * std::min(sharpest, bend * bend);
      total += area;
    }
  }
  return total > 0.0 ? sum / total : 0.0;
}

/**
 * Points of patches between creases alone: nothing says in which direction the surface leaves its
 * contours there, and it would contract as a film of soap does. They stay where they are: sides are
 * straight from one crease to the other, and ends flat.
 */
std::vector<std::uint8_t> FindHeldPoints(const SurfaceMesh& mesh)
{
  const CornerTable& corners = mesh.Corners;
  std::vector<std::uint8_t> hasCrease(mesh.Cells.size(), 0), bends(mesh.Cells.size(), 0);
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (corners.IsAlive(corner) && mesh.Fixed[corners.VertexOf(corner)])
    {
      const bool isCrease = mesh.Crease[corners.VertexOf(corner)] != 0;
      (isCrease ? hasCrease : bends)[mesh.Cell[corner / 3]] = 1;
    }
  }
  std::vector<std::uint8_t> held(mesh.Points.size(), 0);
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (corners.IsAlive(corner))
    {
      const Index cell = mesh.Cell[corner / 3];
      held[corners.VertexOf(corner)] |= hasCrease[cell] & ~bends[cell] & 1;
    }
  }
  return held;
}

/**
 * Points of components all of whose contours lie in one slice: bent least, they would lie in it,
 * too, and enclose nothing. They keep the domes that they have.
 */
void HoldFlatComponents(const SurfaceMesh& mesh, std::vector<std::uint8_t>& held)
{
  const CornerTable& corners = mesh.Corners;
  DisjointSets components(corners.PointCount());
  for (Index corner = 0; corner < corners.CornerCount(); ++corner)
  {
    if (corners.IsAlive(corner))
    {
      components.Unite(corners.StartOf(corner), corners.EndOf(corner));
    }
  }
  std::vector<Box3> boxes(mesh.Points.size()); // around the contours of each component
  for (Index point = 0; point < corners.PointCount(); ++point)
  {
    if (corners.IsUsed(point) && mesh.Fixed[point])
    {
      boxes[components.Find(point)].Add(mesh.Points[point]);
    }
  }
  for (Index point = 0; point < corners.PointCount(); ++point)
  {
    const Box3& box = boxes[components.Find(point)];
    for (int axis = 0; axis < 3; ++axis)
    {
      held[point] |= box.Low[axis] == box.High[axis] ? 1 : 0;
    }
  }
}

/// Numbers the points that are free to move.
Index NumberFreePoints(
  const SurfaceMesh& mesh, const std::vector<std::uint8_t>& held, std::vector<Index>& place)
{
  Index count = 0;
  place.assign(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    if (!mesh.Fixed[i] && !held[i] && mesh.Corners.IsUsed(static_cast<Index>(i)))
    {
      place[i] = count++;
    }
  }
  return count;
}

/// Moves free points that have left their cells onto the boundary, and holds them there. False if
/// none were so far off that the others are to be placed anew.
bool HoldAtCells(BendingEquations& equations, SurfaceMesh& mesh)
{
  constexpr double little = 0.01; // of the cell
  bool isFar = false;
  for (Index point = 0; point < mesh.Corners.PointCount(); ++point)
  {
    if (!equations.IsFree(point))
    {
      continue;
    }
    const Box3& cell = mesh.Cells[mesh.CellOf(point)];
    const Point3 before = mesh.Points[point];
    Point3& position = mesh.Points[point];
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = std::clamp(position[axis], cell.Low[axis], cell.High[axis]);
      const double way = std::abs(position[axis] - before[axis]);
      isFar |= way > little * (cell.High[axis] - cell.Low[axis]);
    }
    if (position != before)
    {
      equations.Hold(point, position);
    }
  }
  return isFar;
}
}

void FairSurface(EdgeWeights weights, SurfaceMesh& mesh)
{
  const BendingOperator bending = MakeBendingOperator(weights, mesh);
  std::vector<std::uint8_t> held = FindHeldPoints(mesh);
  HoldFlatComponents(mesh, held);
  std::vector<Index> place;
  const Index freePoints = NumberFreePoints(mesh, held, place);
  if (freePoints == 0)
  {
    return;
  }
  const bool isPulled = weights != EdgeWeights::Uniform && mesh.StretchAxis >= 0;
  const RoundnessLoad load =
    weights == EdgeWeights::RoundCotangents ? KeepRound(bending, mesh) : RoundnessLoad();
  BendingEquations equations(bending, mesh.Crease, std::move(place), freePoints, mesh.Points);
  SlabPull pull;
  // Points that reach the end of their cell stay there; then the others are placed anew.
  // What one stack's surface is with uniform weights is only where the next one begins, which comes
  // out as good without that. With several families blades do not.
  const int rounds = weights == EdgeWeights::Uniform && mesh.StretchAxis >= 0 ? 1 : 3;
  bool isFar = true;
  for (int round = 0; round < rounds && isFar; ++round)
  {
    std::vector<Point3> points = mesh.Points;
    // A pull acts along the axis alone, and so do, but for the bounds of all, the ends of cells.
    if ((round == 0 || !isPulled) && !equations.Solve(load, points))
    {
      return;
    }
    if (isPulled && round == 0)
    {
      pull = PullIntoSlabs(mesh, MeasureRoughness(bending, mesh, points));
    }
    if (isPulled && !equations.SolveWith(pull, mesh.StretchAxis, points))
    {
      return;
    }
    mesh.Points.swap(points);
    isFar = HoldAtCells(equations, mesh);
  }
}
}
