// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Evidence.h"

#include "Support/ContourStacks.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Vtk/DataSets.h"

#include <stdexcept>

namespace orthoslices
{
namespace baselines
{

using namespace support;

const std::array<CorrespondenceCriterion, 4> AllCriteria{ CorrespondenceCriterion::Overlap,
  CorrespondenceCriterion::EllipticalCylinders, CorrespondenceCriterion::SpanningTree,
  CorrespondenceCriterion::ReebGraph };

namespace
{

/// Between two slices, and within a layer, of the grid that is flooded.
constexpr int FloodLayers = 12;
constexpr double FloodDistance = 0.02;

/// Cells of the in-plane grid on which contours are traced, in each slab. Inclined solids are thin
/// along z: coarser grids tear their x- and y-contours to pieces.
constexpr std::array<int, 3> Subdivisions{ 6, 6, 32 };

//------------------------------------------------------------------------------
bool AreEqual(const CountedTopology& a, const CountedTopology& b)
{
  return a.Components == b.Components && a.Genus == b.Genus;
}

//------------------------------------------------------------------------------
CountedTopology KnownTopology(const Solid& solid) { return { solid.Components, solid.Genus }; }

//------------------------------------------------------------------------------
void JudgeOrthogonalSlices(PieceSets&& slices, Evidence& evidence)
{
  evidence.Surface = MeshOf(Reconstruct(std::move(slices), Options(), Execution()));
  const SurfaceCheck check = CheckSurface(evidence.Surface);
  if (check.IsClosedManifold())
  {
    evidence.Orthogonal = { check.Components, check.TotalGenus() };
  }
  evidence.OrthogonalRight = AreEqual(evidence.Orthogonal, KnownTopology(evidence.Object.Shape));
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::string NameOf(CorrespondenceCriterion criterion)
{
  switch (criterion)
  {
    case CorrespondenceCriterion::Overlap:
      return "overlap";
    case CorrespondenceCriterion::EllipticalCylinders:
      return "elliptical cylinders";
    case CorrespondenceCriterion::SpanningTree:
      return "spanning tree";
    default:
      return "Reeb graph";
  }
}

//------------------------------------------------------------------------------
Evidence Judge(const InclinedSolid& object)
{
  Evidence evidence;
  evidence.Object = object;
  PieceSets slices = SliceSolid(object.Shape, object.Planes, Subdivisions, InPlaneGrid::Aligned);
  evidence.Stack = StackOf(slices[2], object.Planes[2]);
  const auto truth = TruePieces(object.Shape, evidence.Stack, FloodLayers, FloodDistance);
  if (!truth || !AreEqual(TopologyOf(*truth), KnownTopology(object.Shape)))
  {
    throw std::runtime_error("flooding does not tell the pieces of " + object.Shape.Name);
  }
  evidence.Truth = *truth;
  const PriorKnowledge known{ object.Shape.Components, object.Shape.Genus };
  for (std::size_t i = 0; i < AllCriteria.size(); ++i)
  {
    Verdict& verdict = evidence.Verdicts[i];
    verdict.Pairs = FindCorrespondences(AllCriteria[i], evidence.Stack, known);
    const SurfacePieces pieces = PiecesOf(verdict.Pairs, evidence.Stack.Count());
    verdict.Topology = TopologyOf(pieces);
    verdict.Errors = CountMistakes(verdict.Pairs, evidence.Truth);
    verdict.Right = pieces == evidence.Truth;
  }
  JudgeOrthogonalSlices(std::move(slices), evidence);
  return evidence;
}

//------------------------------------------------------------------------------
std::map<Index, std::int64_t> CountPolygonSizes(int planes)
{
  std::map<Index, std::int64_t> counts;
  for (const DataSet& data : AllDataSets())
  {
    const Reconstruction result = Reconstruct(ReadPieceSets(data, planes), Options(), Execution());
    for (Index i = 0; i < result.Cycles.Count(); ++i)
    {
      const Index size = result.Cycles.Offsets[i + 1] - result.Cycles.Offsets[i];
      if (size > 1) // a contour without node points is no polygon
      {
        ++counts[size];
      }
    }
  }
  return counts;
}

} // namespace baselines
} // namespace orthoslices
