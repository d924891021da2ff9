// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/FindContacts.h"

#include "Core/Base/Predicates.h"
#include "Core/Cells/TriangleTree.h"

#include <algorithm>

namespace orthoslices
{
PatchTriangle::PatchTriangle(
  Index patch, const std::array<Point3, 3>& corners, const std::array<Index, 3>& ids)
  : Patch(patch)
  , Corners(corners)
  , Ids(ids)
{
  for (const Point3& corner : corners)
  {
    this->Extent.Add(corner);
  }
}

CellTriangles::CellTriangles(const CycleGeometry& geometry)
  : Geometry(geometry)
{
}

void CellTriangles::AddFan(Index cycle, const Point3& center)
{
  this->Geometry.GetBoundary(cycle, this->Border, this->NodePlaces);
  const NodeGraph& graph = this->Geometry.Graph;
  const Index patch = static_cast<Index>(this->Kinds.size());
  this->Kinds.push_back(PatchKind::Fan);
  --this->LastId;
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    const Index a = this->Border[i];
    const Index b = this->Border[(i + 1) % this->Border.size()];
    this->Triangles.push_back(
      { patch, { center, graph.PointAt(a), graph.PointAt(b) }, { this->LastId, a, b } });
  }
}

void CellTriangles::AddMesh(const PatchMesh& mesh)
{
  this->AddPatch(mesh.Kind, mesh.Cycles,
    { mesh.Points.empty() ? nullptr : mesh.Points.front().data(), mesh.Points.size(),
      mesh.Triangles.empty() ? nullptr : mesh.Triangles.front().data(), mesh.Triangles.size() });
}

void CellTriangles::AddPatch(
  PatchKind kind, const std::vector<Index>& cycles, const PatchArrays& arrays)
{
  const std::vector<Index> borders = this->Geometry.GetBorders(cycles);
  const Index patch = static_cast<Index>(this->Kinds.size());
  this->Kinds.push_back(kind);
  for (std::size_t t = 0; t < arrays.TriangleCount; ++t)
  {
    std::array<Point3, 3> corners;
    std::array<Index, 3> ids;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Index place = arrays.Corners[3 * t + i];
      corners[i] =
        place >= 0 ? this->Geometry.Graph.PointAt(borders[place]) : arrays.PointAt(-1 - place);
      ids[i] = place >= 0 ? borders[place] : this->LastId + place;
    }
    this->Triangles.push_back({ patch, corners, ids });
  }
  this->LastId -= static_cast<Index>(arrays.PointCount);
}

namespace
{
/// Whether two triangles certainly meet in their common corners only.
bool AreCompatible(const PatchTriangle& a, const PatchTriangle& b)
{
  CommonCorners common;
  common.Find(a.Ids, b.Ids);
  return CertainlyApartBeyond(common, a.Corners, b.Corners);
}

/// What a sweep has found out of a pair of patches.
enum class PairState : std::uint8_t
{
  Apart,  ///< need not be tested
  Tested, ///< apart so far
  Passed, ///< not all tests were made, because they would not have changed anything
  Touching
};

/// With as many triangles a tree is worth its making. It changes the time only.
constexpr std::size_t ManyTriangles = 1000;

/// Finds pairs of triangles that may touch, from the lowest along x.
class ContactSweep
{
public:
  ContactSweep(const std::vector<PatchKind>& kinds, KnownApart* known)
    : Kinds(kinds)
    , Known(known)
    , Touches(kinds.size(), 0)
    , States(kinds.size() * kinds.size(), PairState::Apart)
  {
  }

  std::vector<std::pair<Index, Index>> Run(std::vector<PatchTriangle>& triangles);

private:
  PairState& StateOf(Index first, Index second)
  {
    return this->States[static_cast<std::size_t>(first) * this->Kinds.size() + second];
  }
  /// Whether a patch that touches one other patch is built anew whatever else it touches.
  bool MakesRoom(Index patch) const
  {
    return this->Kinds[patch] == PatchKind::Fan || this->Kinds[patch] == PatchKind::Shell;
  }
  std::vector<std::uint8_t> FindPairs(const std::vector<PatchTriangle>& triangles);
  bool IsKnown(Index first, Index second) const;
  void Test(const PatchTriangle& a, const PatchTriangle& b);
  void TestInOrder(const std::vector<PatchTriangle>& triangles);
  void TestByTree(const std::vector<PatchTriangle>& triangles);
  void Remember();

  const std::vector<PatchKind>& Kinds;
  KnownApart* Known;
  std::vector<std::uint8_t> Touches; ///< fans and shells that are known to touch another patch
  std::vector<PairState> States;     ///< of pairs in ascending order
  std::vector<std::pair<Index, Index>> Contacts;
};

bool ContactSweep::IsKnown(Index first, Index second) const
{
  return this->Known &&
    this->Known->Pairs.count(
      std::minmax({ this->Known->Numbers[first], this->Known->Numbers[second] })) > 0;
}

/// The patches that have to be tested; States says with which others, or with themselves.
std::vector<std::uint8_t> ContactSweep::FindPairs(const std::vector<PatchTriangle>& triangles)
{
  const Index count = static_cast<Index>(this->Kinds.size());
  std::vector<Box3> boxes(this->Kinds.size());
  for (const PatchTriangle& triangle : triangles)
  {
    boxes[triangle.Patch].Add(triangle.Extent);
  }
  std::vector<std::uint8_t> isTested(this->Kinds.size(), 0);
  for (Index i = 0; i < count; ++i)
  {
    for (Index j = i; j < count; ++j)
    {
      // A fan cannot touch itself.
      const bool test = i == j ? this->Kinds[i] != PatchKind::Fan : boxes[i].Meets(boxes[j]);
      if (test && !this->IsKnown(i, j))
      {
        this->StateOf(i, j) = PairState::Tested;
        isTested[i] = 1;
        isTested[j] = 1;
      }
    }
  }
  return isTested;
}

/// Tests two triangles whose boxes meet, unless what is known of their patches says enough.
void ContactSweep::Test(const PatchTriangle& a, const PatchTriangle& b)
{
  const std::pair<Index, Index> pair = std::minmax(a.Patch, b.Patch);
  PairState& state = this->StateOf(pair.first, pair.second);
  if (state == PairState::Apart || state == PairState::Touching)
  {
    return;
  }
  if (pair.first != pair.second && this->Touches[pair.first] != 0 &&
    this->Touches[pair.second] != 0)
  {
    state = PairState::Passed;
  }
  else if (!AreCompatible(a, b))
  {
    state = PairState::Touching;
    this->Contacts.push_back(pair);
    this->Touches[pair.first] = this->MakesRoom(pair.first) ? 1 : 0;
    this->Touches[pair.second] = this->MakesRoom(pair.second) ? 1 : 0;
  }
}

/// Notes the pairs that all tests have found apart.
void ContactSweep::Remember()
{
  const Index count = static_cast<Index>(this->Kinds.size());
  for (Index i = 0; i < count; ++i)
  {
    for (Index j = i; j < count; ++j)
    {
      if (this->StateOf(i, j) == PairState::Tested)
      {
        this->Known->Pairs.insert(
          std::minmax({ this->Known->Numbers[i], this->Known->Numbers[j] }));
      }
    }
  }
}

/// Each triangle with those after it that begin before it ends.
void ContactSweep::TestInOrder(const std::vector<PatchTriangle>& triangles)
{
  for (auto a = triangles.begin(); a != triangles.end(); ++a)
  {
    for (auto b = a + 1; b != triangles.end() && b->Extent.Low[0] <= a->Extent.High[0]; ++b)
    {
      if (a->Extent.Meets(b->Extent, 1) && a->Extent.Meets(b->Extent, 2))
      {
        this->Test(*a, *b);
      }
    }
  }
}

/// The same pairs in the same order, without most of those that are certainly apart.
void ContactSweep::TestByTree(const std::vector<PatchTriangle>& triangles)
{
  const TriangleTree tree(triangles);
  std::vector<Index> found;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    tree.FindAfter(
      static_cast<Index>(i),
      [this](Index a, Index b)
      {
        const PairState state = this->StateOf(std::min(a, b), std::max(a, b));
        return state != PairState::Apart && state != PairState::Touching;
      },
      found);
    for (const Index j : found)
    {
      if (triangles[i].Extent.Meets(triangles[j].Extent))
      {
        this->Test(triangles[i], triangles[j]);
      }
    }
  }
}

std::vector<std::pair<Index, Index>> ContactSweep::Run(std::vector<PatchTriangle>& triangles)
{
  std::sort(triangles.begin(), triangles.end(),
    [](const PatchTriangle& a, const PatchTriangle& b)
    { return a.Extent.Low[0] < b.Extent.Low[0]; });
  const std::vector<std::uint8_t> isTested = this->FindPairs(triangles);
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const PatchTriangle& triangle) { return isTested[triangle.Patch] == 0; }),
    triangles.end());
  if (triangles.size() >= ManyTriangles)
  {
    this->TestByTree(triangles);
  }
  else
  {
    this->TestInOrder(triangles);
  }
  if (this->Known)
  {
    this->Remember();
  }
  std::sort(this->Contacts.begin(), this->Contacts.end());
  return std::move(this->Contacts);
}
}

std::vector<std::pair<Index, Index>> FindContacts(
  std::vector<PatchTriangle>& triangles, const std::vector<PatchKind>& kinds, KnownApart* known)
{
  return ContactSweep(kinds, known).Run(triangles);
}
}
