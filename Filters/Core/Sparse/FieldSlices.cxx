// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/FieldSlices.h"

#include "Core/Slicing/PlaneContours.h"
#include "Core/Sparse/VirtualSlices.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace orthoslices
{
namespace
{
/// Steps of the lattice from one plane to the next.
constexpr double StepsBetweenPlanes = 5.0;
/// Share of an edge that vertices keep from its ends, so that they are distinct.
constexpr double Margin = 1e-3;
/// A zero is where the line through two values is zero, once the field at one of these places is
/// within that share of an edge of zero: it is then off by about a thousandth. Otherwise after so
/// many steps.
constexpr double Near = 0.03;
constexpr int MostSteps = 6;
/// Blocks of the lattice are divided down to that many points on each axis.
constexpr std::size_t SmallestBlock = 2;

struct Lattice
{
  std::array<std::vector<double>, 3> Coordinates;
  std::array<std::vector<std::uint8_t>, 3> IsPlane; ///< whether contours are wanted there
  Box3 Inside;                                      ///< nothing is inside beyond it
  AxisFrame Metric;
  std::vector<double> Values;

  std::size_t Count(int axis) const { return this->Coordinates[axis].size(); }
  std::size_t Number(const std::array<std::size_t, 3>& at) const
  {
    return (at[2] * this->Count(1) + at[1]) * this->Count(0) + at[0];
  }
  /// Of points that are in no layer of contours nobody asks.
  bool IsNeeded(const std::array<std::size_t, 3>& at) const
  {
    return this->IsPlane[0][at[0]] || this->IsPlane[1][at[1]] || this->IsPlane[2][at[2]];
  }
  Point3 Place(const std::array<std::size_t, 3>& at) const
  {
    return { this->Coordinates[0][at[0]], this->Coordinates[1][at[1]],
      this->Coordinates[2][at[2]] };
  }
};

/// Distances from the planes of the box are those in the world: see AxisFrame.
double ValueWithin(const SliceField& field, const Lattice& lattice, const Point3& p)
{
  const Box3& box = lattice.Inside;
  double value = field.Value(lattice.Metric.ToWorld(p));
  for (int axis = 0; axis < 3; ++axis)
  {
    value = std::min({ value, p[axis] - box.Low[axis], box.High[axis] - p[axis] });
  }
  return value;
}

/// Planes, ends of the box, and steps between these; one step more on both sides.
std::vector<double> MakeCoordinates(
  std::vector<double> planes, double low, double high, double step)
{
  planes.push_back(low);
  planes.push_back(high);
  std::sort(planes.begin(), planes.end());
  std::vector<double> result{ planes.front() - step };
  for (std::size_t i = 0; i + 1 < planes.size(); ++i)
  {
    const double width = planes[i + 1] - planes[i];
    const int parts = std::max(1, static_cast<int>(std::lround(width / step)));
    for (int k = 0; k < parts && width > 0.0; ++k)
    {
      result.push_back(planes[i] + width * k / parts);
    }
  }
  result.push_back(planes.back());
  result.push_back(planes.back() + step);
  return result;
}

/// Points of the lattice, from one number to the next, on each axis.
using Block = std::array<std::array<std::size_t, 2>, 3>;

/// Whether the field is so great, at the middle of a block, that it has the same sign all over it,
/// unless its slope is above two: that of a distance is one.
bool IsFar(const Lattice& lattice, const Block& block, double& value, const SliceField& field)
{
  const Point3 low = lattice.Place({ block[0][0], block[1][0], block[2][0] });
  const Point3 high = lattice.Place({ block[0][1] - 1, block[1][1] - 1, block[2][1] - 1 });
  const Point3 middle = 0.5 * (low + high);
  value = ValueWithin(field, lattice, middle);
  return std::abs(value) > Length(high - low);
}

/// For each part of a block, of so many points on each axis at most.
template <class Function>
void ForBlocks(const Block& block, std::size_t side, Function&& function)
{
  Block part;
  const auto next = [&](int axis, std::size_t from)
  {
    part[axis] = { from, std::min(from + side, block[axis][1]) };
    return from + side;
  };
  for (std::size_t k = block[2][0]; k < block[2][1];)
  {
    k = next(2, k);
    for (std::size_t j = block[1][0]; j < block[1][1];)
    {
      j = next(1, j);
      for (std::size_t i = block[0][0]; i < block[0][1];)
      {
        i = next(0, i);
        function(part);
      }
    }
  }
}

bool HasNeeded(const Lattice& lattice, const Block& block)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& isPlane = lattice.IsPlane[axis];
    for (std::size_t i = block[axis][0]; i < block[axis][1]; ++i)
    {
      if (isPlane[i] != 0)
      {
        return true;
      }
    }
  }
  return false;
}

void FillBlock(
  const std::function<double(const Point3&)>& valueAt, const Block& block, Lattice& lattice)
{
  std::array<std::size_t, 3> at;
  for (at[2] = block[2][0]; at[2] < block[2][1]; ++at[2])
  {
    for (at[1] = block[1][0]; at[1] < block[1][1]; ++at[1])
    {
      for (at[0] = block[0][0]; at[0] < block[0][1]; ++at[0])
      {
        if (lattice.IsNeeded(at))
        {
          lattice.Values[lattice.Number(at)] = valueAt(lattice.Place(at));
        }
      }
    }
  }
}

/// One value does for a block that is far from the surface; others are divided, down to blocks of
/// eight points.
void EvaluateBlock(const SliceField& field, const Block& block, std::size_t side, Lattice& lattice)
{
  if (!HasNeeded(lattice, block))
  {
    return;
  }
  double far = 0.0;
  if (IsFar(lattice, block, far, field))
  {
    FillBlock([far](const Point3&) { return far; }, block, lattice);
  }
  else if (side <= SmallestBlock)
  {
    FillBlock([&](const Point3& p) { return ValueWithin(field, lattice, p); }, block, lattice);
  }
  else
  {
    ForBlocks(
      block, side / 2, [&](const Block& part) { EvaluateBlock(field, part, side / 2, lattice); });
  }
}

void Evaluate(const SliceField& field, const Execution& execution, Lattice& lattice)
{
  constexpr std::size_t side = 4;
  lattice.Values.resize(lattice.Count(0) * lattice.Count(1) * lattice.Count(2));
  std::array<std::size_t, 3> blocks;
  for (int axis = 0; axis < 3; ++axis)
  {
    blocks[axis] = (lattice.Count(axis) + side - 1) / side;
  }
  execution.For(blocks[0] * blocks[1] * blocks[2],
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::array<std::size_t, 3> number{ i % blocks[0], i / blocks[0] % blocks[1],
          i / (blocks[0] * blocks[1]) };
        Block block;
        for (int axis = 0; axis < 3; ++axis)
        {
          block[axis] = { side * number[axis],
            std::min(side * (number[axis] + 1), lattice.Count(axis)) };
        }
        EvaluateBlock(field, block, side, lattice);
      }
    });
}

/// The contours in one layer of the lattice, by marching squares.
class LayerContours
{
public:
  LayerContours(const SliceField& field, const Lattice& lattice, int axis, double coordinate)
    : Field(field)
    , Table(lattice)
    , Axis(axis)
    , U(FirstAxis(axis))
    , V(SecondAxis(axis))
    , CountU(lattice.Count(U))
    , CountV(lattice.Count(V))
  {
    const auto& all = lattice.Coordinates[axis];
    this->Layer =
      static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), coordinate) - all.begin());
    this->Next.assign(2 * this->CountU * this->CountV, -1);
  }

  PlaneContours Run(const SpatialGrid& grid);

private:
  std::array<std::size_t, 3> At(std::size_t u, std::size_t v) const
  {
    std::array<std::size_t, 3> at;
    at[this->Axis] = this->Layer;
    at[this->U] = u;
    at[this->V] = v;
    return at;
  }
  double Value(std::size_t u, std::size_t v) const
  {
    return this->Table.Values[this->Table.Number(this->At(u, v))];
  }
  /// Edge from a point of the layer to the next one along U, or V.
  std::int64_t Edge(std::size_t u, std::size_t v, bool alongV) const
  {
    return static_cast<std::int64_t>(2 * (v * this->CountU + u) + (alongV ? 1 : 0));
  }
  void March(std::size_t u, std::size_t v);
  Point2 Cross(std::int64_t edge) const;

  const SliceField& Field;
  const Lattice& Table;
  const int Axis, U, V;
  const std::size_t CountU, CountV;
  std::size_t Layer;
  std::vector<std::int64_t> Next; ///< the edge where a contour goes on
};

void LayerContours::March(std::size_t u, std::size_t v)
{
  const std::array<bool, 4> inside{ this->Value(u, v) > 0.0, this->Value(u + 1, v) > 0.0,
    this->Value(u + 1, v + 1) > 0.0, this->Value(u, v + 1) > 0.0 };
  const std::array<std::int64_t, 4> edges{ this->Edge(u, v, false), this->Edge(u + 1, v, true),
    this->Edge(u, v + 1, false), this->Edge(u, v, true) };
  std::array<int, 2> leaving{ -1, -1 };
  std::array<int, 2> entering{ -1, -1 };
  int count = 0, entries = 0;
  for (int k = 0; k < 4; ++k)
  {
    if (inside[k] && !inside[(k + 1) % 4])
    {
      leaving[count++] = k;
    }
    else if (!inside[k] && inside[(k + 1) % 4])
    {
      entering[entries++] = k;
    }
  }
  if (count == 1)
  {
    this->Next[edges[leaving[0]]] = edges[entering[0]];
  }
  if (count == 2)
  {
    const Point3 middle =
      0.5 * (this->Table.Place(this->At(u, v)) + this->Table.Place(this->At(u + 1, v + 1)));
    const bool isJoined = ValueWithin(this->Field, this->Table, middle) > 0.0;
    for (const int k : leaving)
    {
      this->Next[edges[k]] = edges[isJoined ? (k + 1) % 4 : (k + 3) % 4];
    }
  }
}

/// Where the field is zero on an edge, from its lower end up: by regula falsi, after Illinois.
Point2 LayerContours::Cross(std::int64_t edge) const
{
  const std::size_t point = static_cast<std::size_t>(edge) / 2;
  const int along = edge % 2 != 0 ? this->V : this->U;
  const std::size_t u = point % this->CountU, v = point / this->CountU;
  const std::size_t u2 = u + (along == this->U ? 1 : 0), v2 = v + (along == this->V ? 1 : 0);
  const Point3 low = this->Table.Place(this->At(u, v)), high = this->Table.Place(this->At(u2, v2));
  double a = 0.0, b = 1.0, atA = this->Value(u, v), atB = this->Value(u2, v2);
  Point3 place = low;
  const auto cut = [&] { return (a * atB - b * atA) / (atB - atA); };
  int moved = 0; // the end that was moved last
  for (int i = 0; i < MostSteps; ++i)
  {
    place[along] = low[along] + cut() * (high[along] - low[along]);
    const double value = ValueWithin(this->Field, this->Table, place);
    const bool isLikeA = (value > 0.0) == (atA > 0.0);
    (isLikeA ? a : b) = (place[along] - low[along]) / (high[along] - low[along]);
    (isLikeA ? atA : atB) = value;
    if (std::abs(value) < Near * (high[along] - low[along]))
    {
      break;
    }
    // The end that stays twice counts half, so that it moves as well.
    (isLikeA ? atB : atA) *= moved == (isLikeA ? 1 : 2) ? 0.5 : 1.0;
    moved = isLikeA ? 1 : 2;
  }
  const double t = std::clamp(cut(), Margin, 1.0 - Margin);
  place[along] = low[along] + t * (high[along] - low[along]);
  return { place[this->U], place[this->V] };
}

PlaneContours LayerContours::Run(const SpatialGrid& grid)
{
  for (std::size_t v = 0; v + 1 < this->CountV; ++v)
  {
    for (std::size_t u = 0; u + 1 < this->CountU; ++u)
    {
      this->March(u, v);
    }
  }
  PlaneContours contours;
  for (std::size_t first = 0; first < this->Next.size(); ++first)
  {
    std::int64_t edge = static_cast<std::int64_t>(first);
    while (this->Next[edge] >= 0)
    {
      const Point2 p = this->Cross(edge);
      contours.AddVertex(grid.Round(p[0]), grid.Round(p[1]));
      const std::int64_t next = this->Next[edge];
      this->Next[edge] = -1;
      edge = next;
      if (this->Next[edge] < 0)
      {
        contours.CloseContour();
      }
    }
  }
  return contours;
}

Box3 RangeOf(const SpatialGrid& grid)
{
  Box3 box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double room = 0.02 * grid.SpacingAtEnds[axis];
    box.Add(axis, grid.Lowest[axis] + room);
    box.Add(axis, grid.Highest[axis] - room);
  }
  return box;
}
}

Contours CutField(const SliceField& field, const SpatialGrid& grid, const SliceDensity& density,
  const Execution& execution)
{
  return CutField(
    field, grid, density, ChooseVirtualPlanes(grid, RangeOf(grid), density), execution);
}

Contours CutField(const SliceField& field, const SpatialGrid& grid, const SliceDensity& density,
  const VirtualPlanes& planes, const Execution& execution)
{
  Lattice lattice;
  lattice.Inside = RangeOf(grid);
  lattice.Metric = grid.Metric;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> all = grid.Planes[axis];
    all.insert(all.end(), planes[axis].begin(), planes[axis].end());
    lattice.Coordinates[axis] = MakeCoordinates(std::move(all), lattice.Inside.Low[axis],
      lattice.Inside.High[axis], density.Spacing(axis) / StepsBetweenPlanes);
    for (const double coordinate : lattice.Coordinates[axis])
    {
      lattice.IsPlane[axis].push_back(
        std::binary_search(planes[axis].begin(), planes[axis].end(), coordinate) ? 1 : 0);
    }
  }
  Evaluate(field, execution, lattice);
  Contours contours;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<PlaneContours> slices(planes[axis].size());
    execution.For(slices.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          slices[i] = LayerContours(field, lattice, axis, planes[axis][i]).Run(grid);
        }
      });
    for (std::size_t i = 0; i < slices.size(); ++i)
    {
      AppendSlice(slices[i], axis, planes[axis][i], contours);
    }
  }
  return contours;
}
}
