// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Sparse/VirtualSlices.h"

#include "Core/Reconstruct.h"
#include "Core/Sparse/SurfaceMesh.h"
#include "Support/SparseSolids.h"
#include "Support/TextContours.h"
#include "Support/Threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// A solid cut by few planes, and the virtual slices through its surface.
struct Sliced
{
  Sliced(
    const Solid& solid, const std::array<int, 3>& count, const Execution& execution = Execution())
    : First(Reconstruct(SliceByFewPlanes(solid, EqualPlanes(solid, count)), Options(), Execution()))
  {
    Box3 box;
    for (Index i = 0; i < this->First.Graph.Count(); ++i)
    {
      box.Add(this->First.Graph.PointAt(i));
    }
    GuideCurves none;
    this->Virtual = MakeVirtualSlices(
      { GeometryOf(this->First), this->First.Surface, this->First.Grid, none, Pi / 3.0 },
      SliceDensity(this->First.Grid, box), execution);
  }

  Reconstruction First;
  Contours Virtual;
};

double AreaOf(const Contours& contours, Index contour)
{
  double area = 0.0;
  const Index begin = contours.Offsets[contour], end = contours.Offsets[contour + 1];
  for (Index i = begin; i < end; ++i)
  {
    const Index j = i + 1 < end ? i + 1 : begin;
    area += 0.5 * (contours.U[i] * contours.V[j] - contours.U[j] * contours.V[i]);
  }
  return area;
}

/// The greatest distance of the vertices within |z| <= `height` from the surface.
double DistanceOf(const Contours& contours, const Solid& solid, double height)
{
  double greatest = 0.0;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      const Point3 p = contours.World(contour, i);
      greatest = std::abs(p[2]) > height ? greatest : std::max(greatest, std::abs(solid.Value(p)));
    }
  }
  return greatest;
}
}

//----------------------------------------------------------------------------
TEST(MakeVirtualSlices, ContoursOfABallAreCirclesWithTheInteriorOnTheLeft)
{
  const Solid ball = PlainBall();
  const Sliced sliced(ball, { 0, 0, 10 });
  const Contours& contours = sliced.Virtual;
  ASSERT_GE(contours.Count(), 20);
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    EXPECT_TRUE(contours.IsVirtual(contour));
    EXPECT_NE(contours.Axis[contour], 2);
    EXPECT_GE(contours.Size(contour), 8);
    const int axis = contours.Axis[contour];
    const double offset = contours.Coordinate[contour] - (axis == 0 ? 0.02 : -0.01);
    const double area = std::acos(-1.0) * (1.0 - offset * offset);
    EXPECT_NEAR(AreaOf(contours, contour), area, 0.05 * area + 0.02);
  }
  EXPECT_LT(DistanceOf(contours, ball, 0.8), 0.01);
}

//----------------------------------------------------------------------------
/// A cavity's contours run clockwise.
TEST(MakeVirtualSlices, ContoursOfACavityHaveItOnTheRight)
{
  const Sliced sliced(BallWithCavity(0.5), { 0, 0, 16 });
  ASSERT_EQ(sliced.First.Topology.Components, 2);
  const Contours& contours = sliced.Virtual;
  double area = 0.0, cavity = 0.0;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    const double part = AreaOf(contours, contour);
    (part > 0.0 ? area : cavity) += part;
  }
  EXPECT_LT(cavity, -0.05 * area); // radii of 0.5 and 1
  EXPECT_GT(cavity, -0.25 * area);
}

//----------------------------------------------------------------------------
/// Between real slices, and only on axes that lack them.
TEST(MakeVirtualSlices, PlanesAreThoseOfNobodyElse)
{
  for (const auto& count : { std::array<int, 3>{ 0, 12, 12 }, { 1, 1, 16 }, { 32, 32, 8 } })
  {
    const Sliced sliced(TorusAround(0, 0.3), count);
    const Contours& contours = sliced.Virtual;
    EXPECT_GT(contours.Count(), 0);
    for (Index contour = 0; contour < contours.Count(); ++contour)
    {
      const int axis = contours.Axis[contour];
      EXPECT_LT(count[axis], 12); // those that are sparse
      for (const double plane : sliced.First.Grid.Planes[axis])
      {
        EXPECT_GT(std::abs(contours.Coordinate[contour] - plane), 1e-3);
      }
    }
  }
}

//----------------------------------------------------------------------------
/// Thin tubes are stretched: between slices far apart the radius is the right one in the mean.
TEST(MakeVirtualSlices, ThinThingsKeepTheirWidth)
{
  constexpr double radius = 0.11;
  Solid rod = PlainBall();
  rod.Tubes = { Capsule({ 0.1, 0.2, -2.0 }, { 0.1, 0.2, 2.0 }, radius) };
  const Sliced sliced(rod, { 0, 0, 6 });
  const Contours& contours = sliced.Virtual;
  double sum = 0.0;
  int count = 0;
  for (Index contour = 0; contour < contours.Count(); ++contour)
  {
    for (Index i = contours.Offsets[contour]; i < contours.Offsets[contour + 1]; ++i)
    {
      const Point3 p = contours.World(contour, i);
      if (std::abs(p[2]) < 0.6) // off the ends
      {
        sum += rod.Value(p);
        ++count;
      }
    }
  }
  ASSERT_GT(count, 20);
  // Contours of a dozen vertices are two per cent thinner than their circle.
  EXPECT_NEAR(sum / count, -0.02 * radius, 0.04 * radius);
}

//----------------------------------------------------------------------------
TEST(MakeVirtualSlices, DoNotDependOnThreads)
{
  const Solid torus = TorusAround(1, 0.15);
  const Contours one = Sliced(torus, { 0, 0, 12 }).Virtual;
  const Contours many = Sliced(torus, { 0, 0, 12 }, ManyThreads()).Virtual;
  EXPECT_GT(one.Count(), 0);
  EXPECT_EQ(one.U, many.U);
  EXPECT_EQ(one.V, many.V);
  EXPECT_EQ(one.Offsets, many.Offsets);
  EXPECT_EQ(one.Coordinate, many.Coordinate);
}

//----------------------------------------------------------------------------
/// The mesh that is made fair: contours are curves of fixed points, and cells are between them.
TEST(SurfaceMesh, ContoursAreCurvesOfFixedPoints)
{
  const Sliced sliced(TorusAround(0, 0.3), { 0, 0, 12 });
  GuideCurves none;
  const SurfaceMesh mesh =
    MakeSurfaceMesh(GeometryOf(sliced.First), sliced.First.Surface, none, Execution());
  EXPECT_EQ(mesh.StretchAxis, 2);
  Index curves = 0;
  for (Index corner = 0; corner < mesh.Corners.CornerCount(); ++corner)
  {
    const Box3& cell = mesh.Cells[mesh.Cell[corner / 3]];
    const Index vertex = mesh.Corners.VertexOf(corner);
    const Point3& p = mesh.Points[vertex];
    EXPECT_TRUE(mesh.Fixed[vertex] || (cell.Low[2] <= p[2] && p[2] <= cell.High[2]));
    const Point3& stretch = mesh.Stretch[vertex];
    EXPECT_GE(stretch[0], 1.0);
    EXPECT_EQ(stretch[1], stretch[0]);
    EXPECT_EQ(stretch[2], 1.0); // along the slices alone
    if (mesh.Corners.IsCurve(corner))
    {
      ++curves;
      EXPECT_TRUE(mesh.Fixed[mesh.Corners.StartOf(corner)]);
      EXPECT_TRUE(mesh.Fixed[mesh.Corners.EndOf(corner)]);
      EXPECT_NE(mesh.Cell[corner / 3], mesh.Cell[mesh.Corners.OppositeOf(corner) / 3]);
    }
  }
  EXPECT_EQ(curves, 2 * sliced.First.Graph.Count()); // as many edges as points, from both sides
}

//----------------------------------------------------------------------------
/// With two families, what is thin between their planes is stretched, along both axes of its
/// slices; what is thick is not, but perhaps for tips.
TEST(SurfaceMesh, ThinContoursOfTwoFamiliesAreStretched)
{
  for (const double thickness : { 0.04, 0.3 })
  {
    Solid ring = TorusAround(2, thickness);
    ring.Tubes = { Torus({ 0.02, -0.01, 0.01 }, { 1.0, 0.9, 0.1 }, 0.65, thickness) };
    const Sliced sliced(ring, { 12, 12, 0 });
    GuideCurves none;
    const SurfaceMesh mesh =
      MakeSurfaceMesh(GeometryOf(sliced.First), sliced.First.Surface, none, Execution());
    EXPECT_EQ(mesh.StretchAxis, -1);
    Index stretched = 0;
    for (Index point = 0; point < sliced.First.Graph.Count(); ++point)
    {
      const Point3& stretch = mesh.Stretch[point];
      stretched += mesh.IsStretched(point) ? 1 : 0;
      EXPECT_TRUE(stretch == SurfaceMesh::Unstretched ||
        std::count(stretch.begin(), stretch.end(), 1.0) == 1);
      EXPECT_LE(*std::max_element(stretch.begin(), stretch.end()), 2.0);
    }
    const double share = static_cast<double>(stretched) / sliced.First.Graph.Count();
    EXPECT_TRUE(thickness < 0.1 ? share > 0.5 : share < 0.05) << share;
  }
}

//----------------------------------------------------------------------------
/// A needle is stretched by what makes its thickness 0.85 spacings; a strip that thin is stretched
/// until it looks 20 spacings long, which is less, and would be much more than others otherwise.
TEST(SurfaceMesh, LongThinContoursAreStretchedLess)
{
  const auto stretchOf = [](const std::string& contour)
  {
    Options options;
    options.Virtual = VirtualSlices::Off;
    const Reconstruction stack =
      Reconstruct(ParsePieces("z=0: " + contour + "; z=1: " + contour + "; z=2: " + contour),
        options, Execution());
    GuideCurves none;
    const SurfaceMesh mesh = MakeSurfaceMesh(GeometryOf(stack), stack.Surface, none, Execution());
    const Index middle = stack.Graph.FirstPoint(stack.Graph.Arcs + 1);
    EXPECT_EQ(stack.Graph.Loops[1].Plane, 1);
    return mesh.Stretch[middle][0];
  };
  EXPECT_NEAR(stretchOf("0,0 0.2,0 0.2,0.2 0,0.2"), 0.85 / 0.1, 1e-9);
  EXPECT_NEAR(stretchOf("0,0 4,0 4,0.2 0,0.2"), 20.0 / 8.4, 1e-9);
  EXPECT_EQ(stretchOf("0,0 12,0 12,0.2 0,0.2"), 1.0);
}

//----------------------------------------------------------------------------
/// Of families that are not at right angles, lengths and angles are those of the world; the stretch
/// is along the slices, whatever the axes are.
TEST(SurfaceMesh, LengthsAreThoseOfTheWorld)
{
  const double s = 0.6, c = 0.8;
  const AxisFrame frame({ { { s, 0.0, c }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } });
  const Point3 start{ 1.0, 2.0, 3.0 }, inWorld{ 0.3, -0.7, 0.2 };
  SurfaceMesh mesh{ CornerTable(2, {}), { frame.ToAxes(start), frame.ToAxes(start + inWorld) },
    { 0, 0 }, { 0, 0 }, {}, {}, frame, -1, { { 2.0, 2.0, 1.0 }, { 2.0, 2.0, 1.0 } } };
  EXPECT_LT(Length(mesh.Edge(0, 1) - inWorld), 1e-14);
  EXPECT_LT(Length(mesh.InWorld(0, 1) - inWorld), 1e-14);
  mesh.StretchAxis = 2;
  EXPECT_LT(Length(mesh.Edge(0, 1) - Point3{ 0.6, -1.4, 0.2 }), 1e-14);
}

//----------------------------------------------------------------------------
/// Where a stack ends flat the surface has an edge, and where it ends round it has none.
TEST(SurfaceMesh, FlatEndsHaveACrease)
{
  const auto countCreases = [](const Solid& solid)
  {
    const Sliced sliced(solid, { 0, 0, 12 });
    GuideCurves none;
    const SurfaceMesh mesh =
      MakeSurfaceMesh(GeometryOf(sliced.First), sliced.First.Surface, none, Execution());
    return std::count(mesh.Crease.begin(), mesh.Crease.end(), std::uint8_t(1));
  };
  EXPECT_GT(countCreases(Pipe(0.5)), 0);
  EXPECT_EQ(countCreases(PlainBall()), 0);
}
