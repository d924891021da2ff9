// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the paper's evidence: Figures 1 and 2 as tables, Figure 8 as a histogram
 *
 * Figure 10, our surface beside those of other methods, is a picture of CompareMethods.
 */

#include "Evidence.h"

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <stdexcept>

using namespace orthoslices;
using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{

const char* const Usage =
  R"(PaperEvidence [--surfaces FOLDER] [--planes 16|32]

Prints, as Markdown, which of four criteria for parallel slices connects the contours of which
object rightly, beside the surface from orthogonal slices; and the sizes of the spatial cycles
of all data sets in Data.

  --surfaces FOLDER  also write every object's surface, z-contours and correspondences as .vtp
  --planes 16|32     planes on each axis of the data sets (32)
)";

//------------------------------------------------------------------------------
struct Options
{
  bool Help = false;
  std::string Folder; ///< empty: none
  int Planes = 32;
};

//------------------------------------------------------------------------------
Options Parse(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& option = arguments[i];
    if (option == "--help")
    {
      options.Help = true;
      continue;
    }
    if (++i == arguments.size())
    {
      throw std::runtime_error("unknown option or no value: " + option);
    }
    if (option == "--surfaces")
    {
      options.Folder = arguments[i];
    }
    else if (option == "--planes" && (arguments[i] == "16" || arguments[i] == "32"))
    {
      options.Planes = std::stoi(arguments[i]);
    }
    else
    {
      throw std::runtime_error("cannot understand " + option + ' ' + arguments[i]);
    }
  }
  return options;
}

//------------------------------------------------------------------------------
std::vector<Evidence> JudgeAll(const std::vector<InclinedSolid>& objects, const std::string& folder)
{
  std::vector<Evidence> all;
  for (const InclinedSolid& object : objects)
  {
    std::cerr << object.Family << ' ' << object.Shape.Name << std::endl;
    all.push_back(Judge(object));
    if (!folder.empty())
    {
      WriteEvidence(all.back(), folder);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
void PrintPolygonSizes(int planes)
{
  const std::map<Index, std::int64_t> counts = CountPolygonSizes(planes);
  double total = 0.0;
  for (const auto& size : counts)
  {
    total += size.second;
  }
  std::cout << "| node points | polygons | % |\n|---|---|---|\n";
  for (const auto& [size, count] : counts)
  {
    std::cout << "| " << size << " | " << count << " | " << std::fixed << std::setprecision(3)
              << 100.0 * count / total << " |\n";
  }
}

//------------------------------------------------------------------------------
void Run(const Options& options)
{
  if (options.Help)
  {
    std::cout << Usage;
    return;
  }
  const std::vector<Evidence> figureOne = JudgeAll(FigureOneSolids(), options.Folder);
  std::cout << "\n## Objects that each method connects rightly (Figure 1)\n\n";
  PrintFamilies(figureOne, std::cout);
  std::cout << '\n';
  PrintEvidence(figureOne, std::cout);
  std::cout << "\n## Spirals (Figure 2)\n\n";
  PrintEvidence(JudgeAll(FigureTwoSolids(), options.Folder), std::cout);
  std::cout << "\n## Exceptions\n\n";
  PrintEvidence(JudgeAll(Exceptions(), options.Folder), std::cout);
  std::cout << "\n## Sizes of spatial polygons (Figure 8), " << options.Planes
            << " planes per axis\n\n";
  PrintPolygonSizes(options.Planes);
}

} // anonymous namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  try
  {
    Run(Parse(std::vector<std::string>(argv + 1, argv + argc)));
  }
  catch (const std::exception& error)
  {
    std::cerr << "PaperEvidence: " << error.what() << "\nPaperEvidence --help lists the options.\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
