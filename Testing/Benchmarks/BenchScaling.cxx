// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How the time of vtkOrthogonalSliceReconstruction grows with what an input has more of: points per
 * contour, contours per slice, planes per axis, contours in one cell of the grid, and points per
 * contour where there is one stack of slices only, without virtual slices (stack) and with them
 * (sparse).
 *
 *   BenchScaling [points] [contours] [planes] [cells] [stack] [rough]
 *     [horseshoe] [sparse] [N ...]
 *
 * Without names all tables are made, with numbers only the rows that begin with these. Each row has
 * about twice as many points as the one before. Seconds are those of the processor in one thread, so that they hardly depend on what else runs;
 * the last column is the time per point in terms of that of the first row. Where time is
 * proportional to the input, it stays near 1.
 */

#include "vtkOrthogonalSliceReconstruction.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Contours of one family, in the making.
class Family
{
public:
  explicit Family(int axis)
    : Axis(axis)
  {
  }

  using Function = std::function<double(double)>;

  /// A closed curve: radius and direction from the center are functions of a parameter from 0 to
  /// 2 pi along it.
  void Add(
    double coordinate, const double center[2], int vertices, const Function& radius,
    const Function& direction = [](double angle) { return angle; })
  {
    this->Lines->InsertNextCell(vertices + 1);
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (int i = 0; i < vertices; ++i)
    {
      const double angle = 2.0 * Pi * (i + 0.3) / vertices;
      double x[3];
      x[this->Axis] = coordinate;
      x[(this->Axis + 1) % 3] = center[0] + radius(angle) * std::cos(direction(angle));
      x[(this->Axis + 2) % 3] = center[1] + radius(angle) * std::sin(direction(angle));
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(x));
    }
    this->Lines->InsertCellPoint(first);
  }

  vtkSmartPointer<vtkPolyData> Get() const
  {
    auto contours = vtkSmartPointer<vtkPolyData>::New();
    contours->SetPoints(this->Points);
    contours->SetLines(this->Lines);
    return contours;
  }

private:
  int Axis;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
};

/// Sections of balls of radius 0.4 in a lattice of so many on each axis, whose spacing is 1.
vtkSmartPointer<vtkPolyData> CutBalls(int axis, int balls, int planes, int vertices)
{
  Family family(axis);
  for (int p = 0; p < planes; ++p)
  {
    const double coordinate = balls * (p + 0.4375) / planes;
    const double height = coordinate - (std::floor(coordinate) + 0.5);
    for (int ball = 0; ball < balls * balls && std::abs(height) < 0.39; ++ball)
    {
      const double center[2] = { ball % balls + 0.5, ball / balls + 0.5 };
      const double radius = std::sqrt(0.16 - height * height);
      family.Add(coordinate, center, vertices, [=](double) { return radius; });
    }
  }
  return family.Get();
}

/// Posts across z, so many on each side of a square, on z-planes alone.
vtkSmartPointer<vtkPolyData> CutPosts(int posts, int planes, int vertices)
{
  Family family(2);
  for (int p = 0; p < planes; ++p)
  {
    for (int post = 0; post < posts * posts; ++post)
    {
      const double center[2] = { post % posts + 0.5, post / posts + 0.5 };
      family.Add(p + 0.4375, center, vertices, [=](double) { return 0.3; });
    }
  }
  return family.Get();
}

/// A post with ridges that turn from slice to slice.
vtkSmartPointer<vtkPolyData> CutRidges(int planes, int vertices)
{
  Family family(2);
  const double center[2] = { 0.0, 0.0 };
  for (int p = 0; p < planes; ++p)
  {
    family.Add(0.2 * p, center, vertices,
      [=](double angle) { return 1.0 + 0.1 * std::sin(7.0 * angle + 0.4 * p); });
  }
  return family.Get();
}

/// A horseshoe, which no point inside sees as a whole.
vtkSmartPointer<vtkPolyData> CutHorseshoe(int planes, int vertices)
{
  Family family(2);
  const double center[2] = { 0.0, 0.0 };
  for (int p = 0; p < planes; ++p)
  {
    // Once around outside and back inside: the radius depends on where on the contour, not on the
    // direction alone.
    family.Add(
      0.2 * p, center, vertices,
      [=](double angle) { return angle < Pi ? 1.0 + 0.1 * std::sin(9.0 * angle) : 0.6; },
      [](double angle) { return angle < Pi ? 1.8 * angle : 1.8 * (2.0 * Pi - angle); });
  }
  return family.Get();
}

/// A round post whose contours are rough: those of neighbouring slices cross again and again.
vtkSmartPointer<vtkPolyData> CutRoughPost(int planes, int vertices)
{
  Family family(2);
  const double center[2] = { 0.0, 0.0 };
  for (int p = 0; p < planes; ++p)
  {
    family.Add(0.2 * p, center, vertices,
      [=](double angle) { return 1.0 + 1e-3 * std::sin(1e5 * (p + 1.0) * std::sin(angle)); });
  }
  return family.Get();
}

double ProcessorSeconds()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_utime.tv_sec + 1e-6 * usage.ru_utime.tv_usec;
}

/// The rows that are made; all if it is empty.
std::set<int> ChosenRows;

/// One table.
class Table
{
public:
  Table(const char* title, const char* what)
  {
    std::printf("\n%s\n%10s %10s %12s %10s %12s %8s\n", title, what, "points", "triangles",
      "seconds", "us/point", "ratio");
  }

  void Run(int value, const std::vector<vtkSmartPointer<vtkPolyData>>& families, bool isVirtual)
  {
    if (!ChosenRows.empty() && ChosenRows.count(value) == 0)
    {
      return;
    }
    vtkNew<vtkOrthogonalSliceReconstruction> filter;
    filter->SetVirtualSlices(isVirtual ? vtkOrthogonalSliceReconstruction::AUTOMATIC_VIRTUAL_SLICES
                                       : vtkOrthogonalSliceReconstruction::NO_VIRTUAL_SLICES);
    vtkIdType points = 0;
    for (std::size_t i = 0; i < families.size(); ++i)
    {
      points += families[i]->GetNumberOfPoints();
      filter->SetInputData(families.size() == 1 ? 2 : static_cast<int>(i), families[i]);
    }
    double seconds = HUGE_VAL;
    for (int repeat = 0; repeat < 3 && (repeat == 0 || seconds < 1.0); ++repeat)
    {
      filter->Modified();
      const double start = ProcessorSeconds();
      filter->Update();
      seconds = std::min(seconds, ProcessorSeconds() - start);
    }
    const double each = 1e6 * seconds / points;
    this->First = this->First > 0.0 ? this->First : each;
    std::printf("%10d %10lld %12lld %10.3f %12.3f %8.2f\n", value, static_cast<long long>(points),
      static_cast<long long>(filter->GetOutput()->GetNumberOfCells()), seconds, each,
      each / this->First);
    std::fflush(stdout);
  }

private:
  double First = 0.0;
};

using Families = std::vector<vtkSmartPointer<vtkPolyData>>;

Families CutBalls(int balls, int planes, int vertices)
{
  return { CutBalls(0, balls, planes, vertices), CutBalls(1, balls, planes, vertices),
    CutBalls(2, balls, planes, vertices) };
}

void SweepPoints()
{
  Table table("Points per contour: 8 balls, 32 planes on each axis", "vertices");
  for (const int vertices : { 500, 1000, 2000, 4000, 8000 })
  {
    table.Run(vertices, CutBalls(2, 32, vertices), true);
  }
}

void SweepContours()
{
  Table table("Contours per slice: balls in a lattice, 6 planes through each", "per slice");
  for (const int balls : { 3, 4, 5, 6, 8 })
  {
    table.Run(balls * balls, CutBalls(balls, 6 * balls, 60), true);
  }
}

void SweepPlanes()
{
  Table table("Planes per axis: 8 balls, 200 points per contour", "planes");
  for (const int planes : { 16, 32, 64, 128, 256 })
  {
    table.Run(planes, CutBalls(2, planes, 200), true);
  }
}

/// Posts on z-planes, and one plane of x and of y beside them all: four columns of cells, of which
/// one has all posts.
void SweepCells()
{
  Table table("Contours in one cell: posts between two planes, no virtual slices", "contours");
  for (const int posts : { 4, 6, 8, 11, 16, 23 })
  {
    Family x(0), y(1);
    const double center[2] = { 5.0, -2.0 };
    x.Add(-1.0, center, 8, [](double) { return 0.2; });
    y.Add(-1.0, center, 8, [](double) { return 0.2; });
    table.Run(posts * posts, { x.Get(), y.Get(), CutPosts(posts, 8, 24) }, false);
  }
}

void SweepRough()
{
  Table table("Points per rough contour in one stack of 8 slices, no virtual slices", "vertices");
  for (const int vertices : { 1000, 2000, 5000, 10000, 20000 })
  {
    table.Run(vertices, { CutRoughPost(8, vertices) }, false);
  }
}

void SweepHorseshoe()
{
  Table table("Points per contour of a horseshoe, one stack of 8 slices", "vertices");
  for (const int vertices : { 1000, 2000, 5000, 10000, 20000 })
  {
    table.Run(vertices, { CutHorseshoe(8, vertices) }, true);
  }
}

void SweepStack(bool isVirtual)
{
  Table table(isVirtual ? "Points per contour in one stack of 8 slices"
                        : "Points per contour in one stack of 8 slices, no virtual slices",
    "vertices");
  for (const int vertices : { 1000, 2000, 5000, 10000, 20000 })
  {
    table.Run(vertices, { CutRidges(8, vertices) }, isVirtual);
  }
}
}

int main(int argc, char* argv[])
{
  const std::map<std::string, void (*)()> sweeps{ { "points", SweepPoints },
    { "contours", SweepContours }, { "planes", SweepPlanes }, { "cells", SweepCells },
    { "horseshoe", SweepHorseshoe }, { "rough", SweepRough },
    { "sparse", []() { SweepStack(true); } }, { "stack", []() { SweepStack(false); } } };
  vtkObject::GlobalWarningDisplayOff(); // polygons with few vertices lie inside their circles
  vtkSMPTools::Initialize(1);
  std::set<std::string> names;
  for (int i = 1; i < argc; ++i)
  {
    if (std::atoi(argv[i]) > 0)
    {
      ChosenRows.insert(std::atoi(argv[i]));
    }
    else if (sweeps.count(argv[i]) > 0)
    {
      names.insert(argv[i]);
    }
    else
    {
      std::fprintf(stderr,
        "usage: %s [points] [contours] [planes] [cells] [stack] [rough] [horseshoe] [sparse] [N "
        "...]\n",
        argv[0]);
      return 2;
    }
  }
  for (const auto& [name, sweep] : sweeps)
  {
    if (names.empty() || names.count(name) > 0)
    {
      sweep();
    }
  }
  return 0;
}
