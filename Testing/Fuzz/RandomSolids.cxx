// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * RandomSolids COUNT [FIRST [SECONDS]]
 *
 * Reconstructs unions of random balls, capsules and tori, from contours that agree, from contours
 * made contradictory and from contours on few planes of one, two or three axes, with and without
 * virtual slices between these, in both precisions, and checks every surface exactly: closed,
 * 2-manifold, oriented, embedded. Input number n is the same in every run. Stops after SECONDS if
 * they are given. A failure is reduced and printed as text; the exit code is 1 then.
 */

#include "Support/CheckEmbedding.h"
#include "Support/Perturbations.h"
#include "Support/RandomInput.h"
#include "Support/ReduceInput.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
Input MakeInput(std::uint64_t number)
{
  // Every fourth one agrees, and every fourth one has slices on few planes or axes.
  Input input = number % 4 == 0 ? RandomConsistentInput(number)
    : number % 4 == 2           ? RandomSparseInput(number)
                                : RandomContradictoryInput(number);
  if (number / 4 % 2 == 1)
  {
    RoundToFloat(input.Sets);
    input.Settings.SinglePrecision = true;
  }
  if (number / 16 % 2 == 0)
  {
    input.Settings.Virtual = VirtualSlices::Automatic; // dense ones do not get any
  }
  if (number / 8 % 4 == 1)
  {
    input.Settings.Central = CentralPointMethod::Centroid;
  }
  return input;
}

bool Check(std::uint64_t number)
{
  const Input input = MakeInput(number);
  const std::string flaws = FindFlaws(input.Sets, input.Settings);
  if (flaws.empty())
  {
    return true;
  }
  std::cout << "Number " << number << ", " << input.Name << ":\n" << flaws;
  const PieceSets reduced = Reduce(input.Sets, input.Settings);
  std::cout << "Reduced:\n"
            << Describe(reduced, input.Settings) << FindFlaws(reduced, input.Settings) << std::endl;
  return false;
}
}

int main(int argc, char* argv[])
{
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  const double maximum = argc > 3 ? std::strtod(argv[3], nullptr) : HUGE_VAL;
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [start]
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  std::uint64_t done = 0, failures = 0;
  for (; done < count && seconds() < maximum && failures < 20; ++done)
  {
    failures += Check(first + done) ? 0 : 1;
    if (done % 1000 == 999)
    {
      std::cout << done + 1 << " solids, " << failures << " failures, " << seconds() << " s"
                << std::endl;
    }
  }
  std::cout << done << " random solids from number " << first << ": " << failures << " failures, "
            << seconds() << " s" << std::endl;
  return failures == 0 ? 0 : 1;
}
