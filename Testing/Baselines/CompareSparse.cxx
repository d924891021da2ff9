// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   program: the reconstruction and other methods on one stack, two families, few planes
 *
 * Prints a Markdown table with a line for each choice of planes and a column for each method. See
 * Usage below.
 */

#include "CaseFolder.h"
#include "ChosenPlanes.h"
#include "Comparison.h"
#include "DistanceInterpolation.h"
#include "DistanceInterpolationThreeFamilies.h"
#include "MethodSummary.h"
#include "OrthogonalSlices.h"
#include "ProgramArguments.h"
#include "RadialBasis.h"
#include "RuledSurface.h"
#include "SideBySidePicture.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace orthoslices::baselines;

namespace
{

const char* const Usage =
  R"(CompareSparse [options]
  --data FOLDER       cases: FOLDER/<case>/{truth,n32_x,n32_y,n32_z}.vtp
  --cases A,B         only these cases (default: all)
  --planes A,B        only these choices of planes (default: all); --list shows their names
  --methods A,B       only these methods (default: all)
  --samples NUMBER    samples on each surface (default 100000)
  --details           also print the figures of each case
  --csv FILE          also write the rows as comma-separated values
  --picture FILE.png  also show the surfaces of the first case and planes, and the known one
  --list              print the choices of planes, the methods and the cases
Planes are chosen evenly from 32 of each family. Lengths are in units of h, the geometric mean of
the three spacings of all 32 planes, normals in degrees. Ruled surfaces and the distance volume of
one family take the family with most planes, z if there are several; volume-xyz wants three.
Every method runs in a process of its own, with one thread; one that crashes is a row that says so.
)";

constexpr int AllPlanes = 32;

//------------------------------------------------------------------------------
struct PlaneChoice
{
  std::string Name;
  std::array<int, 3> Numbers; // of x-, y- and z-planes
};

const std::vector<PlaneChoice> PlaneChoices{
  { "z", { 0, 0, 32 } },
  { "xy", { 32, 32, 0 } },
  { "xz", { 32, 0, 32 } },
  { "yz", { 0, 32, 32 } },
  { "32x32x8", { 32, 32, 8 } },
  { "8x8x8", { 8, 8, 8 } },
  { "1x1x12", { 1, 1, 12 } },
  { "2x2x3", { 2, 2, 3 } },
  { "1x1x1", { 1, 1, 1 } },
};

//------------------------------------------------------------------------------
struct Options
{
  std::string Data = ORTHOGONAL_SLICES_DATA_DIR;
  std::vector<std::string> Cases;
  std::vector<std::string> Planes;
  std::vector<std::string> Methods;
  std::int64_t Samples = 100000;
  std::string CsvFile;
  std::string PictureFile;
  bool Details = false;
  bool List = false;
  bool Help = false;
};

//------------------------------------------------------------------------------
// Switches without a value.
bool* FindSwitch(const std::string& option, Options& options)
{
  return option == "--details" ? &options.Details
    : option == "--list"       ? &options.List
    : option == "--help"       ? &options.Help
                               : nullptr;
}

//------------------------------------------------------------------------------
void ParseValue(const std::string& option, const std::string& value, Options& options)
{
  std::vector<std::string>* const list = option == "--cases" ? &options.Cases
    : option == "--planes"                                   ? &options.Planes
    : option == "--methods"                                  ? &options.Methods
                                                             : nullptr;
  std::string* const text = option == "--data" ? &options.Data
    : option == "--csv"                        ? &options.CsvFile
    : option == "--picture"                    ? &options.PictureFile
                                               : nullptr;
  if (list)
  {
    *list = SplitAtCommas(value);
  }
  else if (text)
  {
    *text = value;
  }
  else if (option == "--samples")
  {
    options.Samples = ParsePositive(value);
  }
  else
  {
    throw std::runtime_error("unknown option " + option);
  }
}

//------------------------------------------------------------------------------
// What of ALL is wanted, in the order of ALL; an empty list wants all.
template <typename Item, typename Namer>
std::vector<Item> Select(
  std::vector<Item> all, const std::vector<std::string>& wanted, const Namer& nameOf)
{
  std::vector<Item> selected;
  for (Item& item : all)
  {
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), nameOf(item)) != wanted.end())
    {
      selected.push_back(std::move(item));
    }
  }
  if (selected.empty() || selected.size() < wanted.size())
  {
    throw std::runtime_error("unknown or repeated name: --list shows them all");
  }
  return selected;
}

//------------------------------------------------------------------------------
using Methods = std::vector<std::unique_ptr<Baseline>>;

//------------------------------------------------------------------------------
Methods MakeMethods()
{
  Methods methods;
  methods.push_back(std::make_unique<OrthogonalSlices>());
  methods.push_back(std::make_unique<AlongMostPlanes>(
    std::make_unique<RuledSurface>(RuledSurface::Mode::PointWalk)));
  methods.push_back(std::make_unique<AlongMostPlanes>(std::make_unique<DistanceInterpolation>()));
  methods.push_back(std::make_unique<DistanceInterpolationThreeFamilies>());
  methods.push_back(std::make_unique<RadialBasis>());
  return methods;
}

//------------------------------------------------------------------------------
Methods SelectMethods(const Options& options)
{
  return Select(MakeMethods(), options.Methods, [](const auto& method) { return method->Name(); });
}

//------------------------------------------------------------------------------
std::vector<PlaneChoice> SelectPlanes(const Options& options)
{
  return Select(PlaneChoices, options.Planes, [](const PlaneChoice& c) { return c.Name; });
}

//------------------------------------------------------------------------------
std::vector<std::string> SelectCases(const Options& options)
{
  return Select(
    ListCases(options.Data), options.Cases, [](const std::string& name) { return name; });
}

//------------------------------------------------------------------------------
// The three-family volume has nothing to blend where a family is missing.
bool IsMeantFor(const Baseline& method, const PlaneChoice& choice)
{
  return method.Name() != DistanceInterpolationThreeFamilies().Name() ||
    std::count(choice.Numbers.begin(), choice.Numbers.end(), 0) == 0;
}

//------------------------------------------------------------------------------
// Rows of one case with one choice of planes. The picture, if there is one, gets their surfaces.
void CompareMethods(const Task& task, const PlaneChoice& choice, const Options& options,
  std::vector<Row>& rows, SideBySidePicture* picture)
{
  for (const std::unique_ptr<Baseline>& method : SelectMethods(options))
  {
    if (IsMeantFor(*method, choice))
    {
      std::cerr << choice.Name << ' ' << task.CaseName << ' ' << method->Name() << std::endl;
      Outcome outcome = RunMethod(*method, task, options.Samples);
      outcome.Figures.ComparisonName = choice.Name;
      rows.push_back(outcome.Figures);
      if (picture)
      {
        picture->Add(method->Name(), outcome.Surface);
      }
    }
  }
  if (picture)
  {
    picture->Add("known surface", task.Truth);
  }
}

//------------------------------------------------------------------------------
std::vector<Row> Compare(const Options& options)
{
  std::vector<Row> rows;
  SideBySidePicture picture;
  for (const PlaneChoice& choice : SelectPlanes(options))
  {
    for (const std::string& name : SelectCases(options))
    {
      Task task = MakeTask(options.Data, name, Comparison::SamePlanes, AllPlanes);
      task.Orthogonal = ChoosePlanes(task.Orthogonal, choice.Numbers);
      const bool isShown = rows.empty() && !options.PictureFile.empty();
      CompareMethods(task, choice, options, rows, isShown ? &picture : nullptr);
    }
  }
  if (!options.PictureFile.empty())
  {
    picture.Write(options.PictureFile);
  }
  return rows;
}

//------------------------------------------------------------------------------
void PrintList(const Options& options)
{
  for (const PlaneChoice& choice : PlaneChoices)
  {
    std::cout << choice.Name << ": " << choice.Numbers[0] << " x-planes, " << choice.Numbers[1]
              << " y-planes, " << choice.Numbers[2] << " z-planes\n";
  }
  for (const std::unique_ptr<Baseline>& method : MakeMethods())
  {
    std::cout << method->Name() << ": " << method->Description() << '\n';
  }
  for (const std::string& name : ListCases(options.Data))
  {
    std::cout << name << '\n';
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
  if (options.List)
  {
    PrintList(options);
    return;
  }
  const std::vector<Row> rows = Compare(options);
  PrintComparisonTable(rows, std::cout);
  std::cout << "\nMedian of RMS/h (median of the normals' deviation, right topologies) of "
            << SelectCases(options).size() << " cases.\n";
  if (options.Details)
  {
    std::cout << '\n';
    PrintTable(rows, std::cout);
  }
  if (!options.CsvFile.empty())
  {
    WriteCsvFile(rows, options.CsvFile);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  try
  {
    Run(ParseArguments<Options>(
      std::vector<std::string>(argv + 1, argv + argc), FindSwitch, ParseValue));
  }
  catch (const std::exception& error)
  {
    std::cerr << "CompareSparse: " << error.what() << "\nCompareSparse --help lists the options.\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
