// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Vtk/SurfaceMetrics.h"

#include "Support/NearestTriangle.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace orthoslices
{
namespace support
{
namespace
{

using Corners = std::array<vtkIdType, 3>;

//------------------------------------------------------------------------------
Vector3 Subtract(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

//------------------------------------------------------------------------------
// A triangle surface without coincident points and collapsed triangles.
struct Mesh
{
  std::vector<Vector3> Points;
  std::vector<Corners> Triangles;

  // Twice the area, in the direction of the normal.
  Vector3 AreaVector(std::size_t triangle) const
  {
    const Corners& c = this->Triangles[triangle];
    const Vector3& origin = this->Points[c[0]];
    return Cross(Subtract(this->Points[c[1]], origin), Subtract(this->Points[c[2]], origin));
  }

  double Area(std::size_t triangle) const
  {
    const Vector3 n = this->AreaVector(triangle);
    return 0.5 * std::sqrt(Dot(n, n));
  }
};

//------------------------------------------------------------------------------
std::vector<Vector3> CopyPoints(vtkPolyData* surface)
{
  std::vector<Vector3> points(surface->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), points[i].data());
    for (double& coordinate : points[i])
    {
      coordinate += 0.0; // -0 becomes 0
    }
  }
  return points;
}

//------------------------------------------------------------------------------
// For every point the first point, in lexicographic order, with the same coordinates.
std::vector<vtkIdType> FindRepresentatives(const std::vector<Vector3>& points)
{
  std::vector<vtkIdType> order(points.size());
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::sort(order.begin(), order.end(),
    [&points](vtkIdType a, vtkIdType b)
    { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  std::vector<vtkIdType> representative(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
    representative[order[i]] = same ? representative[order[i - 1]] : order[i];
  }
  return representative;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  return triangles->GetOutput();
}

//------------------------------------------------------------------------------
// Keeps the points that triangles use.
void DropUnusedPoints(Mesh& mesh)
{
  std::vector<vtkIdType> newId(mesh.Points.size(), -1);
  std::vector<Vector3> used;
  for (Corners& corners : mesh.Triangles)
  {
    for (vtkIdType& corner : corners)
    {
      if (newId[corner] < 0)
      {
        newId[corner] = static_cast<vtkIdType>(used.size());
        used.push_back(mesh.Points[corner]);
      }
      corner = newId[corner];
    }
  }
  mesh.Points = std::move(used);
}

//------------------------------------------------------------------------------
Mesh MakeMesh(vtkPolyData* surface)
{
  Mesh mesh;
  if (!surface || surface->GetNumberOfPoints() == 0)
  {
    return mesh;
  }
  const vtkSmartPointer<vtkPolyData> triangles = Triangulate(surface);
  mesh.Points = CopyPoints(triangles);
  const std::vector<vtkIdType> representative = FindRepresentatives(mesh.Points);
  auto cell = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    const Corners c{ representative[ids[0]], representative[ids[1]], representative[ids[2]] };
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0])
    {
      mesh.Triangles.push_back(c);
    }
  }
  DropUnusedPoints(mesh);
  return mesh;
}

//------------------------------------------------------------------------------
// Disjoint sets with path halving (R. E. Tarjan, "Efficiency of a good but not linear set union
// algorithm", Journal of the ACM 22(2), 1975).
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t(0));
  }

  std::size_t Find(std::size_t item)
  {
    while (this->Parent[item] != item)
    {
      this->Parent[item] = this->Parent[this->Parent[item]];
      item = this->Parent[item];
    }
    return item;
  }

  void Unite(std::size_t a, std::size_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> Parent;
};

//------------------------------------------------------------------------------
// One side of a triangle. Sides of the same edge follow each other after sorting.
struct Side
{
  vtkIdType Low;
  vtkIdType High;
  std::size_t Triangle;
  bool Ascending;

  bool IsSameEdge(const Side& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }

  bool operator<(const Side& other) const
  {
    return std::tie(this->Low, this->High, this->Triangle) <
      std::tie(other.Low, other.High, other.Triangle);
  }
};

//------------------------------------------------------------------------------
std::vector<Side> SortedSides(const Mesh& mesh)
{
  std::vector<Side> sides;
  sides.reserve(3 * mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType a = mesh.Triangles[t][k];
      const vtkIdType b = mesh.Triangles[t][(k + 1) % 3];
      sides.push_back({ std::min(a, b), std::max(a, b), t, a < b });
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

//------------------------------------------------------------------------------
// Counts what MeasureTopology returns. A vertex counts once in every fan of triangles around it,
// so that surfaces that touch in a vertex have the Euler characteristic of separate ones.
class TopologyCounter
{
public:
  explicit TopologyCounter(const Mesh& mesh)
    : Surface(mesh)
    , Components(mesh.Triangles.size())
    , Fans(3 * mesh.Triangles.size())
    , Open(3 * mesh.Triangles.size())
    , Irregular(mesh.Triangles.size(), false)
  {
  }

  Topology Count()
  {
    this->Result.Points = static_cast<std::int64_t>(this->Surface.Points.size());
    this->Result.Triangles = static_cast<std::int64_t>(this->Surface.Triangles.size());
    this->JoinTriangles();
    this->CountNonManifoldVertices();
    this->CountComponents();
    this->CountGenus();
    return this->Result;
  }

private:
  // The parts of one component's Euler characteristic.
  struct Component
  {
    std::int64_t Euler = 0;
    std::int64_t Boundaries = 0;
    bool IsRegular = true;
  };

  // Index of the corner of TRIANGLE at POINT, one of 3 n.
  std::size_t CornerAt(std::size_t triangle, vtkIdType point) const
  {
    const Corners& corners = this->Surface.Triangles[triangle];
    const auto found = std::find(corners.begin(), corners.end(), point);
    return 3 * triangle + static_cast<std::size_t>(found - corners.begin());
  }

  void JoinTriangles()
  {
    const std::vector<Side> sides = SortedSides(this->Surface);
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last)
    {
      while (last < sides.size() && sides[last].IsSameEdge(sides[first]))
      {
        this->Components.Unite(sides[first].Triangle, sides[last].Triangle);
        ++last;
      }
      this->ClassifyEdge(&sides[first], last - first);
      this->EdgeTriangles.push_back(sides[first].Triangle);
    }
    for (const Side& side : this->OpenSides)
    {
      this->JoinBoundary(side);
    }
  }

  void ClassifyEdge(const Side* sides, std::size_t count)
  {
    if (count == 1)
    {
      ++this->Result.OpenEdges;
      this->OpenSides.push_back(sides[0]);
    }
    else if (count == 2)
    {
      this->JoinFans(sides[0], sides[1]);
    }
    else
    {
      ++this->Result.NonManifoldEdges;
      this->Irregular[sides[0].Triangle] = true;
    }
  }

  void JoinFans(const Side& a, const Side& b)
  {
    if (a.Ascending == b.Ascending)
    {
      ++this->Result.InconsistentEdges;
      this->Irregular[a.Triangle] = true;
    }
    for (const vtkIdType point : { a.Low, a.High })
    {
      this->Fans.Unite(this->CornerAt(a.Triangle, point), this->CornerAt(b.Triangle, point));
    }
  }

  // Boundary loops are connected sets of fans; every open edge joins the fans at its ends.
  void JoinBoundary(const Side& side)
  {
    this->Open.Unite(this->Fans.Find(this->CornerAt(side.Triangle, side.Low)),
      this->Fans.Find(this->CornerAt(side.Triangle, side.High)));
  }

  void CountNonManifoldVertices()
  {
    std::vector<int> fans(this->Surface.Points.size(), 0);
    for (std::size_t corner = 0; corner < 3 * this->Surface.Triangles.size(); ++corner)
    {
      fans[this->Surface.Triangles[corner / 3][corner % 3]] += this->Fans.Find(corner) == corner;
    }
    this->Result.NonManifoldVertices =
      std::count_if(fans.begin(), fans.end(), [](int count) { return count > 1; });
  }

  void CountComponents()
  {
    this->Parts.resize(this->Surface.Triangles.size());
    for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
    {
      Component& part = this->Parts[this->Components.Find(t)];
      part.IsRegular = part.IsRegular && !this->Irregular[t];
      part.Euler += 1;
      for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner)
      {
        part.Euler += this->Fans.Find(corner) == corner;
      }
      this->Result.Components += this->Components.Find(t) == t;
    }
    for (const std::size_t triangle : this->EdgeTriangles)
    {
      --this->Parts[this->Components.Find(triangle)].Euler;
    }
    this->CountBoundaries();
  }

  void CountBoundaries()
  {
    std::vector<bool> seen(3 * this->Surface.Triangles.size(), false);
    for (const Side& side : this->OpenSides)
    {
      const std::size_t fan = this->Fans.Find(this->CornerAt(side.Triangle, side.Low));
      const std::size_t loop = this->Open.Find(fan);
      this->Parts[this->Components.Find(side.Triangle)].Boundaries += !seen[loop];
      seen[loop] = true;
    }
  }

  void CountGenus()
  {
    std::int64_t genus = 0;
    bool exists = this->Result.Triangles > 0;
    for (std::size_t t = 0; t < this->Parts.size(); ++t)
    {
      if (this->Components.Find(t) != t)
      {
        continue;
      }
      const Component& part = this->Parts[t];
      const std::int64_t twice = 2 - part.Euler - part.Boundaries;
      exists = exists && part.IsRegular && twice >= 0 && twice % 2 == 0;
      this->Result.EulerCharacteristic += part.Euler;
      genus += twice / 2;
    }
    if (exists)
    {
      this->Result.Genus = genus;
    }
  }

  const Mesh& Surface;
  DisjointSets Components;     // of triangles
  DisjointSets Fans;           // of corners
  DisjointSets Open;           // of fans on the boundary
  std::vector<bool> Irregular; // triangles at non-manifold or inconsistent edges
  std::vector<Side> OpenSides;
  std::vector<std::size_t> EdgeTriangles; // one triangle of every edge
  std::vector<Component> Parts;           // at the first triangle of each component
  Topology Result;
};

//------------------------------------------------------------------------------
// A number in [0, 1) that depends on INDEX only (finalizer of S. Vigna's splitmix64).
double HashToUnit(std::uint64_t index)
{
  std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

//------------------------------------------------------------------------------
// Points on a surface, one in each of many parts of equal area.
class StratifiedSampler
{
public:
  StratifiedSampler(const Mesh& mesh, std::int64_t samples)
    : Surface(mesh)
    , Samples(samples)
  {
    this->AreaUpTo.reserve(mesh.Triangles.size());
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      area += mesh.Area(t);
      this->AreaUpTo.push_back(area);
    }
  }

  double TotalArea() const { return this->AreaUpTo.empty() ? 0.0 : this->AreaUpTo.back(); }

  // Triangle and position of sample INDEX.
  std::size_t Sample(std::int64_t index, Vector3& position) const
  {
    const std::uint64_t seed = 3 * static_cast<std::uint64_t>(index);
    const double area = (index + HashToUnit(seed)) / this->Samples * this->TotalArea();
    const auto found = std::upper_bound(this->AreaUpTo.begin(), this->AreaUpTo.end(), area);
    const std::size_t triangle =
      std::min<std::size_t>(found - this->AreaUpTo.begin(), this->Surface.Triangles.size() - 1);
    this->PlaceIn(triangle, std::sqrt(HashToUnit(seed + 1)), HashToUnit(seed + 2), position);
    return triangle;
  }

private:
  // Uniform in the triangle if ROOT is the root of a uniform number.
  void PlaceIn(std::size_t triangle, double root, double along, Vector3& position) const
  {
    const Corners& corners = this->Surface.Triangles[triangle];
    const double weights[3] = { 1.0 - root, root * (1.0 - along), root * along };
    position = { 0.0, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        position[axis] += weights[k] * this->Surface.Points[corners[k]][axis];
      }
    }
  }

  const Mesh& Surface;
  std::int64_t Samples;
  std::vector<double> AreaUpTo;
};

//------------------------------------------------------------------------------
NearestTriangle MakeSearch(const Mesh& mesh)
{
  std::vector<NearestTriangle::Triangle> triangles;
  triangles.reserve(mesh.Triangles.size());
  for (const Corners& c : mesh.Triangles)
  {
    triangles.push_back({ mesh.Points[c[0]], mesh.Points[c[1]], mesh.Points[c[2]] });
  }
  return NearestTriangle(std::move(triangles));
}

//------------------------------------------------------------------------------
double AngleDegrees(const Vector3& a, const Vector3& b)
{
  const double product = std::sqrt(Dot(a, a) * Dot(b, b));
  const double cosine = product > 0.0 ? Dot(a, b) / product : 0.0;
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232;
}

//------------------------------------------------------------------------------
// Distances of all points of FROM, the largest of them.
double LargestVertexDistance(const Mesh& from, const NearestTriangle& nearest, std::int64_t maximum)
{
  const std::size_t step = 1 + from.Points.size() / static_cast<std::size_t>(maximum);
  std::vector<double> distances((from.Points.size() + step - 1) / step);
  vtkSMPTools::For(0, static_cast<vtkIdType>(distances.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        distances[i] = nearest.Find(from.Points[step * i]).Distance;
      }
    });
  return distances.empty() ? 0.0 : *std::max_element(distances.begin(), distances.end());
}

//------------------------------------------------------------------------------
// From samples on FROM to TO. RootMeanSquare holds the mean square here.
Deviation MeasureOneSide(
  const Mesh& from, const Mesh& to, const StratifiedSampler& sampler, std::int64_t samples)
{
  const NearestTriangle nearest = MakeSearch(to);
  std::vector<double> distances(samples);
  std::vector<double> angles(samples);
  vtkSMPTools::For(0, samples,
    [&](vtkIdType begin, vtkIdType end)
    {
      Vector3 position;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::size_t triangle = sampler.Sample(i, position);
        const NearestTriangle::Result foot = nearest.Find(position);
        distances[i] = foot.Distance;
        angles[i] = AngleDegrees(from.AreaVector(triangle), to.AreaVector(foot.Triangle));
      }
    });
  Deviation result;
  result.Mean = std::accumulate(distances.begin(), distances.end(), 0.0) / samples;
  result.RootMeanSquare =
    std::inner_product(distances.begin(), distances.end(), distances.begin(), 0.0) / samples;
  result.NormalDegrees = std::accumulate(angles.begin(), angles.end(), 0.0) / samples;
  result.Hausdorff = std::max(*std::max_element(distances.begin(), distances.end()),
    LargestVertexDistance(from, nearest, 10 * samples));
  return result;
}

} // anonymous namespace

//------------------------------------------------------------------------------
Deviation Deviation::ScaledBy(double factor) const
{
  Deviation scaled = *this;
  scaled.RootMeanSquare *= factor;
  scaled.Mean *= factor;
  scaled.Hausdorff *= factor;
  return scaled;
}

//------------------------------------------------------------------------------
Topology MeasureTopology(vtkPolyData* surface)
{
  const Mesh mesh = MakeMesh(surface);
  return TopologyCounter(mesh).Count();
}

//------------------------------------------------------------------------------
double MeasureVolume(vtkPolyData* surface)
{
  const Mesh mesh = MakeMesh(surface);
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const Vector3 fromFirst = Subtract(mesh.Points[mesh.Triangles[t][0]], mesh.Points[0]);
    volume += Dot(fromFirst, mesh.AreaVector(t)) / 6.0;
  }
  return volume;
}

//------------------------------------------------------------------------------
double MeasureArea(vtkPolyData* surface)
{
  const Mesh mesh = MakeMesh(surface);
  return StratifiedSampler(mesh, 1).TotalArea();
}

//------------------------------------------------------------------------------
std::optional<Deviation> MeasureDeviation(
  vtkPolyData* surface, vtkPolyData* truth, std::int64_t samples)
{
  const Mesh a = MakeMesh(surface);
  const Mesh b = MakeMesh(truth);
  const StratifiedSampler onA(a, samples);
  const StratifiedSampler onB(b, samples);
  if (samples < 1 || !(onA.TotalArea() > 0.0) || !(onB.TotalArea() > 0.0))
  {
    return std::nullopt;
  }
  const Deviation ab = MeasureOneSide(a, b, onA, samples);
  const Deviation ba = MeasureOneSide(b, a, onB, samples);
  Deviation both;
  both.Mean = 0.5 * (ab.Mean + ba.Mean);
  both.RootMeanSquare = std::sqrt(0.5 * (ab.RootMeanSquare + ba.RootMeanSquare));
  both.Hausdorff = std::max(ab.Hausdorff, ba.Hausdorff);
  both.NormalDegrees = 0.5 * (ab.NormalDegrees + ba.NormalDegrees);
  return both;
}

} // namespace support
} // namespace orthoslices
