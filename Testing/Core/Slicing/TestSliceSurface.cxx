// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Slicing/SliceSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

using namespace orthoslices;

namespace
{
constexpr double Pi = 3.14159265358979323846;

//----------------------------------------------------------------------------
// Surfaces

/// Corners are numbered x + 2 y + 4 z.
TriangleSurface Box(const Point3& low, const Point3& high)
{
  TriangleSurface box;
  for (int corner = 0; corner < 8; ++corner)
  {
    box.Points.push_back({ corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
      corner & 4 ? high[2] : low[2] });
  }
  box.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return box;
}

TriangleSurface UnitCube() { return Box({ 0, 0, 0 }, { 1, 1, 1 }); }

TriangleSurface Octahedron()
{
  TriangleSurface surface;
  surface.Points = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  for (Index i = 0; i < 4; ++i)
  {
    surface.Triangles.push_back({ i, (i + 1) % 4, 4 });
    surface.Triangles.push_back({ (i + 1) % 4, i, 5 });
  }
  return surface;
}

/// A prism along y from 0 to 1 over a polygon (x, z) that runs counter-clockwise seen from -y.
TriangleSurface Prism(
  const std::vector<std::array<double, 2>>& polygon, const std::vector<std::array<Index, 3>>& cap)
{
  TriangleSurface prism;
  const auto n = static_cast<Index>(polygon.size());
  for (const double y : { 0.0, 1.0 })
  {
    for (const auto& corner : polygon)
    {
      prism.Points.push_back({ corner[0], y, corner[1] });
    }
  }
  for (const auto& t : cap)
  {
    prism.Triangles.push_back(t);
    prism.Triangles.push_back({ t[2] + n, t[1] + n, t[0] + n });
  }
  for (Index i = 0; i < n; ++i)
  {
    const Index j = (i + 1) % n;
    prism.Triangles.push_back({ j, i, i + n });
    prism.Triangles.push_back({ j, i + n, j + n });
  }
  return prism;
}

/// A grid that closes on itself in both directions, with a wavy tube so that nothing is symmetric.
TriangleSurface Torus(double major, double minor, int around, int across, double wave)
{
  TriangleSurface torus;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double a = 2 * Pi * i / around;
      const double b = 2 * Pi * j / across;
      const double r = minor * (1 + wave * std::sin(3 * a + 2 * b));
      const double d = major + r * std::cos(b);
      torus.Points.push_back({ d * std::cos(a), d * std::sin(a), r * std::sin(b) });
    }
  }
  const auto id = [=](int i, int j)
  { return static_cast<Index>((i % around) * across + j % across); };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      torus.Triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      torus.Triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return torus;
}

void Rotate(TriangleSurface& surface, double angle)
{
  for (Point3& p : surface.Points)
  {
    const double y = std::cos(angle) * p[1] - std::sin(angle) * p[2];
    const double z = std::sin(angle) * p[1] + std::cos(angle) * p[2];
    const double x = std::cos(angle) * p[0] - std::sin(angle) * z;
    p = { x, y, std::sin(angle) * p[0] + std::cos(angle) * z };
  }
}

TriangleSurface TiltedTorus()
{
  TriangleSurface torus = Torus(0.62, 0.27, 61, 37, 0.2);
  Rotate(torus, 0.7);
  return torus;
}

void Reverse(TriangleSurface& surface)
{
  for (auto& triangle : surface.Triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
}

void Append(TriangleSurface& surface, const TriangleSurface& other)
{
  const auto offset = static_cast<Index>(surface.Points.size());
  surface.Points.insert(surface.Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& t : other.Triangles)
  {
    surface.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
}

//----------------------------------------------------------------------------
// Measurements

double Area(const PlaneContours& contours, Index contour)
{
  double twice = 0.0;
  const Index first = contours.Offsets[contour];
  const Index end = contours.Offsets[contour + 1];
  for (Index i = first, last = end - 1; i < end; last = i++)
  {
    twice += contours.U[last] * contours.V[i] - contours.U[i] * contours.V[last];
  }
  return 0.5 * twice;
}

std::vector<double> Areas(const PlaneContours& contours)
{
  std::vector<double> areas;
  for (Index i = 0; i < contours.Count(); ++i)
  {
    areas.push_back(Area(contours, i));
  }
  std::sort(areas.begin(), areas.end());
  return areas;
}

double TotalArea(const PlaneContours& contours)
{
  double sum = 0.0;
  for (const double area : Areas(contours))
  {
    sum += area;
  }
  return sum;
}

std::vector<PlaneContours> Slice(TriangleSurface surface, int axis,
  const std::vector<double>& planes, Precision precision = Precision::Double)
{
  EXPECT_EQ(CloseSurface(surface).Kind, SurfaceProblemKind::None);
  return SliceSurface(surface, axis, planes, precision, Execution());
}

std::vector<double> EvenPlanes(double low, double high, int count)
{
  std::vector<double> planes;
  for (int i = 0; i < count; ++i)
  {
    planes.push_back(low + (i + 0.5) * (high - low) / count);
  }
  return planes;
}

struct Segment
{
  Index Contour;
  double U0, V0, U1, V1;
};

std::vector<Segment> Segments(const PlaneContours& contours)
{
  std::vector<Segment> segments;
  for (Index c = 0; c < contours.Count(); ++c)
  {
    for (Index i = contours.Offsets[c]; i < contours.Offsets[c + 1]; ++i)
    {
      const Index j = i + 1 < contours.Offsets[c + 1] ? i + 1 : contours.Offsets[c];
      segments.push_back({ c, contours.U[i], contours.V[i], contours.U[j], contours.V[j] });
    }
  }
  return segments;
}

/// Pairs of segments that cross properly: each has its ends strictly on both sides of the other.
int CountCrossings(const PlaneContours& contours)
{
  const auto side = [](const Segment& s, double u, double v)
  { return (s.U1 - s.U0) * (v - s.V0) - (s.V1 - s.V0) * (u - s.U0); };
  const std::vector<Segment> segments = Segments(contours);
  int crossings = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Segment& a = segments[i];
      const Segment& b = segments[j];
      crossings += side(a, b.U0, b.V0) * side(a, b.U1, b.V1) < 0.0 &&
        side(b, a.U0, a.V0) * side(b, a.U1, a.V1) < 0.0;
    }
  }
  return crossings;
}

int CountRepeatedVertices(const PlaneContours& contours)
{
  std::map<std::pair<double, double>, int> places;
  for (std::size_t i = 0; i < contours.U.size(); ++i)
  {
    ++places[{ contours.U[i], contours.V[i] }];
  }
  return static_cast<int>(contours.U.size() - places.size());
}

/// Where the contours cross the line u = `where` (or v, if `alongU`), in ascending order.
std::vector<double> CrossingsOfLine(const PlaneContours& contours, bool alongU, double where)
{
  std::vector<double> found;
  for (const Segment& s : Segments(contours))
  {
    const double a = alongU ? s.V0 : s.U0;
    const double b = alongU ? s.V1 : s.U1;
    if ((a >= where) != (b >= where))
    {
      const double t = (where - a) / (b - a);
      found.push_back(alongU ? s.U0 + t * (s.U1 - s.U0) : s.V0 + t * (s.V1 - s.V0));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}
}

//----------------------------------------------------------------------------
// Hand-solved surfaces

TEST(SliceSurface, CubeHasOneCounterClockwiseSquareOnEveryAxis)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto slices = Slice(UnitCube(), axis, { 0.25, 0.5 });
    ASSERT_EQ(slices.size(), 2u);
    for (const PlaneContours& slice : slices)
    {
      ASSERT_EQ(slice.Count(), 1);
      EXPECT_EQ(slice.U.size(), 8u); // four edges and four diagonals
      EXPECT_DOUBLE_EQ(Area(slice, 0), 1.0);
    }
  }
}

TEST(SliceSurface, AxesOfTheSliceAreTheNextTwo)
{
  const TriangleSurface box = Box({ 0, 10, 200 }, { 1, 12, 203 });
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle[] = { 0.5, 11, 201.5 };
    const PlaneContours slice = Slice(box, axis, { middle[axis] })[0];
    const auto u = std::minmax_element(slice.U.begin(), slice.U.end());
    const auto v = std::minmax_element(slice.V.begin(), slice.V.end());
    const Point3 low = box.Points[0];
    const Point3 high = box.Points[7];
    EXPECT_EQ(*u.first, low[(axis + 1) % 3]);
    EXPECT_EQ(*u.second, high[(axis + 1) % 3]);
    EXPECT_EQ(*v.first, low[(axis + 2) % 3]);
    EXPECT_EQ(*v.second, high[(axis + 2) % 3]);
  }
}

TEST(SliceSurface, PlanesInFacesAreCutJustBelow)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto slices = Slice(UnitCube(), axis, { 0.0, 1.0 });
    EXPECT_EQ(slices[0].Count(), 0); // nothing of the cube is below 0
    ASSERT_EQ(slices[1].Count(), 1);
    EXPECT_NEAR(Area(slices[1], 0), 1.0, 1e-9);
  }
}

TEST(SliceSurface, PlanesBesideTheSurfaceAreEmpty)
{
  for (const PlaneContours& slice : Slice(UnitCube(), 2, { -5.0, -1e-300, 1.0000001, 7.0 }))
  {
    EXPECT_EQ(slice.Count(), 0);
    EXPECT_TRUE(slice.U.empty());
  }
}

TEST(SliceSurface, PlaneThroughVerticesFollowsThem)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const PlaneContours slice = Slice(Octahedron(), axis, { 0.0 })[0];
    ASSERT_EQ(slice.Count(), 1);
    EXPECT_EQ(slice.U.size(), 4u);
    EXPECT_NEAR(Area(slice, 0), 2.0, 1e-9);
  }
}

TEST(SliceSurface, PlaneInAStepHasTheLowerSection)
{
  // A stair of two steps: 2 wide up to z = 1, then 1 wide up to z = 2.
  const TriangleSurface stair =
    Prism({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } },
      { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 5 }, { 3, 4, 5 } });
  const auto slices = Slice(stair, 2, { 0.5, 1.0, 1.5, 2.0 });
  EXPECT_NEAR(TotalArea(slices[0]), 2.0, 1e-9);
  EXPECT_NEAR(TotalArea(slices[1]), 2.0, 1e-9);
  EXPECT_NEAR(TotalArea(slices[2]), 1.0, 1e-9);
  EXPECT_NEAR(TotalArea(slices[3]), 1.0, 1e-9);
}

TEST(SliceSurface, ContoursDoNotTouchAtARidgeInThePlane)
{
  // An inverted V is cut into the bottom; its ridge lies at z = 1.
  const TriangleSurface gable = Prism({ { 0, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 }, { 0, 2 } },
    { { 0, 1, 4 }, { 1, 3, 4 }, { 1, 2, 3 } });
  for (const Precision precision : { Precision::Single, Precision::Double })
  {
    const PlaneContours slice = Slice(gable, 2, { 1.0 }, precision)[0];
    ASSERT_EQ(slice.Count(), 2);
    EXPECT_EQ(CountRepeatedVertices(slice), 0);
    EXPECT_EQ(std::count(slice.U.begin(), slice.U.end(), 1.0), 0);
    EXPECT_NEAR(Area(slice, 0), 1.0, 1e-5);
    EXPECT_NEAR(Area(slice, 1), 1.0, 1e-5);
  }
}

TEST(SliceSurface, NearlyHorizontalEdgesAreCutWhereThePlaneIs)
{
  // The top rises by 1e-12 from x = 0 to x = 2, less than contours keep away from vertices.
  const TriangleSurface wedge =
    Prism({ { 0, 0 }, { 2, 0 }, { 2, 1 + 1e-12 }, { 0, 1 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  const PlaneContours slice = Slice(wedge, 2, { 1 + 0.25e-12 })[0];
  ASSERT_EQ(slice.Count(), 1);
  EXPECT_NEAR(*std::min_element(slice.U.begin(), slice.U.end()), 0.5, 1e-3);
}

TEST(SliceSurface, TorusHasTheKnownNumberOfContours)
{
  const TriangleSurface torus = Torus(2.0, 0.5, 80, 40, 0.0);
  for (const double z : { -0.4, 0.1, 0.45 }) // a ring: outer boundary and hole
  {
    const auto areas = Areas(Slice(torus, 2, { z })[0]);
    ASSERT_EQ(areas.size(), 2u);
    EXPECT_LT(areas[0], 0.0);
    EXPECT_GT(areas[1], -areas[0]);
  }
  for (const int axis : { 0, 1 })
  {
    const auto slices = Slice(torus, axis, { -2.2, -1.7, -1.0, 0.3, 1.2, 1.8, 2.4, 2.6 });
    const std::vector<Index> expected{ 1, 1, 2, 2, 2, 1, 1, 0 };
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_EQ(slices[i].Count(), expected[i]) << "axis " << axis << ", plane " << i;
      for (const double area : Areas(slices[i]))
      {
        EXPECT_GT(area, 0.0);
      }
    }
  }
}

TEST(SliceSurface, HolesRunClockwise)
{
  TriangleSurface hollow = Box({ 0, 0, 0 }, { 4, 4, 4 });
  TriangleSurface cavity = Box({ 1, 1, 1 }, { 3, 2, 3 });
  Reverse(cavity);
  Append(hollow, cavity);
  const auto areas = Areas(Slice(hollow, 2, { 2.0 })[0]);
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_DOUBLE_EQ(areas[0], -2.0);
  EXPECT_DOUBLE_EQ(areas[1], 16.0);
}

//----------------------------------------------------------------------------
// Properties

TEST(SliceSurface, AreasAddUpToTheVolume)
{
  TriangleSurface torus = TiltedTorus();
  ASSERT_EQ(CloseSurface(torus).Kind, SurfaceProblemKind::None);
  const double volume = SixfoldVolume(torus) / 6.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    double sum = 0.0;
    for (const PlaneContours& slice : Slice(torus, axis, EvenPlanes(-1, 1, 400)))
    {
      sum += TotalArea(slice) * 2.0 / 400;
    }
    EXPECT_NEAR(sum, volume, 1e-4 * volume);
  }
}

TEST(SliceSurface, OrthogonalSlicesMeetInTheSamePoints)
{
  const TriangleSurface torus = TiltedTorus();
  const std::vector<double> planes = EvenPlanes(-1, 1, 24);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = FirstAxis(axis); // its second in-plane axis is `axis`
    const auto slices = Slice(torus, axis, planes);
    const auto nextSlices = Slice(torus, next, planes);
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      for (std::size_t j = 0; j < planes.size(); ++j)
      {
        const auto a = CrossingsOfLine(slices[i], false, planes[j]);
        const auto b = CrossingsOfLine(nextSlices[j], true, planes[i]);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k)
        {
          EXPECT_NEAR(a[k], b[k], 1e-9);
        }
      }
    }
  }
}

TEST(SliceSurface, ContoursThroughManyVerticesStaySimple)
{
  // Every coordinate is rounded to a multiple of 1/16, so that planes contain vertices, edges and
  // triangles of the surface.
  TriangleSurface coarse = Torus(2.0, 0.8, 40, 20, 0.0);
  for (Point3& p : coarse.Points)
  {
    for (double& x : p)
    {
      x = std::round(16 * x) / 16;
    }
  }
  std::vector<double> planes;
  for (int i = -48; i <= 48; ++i)
  {
    planes.push_back(i / 16.0);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto slices = Slice(coarse, axis, planes);
    for (std::size_t i = 0; i < slices.size(); ++i)
    {
      EXPECT_EQ(CountCrossings(slices[i]), 0) << "axis " << axis << ", plane " << planes[i];
      EXPECT_EQ(CountRepeatedVertices(slices[i]), 0) << "axis " << axis << ", plane " << planes[i];
    }
  }
}

TEST(SliceSurface, SinglePrecisionContoursAreFloats)
{
  for (const PlaneContours& slice : Slice(TiltedTorus(), 1, { -0.25, 0.125 }, Precision::Single))
  {
    ASSERT_GT(slice.Count(), 0);
    for (std::size_t i = 0; i < slice.U.size(); ++i)
    {
      EXPECT_EQ(slice.U[i], static_cast<double>(static_cast<float>(slice.U[i])));
      EXPECT_EQ(slice.V[i], static_cast<double>(static_cast<float>(slice.V[i])));
    }
  }
}

TEST(SliceSurface, AnySplitOfTheWorkGivesTheSameContours)
{
  Execution backwards;
  backwards.For = [](std::size_t count, const Execution::Range& run)
  {
    for (std::size_t i = count; i-- > 0;)
    {
      run(i, i + 1);
    }
  };
  TriangleSurface torus = TiltedTorus();
  ASSERT_EQ(CloseSurface(torus).Kind, SurfaceProblemKind::None);
  const auto planes = EvenPlanes(-1, 1, 11);
  const auto a = SliceSurface(torus, 0, planes, Precision::Double, Execution());
  const auto b = SliceSurface(torus, 0, planes, Precision::Double, backwards);
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    EXPECT_EQ(a[i].U, b[i].U);
    EXPECT_EQ(a[i].V, b[i].V);
    EXPECT_EQ(a[i].Offsets, b[i].Offsets);
  }
}

//----------------------------------------------------------------------------
// Checks of the surface

TEST(CloseSurface, NeighborsShareTheirSide)
{
  TriangleSurface torus = TiltedTorus();
  ASSERT_EQ(CloseSurface(torus).Kind, SurfaceProblemKind::None);
  for (std::size_t t = 0; t < torus.Triangles.size(); ++t)
  {
    for (int s = 0; s < 3; ++s)
    {
      const auto& neighbor = torus.Triangles[torus.Neighbors[t][s]];
      const Index from = torus.Triangles[t][s];
      const Index to = torus.Triangles[t][(s + 1) % 3];
      const auto place = std::find(neighbor.begin(), neighbor.end(), to) - neighbor.begin();
      ASSERT_LT(place, 3);
      EXPECT_EQ(neighbor[(place + 1) % 3], from);
    }
  }
}

TEST(CloseSurface, InwardSurfacesAreTurned)
{
  TriangleSurface inward = TiltedTorus();
  Reverse(inward);
  EXPECT_LT(SixfoldVolume(inward), 0.0);
  const auto expected = Slice(TiltedTorus(), 2, { 0.05 })[0];
  const auto turned = Slice(inward, 2, { 0.05 })[0];
  EXPECT_EQ(Areas(turned).size(), Areas(expected).size());
  EXPECT_NEAR(TotalArea(turned), TotalArea(expected), 1e-12);
  EXPECT_EQ(CloseSurface(inward).Kind, SurfaceProblemKind::None);
  EXPECT_GT(SixfoldVolume(inward), 0.0);
}

TEST(CloseSurface, IdenticalPointsAreJoinedWhereItWouldBeOpen)
{
  const TriangleSurface cube = UnitCube();
  TriangleSurface loose; // three points of its own for every triangle
  for (const auto& triangle : cube.Triangles)
  {
    const auto first = static_cast<Index>(loose.Points.size());
    for (const Index vertex : triangle)
    {
      loose.Points.push_back(cube.Points[vertex]);
    }
    loose.Triangles.push_back({ first, first + 1, first + 2 });
  }
  const PlaneContours slice = Slice(loose, 1, { 0.5 })[0];
  ASSERT_EQ(slice.Count(), 1);
  EXPECT_DOUBLE_EQ(Area(slice, 0), 1.0);
}

TEST(CloseSurface, TouchingBodiesStaySeparateIfTheyAre)
{
  TriangleSurface two = UnitCube();
  Append(two, Box({ 1, 1, 0 }, { 2, 2, 1 })); // they share an edge, but not its points
  const PlaneContours slice = Slice(two, 2, { 0.5 })[0];
  EXPECT_EQ(slice.Count(), 2);
  EXPECT_DOUBLE_EQ(TotalArea(slice), 2.0);
}

TEST(CloseSurface, CollapsedTrianglesAreDropped)
{
  TriangleSurface cube = UnitCube();
  cube.Triangles.push_back({ 1, 1, 5 });
  EXPECT_EQ(CloseSurface(cube).Kind, SurfaceProblemKind::None);
  EXPECT_EQ(cube.Triangles.size(), 12u);
}

TEST(CloseSurface, VerticesBetweenTwoBodiesAreNoProblem)
{
  TriangleSurface two = UnitCube();
  TriangleSurface other = Box({ 1, 1, 1 }, { 2, 2, 2 });
  Append(two, other);
  for (auto& triangle : two.Triangles)
  {
    std::replace(triangle.begin(), triangle.end(), Index(8), Index(7));
  }
  const auto slices = Slice(two, 2, { 0.5, 1.0, 1.5 });
  EXPECT_NEAR(TotalArea(slices[0]), 1.0, 1e-9);
  EXPECT_NEAR(TotalArea(slices[1]), 1.0, 1e-9);
  EXPECT_NEAR(TotalArea(slices[2]), 1.0, 1e-9);
}

TEST(CloseSurface, OpenEdgeIsNamed)
{
  TriangleSurface cube = UnitCube();
  cube.Triangles.pop_back(); // 1, 7, 5
  const SurfaceProblem problem = CloseSurface(cube);
  EXPECT_EQ(problem.Kind, SurfaceProblemKind::OpenEdge);
  EXPECT_EQ(problem.From, cube.Points[1]);
  EXPECT_EQ(problem.To, cube.Points[5]);
}

TEST(CloseSurface, OverusedEdgeIsNamed)
{
  TriangleSurface cube = UnitCube();
  cube.Points.push_back({ 3, 3, 3 });
  cube.Triangles.push_back({ 2, 6, 8 });
  cube.Triangles.push_back({ 6, 2, 8 });
  const SurfaceProblem problem = CloseSurface(cube);
  EXPECT_EQ(problem.Kind, SurfaceProblemKind::OverusedEdge);
  EXPECT_EQ(problem.From, cube.Points[2]);
  EXPECT_EQ(problem.To, cube.Points[6]);
}

TEST(CloseSurface, InconsistentEdgeIsNamed)
{
  TriangleSurface cube = UnitCube();
  std::swap(cube.Triangles[2][0], cube.Triangles[2][1]); // 5, 4, 7
  const SurfaceProblem problem = CloseSurface(cube);
  EXPECT_EQ(problem.Kind, SurfaceProblemKind::InconsistentEdge);
  EXPECT_EQ(problem.From, cube.Points[4]);
  EXPECT_EQ(problem.To, cube.Points[5]);
}

TEST(CloseSurface, PointsThatAreNotFiniteAreNamed)
{
  TriangleSurface cube = UnitCube();
  cube.Points[6][1] = std::numeric_limits<double>::infinity();
  const SurfaceProblem problem = CloseSurface(cube);
  EXPECT_EQ(problem.Kind, SurfaceProblemKind::NotFinite);
  EXPECT_EQ(problem.From, cube.Points[6]);
}

TEST(CloseSurface, AnEmptySurfaceHasNoContours)
{
  EXPECT_EQ(Slice(TriangleSurface(), 0, { 1.0 })[0].Count(), 0);
}

//----------------------------------------------------------------------------
TEST(PlaneContours, RepeatedVerticesAndThinContoursAreDropped)
{
  PlaneContours contours;
  for (const double u : { 0.0, 0.0, 1.0, 0.0, 1.0, 0.0 }) // two places only
  {
    contours.AddVertex(u, 0.0);
  }
  contours.CloseContour();
  EXPECT_EQ(contours.Count(), 0);
  EXPECT_TRUE(contours.U.empty());

  for (const double u : { 0.0, 1.0, 1.0, 2.0, 0.0 })
  {
    contours.AddVertex(u, u * u);
  }
  contours.CloseContour();
  EXPECT_EQ(contours.Count(), 1);
  EXPECT_EQ(contours.U, (std::vector<double>{ 0.0, 1.0, 2.0 }));
}
