// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CommonLines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace orthoslices
{
namespace
{
/// Whose border is passed: that of a structure on the first or second slice of a line, or on both
/// once they agree.
enum class Source : std::uint8_t
{
  First,
  Second,
  Both
};

/// A place on a line where it passes into a structure, or out of it.
struct LinePassage
{
  int Direction;
  double First, Second; ///< coordinates of the planes
  Source Of;
  double Position;
  Index Structure;

  auto Line() const { return std::tie(this->Direction, this->First, this->Second); }
};

bool operator<(const LinePassage& a, const LinePassage& b)
{
  return a.Line() != b.Line()  ? a.Line() < b.Line()
    : a.Of != b.Of             ? a.Of < b.Of
    : a.Position != b.Position ? a.Position < b.Position
                               : a.Structure < b.Structure;
}

void AddPassages(
  const StructureCrossings& from, Index structure, std::vector<LinePassage>& passages)
{
  const GridEdgeCode code(from.Grid);
  const auto add = [&](Index crossing, Source of, double position)
  {
    const GridEdge edge = code.Decode(from.Crossings.Edge[crossing]);
    passages.push_back({ edge.Direction, from.Grid.Planes[FirstAxis(edge.Direction)][edge.First],
      from.Grid.Planes[SecondAxis(edge.Direction)][edge.Second], of, position, structure });
  };
  for (Index i = 0; i < from.Crossings.Count(); ++i)
  {
    if (from.Crossings.RunContour[i] != GridCrossings::None) // not inserted around a vertex
    {
      add(i, from.Crossings.Family[i] == 0 ? Source::First : Source::Second,
        from.Crossings.Position[i]);
    }
  }
  for (Index node = 0; node < from.Nodes.Count(); ++node)
  {
    add(from.Nodes.First[node], Source::Both, from.Nodes.Position[node]);
  }
}

/// The structures in which a line is, from one of its passages to the next one.
class LineWalk
{
public:
  LineWalk(const LinePassage* next, const LinePassage* end)
    : Next(next)
    , End(end)
  {
  }

  /// Goes on to a place.
  void GoTo(double position)
  {
    for (; this->Next != this->End && this->Next->Position <= position; ++this->Next)
    {
      const auto place =
        std::lower_bound(this->Inside.begin(), this->Inside.end(), this->Next->Structure);
      const bool isIn = place != this->Inside.end() && *place == this->Next->Structure;
      isIn ? this->Inside.erase(place) : this->Inside.insert(place, this->Next->Structure);
    }
  }
  bool IsAtEnd() const { return this->Next == this->End; }
  double NextPosition() const { return this->Next->Position; }

  std::vector<Index> Inside; ///< ascending

private:
  const LinePassage* Next;
  const LinePassage* End;
};

/// The passages of one line, from a source on.
const LinePassage* StartOf(Source of, const LinePassage* begin, const LinePassage* end)
{
  return std::partition_point(
    begin, end, [of](const LinePassage& passage) { return passage.Of < of; });
}

/// `begin` and `end` hold the passages of one line.
bool IsLineRight(const LinePassage* begin, const LinePassage* end, const StructureSets& sets)
{
  const LinePassage* const second = StartOf(Source::Second, begin, end);
  const LinePassage* const both = StartOf(Source::Both, begin, end);
  LineWalk onFirst(begin, second), onSecond(second, both), agreed(both, end);
  while (!agreed.IsAtEnd())
  {
    const double from = agreed.NextPosition();
    agreed.GoTo(from);
    const double to = agreed.IsAtEnd() ? from : agreed.NextPosition();
    onFirst.GoTo(0.5 * (from + to));
    onSecond.GoTo(0.5 * (from + to));
    const bool isLost = agreed.Inside.empty() && !agreed.IsAtEnd() && !onFirst.Inside.empty() &&
      !onSecond.Inside.empty();
    if (isLost || sets.count(agreed.Inside) == 0)
    {
      return false;
    }
  }
  return true;
}

/// Calls a function with the passages of each line, as long as it returns true.
template <class Function>
bool ForLines(const std::vector<StructureCrossings>& structures, const Function& function)
{
  std::vector<LinePassage> passages;
  for (std::size_t i = 0; i < structures.size(); ++i)
  {
    AddPassages(structures[i], static_cast<Index>(i), passages);
  }
  std::sort(passages.begin(), passages.end());
  const LinePassage* const end = passages.data() + passages.size();
  for (const LinePassage* line = passages.data(); line != end;)
  {
    const LinePassage* next = std::find_if(
      line, end, [line](const LinePassage& passage) { return passage.Line() != line->Line(); });
    if (!function(line, next))
    {
      return false;
    }
    line = next;
  }
  return true;
}

/// Which sets slices have on lines, by length.
class SetsOnLines
{
public:
  SetsOnLines(const std::vector<StructureCrossings>& crossings, const StructureSets& doubtful);

  void AddLine(const LinePassage* begin, const LinePassage* end);
  SetReplacements Replace(const StructureSets& sets) const;

private:
  using Set = std::vector<Index>;
  using Slice = std::pair<int, double>; ///< axis and coordinate

  /// That much of what either of two slices shows of a set is common to both, if it is meant.
  static constexpr double LeastCommon = 0.25;

  void AddRange(const std::array<Slice, 2>& slices, const std::array<Set, 2>& found, double length);
  bool IsDrawn(const Slice& slice, const Set& set) const;
  bool IsContradicted(const Set& set) const;
  Set PartOf(const Set& set, const std::map<Set, double>& across, const StructureSets& sets) const;

  const StructureSets& Doubtful;
  std::set<std::pair<Slice, Index>> Drawn;      ///< structures on slices
  std::map<Set, std::array<double, 2>> Lengths; ///< on either slice of a line, on both
  std::map<Slice, std::map<Set, std::map<Set, double>>> Across; ///< what slices across have there
};

SetsOnLines::SetsOnLines(
  const std::vector<StructureCrossings>& crossings, const StructureSets& doubtful)
  : Doubtful(doubtful)
{
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    const StructureCrossings& of = crossings[i];
    const GridEdgeCode code(of.Grid);
    for (Index crossing = 0; crossing < of.Crossings.Count(); ++crossing)
    {
      const GridEdge edge = code.Decode(of.Crossings.Edge[crossing]);
      const bool isFirst = of.Crossings.Family[crossing] == 0;
      const int axis = isFirst ? FirstAxis(edge.Direction) : SecondAxis(edge.Direction);
      const double plane = of.Grid.Planes[axis][isFirst ? edge.First : edge.Second];
      this->Drawn.insert({ { axis, plane }, static_cast<Index>(i) });
    }
  }
}

bool SetsOnLines::IsDrawn(const Slice& slice, const Set& set) const
{
  return std::all_of(set.begin(), set.end(),
    [&](Index structure) {
      return this->Drawn.count({ slice, structure }) > 0;
    });
}

void SetsOnLines::AddLine(const LinePassage* begin, const LinePassage* end)
{
  const LinePassage* const second = StartOf(Source::Second, begin, end);
  const LinePassage* const both = StartOf(Source::Both, begin, end);
  const std::array<Slice, 2> slices{ Slice{ FirstAxis(begin->Direction), begin->First },
    Slice{ SecondAxis(begin->Direction), begin->Second } };
  LineWalk onFirst(begin, second), onSecond(second, both);
  while (!onFirst.IsAtEnd() || !onSecond.IsAtEnd())
  {
    const auto next = [&]()
    {
      return std::min(onFirst.IsAtEnd() ? HUGE_VAL : onFirst.NextPosition(),
        onSecond.IsAtEnd() ? HUGE_VAL : onSecond.NextPosition());
    };
    const double from = next();
    onFirst.GoTo(from);
    onSecond.GoTo(from);
    if (!onFirst.IsAtEnd() || !onSecond.IsAtEnd())
    {
      this->AddRange(slices, { onFirst.Inside, onSecond.Inside }, next() - from);
    }
  }
}

void SetsOnLines::AddRange(
  const std::array<Slice, 2>& slices, const std::array<Set, 2>& found, double length)
{
  for (int i = 0; i < 2; ++i)
  {
    const Set& set = found[i];
    if (this->Doubtful.count(set) > 0 && this->IsDrawn(slices[1 - i], set))
    {
      const bool isCommon = found[1 - i] == set;
      this->Lengths[set][0] += isCommon ? 0.5 * length : length;
      this->Lengths[set][1] += isCommon ? 0.5 * length : 0.0;
      this->Across[slices[i]][set][found[1 - i]] += length;
    }
  }
}

bool SetsOnLines::IsContradicted(const Set& set) const
{
  const auto found = this->Lengths.find(set);
  return found != this->Lengths.end() && found->second[1] < LeastCommon * found->second[0];
}

/// What a set becomes on a slice across which there are others; itself if there is nothing.
SetsOnLines::Set SetsOnLines::PartOf(
  const Set& set, const std::map<Set, double>& across, const StructureSets& sets) const
{
  Set best = sets.count({ set.front() }) > 0 ? Set{ set.front() } : set;
  double most = 0.0;
  for (const auto& [other, length] : across)
  {
    const bool isPart = other != set && !other.empty() &&
      std::includes(set.begin(), set.end(), other.begin(), other.end());
    if (isPart && length > most && sets.count(other) > 0 && !this->IsContradicted(other))
    {
      best = other;
      most = length;
    }
  }
  return best;
}

SetReplacements SetsOnLines::Replace(const StructureSets& sets) const
{
  SetReplacements replaced;
  for (const auto& [slice, ofSlice] : this->Across)
  {
    for (const auto& [set, across] : ofSlice)
    {
      const Set part = this->IsContradicted(set) ? this->PartOf(set, across, sets) : set;
      if (part != set)
      {
        replaced[slice][set] = part;
      }
    }
  }
  return replaced;
}
}

bool DoStructuresAgree(const std::vector<StructureCrossings>& structures, const StructureSets& sets)
{
  return ForLines(structures,
    [&sets](const LinePassage* line, const LinePassage* end)
    { return IsLineRight(line, end, sets); });
}

SetReplacements FindContradictedSets(const std::vector<StructureCrossings>& crossings,
  const StructureSets& doubtful, const StructureSets& sets)
{
  SetsOnLines found(crossings, doubtful);
  ForLines(crossings,
    [&found](const LinePassage* line, const LinePassage* end)
    {
      found.AddLine(line, end);
      return true;
    });
  return found.Replace(sets);
}
}
