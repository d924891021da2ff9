// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   how many slices the right topology takes: the proposed ones against finer spacing
 *
 * The table of undecided places says where to slice next. This program does so: it cuts a known
 * surface by few planes, adds the slices that the filter proposes, one after another, and counts
 * the planes that it takes until the number of components and the genus are right for the first
 * time. Beside it the same for equally spaced planes: half the spacing each time, and one more on
 * each axis at a time.
 */

#include "CaseFolder.h"
#include "Support/CheckSurface.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkOrthogonalSlicer.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>

using namespace orthoslices;
using namespace orthoslices::baselines;
using namespace orthoslices::support;

namespace
{

const char* const Usage = R"(CompareSampling [options]
  --data FOLDER    cases: FOLDER/<case>/truth.vtp (default: the folder Data)
  --cases A,B      only these cases (default: all that are cut from one surface)
  --start NUMBER   planes on each axis to start with (default 8)
  --maximum NUMBER    planes on each axis, on average, at which to stop (default 48)
  --step NUMBER    proposed planes that are added at a time (default 1)
  --curve          also print components and genus after every step
)";

using Planes = std::array<std::set<double>, 3>;

struct Settings
{
  std::string Folder = ORTHOGONAL_SLICES_DATA_DIR;
  std::vector<std::string> Cases;
  int Start = 8;
  int Maximum = 48;
  int Step = 1;
  bool Curve = false;
};

struct Topology
{
  std::int64_t Components = 0;
  std::int64_t Genus = 0;

  bool operator==(const Topology& other) const
  {
    return this->Components == other.Components && this->Genus == other.Genus;
  }
};

Topology TopologyOf(vtkPolyData* surface)
{
  const SurfaceCheck check = CheckSurface(MeshOf(surface));
  return { check.Components, check.TotalGenus() };
}

int Count(const Planes& planes)
{
  return static_cast<int>(planes[0].size() + planes[1].size() + planes[2].size());
}

/// Equally spaced planes, half a spacing inside the box.
Planes EqualPlanes(vtkPolyData* surface, int number)
{
  double bounds[6];
  surface->GetBounds(bounds);
  Planes planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double width = (bounds[2 * axis + 1] - bounds[2 * axis]) / number;
    for (int i = 0; i < number; ++i)
    {
      planes[axis].insert(bounds[2 * axis] + (i + 0.5) * width);
    }
  }
  return planes;
}

/// The surface from the given slices of a known one.
class Trial
{
public:
  explicit Trial(vtkPolyData* truth)
  {
    this->Slicer->SetInputData(truth);
    this->Slicer->SetPlaneModeToCoordinates();
    this->Slicer->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    for (int port = 0; port < 3; ++port)
    {
      this->Filter->SetInputConnection(port, this->Slicer->GetOutputPort(port));
    }
  }

  Topology Run(const Planes& planes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Slicer->SetNumberOfCoordinates(axis, static_cast<int>(planes[axis].size()));
      int i = 0;
      for (const double coordinate : planes[axis])
      {
        this->Slicer->SetCoordinate(axis, i++, coordinate);
      }
    }
    this->Filter->Update();
    return TopologyOf(this->Filter->GetOutput());
  }

  /// Adds the planes of the best ranks. Returns how many there were.
  int AddProposed(int maximum, Planes& planes)
  {
    vtkTable* table = this->Filter->GetUndecidedTable();
    std::set<vtkIdType> added;
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const int rank = table->GetValueByName(row, "PlaneRank").ToInt();
      if (rank >= 0 && rank < maximum && added.insert(rank).second)
      {
        planes[table->GetValueByName(row, "PlaneAxis").ToInt()].insert(
          table->GetValueByName(row, "PlaneCoordinate").ToDouble());
      }
    }
    return static_cast<int>(added.size());
  }

private:
  vtkNew<vtkOrthogonalSlicer> Slicer;
  vtkNew<vtkOrthogonalSliceReconstruction> Filter;
};

/// Number of planes with which the topology became right, 0 if it did not, and the last number
/// tried.
struct Outcome
{
  int Planes = 0;
  int Last = 0;
  std::ostringstream Curve;
};

void Note(const Planes& planes, const Topology& topology, Outcome& outcome)
{
  outcome.Last = Count(planes);
  outcome.Curve << " " << Count(planes) << ":" << topology.Components << "/" << topology.Genus;
}

void Propose(const Settings& settings, vtkPolyData* truth, const Topology& known, Outcome& outcome)
{
  Trial trial(truth);
  Planes planes = EqualPlanes(truth, settings.Start);
  while (Count(planes) <= 3 * settings.Maximum)
  {
    const Topology topology = trial.Run(planes);
    Note(planes, topology, outcome);
    if (topology == known)
    {
      outcome.Planes = Count(planes);
      return;
    }
    if (trial.AddProposed(settings.Step, planes) == 0)
    {
      return;
    }
  }
}

/// Equally spaced planes: FACTOR times as many on each axis each time, and MORE.
void Refine(const Settings& settings, vtkPolyData* truth, const Topology& known, int factor,
  int more, Outcome& outcome)
{
  Trial trial(truth);
  for (int number = settings.Start; number <= settings.Maximum; number = factor * number + more)
  {
    const Planes planes = EqualPlanes(truth, number);
    const Topology topology = trial.Run(planes);
    Note(planes, topology, outcome);
    if (topology == known)
    {
      outcome.Planes = Count(planes);
      return;
    }
  }
}

std::string Describe(const Outcome& outcome)
{
  return outcome.Planes > 0 ? std::to_string(outcome.Planes)
                            : "more than " + std::to_string(outcome.Last);
}

Settings Parse(int argc, char* argv[])
{
  Settings settings;
  for (int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    if (option == "--curve")
    {
      settings.Curve = true;
      continue;
    }
    if (option == "--help" || i + 1 == argc)
    {
      std::cout << Usage;
      std::exit(option == "--help" ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    const std::string value = argv[++i];
    if (option == "--data")
    {
      settings.Folder = value;
    }
    else if (option == "--cases")
    {
      std::istringstream names(value);
      for (std::string name; std::getline(names, name, ',');)
      {
        settings.Cases.push_back(name);
      }
    }
    else if (option == "--start" || option == "--most" || option == "--step")
    {
      int& number = option == "--start" ? settings.Start
        : option == "--most"            ? settings.Maximum
                                        : settings.Step;
      number = std::max(1, std::atoi(value.c_str()));
    }
    else
    {
      std::cout << Usage;
      std::exit(EXIT_FAILURE);
    }
  }
  return settings;
}

void Compare(const Settings& settings)
{
  std::vector<std::string> names = settings.Cases;
  if (names.empty())
  {
    names = ListCases(settings.Folder);
    // Label volumes are drawn plane by plane: their surface is not what was cut.
    names.erase(std::remove_if(names.begin(), names.end(),
                  [](const std::string& name) { return name.compare(0, 4, "lbl_") == 0; }),
      names.end());
  }
  std::cout << "| case | components / genus | start | proposed slices | spacing halved | "
               "equal spacing |\n"
               "|---|---|---|---|---|---|\n";
  for (const std::string& name : names)
  {
    const auto truth = ReadTruth(settings.Folder, name);
    const Topology known = TopologyOf(truth);
    Outcome proposed, halved, refined;
    Propose(settings, truth, known, proposed);
    Refine(settings, truth, known, 2, 0, halved);
    Refine(settings, truth, known, 1, 1, refined);
    std::cout << "| " << name << " | " << known.Components << " / " << known.Genus << " | "
              << 3 * settings.Start << " | " << Describe(proposed) << " | " << Describe(halved)
              << " | " << Describe(refined) << " |" << std::endl;
    if (settings.Curve)
    {
      std::cout << "  proposed" << proposed.Curve.str() << "\n  halved" << halved.Curve.str()
                << "\n  equal" << refined.Curve.str() << std::endl;
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  vtkObject::GlobalWarningDisplayOff();
  try
  {
    Compare(Parse(argc, argv));
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
