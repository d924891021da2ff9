// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   program: the reconstruction and the methods it is compared with, on shapes with known
 * surface
 *
 * Prints one line of figures for each shape and method, and the medians. See Usage below.
 */

#include "CaseFolder.h"
#include "Comparison.h"
#include "DistanceInterpolation.h"
#include "DistanceInterpolationThreeFamilies.h"
#include "MethodSummary.h"
#include "ProgramArguments.h"
#include "SideBySidePicture.h"

#include "vtkNew.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace orthoslices::baselines;

namespace
{

const char* const Usage =
  R"(CompareMethods [options]
  --data FOLDER       cases: FOLDER/<case>/{truth,n16_x,n16_y,n16_z,n32_x ...}.vtp
  --cases A,B         only these cases (default: all)
  --methods A,B       only these methods (default: all); --list shows their names
  --slices 16|32      planes per axis, N (default 32)
  --comparison NAME   same-planes (default): the same N planes per axis for all;
                      same-number: N per axis against 3 N z-slices for parallel methods;
                      sparse-z: N x N x N/4 planes; all: one after the other
  --samples NUMBER    samples on each surface (default 100000)
  --csv FILE          also write the rows as comma-separated values
  --surfaces FOLDER   also write every surface as FOLDER/<comparison>_<N>_<case>_<method>.vtp
  --picture FILE.png  also show our surface, ruled, volume and truth of the first case
  --noise P,Q         noise on the contours, in per cent of h: prints only a Markdown table of all
                      methods against these levels, e.g. 0,1,2,5,10,20
  --summary           print only Markdown tables with the medians of each method
  --sweep             figures of the volume methods against their resolution instead
  --list              print the methods and the cases
Lengths are in units of h, the geometric mean of the three slice spacings; normals in degrees.
Every method runs in a process of its own, with one thread; one that crashes is a row that says so.
)";

//------------------------------------------------------------------------------
struct Options
{
  std::string Data = ORTHOGONAL_SLICES_DATA_DIR;
  std::vector<std::string> Cases;
  std::vector<std::string> Methods;
  std::vector<Comparison> Comparisons{ Comparison::SamePlanes };
  int Number = 32;
  std::int64_t Samples = 100000;
  std::vector<double> Noises;
  std::string CsvFile;
  std::string SurfaceFolder;
  std::string PictureFile;
  bool Summary = false;
  bool Sweep = false;
  bool List = false;
  bool Help = false;
};

//------------------------------------------------------------------------------
std::vector<Comparison> ParseComparisons(const std::string& text)
{
  if (text == "all")
  {
    return { Comparison::SamePlanes, Comparison::SameNumber, Comparison::SparseZ };
  }
  std::vector<Comparison> comparisons;
  for (const std::string& name : SplitAtCommas(text))
  {
    comparisons.push_back(ComparisonFromName(name));
  }
  return comparisons;
}

//------------------------------------------------------------------------------
std::vector<double> ParsePercents(const std::string& text)
{
  std::vector<double> percents;
  for (const std::string& part : SplitAtCommas(text))
  {
    std::istringstream stream(part);
    double percent = -1.0;
    if (!(stream >> percent) || !stream.eof() || percent < 0.0 || percent > 1000.0)
    {
      throw std::runtime_error("\"" + part + "\" is not a number of per cent");
    }
    percents.push_back(percent);
  }
  return percents;
}

//------------------------------------------------------------------------------
// Switches without a value.
bool* FindSwitch(const std::string& option, Options& options)
{
  return option == "--summary" ? &options.Summary
    : option == "--sweep"      ? &options.Sweep
    : option == "--list"       ? &options.List
    : option == "--help"       ? &options.Help
                               : nullptr;
}

//------------------------------------------------------------------------------
void ParseValue(const std::string& option, const std::string& value, Options& options)
{
  if (option == "--data")
  {
    options.Data = value;
  }
  else if (option == "--cases")
  {
    options.Cases = SplitAtCommas(value);
  }
  else if (option == "--methods")
  {
    options.Methods = SplitAtCommas(value);
  }
  else if (option == "--comparison")
  {
    options.Comparisons = ParseComparisons(value);
  }
  else if (option == "--slices")
  {
    options.Number = static_cast<int>(ParsePositive(value));
  }
  else if (option == "--samples")
  {
    options.Samples = ParsePositive(value);
  }
  else if (option == "--noise")
  {
    options.Noises = ParsePercents(value);
  }
  else if (option == "--csv")
  {
    options.CsvFile = value;
  }
  else if (option == "--surfaces")
  {
    options.SurfaceFolder = value;
  }
  else if (option == "--picture")
  {
    options.PictureFile = value;
  }
  else
  {
    throw std::runtime_error("unknown option " + option);
  }
}

//------------------------------------------------------------------------------
using Methods = std::vector<std::unique_ptr<Baseline>>;

//------------------------------------------------------------------------------
// The methods asked for, in the order of the tables.
Methods SelectMethods(const std::vector<std::string>& names)
{
  Methods selected;
  for (std::unique_ptr<Baseline>& method : MakeAllMethods())
  {
    if (names.empty() || std::find(names.begin(), names.end(), method->Name()) != names.end())
    {
      selected.push_back(std::move(method));
    }
  }
  if (selected.size() < names.size())
  {
    throw std::runtime_error("--methods: unknown or repeated name");
  }
  return selected;
}

//------------------------------------------------------------------------------
std::vector<std::string> SelectCases(const Options& options)
{
  const std::vector<std::string> all = ListCases(options.Data);
  for (const std::string& name : options.Cases)
  {
    if (std::find(all.begin(), all.end(), name) == all.end())
    {
      throw std::runtime_error("there is no case \"" + name + "\" in " + options.Data);
    }
  }
  return options.Cases.empty() ? all : options.Cases;
}

//------------------------------------------------------------------------------
// Surfaces of the picture in the order of the paper's Figure 10.
void AddToPicture(const std::string& method, vtkPolyData* surface, SideBySidePicture& picture)
{
  if (method == "orthogonal")
  {
    picture.Add("orthogonal slices", surface);
  }
  else if (method == "ruled-walk")
  {
    picture.Add("ruled surface", surface);
  }
  else if (method == "volume-z")
  {
    picture.Add("volume", surface);
  }
}

//------------------------------------------------------------------------------
void WriteSurface(const Outcome& outcome, const std::string& folder)
{
  const Row& row = outcome.Figures;
  const std::string name = row.ComparisonName + '_' + std::to_string(row.Number) + '_' +
    row.CaseName + '_' + row.MethodName + ".vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(outcome.Surface);
  writer->SetFileName((folder + '/' + name).c_str());
  writer->SetDataModeToBinary();
  if (!writer->Write())
  {
    throw std::runtime_error("cannot write " + name + " to " + folder);
  }
}

//------------------------------------------------------------------------------
std::vector<Row> Compare(const Options& options)
{
  const Methods methods = SelectMethods(options.Methods);
  std::vector<Row> rows;
  SideBySidePicture picture;
  for (const Comparison comparison : options.Comparisons)
  {
    for (const std::string& name : SelectCases(options))
    {
      const Task task = MakeTask(options.Data, name, comparison, options.Number);
      const bool inPicture = rows.size() < methods.size();
      for (const std::unique_ptr<Baseline>& method : methods)
      {
        std::cerr << NameOf(comparison) << ' ' << name << ' ' << method->Name() << std::endl;
        const Outcome outcome = RunMethod(*method, task, options.Samples);
        rows.push_back(outcome.Figures);
        if (!options.SurfaceFolder.empty())
        {
          WriteSurface(outcome, options.SurfaceFolder);
        }
        if (inPicture)
        {
          AddToPicture(method->Name(), outcome.Surface, picture);
        }
      }
      if (inPicture)
      {
        picture.Add("known surface", task.Truth);
      }
    }
  }
  if (!options.PictureFile.empty())
  {
    picture.Write(options.PictureFile);
  }
  return rows;
}

//------------------------------------------------------------------------------
void RunSweepStep(const Baseline& method, int resolution, const Task& task, const Options& options,
  std::vector<Row>& rows)
{
  Row row = RunMethod(method, task, options.Samples).Figures;
  row.MethodName += "@" + std::to_string(resolution);
  std::cerr << task.CaseName << ' ' << row.MethodName << std::endl;
  rows.push_back(row);
}

//------------------------------------------------------------------------------
// The volume methods at growing resolutions: where the RMS error no longer falls is enough.
std::vector<Row> Sweep(const Options& options)
{
  std::vector<Row> rows;
  for (const Comparison comparison : options.Comparisons)
  {
    for (const std::string& name : SelectCases(options))
    {
      const Task task = MakeTask(options.Data, name, comparison, options.Number);
      for (const int resolution : { 64, 96, 128, 192, 256, 384 })
      {
        RunSweepStep(DistanceInterpolation(resolution), resolution, task, options, rows);
      }
      for (const int parts : { 2, 3, 4, 6, 8, 12 })
      {
        RunSweepStep(DistanceInterpolationThreeFamilies(parts), parts, task, options, rows);
      }
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
// All methods on the same noisy contours.
void RunNoiseLevel(
  const Methods& methods, const Task& task, const Options& options, std::vector<Row>& rows)
{
  for (const std::unique_ptr<Baseline>& method : methods)
  {
    std::cerr << NameOf(task.Kind) << ' ' << task.CaseName << ' ' << method->Name() << " noise "
              << task.NoisePercent << " %" << std::endl;
    Outcome outcome = RunMethod(*method, task, options.Samples);
    CountCrossings(outcome);
    rows.push_back(outcome.Figures);
  }
}

//------------------------------------------------------------------------------
std::vector<Row> AddNoiseStepwise(const Options& options)
{
  const Methods methods = SelectMethods(options.Methods);
  std::vector<Row> rows;
  for (const Comparison comparison : options.Comparisons)
  {
    for (const std::string& name : SelectCases(options))
    {
      const Task task = MakeTask(options.Data, name, comparison, options.Number);
      for (const double percent : options.Noises)
      {
        RunNoiseLevel(methods, WithNoise(task, percent), options, rows);
      }
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
void PrintList(const Options& options)
{
  for (const std::unique_ptr<Baseline>& method : MakeAllMethods())
  {
    std::cout << method->Name() << ": " << method->Description() << '\n';
  }
  for (const std::string& name : ListCases(options.Data))
  {
    std::cout << name << '\n';
  }
}

//------------------------------------------------------------------------------
std::vector<Row> MakeRows(const Options& options)
{
  if (options.Sweep)
  {
    return Sweep(options);
  }
  return options.Noises.empty() ? Compare(options) : AddNoiseStepwise(options);
}

//------------------------------------------------------------------------------
void PrintRows(const std::vector<Row>& rows, const Options& options)
{
  if (!options.Noises.empty())
  {
    PrintNoiseTables(rows, std::cout);
  }
  else if (options.Summary)
  {
    PrintMarkdownSummaries(rows, std::cout);
  }
  else
  {
    PrintTable(rows, std::cout);
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
  const std::vector<Row> rows = MakeRows(options);
  PrintRows(rows, options);
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
    std::cerr << "CompareMethods: " << error.what()
              << "\nCompareMethods --help lists the options.\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
