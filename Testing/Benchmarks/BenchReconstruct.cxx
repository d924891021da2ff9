// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Time and memory of vtkOrthogonalSliceReconstruction against the number of contour points.
 *
 *   BenchReconstruct [--points N ...] [--planes N] [--threads N] [--repeat N] [--float]
 *     [--patches smooth|fan|coons|all] [--edge-length L] [--stages]
 *
 * Without --planes their number grows with the square root of the number of points, so that there
 * is one crossing with the lattice for every four points or so, as in ordinary data. The object is
 * a lattice of 3 x 3 x 3 hollow spheres, cut by `planes` planes on each axis; circles have as many
 * vertices as give the wanted number of points in all. Every size runs in a process of its own, so
 * that peak memory is that size's. Seconds are the least of the repetitions, from vtkPolyData to
 * vtkPolyData. Memory is the growth of the process's peak over the time before the inputs were
 * made. With --stages a list follows of what each stage of the core takes in one more run.
 */

#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/ExecuteWithVtk.h"
#include "Bridge/ReadPieces.h"
#include "Core/ReconstructSorted.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
struct Arguments
{
  std::vector<double> Points{ 1e4, 1e5, 1e6, 1e7 };
  int Planes = 0;
  int Threads = 1;
  int Repeat = 3;
  bool Float = false;
  std::vector<std::string> Patches{ "smooth" };
  double EdgeLength = 0.25;
  bool Stages = false;
};

struct Circle
{
  int Axis;
  double Center[3];
  double Radius;
};

/// Sections of 27 hollow spheres of radius 0.45 and 0.25 in a lattice of spacing 1.
std::vector<Circle> MakeCircles(int axis, int planes)
{
  std::vector<Circle> circles;
  for (int p = 0; p < planes; ++p)
  {
    const double coordinate = 3.0 * (p + 0.4375) / planes;
    for (int cell = 0; cell < 9; ++cell)
    {
      const double height = coordinate - (std::floor(coordinate) + 0.5);
      for (const double radius : { 0.45, 0.25 })
      {
        if (std::abs(height) < 0.999 * radius)
        {
          Circle circle;
          circle.Axis = axis;
          circle.Center[axis] = coordinate;
          circle.Center[(axis + 1) % 3] = cell % 3 + 0.5;
          circle.Center[(axis + 2) % 3] = cell / 3 + 0.5;
          circle.Radius = std::sqrt(radius * radius - height * height);
          circles.push_back(circle);
        }
      }
    }
  }
  return circles;
}

int CountPlanes(const Arguments& arguments, double total)
{
  return arguments.Planes > 0 ? arguments.Planes : static_cast<int>(0.09 * std::sqrt(total) + 8.0);
}

vtkSmartPointer<vtkPolyData> MakeContours(int axis, const Arguments& arguments, double total)
{
  const std::vector<Circle> circles = MakeCircles(axis, CountPlanes(arguments, total));
  const int size = std::max(8, static_cast<int>(total / 3.0 / circles.size()));
  vtkNew<vtkPoints> points;
  points->SetDataType(arguments.Float ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(circles.size()) * size);
  vtkNew<vtkCellArray> lines;
  lines->AllocateExact(circles.size(), circles.size() * (size + 1));
  vtkIdType id = 0;
  for (const Circle& circle : circles)
  {
    lines->InsertNextCell(size + 1);
    const vtkIdType first = id;
    for (int i = 0; i < size; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * (i + 0.3) / size;
      double x[3] = { circle.Center[0], circle.Center[1], circle.Center[2] };
      x[(axis + 1) % 3] += circle.Radius * std::cos(angle);
      x[(axis + 2) % 3] += circle.Radius * std::sin(angle);
      points->SetPoint(id, x);
      lines->InsertCellPoint(id++);
    }
    lines->InsertCellPoint(first);
  }
  auto contours = vtkSmartPointer<vtkPolyData>::New();
  contours->SetPoints(points);
  contours->SetLines(lines);
  return contours;
}

double PeakMegabytes()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word)
  {
    if (word == "VmHWM:")
    {
      status >> kilobytes;
    }
  }
  return kilobytes / 1024.0;
}

/// Prints how long each stage takes, all its runs together, in the order of the stages.
void PrintStages(vtkOrthogonalSliceReconstruction* filter, bool doublePrecision)
{
  orthoslices::Polylines lines;
  for (int port = 0; port < 3; ++port)
  {
    orthoslices::ReadPieces(filter->GetInputDataObject(port, 0), port, doublePrecision, lines);
  }
  orthoslices::Options options;
  options.SinglePrecision = !doublePrecision;
  options.Patching.Method = filter->GetPatchType() == vtkOrthogonalSliceReconstruction::FAN
    ? orthoslices::PatchMethod::Fan
    : filter->GetPatchType() == vtkOrthogonalSliceReconstruction::COONS
    ? orthoslices::PatchMethod::Coons
    : orthoslices::PatchMethod::Smooth;
  options.Patching.EdgeLength = filter->GetEdgeLength();
  std::map<orthoslices::Stage, double> seconds;
  auto last = std::chrono::steady_clock::now();
  const auto observe = [&](orthoslices::Stage stage, const orthoslices::StageTables&,
                         const orthoslices::Reconstruction&)
  {
    const auto now = std::chrono::steady_clock::now();
    seconds[stage] += std::chrono::duration<double>(now - last).count();
    last = now;
  };
  orthoslices::ReconstructSorted(orthoslices::SortByPlanes(lines, orthoslices::FrameOptions()),
    options, orthoslices::ExecuteWithVtk(filter), observe);
  for (const auto& [stage, duration] : seconds)
  {
    std::printf("  %-24s %10.4f\n", orthoslices::NameOf(stage), duration);
  }
}

void RunSize(const Arguments& arguments, double total, const std::string& patches)
{
  const double before = PeakMegabytes();
  // Polygons with few vertices lie inside their circles, which is a small contradiction: no warning
  // here.
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  filter->SetPatchType(patches == "fan" ? vtkOrthogonalSliceReconstruction::FAN
      : patches == "coons"              ? vtkOrthogonalSliceReconstruction::COONS
                                        : vtkOrthogonalSliceReconstruction::SMOOTH);
  filter->SetEdgeLength(arguments.EdgeLength);
  double points = 0.0;
  double input = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    auto contours = MakeContours(axis, arguments, total);
    points += contours->GetNumberOfPoints();
    input += contours->GetActualMemorySize() / 1024.0;
    filter->SetInputData(axis, contours);
  }
  double seconds = HUGE_VAL;
  for (int i = 0; i < arguments.Repeat; ++i)
  {
    filter->Modified();
    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    seconds = std::min(
      seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  const double peak = PeakMegabytes() - before;
  vtkPolyData* surface = filter->GetOutput();
  std::printf("%-8s %10.0f %7d %12lld %10.4f %12.3f %10.1f %10.1f %8.2f %8lld\n", patches.c_str(),
    points, CountPlanes(arguments, total), static_cast<long long>(surface->GetNumberOfCells()),
    seconds, points / seconds * 1e-6, input, peak, peak / input,
    static_cast<long long>(surface->GetFieldData()->GetArray("NumberOfComponents")->GetTuple1(0)));
  if (arguments.Stages)
  {
    PrintStages(filter, !arguments.Float);
  }
  std::fflush(stdout);
}

Arguments Parse(int argc, char* argv[])
{
  Arguments arguments;
  for (int i = 1; i < argc; ++i)
  {
    const bool value = i + 1 < argc && argv[i + 1][0] != '-';
    if (std::strcmp(argv[i], "--points") == 0 && value)
    {
      arguments.Points.clear();
      while (i + 1 < argc && argv[i + 1][0] != '-')
      {
        arguments.Points.push_back(std::atof(argv[++i]));
      }
    }
    else if (std::strcmp(argv[i], "--planes") == 0 && value)
    {
      arguments.Planes = std::atoi(argv[++i]);
    }
    else if (std::strcmp(argv[i], "--threads") == 0 && value)
    {
      arguments.Threads = std::atoi(argv[++i]);
    }
    else if (std::strcmp(argv[i], "--repeat") == 0 && value)
    {
      arguments.Repeat = std::atoi(argv[++i]);
    }
    else if (std::strcmp(argv[i], "--float") == 0)
    {
      arguments.Float = true;
    }
    else if (std::strcmp(argv[i], "--stages") == 0)
    {
      arguments.Stages = true;
    }
    else if (std::strcmp(argv[i], "--patches") == 0 && value)
    {
      const std::string name = argv[++i];
      arguments.Patches = name == "all" ? std::vector<std::string>{ "smooth", "coons", "fan" }
                                        : std::vector<std::string>{ name };
    }
    else if (std::strcmp(argv[i], "--edge-length") == 0 && value)
    {
      arguments.EdgeLength = std::atof(argv[++i]);
    }
    else
    {
      std::fprintf(stderr,
        "usage: %s [--points N ...] [--planes N] [--threads N] [--repeat N] [--float]\n"
        "  [--patches smooth|fan|coons|all] [--edge-length L] [--stages]\n",
        argv[0]);
      std::exit(2);
    }
  }
  return arguments;
}
}

int main(int argc, char* argv[])
{
  const Arguments arguments = Parse(argc, argv);
  std::printf("%d threads, %s points\n", arguments.Threads, arguments.Float ? "float" : "double");
  std::printf("%-8s %10s %7s %12s %10s %12s %10s %10s %8s %8s\n", "patches", "points", "planes",
    "triangles", "seconds", "Mpoints/s", "input MB", "peak MB", "peak/in", "pieces");
  std::fflush(stdout);
  int status = 0;
  for (const double total : arguments.Points)
  {
    for (const std::string& patches : arguments.Patches)
    {
      const pid_t child = fork();
      if (child == 0)
      {
        vtkSMPTools::Initialize(arguments.Threads);
        RunSize(arguments, total, patches);
        _exit(0);
      }
      int result = 1;
      if (child < 0 || waitpid(child, &result, 0) != child || result != 0)
      {
        status = 1;
      }
    }
  }
  return status;
}
