// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Improve/BlockChange.h"

#include "Core/Improve/MakesFold.h"

#include <cstring>

namespace orthoslices
{
namespace
{
template <typename Value>
void Append(const std::vector<Value>& values, Ranks::Bytes& bytes)
{
  const std::size_t count = values.size(), at = bytes.size();
  bytes.resize(at + sizeof(count) + count * sizeof(Value));
  std::memcpy(&bytes[at], &count, sizeof(count));
  if (count > 0)
  {
    std::memcpy(&bytes[at + sizeof(count)], values.data(), count * sizeof(Value));
  }
}

/// Reads what was appended, from a place on, and moves that behind it.
template <typename Value>
void Read(const Ranks::Bytes& bytes, std::size_t& at, std::vector<Value>& values)
{
  std::size_t count = 0;
  std::memcpy(&count, &bytes[at], sizeof(count));
  at += sizeof(count);
  values.resize(count);
  if (count > 0)
  {
    std::memcpy(values.data(), &bytes[at], count * sizeof(Value));
  }
  at += count * sizeof(Value);
}

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
  bool IsFolded(Index triangle) const;
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

bool ChangeLister::IsFolded(Index triangle) const
{
  const CornerTable& corners = this->Mesh.Corners;
  for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    if (this->CornerInWhole(corners.OppositeOf(corner)) > this->CornerInWhole(corner) &&
      orthoslices::IsFolded(corners, this->Mesh.Points, corner) && !this->IsCurve(corner))
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
    this->IsFolded(triangle) ? std::uint8_t(1) : std::uint8_t(0) };
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

void ExchangeChanges(const Ranks& ranks, const int* rankOfChange, std::vector<BlockChange>& changes)
{
  Ranks::Bytes own;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    if (rankOfChange[i] == ranks.Rank)
    {
      Append(std::vector<BlockChange::Counts>{ changes[i].New }, own);
      Append(changes[i].Triangles, own);
      Append(changes[i].Points, own);
      Append(changes[i].Marks, own);
      Append(changes[i].Samples, own);
    }
  }
  const std::vector<Ranks::Bytes> all = ranks.Gather(own);
  std::vector<std::size_t> at(all.size(), 0);
  std::vector<BlockChange::Counts> counts;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const std::size_t rank = static_cast<std::size_t>(rankOfChange[i]);
    if (rankOfChange[i] != ranks.Rank)
    {
      Read(all[rank], at[rank], counts);
      changes[i].New = counts.front();
      Read(all[rank], at[rank], changes[i].Triangles);
      Read(all[rank], at[rank], changes[i].Points);
      Read(all[rank], at[rank], changes[i].Marks);
      Read(all[rank], at[rank], changes[i].Samples);
    }
  }
}
}
