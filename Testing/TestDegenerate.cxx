// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   contours in singular position, each as small as it can be drawn
 *
 * Every one has to give a surface that is closed, 2-manifold, oriented and embedded (G1 to G3, G6),
 * in both precisions, with directions trusted or not, and with all of its axes permuted; or it is
 * refused with a problem that names the place.
 */

#include "Support/CheckEmbedding.h"
#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Perturbations.h"
#include "Support/RandomInput.h"
#include "Support/ReconstructionMesh.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkOrthogonalSlicer.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
struct Outcome
{
  Reconstruction Core;
  TriangleMesh Mesh;
};

Outcome RunCore(PieceSets sets, Options options)
{
  if (options.SinglePrecision)
  {
    RoundToFloat(sets);
  }
  Outcome run;
  run.Core = Reconstruct(std::move(sets), options, Execution());
  run.Mesh = MeshOf(run.Core);
  return run;
}

constexpr std::array<Index, 3> NoContours{ 0, 0, 0 };

/// All guarantees in all settings; the run in double precision, by nesting.
Outcome ExpectSound(const PieceSets& input)
{
  PieceSets sets = input;
  for (int turn = 0; turn < 3; ++turn)
  {
    for (const bool single : { false, true })
    {
      for (const Orientation orientation : { Orientation::ByNesting, Orientation::AsDrawn })
      {
        SCOPED_TRACE(std::string(single ? "float" : "double") +
          (orientation == Orientation::AsDrawn ? ", as drawn" : ", by nesting") + ", turned " +
          std::to_string(turn) + "\n" + (sets[0].U.size() < 200 ? ToText(sets) : ""));
        Options options;
        options.SinglePrecision = single;
        options.Orient = orientation;
        const Outcome run = RunCore(sets, options);
        // Refused only where nothing is left, as of contours that are flat, or become so as float.
        EXPECT_TRUE(!run.Core.Refused || run.Core.ContourCount == NoContours);
        EXPECT_EQ(DescribeFlaws(run.Mesh), "");
      }
    }
    PermuteAxes(sets);
  }
  return RunCore(input, Options());
}

Outcome ExpectSound(const std::string& text) { return ExpectSound(ParsePieces(text)); }

/// Squares of half-width `size` around the origin on the planes, on all axes.
std::string Squares(const std::vector<double>& planes, double size)
{
  const std::string p = std::to_string(size), n = std::to_string(-size);
  std::string text;
  for (const char axis : { 'x', 'y', 'z' })
  {
    for (const double plane : planes)
    {
      text += std::string(1, axis) + "=" + std::to_string(plane) + ": " + n + "," + n + " " + p +
        "," + n + " " + p + "," + p + " " + n + "," + p + "\n";
    }
  }
  return text;
}

/// A regular polygon on the plane.
void AddCircle(Pieces& pieces, double plane, double u, double v, double radius, int corners)
{
  std::vector<std::array<double, 2>> vertices;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * (i + 0.5) / corners;
    vertices.push_back({ u + radius * std::cos(angle), v + radius * std::sin(angle) });
  }
  AddPiece(pieces, vertices, plane);
}

/// A ball cut by the planes of all axes.
PieceSets Ball(const std::vector<double>& planes, double radius, int corners)
{
  PieceSets sets = EmptySets();
  for (Pieces& pieces : sets)
  {
    for (const double plane : planes)
    {
      if (std::abs(plane) < radius)
      {
        AddCircle(pieces, plane, 0, 0, std::sqrt(radius * radius - plane * plane), corners);
      }
    }
  }
  return sets;
}

std::int64_t CountTriangles(const Outcome& run)
{
  return static_cast<std::int64_t>(run.Mesh.Triangles.size());
}
}

//----------------------------------------------------------------------------
// On the lattice.

TEST(Degenerate, EdgesOfContoursOnLatticeLines)
{
  // The planes -1 and 1 contain the faces of the box.
  EXPECT_GT(CountTriangles(ExpectSound(Squares({ -1, 0, 1 }, 1))), 0);
  EXPECT_GT(CountTriangles(ExpectSound(Squares({ -1, 1 }, 1))), 0);
  EXPECT_GT(CountTriangles(ExpectSound(Squares({ -2, -1, 0, 1, 2 }, 1))), 0);
}

//----------------------------------------------------------------------------
TEST(Degenerate, VerticesOnLatticeLines)
{
  std::string text;
  for (const char axis : { 'x', 'y', 'z' })
  {
    for (const char* plane : { "-1", "0", "1" })
    {
      text += std::string(1, axis) + "=" + plane +
        ": -2,-1 -1,-2 0,-2 1,-2 2,-1 2,0 2,1 1,2 0,2 -1,2 -2,1 -2,0\n";
    }
  }
  EXPECT_GT(CountTriangles(ExpectSound(text)), 0);
}

//----------------------------------------------------------------------------
TEST(Degenerate, ContoursThroughGridVertices)
{
  std::string text;
  for (const char axis : { 'x', 'y', 'z' })
  {
    // Slanted edges through (1, 0) and (0, 1), and vertices on (2, 0) and (0, 2).
    text += std::string(1, axis) + "=0: 2,0 0,2 -2,0 0,-2\n";
    text += std::string(1, axis) + "=1: 1,0 0,1 -1,0 0,-1\n";
    text += std::string(1, axis) + "=-1: 1,0 0,1 -1,0 0,-1\n";
    text += std::string(1, axis) + "=2: 9,9 10,9 10,10\n";
  }
  EXPECT_GT(CountTriangles(ExpectSound(text)), 0);
}

//----------------------------------------------------------------------------
TEST(Degenerate, ArcsAlongGridLinesForthAndBack)
{
  // Each contour runs along a line of the grid, leaves it and comes back to it.
  EXPECT_GT(CountTriangles(ExpectSound(
              "x=0: -2,0 -1,0 0,0 1,0 2,0 2,2 1,0.5 0,2 -1,0.5 -2,2; y=0: -2,-2 2,-2 2,2 -2,2; "
              "z=0: -2,0 2,0 2,1 1,0 0,1 -1,0 -2,1; z=1: -2,-2 2,-2 2,2 -2,2")),
    0);
}

//----------------------------------------------------------------------------
// Meshes, by the slicer and its contours back into the filter.

namespace
{
void SetPlanes(vtkOrthogonalSlicer* slicer, const std::array<std::vector<double>, 3>& planes)
{
  slicer->SetPlaneModeToCoordinates();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < planes[axis].size(); ++i)
    {
      slicer->SetCoordinate(axis, static_cast<int>(i), planes[axis][i]);
    }
  }
}

/// The surface from slices of a mesh in one precision.
vtkSmartPointer<vtkPolyData> ExpectSoundSlices(
  vtkPolyData* mesh, const std::array<std::vector<double>, 3>& planes, int precision)
{
  vtkNew<vtkOrthogonalSlicer> slicer;
  slicer->SetInputData(mesh);
  slicer->SetOutputPointsPrecision(precision);
  SetPlanes(slicer, planes);
  FilterRun run;
  for (int port = 0; port < 3; ++port)
  {
    run.Filter->SetInputConnection(port, slicer->GetOutputPort(port));
  }
  vtkSmartPointer<vtkPolyData> surface = run.Update();
  EXPECT_EQ(DescribeFlaws(MeshOf(surface)), "");
  EXPECT_TRUE(surface->GetNumberOfCells() > 0 || !run.Errors.empty());
  return surface;
}

void ExpectSoundSlicesOfCube(const std::vector<double>& planes)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2);
  cube->SetYLength(2);
  cube->SetZLength(2);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    ExpectSoundSlices(triangles->GetOutput(), { planes, planes, planes }, precision);
  }
}
}

TEST(Degenerate, PlanesAlongFacesOfTheMesh)
{
  ExpectSoundSlicesOfCube({ -1, 0, 1 });
  ExpectSoundSlicesOfCube({ -1, -0.5, 0.5, 1 });
  ExpectSoundSlicesOfCube({ -1, 1 });
}

//----------------------------------------------------------------------------
TEST(Degenerate, PlanesNextToFacesOfTheMesh)
{
  const double e = 0x1p-50;
  ExpectSoundSlicesOfCube({ -1 - e, 0, 1 + e });
  ExpectSoundSlicesOfCube({ -1 + e, 0, 1 - e });
  ExpectSoundSlicesOfCube({ -1 + 1e-4, 0, 1 - 1e-4 });
}

//----------------------------------------------------------------------------
namespace
{
/// Coordinates of the mesh's points along an axis, ascending, each at least `least` after the last.
std::vector<double> PointCoordinates(vtkPolyData* mesh, int axis, double minimum)
{
  std::set<double> all;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    all.insert(mesh->GetPoint(i)[axis]);
  }
  std::vector<double> chosen;
  for (const double x : all)
  {
    if (chosen.empty() || x >= chosen.back() + minimum)
    {
      chosen.push_back(x);
    }
  }
  return chosen;
}
}

/// Every plane passes through a vertex of a sphere: the z-planes through whole rings and the poles.
TEST(Degenerate, PlanesThroughVerticesOfTheMesh)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(17);
  sphere->Update();
  for (const double minimum : { 0.02, 0.1, 0.3 })
  {
    SCOPED_TRACE(minimum);
    std::array<std::vector<double>, 3> planes;
    for (int axis = 0; axis < 3; ++axis)
    {
      planes[axis] = PointCoordinates(sphere->GetOutput(), axis, minimum);
    }
    for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
    {
      const SurfaceCheck check =
        CheckSurface(MeshOf(ExpectSoundSlices(sphere->GetOutput(), planes, precision)));
      EXPECT_EQ(check.Components, 1);
      EXPECT_EQ(check.TotalGenus(), 0);
    }
  }
}

//----------------------------------------------------------------------------
// Contours that repeat something.

TEST(Degenerate, SegmentsWithoutLength)
{
  EXPECT_EQ(CountTriangles(ExpectSound("x=0: -1,-1 -1,-1 1,-1 1,-1 1,-1 1,1 -1,1 -1,1 -1,-1; "
                                       "y=0: -1,-1 1,-1 1,1 1,1 -1,1; z=0: -1,-1 1,-1 1,1 -1,1")),
    CountTriangles(ExpectSound(Squares({ 0 }, 1))));
}

//----------------------------------------------------------------------------
TEST(Degenerate, LoopsTwiceForwardReversedAndFromAnotherVertex)
{
  const std::string once = Squares({ 0 }, 1);
  for (const char* copy : { "x=0: -1,-1 1,-1 1,1 -1,1", "x=0: -1,1 1,1 1,-1 -1,-1",
         "x=0: 1,-1 1,1 -1,1 -1,-1", "x=0: 1,1 1,-1 -1,-1 -1,1", "y=0: -1,-1 0,-1 1,-1 1,1 -1,1" })
  {
    const Outcome run = ExpectSound(once + copy + "; " + copy);
    EXPECT_GT(CountTriangles(run), 0) << copy;
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, NestedToDepthFive)
{
  for (const bool planes : { false, true })
  {
    std::string text;
    for (const double size : { 1.0, 2.0, 3.0, 4.0, 5.0 })
    {
      text += Squares({ 0 }, size);
      text += planes ? Squares({ size - 0.5 }, 5.5 - size) : "";
    }
    const Outcome run = ExpectSound(text);
    EXPECT_GT(CountTriangles(run), 0);
    EXPECT_TRUE(planes || CheckSurface(run.Mesh).Components == 5);
  }
}

//----------------------------------------------------------------------------
// Planes and sizes.

TEST(Degenerate, PlanesCloserThanTheTolerance)
{
  const Outcome run =
    ExpectSound(Squares({ 0 }, 1) + "x=1e-6: -1,-1 1,-1 1,1 -1,1; z=-1e-6: -1,-1 1,-1 1,1 -1,1");
  EXPECT_EQ(run.Core.Grid.Count(0), 1);
  EXPECT_EQ(run.Core.Grid.Count(2), 1);
  // A chain of them, each closer to the next than the tolerance.
  std::string chain = Squares({ 0 }, 1);
  for (int i = 1; i < 30; ++i)
  {
    chain += "x=" + std::to_string(1e-6 * i * 20) + ": -1,-1 1,-1 1,1 -1,1\n";
  }
  EXPECT_GT(CountTriangles(ExpectSound(chain)), 0);
  Options options;
  options.PlaneTolerance = 0.0;
  const Outcome exact =
    RunCore(ParsePieces(Squares({ 0 }, 1) + "x=1e-300: -1,-1 1,-1 1,1 -1,1"), options);
  EXPECT_EQ(DescribeFlaws(exact.Mesh), "");
}

//----------------------------------------------------------------------------
TEST(Degenerate, SmallFeaturesFarFromTheOrigin)
{
  // In float, 1e6 has steps of 0.06: all planes become one, and most contours nothing.
  for (const double feature : { 1e-3, 1e-1, 1.0, 10.0 })
  {
    PieceSets sets = Ball({ -0.75, -0.25, 0.25, 0.75 }, 1.0, 24);
    Scale(sets, feature);
    Translate(sets, { 1e6, -1e6, 1e6 });
    SCOPED_TRACE(feature);
    EXPECT_GT(CountTriangles(ExpectSound(sets)), 0);
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, SmallAndLargeExtents)
{
  for (const double extent : { 1e-30, 1e-9, 1.0, 1e9, 1e30 })
  {
    PieceSets sets = Ball({ -0.75, -0.25, 0.25, 0.75 }, 1.0, 24);
    Scale(sets, extent);
    SCOPED_TRACE(extent);
    const Outcome run = ExpectSound(sets);
    EXPECT_EQ(CheckSurface(run.Mesh).Components, 1);
    EXPECT_EQ(CheckSurface(run.Mesh).TotalGenus(), 0);
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, FlatAndThin)
{
  for (const double thin : { 1e-3, 1e-6, 1e-9 })
  {
    PieceSets sets = Ball({ -0.75, -0.25, 0.25, 0.75 }, 1.0, 24);
    for (Pieces& pieces : sets)
    {
      std::vector<double>& z = pieces.Axis == 0 ? pieces.V : pieces.Axis == 1 ? pieces.U : pieces.W;
      for (double& value : z)
      {
        value *= thin;
      }
    }
    SCOPED_TRACE(thin);
    EXPECT_GT(CountTriangles(ExpectSound(sets)), 0);
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, OnePlaneOnEachAxis)
{
  const Outcome run = ExpectSound(Squares({ 0 }, 1));
  EXPECT_EQ(run.Core.Cycles.Count(), 8);
  // The planes do not meet within the contours: solids of their own, or one around the corner.
  const Outcome apart = ExpectSound("x=9: 0,0 1,0 1,1; y=9: 0,0 1,0 1,1; z=9: 0,0 1,0 1,1");
  EXPECT_GT(CheckSurface(apart.Mesh).TotalVolume(), 0.0);
}

//----------------------------------------------------------------------------
// Contours that touch.

TEST(Degenerate, TwoContoursThatTouchInAPoint)
{
  const std::string frame = Squares({ -1, 0, 1 }, 2);
  for (const char* pair : { "z=0.5: -1,-1 0.5,0.5 -1,1; z=0.5: 1,-1 0.5,0.5 1,1",
         "z=0.5: -1,-1 0,0 -1,1; z=0.5: 1,-1 0,0 1,1",
         "z=0.5: -1,-1 0,-1 0,1 -1,1; z=0.5: 1,-1 0,0 1,1",
         "z=0.5: -2,-2 2,-2 2,2 -2,2; z=0.5: -2,-2 0,-0.5 -0.5,0" })
  {
    EXPECT_GT(CountTriangles(ExpectSound(frame + pair)), 0) << pair;
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, TwoContoursThatTouchAlongAnEdge)
{
  const std::string frame = Squares({ -1, 0, 1 }, 2);
  for (const char* pair : { "z=0.5: -1.5,-1 0,-1 0,1 -1.5,1; z=0.5: 1.5,-1 1.5,1 0,1 0,-1",
         "z=0.5: -1.5,-1 0.5,-1 0.5,1 -1.5,1; z=0.5: 1.5,-1 1.5,1 0.5,1 0.5,-1",
         "z=0.5: -1.5,-1 0.5,-1 0.5,1 -1.5,1; z=0.5: 1.5,-0.5 1.5,2 0.5,2 0.5,-0.5",
         "z=0.5: -2,-2 2,-2 2,2 -2,2; z=0.5: -2,-2 1,-2 1,1 -2,1" })
  {
    EXPECT_GT(CountTriangles(ExpectSound(frame + pair)), 0) << pair;
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, FigureEight)
{
  const std::string frame = Squares({ -1, 0, 1 }, 2);
  for (const char* eight : { "z=0.5: -1.5,-1.5 1.5,1.5 1.5,-1.5 -1.5,1.5",
         "z=0.5: -1.5,-1.5 0,0 1.5,1.5 1.5,-1.5 0,0 -1.5,1.5",
         "z=0.5: -1.5,-1.5 0.25,0.25 1.5,1.5 1.5,-1.5 0.25,0.25 -1.5,1.5",
         "z=0.5: -1,-1 1,-1 1,1 -1,1 -1,-1 1,-1 1,1 -1,1",
         "z=0.5: 0,1 -0.6,-0.8 0.95,0.3 -0.95,0.3 0.6,-0.8" })
  {
    EXPECT_GT(CountTriangles(ExpectSound(frame + eight)), 0) << eight;
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, SpikesThatGoBackExactly)
{
  const std::string frame = Squares({ -1, 0, 1 }, 2);
  for (const char* spike : { "z=0.5: -1.5,-1.5 1.5,-1.5 1.5,1.5 1.8,1.8 1.5,1.5 -1.5,1.5",
         "z=0.5: -1.5,-1.5 0.5,-1.5 0.5,1 0.5,-1.5 1.5,-1.5 1.5,1.5 -1.5,1.5",
         "z=0.5: -1.5,-1.5 0,-1.5 0,1 0,-1.5 1.5,-1.5 1.5,1.5 -1.5,1.5",
         "z=0.5: -1.5,-1.5 1.5,1.5 0.5,0.5 1.75,1.75 -1.5,1.5",
         "z=0.5: -1.5,-1.5 1.5,1.5 -1.5,-1.5 1.5,1.5" })
  {
    EXPECT_GT(CountTriangles(ExpectSound(frame + spike)), 0) << spike;
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, ContoursOfThreeVertices)
{
  EXPECT_GT(
    CountTriangles(ExpectSound("x=0: -1,-1 1,-1 0,1; y=0: -1,-1 1,-1 0,1; z=0: -1,-1 1,-1 0,1")),
    0);
  // On one line: no area.
  EXPECT_EQ(
    DescribeFlaws(ExpectSound("x=0: -1,-1 0,0 1,1; y=0: -1,-1 1,-1 0,1; z=0: -1,-1 1,-1 0,1").Mesh),
    "");
  EXPECT_EQ(
    CountTriangles(ExpectSound("x=0: -1,0 0,0 1,0; y=0: -1,0 0,0 1,0; z=0: -1,0 0,0 1,0")), 0);
}

//----------------------------------------------------------------------------
TEST(Degenerate, AlmostNothingBetweenVertices)
{
  // Two vertices and a spike that differ in the last bits only.
  const std::string frame = Squares({ -1, 0, 1 }, 2);
  const std::string e = "1.0000000000000002";
  for (const std::string& contour :
    { "z=0.5: -1,-1 1,-1 1,1 1," + e + " -1,1", "z=0.5: -1,-1 1.5,-1 -1," + e + " 1.5,1 -1,1",
      "z=0.5: -" + e + ",-1 " + e + ",-1 1,1 -1,1",
      "z=0.5: -1,-1 " + e + ",-1 1,1.5 1,-0.5 " + e + ",1.7 -1,1" })
  {
    EXPECT_GT(CountTriangles(ExpectSound(frame + contour)), 0) << contour;
  }
}

//----------------------------------------------------------------------------
// Many planes, many vertices.

TEST(Degenerate, ThousandsOfPlanesWithOneTinyContour)
{
  PieceSets sets = EmptySets();
  for (int i = 0; i < 3000; ++i)
  {
    AddCircle(sets[2], i, 0.0, 0.0, 0.3, 3);
  }
  AddPiece(sets[0], { { -1, -1 }, { 1, -1 }, { 1, 3001 }, { -1, 3001 } }, 0.0);
  AddPiece(sets[1], { { -1, -1 }, { 3001, -1 }, { 3001, 1 }, { -1, 1 } }, 0.0);
  Options options;
  const Outcome run = RunCore(sets, options);
  EXPECT_EQ(DescribeFlaws(run.Mesh), "");
  EXPECT_EQ(run.Core.Grid.Count(2), 3000);
}

//----------------------------------------------------------------------------
TEST(Degenerate, HugeContoursOnOnePlane)
{
  PieceSets sets = EmptySets();
  for (Pieces& pieces : sets)
  {
    AddCircle(pieces, 0.0, 0.0, 0.0, 1.0, 1200);
  }
  for (const bool single : { false, true })
  {
    Options options;
    options.SinglePrecision = single;
    const Outcome run = RunCore(sets, options);
    EXPECT_EQ(DescribeFlaws(run.Mesh), "");
    EXPECT_EQ(CheckSurface(run.Mesh).Components, 1);
    EXPECT_GT(CountTriangles(run), 6000);
  }
}

//----------------------------------------------------------------------------
TEST(Degenerate, CombThatCrossesOneGridEdgeThousandsOfTimes)
{
  PieceSets sets = EmptySets();
  std::vector<std::array<double, 2>> comb;
  for (int i = 0; i < 1000; ++i)
  {
    const double u = -1.0 + 0.002 * i;
    comb.push_back({ u, i % 2 == 0 ? -1.0 : 1.0 });
  }
  comb.push_back({ 0.998, -2.0 });
  comb.push_back({ -1.0, -2.0 });
  AddPiece(sets[2], comb, 0.0);
  AddPiece(sets[0], { { -2, -2 }, { 2, -2 }, { 2, 2 }, { -2, 2 } }, 0.0);
  AddPiece(sets[1], { { -2, -2 }, { 2, -2 }, { 2, 2 }, { -2, 2 } }, 0.0);
  for (int turn = 0; turn < 3; ++turn)
  {
    for (const bool single : { false, true })
    {
      Options options;
      options.SinglePrecision = single;
      options.Orient = Orientation::AsDrawn;
      EXPECT_EQ(DescribeFlaws(RunCore(sets, options).Mesh), "");
    }
    PermuteAxes(sets);
  }
}

//----------------------------------------------------------------------------
// What is refused, with the place.

TEST(Degenerate, RefusedWithTheirPlace)
{
  for (const char* bad : { "z=0.5: 0,0 nan,1 1,1", "z=0.5: 0,0 inf,1 1,1", "z=0.5 open: 0,0 5,0",
         "z=0.5: 0,0 1,0 1,1,0.9" })
  {
    FilterRun run(ParsePieces(Squares({ 0 }, 1) + bad));
    run.Filter->SetInvalidContoursToRefuse();
    vtkPolyData* surface = run.Update();
    EXPECT_EQ(surface->GetNumberOfCells(), 0) << bad;
    ASSERT_EQ(run.Errors.size(), 2u) << bad; // of the filter and its executive
    EXPECT_NE(run.Errors[0].find("port 2 (z-slices), cell 1"), std::string::npos) << run.Errors[0];
  }
}
