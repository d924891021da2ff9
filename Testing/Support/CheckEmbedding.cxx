// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CheckEmbedding.h"

#include "Support/CheckSurface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace orthoslices
{
namespace support
{
namespace
{
/// A sum of doubles that is never rounded: its terms do not overlap and ascend.
class ExactSum
{
public:
  void Add(double x)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const double total = x + this->Terms[i];
      const double part = total - x;
      const double error = (x - (total - part)) + (this->Terms[i] - part);
      if (error != 0.0)
      {
        this->Terms[kept++] = error;
      }
      x = total;
    }
    if (x != 0.0)
    {
      this->Terms[kept++] = x;
    }
    this->Count = kept;
  }

  void AddProduct(double x, double y)
  {
    if (x == 0.0 || y == 0.0)
    {
      return;
    }
    const double product = x * y;
    this->Add(std::fma(x, y, -product));
    this->Add(product);
  }

  void AddProduct(double x, double y, double z)
  {
    const double product = x * y;
    this->AddProduct(std::fma(x, y, -product), z);
    this->AddProduct(product, z);
  }

  int Sign() const { return this->Count == 0 ? 0 : this->Terms[this->Count - 1] > 0.0 ? 1 : -1; }

private:
  std::array<double, 128> Terms; // four products of three numbers in each of 24 places, at most
  std::size_t Count = 0;
};

/// Adds the determinant of three points, times a sign.
void AddDeterminant(ExactSum& sum, const Point3& a, const Point3& b, const Point3& c, double sign)
{
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (a[i] == 0.0)
    {
      continue;
    }
    sum.AddProduct(sign * a[i], b[j], c[k]);
    sum.AddProduct(-sign * a[i], b[k], c[j]);
  }
}
}

namespace
{
/// a - b, and whether it was not rounded.
bool Subtract(const Point3& a, const Point3& b, Point3& difference)
{
  bool exact = true;
  for (int i = 0; i < 3; ++i)
  {
    const double d = a[i] - b[i];
    const double part = d - a[i];
    exact &= (a[i] - (d - part)) - (b[i] + part) == 0.0;
    difference[i] = d;
  }
  return exact;
}
}

int ExactOrientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  Point3 p, q, r;
  bool exact = Subtract(a, d, p);
  exact &= Subtract(b, d, q);
  exact &= Subtract(c, d, r);
  double value = 0.0, size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    value += p[i] * (q[j] * r[k] - q[k] * r[j]);
    size += std::abs(p[i]) * (std::abs(q[j] * r[k]) + std::abs(q[k] * r[j]));
  }
  // Far more than the rounding errors of the lines above; the smallest numbers go the long way.
  if (std::abs(value) > 1e-14 * size && size > 1e-280)
  {
    return value > 0.0 ? 1 : -1;
  }
  ExactSum sum;
  if (exact)
  {
    AddDeterminant(sum, p, q, r, 1.0);
    return sum.Sign();
  }
  AddDeterminant(sum, a, b, c, 1.0);
  AddDeterminant(sum, a, b, d, -1.0);
  AddDeterminant(sum, a, c, d, 1.0);
  AddDeterminant(sum, b, c, d, -1.0);
  return sum.Sign();
}

int ExactTurn(const Point3& a, const Point3& b, const Point3& c, int axis)
{
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double left = (a[i] - c[i]) * (b[j] - c[j]);
  const double right = (a[j] - c[j]) * (b[i] - c[i]);
  const double size = std::abs(left) + std::abs(right);
  if (std::abs(left - right) > 1e-15 * size && size > 1e-280)
  {
    return left > right ? 1 : -1;
  }
  ExactSum sum;
  const Point3* points[4] = { &a, &b, &c, &a };
  for (int n = 0; n < 3; ++n)
  {
    sum.AddProduct((*points[n])[i], (*points[n + 1])[j]);
    sum.AddProduct(-(*points[n])[j], (*points[n + 1])[i]);
  }
  return sum.Sign();
}

namespace
{
using Corners = std::array<Point3, 3>;

/// An axis along which the triangle is seen with an area; -1 if it has none.
int AxisOfSight(const Corners& t)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (ExactTurn(t[0], t[1], t[2], axis) != 0)
    {
      return axis;
    }
  }
  return -1;
}

/// Whether c lies between a and b on their line (all three are known to be on one line).
bool IsBetween(const Point3& a, const Point3& b, const Point3& c, int axis)
{
  const auto between = [&](int i)
  { return std::min(a[i], b[i]) <= c[i] && c[i] <= std::max(a[i], b[i]); };
  return between((axis + 1) % 3) && between((axis + 2) % 3);
}

}

bool SegmentsMeet(const Point3& a, const Point3& b, const Point3& c, const Point3& d, int axis)
{
  const int abc = ExactTurn(a, b, c, axis), abd = ExactTurn(a, b, d, axis);
  const int cda = ExactTurn(c, d, a, axis), cdb = ExactTurn(c, d, b, axis);
  if (abc * abd < 0 && cda * cdb < 0)
  {
    return true;
  }
  return (abc == 0 && IsBetween(a, b, c, axis)) || (abd == 0 && IsBetween(a, b, d, axis)) ||
    (cda == 0 && IsBetween(c, d, a, axis)) || (cdb == 0 && IsBetween(c, d, b, axis));
}

namespace
{
/// Segment and triangle in one plane.
bool MeetInPlane(const Point3& p, const Point3& q, const Corners& t)
{
  const int axis = AxisOfSight(t);
  const int turn = ExactTurn(t[0], t[1], t[2], axis);
  bool inside = true;
  for (int i = 0; i < 3; ++i)
  {
    const Point3& a = t[i];
    const Point3& b = t[(i + 1) % 3];
    inside &= ExactTurn(a, b, p, axis) * turn >= 0;
    if (SegmentsMeet(p, q, a, b, axis))
    {
      return true;
    }
  }
  return inside;
}

/// On which sides of the triangle's plane the corners of another one lie.
std::array<int, 3> SidesOf(const Corners& s, const Corners& t)
{
  return { ExactOrientation(t[0], t[1], t[2], s[0]), ExactOrientation(t[0], t[1], t[2], s[1]),
    ExactOrientation(t[0], t[1], t[2], s[2]) };
}

bool AreAllOnOneSide(const std::array<int, 3>& sides)
{
  return std::abs(sides[0] + sides[1] + sides[2]) == 3;
}

}

bool Pierces(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t,
  const std::array<bool, 3>& isCommon)
{
  const std::array<int, 3> sides = SidesOf(s, t);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    if (isCommon[i] || isCommon[j] || sides[i] * sides[j] >= 0)
    {
      continue;
    }
    const int side = ExactOrientation(s[i], s[j], t[0], t[1]);
    if (side != 0 && ExactOrientation(s[i], s[j], t[1], t[2]) == side &&
      ExactOrientation(s[i], s[j], t[2], t[0]) == side)
    {
      return true;
    }
  }
  return false;
}

namespace
{
/// Whether the closed segment and the closed triangle (with an area) have a point in common; with
/// the sides of its plane on which the segment's ends lie.
bool SegmentMeetsTriangle(const Point3& p, int sideP, const Point3& q, int sideQ, const Corners& t)
{
  if (sideP * sideQ > 0)
  {
    return false;
  }
  if (sideP == 0 && sideQ == 0)
  {
    return MeetInPlane(p, q, t);
  }
  // The line through p and q passes the three edges on the same side, or touches them.
  int minimum = 1, maximum = -1;
  for (int i = 0; i < 3; ++i)
  {
    const int side = ExactOrientation(p, q, t[i], t[(i + 1) % 3]);
    minimum = std::min(minimum, side);
    maximum = std::max(maximum, side);
  }
  return minimum >= 0 || maximum <= 0;
}

/// Whether the edge from corner i of the first triangle meets the second.
bool EdgeMeets(const Corners& s, const std::array<int, 3>& sides, std::size_t i, const Corners& t)
{
  const std::size_t j = (i + 1) % 3;
  return SegmentMeetsTriangle(s[i], sides[i], s[j], sides[j], t);
}

bool AnyEdgeMeets(const Corners& s, const std::array<int, 3>& sides, const Corners& t)
{
  return EdgeMeets(s, sides, 0, t) || EdgeMeets(s, sides, 1, t) || EdgeMeets(s, sides, 2, t);
}

/// Triangles abc and abd: they overlap if they lie in one plane on the same side of ab.
bool OverlapAtEdge(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  if (ExactOrientation(a, b, c, d) != 0)
  {
    return false;
  }
  const int axis = AxisOfSight({ a, b, c });
  return ExactTurn(a, b, c, axis) * ExactTurn(a, b, d, axis) > 0;
}

class MeetingFinder
{
public:
  explicit MeetingFinder(const TriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  std::vector<Meeting> Find(std::size_t maximum) const;
  std::int64_t CountCrossings() const;

private:
  struct Box
  {
    Point3 Low, High;
    std::int64_t Triangle;
  };

  Corners CornersOf(const std::array<std::int64_t, 3>& ids) const
  {
    return { this->Mesh.Points[ids[0]], this->Mesh.Points[ids[1]], this->Mesh.Points[ids[2]] };
  }
  int LongestAxis() const;
  std::vector<Box> SortedBoxes(int axis) const;
  /// Calls the function for pairs of triangles whose boxes overlap, until it returns false.
  void VisitNeighbours(const std::function<bool(std::int64_t, std::int64_t)>& visit) const;
  bool Meet(std::int64_t a, std::int64_t b) const;
  bool SidePierces(std::int64_t a, std::int64_t b) const;

  const TriangleMesh& Mesh;
};

int MeetingFinder::LongestAxis() const
{
  Point3 length{ 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3 && !this->Mesh.Points.empty(); ++axis)
  {
    const auto ends = std::minmax_element(this->Mesh.Points.begin(), this->Mesh.Points.end(),
      [axis](const Point3& a, const Point3& b) { return a[axis] < b[axis]; });
    length[axis] = (*ends.second)[axis] - (*ends.first)[axis];
  }
  return static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
}

std::vector<MeetingFinder::Box> MeetingFinder::SortedBoxes(int axis) const
{
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
  {
    const Corners corners = this->CornersOf(this->Mesh.Triangles[t]);
    Box box{ corners[0], corners[0], static_cast<std::int64_t>(t) };
    for (const Point3& p : corners)
    {
      for (int i = 0; i < 3; ++i)
      {
        box.Low[i] = std::min(box.Low[i], p[i]);
        box.High[i] = std::max(box.High[i], p[i]);
      }
    }
    boxes.push_back(box);
  }
  std::sort(boxes.begin(), boxes.end(),
    [axis](const Box& a, const Box& b) { return a.Low[axis] < b.Low[axis]; });
  return boxes;
}

bool MeetingFinder::Meet(std::int64_t first, std::int64_t second) const
{
  // Common corners come first, in the same order.
  auto ids = this->Mesh.Triangles[first], others = this->Mesh.Triangles[second];
  std::size_t common = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto same = std::find(others.begin() + common, others.end(), ids[i]);
    if (same != others.end())
    {
      std::iter_swap(same, others.begin() + common);
      std::swap(ids[i], ids[common]);
      ++common;
    }
  }
  const Corners s = this->CornersOf(ids), t = this->CornersOf(others);
  if (common >= 2)
  {
    return common == 3 || OverlapAtEdge(s[0], s[1], s[2], t[2]);
  }
  const std::array<int, 3> sidesOfS = SidesOf(s, t);
  if (AreAllOnOneSide(sidesOfS))
  {
    return false;
  }
  const std::array<int, 3> sidesOfT = SidesOf(t, s);
  if (AreAllOnOneSide(sidesOfT))
  {
    return false;
  }
  if (common == 0)
  {
    return AnyEdgeMeets(s, sidesOfS, t) || AnyEdgeMeets(t, sidesOfT, s);
  }
  // What they have in common is convex: more than the corner reaches an opposite side.
  return EdgeMeets(s, sidesOfS, 1, t) || EdgeMeets(t, sidesOfT, 1, s);
}

/// A side of `a` without a corner of `b` passes from one side of `b` to the other through its
/// inside.
bool MeetingFinder::SidePierces(std::int64_t a, std::int64_t b) const
{
  const auto &ids = this->Mesh.Triangles[a], &others = this->Mesh.Triangles[b];
  const auto isCorner = [&](std::int64_t id)
  { return std::find(others.begin(), others.end(), id) != others.end(); };
  const Corners s = this->CornersOf(ids), t = this->CornersOf(others);
  return Pierces(s, t, { isCorner(ids[0]), isCorner(ids[1]), isCorner(ids[2]) });
}

void MeetingFinder::VisitNeighbours(
  const std::function<bool(std::int64_t, std::int64_t)>& visit) const
{
  const int axis = this->LongestAxis();
  const std::vector<Box> boxes = this->SortedBoxes(axis);
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    const Box& a = boxes[i];
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].Low[axis] <= a.High[axis]; ++j)
    {
      const Box& b = boxes[j];
      const auto apart = [&](int n) { return a.Low[n] > b.High[n] || b.Low[n] > a.High[n]; };
      const bool overlap = !apart((axis + 1) % 3) && !apart((axis + 2) % 3);
      if (overlap && !visit(a.Triangle, b.Triangle))
      {
        return;
      }
    }
  }
}

std::vector<Meeting> MeetingFinder::Find(std::size_t maximum) const
{
  std::vector<Meeting> found;
  std::vector<std::uint8_t> flat(this->Mesh.Triangles.size(), 0);
  for (std::size_t t = 0; t < flat.size() && found.size() < maximum; ++t)
  {
    const auto id = static_cast<std::int64_t>(t);
    flat[t] = AxisOfSight(this->CornersOf(this->Mesh.Triangles[t])) < 0;
    if (flat[t])
    {
      found.push_back({ id, id });
    }
  }
  if (found.size() < maximum)
  {
    this->VisitNeighbours(
      [&](std::int64_t a, std::int64_t b)
      {
        if (!flat[a] && !flat[b] && this->Meet(a, b))
        {
          found.push_back({ a, b });
        }
        return found.size() < maximum;
      });
  }
  return found;
}

std::int64_t MeetingFinder::CountCrossings() const
{
  std::int64_t crossings = 0;
  this->VisitNeighbours(
    [&](std::int64_t a, std::int64_t b)
    {
      crossings += this->SidePierces(a, b) || this->SidePierces(b, a) ? 1 : 0;
      return true;
    });
  return crossings;
}

void WriteTriangle(const TriangleMesh& mesh, std::int64_t t, std::ostream& os)
{
  os << "  triangle " << t << ":";
  for (const std::int64_t id : mesh.Triangles[t])
  {
    const Point3& p = mesh.Points[id];
    os << " #" << id << " (" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  }
  os << "\n";
}
}

std::vector<Meeting> FindMeetings(const TriangleMesh& mesh, std::size_t maximum)
{
  return MeetingFinder(mesh).Find(maximum);
}

std::int64_t CountCrossings(const TriangleMesh& mesh)
{
  return MeetingFinder(mesh).CountCrossings();
}

std::string DescribeFlaws(const TriangleMesh& mesh)
{
  std::ostringstream text;
  text.precision(17);
  for (const Point3& p : mesh.Points)
  {
    if (!std::isfinite(p[0] + p[1] + p[2]))
    {
      return "a point is not finite";
    }
  }
  const SurfaceCheck check = CheckSurface(mesh);
  if (!check.IsClosedManifold() || check.UnusedPoints > 0)
  {
    text << check << "\n";
  }
  if (check.DegenerateTriangles == 0)
  {
    for (const Meeting& meeting : FindMeetings(mesh, 3))
    {
      text << (meeting.First == meeting.Second ? "no area:\n" : "triangles meet:\n");
      WriteTriangle(mesh, meeting.First, text);
      WriteTriangle(mesh, meeting.Second, text);
    }
  }
  return text.str();
}

} // namespace support
} // namespace orthoslices
