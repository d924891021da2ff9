// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CheckLabels.h"

#include "Core/Base/Box.h"
#include "Core/Base/Predicates.h"
#include "Support/CheckEmbedding.h"

#include <algorithm>
#include <numeric>

namespace orthoslices
{
namespace support
{
namespace
{
using Corners = std::array<Point3, 3>;

std::vector<Corners> ListCorners(const TriangleMesh& mesh)
{
  std::vector<Corners> corners;
  for (const auto& ids : mesh.Triangles)
  {
    corners.push_back({ mesh.Points[ids[0]], mesh.Points[ids[1]], mesh.Points[ids[2]] });
  }
  return corners;
}

/// Corners are common if they are at the same place.
bool PiercesWhereApart(const Corners& s, const Corners& t)
{
  const auto isCorner = [&](const Point3& p)
  { return std::find(t.begin(), t.end(), p) != t.end(); };
  return Pierces(s, t, { isCorner(s[0]), isCorner(s[1]), isCorner(s[2]) });
}

/// Whether two segments cross, each inside, in a plane across an axis.
bool DoCrossInPlane(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto inPlane = [axis](const Point3& p) {
      return Point2{ p[FirstAxis(axis)], p[SecondAxis(axis)] };
    };
    const Point2 p = inPlane(a), q = inPlane(b), r = inPlane(c), s = inPlane(d);
    if (a[axis] == b[axis] && a[axis] == c[axis] && a[axis] == d[axis] &&
      SideOf(p, q, r) * SideOf(p, q, s) < 0 && SideOf(r, s, p) * SideOf(r, s, q) < 0)
    {
      return true;
    }
  }
  return false;
}

bool DoSidesCross(const Corners& s, const Corners& t)
{
  for (int i = 0; i < 9; ++i)
  {
    if (DoCrossInPlane(s[i / 3], s[(i / 3 + 1) % 3], t[i % 3], t[(i % 3 + 1) % 3]))
    {
      return true;
    }
  }
  return false;
}

Box3 BoxAround(const Corners& corners)
{
  Box3 box;
  for (const Point3& p : corners)
  {
    box.Add(p);
  }
  return box;
}

/// Where a line passes into a structure, or out of it.
struct Passage
{
  double X;
  int Label;
  int Change; ///< 1 into it, -1 out of it
};

bool operator<(const Passage& a, const Passage& b) { return a.X < b.X; }

/// Adds where the line along x at (y, z) passes a triangle.
void AddPassage(const Corners& t, int label, double y, double z, std::vector<Passage>& passages)
{
  const auto area = [&](int i)
  {
    const Point3 &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
    return (a[1] - y) * (b[2] - z) - (a[2] - z) * (b[1] - y);
  };
  const std::array<double, 3> areas{ area(0), area(1), area(2) };
  const auto [low, high] = std::minmax_element(areas.begin(), areas.end());
  if (*low > 0.0 || *high < 0.0)
  {
    const double sum = areas[0] + areas[1] + areas[2];
    const double x = (areas[0] * t[0][0] + areas[1] * t[1][0] + areas[2] * t[2][0]) / sum;
    passages.push_back({ x, label, sum > 0.0 ? -1 : 1 });
  }
}

/// Adds what a line passes, for as much area as it stands for.
void AddLine(std::vector<Passage>& passages, double area, LabelVolumes& volumes)
{
  std::sort(passages.begin(), passages.end());
  std::vector<int> inside(volumes.OfLabel.size(), 0);
  for (std::size_t i = 0; i < passages.size(); ++i)
  {
    const double part = i > 0 ? (passages[i].X - passages[i - 1].X) * area : 0.0;
    int count = 0;
    for (std::size_t label = 0; label < inside.size(); ++label)
    {
      count += inside[label] > 0 ? 1 : 0;
      volumes.OfLabel[label] += inside[label] > 0 ? part : 0.0;
    }
    volumes.Overlap += count > 1 ? (count - 1) * part : 0.0;
    volumes.Gap += count == 0 ? part : 0.0;
    inside[passages[i].Label] += passages[i].Change;
  }
}

/// Pairs of triangles of different labels whose boxes meet and for which a condition holds.
template <class Condition>
std::int64_t CountPairs(
  const TriangleMesh& mesh, const std::vector<int>& labels, const Condition& condition)
{
  const std::vector<Corners> corners = ListCorners(mesh);
  std::vector<Box3> boxes;
  std::transform(corners.begin(), corners.end(), std::back_inserter(boxes), BoxAround);
  std::vector<std::size_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return boxes[a].Low[1] < boxes[b].Low[1]; });
  std::int64_t pairs = 0;
  for (auto a = order.begin(); a != order.end(); ++a)
  {
    for (auto b = a + 1; b != order.end() && boxes[*b].Low[1] <= boxes[*a].High[1]; ++b)
    {
      const bool doMeet =
        labels[*a] != labels[*b] && boxes[*a].Meets(boxes[*b], 0) && boxes[*a].Meets(boxes[*b], 2);
      pairs += doMeet && condition(corners[*a], corners[*b]) ? 1 : 0;
    }
  }
  return pairs;
}
}

std::int64_t CountLabelCrossings(const TriangleMesh& mesh, const std::vector<int>& labels)
{
  return CountPairs(mesh, labels,
    [](const Corners& s, const Corners& t)
    { return PiercesWhereApart(s, t) || PiercesWhereApart(t, s) || DoSidesCross(s, t); });
}

LabelVolumes MeasureLabels(const TriangleMesh& mesh, const std::vector<int>& labels, int lines)
{
  const std::vector<Corners> corners = ListCorners(mesh);
  Box3 box;
  for (const Point3& p : mesh.Points)
  {
    box.Add(p);
  }
  const double stepY = (box.High[1] - box.Low[1]) / lines;
  const double stepZ = (box.High[2] - box.Low[2]) / lines;
  // Lines lie off the middles of their squares, so that they pass no corners of regular meshes.
  constexpr double shareY = 0.5017, shareZ = 0.4983;
  std::vector<std::vector<Passage>> passages(static_cast<std::size_t>(lines) * lines);
  for (std::size_t t = 0; t < corners.size(); ++t)
  {
    const Box3 of = BoxAround(corners[t]);
    const auto place = [lines](double x, double low, double step)
    { return std::max(0, std::min(lines - 1, static_cast<int>((x - low) / step))); };
    for (int i = place(of.Low[1], box.Low[1], stepY); i <= place(of.High[1], box.Low[1], stepY);
         ++i)
    {
      for (int j = place(of.Low[2], box.Low[2], stepZ); j <= place(of.High[2], box.Low[2], stepZ);
           ++j)
      {
        AddPassage(corners[t], labels[t], box.Low[1] + (i + shareY) * stepY,
          box.Low[2] + (j + shareZ) * stepZ, passages[static_cast<std::size_t>(i) * lines + j]);
      }
    }
  }
  LabelVolumes volumes;
  const auto last = std::max_element(labels.begin(), labels.end());
  volumes.OfLabel.assign(last == labels.end() ? 0 : *last + 1, 0.0);
  for (std::vector<Passage>& line : passages)
  {
    AddLine(line, stepY * stepZ, volumes);
  }
  return volumes;
}

} // namespace support
} // namespace orthoslices
