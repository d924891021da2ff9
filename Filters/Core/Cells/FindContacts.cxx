// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/PatchMesh.h"

#include "Core/Base/Predicates.h"

#include <algorithm>

namespace orthoslices
{
Index EulerCharacteristic(const PatchMesh& mesh)
{
  std::vector<Index> corners;
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& triangle : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      corners.push_back(triangle[i]);
      edges.push_back(std::minmax(triangle[i], triangle[(i + 1) % 3]));
    }
  }
  const auto countDistinct = [](auto& list)
  {
    std::sort(list.begin(), list.end());
    return static_cast<Index>(std::unique(list.begin(), list.end()) - list.begin());
  };
  return countDistinct(corners) - countDistinct(edges) + static_cast<Index>(mesh.Triangles.size());
}

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

namespace
{
/// Whether two triangles certainly meet in their common corners only.
bool AreCompatible(const PatchTriangle& a, const PatchTriangle& b)
{
  std::vector<int> commonOfA, commonOfB;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (a.Ids[i] == b.Ids[j])
      {
        commonOfA.push_back(i);
        commonOfB.push_back(j);
      }
    }
  }
  return commonOfA.empty() ? CertainlyApart(a.Corners, b.Corners)
                           : CertainlyApartBeyond(commonOfA, a.Corners, commonOfB, b.Corners);
}

/// What a sweep has found out of a pair of patches.
enum class PairState : std::uint8_t
{
  Apart,  ///< need not be tested
  Tested, ///< apart so far
  Passed, ///< not all tests were made, because they would not have changed anything
  Touching
};

/// Finds pairs of triangles that may touch, from the lowest along x.
class ContactSweep
{
public:
  ContactSweep(const std::vector<PatchShape>& shapes, KnownApart* known)
    : Shapes(shapes)
    , Known(known)
    , Touches(shapes.size(), 0)
    , States(shapes.size() * shapes.size(), PairState::Apart)
  {
  }

  std::vector<std::pair<Index, Index>> Run(std::vector<PatchTriangle>& triangles);

private:
  PairState& StateOf(Index first, Index second)
  {
    return this->States[static_cast<std::size_t>(first) * this->Shapes.size() + second];
  }
  std::vector<std::uint8_t> FindPairs(const std::vector<PatchTriangle>& triangles);
  bool IsKnown(Index first, Index second) const;
  void Test(const PatchTriangle& a, const PatchTriangle& b);
  void Remember();

  const std::vector<PatchShape>& Shapes;
  KnownApart* Known;
  std::vector<std::uint8_t> Touches; ///< fans and shells
  std::vector<PairState> States;     ///< of pairs in ascending order
  std::vector<std::pair<Index, Index>> Contacts;
};

bool ContactSweep::IsKnown(Index first, Index second) const
{
  return this->Known &&
    this->Known->Pairs.count(
      std::minmax({ this->Known->Numbers[first], this->Known->Numbers[second] })) > 0;
}

/// Names the patches that have to be tested, with which others or themselves being in States.
std::vector<std::uint8_t> ContactSweep::FindPairs(const std::vector<PatchTriangle>& triangles)
{
  const Index count = static_cast<Index>(this->Shapes.size());
  std::vector<Box3> boxes(this->Shapes.size());
  for (const PatchTriangle& triangle : triangles)
  {
    boxes[triangle.Patch].Add(triangle.Extent);
  }
  std::vector<std::uint8_t> isTested(this->Shapes.size(), 0);
  for (Index i = 0; i < count; ++i)
  {
    for (Index j = i; j < count; ++j)
    {
      // A fan cannot touch itself.
      const bool test = i == j ? this->Shapes[i] != PatchShape::Fan : boxes[i].Meets(boxes[j]);
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
    this->Touches[pair.first] = this->Shapes[pair.first] != PatchShape::Joined;
    this->Touches[pair.second] = this->Shapes[pair.second] != PatchShape::Joined;
  }
}

void ContactSweep::Remember()
{
  const Index count = static_cast<Index>(this->Shapes.size());
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

std::vector<std::pair<Index, Index>> ContactSweep::Run(std::vector<PatchTriangle>& triangles)
{
  std::sort(triangles.begin(), triangles.end(),
    [](const PatchTriangle& a, const PatchTriangle& b)
    { return a.Extent.Low[0] < b.Extent.Low[0]; });
  const std::vector<std::uint8_t> isTested = this->FindPairs(triangles);
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [&](const PatchTriangle& triangle) { return isTested[triangle.Patch] == 0; }),
    triangles.end());
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
  if (this->Known)
  {
    this->Remember();
  }
  std::sort(this->Contacts.begin(), this->Contacts.end());
  return std::move(this->Contacts);
}
}

std::vector<std::pair<Index, Index>> FindContacts(
  std::vector<PatchTriangle>& triangles, const std::vector<PatchShape>& shapes, KnownApart* known)
{
  return ContactSweep(shapes, known).Run(triangles);
}
}
