// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/CommonLines.h"

#include <algorithm>
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

/// `begin` and `end` hold the passages of one line.
bool IsLineRight(const LinePassage* begin, const LinePassage* end, const StructureSets& sets)
{
  const auto startOf = [&](Source of)
  {
    return std::partition_point(
      begin, end, [of](const LinePassage& passage) { return passage.Of < of; });
  };
  const LinePassage *second = startOf(Source::Second), *both = startOf(Source::Both);
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
}

bool DoStructuresAgree(const std::vector<StructureCrossings>& structures, const StructureSets& sets)
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
    if (!IsLineRight(line, next, sets))
    {
      return false;
    }
    line = next;
  }
  return true;
}
}
