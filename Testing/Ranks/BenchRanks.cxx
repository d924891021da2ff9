// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Several processes against one: work, waiting and messages.
 *
 *   mpirun -np N BenchRanks [points] [planes] [few]
 *
 * The object is a lattice of 3 x 3 x 3 balls, cut by `planes` planes on each axis (DEFAULT: as
 * BenchReconstruct) into circles with `points` vertices in all (DEFAULT: a million). With `few`, which
 * needs both numbers, triangles are few, as they are by default of the filter; else all. First the first
 * process makes the surface alone, then all together, each from its own part of the contours. Seconds
 * are those of the processor: those at work, and apart from them those in exchanges, where MPI waits
 * busily; memory is the growth of a process's peak (of the first one, from the run alone on). So they say how work is divided, also where processes share a processor.
 */

#include "vtkCellArray.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkOrthogonalSliceReconstruction.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace
{
double ProcessorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The most memory that this process has had, in MB, and has now.
double Megabytes(const char* what)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word)
  {
    if (word == what)
    {
      status >> kilobytes;
    }
  }
  return kilobytes / 1024.0;
}

/// Counts what goes through the collective calls.
class CountingCommunicator : public vtkMPICommunicator
{
public:
  static CountingCommunicator* New();
  vtkTypeMacro(CountingCommunicator, vtkMPICommunicator);

  int AllGatherVoidArray(const void* send, void* receive, vtkIdType length, int type) override
  {
    const double start = ProcessorSeconds();
    const int done = this->Superclass::AllGatherVoidArray(send, receive, length, type);
    this->Seconds += ProcessorSeconds() - start;
    return done;
  }
  int AllGatherVVoidArray(const void* send, void* receive, vtkIdType length, vtkIdType* lengths,
    vtkIdType* offsets, int type) override
  {
    const double start = ProcessorSeconds();
    const int done =
      this->Superclass::AllGatherVVoidArray(send, receive, length, lengths, offsets, type);
    this->Seconds += ProcessorSeconds() - start;
    this->Sent.push_back(static_cast<double>(length));
    return done;
  }

  double Seconds = 0.0;
  std::vector<double> Sent; ///< bytes, in the order of the exchanges
};
vtkStandardNewMacro(CountingCommunicator);

/// Circles of one axis; of `ranks` parts of them, one.
vtkSmartPointer<vtkPolyData> MakeContours(int axis, int planes, double total, int rank, int ranks)
{
  struct Circle
  {
    double Center[3];
    double Radius;
  };
  std::vector<Circle> circles;
  for (int p = 0; p < planes; ++p)
  {
    const double coordinate = 3.0 * (p + 0.4375) / planes;
    const double height = coordinate - (std::floor(coordinate) + 0.5);
    for (int ball = 0; ball < 9 && std::abs(height) < 0.449; ++ball)
    {
      Circle circle;
      circle.Center[axis] = coordinate;
      circle.Center[(axis + 1) % 3] = ball % 3 + 0.5;
      circle.Center[(axis + 2) % 3] = ball / 3 + 0.5;
      circle.Radius = std::sqrt(0.45 * 0.45 - height * height);
      circles.push_back(circle);
    }
  }
  const int size = std::max(8, static_cast<int>(total / 3.0 / circles.size()));
  const std::size_t first = circles.size() * rank / ranks,
                    last = circles.size() * (rank + 1) / ranks;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (std::size_t c = first; c < last; ++c)
  {
    lines->InsertNextCell(size + 1);
    for (int i = 0; i <= size; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * (i % size + 0.3) / size;
      double x[3] = { circles[c].Center[0], circles[c].Center[1], circles[c].Center[2] };
      x[(axis + 1) % 3] += circles[c].Radius * std::cos(angle);
      x[(axis + 2) % 3] += circles[c].Radius * std::sin(angle);
      const vtkIdType start = points->GetNumberOfPoints();
      lines->InsertCellPoint(i < size ? points->InsertNextPoint(x) : start - size);
    }
  }
  auto contours = vtkSmartPointer<vtkPolyData>::New();
  contours->SetPoints(points);
  contours->SetLines(lines);
  return contours;
}

struct Input
{
  double Total;
  int Planes;
  bool Few; ///< triangles, as by default; else all
};

struct Run
{
  double Wall, Work;
  vtkIdType Triangles, Points;
};

Run Reconstruct(vtkMultiProcessController* controller, const Input& input, int rank, int ranks)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  filter->SetController(controller);
  filter->SetAutomaticAccuracy(input.Few);
  for (int axis = 0; axis < 3; ++axis)
  {
    filter->SetInputData(axis, MakeContours(axis, input.Planes, input.Total, rank, ranks));
  }
  const auto start = std::chrono::steady_clock::now();
  const double before = ProcessorSeconds();
  filter->UpdatePiece(rank, ranks, 0);
  return { std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
    ProcessorSeconds() - before, filter->GetOutput()->GetNumberOfCells(),
    filter->GetOutput()->GetNumberOfPoints() };
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv, 0);
  vtkNew<CountingCommunicator> communicator;
  communicator->CopyFrom(vtkMPICommunicator::GetWorldCommunicator());
  controller->SetCommunicator(communicator);
  vtkObject::GlobalWarningDisplayOff();
  vtkSMPTools::Initialize(1);
  const double total = argc > 1 ? std::atof(argv[1]) : 1e6;
  const int planes =
    argc > 2 ? std::atoi(argv[2]) : static_cast<int>(0.09 * std::sqrt(total) + 8.0);
  const Input input{ total, planes, argc > 3 && std::string(argv[3]) == "few" };
  const int rank = controller->GetLocalProcessId(), ranks = controller->GetNumberOfProcesses();
  double alone = 0.0;
  if (rank == 0)
  {
    const double least = Megabytes("VmRSS:");
    const Run run = Reconstruct(nullptr, input, 0, 1);
    alone = run.Work;
    std::printf("alone: %.2f s at work, %.2f s wall, %.0f MB, %lld triangles, %lld points\n",
      run.Work, run.Wall, Megabytes("VmHWM:") - least, static_cast<long long>(run.Triangles),
      static_cast<long long>(run.Points));
  }
  controller->Barrier();
  communicator->Sent.clear();
  communicator->Seconds = 0.0;
  const double least = Megabytes("VmRSS:");
  const Run run = Reconstruct(controller, input, rank, ranks);
  const double work = run.Work - communicator->Seconds;
  double most = 0.0;
  controller->AllReduce(&work, &most, 1, vtkCommunicator::MAX_OP);
  for (int turn = 0; turn < ranks; ++turn)
  {
    controller->Barrier();
    if (turn == rank)
    {
      std::printf(
        "process %d: %.2f s at work, %.2f s in exchanges, %.2f s wall, %.0f MB, %lld triangles, "
        "%lld points, bytes sent:",
        rank, work, communicator->Seconds, run.Wall, Megabytes("VmHWM:") - least,
        static_cast<long long>(run.Triangles), static_cast<long long>(run.Points));
      for (const double bytes : communicator->Sent)
      {
        std::printf(" %.0f", bytes);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  controller->Barrier();
  if (rank == 0)
  {
    std::printf("%d processes: 1 / %.2f of the work on the busiest\n", ranks, alone / most);
  }
  controller->Finalize();
  return 0;
}
