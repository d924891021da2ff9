// SPDX-FileCopyrightText: Copyright (c) the Orthogonal Slices contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Labels/PatchForms.h"

#include "Core/Base/Vectors.h"

#include <algorithm>
#include <set>

/// The part of PatchForms for fans around several points.
namespace orthoslices
{
namespace
{
/// How far patches with a point of their own move it, as parts of the way from the common one to
/// the middle of their border, in the order in which that is tried.
constexpr std::array<double, 4> TriedWays{ 0.4, 0.15, 0.7, 0.85 };
/// The same for one patch after another; a small border is seen from nearby only.
constexpr std::array<double, 7> WaysInTurn{ 0.4, 0.7, 0.85, 0.95, 0.15, 0.99, 0.03 };
/// As many choices are tried of the patches that keep the common point.
constexpr std::size_t TriedChoices = 3;
/// As many chords of a border are tried, by the middles of which a point may lie, if its middle
/// sees not all of it.
constexpr std::size_t TriedChords = 4;

/// A patch whose sides are each seen from one of several points; `around` has the place of each
/// side's point in `centers`, and `base` is that of the patch.
InnerPatch FanAroundSeveral(
  const std::vector<Index>& around, Index base, const std::vector<Point3>& centers)
{
  InnerPatch patch;
  std::map<Index, Index> corner; // of a place in centers
  const auto cornerOf = [&](Index place)
  {
    const auto [at, isNew] = corner.emplace(place, -1 - static_cast<Index>(patch.Points.size()));
    if (isNew)
    {
      patch.Points.push_back(centers[place]);
      patch.Normals.push_back({ 0.0, 0.0, 0.0 });
    }
    return at->second;
  };
  const std::size_t size = around.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Index own = around[i], next = around[(i + 1) % size];
    const Index end = static_cast<Index>((i + 1) % size);
    patch.Triangles.push_back({ static_cast<Index>(i), end, cornerOf(own) });
    if (own != next)
    {
      patch.Triangles.push_back({ end, cornerOf(next), cornerOf(own) });
    }
    if (own != next && own != base && next != base)
    {
      patch.Triangles.push_back({ cornerOf(own), cornerOf(next), cornerOf(base) });
    }
  }
  return patch;
}
}

/// The patches of a group that need a point of their own: of each structure all but the one that
/// `kept` counts, from the longest border on; all where a patch of several cycles is in the way.
PatchGroup PatchForms::FindClaiming(const PatchGroup& group, std::size_t kept) const
{
  const bool hasMesh = this->HasMesh(group);
  std::map<Index, PatchGroup> ofStructure;
  for (const Index patch : group)
  {
    for (const StructureCycle& owner : this->Cell[patch].Owners)
    {
      ofStructure[owner.Structure].push_back(patch);
    }
  }
  std::set<Index> claiming;
  for (auto& structure : ofStructure)
  {
    PatchGroup& patches = structure.second;
    std::stable_sort(patches.begin(), patches.end(),
      [this](Index a, Index b)
      { return this->Cell[a].Border.size() > this->Cell[b].Border.size(); });
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      const bool isKept = patches.size() == 1 ? !hasMesh : i == kept % patches.size();
      if (!isKept && this->Cell[patches[i]].IsOneCycle)
      {
        claiming.insert(patches[i]);
      }
    }
  }
  return { claiming.begin(), claiming.end() };
}

/// A patch claims its sides, as far as no other one has: they are seen from a point of its own.
void PatchForms::AddClaim(Index patch, const Point3& center, Claims& claims) const
{
  const Index place = static_cast<Index>(claims.Centers.size());
  claims.BaseOf[patch] = place;
  this->Cell[patch].VisitSides(
    [&](Index a, Index b) { claims.ClaimedBy.emplace(CellEdgeOf(a, b), place); });
  claims.Centers.push_back(center);
}

/**
 * Fans around one point, but around others where patches claim their sides, in their neighbours,
 * too; where sides around several points follow each other, triangles between these points fill the
 * patch. False if that is no surface.
 */
bool PatchForms::Build(const PatchGroup& group, const Claims& claims)
{
  for (const Index patch : group)
  {
    if (!this->Cell[patch].IsOneCycle)
    {
      continue; // stays
    }
    const std::vector<Index>& border = this->Cell[patch].Border;
    std::vector<Index> around; // of each side, the place of its point
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      const auto found =
        claims.ClaimedBy.find(CellEdgeOf(border[i], border[(i + 1) % border.size()]));
      around.push_back(found == claims.ClaimedBy.end() ? 0 : found->second);
    }
    const auto base = claims.BaseOf.find(patch);
    InnerPatch made =
      FanAroundSeveral(around, base == claims.BaseOf.end() ? 0 : base->second, claims.Centers);
    if (!IsBordered(made, border.size()))
    {
      return false;
    }
    this->Cell.Take(patch, std::move(made));
  }
  return true;
}

/// All that need a point of their own take it the same part of their way.
bool PatchForms::ClaimAll(const PatchGroup& group, std::size_t kept, double way)
{
  Claims claims;
  claims.Centers.push_back(this->CommonCenter(group));
  for (const Index patch : this->FindClaiming(group, kept))
  {
    this->AddClaim(patch,
      this->Cell.MoveInside(
        group, Between(claims.Centers[0], this->Cell.MiddleOfBorder(this->Cell[patch]), way)),
      claims);
  }
  return this->Build(group, claims) && this->Cell.FindContactsOf(group).empty();
}

/// Where a patch may have a point of its own: between the common one and the middle of its border,
/// or of some chords of it.
std::vector<Point3> PatchForms::PlacesFor(Index patch, const Point3& common) const
{
  const std::vector<Index>& border = this->Cell[patch].Border;
  std::vector<Point3> middles{ this->Cell.MiddleOfBorder(this->Cell[patch]) };
  for (std::size_t chord = 0; chord < TriedChords; ++chord)
  {
    const std::size_t begin = chord * border.size() / (2 * TriedChords);
    const std::size_t end = (begin + border.size() / 2) % border.size();
    middles.push_back(
      Between(this->Cell.PlaceOf(border[begin]), this->Cell.PlaceOf(border[end]), 0.5));
  }
  std::vector<Point3> places;
  for (const Point3& middle : middles)
  {
    for (const double way : WaysInTurn)
    {
      places.push_back(this->Cell.KeepInside({ patch }, Between(common, middle, way)));
    }
  }
  return places;
}

/// Whether two patches of one structure have a point inside in common, so that its surface touches
/// itself.
bool PatchForms::IsShared(const PatchGroup& group, const Point3& center) const
{
  std::set<Index> structures;
  for (const Index patch : group)
  {
    const std::vector<Point3>& points = this->Cell[patch].New.Points;
    if (std::find(points.begin(), points.end(), center) == points.end())
    {
      continue;
    }
    for (const StructureCycle& owner : this->Cell[patch].Owners)
    {
      if (!structures.insert(owner.Structure).second)
      {
        return true;
      }
    }
  }
  return false;
}

/// Finds a place for the point of a patch where no patches touch.
bool PatchForms::ClaimNext(const PatchGroup& group, Index patch, Claims& claims)
{
  const Claims before = claims;
  for (const Point3& place : this->PlacesFor(patch, claims.Centers[0]))
  {
    claims = before;
    this->AddClaim(patch, place, claims);
    if (this->Build(group, claims) && !this->IsShared(group, place) &&
      this->Cell.FindContactsOf(group).empty())
    {
      return true;
    }
  }
  claims = before;
  return false;
}

/// One patch after another takes a point of its own, from the shortest border on. Those for which
/// no place is found keep the common one; then it is false.
bool PatchForms::ClaimInTurn(const PatchGroup& group, std::size_t kept)
{
  Claims claims;
  claims.Centers.push_back(this->CommonCenter(group));
  PatchGroup claiming = this->FindClaiming(group, kept);
  std::stable_sort(claiming.begin(), claiming.end(),
    [this](Index a, Index b) { return this->Cell[a].Border.size() < this->Cell[b].Border.size(); });
  bool isApart = true;
  for (const Index patch : claiming)
  {
    if (!this->ClaimNext(group, patch, claims))
    {
      isApart = false;
      this->Build(group, claims);
    }
  }
  return isApart;
}

bool PatchForms::BecomeClaims(const PatchGroup& group)
{
  for (const double way : TriedWays)
  {
    for (std::size_t kept = 0; kept < TriedChoices; ++kept)
    {
      if (this->ClaimAll(group, kept, way))
      {
        return true;
      }
    }
  }
  const std::size_t choices = this->HasMesh(group) ? 0 : TriedChoices;
  for (std::size_t kept = 0; kept < choices; ++kept)
  {
    if (this->ClaimInTurn(group, kept))
    {
      return true;
    }
  }
  return false;
}
}
