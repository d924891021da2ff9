// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RuledSurface.h"

#include "CapLoops.h"
#include "PairByOverlap.h"
#include "PlanarContours.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRuledSurfaceFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace orthoslices
{
namespace baselines
{
namespace
{

// Strips are torn where rules get longer than this many first rules: never.
constexpr double NoTearing = 1e6;

//------------------------------------------------------------------------------
// The same loop as COUNT points at equal distances along it, from its first vertex on.
Loop Resample(const Loop& loop, int count)
{
  const double step = Perimeter(loop) / count;
  Loop result;
  std::size_t edge = 0;
  double edgeStart = 0.0;
  for (int i = 0; i < count; ++i)
  {
    for (;; ++edge)
    {
      const Point2& a = loop[edge];
      const Point2& b = loop[(edge + 1) % loop.size()];
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const double along = (i * step - edgeStart) / length;
      if (along <= 1.0 || edge + 1 == loop.size())
      {
        result.push_back({ a[0] + along * (b[0] - a[0]), a[1] + along * (b[1] - a[1]) });
        break;
      }
      edgeStart += length;
    }
  }
  return result;
}

//------------------------------------------------------------------------------
// How many steps B has to be turned so that the rules from A are shortest, for loops of as many
// points each.
std::size_t BestRotation(const Loop& a, const Loop& b)
{
  std::size_t best = 0;
  double minimum = std::numeric_limits<double>::max();
  for (std::size_t shift = 0; shift < b.size(); ++shift)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      const Point2& q = b[(i + shift) % b.size()];
      sum += std::pow(q[0] - a[i][0], 2) + std::pow(q[1] - a[i][1], 2);
    }
    if (sum < minimum)
    {
      minimum = sum;
      best = shift;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
std::size_t NearestVertex(const Loop& loop, const Point2& point)
{
  const auto distance2 = [&point](const Point2& p)
  { return std::pow(p[0] - point[0], 2) + std::pow(p[1] - point[1], 2); };
  const auto nearest = std::min_element(loop.begin(), loop.end(),
    [&distance2](const Point2& p, const Point2& q) { return distance2(p) < distance2(q); });
  return static_cast<std::size_t>(nearest - loop.begin());
}

//------------------------------------------------------------------------------
// Turns LOOP so that its first vertex suits the first vertex of its partner BELOW.
void AlignStart(const Loop& below, Loop& loop)
{
  constexpr int Samples = 128;
  const Loop samples = Resample(loop, Samples);
  const Point2 start = samples[BestRotation(Resample(below, Samples), samples)];
  std::rotate(loop.begin(), loop.begin() + NearestVertex(loop, start), loop.end());
}

//------------------------------------------------------------------------------
// Builds the surface of one stack of slices.
class Builder
{
public:
  Builder(const std::vector<Slice>& slices, RuledSurface::Mode mode, int resolution)
    : Stack(slices)
    , Mode(mode)
    , Resolution(resolution)
  {
    this->Points->SetDataTypeToDouble();
  }

  vtkSmartPointer<vtkPolyData> Build()
  {
    for (Slice& slice : this->Stack)
    {
      OrientByNesting(slice);
      this->Nodes.emplace_back(slice.Loops.size());
    }
    for (std::size_t i = 0; i + 1 < this->Stack.size(); ++i)
    {
      this->ConnectSlices(i);
    }
    for (std::size_t i = 0; i < this->Stack.size(); ++i)
    {
      this->CapSlice(i);
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(this->Points);
    surface->SetPolys(this->Triangles);
    return surface;
  }

private:
  // What became of a loop: whether it has partners, and its points on the surface.
  struct Node
  {
    bool HasBelow = false;
    bool HasAbove = false;
    std::vector<vtkIdType> Ids;
  };

  void ConnectSlices(std::size_t below)
  {
    for (const LoopPair& pair : PairByOverlap(this->Stack[below], this->Stack[below + 1]))
    {
      AlignStart(this->Stack[below].Loops[pair.Below], this->Stack[below + 1].Loops[pair.Above]);
      this->Nodes[below][pair.Below].HasAbove = true;
      this->Nodes[below + 1][pair.Above].HasBelow = true;
      this->AddStrip(below, pair);
    }
  }

  void AddStrip(std::size_t below, const LoopPair& pair)
  {
    const vtkSmartPointer<vtkPolyData> strip = this->RuleBetween(below, pair);
    const std::vector<vtkIdType>& lower = this->PlaceLoop(strip, below, pair.Below, 0);
    const std::vector<vtkIdType>& upper = this->PlaceLoop(strip, below + 1, pair.Above, 1);
    const auto onSurface = [&](vtkIdType id) { return this->SurfaceId(id, lower, upper); };
    const vtkIdType before = this->Triangles->GetNumberOfCells();
    vtkNew<vtkIdList> ids;
    strip->BuildCells();
    for (vtkIdType cell = 0; cell < strip->GetNumberOfCells(); ++cell)
    {
      strip->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); ++i)
      {
        const vtkIdType odd = i % 2; // every second triangle of a strip is turned
        this->AddTriangle(onSurface(ids->GetId(i + odd)), onSurface(ids->GetId(i + 1 - odd)),
          onSurface(ids->GetId(i + 2)));
      }
    }
    this->CloseStrip(this->Triangles->GetNumberOfCells() - before, lower, upper);
  }

  // Every edge of both loops has one triangle. The filter's walk stops one short if it comes to the
  // end of the upper loop before the end of the lower one.
  void CloseStrip(
    vtkIdType triangles, const std::vector<vtkIdType>& lower, const std::vector<vtkIdType>& upper)
  {
    if (triangles + 1 == static_cast<vtkIdType>(lower.size() + upper.size()))
    {
      this->AddTriangle(lower.front(), upper.front(), upper.back());
    }
  }

  // Two polylines, each closed by its first point, ruled by VTK.
  vtkSmartPointer<vtkPolyData> RuleBetween(std::size_t below, const LoopPair& pair) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    AppendLine(this->Stack[below], pair.Below, points, lines);
    AppendLine(this->Stack[below + 1], pair.Above, points, lines);
    vtkNew<vtkPolyData> input;
    input->SetPoints(points);
    input->SetLines(lines);
    vtkNew<vtkRuledSurfaceFilter> filter;
    filter->SetInputData(input);
    filter->SetDistanceFactor(NoTearing);
    filter->OrientLoopsOff();
    filter->SetResolution(this->Resolution, 1);
    filter->SetRuledMode(this->Mode == RuledSurface::Mode::Resample ? VTK_RULED_MODE_RESAMPLE
                                                                    : VTK_RULED_MODE_POINT_WALK);
    filter->Update();
    return filter->GetOutput();
  }

  static void AppendLine(
    const Slice& slice, std::size_t loop, vtkPoints* points, vtkCellArray* lines)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(slice.Loops[loop].size() + 1));
    for (const Point2& point : slice.Loops[loop])
    {
      lines->InsertCellPoint(
        points->InsertNextPoint(PlaceInSpace(2, slice.Coordinate, point).data()));
    }
    lines->InsertCellPoint(first);
  }

  // Ids of the points of a loop on the surface. The first strip at the loop makes them; SIDE is 0
  // or 1 if the loop is the strip's lower or upper one.
  const std::vector<vtkIdType>& PlaceLoop(
    vtkPolyData* strip, std::size_t slice, std::size_t loop, int side)
  {
    std::vector<vtkIdType>& ids = this->Nodes[slice][loop].Ids;
    if (ids.empty())
    {
      const bool walk = this->Mode == RuledSurface::Mode::PointWalk;
      const vtkIdType count = walk ? this->Stack[slice].Loops[loop].size() : this->Resolution;
      for (vtkIdType i = 0; i < count; ++i)
      {
        const vtkIdType fromEnd = strip->GetNumberOfPoints() - count;
        const vtkIdType id = walk ? (side == 0 ? i : fromEnd + i) : 2 * i + side;
        double p[3];
        strip->GetPoint(id, p);
        ids.push_back(this->Points->InsertNextPoint(p));
      }
    }
    return ids;
  }

  // The filter numbers walked points line after line, resampled ones in turns; the last resampled
  // point of a line is its first again.
  vtkIdType SurfaceId(
    vtkIdType id, const std::vector<vtkIdType>& lower, const std::vector<vtkIdType>& upper) const
  {
    const auto sizeOfLower = static_cast<vtkIdType>(lower.size());
    if (this->Mode == RuledSurface::Mode::PointWalk)
    {
      return id < sizeOfLower ? lower[id] : upper[id - sizeOfLower];
    }
    return (id % 2 == 0 ? lower : upper)[(id / 2) % sizeOfLower];
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (a != b && b != c && c != a)
    {
      const vtkIdType ids[3] = { a, b, c };
      this->Triangles->InsertNextCell(3, ids);
    }
  }

  void CapSlice(std::size_t slice)
  {
    std::vector<std::vector<vtkIdType>> upward;
    std::vector<std::vector<vtkIdType>> downward;
    for (const Node& node : this->Nodes[slice])
    {
      if (node.HasBelow && !node.HasAbove)
      {
        upward.push_back(node.Ids);
      }
      else if (node.HasAbove && !node.HasBelow)
      {
        downward.emplace_back(node.Ids.rbegin(), node.Ids.rend());
      }
    }
    CapLoops(upward, this->Points, this->Triangles);
    CapLoops(downward, this->Points, this->Triangles);
  }

  std::vector<Slice> Stack;
  RuledSurface::Mode Mode;
  int Resolution;
  std::vector<std::vector<Node>> Nodes; // of every slice, for every loop
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
};

} // anonymous namespace

//------------------------------------------------------------------------------
RuledSurface::RuledSurface(Mode mode, int resolution)
  : StripMode(mode)
  , Resolution(std::max(3, resolution))
{
}

//------------------------------------------------------------------------------
std::string RuledSurface::Name() const
{
  return this->StripMode == Mode::Resample ? "ruled-resample" : "ruled-walk";
}

//------------------------------------------------------------------------------
std::string RuledSurface::Description() const
{
  return this->StripMode == Mode::Resample
    ? "vtkRuledSurfaceFilter, resample mode, z-loops paired by overlap, aligned and capped"
    : "vtkRuledSurfaceFilter, point-walk mode, z-loops paired by overlap, aligned and capped";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> RuledSurface::Reconstruct(const SliceSets& slices) const
{
  return Builder(ExtractSlices(slices.Families[2], 2), this->StripMode, this->Resolution).Build();
}

//------------------------------------------------------------------------------
std::string NaiveRuledSurface::Description() const
{
  return "vtkRuledSurfaceFilter, resample mode, on the whole stack of z-contours as it is";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> NaiveRuledSurface::Reconstruct(const SliceSets& slices) const
{
  vtkNew<vtkRuledSurfaceFilter> filter;
  filter->SetInputData(slices.Families[2]);
  filter->SetRuledModeToResample();
  filter->SetResolution(50, 1);
  filter->OrientLoopsOff();
  filter->Update();
  return filter->GetOutput();
}

} // namespace baselines
} // namespace orthoslices
