// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/JoinEvidence.h"

#include "Core/Base/TriangleDistance.h"
#include "Core/Base/Vectors.h"
#include "Core/Cells/CycleShape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthoslices
{
namespace
{
/// Points of a loop at which its distance to a patch is measured: the mean of so many differs
/// little from that of all.
constexpr Index MaxSamples = 16;

/// A join, and how far each of its two cycles, if it is a loop, is from the patch of the other.
struct Candidate
{
  CycleJoin Join;
  std::array<double, 2> Distance;
};

/**
 * How steep the line between two cycles is on the surface, as far as their headings tell: the mean
 * cosine, without its sign, between the line and the normals all along both borders; or how much
 * more the surface has to turn to get from one to the other than to get across each, which is 1
 * for two sheets above each other. 0 without headings.
 */
double SteepnessOfBorders(const CycleShape& a, const CycleShape& b, const Point3& direction)
{
  if (a.Headings.empty() || b.Headings.empty())
  {
    return 0.0;
  }
  double steepness = 0.0;
  for (const CycleShape* shape : { &a, &b })
  {
    for (const Heading& heading : shape->Headings)
    {
      steepness += 0.5 * heading.Weight * std::abs(Dot(heading.Normal, direction));
    }
  }
  return std::max(steepness, TurnBetween(a.Headings, b.Headings) - 0.5 * (a.Turn + b.Turn));
}

/// Measures the pairs of cycles of one cell after another.
class PairMeter
{
public:
  explicit PairMeter(const EvidenceTables& tables)
    : Geometry(tables.Geometry)
    , Describer(tables.Geometry, tables.NodeNormals, tables.CentralPoints)
  {
  }

  /// Describes the cycles [first, last) of a cell.
  void Start(const Index* first, const Index* last);
  const std::vector<CycleShape>& AllShapes() const { return this->Shapes; }
  /// False if the two cannot belong together.
  bool Measure(const CycleShape& a, const CycleShape& b, PairFeatures& features) const;
  double DistanceTo(const CycleShape& loop, const CycleShape& patch) const;
  bool AreOnOneFace(Index a, Index b) const;
  /// Whether a loop bounds a hole.
  bool IsHole(const CycleShape& loop) const;

private:
  void FindStep(const std::array<Index, 3>& cell);

  const CycleGeometry& Geometry;
  CycleDescriber Describer;
  std::vector<CycleShape> Shapes;
  double Step = 1.0; ///< of the spatial grid at this cell: the geometric mean
};

/// The mean of the cell's widths, or of mean widths where it is unbounded, without axes that have
/// no planes.
void PairMeter::FindStep(const std::array<Index, 3>& cell)
{
  const SpatialGrid& grid = this->Geometry.Grid;
  double product = 1.0;
  int known = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double width =
      grid.Count(axis) == 0 ? 0.0 : grid.Width(axis, cell[axis]) * Length(grid.Metric.Edge(axis));
    product *= width > 0.0 ? width : 1.0;
    known += width > 0.0 ? 1 : 0;
  }
  this->Step = known > 0 ? std::pow(product, 1.0 / known) : 1.0;
}

void PairMeter::Start(const Index* first, const Index* last)
{
  this->FindStep(this->Geometry.Cycles.Cell[*first]);
  this->Shapes.clear();
  for (const Index* cycle = first; cycle != last; ++cycle)
  {
    this->Shapes.push_back(this->Describer.Describe(*cycle));
  }
}

/// Mean distance of a loop to the fan of another cycle, in steps.
double PairMeter::DistanceTo(const CycleShape& loop, const CycleShape& patch) const
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
bool PairMeter::AreOnOneFace(Index a, Index b) const
{
  const Face& first = this->Geometry.Graph.Loops[this->Geometry.LoopOf(a)];
  const Face& second = this->Geometry.Graph.Loops[this->Geometry.LoopOf(b)];
  return first.Axis == second.Axis && first.Plane == second.Plane;
}

/// The cycle above a slice runs as its contour does, the one below the other way around.
bool PairMeter::IsHole(const CycleShape& loop) const
{
  const int axis = this->Geometry.Graph.Loops[this->Geometry.LoopOf(loop.Cycle)].Axis;
  return (Dot(loop.Area, this->Geometry.Grid.Metric.Normal(axis)) > 0.0) !=
    this->Geometry.FirstArc(loop.Cycle).Above;
}

bool PairMeter::Measure(const CycleShape& a, const CycleShape& b, PairFeatures& features) const
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
  features = {};
  for (const CycleShape* shape : { &a, &b })
  {
    for (std::size_t i = 0; i < shape->Normals.size(); ++i)
    {
      features.Steepness += 0.5 * shape->Weights[i] * std::abs(Dot(shape->Normals[i], direction));
    }
  }
  features.Steepness = std::max(features.Steepness, SteepnessOfBorders(a, b, direction));
  features.Flatness = 0.5 * (a.Flatness + b.Flatness);
  features.Facing = (facing ? 1.0 : -1.0) * std::min(std::abs(facingA), std::abs(facingB));
  features.Distance = Length(line);
  features.Disagreement = std::max(a.Disagreement, b.Disagreement);
  features.Step = this->Step;
  const double radii = a.Radius + b.Radius;
  if (radii > 0.0)
  {
    features.Closeness = std::max(0.0, MinDistance - Length(line) / radii);
    if (!a.Loop && !b.Loop)
    {
      const auto range = std::minmax(a.Radius, b.Radius);
      features.Inequality = std::max(0.0, MinRadius - range.first / range.second);
    }
  }
  features.OnOneFace = a.Loop && b.Loop && this->AreOnOneFace(a.Cycle, b.Cycle);
  features.Loops = (a.Loop ? 1 : 0) + (b.Loop ? 1 : 0);
  return true;
}

/// The joins of one cell.
class CellJoins
{
public:
  CellJoins(
    const EvidenceTables& tables, const KnownPairs& known, const std::vector<Index>& patchOf)
    : Meter(tables)
    , Known(known)
    , PatchOf(patchOf)
    , Parallel(CountFamilies(tables.Geometry.Grid) <= 1)
  {
  }

  std::vector<Candidate> Find(const Index* first, const Index* last);

private:
  bool IsKnown(Index a, Index b) const;
  bool HasLid(Index cycle) const;
  bool IsExcluded(const CycleShape& a, const CycleShape& b) const;
  bool Compare(const CycleShape& a, const CycleShape& b, Candidate& candidate) const;
  void AddCertain(Index patch, Index first, Index second, std::vector<Candidate>& found) const;

  PairMeter Meter;
  const KnownPairs& Known;
  const std::vector<Index>& PatchOf; ///< of each cycle among Known.Patches, or -1
  const bool Parallel;               ///< slices of one family only
};

/// False if the two cannot belong together.
bool CellJoins::Compare(const CycleShape& a, const CycleShape& b, Candidate& candidate) const
{
  PairFeatures features;
  if (!this->Meter.Measure(a, b, features))
  {
    return false;
  }
  candidate.Join.Flatness = std::max(0.0, a.Flatness) * std::max(0.0, b.Flatness);
  candidate.Join.First = a.Cycle;
  candidate.Join.Second = b.Cycle;
  candidate.Join.Evidence = EvidenceOf(features);
  const double none = std::numeric_limits<double>::infinity();
  const double penalty = features.OnOneFace ? OneFaceDistance : 0.0;
  candidate.Distance = { a.Loop ? this->Meter.DistanceTo(a, b) + penalty : none,
    b.Loop ? this->Meter.DistanceTo(b, a) + penalty : none };
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

/// What the criterion says of two loops. By evidence, that is which ones overlap, and the overlay
/// has seen to these: if it keeps them apart, then because there is something between them.
bool CellJoins::IsKnown(Index a, Index b) const
{
  if (!this->Known.Exclusive && this->PatchOf[a] >= 0 && this->PatchOf[b] >= 0)
  {
    return false;
  }
  return std::binary_search(this->Known.Pairs.begin(), this->Known.Pairs.end(), LoopPair{ a, b },
    [](const LoopPair& p, const LoopPair& q)
    { return p.First != q.First ? p.First < q.First : p.Second < q.Second; });
}

/// Whether nothing but a lid is over a loop.
bool CellJoins::HasLid(Index cycle) const
{
  const Index patch = this->PatchOf[cycle];
  return patch < 0 || this->Known.Patches[patch].Cycles.size() == 1;
}

/// Whether the criterion says no: it speaks of loops only. With parallel slices alone, a tube from
/// a hole to an outer contour would be a tunnel out of a cavity, which nothing speaks for; neither
/// does anything for one between two cavities, unless one ends where the other begins.
bool CellJoins::IsExcluded(const CycleShape& a, const CycleShape& b) const
{
  if (this->Parallel && a.Loop && b.Loop)
  {
    const bool holes = this->Meter.IsHole(a);
    if (holes != this->Meter.IsHole(b) ||
      (holes &&
        (this->Meter.AreOnOneFace(a.Cycle, b.Cycle) || !this->HasLid(a.Cycle) ||
          !this->HasLid(b.Cycle))))
    {
      return true;
    }
  }
  return this->Known.Exclusive && a.Loop && b.Loop;
}

/// Two cycles of a stitched patch. All of its cycles form one chain of joins.
void CellJoins::AddCertain(
  Index patch, Index first, Index second, std::vector<Candidate>& found) const
{
  const std::vector<Index>& chain = this->Known.Patches[patch].Cycles;
  const auto at = std::lower_bound(chain.begin(), chain.end(), first);
  if (*(at + 1) != second)
  {
    return;
  }
  found.push_back(Certain(first, second));
  if (at == chain.begin())
  {
    const Index discs = 2 - static_cast<Index>(chain.size());
    found.back().Join.Handles = (discs - EulerCharacteristic(this->Known.Patches[patch])) / 2;
  }
}

std::vector<Candidate> CellJoins::Find(const Index* first, const Index* last)
{
  this->Meter.Start(first, last);
  const std::vector<CycleShape>& shapes = this->Meter.AllShapes();
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
    {
      const Index patch = this->PatchOf[shapes[i].Cycle];
      if (patch >= 0 && patch == this->PatchOf[shapes[j].Cycle])
      {
        this->AddCertain(patch, shapes[i].Cycle, shapes[j].Cycle, found);
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
  const bool parallel = CountFamilies(geometry.Grid) <= 1;
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
      join.Evidence = std::max(join.Evidence, ContinuationEvidence - b.Distance);
    }
  }
}
}

double EvidenceOf(const PairFeatures& features, const EvidenceWeights& weights)
{
  double evidence = weights.Constant + weights.Flatness * features.Flatness +
    weights.Steepness * features.Steepness + weights.Facing * features.Facing +
    (weights.Distance * features.Distance + weights.Disagreement * features.Disagreement) /
      features.Step;
  evidence += weights.Closeness * features.Closeness;
  evidence += weights.Inequality * features.Inequality;
  return evidence + (features.OnOneFace ? weights.OnOneFace : 0.0);
}

std::vector<MeasuredPair> MeasurePairs(const EvidenceTables& tables)
{
  std::vector<MeasuredPair> pairs;
  PairMeter meter(tables);
  for (const auto& range : tables.Cells.Several)
  {
    const Index* cycles = tables.Cells.Cycles.data();
    meter.Start(cycles + range.first, cycles + range.second);
    const std::vector<CycleShape>& shapes = meter.AllShapes();
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      for (std::size_t j = i + 1; j < shapes.size(); ++j)
      {
        MeasuredPair pair{ shapes[i].Cycle, shapes[j].Cycle, {} };
        if (meter.Measure(shapes[i], shapes[j], pair.Features))
        {
          pairs.push_back(pair);
        }
      }
    }
  }
  return pairs;
}

std::vector<CycleJoin> FindJoins(
  const EvidenceTables& tables, const KnownPairs& known, const Execution& execution)
{
  const CycleGeometry& geometry = tables.Geometry;
  const CellGroups& cells = tables.Cells;
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
      CellJoins cell(tables, known, patchOf);
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
