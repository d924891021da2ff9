// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/JoinEvidence.h"

#include "Core/Base/Vectors.h"
#include "Core/Cells/BorderHeading.h"
#include "Core/Cells/CycleShape.h"
#include "Core/Reconstruct.h"
#include "Support/RandomInput.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
/// Calls `check` with the tables after each FindJoins.
void ObserveJoins(const PieceSets& sets, const Options& options,
  const std::function<void(const EvidenceTables&, const Reconstruction&)>& check)
{
  Reconstruct(PieceSets(sets), options, Execution(),
    [&](Stage stage, const StageTables& tables, const Reconstruction& result)
    {
      if (stage == Stage::FindJoins)
      {
        const CycleGeometry geometry = GeometryOf(result);
        check({ geometry, result.Cells, tables.NodeNormals, result.Surface.CentralPoints }, result);
      }
    });
}

/// The center of a cycle and the normal of its disc, each by its own definition.
struct Disc
{
  Disc(const CycleGeometry& geometry, Index cycle)
  {
    std::vector<Point3> border;
    for (const Index point : geometry.GetBorders({ cycle }))
    {
      border.push_back(geometry.Graph.PointAt(point));
    }
    double total = 0.0;
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const Point3& p = border[i];
      const Point3& q = border[(i + 1) % border.size()];
      const double length = Length(q - p);
      this->Center = this->Center + 0.5 * length * (p + q);
      this->Normal = this->Normal + Cross(p, q);
      total += length;
    }
    this->Center = (1.0 / total) * this->Center;
    this->Normal = Unit(this->Normal);
  }

  Point3 Center{}, Normal{};
};

/// Mean of a function of the unit normals at the node points of a cycle.
double MeanOverNodes(
  const EvidenceTables& tables, Index cycle, const std::function<double(const Point3&)>& function)
{
  std::vector<Index> points, places;
  tables.Geometry.GetBoundary(cycle, points, places);
  double sum = 0.0;
  int count = 0;
  for (const Index place : places)
  {
    const double* n = tables.NodeNormals.data() + 3 * static_cast<std::size_t>(points[place]);
    const Point3 normal{ n[0], n[1], n[2] };
    if (Length(normal) > 0.0)
    {
      sum += function(Unit(normal));
      ++count;
    }
  }
  return count > 0 ? sum / count : HUGE_VAL;
}

/// What the headings add with few planes to the means over the node points: the greater one counts.
struct BorderMeans
{
  BorderMeans(const EvidenceTables& tables, Index cycle)
    : Headings(FindHeadings(tables.Geometry, tables.NodeNormals, cycle))
  {
    const SpatialGrid& grid = tables.Geometry.Grid;
    this->Used = std::min({ grid.Count(0), grid.Count(1), grid.Count(2) }) < MinPlanes;
  }

  double Mean(const std::function<double(const Point3&)>& function) const
  {
    double sum = 0.0;
    for (const Heading& heading : this->Headings)
    {
      sum += heading.Weight * function(heading.Normal);
    }
    return sum;
  }
  double Flatness(double atNodes, const std::function<double(const Point3&)>& function) const
  {
    return this->Used
      ? std::max({ atNodes, this->Mean(function), 1.0 - 2.0 * TurnAcross(this->Headings) })
      : atNodes;
  }

  std::vector<Heading> Headings;
  bool Used;
};

/// Two squares of side 2 on the planes z = 0 and z = `height`, the second one shifted along x.
std::string TwoSquares(double height, double shift)
{
  const auto at = [&](double x, double y)
  { return " " + std::to_string(x + shift) + "," + std::to_string(y); };
  return "z=0: -1,-1 1,-1 1,1 -1,1\nz=" + std::to_string(height) + ":" + at(-1, -1) + at(1, -1) +
    at(1, 1) + at(-1, 1);
}

Options AsDrawn()
{
  Options options;
  options.Orient = Orientation::AsDrawn;
  return options;
}

/// The one pair between the two squares.
PairFeatures FeaturesOf(const std::string& text)
{
  PairFeatures features;
  std::size_t count = 0;
  ObserveJoins(ParsePieces(text), AsDrawn(),
    [&](const EvidenceTables& tables, const Reconstruction&)
    {
      const std::vector<MeasuredPair> pairs = MeasurePairs(tables);
      count = pairs.size();
      features = pairs.empty() ? features : pairs.front().Features;
    });
  EXPECT_EQ(count, 1u);
  return features;
}
}

//----------------------------------------------------------------------------
TEST(JoinEvidence, WeightsAreOfTheFeaturesTheyAreNamedAfter)
{
  PairFeatures features;
  features.Step = 2.0;
  EXPECT_EQ(EvidenceOf(features), JoinWeights.Constant);
  const auto changeBy = [&](double PairFeatures::*feature)
  {
    PairFeatures changed = features;
    changed.*feature += 1.0;
    return EvidenceOf(changed) - JoinWeights.Constant;
  };
  EXPECT_NEAR(changeBy(&PairFeatures::Flatness), JoinWeights.Flatness, 1e-14);
  EXPECT_NEAR(changeBy(&PairFeatures::Steepness), JoinWeights.Steepness, 1e-14);
  EXPECT_NEAR(changeBy(&PairFeatures::Facing), JoinWeights.Facing, 1e-14);
  EXPECT_NEAR(changeBy(&PairFeatures::Closeness), JoinWeights.Closeness, 1e-14);
  EXPECT_NEAR(changeBy(&PairFeatures::Inequality), JoinWeights.Inequality, 1e-14);
  // Lengths count in steps of the grid.
  EXPECT_NEAR(changeBy(&PairFeatures::Distance), JoinWeights.Distance / 2.0, 1e-14);
  EXPECT_NEAR(changeBy(&PairFeatures::Disagreement), JoinWeights.Disagreement / 2.0, 1e-14);
  features.OnOneFace = true;
  EXPECT_NEAR(EvidenceOf(features), JoinWeights.Constant + JoinWeights.OnOneFace, 1e-14);
}

//----------------------------------------------------------------------------
/// Squares above each other: the normals of their contours are across the line between them.
TEST(JoinEvidence, SquaresAboveEachOther)
{
  const PairFeatures features = FeaturesOf(TwoSquares(3.0, 0.0));
  EXPECT_EQ(features.Loops, 2);
  EXPECT_FALSE(features.OnOneFace);
  EXPECT_EQ(features.Flatness, 0.0);
  EXPECT_NEAR(features.Steepness, 0.0, 1e-14);
  EXPECT_NEAR(features.Facing, 1.0, 1e-14);
  EXPECT_NEAR(features.Distance, 3.0, 1e-14);
  EXPECT_NEAR(features.Step, 3.0, 1e-14);
  EXPECT_EQ(features.Closeness, 0.0);
}

//----------------------------------------------------------------------------
/// Shifted by as much as they are apart: the line is inclined by 45 degrees, and half of the border
/// has its normal along the shift.
TEST(JoinEvidence, SquaresBesideEachOther)
{
  const PairFeatures features = FeaturesOf(TwoSquares(3.0, 3.0));
  EXPECT_NEAR(features.Steepness, 0.5 * std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(features.Facing, std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(features.Distance, std::sqrt(18.0), 1e-14);
}

//----------------------------------------------------------------------------
/// The root mean square distance of a square's border from its center is measured at its corners.
TEST(JoinEvidence, WideSquaresCloseToEachOtherAreSheets)
{
  const double radius = std::sqrt(2.0), height = 0.4;
  const PairFeatures features = FeaturesOf(TwoSquares(height, 0.0));
  EXPECT_NEAR(features.Closeness, MinDistance - height / (2.0 * radius), 1e-7);
}

//----------------------------------------------------------------------------
/// On random inputs: by the definitions, written down again.
TEST(JoinEvidence, FeaturesAreAsDefined)
{
  int measured = 0, leftOut = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(40); ++seed)
  {
    const Input input = seed % 2 == 0 ? RandomSparseInput(seed) : RandomContradictoryInput(seed);
    SCOPED_TRACE(input.Name);
    ObserveJoins(input.Sets, input.Settings,
      [&](const EvidenceTables& tables, const Reconstruction& result)
      {
        const CycleGeometry& geometry = tables.Geometry;
        std::map<std::pair<Index, Index>, PairFeatures> pairs;
        for (const MeasuredPair& pair : MeasurePairs(tables))
        {
          pairs.emplace(std::make_pair(pair.First, pair.Second), pair.Features);
        }
        for (Index a = 0; a < result.Cycles.Count(); ++a)
        {
          for (Index b = a + 1; b < result.Cycles.Count(); ++b)
          {
            if (geometry.IsLoop(a) || geometry.IsLoop(b) ||
              result.Cycles.Cell[a] != result.Cycles.Cell[b])
            {
              continue;
            }
            const Disc first(geometry, a), second(geometry, b);
            const Point3 line = Unit(second.Center - first.Center);
            const double facingA = Dot(first.Normal, line), facingB = Dot(second.Normal, line);
            const auto at = pairs.find({ a, b });
            if (std::min(std::abs(facingA), std::abs(facingB)) < 1e-6)
            {
              continue;
            }
            ASSERT_EQ(at != pairs.end(), facingA * facingB < 0.0);
            if (at == pairs.end())
            {
              ++leftOut;
              continue;
            }
            const PairFeatures& features = at->second;
            const auto alongLine = [&](const Point3& n) { return std::abs(Dot(n, line)); };
            const BorderMeans borderA(tables, a), borderB(tables, b);
            double steepness =
              0.5 * (MeanOverNodes(tables, a, alongLine) + MeanOverNodes(tables, b, alongLine));
            if (borderA.Used && !std::isinf(steepness))
            {
              const double turn = TurnBetween(borderA.Headings, borderB.Headings) -
                0.5 * (TurnAcross(borderA.Headings) + TurnAcross(borderB.Headings));
              steepness = std::max(
                { steepness, 0.5 * (borderA.Mean(alongLine) + borderB.Mean(alongLine)), turn });
            }
            const auto outA = [&](const Point3& n) { return Dot(n, first.Normal); };
            const auto outB = [&](const Point3& n) { return Dot(n, second.Normal); };
            const double flatness = 0.5 *
              (borderA.Flatness(MeanOverNodes(tables, a, outA), outA) +
                borderB.Flatness(MeanOverNodes(tables, b, outB), outB));
            if (std::isinf(steepness))
            {
              continue; // no normals are known
            }
            EXPECT_NEAR(features.Steepness, steepness, 1e-6);
            EXPECT_NEAR(features.Flatness, flatness, 1e-6);
            EXPECT_NEAR(features.Facing, std::min(std::abs(facingA), std::abs(facingB)), 1e-6);
            EXPECT_NEAR(features.Distance, Length(second.Center - first.Center), 1e-9);
            EXPECT_EQ(features.Loops, 0);
            ++measured;
          }
        }
      });
  }
  EXPECT_GT(measured, 100);
  EXPECT_GT(leftOut, 3);
}

//----------------------------------------------------------------------------
/// Pairs of cycles of node points have just the evidence of their features.
TEST(JoinEvidence, JoinsHaveTheEvidenceOfTheirFeatures)
{
  int joins = 0, raised = 0;
  for (std::uint64_t seed = FirstSeed(); seed < FirstSeed() + RandomRuns(40); ++seed)
  {
    const Input input = RandomSparseInput(seed);
    SCOPED_TRACE(input.Name);
    ObserveJoins(input.Sets, input.Settings,
      [&](const EvidenceTables& tables, const Reconstruction&)
      {
        const std::vector<MeasuredPair> pairs = MeasurePairs(tables);
        const std::vector<CycleJoin> found = FindJoins(tables, {}, Execution());
        ASSERT_EQ(found.size(), pairs.size());
        for (std::size_t i = 0; i < found.size(); ++i)
        {
          const double evidence = EvidenceOf(pairs[i].Features);
          EXPECT_EQ(found[i].First, pairs[i].First);
          EXPECT_EQ(found[i].Second, pairs[i].Second);
          EXPECT_LT(found[i].First, found[i].Second);
          if (pairs[i].Features.Loops == 0 || evidence > ContinuationEvidence)
          {
            EXPECT_EQ(found[i].Evidence, evidence);
          }
          EXPECT_GE(found[i].Evidence, evidence);
          raised += found[i].Evidence > evidence ? 1 : 0;
          ++joins;
        }
      });
  }
  EXPECT_GT(joins, 100);
  EXPECT_GT(raised, 20);
}

//----------------------------------------------------------------------------
/// What a criterion says is certain, and if it is exclusive, other loops are never joined. Between
/// the planes there are four cycles, below and above them two each: 6 + 1 + 1 pairs.
TEST(JoinEvidence, KnownPairsOfLoops)
{
  ObserveJoins(ParsePieces("z=0: 0,0 1,0 1,1 0,1\nz=0: 9,0 10,0 10,1 9,1\n"
                           "z=1: 0,0 1,0 1,1 0,1\nz=1: 9,0 10,0 10,1 9,1"),
    AsDrawn(),
    [](const EvidenceTables& tables, const Reconstruction&)
    {
      const std::vector<CycleJoin> free = FindJoins(tables, {}, Execution());
      ASSERT_EQ(free.size(), 8u);
      const auto weakest = std::min_element(free.begin(), free.end(),
        [](const CycleJoin& a, const CycleJoin& b) { return a.Evidence < b.Evidence; });
      EXPECT_LT(weakest->Evidence, 0.0);
      KnownPairs known;
      known.Pairs = { { weakest->First, weakest->Second } };
      for (const CycleJoin& join : FindJoins(tables, known, Execution()))
      {
        if (join.First == weakest->First && join.Second == weakest->Second)
        {
          EXPECT_EQ(join.Evidence, CertainEvidence);
        }
      }
      EXPECT_EQ(FindJoins(tables, known, Execution()).size(), 8u);
      known.Exclusive = true;
      EXPECT_EQ(FindJoins(tables, known, Execution()).size(), 1u);
    });
}
