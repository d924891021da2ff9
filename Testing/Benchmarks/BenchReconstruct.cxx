// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Time and memory of vtkOrthogonalSliceReconstruction against the number of contour points.
 *
 *   BenchReconstruct [--points N ...] [--planes N] [--threads N] [--repeat N] [--float]
 *     [--patches smooth|fan|coons|all] [--edge-length L] [--few] [--stages]
 *
 * Without --planes their number grows with the square root of the number of points, so that there
 * is one crossing with the lattice for every four points or so, as in ordinary data. The object is
 * a lattice of 3 x 3 x 3 hollow spheres, cut by `planes` planes on each axis; circles have as many
 * vertices as give the wanted number of points in all. With --few triangles are few, as they are by
 * default; else all, in proportion to the input. Every size runs in a process of its own, so
 * that peak memory is that size's. Seconds are the least of the repetitions, from vtkPolyData to
 * vtkPolyData; below `memcpy` they are in terms of what copying as many bytes takes as the inputs
 * and outputs have, in memory that is there already. Memory is the growth of the process's peak over
 * the time before the inputs were made. With --stages a list follows of each step in one more run,
 * conversions included: its seconds, those of the processor in all threads, its peak memory, and
 * what part of the processor's time is in loops that run in parallel; then that of each loop, from
 * the end of the one before.
 */

#include "vtkOrthogonalSliceReconstruction.h"

#include "Bridge/ExecuteWithVtk.h"
#include "Bridge/ReadPieces.h"
#include "Bridge/WriteComponents.h"
#include "Bridge/WriteGraph.h"
#include "Bridge/WriteSurface.h"
#include "Core/ReconstructSorted.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <malloc.h>
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
  bool Few = false;
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

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of the processor, in all threads.
double ProcessorSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

/// Measures the steps of one run, one after another, and the loops of each.
class StepTimer
{
public:
  /// Memory is that beyond so many megabytes.
  explicit StepTimer(double before)
    : Before(before)
  {
    malloc_trim(0);
    this->Begin();
  }

  /// Ends a step: prints its seconds, its memory and its loops.
  void End(const char* name)
  {
    const double seconds = SecondsSince(this->Start);
    const double processor = ProcessorSeconds() - this->ProcessorStart;
    std::printf("  %-24s %9.4f %9.4f %8.1f %5.2f", name, seconds, processor,
      PeakMegabytes() - this->Before, this->InLoops / processor);
    double before = 0.0;
    for (const double loop : this->LoopEnds)
    {
      std::printf(" %.2f", (loop - before) / processor);
      before = loop;
    }
    std::printf("\n");
    this->Sum += seconds;
    this->ProcessorSum += processor;
    this->AllInLoops += this->InLoops;
    this->Begin();
  }

  void PrintSums() const
  {
    std::printf("  %-24s %9.4f %9.4f %8s %5.2f\n", "all", this->Sum, this->ProcessorSum, "",
      this->AllInLoops / this->ProcessorSum);
  }

  /// Begins a step, with what it needs in memory now.
  void Begin()
  {
    std::ofstream("/proc/self/clear_refs") << "5";
    this->Start = Clock::now();
    this->ProcessorStart = ProcessorSeconds();
    this->InLoops = 0.0;
    this->LoopEnds.clear();
  }

  /// Runs loops as another execution does, and measures them.
  orthoslices::Execution Wrap(const orthoslices::Execution& execution)
  {
    orthoslices::Execution wrapped = execution;
    wrapped.For = [this, execution](std::size_t count, const orthoslices::Execution::Range& run)
    {
      const double start = ProcessorSeconds();
      execution.For(count, run);
      this->InLoops += ProcessorSeconds() - start;
      this->LoopEnds.push_back(ProcessorSeconds() - this->ProcessorStart);
    };
    return wrapped;
  }

private:
  double Before;
  Clock::time_point Start;
  double ProcessorStart = 0.0;
  double InLoops = 0.0;
  double Sum = 0.0, ProcessorSum = 0.0, AllInLoops = 0.0; ///< of all steps
  std::vector<double> LoopEnds;
};

orthoslices::Options OptionsOf(vtkOrthogonalSliceReconstruction* filter, bool doublePrecision)
{
  orthoslices::Options options;
  options.SinglePrecision = !doublePrecision;
  options.Patching.Method = filter->GetPatchType() == vtkOrthogonalSliceReconstruction::FAN
    ? orthoslices::PatchMethod::Fan
    : filter->GetPatchType() == vtkOrthogonalSliceReconstruction::COONS
    ? orthoslices::PatchMethod::Coons
    : orthoslices::PatchMethod::Smooth;
  options.Patching.EdgeLength = filter->GetEdgeLength();
  options.Patching.Accuracy = filter->GetAccuracy();
  options.Patching.OwnAccuracy = filter->GetAutomaticAccuracy();
  return options;
}

/// Prints how long each step takes and its peak memory, in the order of the steps.
void PrintStages(vtkOrthogonalSliceReconstruction* filter, bool doublePrecision, double before)
{
  std::printf("  %-24s %9s %9s %8s %5s\n", "step", "seconds", "processor", "peak MB", "loops");
  StepTimer timer(before);
  const orthoslices::Execution execution = timer.Wrap(orthoslices::ExecuteWithVtk(filter));
  orthoslices::Polylines lines;
  for (int port = 0; port < 3; ++port)
  {
    orthoslices::ReadPieces(filter->GetInputDataObject(port, 0), port, doublePrecision, lines);
  }
  timer.End("ReadPieces");
  orthoslices::SortedSlices sorted = orthoslices::SortByPlanes(lines, orthoslices::FrameOptions());
  lines = orthoslices::Polylines();
  timer.End("SortByPlanes");
  orthoslices::Reconstruction result =
    orthoslices::ReconstructSorted(std::move(sorted), OptionsOf(filter, doublePrecision), execution,
      [&](orthoslices::Stage stage, const orthoslices::StageTables&,
        const orthoslices::Reconstruction&) { timer.End(orthoslices::NameOf(stage)); });
  timer.Begin();
  vtkNew<vtkPolyData> graph, surface;
  vtkNew<vtkTable> components;
  orthoslices::WriteGraph(result, execution, doublePrecision, graph);
  timer.End("WriteGraph");
  orthoslices::WriteSurface(
    std::move(result), execution, doublePrecision, { true, false }, 0.0, surface);
  timer.End("WriteSurface");
  orthoslices::WriteComponentTable(surface, false, orthoslices::Ranks(), execution, components);
  timer.End("WriteComponentTable");
  timer.PrintSums();
}

/// The seconds that it takes to copy so many megabytes in memory.
double SecondsOfCopy(double megabytes)
{
  const std::size_t size = static_cast<std::size_t>(1024.0 * 1024.0 * megabytes);
  const std::vector<char> from(size, 1);
  std::vector<char> to(size, 2);
  double least = HUGE_VAL;
  for (int i = 0; i < 5; ++i)
  {
    const auto start = Clock::now();
    std::memcpy(to.data(), from.data(), size);
    least = std::min(least, SecondsSince(start));
  }
  return to[size / 2] == 1 ? least : HUGE_VAL;
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
  filter->SetAutomaticAccuracy(arguments.Few); // else triangles are in proportion to the input
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
  double output = 0.0;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    output += filter->GetOutputDataObject(port)->GetActualMemorySize() / 1024.0;
  }
  const double copies = seconds / SecondsOfCopy(input + output);
  std::printf("%-8s %10.0f %7d %12lld %10.4f %12.3f %10.1f %10.1f %8.1f %10.1f %8.2f %8lld\n",
    patches.c_str(), points, CountPlanes(arguments, total),
    static_cast<long long>(surface->GetNumberOfCells()), seconds,
    surface->GetNumberOfCells() / seconds * 1e-6, input, output, copies, peak, peak / input,
    static_cast<long long>(surface->GetFieldData()->GetArray("NumberOfComponents")->GetTuple1(0)));
  if (arguments.Stages)
  {
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      filter->GetOutputDataObject(port)->Initialize();
    }
    PrintStages(filter, !arguments.Float, before);
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
    else if (std::strcmp(argv[i], "--few") == 0)
    {
      arguments.Few = true;
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
        "  [--patches smooth|fan|coons|all] [--edge-length L] [--few] [--stages]\n",
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
  std::printf("%-8s %10s %7s %12s %10s %12s %10s %10s %8s %10s %8s %8s\n", "patches", "points",
    "planes", "triangles", "seconds", "Mtri/s", "input MB", "output MB", "memcpy", "peak MB",
    "peak/in", "pieces");
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
