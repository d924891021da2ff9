// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   AxisWeights and tolerances of vtkOrthogonalSliceReconstruction
 *
 * What is trusted is judged from the contours alone: by distances to their segments and by
 * counting how often a ray crosses them.
 */

#include "Support/CheckSurface.h"
#include "Support/FilterRun.h"
#include "Support/Perturbations.h"
#include "Support/SliceSolid.h"
#include "Support/Vtk/DataSets.h"
#include "Support/Vtk/PolyDataMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace orthoslices;
using namespace orthoslices::support;

namespace
{
bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

double ValueOf(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetTuple1(cell);
}

/// Cells of the graph output that are of a kind.
std::vector<vtkIdType> CellsOfKind(vtkPolyData* graph, int kind)
{
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < graph->GetNumberOfCells(); ++cell)
  {
    if (ValueOf(graph, "Kind", cell) == kind)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

/// The node points are the first points of the graph.
std::vector<Point3> NodePointsOf(vtkPolyData* graph)
{
  std::vector<Point3> points(CellsOfKind(graph, 0).size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    graph->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

/// Calls visit(a, b) for the segments of all contours on one plane, in the plane's coordinates.
template <typename Visit>
void VisitSegments(const Pieces& pieces, double plane, Visit&& visit)
{
  using Point2 = std::array<double, 2>;
  for (Index i = 0; i < pieces.Count(); ++i)
  {
    const Index begin = pieces.Offsets[i], end = pieces.Offsets[i + 1];
    for (Index a = begin; a < end && pieces.W[begin] == plane; ++a)
    {
      const Index b = a + 1 < end ? a + 1 : begin;
      visit(Point2{ pieces.U[a], pieces.V[a] }, Point2{ pieces.U[b], pieces.V[b] });
    }
  }
}

/// Distance of a point from the contours of the plane on which it lies; infinite if it is on none.
double DistanceToContours(const Pieces& pieces, const Point3& p)
{
  const double u = p[FirstAxis(pieces.Axis)], v = p[SecondAxis(pieces.Axis)];
  double minimum = std::numeric_limits<double>::infinity();
  VisitSegments(pieces, p[pieces.Axis],
    [&](const auto& a, const auto& b)
    {
      const double du = b[0] - a[0], dv = b[1] - a[1];
      const double length2 = du * du + dv * dv;
      const double along = length2 > 0.0 ? ((u - a[0]) * du + (v - a[1]) * dv) / length2 : 0.0;
      const double t = std::clamp(along, 0.0, 1.0);
      minimum = std::min(minimum, std::hypot(a[0] + t * du - u, a[1] + t * dv - v));
    });
  return minimum;
}

/// Whether a ray from the point crosses the contours of its plane an odd number of times.
bool IsInside(const Pieces& pieces, const Point3& p)
{
  const double u = p[FirstAxis(pieces.Axis)], v = p[SecondAxis(pieces.Axis)];
  bool inside = false;
  VisitSegments(pieces, p[pieces.Axis],
    [&](const auto& a, const auto& b)
    {
      if ((a[1] > v) != (b[1] > v))
      {
        inside ^= a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > u;
      }
    });
  return inside;
}

constexpr int Planes = 9;

/// Slices of one torus, every one of them moved within its plane.
PieceSets MovedTorus(double& spacing)
{
  const Solid solid = TiltedTorus();
  spacing = (solid.High[0] - solid.Low[0]) / Planes;
  PieceSets sets =
    SliceSolid(solid, EqualPlanes(solid, { Planes, Planes, Planes }), 4, InPlaneGrid::Free);
  MoveSlices(sets, 0.3 * spacing, 5);
  return sets;
}

/// All trust in one axis.
std::array<double, 3> Only(int axis)
{
  std::array<double, 3> weights{ 0.0, 0.0, 0.0 };
  weights[axis] = 1.0;
  return weights;
}

void SetWeights(FilterRun& run, const std::array<double, 3>& weights)
{
  run.Filter->SetAxisWeights(weights[0], weights[1], weights[2]);
}

std::string ToString(const std::array<double, 3>& w)
{
  return std::to_string(w[0]) + ", " + std::to_string(w[1]) + ", " + std::to_string(w[2]);
}
}

//----------------------------------------------------------------------------
TEST(AxisWeights, PlaceTheNodePoints)
{
  // Squares around the origin; those of two axes meet at unequal distances from it.
  const double half[3] = { 1.0, 1.25, 1.75 };
  FilterRun run(ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1\n"
                            "y=0: -1.25,-1.25 1.25,-1.25 1.25,1.25 -1.25,1.25\n"
                            "z=0: -1.75,-1.75 1.75,-1.75 1.75,1.75 -1.75,1.75"));
  run.Filter->SetVirtualSlicesToOff(); // which have node points, too
  const std::array<double, 3> settings[] = { { 1, 1, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 3, 0 }, { 1, 2, 5 }, { 0.25, 0.5, 1.25 }, { 0, 0, 0 } };
  for (const std::array<double, 3>& w : settings)
  {
    SCOPED_TRACE(ToString(w));
    SetWeights(run, w);
    run.Update();
    std::set<std::pair<int, bool>> found;
    for (const Point3& p : NodePointsOf(run.Filter->GetGraphOutput()))
    {
      const int t = p[0] != 0.0 ? 0 : p[1] != 0.0 ? 1 : 2;
      const int u = FirstAxis(t), v = SecondAxis(t);
      const double sum = w[u] + w[v];
      const double mean =
        sum > 0.0 ? (w[u] * half[u] + w[v] * half[v]) / sum : 0.5 * (half[u] + half[v]);
      EXPECT_NEAR(std::abs(p[t]), mean, 1e-14);
      EXPECT_EQ(p[u], 0.0);
      EXPECT_EQ(p[v], 0.0);
      found.insert({ t, p[t] > 0.0 });
    }
    EXPECT_EQ(found.size(), 6u);
  }
}

//----------------------------------------------------------------------------
namespace
{
/// The greatest distance of the node points on slices of an axis from these slices' contours.
double FarthestNodePoint(vtkPolyData* graph, const Pieces& pieces)
{
  const std::set<double> planes(pieces.W.begin(), pieces.W.end());
  double farthest = 0.0;
  std::size_t count = 0;
  for (const Point3& p : NodePointsOf(graph))
  {
    if (planes.count(p[pieces.Axis]) > 0)
    {
      farthest = std::max(farthest, DistanceToContours(pieces, p));
      ++count;
    }
  }
  EXPECT_GE(count, 100u);
  return farthest;
}
}

TEST(AxisWeights, NodePointsLieOnTheContoursOfTheTrustedAxis)
{
  double spacing = 0.0;
  const PieceSets sets = MovedTorus(spacing);
  FilterRun run(sets);
  // Nodes keep a millionth of a slab from its ends and from each other.
  const double margin = 3e-6 * spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    run.Filter->SetAxisWeights(1.0, 1.0, 1.0);
    run.Update();
    EXPECT_GT(FarthestNodePoint(run.Filter->GetGraphOutput(), sets[axis]), 0.05 * spacing);
    SetWeights(run, Only(axis));
    vtkPolyData* surface = run.Update();
    EXPECT_LE(FarthestNodePoint(run.Filter->GetGraphOutput(), sets[axis]), margin);
    EXPECT_TRUE(CheckSurface(MeshOf(surface)).IsClosedManifold());
  }
}

//----------------------------------------------------------------------------
namespace
{
/// Vertices of the contours that have no point of the graph within `margin`.
std::size_t CountMoved(const Pieces& pieces, vtkPolyData* graph, double margin)
{
  std::vector<Point3> points(graph->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    graph->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  std::size_t moved = 0;
  for (std::size_t i = 0; i < pieces.U.size(); ++i)
  {
    Point3 vertex;
    vertex[pieces.Axis] = pieces.W[i];
    vertex[FirstAxis(pieces.Axis)] = pieces.U[i];
    vertex[SecondAxis(pieces.Axis)] = pieces.V[i];
    moved += std::none_of(points.begin(), points.end(),
               [&](const Point3& p) {
                 return std::hypot(p[0] - vertex[0], p[1] - vertex[1], p[2] - vertex[2]) < margin;
               })
      ? 1
      : 0;
  }
  return moved;
}
}

/// Displacements of node points fade along the arcs: of trusted contours there are none.
TEST(AxisWeights, ContoursOfTheTrustedAxisStayWhereTheyAre)
{
  double spacing = 0.0;
  const PieceSets sets = MovedTorus(spacing);
  const double margin = 3e-6 * spacing;
  FilterRun run(sets);
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    run.Filter->SetAxisWeights(1.0, 1.0, 1.0);
    run.Update();
    EXPECT_GT(CountMoved(sets[axis], graph, margin), 0.5 * sets[axis].U.size());
    SetWeights(run, Only(axis));
    run.Update();
    std::size_t snips = 0;
    for (const vtkIdType cell : CellsOfKind(graph, 4))
    {
      snips += ValueOf(graph, "SliceAxis", cell) == axis ? 1 : 0;
    }
    // With a pair of crossings that is taken out, up to two vertices may go without being listed.
    EXPECT_LE(CountMoved(sets[axis], graph, margin), 2 * snips);
    EXPECT_LT(2 * snips, 0.1 * sets[axis].U.size());
  }
}

//----------------------------------------------------------------------------
TEST(AxisWeights, HeavierSideDecidesOnAGridVertex)
{
  // The origin is inside for the x- and the y-slice, outside for the z-slice. The surface passes it
  // closely, with all triangles on the side that is asked for.
  FilterRun run(ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                            "z=0: 0.2,0.2 0.8,0.2 0.8,0.8 0.2,0.8"));
  run.Filter->AutomaticAccuracyOff();
  const struct
  {
    std::array<double, 3> Weights;
    bool Inside;
  } settings[] = { { { 1, 1, 1 }, true }, { { 1, 1, 1.9 }, true }, { { 1, 1, 2.1 }, false },
    { { 0, 0, 1 }, false }, { { 1, 0, 0 }, true }, { { 3, 0, 2 }, true }, { { 2, 0, 3 }, false },
    { { 0, 0, 0 }, true } };
  for (const auto& setting : settings)
  {
    SCOPED_TRACE(ToString(setting.Weights));
    SetWeights(run, setting.Weights);
    vtkPolyData* surface = run.Update();
    EXPECT_NEAR(WindingNumber(MeshOf(surface), { 0, 0, 0 }), setting.Inside ? 1.0 : 0.0, 1e-6);
    vtkPolyData* graph = run.Filter->GetGraphOutput();
    std::set<int> overruled;
    for (const vtkIdType cell : CellsOfKind(graph, 3))
    {
      overruled.insert(static_cast<int>(ValueOf(graph, "SliceAxis", cell)));
    }
    EXPECT_EQ(overruled, setting.Inside ? std::set<int>{ 2 } : (std::set<int>{ 0, 1 }));
  }
}

//----------------------------------------------------------------------------
namespace
{
/// Grid vertices on whose side the surface and the contours of one axis do not agree.
std::size_t CountDissent(vtkPolyData* surface, const PieceSets& sets, int axis)
{
  const TriangleMesh mesh = MeshOf(surface);
  std::array<std::set<double>, 3> planes;
  for (const Pieces& pieces : sets)
  {
    planes[pieces.Axis].insert(pieces.W.begin(), pieces.W.end());
  }
  std::size_t dissent = 0, inside = 0;
  for (const double x : planes[0])
  {
    for (const double y : planes[1])
    {
      for (const double z : planes[2])
      {
        const bool encloses = WindingNumber(mesh, { x, y, z }) > 0.5;
        inside += encloses ? 1 : 0;
        dissent += encloses != IsInside(sets[axis], { x, y, z }) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 10u);
  return dissent;
}
}

TEST(AxisWeights, TrustedAxisDecidesOnEveryGridVertex)
{
  double spacing = 0.0;
  const PieceSets sets = MovedTorus(spacing);
  FilterRun run(sets);
  run.Filter->AutomaticAccuracyOff(); // to the last vertex
  for (int axis = 0; axis < 3; ++axis)
  {
    SCOPED_TRACE(axis);
    run.Filter->SetAxisWeights(1.0, 1.0, 1.0);
    EXPECT_GT(CountDissent(run.Update(), sets, axis), 0u);
    SetWeights(run, Only(axis));
    EXPECT_EQ(CountDissent(run.Update(), sets, axis), 0u);
  }
}

//----------------------------------------------------------------------------
TEST(AxisWeights, ThatAreNoWeightsAreAnError)
{
  FilterRun run(ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                            "z=0: -1,-1 1,-1 1,1 -1,1"));
  for (const double bad : { -1e-9, -HUGE_VAL, HUGE_VAL, std::nan("") })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      SCOPED_TRACE(std::to_string(bad) + " for " + "xyz"[axis]);
      std::array<double, 3> weights{ 1.0, 1.0, 1.0 };
      weights[axis] = bad;
      SetWeights(run, weights);
      EXPECT_EQ(run.Update()->GetNumberOfCells(), 0);
      ASSERT_GE(run.Errors.size(), 1u);
      EXPECT_TRUE(Contains(run.Errors[0], "AxisWeights")) << run.Errors[0];
    }
  }
  run.Filter->SetAxisWeights(1.0, 1.0, 1.0);
  EXPECT_GT(run.Update()->GetNumberOfCells(), 0);
  EXPECT_TRUE(run.Errors.empty());
}

//----------------------------------------------------------------------------
TEST(Tolerances, ThatAreNoNumbersAreAnError)
{
  FilterRun run(ParsePieces("x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1\n"
                            "z=0: -1,-1 1,-1 1,1 -1,1"));
  const auto expectError = [&](const std::string& name)
  {
    SCOPED_TRACE(name);
    EXPECT_EQ(run.Update()->GetNumberOfCells(), 0);
    ASSERT_GE(run.Errors.size(), 1u);
    EXPECT_TRUE(Contains(run.Errors[0], name)) << run.Errors[0];
  };
  run.Filter->SetPlaneTolerance(std::nan(""));
  expectError("PlaneTolerance");
  run.Filter->SetPlaneTolerance(1e-5);
  run.Filter->SetReportTolerance(std::nan(""));
  expectError("ReportTolerance");
  run.Filter->SetReportTolerance(1e-3);
  EXPECT_GT(run.Update()->GetNumberOfCells(), 0);
  EXPECT_TRUE(run.Errors.empty());
}

//----------------------------------------------------------------------------
namespace
{
/// The z-slice reaches 0.5 farther along +y than the x-slice does: one of six node points.
const char* const OneDisagreement =
  "x=0: -1,-1 1,-1 1,1 -1,1; y=0: -1,-1 1,-1 1,1 -1,1; z=0: -1,-1 1,-1 1,1.5 -1,1.5";
}

TEST(ReportTolerance, IsAShareOfTheDiagonalOfAllInputs)
{
  FilterRun run(ParsePieces(OneDisagreement));
  const double share = 0.5 / std::sqrt(2.0 * 2.0 + 2.5 * 2.5 + 2.0 * 2.0);
  for (const double factor : { 0.0, 0.5, 0.999, 1.001, 2.0 })
  {
    SCOPED_TRACE(factor);
    const bool reported = factor < 1.0;
    run.Filter->SetReportTolerance(factor * share);
    vtkPolyData* surface = run.Update();
    EXPECT_TRUE(run.Errors.empty());
    ASSERT_EQ(run.Warnings.size(), reported ? 1u : 0u);
    EXPECT_TRUE(!reported || Contains(run.Warnings[0], " at 1 of 6 node points"));
    // Four of the eight polygons have the node point: those beyond y = 0.
    for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
    {
      const bool beyond = surface->GetCellData()->GetArray("GridCell")->GetComponent(cell, 1) > 0.0;
      EXPECT_EQ(ValueOf(surface, "Repaired", cell), reported && beyond ? 1.0 : 0.0);
    }
  }
}

//----------------------------------------------------------------------------
TEST(ReportTolerance, LeavesTheMeasuredValuesAlone)
{
  FilterRun run(ParsePieces(OneDisagreement));
  run.Filter->SetReportTolerance(1.0);
  run.Update();
  vtkTable* slices = run.Filter->GetSliceTable();
  ASSERT_EQ(slices->GetNumberOfRows(), 3);
  const double expected[3] = { 0.5, 0.0, 0.5 };
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(slices->GetValueByName(axis, "MaxDisagreement").ToDouble(), expected[axis]);
    EXPECT_EQ(slices->GetValueByName(axis, "RmsDisagreement").ToDouble(), 0.5 * expected[axis]);
  }
  double range[2];
  run.Filter->GetGraphOutput()->GetCellData()->GetArray("Disagreement")->GetRange(range);
  EXPECT_EQ(range[1], 0.5);
}

//----------------------------------------------------------------------------
TEST(GraphOutput, IsColoredByTheDisagreementOfSlices)
{
  FilterRun run(ParsePieces(OneDisagreement));
  run.Filter->SetReportTolerance(1.0);
  run.Update();
  vtkPolyData* graph = run.Filter->GetGraphOutput();
  vtkTable* slices = run.Filter->GetSliceTable();
  auto* contours = vtkTable::SafeDownCast(run.Filter->GetOutputDataObject(3));
  ASSERT_NE(graph->GetCellData()->GetScalars(), nullptr);
  EXPECT_STREQ(graph->GetCellData()->GetScalars()->GetName(), "SliceRmsDisagreement");
  int arcs = 0;
  for (vtkIdType cell = 0; cell < graph->GetNumberOfCells(); ++cell)
  {
    const auto value = [&](const char* name) { return ValueOf(graph, name, cell); };
    if (value("Kind") == 0.0)
    {
      EXPECT_EQ(value("SliceRmsDisagreement"), value("Disagreement"));
    }
    else if (value("Kind") == 1.0)
    {
      ++arcs;
      // One slice and one contour of each family.
      const vtkIdType axis = static_cast<vtkIdType>(value("SliceAxis"));
      const auto rms = [&](vtkTable* table)
      { return table->GetValueByName(axis, "RmsDisagreement").ToDouble(); };
      EXPECT_EQ(value("SliceRmsDisagreement"), rms(slices));
      EXPECT_EQ(value("ContourRmsDisagreement"), rms(contours));
    }
  }
  EXPECT_EQ(arcs, 12);
  EXPECT_EQ(slices->GetValueByName(1, "SliceName").ToString(), "y = 0");
}

//----------------------------------------------------------------------------
namespace
{
double DiagonalOf(const PieceSets& sets)
{
  Point3 low{ HUGE_VAL, HUGE_VAL, HUGE_VAL }, high{ -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const Pieces& pieces : sets)
  {
    const std::vector<double>* values[3] = { &pieces.W, &pieces.U, &pieces.V };
    for (int i = 0; i < 3; ++i)
    {
      const auto ends = std::minmax_element(values[i]->begin(), values[i]->end());
      const int axis = (pieces.Axis + i) % 3;
      low[axis] = std::min(low[axis], *ends.first);
      high[axis] = std::max(high[axis], *ends.second);
    }
  }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

/// Triangles that are fans around a common last point belong to one polygon.
std::map<vtkIdType, bool> FansWith(vtkPolyData* surface, const std::set<vtkIdType>& nodes)
{
  std::map<vtkIdType, bool> fans;
  const TriangleMesh mesh = MeshOf(surface);
  for (const auto& ids : mesh.Triangles)
  {
    bool& marked = fans[*std::max_element(ids.begin(), ids.end())];
    marked |= std::any_of(ids.begin(), ids.end(), [&](auto id) { return nodes.count(id) > 0; });
  }
  return fans;
}

/// Node points whose contours are farther apart than `tolerance`.
std::set<vtkIdType> FindDisagreeing(vtkPolyData* graph, double tolerance)
{
  std::set<vtkIdType> nodes;
  for (const vtkIdType cell : CellsOfKind(graph, 0))
  {
    if (ValueOf(graph, "Disagreement", cell) > tolerance)
    {
      nodes.insert(cell); // cell i is point i
    }
  }
  return nodes;
}
}

TEST(ReportTolerance, MarksThePolygonsOfTheNodePointsBeyondIt)
{
  const PieceSets sets = ReadPieceSets({ "lbl_lumbar3", 1, 1, false }, 32);
  FilterRun run(sets);
  run.Filter->SetPatchTypeToFan();
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const double share : { 0.0, 1e-3, 5e-3, 1.0 })
  {
    SCOPED_TRACE(share);
    run.Filter->SetReportTolerance(share);
    vtkPolyData* surface = run.Update();
    const auto nodes = FindDisagreeing(run.Filter->GetGraphOutput(), share * DiagonalOf(sets));
    EXPECT_LT(nodes.size(), before);
    EXPECT_EQ(nodes.empty(), share == 1.0);
    before = nodes.size();
    ASSERT_EQ(run.Warnings.size(), 1u); // there are isolated contours, too
    EXPECT_TRUE(
      nodes.empty() || Contains(run.Warnings[0], " at " + std::to_string(nodes.size()) + " of "));
    const auto fans = FansWith(surface, nodes);
    const TriangleMesh mesh = MeshOf(surface);
    std::size_t wrong = 0;
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      const int repaired =
        static_cast<int>(ValueOf(surface, "Repaired", static_cast<vtkIdType>(t)));
      const auto& ids = mesh.Triangles[t];
      const bool isFan = (repaired & 4) == 0;
      const bool marked = (repaired & 1) != 0;
      wrong += isFan && marked != fans.at(*std::max_element(ids.begin(), ids.end())) ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0u);
  }
}

//----------------------------------------------------------------------------
TEST(ReportTolerance, IsClamped)
{
  vtkNew<vtkOrthogonalSliceReconstruction> filter;
  EXPECT_EQ(filter->GetReportTolerance(), 1e-3);
  filter->SetReportTolerance(-1.0);
  EXPECT_EQ(filter->GetReportTolerance(), 0.0);
  filter->SetReportTolerance(7.0);
  EXPECT_EQ(filter->GetReportTolerance(), 1.0);
}

//----------------------------------------------------------------------------
namespace
{
/// A row of the table of slices.
vtkIdType RowOf(vtkTable* slices, int axis, int plane)
{
  for (vtkIdType row = 0; row < slices->GetNumberOfRows(); ++row)
  {
    if (slices->GetValueByName(row, "SliceAxis").ToInt() == axis &&
      slices->GetValueByName(row, "SlicePlane").ToInt() == plane)
    {
      return row;
    }
  }
  return -1;
}

/// Planes 1 and 2 through the cube from 0.5 to 2.5, but for z = 2.
const std::string CubeWithoutLid = "x=1: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5\n"
                                   "x=2: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5\n"
                                   "y=1: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5\n"
                                   "y=2: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5\n"
                                   "z=1: 0.5,0.5 2.5,0.5 2.5,2.5 0.5,2.5\n";
}

TEST(ReportOfFilter, NamesTheSliceThatWasOverruled)
{
  // The slice z = 2 is drawn in the wrong place.
  FilterRun run(ParsePieces(CubeWithoutLid + "z=2: 5,5 7,5 7,7 5,7"));
  run.Filter->SetVirtualSlicesToOff(); // planes are numbered among all
  run.Update();
  vtkTable* slices = run.Filter->GetSliceTable();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int plane = 0; plane < 2; ++plane)
    {
      const vtkIdType row = RowOf(slices, axis, plane);
      EXPECT_EQ(
        slices->GetValueByName(row, "OverruledVertices").ToInt(), axis == 2 && plane == 1 ? 4 : 0);
      EXPECT_EQ(slices->GetValueByName(row, "SnippedCrossings").ToInt(), 0);
    }
  }
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_TRUE(Contains(run.Warnings[0], "the slice z = 2, at 4 grid vertices")) << run.Warnings[0];
}

//----------------------------------------------------------------------------
TEST(ReportOfFilter, CountsSnippedCrossingsAboveTheTolerance)
{
  // Between y = 1.2 and 1.4 the slice z = 2 does not reach as far as x = 2; the slice x = 2 does
  // not know.
  FilterRun run(ParsePieces(
    CubeWithoutLid + "z=2: 0.5,0.5 2.5,0.5 2.5,1.2 1.9,1.2 1.9,1.4 2.5,1.4 2.5,2.5 0.5,2.5"));
  const double share = 0.2 / std::sqrt(3.0 * 2.0 * 2.0);
  for (const double factor : { 0.0, 0.99, 1.01 })
  {
    SCOPED_TRACE(factor);
    run.Filter->SetReportTolerance(factor * share);
    vtkPolyData* surface = run.Update();
    const vtkIdType count = factor < 1.0 ? 1 : 0;
    EXPECT_EQ(surface->GetFieldData()->GetArray("NumberOfRepairs")->GetTuple1(0), count);
    EXPECT_EQ(surface->GetFieldData()->GetArray("NumberOfReconciledEdges")->GetTuple1(0), 1);
    const auto snipped = CellsOfKind(run.Filter->GetGraphOutput(), 4);
    ASSERT_EQ(static_cast<vtkIdType>(snipped.size()), count);
    if (count > 0)
    {
      EXPECT_NEAR(ValueOf(run.Filter->GetGraphOutput(), "RepairSize", snipped[0]), 0.2, 1e-6);
    }
    vtkTable* slices = run.Filter->GetSliceTable();
    EXPECT_EQ(slices->GetValueByName(RowOf(slices, 2, 1), "SnippedCrossings").ToInt(), 2 * count);
    EXPECT_EQ(static_cast<vtkIdType>(run.Warnings.size()), count);
  }
}

//----------------------------------------------------------------------------
TEST(ReportOfFilter, SaysThatContoursAsDrawnBoundTheOutside)
{
  FilterRun run(ParsePieces("x=0: -1,-1 -1,1 1,1 1,-1; y=0: -1,-1 -1,1 1,1 1,-1\n"
                            "z=0: -1,-1 -1,1 1,1 1,-1"));
  run.Update();
  EXPECT_TRUE(run.Warnings.empty());
  run.Filter->SetOrientationToAsDrawn();
  EXPECT_GT(run.Update()->GetNumberOfCells(), 0);
  ASSERT_EQ(run.Warnings.size(), 1u);
  EXPECT_TRUE(Contains(run.Warnings[0], "inside out")) << run.Warnings[0];
}

//----------------------------------------------------------------------------
namespace
{
/// What the filter says about a shape of Data in three families of slices.
std::vector<std::string> WarningsOn(const std::string& name, int planes, FilterRun& run)
{
  run.SetInputs(ReadPieceSets({ name, 0, 0, true }, planes));
  run.Update();
  EXPECT_TRUE(run.Errors.empty());
  return run.Warnings;
}

/// Whether the surface of the last run has the topology that a shape is known to have.
bool IsRight(const DataSet& data, FilterRun& run)
{
  vtkPolyData* surface = run.Filter->GetOutput();
  return FieldValue(surface, "NumberOfComponents") == data.Components &&
    FieldValue(surface, "TotalGenus") == data.Genus;
}
}

/// Although up to 84 places are undecided, of which the table tells.
TEST(ReportOfFilter, SaysNothingAboutShapesThatComeOutRight)
{
  int right = 0;
  for (const DataSet& data : AllDataSets())
  {
    for (const int planes : { 16, 32 })
    {
      if (!data.Consistent)
      {
        continue;
      }
      SCOPED_TRACE(data.Name + " " + std::to_string(planes));
      FilterRun run;
      const auto warnings = WarningsOn(data.Name, planes, run);
      EXPECT_GT(run.Filter->GetUndecidedTable()->GetNumberOfRows(), 0);
      if (IsRight(data, run))
      {
        ++right;
        EXPECT_TRUE(warnings.empty()) << warnings.front();
      }
      else
      {
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_TRUE(Contains(warnings[0], "the slices hardly say")) << warnings[0];
        EXPECT_TRUE(Contains(warnings[0], "would settle")) << warnings[0];
        EXPECT_FALSE(Contains(warnings[0], "contradict")) << warnings[0];
      }
    }
  }
  EXPECT_GE(right, 10);
}

//----------------------------------------------------------------------------
TEST(ReportOfFilter, SaysNothingOfOneFamilyWhoseContoursOverlap)
{
  FilterRun run;
  run.SetInputs(PieceSets{ Pieces(), Pieces(), ReadPieceSets({ "heart", 1, 1, true }, 32)[2] });
  run.Filter->SetInputConnection(0, nullptr);
  run.Filter->SetInputConnection(1, nullptr);
  run.Update();
  EXPECT_TRUE(run.Errors.empty());
  // What contours of one stack overlap is no question; a place that is stays in the table.
  EXPECT_GE(run.Filter->GetUndecidedTable()->GetNumberOfRows(), 1);
  EXPECT_TRUE(run.Warnings.empty());
}
