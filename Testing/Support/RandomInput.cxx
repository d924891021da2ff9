// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/RandomInput.h"

#include "Support/Perturbations.h"
#include "Support/Random.h"
#include "Support/SliceSolid.h"

#include <algorithm>
#include <cstdlib>

namespace orthoslices
{
namespace support
{
namespace
{
/// Typical distance of the planes of the random inputs.
constexpr double Spacing = 0.28;

PieceSets RandomSlices(std::uint64_t seed, InPlaneGrid grid)
{
  Random random(seed);
  const Solid solid = RandomSolid(seed);
  PieceSets sets;
  int minimum = 3;
  do
  {
    std::array<int, 3> count;
    for (int& n : count)
    {
      n = minimum + static_cast<int>(random.Below(10));
    }
    const PlaneSets planes =
      random.Chance(0.5) ? EqualPlanes(solid, count) : RandomPlanes(solid, count, seed);
    sets = SliceSolid(solid, planes, 2 + static_cast<int>(random.Below(3)), grid);
    minimum += 4; // a small solid between few planes is cut by none
  } while (sets[0].Count() == 0 || sets[1].Count() == 0 || sets[2].Count() == 0);
  return sets;
}

using Change = void (*)(Input&, Random&);

struct NamedChange
{
  const char* Name;
  Change Apply;
};

const NamedChange Changes[] = {
  { "vertices moved a little",
    [](Input& input, Random& random)
    { MoveVertices(input.Sets, random.Uniform(0.0, 0.1) * Spacing, random.Bits()); } },
  { "vertices moved by a spacing",
    [](Input& input, Random& random) { MoveVertices(input.Sets, Spacing, random.Bits()); } },
  { "slices bent",
    [](Input& input, Random& random)
    {
      BendSlices(
        input.Sets, random.Uniform(0.0, 1.0) * Spacing, random.Uniform(0.5, 3.0), random.Bits());
    } },
  { "slices moved",
    [](Input& input, Random& random)
    { MoveSlices(input.Sets, random.Uniform(0.0, 1.0) * Spacing, random.Bits()); } },
  { "planes shifted",
    [](Input& input, Random& random) { ShiftPlanes(input.Sets, 0.5 * Spacing, random.Bits()); } },
  { "sets rotated",
    [](Input& input, Random& random) { RotateSets(input.Sets, random.Uniform(1.0, 30.0)); } },
  { "contours deleted",
    [](Input& input, Random& random)
    { DropContours(input.Sets, random.Uniform(0.01, 0.5), random.Bits()); } },
  { "one axis thinned out",
    [](Input& input, Random& random) { ThinOut(input.Sets[random.Below(3)], 10); } },
  { "directions random",
    [](Input& input, Random& random)
    {
      ReverseContours(input.Sets, 0.5, random.Bits());
      input.Settings.Orient = Orientation::AsDrawn;
    } },
  { "contours twice, as drawn",
    [](Input& input, Random& random)
    {
      DuplicatePieces(input.Sets);
      ReverseContours(input.Sets, 0.3, random.Bits());
      input.Settings.Orient = Orientation::AsDrawn;
    } },
  { "everything at once",
    [](Input& input, Random& random)
    {
      BendSlices(input.Sets, Spacing, 1.0, random.Bits());
      MoveSlices(input.Sets, Spacing, random.Bits());
      ShiftPlanes(input.Sets, 0.3 * Spacing, random.Bits());
      DropContours(input.Sets, 0.2, random.Bits());
      ReverseContours(input.Sets, 0.2, random.Bits());
      input.Settings.Orient = random.Chance(0.5) ? Orientation::AsDrawn : Orientation::ByNesting;
    } },
};

std::uint64_t FromEnvironment(const char* name, std::uint64_t usual)
{
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : usual;
}
}

Input RandomConsistentInput(std::uint64_t seed)
{
  Input input;
  input.Exact = seed % 2 == 0;
  input.Sets = RandomSlices(seed, input.Exact ? InPlaneGrid::Aligned : InPlaneGrid::Free);
  input.Name = "RandomConsistentInput(" + std::to_string(seed) + (input.Exact ? "), exact" : ")");
  return input;
}

Input RandomContradictoryInput(std::uint64_t seed)
{
  constexpr std::size_t changes = sizeof(Changes) / sizeof(Changes[0]);
  Input input;
  input.Sets = RandomSlices(seed, seed / changes % 2 ? InPlaneGrid::Aligned : InPlaneGrid::Free);
  input.Settings.Invalid = InvalidContours::LeaveOut;
  Random random(seed);
  input.Settings.Crossing =
    random.Chance(0.7) ? CrossingContours::Repair : CrossingContours::LeaveOut;
  constexpr LoopRule rules[] = { LoopRule::Union, LoopRule::Union, LoopRule::EvenOdd,
    LoopRule::NonZero };
  input.Settings.Loops = rules[seed / (2 * changes) % 4];
  const NamedChange& change = Changes[seed % changes];
  change.Apply(input, random);
  input.Name = "RandomContradictoryInput(" + std::to_string(seed) + "), " + change.Name;
  return input;
}

namespace
{
/// Tubes, rings, curves and balls with radii of about a quarter to one spacing.
Solid RandomThinSolid(std::uint64_t seed, double spacing)
{
  Random random(seed);
  const auto place = [&]() -> Point3 {
    return { random.Uniform(-0.9, 0.9), random.Uniform(-0.9, 0.9), random.Uniform(-0.9, 0.9) };
  };
  Solid solid;
  solid.Name = "RandomThinSolid" + std::to_string(seed);
  solid.Low = { -1.411, -1.423, -1.437 };
  solid.High = { 1.417, 1.413, 1.429 };
  const std::size_t count = 1 + random.Below(4);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double radius = std::min(random.Uniform(0.2, 1.0) * spacing, 0.45);
    switch (random.Below(4))
    {
      case 0:
        solid.Tubes.push_back(Ball(place(), radius));
        break;
      case 1:
        solid.Tubes.push_back(Capsule(place(), place(), radius));
        break;
      case 2:
        solid.Tubes.push_back(CurveTube({ place(), place(), place(), place() }, false, radius));
        break;
      default:
        solid.Tubes.push_back(Torus({ 0.3 * random.Uniform(-1.0, 1.0), 0.1, -0.1 }, place(),
          random.Uniform(0.4, 0.7), std::min(radius, 0.3)));
    }
  }
  return solid;
}
}

Input RandomSparseInput(std::uint64_t seed)
{
  Random random(seed);
  Input input;
  input.Name = "RandomSparseInput(" + std::to_string(seed) + ")";
  const int families = 1 + static_cast<int>(seed % 3);
  const int firstAxis = static_cast<int>(random.Below(3));
  std::array<int, 3> count{ 0, 0, 0 };
  double spacing = 0.0;
  for (int i = 0; i < families; ++i)
  {
    const int axis = (firstAxis + i) % 3;
    count[axis] = 3 + static_cast<int>(random.Below(9));
    spacing = std::max(spacing, 2.8 / count[axis]);
  }
  const InPlaneGrid grid = random.Chance(0.3) ? InPlaneGrid::Aligned : InPlaneGrid::Free;
  const bool equal = random.Chance(0.5);
  std::uint64_t trial = 0;
  do
  {
    const Solid solid = RandomThinSolid(seed + (trial << 32), spacing);
    const PlaneSets planes =
      equal ? EqualPlanes(solid, count) : RandomPlanes(solid, count, seed + trial);
    input.Sets = SliceSolid(solid, planes, 3, grid);
    ++trial;
  } while (input.Sets[0].Count() + input.Sets[1].Count() + input.Sets[2].Count() == 0);
  input.Settings.Invalid = InvalidContours::LeaveOut;
  input.Settings.Known.Components = random.Chance(0.5) ? static_cast<Index>(random.Below(4)) : 0;
  input.Settings.Known.Genus = random.Chance(0.5) ? static_cast<Index>(random.Below(4)) : -1;
  input.Settings.MinComponent = random.Chance(0.1) ? random.Uniform(0.0, 0.3) : 0.0;
  input.Settings.MinIsolatedContour = random.Chance(0.1) ? random.Uniform(0.0, 0.1) : 0.0;
  if (random.Chance(0.2))
  {
    MoveSlices(input.Sets, random.Uniform(0.0, 0.3) * spacing, random.Bits());
    input.Name += ", slices moved";
  }
  return input;
}

std::uint64_t RandomRuns(std::uint64_t usual)
{
  return FromEnvironment("ORTHOGONAL_SLICES_RUNS", usual);
}

std::uint64_t FirstSeed() { return FromEnvironment("ORTHOGONAL_SLICES_SEED", 0); }

} // namespace support
} // namespace orthoslices
