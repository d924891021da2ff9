// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BlockChange.h"

#include "Core/Improve/MakesFold.h"

#include <algorithm>

namespace orthoslices
{
namespace
{
/// Lists changes of one block.
class ChangeLister
{
public:
  ChangeLister(const MeshBlock& block, const BlockImprover& improver, const ImprovableMesh& whole,
    const TriangleMarks& marks)
    : Block(block)
    , Mesh(block.Mesh)
    , Improver(improver)
    , Whole(whole)
    , Marks(marks)
    , There{ whole.Corners.CornerCount() / 3, static_cast<Index>(whole.Points.size()) }
    , Given{ static_cast<Index>(block.Triangles.size()), static_cast<Index>(block.Points.size()) }
  {
  }

  BlockChange Run();

private:
  Index TriangleInWhole(Index triangle) const
  {
    return triangle < this->Given.Triangles
      ? this->Block.Triangles[triangle]
      : this->There.Triangles + triangle - this->Given.Triangles;
  }
  Index CornerInWhole(Index corner) const
  {
    return 3 * this->TriangleInWhole(corner / 3) + corner % 3;
  }
  Index PointInWhole(Index point) const
  {
    return point < this->Given.Points ? this->Block.Points[point]
                                      : this->There.Points + point - this->Given.Points;
  }
  Index OriginOf(Index triangle) const
  {
    return triangle < this->Given.Triangles
      ? -1
      : this->TriangleInWhole(this->Mesh.Origins[triangle - this->Given.Triangles]);
  }
  bool IsCurve(Index corner) const;
  bool HasFold(Index triangle) const;
  void AddTriangle(Index triangle);
  void AddMarks(Index triangle);
  void AddPoint(Index point);

  const MeshBlock& Block;
  const ImprovableMesh& Mesh;
  const BlockImprover& Improver;
  const ImprovableMesh& Whole;
  const TriangleMarks& Marks;
  const BlockChange::Counts There, Given;
  BlockChange Change;
};

/// Whether the edge of an inner triangle is a curve. Those of triangles that stay are marked in the
/// block; what they are, the whole knows.
bool ChangeLister::IsCurve(Index corner) const
{
  const Index across = this->Mesh.Corners.OppositeOf(corner);
  return this->Block.IsInner(across / 3) ? this->Mesh.Corners.IsCurve(corner)
                                         : this->Whole.Corners.IsCurve(this->CornerInWhole(across));
}

/// Whether a triangle is folded onto one with a greater number. Those of the block ascend as those
/// of the whole do.
bool ChangeLister::HasFold(Index triangle) const
{
  const CornerTable& corners = this->Mesh.Corners;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    if (corners.OppositeOf(corner) > corner && IsFolded(corners, this->Mesh.Points, corner) &&
      !this->IsCurve(corner))
    {
      return true;
    }
  }
  return false;
}

void ChangeLister::AddTriangle(Index triangle)
{
  const bool isGone = !this->Mesh.Corners.IsAlive(3 * triangle);
  ChangedTriangle changed{ this->TriangleInWhole(triangle), { -1, -1, -1 }, { 0, 0, 0 },
    this->OriginOf(triangle), this->Improver.Samples().PlainOf(triangle), 0 };
  if (!isGone)
  {
    for (int i = 0; i < 3; ++i)
    {
      changed.Vertices[i] = this->PointInWhole(this->Mesh.Corners.VertexOf(3 * triangle + i));
      changed.Curves[i] = this->IsCurve(3 * triangle + i) ? 1 : 0;
    }
    const std::size_t before = this->Change.Samples.size();
    this->Improver.Samples().AppendSamplesOn(triangle, this->Change.Samples);
    changed.SampleCount = static_cast<Index>(this->Change.Samples.size() - before);
  }
  this->Change.Triangles.push_back(changed);
}

void ChangeLister::AddMarks(Index triangle)
{
  const Index number = this->TriangleInWhole(triangle);
  const bool isNew = triangle >= this->Given.Triangles;
  const std::uint8_t tried = isNew ? 0 : this->Marks.Tried[number];
  const std::uint8_t folded = isNew ? 0 : this->Marks.IsFolded[number];
  ChangedMarks changed{ number, tried,
    this->HasFold(triangle) ? std::uint8_t(1) : std::uint8_t(0) };
  if (this->Improver.IsOpen(triangle))
  {
    changed.Tried = 0;
  }
  else if (this->Block.IsFree(triangle))
  {
    changed.Tried = 1;
  }
  if (changed.Tried != tried || changed.IsFolded != folded)
  {
    this->Change.Marks.push_back(changed);
  }
}

void ChangeLister::AddPoint(Index point)
{
  this->Change.Points.push_back(
    { this->PointInWhole(point), this->Mesh.RoomOf.empty() ? -1 : this->Mesh.RoomOf[point],
      this->Mesh.Points[point], this->Mesh.Normals[point] });
}

BlockChange ChangeLister::Run()
{
  const Index triangles = this->Mesh.Corners.CornerCount() / 3;
  const Index points = this->Mesh.Corners.PointCount();
  this->Change.New = { triangles - this->Given.Triangles, points - this->Given.Points };
  for (Index triangle = 0; triangle < triangles; ++triangle)
  {
    const bool isGone = !this->Mesh.Corners.IsAlive(3 * triangle);
    if (!isGone && !this->Block.IsInner(triangle))
    {
      continue;
    }
    if (isGone || this->Improver.HasChanged(triangle))
    {
      this->AddTriangle(triangle);
    }
    if (!isGone)
    {
      this->AddMarks(triangle);
    }
  }
  // Frozen points are as they were, and others may look at them while these are put back.
  for (Index point = this->Block.FirstFree; point < points; ++point)
  {
    if (this->Improver.HasMoved(point))
    {
      this->AddPoint(point);
    }
  }
  return std::move(this->Change);
}

/// Adds to numbers of what is new.
struct Shift
{
  Index First, By;
  void operator()(Index& number) const { number += number >= this->First ? this->By : 0; }
};
}

BlockChange ListChange(const MeshBlock& block, const BlockImprover& improver,
  const ImprovableMesh& whole, const TriangleMarks& marks)
{
  return ChangeLister(block, improver, whole, marks).Run();
}

void BlockChange::Renumber(const Counts& there, const Counts& before)
{
  const Shift ofTriangle{ there.Triangles, before.Triangles };
  const Shift ofPoint{ there.Points, before.Points };
  for (ChangedTriangle& triangle : this->Triangles)
  {
    ofTriangle(triangle.Number);
    ofTriangle(triangle.Origin);
    for (Index& vertex : triangle.Vertices)
    {
      ofPoint(vertex);
    }
  }
  for (ChangedPoint& point : this->Points)
  {
    ofPoint(point.Number);
  }
  for (ChangedMarks& marks : this->Marks)
  {
    ofTriangle(marks.Number);
  }
}

namespace
{
/// What is new of a change, and how long its lists are.
struct Sizes
{
  BlockChange::Counts New;
  std::size_t Triangles, Points, Marks, Samples;
};

/// Gives all processes one list of each change, once the lists have the room for it.
template <typename Value>
void ExchangeLists(const Ranks& ranks, const int* rankOfChange,
  std::vector<Value> BlockChange::*list, std::vector<BlockChange>& changes)
{
  std::vector<Value> own;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    if (rankOfChange[i] == ranks.Rank)
    {
      const std::vector<Value>& values = changes[i].*list;
      own.insert(own.end(), values.begin(), values.end());
    }
  }
  const std::vector<std::vector<Value>> all = GatherValues(ranks, own);
  std::vector<std::ptrdiff_t> next(all.size(), 0);
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const int rank = rankOfChange[i];
    std::vector<Value>& values = changes[i].*list;
    std::copy_n(all[rank].begin() + next[rank], values.size(), values.begin());
    next[rank] += static_cast<std::ptrdiff_t>(values.size());
  }
}
}

void ExchangeChanges(const Ranks& ranks, const int* rankOfChange, std::vector<BlockChange>& changes)
{
  std::vector<Sizes> own;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const BlockChange& change = changes[i];
    if (rankOfChange[i] == ranks.Rank)
    {
      own.push_back({ change.New, change.Triangles.size(), change.Points.size(),
        change.Marks.size(), change.Samples.size() });
    }
  }
  const std::vector<std::vector<Sizes>> all = GatherValues(ranks, own);
  std::vector<std::size_t> next(all.size(), 0);
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const int rank = rankOfChange[i];
    const Sizes& sizes = all[rank][next[rank]++];
    changes[i].New = sizes.New;
    changes[i].Triangles.resize(sizes.Triangles);
    changes[i].Points.resize(sizes.Points);
    changes[i].Marks.resize(sizes.Marks);
    changes[i].Samples.resize(sizes.Samples);
  }
  ExchangeLists(ranks, rankOfChange, &BlockChange::Triangles, changes);
  ExchangeLists(ranks, rankOfChange, &BlockChange::Points, changes);
  ExchangeLists(ranks, rankOfChange, &BlockChange::Marks, changes);
  ExchangeLists(ranks, rankOfChange, &BlockChange::Samples, changes);
}
}
