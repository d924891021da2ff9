// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/JoinEvidence.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"

#include <algorithm>
#include <limits>

namespace orthoslices
{
namespace
{
/// The weights of the evidence; see CycleJoin.
constexpr double Constant = 2.8;
constexpr double OfFlatness = -3.0;
constexpr double OfSteepness = -4.0;
constexpr double OfFacing = 2.0;
constexpr double OfDistance = -2.0;
constexpr double OfDisagreement = -8.0;
/// Cycles that are much wider than their distance are parallel sheets: evidence for each part of
/// the sum of their radii that is missing to this one.
constexpr double OfCloseness = -4.0;
constexpr double MinDistance = 0.45;
/// A cycle around a tip that a slice just touches is no end of a wide one: evidence for each part of
/// the wider radius that the other one lacks to this share.
constexpr double OfUnequalRadii = -8.0;
constexpr double MinRadius = 0.25;
/// Of loops of which a criterion for parallel slices says that they belong together.
constexpr double CertainEvidence = 3.0;
/// Loops on one face are rather neighbours than ends of one tube: evidence, and by how many steps
/// they count as farther apart.
constexpr double ForOneFace = -2.0;
constexpr double OnOneFace = 2.0;
/// Evidence for the best way of an isolated contour to go on, if there is no distance to bridge.
constexpr double ForContinuation = 1.5;
/// Points of a loop at which its distance to a patch is measured.
constexpr Index MaxSamples = 16;

/// What the evidence needs of one cycle.
struct CycleShape
{
  Index Cycle;
  bool Loop;
  std::vector<Point3> Border;
  Point3 Center;               ///< of the border
  double Radius;               ///< root mean square distance of the border from it
  Point3 Apex;                 ///< of the fan to which distances are measured
  Point3 Area;                 ///< unit normal of the disc, outwards
  double Flatness;             ///< see CycleJoin
  double Disagreement;         ///< the greatest at its node points
  std::vector<Point3> Normals; ///< unit, of the surface at the border
  std::vector<double> Weights; ///< their sum is 1, or 0 without normals
};

/// A join, and how far each of its two cycles, if it is a loop, is from the patch of the other.
struct Candidate
{
  CycleJoin Join;
  std::array<double, 2> Distance;
};

/// The joins of one cell.
class CellJoins
{
public:
  CellJoins(const CycleGeometry& geometry, const std::vector<double>& nodeNormals,
    const std::vector<double>& centralPoints, const KnownPairs& known,
    const std::vector<Index>& patchOf)
    : Geometry(geometry)
    , NodeNormals(nodeNormals)
    , CentralPoints(centralPoints)
    , Known(known)
    , PatchOf(patchOf)
  {
  }

  std::vector<Candidate> Find(const Index* first, const Index* last);

private:
  void FindSteps(const std::array<Index, 3>& cell);
  CycleShape Describe(Index cycle);
  void AddNormals(CycleShape& shape) const;
  double DistanceTo(const CycleShape& loop, const CycleShape& patch) const;
  bool IsKnown(Index a, Index b) const;
  bool IsExcluded(const CycleShape& a, const CycleShape& b) const;
  bool AreOnOneFace(Index a, Index b) const;
  bool Compare(const CycleShape& a, const CycleShape& b, Candidate& candidate) const;

  const CycleGeometry& Geometry;
  const std::vector<double>& NodeNormals;
  const std::vector<double>& CentralPoints;
  const KnownPairs& Known;
  const std::vector<Index>& PatchOf; ///< of each cycle among Known.Patches
  Point3 Steps;                      ///< of the spatial grid at this cell
  double Step = 1.0;                 ///< their geometric mean
  std::vector<Index> Points, NodePlaces;
};

/// The widths of the cell; mean widths where it is unbounded, the mean of the others where there
/// are no planes.
void CellJoins::FindSteps(const std::array<Index, 3>& cell)
{
  const SpatialGrid& grid = this->Geometry.Grid;
  double product = 1.0;
  int known = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Steps[axis] = grid.Count(axis) == 0 ? 0.0 : grid.Width(axis, cell[axis]);
    product *= this->Steps[axis] > 0.0 ? this->Steps[axis] : 1.0;
    known += this->Steps[axis] > 0.0 ? 1 : 0;
  }
  this->Step = known > 0 ? std::pow(product, 1.0 / known) : 1.0;
  for (double& step : this->Steps)
  {
    step = step > 0.0 ? step : this->Step;
  }
}

/// Surface normals at the node points; for a loop, normals of the contour in its plane.
void CellJoins::AddNormals(CycleShape& shape) const
{
  double total = 0.0;
  const auto add = [&](const Point3& normal, double weight)
  {
    shape.Normals.push_back(Unit(normal));
    shape.Weights.push_back(weight);
    total += weight;
  };
  if (shape.Loop)
  {
    Point3 up{ 0.0, 0.0, 0.0 };
    up[this->Geometry.Graph.Loops[this->Geometry.LoopOf(shape.Cycle)].Axis] =
      this->Geometry.FirstArc(shape.Cycle).Above ? 1.0 : -1.0;
    for (std::size_t i = 0; i < shape.Border.size(); ++i)
    {
      const Point3 along = shape.Border[(i + 1) % shape.Border.size()] - shape.Border[i];
      add(Cross(along, up), Length(along));
    }
  }
  shape.Disagreement = 0.0;
  for (const Index place : this->NodePlaces)
  {
    shape.Disagreement =
      std::max(shape.Disagreement, this->Geometry.Nodes.Disagreement(this->Points[place]));
    const double* n = this->NodeNormals.data() + 3 * static_cast<std::size_t>(this->Points[place]);
    const Point3 normal{ n[0], n[1], n[2] };
    if (Dot(normal, normal) > 0.0)
    {
      add(normal, 1.0);
    }
  }
  for (double& weight : shape.Weights)
  {
    weight /= total > 0.0 ? total : 1.0;
  }
}

CycleShape CellJoins::Describe(Index cycle)
{
  CycleShape shape;
  shape.Cycle = cycle;
  shape.Loop = this->Geometry.IsLoop(cycle);
  this->Geometry.GetBoundary(cycle, this->Points, this->NodePlaces);
  for (const Index point : this->Points)
  {
    shape.Border.push_back(this->Geometry.Graph.PointAt(point));
  }
  const Point3& origin = shape.Border.front();
  CurveCenter center(origin);
  Point3 area{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < shape.Border.size(); ++i)
  {
    const Point3& p = shape.Border[i];
    const Point3& q = shape.Border[(i + 1) % shape.Border.size()];
    center.Add(p, q);
    area = area + Cross(p - origin, q - origin);
  }
  const double length = center.TotalLength();
  shape.Center = center.Get();
  shape.Area = Unit(area);
  double square = 0.0;
  for (std::size_t i = 0; i < shape.Border.size(); ++i)
  {
    const std::size_t before = i > 0 ? i - 1 : shape.Border.size() - 1;
    const Point3 arm = shape.Border[i] - shape.Center;
    square += 0.5 * Dot(arm, arm) *
      (Length(shape.Border[i] - shape.Border[before]) +
        Length(shape.Border[(i + 1) % shape.Border.size()] - shape.Border[i]));
  }
  shape.Radius = length > 0.0 ? std::sqrt(square / length) : 0.0;
  const double* apex = this->CentralPoints.data() + 3 * static_cast<std::size_t>(cycle);
  shape.Apex = shape.Loop ? shape.Center : Point3{ apex[0], apex[1], apex[2] };
  this->AddNormals(shape);
  // Contours that touch each other's planes without crossing them give no normals: then nothing
  // speaks for a tube.
  shape.Flatness = shape.Normals.empty() ? 1.0 : 0.0;
  for (std::size_t i = 0; i < shape.Normals.size() && !shape.Loop; ++i)
  {
    shape.Flatness += shape.Weights[i] * Dot(shape.Normals[i], shape.Area);
  }
  return shape;
}

/// Mean distance of a loop to the fan of another cycle, in steps.
double CellJoins::DistanceTo(const CycleShape& loop, const CycleShape& patch) const
{
  const Index count = static_cast<Index>(loop.Border.size());
  const Index samples = std::min(count, MaxSamples);
  double sum = 0.0;
  for (Index s = 0; s < samples; ++s)
  {
    const Point3& p =
      loop.Border[static_cast<std::size_t>(static_cast<std::int64_t>(s) * count / samples)];
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < patch.Border.size(); ++i)
    {
      minimum = std::min(minimum,
        SquaredDistanceToTriangle(
          p, patch.Apex, patch.Border[i], patch.Border[(i + 1) % patch.Border.size()]));
    }
    sum += std::sqrt(minimum);
  }
  return sum / (samples * this->Step);
}

/// Whether two loops of the cell lie on the same face of it.
bool CellJoins::AreOnOneFace(Index a, Index b) const
{
  const Face& first = this->Geometry.Graph.Loops[this->Geometry.LoopOf(a)];
  const Face& second = this->Geometry.Graph.Loops[this->Geometry.LoopOf(b)];
  return first.Axis == second.Axis && first.Plane == second.Plane;
}

/// False if the two cannot belong together.
bool CellJoins::Compare(const CycleShape& a, const CycleShape& b, Candidate& candidate) const
{
  const Point3 line = b.Center - a.Center;
  const Point3 direction = Unit(line);
  const double facingA = Dot(a.Area, direction);
  const double facingB = Dot(b.Area, direction);
  const bool facing = facingA * facingB < 0.0;
  if (!facing && !a.Loop && !b.Loop)
  {
    return false;
  }
  double steepness = 0.0;
  for (const CycleShape* shape : { &a, &b })
  {
    for (std::size_t i = 0; i < shape->Normals.size(); ++i)
    {
      steepness += 0.5 * shape->Weights[i] * std::abs(Dot(shape->Normals[i], direction));
    }
  }
  candidate.Join.Flatness = std::max(0.0, a.Flatness) * std::max(0.0, b.Flatness);
  candidate.Join.First = a.Cycle;
  candidate.Join.Second = b.Cycle;
  candidate.Join.Evidence = Constant + OfFlatness * 0.5 * (a.Flatness + b.Flatness) +
    OfSteepness * steepness +
    OfFacing * (facing ? 1.0 : -1.0) * std::min(std::abs(facingA), std::abs(facingB)) +
    (OfDistance * Length(line) + OfDisagreement * std::max(a.Disagreement, b.Disagreement)) /
      this->Step;
  const double radii = a.Radius + b.Radius;
  if (radii > 0.0)
  {
    candidate.Join.Evidence += OfCloseness * std::max(0.0, MinDistance - Length(line) / radii);
    if (!a.Loop && !b.Loop)
    {
      const auto range = std::minmax(a.Radius, b.Radius);
      candidate.Join.Evidence +=
        OfUnequalRadii * std::max(0.0, MinRadius - range.first / range.second);
    }
  }
  double penalty = 0.0;
  if (a.Loop && b.Loop && this->AreOnOneFace(a.Cycle, b.Cycle))
  {
    penalty = OnOneFace;
    candidate.Join.Evidence += ForOneFace;
  }
  const double none = std::numeric_limits<double>::infinity();
  candidate.Distance = { a.Loop ? this->DistanceTo(a, b) + penalty : none,
    b.Loop ? this->DistanceTo(b, a) + penalty : none };
  return true;
}

Candidate Certain(Index first, Index second)
{
  Candidate candidate;
  candidate.Join.First = first;
  candidate.Join.Second = second;
  candidate.Join.Evidence = CertainEvidence;
  candidate.Distance.fill(std::numeric_limits<double>::infinity());
  return candidate;
}

bool CellJoins::IsKnown(Index a, Index b) const
{
  return std::binary_search(this->Known.Pairs.begin(), this->Known.Pairs.end(), LoopPair{ a, b },
    [](const LoopPair& p, const LoopPair& q)
    { return p.First != q.First ? p.First < q.First : p.Second < q.Second; });
}

/// Whether the criterion says no: it speaks of loops only.
bool CellJoins::IsExcluded(const CycleShape& a, const CycleShape& b) const
{
  return this->Known.Exclusive && a.Loop && b.Loop;
}

std::vector<Candidate> CellJoins::Find(const Index* first, const Index* last)
{
  this->FindSteps(this->Geometry.Cycles.Cell[*first]);
  std::vector<CycleShape> shapes;
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    shapes.push_back(this->Describe(*cycle));
  }
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
    {
      const Index patch = this->PatchOf[shapes[i].Cycle];
      if (patch >= 0 && patch == this->PatchOf[shapes[j].Cycle])
      {
        // One chain through the cycles of the patch.
        const std::vector<Index>& chain = this->Known.Patches[patch].Cycles;
        const auto at = std::lower_bound(chain.begin(), chain.end(), shapes[i].Cycle);
        if (*(at + 1) == shapes[j].Cycle)
        {
          found.push_back(Certain(shapes[i].Cycle, shapes[j].Cycle));
          if (at == chain.begin())
          {
            const Index discs = 2 - static_cast<Index>(chain.size());
            found.back().Join.Handles =
              (discs - EulerCharacteristic(this->Known.Patches[patch])) / 2;
          }
        }
        continue;
      }
      Candidate candidate;
      const bool pair = this->IsKnown(shapes[i].Cycle, shapes[j].Cycle);
      if ((pair || !this->IsExcluded(shapes[i], shapes[j])) &&
        this->Compare(shapes[i], shapes[j], candidate))
      {
        if (pair)
        {
          candidate.Join.Evidence = std::max(candidate.Join.Evidence, CertainEvidence);
        }
        candidate.Join.OnlyConnects = patch >= 0 || this->PatchOf[shapes[j].Cycle] >= 0;
        found.push_back(candidate);
      }
    }
  }
  return found;
}

/// Finds the best way for each isolated contour to go on, in one of its two cells. Parallel slices
/// alone have isolated contours only, most of which go on in both.
void RateContinuations(const CycleGeometry& geometry, std::vector<Candidate>& candidates)
{
  const SpatialGrid& grid = geometry.Grid;
  const bool parallel = grid.Count(0) + grid.Count(1) + grid.Count(2) ==
    std::max({ grid.Count(0), grid.Count(1), grid.Count(2) });
  struct Best
  {
    double Distance = std::numeric_limits<double>::infinity();
    Candidate* At = nullptr;
  };
  std::vector<Best> best(geometry.Cycles.Count());
  for (Candidate& candidate : candidates)
  {
    const std::array<Index, 2> cycles{ candidate.Join.First, candidate.Join.Second };
    for (int side = 0; side < 2; ++side)
    {
      if (geometry.IsLoop(cycles[side]))
      {
        Best& b = best[parallel ? cycles[side] : geometry.LoopOf(cycles[side])];
        if (candidate.Distance[side] < b.Distance)
        {
          b = { candidate.Distance[side], &candidate };
        }
      }
    }
  }
  for (const Best& b : best)
  {
    if (b.At)
    {
      CycleJoin& join = b.At->Join;
      join.OnlyConnects |= parallel && join.Evidence <= 0.0;
      join.Evidence = std::max(join.Evidence, ForContinuation - b.Distance);
    }
  }
}
}

std::vector<CycleJoin> FindJoins(const CycleGeometry& geometry, const CellGroups& cells,
  const std::vector<double>& nodeNormals, const std::vector<double>& centralPoints,
  const KnownPairs& known, const Execution& execution)
{
  std::vector<Index> patchOf(geometry.Cycles.Count(), -1);
  for (std::size_t patch = 0; patch < known.Patches.size(); ++patch)
  {
    for (const Index cycle : known.Patches[patch].Cycles)
    {
      patchOf[cycle] = static_cast<Index>(patch);
    }
  }
  std::vector<std::vector<Candidate>> found(cells.Several.size());
  execution.For(found.size(),
    [&](std::size_t begin, std::size_t end)
    {
      CellJoins cell(geometry, nodeNormals, centralPoints, known, patchOf);
      for (std::size_t i = begin; i < end; ++i)
      {
        found[i] = cell.Find(cells.Cycles.data() + cells.Several[i].first,
          cells.Cycles.data() + cells.Several[i].second);
      }
    });
  std::vector<Candidate> candidates;
  for (const std::vector<Candidate>& part : found)
  {
    candidates.insert(candidates.end(), part.begin(), part.end());
  }
  RateContinuations(geometry, candidates);
  std::vector<CycleJoin> joins;
  for (const Candidate& candidate : candidates)
  {
    joins.push_back(candidate.Join);
  }
  return joins;
}
}
