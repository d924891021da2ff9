// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Loops/SlightMeetings.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace orthoslices
{
namespace
{
/// What noise leaves in all lobes of a contour together, by its area without them, is less than
/// that.
constexpr double MostInLobes = 0.25;

/// Loops that are meant to meet make about one face more than there are loops where two cross. With
/// so many more faces than twice the loops, noise has made them, whatever their areas.
constexpr Index MostFaces = 16;

/// Loops that overlap in a face around which runs this share of the length of the shorter one, or
/// more, are one: the neck between them is a fifth as wide as a circle of that length.
constexpr double LeastNeck = 0.125;

/// What is common to two loops.
struct CommonFaces
{
  double Area = 0.0;
  Index Count = 0;
  Index Last = -1;
};

using CommonOfParts = std::map<std::pair<Index, Index>, CommonFaces>;

/// Of two parts, the lesser one first.
CommonOfParts FindCommonFaces(const LoopWindings& windings)
{
  CommonOfParts common;
  for (Index face = 0; face < windings.GetGraph().CountFaces(); ++face)
  {
    const LoopWindings::Layers& layers = windings.LayersOf(face);
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      for (std::size_t j = 0; j < i && windings.IsAtHome(layers[i].Part, face); ++j)
      {
        if (windings.IsAtHome(layers[j].Part, face))
        {
          CommonFaces& of = common[{ layers[j].Part, layers[i].Part }];
          of.Area += windings.AreaOfFace(face);
          of.Count += 1;
          of.Last = face;
        }
      }
    }
  }
  return common;
}

/// Lengths around faces, and of walks.
struct BorderLengths
{
  std::vector<double> OfFace, OfWalk;
};

BorderLengths MeasureBorders(const LoopWindings& windings)
{
  const PlaneFaces& graph = windings.GetGraph();
  BorderLengths lengths{ std::vector<double>(graph.CountFaces(), 0.0),
    std::vector<double>(windings.CountWalks(), 0.0) };
  for (Index edge = 0; edge < graph.CountHalfEdges() / 2; ++edge)
  {
    const double length = windings.LengthOf(edge);
    lengths.OfFace[graph.Face(2 * edge)] += length;
    lengths.OfFace[graph.Face(2 * edge + 1)] += length;
    for (Index i = graph.FirstPassage(edge); i < graph.EndOfPassages(edge); ++i)
    {
      lengths.OfWalk[graph.PassageAt(i).Walk] += length;
    }
  }
  return lengths;
}

/// Whether a walk surrounds most once and in one direction, and the rest in little lobes.
bool AreWalksPlain(const LoopWindings& windings)
{
  const PlaneFaces& graph = windings.GetGraph();
  struct Sums
  {
    Index Parts = 0;
    double All = 0.0;
    std::array<double, 2> Once{}; ///< clockwise and counter-clockwise
    std::array<double, 2> Lobe{}; ///< the largest face that is not surrounded once so
  };
  std::vector<Sums> sums(windings.CountWalks());
  for (Index part = 0; part < windings.CountParts(); ++part)
  {
    Sums& sum = sums[windings.WalkOf(part)];
    sum.Parts += windings.AreaOf(part) > 0.0 ? 1 : 0;
    sum.All += windings.AreaOf(part);
  }
  for (Index face = 0; face < graph.CountFaces(); ++face)
  {
    const double area = windings.AreaOfFace(face);
    for (const LoopWindings::Layer& layer : windings.LayersOf(face))
    {
      Sums& sum = sums[windings.WalkOf(layer.Part)];
      for (const int turn : { 0, 1 })
      {
        const bool isOnce = layer.Winding == 2 * turn - 1;
        const bool isAtHome = windings.IsAtHome(layer.Part, face);
        sum.Once[turn] += isAtHome && isOnce ? area : 0.0;
        sum.Lobe[turn] = std::max(sum.Lobe[turn], isAtHome && !isOnce ? area : 0.0);
      }
    }
  }
  return std::all_of(sums.begin(), sums.end(),
    [](const Sums& sum)
    {
      const int main = sum.Once[1] >= sum.Once[0] ? 1 : 0;
      return sum.Parts < 2 && sum.Lobe[main] <= LittleShare * sum.Once[main] &&
        sum.All <= (1.0 + MostInLobes) * sum.Once[main];
    });
}

/// Whether no walks run along each other for more than a little.
bool AreWalksApart(const LoopWindings& windings)
{
  const PlaneFaces& graph = windings.GetGraph();
  std::vector<double> length(windings.CountWalks(), 0.0), common(length);
  for (Index edge = 0; edge < graph.CountHalfEdges() / 2; ++edge)
  {
    const Index first = graph.FirstPassage(edge), end = graph.EndOfPassages(edge);
    for (Index i = first; i < end; ++i)
    {
      const Index walk = graph.PassageAt(i).Walk;
      length[walk] += windings.LengthOf(edge);
      common[walk] += end - first > 1 ? windings.LengthOf(edge) : 0.0;
    }
  }
  for (std::size_t walk = 0; walk < length.size(); ++walk)
  {
    if (common[walk] > LittleShare * length[walk])
    {
      return false;
    }
  }
  return true;
}
}

bool AreMeetingsSlight(const LoopWindings& windings)
{
  const PlaneFaces& graph = windings.GetGraph();
  if (graph.CountFaces() > MostFaces + 2 * windings.CountWalks())
  {
    return true;
  }
  if (!AreWalksPlain(windings) || !AreWalksApart(windings))
  {
    return false;
  }
  const BorderLengths lengths = MeasureBorders(windings);
  for (const auto& [parts, of] : FindCommonFaces(windings))
  {
    const double a = windings.AreaOf(parts.first);
    const double b = windings.AreaOf(parts.second);
    const double little = LittleShare * std::min(a, b);
    const bool isIn = a - of.Area <= little || b - of.Area <= little;
    const bool isSame = a - of.Area <= little && b - of.Area <= little;
    const double shorter = std::min(
      lengths.OfWalk[windings.WalkOf(parts.first)], lengths.OfWalk[windings.WalkOf(parts.second)]);
    const bool isNeck = of.Count == 1 && lengths.OfFace[of.Last] >= LeastNeck * shorter;
    if ((of.Area > little && (!isIn || isSame)) || (isNeck && !isIn))
    {
      return false;
    }
  }
  return true;
}

bool DoLoopsCross(const LoopWindings& windings)
{
  const PlaneFaces& graph = windings.GetGraph();
  for (Index edge = 0; edge < graph.CountHalfEdges() / 2; ++edge)
  {
    const Index first = graph.FirstPassage(edge);
    if (graph.EndOfPassages(edge) - first > 1 || graph.PassageAt(first).Net == 0)
    {
      return true;
    }
  }
  std::vector<Index> faces(windings.CountParts(), 0), windingOf(faces);
  for (Index face = 0; face < graph.CountFaces(); ++face)
  {
    for (const LoopWindings::Layer& layer : windings.LayersOf(face))
    {
      if (windings.IsAtHome(layer.Part, face))
      {
        Index& winding = windingOf[layer.Part];
        winding = faces[layer.Part] == 0 ? layer.Winding : winding;
        if (winding != layer.Winding || std::abs(winding) > 1)
        {
          return true;
        }
        faces[layer.Part] += 1;
      }
    }
  }
  const CommonOfParts common = FindCommonFaces(windings);
  return std::any_of(common.begin(), common.end(),
    [&](const CommonOfParts::value_type& entry)
    {
      return entry.second.Count < faces[entry.first.first] &&
        entry.second.Count < faces[entry.first.second];
    });
}
}
