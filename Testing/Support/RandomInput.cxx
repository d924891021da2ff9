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
  int least = 3;
  do
  {
    std::array<int, 3> count;
    for (int& n : count)
    {
      n = least + static_cast<int>(random.Below(10));
    }
    const PlaneSets planes =
      random.Chance(0.5) ? EqualPlanes(solid, count) : RandomPlanes(solid, count, seed);
    sets = SliceSolid(solid, planes, 2 + static_cast<int>(random.Below(3)), grid);
    least += 4; // a small solid between few planes is cut by none
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
  input.Settings.RefuseInvalid = false;
  Random random(seed);
  input.Settings.Crossing =
    random.Chance(0.7) ? CrossingContours::Repair : CrossingContours::LeaveOut;
  const NamedChange& change = Changes[seed % changes];
  change.Apply(input, random);
  input.Name = "RandomContradictoryInput(" + std::to_string(seed) + "), " + change.Name;
  return input;
}

std::uint64_t RandomRuns(std::uint64_t usual)
{
  return FromEnvironment("ORTHOGONAL_SLICES_RUNS", usual);
}

std::uint64_t FirstSeed() { return FromEnvironment("ORTHOGONAL_SLICES_SEED", 0); }

} // namespace support
} // namespace orthoslices
