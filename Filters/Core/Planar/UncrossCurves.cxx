// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Planar/UncrossCurves.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orthoslices
{
namespace
{
/// Pairs compared and vertices moved for each vertex before we give up, between two rounds.
constexpr std::size_t MaxWorkPerVertex = 1 << 12;
/// Pairs that overlap along x, for each segment, from which on it is worth trying y.
constexpr std::size_t ManyOverlapsPerSegment = 16;
/// Contacts for each vertex that are listed before the first of them are dealt with.
constexpr std::size_t MaxContactsPerVertex = 16;

/// The segment from a vertex to the next one of its curve.
struct Segment
{
  Index Start, End;
  Point2 Low, High;
};

/// Two segments that cross, or that touch until the vertex Remove (None: it cannot be) is left out.
struct Contact
{
  double Gain; ///< by how much the move makes the curves shorter
  std::array<Index, 2> First, Second;
  bool Cross;
  Index Remove;
};

/// Where two curves cross: the segment and the share of its length, on each of them.
struct Crossing
{
  std::pair<Index, double> OnFirst, OnSecond;
};

/// The share of pq up to its crossing with rs.
double ShareAtCrossing(const Point2& p, const Point2& q, const Point2& r, const Point2& s)
{
  const double from = Cross(p - r, s - r);
  const double to = Cross(q - r, s - r);
  return from / (from - to);
}

class Untangler
{
public:
  explicit Untangler(PlanarCurves& curves);
  Uncrossing Run();
  bool IsSimple();

private:
  static constexpr Index None = -1;

  const Point2& At(Index vertex) const { return this->Curves.Vertices[vertex]; }
  bool IsEnd(Index vertex) const;
  bool AreNeighbours(const std::array<Index, 2>& pair) const;
  void Renumber(Index curve, std::size_t first);

  std::vector<Segment> ListSegments() const;
  void FindContacts(std::size_t maximum);
  void Compare(const Segment& a, const Segment& b);
  bool Closes(const Segment& last, const Segment& first) const;
  void AddFold(const Segment& a, const Segment& b);
  void AddTouch(const Segment& a, const Segment& b);
  double GainOf(const Segment& a, const Segment& b) const;
  double GainOfRemoving(Index vertex) const;

  bool Apply(const Contact& contact);
  Index PlaceOf(const std::array<Index, 2>& pair) const;
  bool Uncross(const Contact& contact);
  void Reverse(const Contact& contact);
  std::vector<Crossing> CrossingsOf(Index one, Index other);
  void ExchangeParts(Index one, Index other, Crossing first, Crossing second);
  void BeginInLongerPart(Index curve, std::pair<Index, double>& p, std::pair<Index, double>& q);
  void ExchangeRests(Index one, Index other, const Crossing& crossing);
  void Remove(Index vertex);
  double Length() const;

  PlanarCurves& Curves;
  std::vector<Index> Curve, Place; ///< of each vertex; Curve is None for those left out
  std::vector<Contact> Contacts;
  std::size_t Work = 0;
  Uncrossing Result;
};

Untangler::Untangler(PlanarCurves& curves)
  : Curves(curves)
  , Curve(curves.Vertices.size(), None)
  , Place(curves.Vertices.size(), 0)
{
  for (std::size_t curve = 0; curve < this->Curves.Curves.size(); ++curve)
  {
    this->Renumber(static_cast<Index>(curve), 0);
  }
}

void Untangler::Renumber(Index curve, std::size_t first)
{
  const std::vector<Index>& vertices = this->Curves.Curves[curve];
  for (std::size_t i = first; i < vertices.size(); ++i)
  {
    this->Curve[vertices[i]] = curve;
    this->Place[vertices[i]] = static_cast<Index>(i);
  }
  this->Work += vertices.size() - std::min(first, vertices.size());
}

bool Untangler::IsEnd(Index vertex) const
{
  const std::vector<Index>& curve = this->Curves.Curves[this->Curve[vertex]];
  return curve.front() == vertex || curve.back() == vertex;
}

bool Untangler::AreNeighbours(const std::array<Index, 2>& pair) const
{
  return this->Curve[pair[0]] != None && this->Curve[pair[0]] == this->Curve[pair[1]] &&
    std::abs(this->Place[pair[0]] - this->Place[pair[1]]) == 1;
}

std::vector<Segment> Untangler::ListSegments() const
{
  std::vector<Segment> segments;
  for (const std::vector<Index>& curve : this->Curves.Curves)
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      const Point2& p = this->At(curve[i - 1]);
      const Point2& q = this->At(curve[i]);
      segments.push_back({ curve[i - 1], curve[i], { std::min(p[0], q[0]), std::min(p[1], q[1]) },
        { std::max(p[0], q[0]), std::max(p[1], q[1]) } });
    }
  }
  return segments;
}

/// Sorts segments by where they begin along an axis. Returns how many pairs overlap along it.
std::size_t SortAlong(int axis, std::vector<Segment>& segments)
{
  std::sort(segments.begin(), segments.end(),
    [axis](const Segment& a, const Segment& b)
    { return a.Low[axis] != b.Low[axis] ? a.Low[axis] < b.Low[axis] : a.Start < b.Start; });
  std::size_t overlaps = 0;
  for (auto segment = segments.begin(); segment != segments.end(); ++segment)
  {
    const auto end = std::upper_bound(segment + 1, segments.end(), segment->High[axis],
      [axis](double high, const Segment& other) { return high < other.Low[axis]; });
    overlaps += end - segment - 1;
  }
  return overlaps;
}

/**
 * Sorts segments along the axis on which fewer of them overlap, and returns it: all segments of
 * curves that run along y overlap along x.
 */
int SortForSweep(std::vector<Segment>& segments)
{
  const std::size_t alongX = SortAlong(0, segments);
  if (alongX <= ManyOverlapsPerSegment * segments.size())
  {
    return 0;
  }
  if (SortAlong(1, segments) < alongX)
  {
    return 1;
  }
  SortAlong(0, segments);
  return 0;
}

/**
 * Lists contacts until there are more than `most`. However long it takes: what is not known to
 * touch must not be changed.
 */
void Untangler::FindContacts(std::size_t maximum)
{
  this->Contacts.clear();
  std::vector<Segment> segments = this->ListSegments();
  const int along = SortForSweep(segments);
  const int across = 1 - along;
  for (std::size_t i = 0; i < segments.size() && this->Contacts.size() <= maximum; ++i)
  {
    const Segment& a = segments[i];
    for (std::size_t j = i + 1; j < segments.size() && segments[j].Low[along] <= a.High[along]; ++j)
    {
      const Segment& b = segments[j];
      ++this->Work;
      if (b.Low[across] <= a.High[across] && a.Low[across] <= b.High[across])
      {
        this->Compare(a, b);
      }
    }
  }
}

bool Untangler::IsSimple()
{
  this->FindContacts(0);
  return this->Contacts.empty();
}

void Untangler::Compare(const Segment& a, const Segment& b)
{
  if (a.End == b.Start || b.End == a.Start)
  {
    a.End == b.Start ? this->AddFold(a, b) : this->AddFold(b, a);
    return;
  }
  const Point2& p = this->At(a.Start);
  const Point2& q = this->At(a.End);
  const Point2& r = this->At(b.Start);
  const Point2& s = this->At(b.End);
  if (this->Closes(b, a) || this->Closes(a, b))
  {
    this->Closes(b, a) ? this->AddFold(b, a) : this->AddFold(a, b);
    return;
  }
  const int acrossA = SideOf(p, q, r) * SideOf(p, q, s);
  const int acrossB = SideOf(r, s, p) * SideOf(r, s, q);
  if (acrossA > 0 || acrossB > 0)
  {
    return;
  }
  if (acrossA < 0 && acrossB < 0)
  {
    this->Contacts.push_back(
      { this->GainOf(a, b), { a.Start, a.End }, { b.Start, b.End }, true, None });
    return;
  }
  this->AddTouch(a, b);
}

/// Whether a closed curve ends with one segment and begins with the other.
bool Untangler::Closes(const Segment& last, const Segment& first) const
{
  const Index curve = this->Curve[first.Start];
  return static_cast<std::size_t>(curve) >= this->Curves.FirstClosed &&
    curve == this->Curve[last.End] && this->Curves.Curves[curve].front() == first.Start &&
    this->Curves.Curves[curve].back() == last.End;
}

/// Consecutive segments touch beyond their common vertex if the second runs back along the first.
void Untangler::AddFold(const Segment& a, const Segment& b)
{
  const Point2& p = this->At(a.Start);
  const Point2& q = this->At(a.End);
  const Point2& r = this->At(b.End);
  const double dot = Dot(q - p, r - q);
  if (dot <= 0.0 && SideOf(p, q, r) == 0)
  {
    const bool isEnd = this->IsEnd(a.End);
    this->Contacts.push_back({ isEnd ? 0.0 : this->GainOfRemoving(a.End), { a.Start, a.End },
      { b.Start, b.End }, false, isEnd ? None : a.End });
  }
}

/// Whether a point on the line of a segment lies on the segment.
bool IsWithin(const Segment& segment, const Point2& p)
{
  return segment.Low[0] <= p[0] && p[0] <= segment.High[0] && segment.Low[1] <= p[1] &&
    p[1] <= segment.High[1];
}

/// An end of one segment lies on the other one: what is no end of a curve can be left out.
void Untangler::AddTouch(const Segment& a, const Segment& b)
{
  Index best = None;
  bool touch = false;
  const auto consider = [&](const Segment& segment, Index vertex)
  {
    const Point2& p = this->At(vertex);
    if (SideOf(this->At(segment.Start), this->At(segment.End), p) != 0 || !IsWithin(segment, p))
    {
      return;
    }
    touch = true;
    const bool better = !this->IsEnd(vertex) &&
      (best == None || this->GainOfRemoving(vertex) > this->GainOfRemoving(best));
    best = better ? vertex : best;
  };
  consider(a, b.Start);
  consider(a, b.End);
  consider(b, a.Start);
  consider(b, a.End);
  if (touch)
  {
    const double gain = best == None ? 0.0 : this->GainOfRemoving(best);
    this->Contacts.push_back({ gain, { a.Start, a.End }, { b.Start, b.End }, false, best });
  }
}

double Untangler::GainOf(const Segment& a, const Segment& b) const
{
  const double before =
    Distance(this->At(a.Start), this->At(a.End)) + Distance(this->At(b.Start), this->At(b.End));
  const bool same = this->Curve[a.Start] == this->Curve[b.Start];
  const Index afterA = same ? b.Start : b.End;
  const Index beforeB = same ? b.End : b.Start;
  return before - Distance(this->At(a.Start), this->At(afterA)) -
    Distance(this->At(a.End), this->At(beforeB));
}

double Untangler::GainOfRemoving(Index vertex) const
{
  const std::vector<Index>& curve = this->Curves.Curves[this->Curve[vertex]];
  const Point2& before = this->At(curve[this->Place[vertex] - 1]);
  const Point2& after = this->At(curve[this->Place[vertex] + 1]);
  return Distance(before, this->At(vertex)) + Distance(this->At(vertex), after) -
    Distance(before, after);
}

/// The place of the first of two neighbours on their curve.
Index Untangler::PlaceOf(const std::array<Index, 2>& pair) const
{
  return std::min(this->Place[pair[0]], this->Place[pair[1]]);
}

/// Passes the part of a curve between two segments of it the other way.
void Untangler::Reverse(const Contact& contact)
{
  const Index curve = this->Curve[contact.First[0]];
  const Index i = this->PlaceOf(contact.First) + 1;
  const Index j = this->PlaceOf(contact.Second) + 1;
  std::vector<Index>& vertices = this->Curves.Curves[curve];
  std::reverse(vertices.begin() + std::min(i, j), vertices.begin() + std::max(i, j));
  this->Renumber(curve, std::min(i, j));
}

/// The crossings of two curves, in their order along the first.
std::vector<Crossing> Untangler::CrossingsOf(Index one, Index other)
{
  this->Work += this->Contacts.size();
  std::vector<Crossing> crossings;
  const std::vector<Index>& a = this->Curves.Curves[one];
  const std::vector<Index>& b = this->Curves.Curves[other];
  for (const Contact& contact : this->Contacts)
  {
    if (!contact.Cross || !this->AreNeighbours(contact.First) ||
      !this->AreNeighbours(contact.Second))
    {
      continue;
    }
    const std::array<Index, 2> curves{ this->Curve[contact.First[0]],
      this->Curve[contact.Second[0]] };
    const bool inOrder = curves[0] == one && curves[1] == other;
    if (inOrder || (curves[0] == other && curves[1] == one))
    {
      const Index i = this->PlaceOf(inOrder ? contact.First : contact.Second);
      const Index j = this->PlaceOf(inOrder ? contact.Second : contact.First);
      const Point2& p = this->At(a[i]);
      const Point2& q = this->At(a[i + 1]);
      const Point2& r = this->At(b[j]);
      const Point2& s = this->At(b[j + 1]);
      crossings.push_back(
        { { i, ShareAtCrossing(p, q, r, s) }, { j, ShareAtCrossing(r, s, p, q) } });
    }
  }
  std::sort(crossings.begin(), crossings.end(),
    [](const Crossing& x, const Crossing& y)
    { return x.OnFirst != y.OnFirst ? x.OnFirst < y.OnFirst : x.OnSecond < y.OnSecond; });
  return crossings;
}

/// A closed curve may begin anywhere: makes it begin on the longer one of its two parts between two
/// crossings, so that it remains the same but for a little when the other one is exchanged.
void Untangler::BeginInLongerPart(
  Index curve, std::pair<Index, double>& p, std::pair<Index, double>& q)
{
  std::vector<Index>& vertices = this->Curves.Curves[curve];
  double all = 0.0;
  std::array<double, 2> at{}; // lengths from the start to the crossings
  for (std::size_t i = 1; i < vertices.size(); ++i)
  {
    const double length = Distance(this->At(vertices[i - 1]), this->At(vertices[i]));
    for (int k = 0; k < 2; ++k)
    {
      const std::pair<Index, double>& place = k == 0 ? p : q;
      at[k] = place.first == static_cast<Index>(i) - 1 ? all + place.second * length : at[k];
    }
    all += length;
  }
  const bool isClosed = static_cast<std::size_t>(curve) >= this->Curves.FirstClosed;
  if (!isClosed || std::abs(at[1] - at[0]) <= 0.5 * all)
  {
    return;
  }
  const Index begin = std::min(p.first, q.first) + 1;
  const Index count = static_cast<Index>(vertices.size()) - 1;
  std::rotate(vertices.begin(), vertices.begin() + begin, vertices.end() - 1);
  this->Curves.Vertices[vertices.back()] = this->At(vertices.front());
  for (std::pair<Index, double>* place : { &p, &q })
  {
    place->first = (place->first - begin + count) % count;
  }
  this->Renumber(curve, 0);
}

/// Exchanges the parts of two curves between two crossings, so that their ends stay together.
void Untangler::ExchangeParts(Index one, Index other, Crossing first, Crossing second)
{
  this->BeginInLongerPart(one, first.OnFirst, second.OnFirst);
  this->BeginInLongerPart(other, first.OnSecond, second.OnSecond);
  if (second.OnFirst < first.OnFirst)
  {
    std::swap(first, second);
  }
  std::vector<Index>& a = this->Curves.Curves[one];
  std::vector<Index>& b = this->Curves.Curves[other];
  const bool sameWay = first.OnSecond < second.OnSecond;
  const Index j = std::min(first.OnSecond.first, second.OnSecond.first) + 1;
  const auto beginA = a.begin() + first.OnFirst.first + 1;
  const auto endA = a.begin() + second.OnFirst.first + 1;
  const auto beginB = b.begin() + j;
  const auto endB = b.begin() + std::max(first.OnSecond.first, second.OnSecond.first) + 1;
  std::vector<Index> partA(beginA, endA);
  std::vector<Index> partB(beginB, endB);
  if (!sameWay)
  {
    std::reverse(partA.begin(), partA.end());
    std::reverse(partB.begin(), partB.end());
  }
  a.insert(a.erase(beginA, endA), partB.begin(), partB.end());
  b.insert(b.erase(beginB, endB), partA.begin(), partA.end());
  this->Renumber(one, first.OnFirst.first);
  this->Renumber(other, j);
}

/// Exchanges all that follows on two curves.
void Untangler::ExchangeRests(Index one, Index other, const Crossing& crossing)
{
  std::vector<Index>& a = this->Curves.Curves[one];
  std::vector<Index>& b = this->Curves.Curves[other];
  const auto restOfA = a.begin() + crossing.OnFirst.first + 1;
  const auto restOfB = b.begin() + crossing.OnSecond.first + 1;
  const std::vector<Index> tail(restOfA, a.end());
  a.erase(restOfA, a.end());
  a.insert(a.end(), restOfB, b.end());
  b.erase(restOfB, b.end());
  b.insert(b.end(), tail.begin(), tail.end());
  this->Renumber(one, crossing.OnFirst.first);
  this->Renumber(other, crossing.OnSecond.first);
}

/// False if it has to wait until a vertex that touches is left out: then closed curves do not cross
/// once.
bool Untangler::Uncross(const Contact& contact)
{
  const Index one = this->Curve[contact.First[0]];
  const Index other = this->Curve[contact.Second[0]];
  if (one == other)
  {
    this->Reverse(contact);
    return true;
  }
  const std::vector<Crossing> crossings = this->CrossingsOf(one, other);
  if (crossings.size() == 1)
  {
    const bool isClosed =
      static_cast<std::size_t>(std::max(one, other)) >= this->Curves.FirstClosed;
    if (!isClosed)
    {
      this->ExchangeRests(one, other, crossings.front());
    }
    return !isClosed;
  }
  const Index i = this->PlaceOf(contact.First);
  const Index j = this->PlaceOf(contact.Second);
  const auto here = std::find_if(crossings.begin(), crossings.end(),
    [&](const Crossing& c) { return c.OnFirst.first == i && c.OnSecond.first == j; });
  const auto first = here + 1 != crossings.end() ? here : here - 1;
  this->ExchangeParts(one, other, *first, *(first + 1));
  return true;
}

void Untangler::Remove(Index vertex)
{
  const Index curve = this->Curve[vertex];
  const Index place = this->Place[vertex];
  std::vector<Index>& vertices = this->Curves.Curves[curve];
  vertices.erase(vertices.begin() + place);
  this->Curve[vertex] = None;
  this->Renumber(curve, place);
}

double Untangler::Length() const
{
  double length = 0.0;
  for (const std::vector<Index>& curve : this->Curves.Curves)
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      length += Distance(this->At(curve[i - 1]), this->At(curve[i]));
    }
  }
  return length;
}

/// Does nothing if one of the segments is no more, or if nothing helps.
bool Untangler::Apply(const Contact& contact)
{
  if (!this->AreNeighbours(contact.First) || !this->AreNeighbours(contact.Second) ||
    (!contact.Cross && contact.Remove == None))
  {
    return false;
  }
  const Point2 p = this->At(contact.First[0]), q = this->At(contact.Second[0]);
  if (contact.Cross && !this->Uncross(contact))
  {
    return false;
  }
  if (!contact.Cross)
  {
    this->Remove(contact.Remove);
  }
  if (this->Result.Changes == 0)
  {
    this->Result.Where = { p[0] + 0.5 * (q[0] - p[0]), p[1] + 0.5 * (q[1] - p[1]) };
  }
  ++this->Result.Changes;
  return true;
}

Uncrossing Untangler::Run()
{
  const double length = this->Length();
  const std::size_t vertices = this->Curves.Vertices.size();
  Index applied = 0;
  do
  {
    this->FindContacts(MaxContactsPerVertex * vertices);
    std::stable_sort(this->Contacts.begin(), this->Contacts.end(),
      [](const Contact& a, const Contact& b) { return a.Gain > b.Gain; });
    applied = 0;
    for (const Contact& contact : this->Contacts)
    {
      applied += this->Apply(contact) ? 1 : 0;
    }
  } while (applied > 0 && this->Work <= MaxWorkPerVertex * vertices);
  this->Result.Simple = this->Contacts.empty();
  this->Result.Shortening = length - this->Length();
  return this->Result;
}
}

void AddCurve(const std::vector<Point2>& points, PlanarCurves& curves)
{
  curves.Curves.emplace_back(points.size());
  std::iota(curves.Curves.back().begin(), curves.Curves.back().end(),
    static_cast<Index>(curves.Vertices.size()));
  curves.Vertices.insert(curves.Vertices.end(), points.begin(), points.end());
}

void AddClosedCurve(std::vector<Point2> points, PlanarCurves& curves)
{
  points.push_back(points.front());
  curves.FirstClosed = std::min(curves.FirstClosed, curves.Curves.size());
  AddCurve(points, curves);
}

bool AreSimple(PlanarCurves& curves) { return Untangler(curves).IsSimple(); }

Uncrossing UncrossCurves(PlanarCurves& curves) { return Untangler(curves).Run(); }
}
